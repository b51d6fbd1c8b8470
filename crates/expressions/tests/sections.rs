//! The functions of cross sections. What they compute is tested in the room `sections`.

mod common;
use common::*;

/// Truth: 0.1405770149 for a square; 10/9 for a circle by energy; 15.3/13 for a rectangle by Cowper.
#[test]
fn sections_can_be_asked_for() {
    let db = fixture().db;
    for (text, expected) in [
        ("SECTION_TORSION(\"rectangle\", 10, 10)", 1_405.770_149),
        ("SECTION_TORSION(\"Circle\", 2)", std::f64::consts::FRAC_PI_2),
        ("SECTION_SHEAR(\"circle\", \"y\", \"energy\", 0.3, 5)", 10.0 / 9.0),
        ("SECTION_SHEAR(\"rectangle\", \"z\", \"cowper\", 0.3, 5, 6)", 15.3 / 13.0),
        ("SECTION_SHEAR(\"rectangle\", \"z\", \"none\", 0.3, 5, 6)", 0.0),
    ] {
        let found = value(&db, text).as_number().unwrap();
        assert!((found - expected).abs() <= 1e-9 * expected, "{text} = {found}");
    }
}

#[test]
fn what_is_no_section_is_an_error() {
    let db = fixture().db;
    for (text, part) in [
        ("SECTION_TORSION(\"hexagon\", 10)", "no section `hexagon`"),
        ("SECTION_TORSION(\"rectangle\", 10)", "width, height"),
        ("SECTION_SHEAR(\"circle\", \"x\", \"energy\", 0.3, 5)", "along y and z"),
        ("SECTION_SHEAR(\"circle\", \"y\", \"timoshenko\", 0.3, 5)", "none, energy, cowper"),
        ("SECTION_SHEAR(\"circle\", \"y\", \"cowper\", 0.6, 5)", "at most 0.5"),
    ] {
        let error = error(&db, text);
        assert_eq!(error.code, "expression/wrong-argument");
        assert!(error.message.contains(part), "{}", error.message);
    }
}
