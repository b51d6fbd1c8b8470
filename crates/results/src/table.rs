//! The results of one run, columnar.

/// One column: `<result set>.<component>` with its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// `REQ_TIP.X`, `beam_1.FX`.
    pub name: String,
    /// Unit label, `newton-mm`; empty for a plain number.
    pub unit: String,
    pub values: Vec<f64>,
}

/// Equal-length series; the first is `time`. Values are in model units.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Table {
    pub series: Vec<Series>,
}

impl Table {
    /// A table with named, empty columns `(name, unit)`; the first is time.
    pub fn with_columns(columns: impl IntoIterator<Item = (String, String)>) -> Table {
        let series = columns.into_iter().map(|(name, unit)| Series { name, unit, values: Vec::new() }).collect();
        Table { series }
    }

    /// Appends one row; `row` has one value for each series.
    pub fn push(&mut self, row: &[f64]) {
        debug_assert_eq!(row.len(), self.series.len());
        for (series, value) in self.series.iter_mut().zip(row) {
            series.values.push(*value);
        }
    }

    pub fn rows(&self) -> usize {
        self.series.first().map_or(0, |s| s.values.len())
    }

    /// A series by name, ignoring case.
    pub fn get(&self, name: &str) -> Option<&Series> {
        self.series.iter().find(|s| s.name.eq_ignore_ascii_case(name))
    }
}
