//! Sections of a model against the room `sections`: the expressions that a section keeps are written
//! once more there as functions, which makes each the other's twin.

use flexure::Session;
use flexure::sections::{Shape, Theory};

#[test]
fn the_cells_of_a_section_are_what_its_shape_has() {
    let sizes = [
        ("rectangle", &[20.0, 10.0][..]),
        ("circle", &[7.0]),
        ("tube", &[30.0, 4.0]),
        ("box", &[100.0, 50.0, 4.0, 6.0]),
        ("i", &[100.0, 200.0, 6.0, 9.0]),
        ("ellipse", &[20.0, 10.0]),
    ];
    for ((kind, sizes), (word, theory)) in
        sizes.into_iter().zip([("energy", Theory::Energy), ("cowper", Theory::Cowper)].into_iter().cycle())
    {
        let (_, names) = Shape::KINDS.iter().find(|(k, _)| *k == kind).unwrap();
        let given: Vec<String> = names.iter().zip(sizes).map(|(name, size)| format!("{name}={size}")).collect();
        let mut session = Session::new();
        let report = session.execute(&format!(
            "model create model_name=m\n\
             section create {kind} section_name=.m.s poisson_ratio=0.25 shear_theory={word} {}",
            given.join(" ")
        ));
        assert!(report.diagnostics.is_empty(), "{}", session.render(&report.diagnostics, false));
        let p = Shape::new(kind, sizes).unwrap().properties(theory, 0.25);
        let id = session.database().ids().find(|id| session.database().full_name(*id) == ".m.s").unwrap();
        for (cell, expected) in [
            ("area_of_cross_section", p.area),
            ("ixx", p.ixx),
            ("iyy", p.iyy),
            ("izz", p.izz),
            ("y_shear_area_ratio", p.asy),
            ("z_shear_area_ratio", p.asz),
            ("y_extreme_fibre", p.extreme_y),
            ("z_extreme_fibre", p.extreme_z),
        ] {
            let found = session.database().number(id, cell).unwrap();
            // Because differences of fourth powers lose a few digits.
            assert!((found - expected).abs() <= 1e-12 * expected, "{kind}.{cell}: {found} is not {expected}");
        }
    }
}
