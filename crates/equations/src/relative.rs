//! Motion of I as seen from J, and loads between two frames with their exact derivative.
//!
//! An element computes the load on I, at I's origin, in J axes. Here the reaction on J's body is
//! made, and the derivative of both with respect to increments and velocities of both bodies.

use glam::{DMat3, DVec3};

use crate::matrix::{Blocks, blocks, halves, rows};
use crate::{FrameId, FrameLoad, FrameMotion, GROUND, Loads, State, Tangent, skew};

/// Motion of frame I relative to frame J, in J axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relative {
    /// Position of I from J: `R_J^T (r_I - r_J)`.
    pub d_ji_j: DVec3,
    /// Columns are the axes of I in J: `R_J^T R_I`.
    pub rot_ji: DMat3,
    /// Velocity of I as seen by J: `R_J^T (v_I - v_J - w_J x (r_I - r_J))`.
    pub v_ji_j: DVec3,
    /// Angular velocity of I as seen by J: `R_J^T (w_I - w_J)`.
    pub w_ji_j: DVec3,
}

/// Motion of I as seen from J.
pub fn relative(state: &State, i: FrameId, j: FrameId) -> Relative {
    let (i, j) = (state.frame(i), state.frame(j));
    let to_j = j.rot_gi.transpose();
    let r_ji_g = i.r_gi_g - j.r_gi_g;
    Relative {
        d_ji_j: to_j * r_ji_g,
        rot_ji: to_j * i.rot_gi,
        v_ji_j: to_j * (i.v_gi_g - j.v_gi_g - j.w_gi_g.cross(r_ji_g)),
        w_ji_j: to_j * (i.w_gi_g - j.w_gi_g),
    }
}

/// Load on J's body at J's origin: equal and opposite, plus the moment of the force over the arm
/// from J to I. Ground axes.
pub fn load_of_reaction(i: &FrameMotion, j: &FrameMotion, on_i: FrameLoad) -> FrameLoad {
    let r_ji_g = i.r_gi_g - j.r_gi_g;
    FrameLoad { f_g: -on_i.f_g, t_g: -on_i.t_g - r_ji_g.cross(on_i.f_g) }
}

/// Adds a load on I, given in J axes as `[f | t]`, and its reaction on J.
pub fn apply_between(state: &State, i: FrameId, j: FrameId, load_on_i_j: &[f64; 6], loads: &mut dyn Loads) {
    apply_following(state, i, Some(j), Some(j), load_on_i_j, loads);
}

/// Adds a load on I, given in the axes of `axes` (ground axes if none) as `[f | t]`, and its
/// reaction on J's body, if there is a J.
pub fn apply_following(
    state: &State,
    i: FrameId,
    j: Option<FrameId>,
    axes: Option<FrameId>,
    load_on_i: &[f64; 6],
    loads: &mut dyn Loads,
) {
    let rot = state.frame_or_global(axes).rot_gi;
    let (f, t) = halves(load_on_i);
    let on_i = FrameLoad { f_g: rot * f, t_g: rot * t };
    loads.at_frame(state, i, on_i);
    if let Some(j) = j {
        loads.at_frame(state, j, load_of_reaction(state.frame(i), state.frame(j), on_i));
    }
}

/// Derivative of one vector with respect to one body's translation, spin, velocity and angular
/// velocity; everything in ground axes.
#[derive(Clone, Copy)]
struct Partial {
    r: DMat3,
    phi: DMat3,
    v: DMat3,
    w: DMat3,
}

impl Partial {
    const ZERO: Partial = Partial { r: DMat3::ZERO, phi: DMat3::ZERO, v: DMat3::ZERO, w: DMat3::ZERO };

    fn left(&self, m: DMat3) -> Partial {
        Partial { r: m * self.r, phi: m * self.phi, v: m * self.v, w: m * self.w }
    }

    fn plus(&self, other: &Partial) -> Partial {
        Partial { r: self.r + other.r, phi: self.phi + other.phi, v: self.v + other.v, w: self.w + other.w }
    }

    fn minus(&self) -> Partial {
        self.left(DMat3::from_diagonal(DVec3::NEG_ONE))
    }

    fn spun(&self, m: DMat3) -> Partial {
        Partial { phi: self.phi + m, ..*self }
    }
}

/// Force and torque at I's origin on I's body: derivative with respect to one body.
#[derive(Clone, Copy)]
struct LoadPartial {
    f: Partial,
    t: Partial,
}

/// Adds the derivative of what [`apply_between`] adds.
///
/// `load` is the load on I in J axes. `d_load_d_displacement` is its derivative with respect to
/// `[dd | psi]`: the change of `d_ji_j`, and the relative spin `R_J^T (dphi_I - dphi_J)`.
/// `d_load_d_velocity` is its derivative with respect to `[v_ji_j | w_ji_j]`. Rotation of the J
/// axes, the arms on both bodies and the change of the relative velocities with position are
/// added here, so the result is exact.
pub fn tangent_between(
    state: &State,
    i: FrameId,
    j: FrameId,
    load: &[f64; 6],
    d_load_d_displacement: &[[f64; 6]; 6],
    d_load_d_velocity: &[[f64; 6]; 6],
    tangent: &mut dyn Tangent,
) {
    let k = blocks(d_load_d_displacement);
    let c = blocks(d_load_d_velocity);
    between(state, i, j, true, load, &k, &c, tangent);
}

/// [`tangent_between`] with 3x3 blocks, and with the reaction on J left out on demand.
#[allow(clippy::too_many_arguments)] // one call site per public form, all of them in this crate
pub(crate) fn between(
    state: &State,
    i: FrameId,
    j: FrameId,
    reaction: bool,
    load: &[f64; 6],
    k: &Blocks,
    c: &Blocks,
    tangent: &mut dyn Tangent,
) {
    let (i, j) = (state.frame(i), state.frame(j));
    let (rot, to_j) = (j.rot_gi, j.rot_gi.transpose());
    let (f, t) = halves(load);
    let (f_g, t_g) = (rot * f, rot * t);
    let turn = |m: &DMat3| rot * *m * to_j;
    let k = k.each_ref().map(|row| row.each_ref().map(turn));

    // Derivative of displacement and relative spin, turned into ground axes:
    // dd = dr_I - dr_J + d x dphi_J, psi = dphi_I - dphi_J.
    let d = i.r_gi_g - j.r_gi_g;
    let arm_j = j.r_bi_g + d;
    let (skew_arm_i, skew_arm_j) = (skew(i.r_bi_g), skew(arm_j));
    let one = DMat3::IDENTITY;
    let displacement = [
        LoadPartial {
            f: Partial { r: one, phi: -skew_arm_i, ..Partial::ZERO },
            t: Partial { phi: one, ..Partial::ZERO },
        },
        LoadPartial {
            f: Partial { r: -one, phi: skew_arm_j, ..Partial::ZERO },
            t: Partial { phi: -one, ..Partial::ZERO },
        },
    ];
    let mut partials = displacement.map(|x| multiply(&k, &x));

    if c.iter().flatten().any(|block| *block != DMat3::ZERO) {
        let c = c.each_ref().map(|row| row.each_ref().map(turn));
        for (partial, x) in partials.iter_mut().zip(&velocity_partials(i, j)) {
            let rate = multiply(&c, x);
            *partial = LoadPartial { f: partial.f.plus(&rate.f), t: partial.t.plus(&rate.t) };
        }
    }

    // The axes of J turn the load with them.
    partials[1].f = partials[1].f.spun(-skew(f_g));
    partials[1].t = partials[1].t.spun(-skew(t_g));
    add_rows(state, i, reaction.then_some(j), f_g, t_g, &[(i, partials[0]), (j, partials[1])], tangent);
}

/// Derivative of the relative velocities with respect to the motion of both bodies, turned into
/// ground axes.
fn velocity_partials(i: &FrameMotion, j: &FrameMotion) -> [LoadPartial; 2] {
    let d = i.r_gi_g - j.r_gi_g;
    let (w_i, w_j) = (i.w_gi_g, j.w_gi_g);
    let u = i.v_gi_g - j.v_gi_g - w_j.cross(d);
    let (skew_w_i, skew_w_j) = (skew(w_i), skew(w_j));
    let (skew_arm_i, skew_arm_j) = (skew(i.r_bi_g), skew(j.r_bi_g + d));
    let one = DMat3::IDENTITY;
    [
        LoadPartial {
            f: Partial { r: -skew_w_j, phi: skew_w_j * skew_arm_i - skew(w_i.cross(i.r_bi_g)), v: one, w: -skew_arm_i },
            t: Partial { phi: -skew_w_i, w: one, ..Partial::ZERO },
        },
        LoadPartial {
            f: Partial {
                r: skew_w_j,
                phi: skew(w_j.cross(j.r_bi_g)) - skew(d) * skew_w_j - skew_w_j * skew(j.r_bi_g) + skew(u),
                v: -one,
                w: skew_arm_j,
            },
            // w_J + (w_I - w_J): the spin of J turns its own angular velocity and the axes.
            t: Partial { phi: skew_w_i, w: -one, ..Partial::ZERO },
        },
    ]
}

fn multiply(m: &Blocks, x: &LoadPartial) -> LoadPartial {
    LoadPartial { f: x.f.left(m[0][0]).plus(&x.t.left(m[0][1])), t: x.f.left(m[1][0]).plus(&x.t.left(m[1][1])) }
}

/// Adds the derivative of what [`apply_following`] adds, for constant components in `axes`.
pub fn tangent_following(
    state: &State,
    i: FrameId,
    j: Option<FrameId>,
    axes: Option<FrameId>,
    load: &[f64; 6],
    tangent: &mut dyn Tangent,
) {
    let axes = state.frame_or_global(axes);
    let (f, t) = halves(load);
    let (f_g, t_g) = (axes.rot_gi * f, axes.rot_gi * t);
    let zero = LoadPartial { f: Partial::ZERO, t: Partial::ZERO };
    let turned = LoadPartial { f: zero.f.spun(-skew(f_g)), t: zero.t.spun(-skew(t_g)) };
    let (i, j) = (state.frame(i), j.map(|j| state.frame(j)));
    add_rows(state, i, j, f_g, t_g, &[(i, zero), (axes, turned)], tangent);
}

/// Adds rows for the loads on I's body and on J's body from the derivative of the load on I.
///
/// `columns` holds the derivative with respect to the body of each frame named; the first is I.
fn add_rows(
    state: &State,
    i: &FrameMotion,
    j: Option<&FrameMotion>,
    f_g: DVec3,
    t_g: DVec3,
    columns: &[(&FrameMotion, LoadPartial); 2],
    tangent: &mut dyn Tangent,
) {
    // Torque about the centre of mass of I's body: t + c x f, seen from the body.
    let arm_i = skew(i.r_bi_g);
    let torque_i = t_g + i.r_bi_g.cross(f_g);
    for (at, (frame, partial)) in columns.iter().enumerate() {
        let mut moment = partial.t.plus(&partial.f.left(arm_i));
        if at == 0 {
            moment = moment.spun(skew(f_g) * arm_i + skew(torque_i));
        }
        emit(state, i, frame, &partial.f, &moment, tangent);
    }
    let Some(j) = j else { return };
    let arm = j.r_bi_g + i.r_gi_g - j.r_gi_g;
    for (frame, partial) in columns {
        let moment = partial.t.plus(&partial.f.left(skew(arm))).minus();
        emit(state, j, frame, &partial.f.minus(), &moment, tangent);
    }
    add_arm_of_reaction(state, i, j, f_g, t_g, tangent);
}

/// Derivative of the reaction's torque `-t - p x f` about J's centre of mass, for fixed `f` and
/// `t`: the arm `p` from there to I changes, and the components are taken in J's body.
fn add_arm_of_reaction(
    state: &State,
    i: &FrameMotion,
    j: &FrameMotion,
    f_g: DVec3,
    t_g: DVec3,
    tangent: &mut dyn Tangent,
) {
    let arm = j.r_bi_g + i.r_gi_g - j.r_gi_g;
    let torque = -t_g - arm.cross(f_g);
    let skew_f = skew(f_g);
    let by_i = Partial { r: skew_f, phi: -(skew_f * skew(i.r_bi_g)), ..Partial::ZERO };
    let by_j = Partial { r: -skew_f, phi: skew(torque), ..Partial::ZERO };
    emit(state, j, i, &Partial::ZERO, &by_i, tangent);
    emit(state, j, j, &Partial::ZERO, &by_j, tangent);
}

/// Turns the torque row and the spin columns into body axes and hands the block over.
fn emit(
    state: &State,
    row: &FrameMotion,
    column: &FrameMotion,
    force: &Partial,
    torque: &Partial,
    tangent: &mut dyn Tangent,
) {
    if row.body == GROUND || column.body == GROUND {
        return;
    }
    let (stiffness, damping) = (tangent.stiffness(), tangent.damping());
    let to_row = state.rotation(row.body).transpose();
    let from_column = state.rotation(column.body);
    let translations = |p: &Partial| p.r * stiffness + p.v * damping;
    let rotations = |p: &Partial| (p.phi * stiffness + p.w * damping) * from_column;
    let block = [[translations(force), rotations(force)], [to_row * translations(torque), to_row * rotations(torque)]];
    tangent.add(row.body, column.body, &rows(&block));
}
