//! What the functions of the solver name: the statement of the object that each argument wants.

/// Functions whose arguments are objects: for each argument the statements that it may be of, none
/// where it is a number. The last entry holds for all arguments behind it. The first statement of an
/// argument is the one whose ids the solver takes there.
type Signature = (&'static [&'static str], &'static [&'static [&'static str]]);

const MARKERS: &[&[&str]] = &[&["MARKER"]];
/// A variable of the solver; the modeller also takes a measure there.
const VARIABLE: &[&str] = &["VARIABLE", "REQUEST"];

const OF_STATE: &[Signature] = &[
    (&["DX", "DY", "DZ", "DM", "AX", "AY", "AZ", "PSI", "THETA", "PHI", "YAW", "PITCH", "ROLL", "INCANG"], MARKERS),
    (&["VX", "VY", "VZ", "VM", "VR", "WX", "WY", "WZ", "WM"], MARKERS),
    (&["ACCX", "ACCY", "ACCZ", "ACCM", "WDTX", "WDTY", "WDTZ", "WDTM"], MARKERS),
    (&["FX", "FY", "FZ", "FM", "TX", "TY", "TZ", "TM"], MARKERS),
    (&["VARVAL"], &[VARIABLE, &[]]),
    (&["DIF", "DIF1"], &[&["DIFF"], &[]]),
    (&["ARYVAL"], &[&["ARRAY"], &[]]),
    (&["SENVAL"], &[&["SENSOR"], &[]]),
    (&["AKISPL", "CUBSPL"], &[&[], &[], &["SPLINE"], &[]]),
    (&["CURVE"], &[&[], &[], &[], &["CURVE"], &[]]),
];

/// Loads of an element: `(element, side, component, marker of the axes)`.
const OF_ELEMENTS: &[(&[&str], &[&str])] = &[
    (&["JOINT"], &["JOINT"]),
    (&["JPRIM"], &["JPRIM"]),
    (&["MOTION"], &["MOTION"]),
    (&["BEAM"], &["BEAM"]),
    (&["BUSH", "BUSHING"], &["BUSHING"]),
    (&["FIELD"], &["FIELD"]),
    (&["SFORCE"], &["SFORCE", "SPRINGDAMPER"]),
    (&["VFORCE"], &["VFORCE"]),
    (&["VTORQ"], &["VTORQUE"]),
    (&["GFORCE"], &["GFORCE"]),
    (&["NFORCE"], &["NFORCE"]),
    (&["SPDP"], &["SPRINGDAMPER"]),
    (&["PTCV"], &["PTCV"]),
    (&["CVCV"], &["CVCV"]),
    (&["GEAR"], &["GEAR"]),
    (&["CONTACT"], &["CONTACT"]),
    (&["FRICTION"], &["FRICTION"]),
];

/// The statements that an argument of a function names an object of, the proper one first; none if
/// the argument is a number or the function is not known. Arguments count from 0.
pub fn referred(function: &str, argument: usize) -> &'static [&'static str] {
    let is = |names: &[&str]| names.iter().any(|name| name.eq_ignore_ascii_case(function));
    if let Some((_, kinds)) = OF_STATE.iter().find(|(names, _)| is(names)) {
        return kinds.get(argument).or(kinds.last()).copied().unwrap_or_default();
    }
    match OF_ELEMENTS.iter().find(|(names, _)| is(names)) {
        Some((_, statements)) if argument == 0 => statements,
        Some(_) if argument == 3 => MARKERS[0],
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::referred;

    /// Truth: the argument lists of the solver's functions.
    #[test]
    fn arguments_that_are_objects_are_told_from_numbers() {
        for (function, argument, statement) in [
            ("dx", 0, Some("MARKER")),
            ("DX", 2, Some("MARKER")),
            ("BEAM", 0, Some("BEAM")),
            ("BEAM", 1, None),
            ("BEAM", 3, Some("MARKER")),
            ("AKISPL", 0, None),
            ("AKISPL", 2, Some("SPLINE")),
            ("AKISPL", 3, None),
            ("VARVAL", 0, Some("VARIABLE")),
            ("STEP", 0, None),
        ] {
            assert_eq!(referred(function, argument).first().copied(), statement, "{function} {argument}");
        }
    }
}
