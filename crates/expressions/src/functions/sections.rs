//! Properties of cross sections that no short expression gives. Sizes may be in any one unit of length.

use ::sections::{Axis, Shape, Theory};
use model::Value;

use super::{Arguments, Function, function, real};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[
    function(
        "SECTION_TORSION",
        "shape, size, [size_2], [size_3], [size_4]",
        "torsion constant of a rectangle, circle, tube, box, i or ellipse",
        |a| real(shape(a, 0, 1)?.torsion()),
    ),
    function(
        "SECTION_SHEAR",
        "shape, axis, theory, poisson, size, [size_2], [size_3], [size_4]",
        "shear factor A/As along y or z by the theory energy or cowper, or 0 by none",
        shear,
    ),
];

/// The shape whose word is argument `word`, its sizes from argument `first` on.
fn shape(a: &Arguments, word: usize, first: usize) -> Outcome<Shape> {
    let word = a.text(word)?;
    let sizes = (first..a.len()).map(|i| a.number(i)).collect::<Outcome<Vec<f64>>>()?;
    Shape::new(&word, &sizes).map_err(|sentence| a.error(sentence))
}

fn shear(a: &mut Arguments) -> Outcome<Value> {
    let axis = match a.axis(1)? {
        1 => Axis::Y,
        2 => Axis::Z,
        _ => return Err(a.error("a section has no shear along x, but along y and z")),
    };
    let word = a.text(2)?;
    let Some(theory) = Theory::named(&word) else {
        return Err(a.error(format!("there is no theory `{word}`; there are {}", Theory::WORDS.join(", "))));
    };
    let poisson = a.number(3)?;
    if !(poisson > -1.0 && poisson <= 0.5) {
        return Err(a.error(format!("Poisson's ratio is {poisson}; it must be above -1 and at most 0.5")));
    }
    real(shape(a, 0, 4)?.shear(axis, theory, poisson))
}
