//! Displacements and angles of markers. The users' arguments are *to, from, axes*.

use super::{MAGNITUDE, Markers, OfMarkers, X, Y, Z};
use crate::{Component, Measure};

pub(super) const ALL: &[OfMarkers] = &[
    OfMarkers { name: "DX", arguments: (1, 3), measure: |m| displacement(X, m) },
    OfMarkers { name: "DY", arguments: (1, 3), measure: |m| displacement(Y, m) },
    OfMarkers { name: "DZ", arguments: (1, 3), measure: |m| displacement(Z, m) },
    OfMarkers { name: "DM", arguments: (1, 2), measure: |m| displacement(MAGNITUDE, m) },
    OfMarkers { name: "AX", arguments: (1, 2), measure: |m| angle(X, m) },
    OfMarkers { name: "AY", arguments: (1, 2), measure: |m| angle(Y, m) },
    OfMarkers { name: "AZ", arguments: (1, 2), measure: |m| angle(Z, m) },
    OfMarkers { name: "PSI", arguments: (1, 2), measure: |m| euler(false, 0, m) },
    OfMarkers { name: "THETA", arguments: (1, 2), measure: |m| euler(false, 1, m) },
    OfMarkers { name: "PHI", arguments: (1, 2), measure: |m| euler(false, 2, m) },
    OfMarkers { name: "YAW", arguments: (1, 2), measure: |m| euler(true, 0, m) },
    OfMarkers { name: "PITCH", arguments: (1, 2), measure: |m| euler(true, 1, m) },
    OfMarkers { name: "ROLL", arguments: (1, 2), measure: |m| euler(true, 2, m) },
    OfMarkers { name: "INCANG", arguments: (3, 3), measure: included_angle },
];

fn displacement(component: Component, m: &Markers) -> Measure {
    Measure::Displacement { component, i: m.first, j: m.rest[0], k: m.rest[1] }
}

fn angle(component: Component, m: &Markers) -> Measure {
    Measure::Angle { component, i: m.first, j: m.rest[0] }
}

fn euler(yaw_pitch_roll: bool, which: u8, m: &Markers) -> Measure {
    Measure::EulerAngle { yaw_pitch_roll, which, i: m.first, j: m.rest[0] }
}

/// All three markers are required, so the defaults below are never taken.
fn included_angle(m: &Markers) -> Measure {
    Measure::IncludedAngle { i: m.first, j: m.rest[0].unwrap_or_default(), k: m.rest[1].unwrap_or_default() }
}
