//! Properties of sections against closed forms, published numbers and limits.

use std::f64::consts::PI;

use sections::{Axis, Shape, Theory};

fn shape(kind: &str, dimensions: &[f64]) -> Shape {
    Shape::new(kind, dimensions).unwrap()
}

fn assert_close(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found} is not {expected}");
}

/// Truth: Timoshenko and Goodier, Theory of Elasticity, art. 109, table of k1 (four digits).
#[test]
fn the_torsion_of_rectangles_is_that_of_the_table() {
    let table = [
        (1.0, 0.1406),
        (1.2, 0.166),
        (1.5, 0.196),
        (2.0, 0.229),
        (2.5, 0.249),
        (3.0, 0.263),
        (4.0, 0.281),
        (5.0, 0.291),
        (10.0, 0.312),
    ];
    for (ratio, k) in table {
        for rectangle in [shape("rectangle", &[1.0, ratio]), shape("rectangle", &[ratio, 1.0])] {
            assert!((rectangle.torsion() / ratio - k).abs() <= 0.00051, "{ratio}: {}", rectangle.torsion() / ratio);
        }
    }
    // Truth: 0.1405770149 for the square, the sum of the series to ten digits.
    assert_close(shape("rectangle", &[1.0, 1.0]).torsion(), 0.140_577_014_9, 1e-9);
    // Truth: the strip of height 1: 1/3 - 0.21 b/a, as Roark's table has it; 0.2100834 exactly.
    assert_close(shape("rectangle", &[1e4, 1.0]).torsion(), 1e4 / 3.0 - 0.210_083, 1e-9);
}

/// Truth: mensuration. Twice a length is eight or sixteen times a moment, so that any unit will do.
#[test]
fn areas_and_second_moments_are_those_of_the_closed_forms() {
    let rectangle = shape("rectangle", &[2.0, 3.0]).properties(Theory::Energy, 0.3);
    assert_eq!((rectangle.area, rectangle.iyy, rectangle.izz), (6.0, 4.5, 2.0));
    assert_eq!((rectangle.extreme_y, rectangle.extreme_z), (1.0, 1.5));
    let circle = shape("circle", &[2.0]).properties(Theory::Energy, 0.3);
    assert_close(circle.area, PI, 1e-15);
    assert_close(circle.iyy, PI / 4.0, 1e-15);
    assert_close(circle.ixx, PI / 2.0, 1e-15);
    let tube = shape("tube", &[2.0, 0.5]).properties(Theory::Energy, 0.3);
    assert_close(tube.area, PI * 0.75, 1e-15);
    assert_close(tube.izz, PI / 4.0 * (1.0 - 0.0625), 1e-15);
    assert_close(tube.ixx, 2.0 * tube.iyy, 1e-15);
    let ellipse = shape("ellipse", &[4.0, 2.0]).properties(Theory::Energy, 0.3);
    assert_close(ellipse.iyy, PI / 4.0 * 2.0, 1e-15);
    assert_close(ellipse.izz, PI / 4.0 * 8.0, 1e-15);
    assert_close(ellipse.ixx, PI * 8.0 / 5.0, 1e-15);
    let i = shape("i", &[4.0, 6.0, 1.0, 1.0]).properties(Theory::Energy, 0.3);
    assert_close(i.area, 12.0, 1e-15);
    assert_close(i.iyy, (4.0 * 216.0 - 3.0 * 64.0) / 12.0, 1e-15);
    assert_close(i.izz, (2.0 * 64.0 + 4.0) / 12.0, 1e-15);
    let case = shape("box", &[4.0, 6.0, 0.5, 1.0]).properties(Theory::Energy, 0.3);
    assert_close(case.area, 24.0 - 12.0, 1e-15);
    assert_close(case.iyy, (4.0 * 216.0 - 3.0 * 64.0) / 12.0, 1e-15);
    assert_close(case.izz, (6.0 * 64.0 - 4.0 * 27.0) / 12.0, 1e-15);
}

/// Truth: the published factors: 6/5 and 10/9 by energy, 2 for a thin tube; Cowper 1966: rectangle
/// 10(1+v)/(12+11v), circle 6(1+v)/(7+6v), thin tube 2(1+v)/(4+3v), here inverted.
#[test]
fn shear_factors_are_the_published_ones() {
    let nu = 0.3;
    let factor = |kind: &str, sizes: &[f64], theory| shape(kind, sizes).shear(Axis::Z, theory, nu);
    assert_eq!(factor("rectangle", &[1.0, 2.0], Theory::Energy), 1.2);
    assert_eq!(factor("circle", &[1.0], Theory::Energy), 10.0 / 9.0);
    assert_close(factor("tube", &[1.0, 1e-7], Theory::Energy), 2.0, 1e-9);
    assert_close(factor("rectangle", &[1.0, 2.0], Theory::Cowper), 15.3 / 13.0, 1e-15);
    assert_close(factor("circle", &[1.0], Theory::Cowper), 8.8 / 7.8, 1e-15);
    assert_close(factor("tube", &[1.0, 1e-7], Theory::Cowper), 4.9 / 2.6, 1e-9);
    for (kind, sizes) in [("rectangle", &[1.0, 2.0][..]), ("i", &[1.0, 2.0, 0.1, 0.1]), ("tube", &[1.0, 0.1])] {
        assert_eq!(factor(kind, sizes, Theory::None), 0.0);
    }
}

/// Truth: one shape may be written as another: an ellipse of equal axes is a circle, a tube without a
/// bore is one too, and so are their factors by Cowper.
#[test]
fn shapes_pass_into_each_other() {
    let circle = shape("circle", &[2.0]).properties(Theory::Cowper, 0.28);
    let ellipse = shape("ellipse", &[2.0, 2.0]).properties(Theory::Cowper, 0.28);
    let tube = shape("tube", &[2.0, 1.0 - 1e-9]).properties(Theory::Cowper, 0.28);
    for (a, b, c) in [
        (circle.area, ellipse.area, tube.area),
        (circle.ixx, ellipse.ixx, tube.ixx),
        (circle.iyy, ellipse.iyy, tube.iyy),
        (circle.asy, ellipse.asy, tube.asy),
    ] {
        assert_close(b, a, 1e-14);
        assert_close(c, a, 1e-12);
    }
    // A box of equal walls is turned without change but of names.
    let case = shape("box", &[3.0, 5.0, 0.2, 0.3]);
    let turned = shape("box", &[5.0, 3.0, 0.3, 0.2]);
    for theory in [Theory::Energy, Theory::Cowper] {
        let (a, b) = (case.properties(theory, 0.3), turned.properties(theory, 0.3));
        assert_close(a.ixx, b.ixx, 1e-14);
        assert_close(a.iyy, b.izz, 1e-14);
        assert_close(a.asy, b.asz, 1e-14);
    }
}

/// Twin: Cowper's factors of thin-walled shapes without Poisson's ratio are the energy of the flow in
/// thin walls; the error of walls of 1e-5 of the size is of that order.
#[test]
fn energy_and_cowper_agree_for_thin_walls_without_poissons_ratio() {
    for (width, height) in [(1.0, 1.0), (0.5, 1.0), (2.0, 1.0)] {
        for kind in ["i", "box"] {
            let thin = shape(kind, &[width, height, 1e-5, 2e-5]);
            let energy = thin.shear(Axis::Z, Theory::Energy, 0.3);
            assert_close(energy, thin.shear(Axis::Z, Theory::Cowper, 0.0), 2e-4);
            assert!(energy > 1.2, "{kind}: {energy}");
        }
    }
    // Truth: both flanges are rectangles of which the web takes nothing.
    let thin = shape("i", &[1.0, 1.0, 1e-6, 1e-3]);
    let flanges = 1.2 * thin.area() / 2e-3;
    assert_close(thin.shear(Axis::Y, Theory::Energy, 0.3), flanges, 1e-3);
}

#[test]
fn what_is_no_section_is_told_in_a_sentence() {
    let told = |kind: &str, sizes: &[f64], part: &str| {
        let sentence = Shape::new(kind, sizes).unwrap_err();
        assert!(sentence.contains(part), "{sentence}");
    };
    told("hexagon", &[1.0], "rectangle, circle, tube, box, i, ellipse");
    told("rectangle", &[1.0], "width, height, 2 numbers; 1 are given");
    told("circle", &[0.0], "diameter");
    told("circle", &[f64::NAN], "diameter");
    told("tube", &[1.0, 0.5], "thickness 0.5");
    told("box", &[1.0, 1.0, 0.1, 0.6], "flange_thickness 0.6");
    told("i", &[1.0, 1.0, 1.0, 0.1], "web_thickness 1");
    assert_eq!(Theory::named("Cowper"), Some(Theory::Cowper));
    assert_eq!(Theory::named("timoshenko"), None);
}
