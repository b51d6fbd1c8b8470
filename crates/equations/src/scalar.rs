//! Loads of one number: along the line of two markers, along or about an axis of J.
//!
//! The number's own derivative comes as a [`Gradient`]; the change of its direction and arm is
//! added here.

use glam::{DMat3, DVec3};

use crate::matrix::{halves, outer, six};
use crate::relative::between;
use crate::{
    Axis, FrameId, FrameLoad, Gradient, Loads, State, Tangent, apply_between, apply_following, load_of_reaction,
    relative,
};

/// How a scalar acts on I.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalarAction {
    /// Force along the line from J to I: positive pushes I away from J.
    Line,
    /// Force at I along an axis of J.
    Force(Axis),
    /// Torque on I about an axis of J.
    Torque(Axis),
}

/// Load on I in J axes, `[f | t]`, of a scalar of size 1; zero along the line of coincident markers.
pub fn scalar_load(state: &State, i: FrameId, j: FrameId, action: ScalarAction) -> [f64; 6] {
    match action {
        ScalarAction::Line => six(relative(state, i, j).d_ji_j.normalize_or_zero(), DVec3::ZERO),
        ScalarAction::Force(axis) => six(DVec3::AXES[axis.index()], DVec3::ZERO),
        ScalarAction::Torque(axis) => six(DVec3::ZERO, DVec3::AXES[axis.index()]),
    }
}

/// Adds a scalar load on I and, with `reaction`, what it does to J.
pub fn apply_scalar(
    state: &State,
    i: FrameId,
    j: FrameId,
    action: ScalarAction,
    reaction: bool,
    value: f64,
    loads: &mut dyn Loads,
) {
    let load = scalar_load(state, i, j, action).map(|unit| value * unit);
    if reaction {
        apply_between(state, i, j, &load, loads);
    } else {
        apply_following(state, i, None, Some(j), &load, loads);
    }
}

/// Adds the derivative of what [`apply_scalar`] adds. `gradient` is the derivative of `value`.
#[allow(clippy::too_many_arguments)] // the arguments of `apply_scalar` and the gradient
pub fn tangent_scalar(
    state: &State,
    i: FrameId,
    j: FrameId,
    action: ScalarAction,
    reaction: bool,
    value: f64,
    gradient: &Gradient,
    tangent: &mut dyn Tangent,
) {
    let unit = scalar_load(state, i, j, action);
    let mut stiffness = [[DMat3::ZERO; 2]; 2];
    if action == ScalarAction::Line {
        let (direction, _) = halves(&unit);
        let length = relative(state, i, j).d_ji_j.length();
        if length > 0.0 {
            // d(value e)/dd = value (1 - e e^T) / |d|
            stiffness[0][0] = (DMat3::IDENTITY - outer(direction, direction)) * (value / length);
        }
    }
    between(state, i, j, reaction, &unit.map(|u| value * u), &stiffness, None, tangent);
    tangent_gradient(state, i, reaction.then_some(j), Some(j), &unit, gradient, tangent);
}

/// Adds the derivative of a load that is `value` times a constant `unit` load on I (in the axes of
/// `axes`, ground axes if none), with its reaction on J if there is one: the part that comes from
/// the change of `value`. The other part is [`crate::tangent_following`].
pub fn tangent_gradient(
    state: &State,
    i: FrameId,
    j: Option<FrameId>,
    axes: Option<FrameId>,
    unit: &[f64; 6],
    gradient: &Gradient,
    tangent: &mut dyn Tangent,
) {
    let rot = state.frame_or_global(axes).rot_gi;
    let (f, t) = halves(unit);
    let on_i = FrameLoad { f_g: rot * f, t_g: rot * t };
    add_outer(state, i, on_i, gradient, tangent);
    if let Some(j) = j {
        add_outer(state, j, load_of_reaction(state.frame(i), state.frame(j), on_i), gradient, tangent);
    }
}

fn add_outer(state: &State, at: FrameId, load: FrameLoad, gradient: &Gradient, tangent: &mut dyn Tangent) {
    let frame = state.frame(at);
    if frame.body == crate::GROUND {
        return;
    }
    let to_body = state.rotation(frame.body).transpose();
    let generalised = six(load.f_g, to_body * (load.t_g + frame.r_bi_g.cross(load.f_g)));
    let (stiffness, damping) = (tangent.stiffness(), tangent.damping());
    for (body, values) in gradient.entries() {
        let block = generalised
            .map(|component| std::array::from_fn(|c| component * (stiffness * values[c] + damping * values[6 + c])));
        tangent.add(frame.body, *body, &block);
    }
}
