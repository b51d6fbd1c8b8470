//! Outlines given by points in the axes of a marker.

use glam::DVec3;
use text::Diagnostic;

use crate::place::Cells;

/// The points of a cell, metre; at least two.
pub(crate) fn corners(cells: &Cells<'_>, name: &'static str) -> Result<Vec<DVec3>, Diagnostic> {
    if name == "points_for_profile" && cells.database.value(cells.id, name).is_none() {
        let other = ["profile_curve", "profiles_loft"];
        if let Some(other) = other.iter().find(|other| cells.database.value(cells.id, other).is_some()) {
            return Err(not_evaluated(cells, other));
        }
    }
    let numbers = cells.database.si_numbers(cells.id, name).unwrap_or_default();
    if numbers.len() < 6 || !numbers.len().is_multiple_of(3) || numbers.iter().any(|x| !x.is_finite()) {
        let what = format!("needs `{name}` of three finite coordinates for each of two or more points");
        return Err(cells.trouble("geometry/missing-value", &what));
    }
    Ok(numbers.chunks_exact(3).map(DVec3::from_slice).collect())
}

/// The corners of an outline that ends where it begins, without the repeated one.
pub(crate) fn closed(points: &[DVec3]) -> Option<&[DVec3]> {
    let (first, rest) = points.split_first()?;
    let size = rest.iter().map(|p| p.distance(*first)).fold(0.0, f64::max);
    let (last, corners) = rest.split_last()?;
    (corners.len() >= 2 && last.distance(*first) <= 1e-9 * size).then(|| &points[..points.len() - 1])
}

/// A shape that depends on what is kept but not computed.
pub(crate) fn not_evaluated(cells: &Cells<'_>, name: &str) -> Diagnostic {
    cells
        .trouble("geometry/not-evaluated", &format!("is neither drawn nor weighed: its `{name}` is not evaluated yet"))
        .help("give its part a `mass` with inertias if the mass is to follow from this shape")
}
