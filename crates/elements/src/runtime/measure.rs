//! The bridge from what a run-time function asks for to measures of the equations. SI; angles
//! in radians.

use equations::{Axis, FrameId, Gradient, State, measures};
use functions::{Component, Measure};
use schema::Dimension;

/// An axis of the third marker, or the length of the vector.
fn axis_of(component: Component) -> Option<Axis> {
    match component {
        Component::X => Some(Axis::X),
        Component::Y => Some(Axis::Y),
        Component::Z => Some(Axis::Z),
        Component::Magnitude => None,
    }
}

/// Physical dimension of a measure; angles count as numbers, for functions see radians.
pub fn dimension(measure: &Measure) -> Dimension {
    match measure {
        Measure::Displacement { .. } => Dimension::LENGTH,
        Measure::Angle { .. } | Measure::EulerAngle { .. } | Measure::IncludedAngle { .. } => Dimension::NONE,
        Measure::Velocity { .. } | Measure::RadialVelocity { .. } => Dimension::VELOCITY,
        Measure::AngularVelocity { .. } => Dimension::of(0, 0, -1, 0, 0),
        Measure::Acceleration { .. } => Dimension::ACCELERATION,
        Measure::AngularAcceleration { .. } => Dimension::of(0, 0, -2, 0, 0),
        Measure::Load { component, .. } => {
            if *component <= 4 {
                Dimension::FORCE
            } else {
                Dimension::TORQUE
            }
        }
        Measure::MarkerLoad { torque, .. } => {
            if *torque {
                Dimension::TORQUE
            } else {
                Dimension::FORCE
            }
        }
    }
}

/// Whether the measure is an angle that turns over and must stay continuous.
pub fn turns_over(measure: &Measure) -> bool {
    matches!(measure, Measure::Angle { .. } | Measure::EulerAngle { .. })
}

/// Whether the measure follows from positions and velocities; accelerations and loads do not.
pub fn of_state(measure: &Measure) -> bool {
    !matches!(
        measure,
        Measure::Acceleration { .. }
            | Measure::AngularAcceleration { .. }
            | Measure::Load { .. }
            | Measure::MarkerLoad { .. }
    )
}

/// Frames a measure looks at.
pub fn frames(measure: &Measure) -> Vec<FrameId> {
    let ids = match *measure {
        Measure::Displacement { i, j, k, .. }
        | Measure::AngularVelocity { i, j, k, .. }
        | Measure::MarkerLoad { i, j, k, .. } => [Some(i), j, k, None],
        Measure::Angle { i, j, .. } | Measure::EulerAngle { i, j, .. } => [Some(i), j, None, None],
        Measure::IncludedAngle { i, j, k } => [Some(i), Some(j), Some(k), None],
        Measure::Velocity { i, j, k, l, .. }
        | Measure::Acceleration { i, j, k, l, .. }
        | Measure::AngularAcceleration { i, j, k, l, .. } => [Some(i), j, k, l],
        Measure::RadialVelocity { i, j, l } => [Some(i), j, l, None],
        Measure::Load { rm, .. } => [rm, None, None, None],
    };
    ids.into_iter().flatten().map(FrameId).collect()
}

/// Value of a measure of positions and velocities. Angles are on the branch nearest to `reference`;
/// the gradient is added to. Accelerations and loads are 0 here.
pub fn value(measure: &Measure, state: &State, reference: f64, gradient: Option<&mut Gradient>) -> f64 {
    let frame = |id: Option<u32>| id.map(FrameId);
    match *measure {
        Measure::Displacement { component, i, j, k } => match axis_of(component) {
            Some(axis) => measures::displacement(state, axis, FrameId(i), frame(j), frame(k), gradient),
            None => measures::distance(state, FrameId(i), frame(j), gradient),
        },
        Measure::Velocity { component, i, j, k, l } => match axis_of(component) {
            Some(axis) => measures::velocity(state, axis, FrameId(i), frame(j), frame(k), frame(l), gradient),
            None => measures::speed(state, FrameId(i), frame(j), frame(l), gradient),
        },
        Measure::RadialVelocity { i, j, l } => {
            measures::radial_velocity(state, FrameId(i), frame(j), frame(l), gradient)
        }
        Measure::AngularVelocity { component, i, j, k } => match axis_of(component) {
            Some(axis) => measures::angular_velocity(state, axis, FrameId(i), frame(j), frame(k), gradient),
            None => measures::angular_speed(state, FrameId(i), frame(j), gradient),
        },
        Measure::Angle { component, i, j } => {
            let axis = axis_of(component).unwrap_or(Axis::Z);
            measures::angle(state, axis, FrameId(i), frame(j), reference, gradient)
        }
        Measure::EulerAngle { yaw_pitch_roll: false, which, i, j } => {
            measures::angle_313(state, usize::from(which), FrameId(i), frame(j), reference, gradient)
        }
        Measure::EulerAngle { yaw_pitch_roll: true, which, i, j } => {
            measures::yaw_pitch_roll(state, usize::from(which), FrameId(i), frame(j), reference, gradient)
        }
        Measure::IncludedAngle { i, j, k } => {
            measures::included_angle(state, FrameId(i), FrameId(j), FrameId(k), gradient)
        }
        Measure::Acceleration { .. }
        | Measure::AngularAcceleration { .. }
        | Measure::Load { .. }
        | Measure::MarkerLoad { .. } => 0.0,
    }
}

/// Value of an acceleration measure, from a state computed with accelerations.
pub fn acceleration(measure: &Measure, state: &State) -> Option<f64> {
    let frame = |id: Option<u32>| id.map(FrameId);
    let (vector, component) = match *measure {
        Measure::Acceleration { component, i, j, k, l } => {
            (measures::acceleration(state, FrameId(i), frame(j), frame(k), frame(l)), component)
        }
        Measure::AngularAcceleration { component, i, j, k, l } => {
            (measures::angular_acceleration(state, FrameId(i), frame(j), frame(k), frame(l)), component)
        }
        _ => return None,
    };
    Some(axis_of(component).map_or_else(|| vector.length(), |axis| vector[axis.index()]))
}
