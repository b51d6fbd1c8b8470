//! Velocities and accelerations of markers. The last marker is the frame in which the derivative is
//! taken.

use super::{MAGNITUDE, Markers, OfMarkers, X, Y, Z};
use crate::{Component, Measure};

pub(super) const ALL: &[OfMarkers] = &[
    OfMarkers { name: "VX", arguments: (1, 4), measure: |m| velocity(X, m) },
    OfMarkers { name: "VY", arguments: (1, 4), measure: |m| velocity(Y, m) },
    OfMarkers { name: "VZ", arguments: (1, 4), measure: |m| velocity(Z, m) },
    // VM(i, j, l): no axes needed.
    OfMarkers { name: "VM", arguments: (1, 3), measure: |m| velocity(MAGNITUDE, &without_axes(m)) },
    OfMarkers {
        name: "VR",
        arguments: (1, 3),
        measure: |m| Measure::RadialVelocity { i: m.first, j: m.rest[0], l: m.rest[1] },
    },
    OfMarkers { name: "WX", arguments: (1, 3), measure: |m| angular_velocity(X, m) },
    OfMarkers { name: "WY", arguments: (1, 3), measure: |m| angular_velocity(Y, m) },
    OfMarkers { name: "WZ", arguments: (1, 3), measure: |m| angular_velocity(Z, m) },
    OfMarkers { name: "WM", arguments: (1, 2), measure: |m| angular_velocity(MAGNITUDE, m) },
    OfMarkers { name: "ACCX", arguments: (1, 4), measure: |m| acceleration(X, m) },
    OfMarkers { name: "ACCY", arguments: (1, 4), measure: |m| acceleration(Y, m) },
    OfMarkers { name: "ACCZ", arguments: (1, 4), measure: |m| acceleration(Z, m) },
    OfMarkers { name: "ACCM", arguments: (1, 3), measure: |m| acceleration(MAGNITUDE, &without_axes(m)) },
    OfMarkers { name: "WDTX", arguments: (1, 4), measure: |m| angular_acceleration(X, m) },
    OfMarkers { name: "WDTY", arguments: (1, 4), measure: |m| angular_acceleration(Y, m) },
    OfMarkers { name: "WDTZ", arguments: (1, 4), measure: |m| angular_acceleration(Z, m) },
    OfMarkers { name: "WDTM", arguments: (1, 3), measure: |m| angular_acceleration(MAGNITUDE, &without_axes(m)) },
];

/// Arguments `(i, j, l)` as `(i, j, global, l)`.
fn without_axes(m: &Markers) -> Markers {
    Markers { first: m.first, rest: [m.rest[0], None, m.rest[1]] }
}

fn velocity(component: Component, m: &Markers) -> Measure {
    Measure::Velocity { component, i: m.first, j: m.rest[0], k: m.rest[1], l: m.rest[2] }
}

fn angular_velocity(component: Component, m: &Markers) -> Measure {
    Measure::AngularVelocity { component, i: m.first, j: m.rest[0], k: m.rest[1] }
}

fn acceleration(component: Component, m: &Markers) -> Measure {
    Measure::Acceleration { component, i: m.first, j: m.rest[0], k: m.rest[1], l: m.rest[2] }
}

fn angular_acceleration(component: Component, m: &Markers) -> Measure {
    Measure::AngularAcceleration { component, i: m.first, j: m.rest[0], k: m.rest[1], l: m.rest[2] }
}
