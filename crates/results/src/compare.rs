//! Difference of two results: series by series, at the instants both have.

use crate::Table;

/// How far two series of one name are apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    pub name: String,
    /// Largest absolute difference and the time at which it occurs; `None` if only one table has
    /// the series.
    pub largest: Option<(f64, f64)>,
    /// Largest absolute value of the series in the first table.
    pub size: f64,
}

/// Compares the series of two tables by name. The second is interpolated linearly at the times of
/// the first; times outside the second are left out. Series without partner are listed too.
pub fn compare(a: &Table, b: &Table) -> Vec<Difference> {
    let empty = Vec::new();
    let time = |t: &Table| t.series.first().map_or(&empty, |s| &s.values).clone();
    let (times_a, times_b) = (time(a), time(b));
    let mut differences: Vec<Difference> = a
        .series
        .iter()
        .skip(1)
        .map(|series| {
            let size = series.values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            let largest = b.get(&series.name).map(|other| {
                let mut worst = (0.0_f64, times_a.first().copied().unwrap_or(0.0));
                for (t, x) in times_a.iter().zip(&series.values) {
                    if let Some(y) = interpolate(&times_b, &other.values, *t)
                        && ((x - y).abs() > worst.0 || (x - y).is_nan())
                    {
                        worst = ((x - y).abs(), *t);
                    }
                }
                worst
            });
            Difference { name: series.name.clone(), largest, size }
        })
        .collect();
    differences.extend(b.series.iter().skip(1).filter(|s| a.get(&s.name).is_none()).map(|s| Difference {
        name: s.name.clone(),
        largest: None,
        size: 0.0,
    }));
    differences
}

fn interpolate(times: &[f64], values: &[f64], t: f64) -> Option<f64> {
    let after = times.partition_point(|x| *x < t);
    let at = |k: usize| Some((*times.get(k)?, *values.get(k)?));
    let (t1, y1) = at(after)?;
    if t1 == t {
        return Some(y1);
    }
    let (t0, y0) = at(after.checked_sub(1)?)?;
    Some(y0 + (y1 - y0) * (t - t0) / (t1 - t0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(rows: &[[f64; 2]], name: &str) -> Table {
        let mut t = Table::with_columns([("time".into(), String::new()), (name.into(), String::new())]);
        rows.iter().for_each(|r| t.push(r));
        t
    }

    #[test]
    fn the_largest_difference_is_found_between_the_samples_too() {
        let a = table(&[[0.0, 0.0], [0.5, 2.0], [1.0, 1.0]], "x");
        let b = table(&[[0.0, 0.0], [1.0, 1.0]], "X");
        assert_eq!(compare(&a, &b)[0].largest, Some((1.5, 0.5)));
    }

    #[test]
    fn a_series_without_partner_is_listed() {
        let names: Vec<_> = compare(&table(&[], "x"), &table(&[], "y")).into_iter().map(|d| d.name).collect();
        assert_eq!(names, ["x", "y"]);
    }

    #[test]
    fn not_a_number_is_a_difference() {
        let a = table(&[[0.0, f64::NAN]], "x");
        let b = table(&[[0.0, 1.0]], "x");
        assert!(compare(&a, &b)[0].largest.unwrap().0.is_nan());
    }
}
