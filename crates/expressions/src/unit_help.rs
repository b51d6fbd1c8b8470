//! What to write in place of a unit that Adams does not have.

use schema::{Dimension, UnitName, unit_table};
use text::Diagnostic;

/// Prefixes that make another unit of a unit: a guess across them would be off by powers of ten.
const PREFIXES: &[&str] = &["giga", "mega", "kilo", "milli", "micro", "nano", "g", "m", "k", "u", "n"];

/// Units of other programs, by what they measure.
const ELSEWHERE: &[(&str, Dimension)] = &[
    ("psi", Dimension::PRESSURE),
    ("ksi", Dimension::PRESSURE),
    ("bar", Dimension::PRESSURE),
    ("mbar", Dimension::PRESSURE),
    ("atm", Dimension::PRESSURE),
];

/// Adds a guess at what was meant, and the units there are of what is wanted or seems to be meant.
#[must_use]
pub fn with_units(mut diagnostic: Diagnostic, unit: &str, wanted: Option<Dimension>) -> Diagnostic {
    let lower = unit.to_ascii_lowercase();
    let prefixed = PREFIXES.iter().filter_map(|p| lower.strip_prefix(p)).find_map(UnitName::find);
    let foreign = ELSEWHERE.iter().find(|(word, _)| *word == lower).map(|(_, dimension)| *dimension);
    let wanted = wanted.filter(|d| *d != Dimension::NONE);
    let fits = |u: &&UnitName| wanted.is_none_or(|d| d == u.dimension);
    let words =
        || unit_table().iter().filter(fits).flat_map(|u| std::iter::once(u.name).chain(u.symbols.iter().copied()));
    let near = if prefixed.is_none() && foreign.is_none() && lower.len() > 2 {
        crate::names::nearest(&lower, words())
    } else {
        None
    };
    if let Some(near) = near {
        diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
    }
    let meant = near.and_then(UnitName::find).or(prefixed).map(|u| u.dimension);
    let Some(dimension) = wanted.or(foreign).or(meant) else { return diagnostic };
    let names: Vec<&str> = unit_table().iter().filter(|u| u.dimension == dimension).map(|u| u.name).collect();
    let what = dimension.name().map_or_else(String::new, |name| format!(" of {name}"));
    if names.is_empty() {
        return diagnostic.help("units are put together with `*`, `/` and `**`, as in `(2.0(newton/mm**2))`");
    }
    let more =
        if dimension == Dimension::PRESSURE { "; others are put together, as in `(2.0(newton/mm**2))`" } else { "" };
    diagnostic.help(format!("the units{what} are {}{more}", names.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn helps(unit: &str, wanted: Option<Dimension>) -> Vec<String> {
        let diagnostic = with_units(Diagnostic::error("unit/unknown", "no unit"), unit, wanted);
        diagnostic.helps.into_iter().map(|help| help.text).collect()
    }

    /// A thousand times too little is worse than no guess: `GPa` is not taken for `MPa`.
    #[test]
    fn units_of_the_wanted_kind_are_listed_and_no_other_size_is_guessed() {
        for unit in ["GPa", "gigapascal", "psi"] {
            for wanted in [None, Some(Dimension::PRESSURE)] {
                let helps = helps(unit, wanted);
                assert_eq!(helps.len(), 1, "{unit}: {helps:?}");
                assert!(helps[0].contains("are pascal, megapascal; others are put together"), "{helps:?}");
            }
        }
    }

    #[test]
    fn a_misspelled_unit_is_guessed() {
        assert_eq!(helps("megapascall", None)[0], "did you mean `megapascal`?");
        assert_eq!(helps("milimeter", Some(Dimension::LENGTH))[0], "did you mean `millimeter`?");
        assert!(helps("parsec", Some(Dimension::LENGTH)).concat().contains("are mm, cm, meter, km, inch"));
    }
}
