//! Functions that Adams knows and that cannot be evaluated yet, with the reason in words.

const UNSUPPORTED: &[(&[&str], &str)] = &[
    (&["VARVAL"], "it reads a state variable, and variables are not simulated yet"),
    (&["ARYVAL", "PINVAL", "POUVAL"], "it reads an array or plant signal, and these are not simulated yet"),
    (&["DIF", "DIF1"], "it reads a differential equation, and these are not simulated yet"),
    (&["SENVAL"], "it reads a sensor, and sensors are not simulated yet"),
    (&["AKISPL", "CUBSPL", "CURVE", "INTERP", "INVPSD"], "it reads a spline or curve, and these are not evaluated yet"),
    (&["CONTACT"], "it reads a contact, and contacts are not simulated yet"),
    (&["FRICTION"], "it reads joint friction, which is not simulated yet"),
    (&["NFORCE"], "it reads a multi-point force, which is not simulated yet"),
    (&["DELAY"], "delayed values are not kept yet"),
    (&["ORIENT"], "rotation systems other than 3-1-3 and yaw, pitch, roll are not computed yet"),
    (&["USER"], "it calls a user subroutine, and libraries are not loaded"),
    (&["CPU", "HSIZE", "NJAC", "NRHS", "ORDER"], "statistics of the solver are not offered to functions yet"),
    (
        &[
            "DXYZ", "VXYZ", "WXYZ", "ACCXYZ", "WDTXYZ", "FXYZ", "TXYZ", "UVX", "UVY", "UVZ", "UV", "MAG", "TRANS",
            "CROSS",
        ],
        "vector expressions are not evaluated yet",
    ),
];

/// Why a function that Adams has is refused; `None` if Adams has no such function.
pub(crate) fn why_not_supported(name: &str) -> Option<&'static str> {
    UNSUPPORTED.iter().find(|(names, _)| names.iter().any(|n| n.eq_ignore_ascii_case(name))).map(|(_, why)| *why)
}
