//! Outlines for drawing: closed lines, the outer one first.

/// Points of a closed line in y and z; the last joins the first.
pub(crate) type Outline = Vec<[f64; 2]>;

pub(crate) fn rectangle(width: f64, height: f64) -> Outline {
    let (y, z) = (width / 2.0, height / 2.0);
    vec![[-y, -z], [y, -z], [y, z], [-y, z]]
}

pub(crate) fn ellipse(p: f64, q: f64) -> Outline {
    let angle = |k: i32| std::f64::consts::TAU * f64::from(k) / 96.0;
    (0..96).map(|k| [p * angle(k).cos(), q * angle(k).sin()]).collect()
}

pub(crate) fn i_beam(width: f64, height: f64, web: f64, flange: f64) -> Outline {
    let (y, z, s, c) = (width / 2.0, height / 2.0, web / 2.0, height / 2.0 - flange);
    vec![[-y, -z], [y, -z], [y, -c], [s, -c], [s, c], [y, c], [y, z], [-y, z], [-y, c], [-s, c], [-s, -c], [-y, -c]]
}
