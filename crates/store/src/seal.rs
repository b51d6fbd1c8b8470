//! Checksums: one for each row, and one over all of them, so that neither a changed nor a missing
//! row goes unnoticed. SQLite itself checks its pages' structure but not what stands in them.

use xxhash_rust::xxh3::Xxh3;

/// Number of rows and the sum of their checksums.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Seal {
    pub rows: i64,
    pub total: i64,
}

impl Seal {
    pub fn add(&mut self, sum: i64) {
        self.rows += 1;
        self.total = self.total.wrapping_add(sum);
    }

    pub fn take(&mut self, sum: i64) {
        self.rows -= 1;
        self.total = self.total.wrapping_sub(sum);
    }
}

/// The checksum of a row: of the table's name and every column, each with its length.
pub fn sum(table: &str, columns: &[&str]) -> i64 {
    let mut hash = Xxh3::new();
    for text in std::iter::once(&table).chain(columns) {
        hash.update(&(text.len() as u64).to_le_bytes());
        hash.update(text.as_bytes());
    }
    hash.digest() as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_that_moves_to_the_next_column_changes_the_sum() {
        assert_ne!(sum("t", &["ab", "c"]), sum("t", &["a", "bc"]));
        assert_ne!(sum("t", &["a"]), sum("u", &["a"]));
        assert_eq!(sum("t", &["a"]), sum("t", &["a"]));
    }

    #[test]
    fn what_is_taken_away_again_leaves_no_trace() {
        let mut seal = Seal::default();
        seal.add(i64::MAX);
        seal.add(12);
        seal.take(i64::MAX);
        assert_eq!(seal, Seal { rows: 1, total: 12 });
    }
}
