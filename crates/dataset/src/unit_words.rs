//! The words of datasets for units.

use schema::{Dimension, UnitName, UnitSystem};

/// Units and the words of a dataset for them.
const UNIT_WORDS: &[(&str, &str)] = &[
    ("newton", "NEWTON"),
    ("knewton", "KNEWTON"),
    ("dyne", "DYNE"),
    ("pound_force", "POUND_FORCE"),
    ("kpound_force", "KPOUND_FORCE"),
    ("kg_force", "KILOGRAM_FORCE"),
    ("ounce_force", "OUNCE_FORCE"),
    ("millinewton", "MILLINEWTON"),
    ("centinewton", "CENTINEWTON"),
    ("poundal", "POUNDAL"),
    ("nanonewton", "NANONEWTON"),
    ("micronewton", "MICRONEWTON"),
    ("meganewton", "MEGANEWTON"),
    ("kg", "KILOGRAM"),
    ("gram", "GRAM"),
    ("pound_mass", "POUND_MASS"),
    ("kpound_mass", "KPOUND_MASS"),
    ("slug", "SLUG"),
    ("slinch", "SLINCH"),
    ("ounce_mass", "OUNCE_MASS"),
    ("tonne", "TONNE"),
    ("milligram", "MILLIGRAM"),
    ("microgram", "MICROGRAM"),
    ("nanogram", "NANOGRAM"),
    ("us_ton", "US_TON"),
    ("mm", "MILLIMETER"),
    ("cm", "CENTIMETER"),
    ("meter", "METER"),
    ("km", "KILOMETER"),
    ("micrometer", "MICROMETER"),
    ("nanometer", "NANOMETER"),
    ("inch", "INCH"),
    ("foot", "FOOT"),
    ("yard", "YARD"),
    ("mile", "MILE"),
    ("mils", "MILS"),
    ("microinch", "MICROINCH"),
    ("angstrom", "ANGSTROM"),
    ("second", "SECOND"),
    ("millisecond", "MILLISECOND"),
    ("microsecond", "MICROSECOND"),
    ("nanosecond", "NANOSECOND"),
    ("minute", "MINUTE"),
    ("hour", "HOUR"),
    ("day", "DAY"),
];

/// The arguments of UNITS that name a unit each.
pub(crate) fn arguments(units: &UnitSystem) -> [(&'static str, &'static UnitName); 4] {
    [("FORCE", units.force), ("MASS", units.mass), ("LENGTH", units.length), ("TIME", units.time)]
}

/// The word of a dataset for a unit.
pub(crate) fn solver_unit(name: &str) -> Option<&'static str> {
    UNIT_WORDS.iter().find(|(word, _)| *word == name).map(|(_, solver)| *solver)
}

/// Second words for units.
const OTHER_WORDS: &[(&str, &str)] = &[("tonne", "MEGAGRAM"), ("millisecond", "MILLISECONDS")];

/// The unit that a word of a dataset means.
pub(crate) fn unit_of_word(word: &str) -> Option<&'static str> {
    let found = UNIT_WORDS.iter().chain(OTHER_WORDS).find(|(_, solver)| solver.eq_ignore_ascii_case(word));
    found.map(|(name, _)| *name)
}

/// The word of a dataset for a unit by the name that commands have for it: `MM`.
pub(crate) fn meant(word: &str, dimension: Dimension) -> Option<&'static str> {
    let unit = UnitName::find(&word.to_ascii_lowercase()).filter(|unit| unit.dimension == dimension)?;
    solver_unit(unit.name)
}

/// The words of a dataset for the units of a dimension.
pub(crate) fn words_of_units(dimension: Dimension) -> Vec<&'static str> {
    let fits = |name: &str| UnitName::find(name).is_some_and(|unit| unit.dimension == dimension);
    UNIT_WORDS.iter().filter(|(name, _)| fits(name)).map(|(_, solver)| *solver).collect()
}
