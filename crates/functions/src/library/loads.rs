//! Loads at markers (`FX(i, j, k)`) and of elements (`BEAM(id, jflag, component, rm)`).

use super::{MAGNITUDE, Markers, OfMarkers, X, Y, Z};
use crate::{Component, Measure};

pub(super) const AT_MARKERS: &[OfMarkers] = &[
    OfMarkers { name: "FX", arguments: (1, 3), measure: |m| load(false, X, m) },
    OfMarkers { name: "FY", arguments: (1, 3), measure: |m| load(false, Y, m) },
    OfMarkers { name: "FZ", arguments: (1, 3), measure: |m| load(false, Z, m) },
    OfMarkers { name: "FM", arguments: (1, 2), measure: |m| load(false, MAGNITUDE, m) },
    OfMarkers { name: "TX", arguments: (1, 3), measure: |m| load(true, X, m) },
    OfMarkers { name: "TY", arguments: (1, 3), measure: |m| load(true, Y, m) },
    OfMarkers { name: "TZ", arguments: (1, 3), measure: |m| load(true, Z, m) },
    OfMarkers { name: "TM", arguments: (1, 2), measure: |m| load(true, MAGNITUDE, m) },
];

/// Functions of the form `(id, jflag, component, rm)`; each names the statement of its element.
pub(super) const OF_ELEMENTS: &[&str] = &[
    "BEAM", "BUSH", "FIELD", "SPDP", "SFORCE", "VFORCE", "VTORQ", "GFORCE", "JOINT", "JPRIM", "MOTION", "PTCV", "CVCV",
];

fn load(torque: bool, component: Component, m: &Markers) -> Measure {
    Measure::MarkerLoad { torque, component, i: m.first, j: m.rest[0], k: m.rest[1] }
}
