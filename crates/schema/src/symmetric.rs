//! Symmetric matrices as lists of numbers: the lower triangle by columns, or all terms.

/// How far two terms across the diagonal may differ, as a share of the larger one: the rounding of
/// whatever computed or printed them, and no more.
pub const SYMMETRY_TOLERANCE: f64 = 1e-9;

/// Two terms that should be equal: their places in the full list by columns, the one below the
/// diagonal first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unequal {
    pub below: usize,
    pub above: usize,
}

/// Row and column of a term of the full list by columns, counted from 1.
#[must_use]
pub fn place_by_columns(index: usize, side: usize) -> (usize, usize) {
    (index % side + 1, index / side + 1)
}

/// For each term of the lower triangle by columns, its place in the full list and that of its twin.
pub fn triangle_places(side: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..side).flat_map(move |column| (column..side).map(move |row| (column * side + row, row * side + column)))
}

/// The lower triangle by columns of a full matrix.
///
/// # Errors
/// The first two terms, by columns, that differ by more than [`SYMMETRY_TOLERANCE`]. A list of
/// another length than `side * side` has no terms to compare and gives back what is there.
pub fn lower_triangle(full: &[f64], side: usize) -> Result<Vec<f64>, Unequal> {
    let mut kept = Vec::with_capacity(side * (side + 1) / 2);
    for (below, above) in triangle_places(side) {
        let (Some(&low), Some(&high)) = (full.get(below), full.get(above)) else { continue };
        let equal = (low - high).abs() <= SYMMETRY_TOLERANCE * low.abs().max(high.abs());
        // What is no number is equal to nothing, and is complained about by whoever reads numbers.
        if !equal && low.is_finite() && high.is_finite() {
            return Err(Unequal { below, above });
        }
        kept.push(low);
    }
    Ok(kept)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: [1 2 4; 2 3 5; 4 5 6] by columns is 1 2 4 2 3 5 4 5 6, its triangle 1 2 4 3 5 6.
    #[test]
    fn a_symmetric_matrix_is_its_triangle() {
        let full = [1.0, 2.0, 4.0, 2.0, 3.0, 5.0, 4.0, 5.0, 6.0];
        assert_eq!(lower_triangle(&full, 3), Ok(vec![1.0, 2.0, 4.0, 3.0, 5.0, 6.0]));
        let mut rounded = full;
        rounded[6] *= 1.0 + 0.9e-9;
        assert_eq!(lower_triangle(&rounded, 3), Ok(vec![1.0, 2.0, 4.0, 3.0, 5.0, 6.0]));
        rounded[6] = 4.0 * (1.0 + 1.1e-9);
        assert_eq!(lower_triangle(&rounded, 3), Err(Unequal { below: 2, above: 6 }));
        assert_eq!((place_by_columns(2, 3), place_by_columns(6, 3)), ((3, 1), (1, 3)));
    }
}
