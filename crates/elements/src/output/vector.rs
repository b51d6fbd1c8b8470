//! Columns that belong together: the components of a relative motion, of a load, of a part.

use equations::FrameId;
use functions::{Component, Measure};
use schema::Dimension;

use super::outputs::{Column, Polar, Quantity, Unit};
use crate::lower::Lowering;

pub(crate) const XYZ: [Component; 3] = [Component::X, Component::Y, Component::Z];

/// Markers of a relative motion: of `i` from `j`, in the axes of `k`, derivatives as seen by `l`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Markers {
    pub i: u32,
    pub j: Option<u32>,
    pub k: Option<u32>,
    pub l: Option<u32>,
}

/// Kind of vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Vector {
    Displacement,
    Velocity,
    AngularVelocity,
    Acceleration,
    AngularAcceleration,
    Force,
    Torque,
}

impl Vector {
    /// The measure of one component.
    pub fn measure(self, component: Component, m: Markers) -> Measure {
        let Markers { i, j, k, l } = m;
        match self {
            Vector::Displacement => Measure::Displacement { component, i, j, k },
            Vector::Velocity => Measure::Velocity { component, i, j, k, l },
            Vector::AngularVelocity => Measure::AngularVelocity { component, i, j, k },
            Vector::Acceleration => Measure::Acceleration { component, i, j, k, l },
            Vector::AngularAcceleration => Measure::AngularAcceleration { component, i, j, k, l },
            Vector::Force => Measure::MarkerLoad { torque: false, component, i, j, k },
            Vector::Torque => Measure::MarkerLoad { torque: true, component, i, j, k },
        }
    }

    /// Dimension of a column; angles are shown in the model's angle unit.
    pub fn dimension(self) -> Dimension {
        match self {
            Vector::Displacement => Dimension::LENGTH,
            Vector::Velocity => Dimension::VELOCITY,
            Vector::AngularVelocity => Dimension::ANGULAR_VELOCITY,
            Vector::Acceleration => Dimension::ACCELERATION,
            Vector::AngularAcceleration => Dimension::ANGULAR_ACCELERATION,
            Vector::Force => Dimension::FORCE,
            Vector::Torque => Dimension::TORQUE,
        }
    }
}

/// Adds columns `<set>.<name>` for a vector: its three components, and its size if a fourth name
/// is given.
pub(crate) fn add_vector(lowering: &mut Lowering<'_>, set: &str, names: &[&str], vector: Vector, markers: Markers) {
    let components = [Component::X, Component::Y, Component::Z, Component::Magnitude];
    for (name, component) in names.iter().zip(components) {
        let quantity = Quantity::Measure(vector.measure(component, markers));
        add(lowering, format!("{set}.{name}"), quantity, vector.dimension());
    }
}

/// Adds three angles of the sequence 3-1-3, or yaw, pitch and roll, of I relative to J.
pub(crate) fn add_angles(lowering: &mut Lowering<'_>, set: &str, names: [&str; 3], i: u32, j: Option<u32>) {
    for (which, name) in (0..3).zip(names) {
        let measure = Measure::EulerAngle { yaw_pitch_roll: false, which, i, j };
        add(lowering, format!("{set}.{name}"), Quantity::Measure(measure), Dimension::ANGLE);
    }
}

/// Adds the load of an element at its I marker, in global axes.
pub(crate) fn add_load(lowering: &mut Lowering<'_>, set: &str, element: model::ObjectId) {
    for (component, name) in [(2, "FX"), (3, "FY"), (4, "FZ"), (6, "TX"), (7, "TY"), (8, "TZ")] {
        let measure = Measure::Load { element: element.0, j_flag: false, component, rm: None };
        let dimension = if component <= 4 { Dimension::FORCE } else { Dimension::TORQUE };
        add(lowering, format!("{set}.{name}"), Quantity::Measure(measure), dimension);
    }
}

/// Adds position, angles, velocities and accelerations of a part's own frame.
pub(crate) fn add_motion(lowering: &mut Lowering<'_>, set: &str, frame: FrameId) {
    let markers = Markers { i: frame.0, j: None, k: None, l: None };
    add_vector(lowering, set, &["X", "Y", "Z"], Vector::Displacement, markers);
    add_angles(lowering, set, ["PSI", "THETA", "PHI"], frame.0, None);
    add_vector(lowering, set, &["VX", "VY", "VZ"], Vector::Velocity, markers);
    add_vector(lowering, set, &["WX", "WY", "WZ"], Vector::AngularVelocity, markers);
    add_vector(lowering, set, &["ACCX", "ACCY", "ACCZ"], Vector::Acceleration, markers);
    add_vector(lowering, set, &["WDX", "WDY", "WDZ"], Vector::AngularAcceleration, markers);
}

/// Adds one column.
pub(crate) fn add(lowering: &mut Lowering<'_>, name: String, quantity: Quantity, dimension: Dimension) {
    let column = Column::new(name, quantity, &Unit(lowering.units(), dimension));
    lowering.columns.push(column);
}

/// Adds the column `<measure>.Q` of a measure with cells `component`: one component of a vector.
pub(crate) fn add_measure(lowering: &mut Lowering<'_>, object: model::ObjectId, vector: Vector, markers: Markers) {
    let word = lowering.database.text(object, "component").unwrap_or("mag_component").to_ascii_lowercase();
    let name = format!("{}.Q", lowering.database.object(object).name);
    let polar = |component| Quantity::Polar { of: XYZ.map(|c| vector.measure(c, markers)), component };
    let one = |component| Quantity::Measure(vector.measure(component, markers));
    let (quantity, dimension) = match word.as_str() {
        "x_component" => (one(Component::X), vector.dimension()),
        "y_component" => (one(Component::Y), vector.dimension()),
        "z_component" => (one(Component::Z), vector.dimension()),
        "r_component" => (polar(Polar::Radius), vector.dimension()),
        "rho_component" => (polar(Polar::Distance), vector.dimension()),
        "theta_component" => (polar(Polar::Azimuth), Dimension::ANGLE),
        "phi_component" => (polar(Polar::Inclination), Dimension::ANGLE),
        _ => (one(Component::Magnitude), vector.dimension()),
    };
    add(lowering, name, quantity, dimension);
}

/// Label of a kind of quantity (`length`); other words stay as they are.
pub(crate) fn label_of(lowering: &Lowering<'_>, word: &str) -> String {
    match schema::Quantity::named(word.trim()) {
        Some(quantity) => lowering.units().label(quantity.dimension),
        None => word.trim().to_string(),
    }
}

/// Number of the frame an optional marker cell names.
pub(crate) fn optional_frame(lowering: &mut Lowering<'_>, object: model::ObjectId, cell: &str) -> Option<u32> {
    let marker = lowering.database.reference(object, cell)?;
    lowering.frame(marker).map(|frame| frame.0)
}
