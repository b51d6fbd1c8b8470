//! Small conversions between blocks of 3x3 matrices and rows of numbers.

use glam::{DMat3, DVec3};

/// A 6x6 matrix of four 3x3 blocks, `[row][column]`.
pub(crate) type Blocks = [[DMat3; 2]; 2];

pub(crate) fn blocks(m: &[[f64; 6]; 6]) -> Blocks {
    let block = |row: usize, column: usize| {
        DMat3::from_cols_array_2d(&[0, 1, 2].map(|c| [0, 1, 2].map(|r| m[row + r][column + c])))
    };
    [[block(0, 0), block(0, 3)], [block(3, 0), block(3, 3)]]
}

pub(crate) fn rows_of(blocks: &Blocks) -> [[f64; 6]; 6] {
    let mut m = [[0.0; 6]; 6];
    for (block_row, pair) in blocks.iter().enumerate() {
        for (block_column, block) in pair.iter().enumerate() {
            for column in 0..3 {
                let values = block.col(column).to_array();
                for (row, value) in values.into_iter().enumerate() {
                    m[3 * block_row + row][3 * block_column + column] = value;
                }
            }
        }
    }
    m
}

/// The two halves of six numbers.
pub(crate) fn halves(six: &[f64; 6]) -> (DVec3, DVec3) {
    (DVec3::new(six[0], six[1], six[2]), DVec3::new(six[3], six[4], six[5]))
}

pub(crate) fn six(first: DVec3, second: DVec3) -> [f64; 6] {
    [first.x, first.y, first.z, second.x, second.y, second.z]
}

/// `a b^T`.
pub(crate) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

/// `skew(a) m`: `a` crossed with each column.
pub(crate) fn skew_times(a: DVec3, m: &DMat3) -> DMat3 {
    DMat3::from_cols(a.cross(m.x_axis), a.cross(m.y_axis), a.cross(m.z_axis))
}

/// `m skew(a)`.
pub(crate) fn times_skew(m: &DMat3, a: DVec3) -> DMat3 {
    DMat3::from_cols(m.y_axis * a.z - m.z_axis * a.y, m.z_axis * a.x - m.x_axis * a.z, m.x_axis * a.y - m.y_axis * a.x)
}
