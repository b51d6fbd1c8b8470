//! Motion of I as seen from J, and loads between two frames with their exact derivative.
//!
//! An element computes the load on I, at I's origin, in J axes. Here the reaction on J's body is
//! made, and the derivative of both with respect to increments and velocities of both bodies.

use glam::{DMat3, DVec3};

use crate::matrix::{Blocks, blocks, halves, rows_of, skew_times, times_skew};
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

/// Derivative of a load at I with respect to one body: columns for its translation and for its
/// spin (ground axes), stiffness and damping already added up with the wanted factors.
#[derive(Clone, Copy)]
struct Columns {
    /// Force and torque by translation.
    r: [DMat3; 2],
    /// Force and torque by spin.
    phi: [DMat3; 2],
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
    between(state, i, j, true, load, &k, Some(&c), tangent);
}

/// [`tangent_between`] with 3x3 blocks, and with the reaction on J left out on demand.
///
/// With the changes of displacement and relative spin, turned into ground axes,
///
/// ```text
/// dd  = dr_I - dr_J + d x dphi_J         psi = dphi_I - dphi_J
/// dV  = dv_I - dv_J - dw_J x d - w_J x (dr_I - dr_J) - dphi_J x V
/// dW  = dw_I - dw_J - dphi_J x W
/// ```
///
/// the load changes by `K [dd; psi] + C [dV; dW] + dphi_J x load`.
#[allow(clippy::too_many_arguments)] // one call for each public form, all of them in this crate
pub(crate) fn between(
    state: &State,
    i: FrameId,
    j: FrameId,
    reaction: bool,
    load: &[f64; 6],
    k: &Blocks,
    c: Option<&Blocks>,
    tangent: &mut dyn Tangent,
) {
    let (i, j) = (state.frame(i), state.frame(j));
    let (stiffness, damping) = (tangent.stiffness(), tangent.damping());
    let (rot, to_j) = (j.rot_gi, j.rot_gi.transpose());
    let (f, t) = halves(load);
    let loads = [rot * f, rot * t];
    let d = i.r_gi_g - j.r_gi_g;
    let arm_j = j.r_bi_g + d;
    let turn = |m: DMat3| rot * m * to_j;

    let (w_i, w_j) = (i.w_gi_g, j.w_gi_g);
    let moving = stiffness != 0.0 && (w_i != DVec3::ZERO || w_j != DVec3::ZERO || i.v_gi_g != j.v_gi_g);
    let (spin_i, spin_j) = if moving { velocity_by_spin(i, j) } else { (DMat3::ZERO, DMat3::ZERO) };
    let empty = Columns { r: [DMat3::ZERO; 2], phi: [DMat3::ZERO; 2] };
    let (mut by_i, mut by_j) = (empty, empty);
    for row in 0..2 {
        let [mut by_d, mut by_psi] = k[row].map(|block| block * stiffness);
        if let Some(c) = c {
            by_d += c[row][0] * damping;
            by_psi += c[row][1] * damping;
        }
        let (by_d, by_psi) = (turn(by_d), turn(by_psi));
        by_i.r[row] = by_d;
        by_i.phi[row] = by_psi - times_skew(&by_d, i.r_bi_g);
        by_j.phi[row] = times_skew(&by_d, arm_j) - by_psi - skew(loads[row] * stiffness);
        if let (Some(c), true) = (c, moving) {
            let [by_v, by_w] = c[row].map(|block| turn(block * stiffness));
            let turned = times_skew(&by_w, w_i);
            by_i.r[row] -= times_skew(&by_v, w_j);
            by_i.phi[row] += by_v * spin_i - turned;
            by_j.phi[row] += by_v * spin_j + turned;
        }
        by_j.r[row] = -by_i.r[row];
    }
    add_rows(state, i, reaction.then_some(j), loads, &[(i, by_i), (j, by_j)], true, tangent);
}

/// Derivative of the relative velocity (ground axes) with respect to the spins of I's and J's
/// bodies; that of the relative angular velocity is `-skew(w_I)` and `skew(w_I)`.
fn velocity_by_spin(i: &FrameMotion, j: &FrameMotion) -> (DMat3, DMat3) {
    let d = i.r_gi_g - j.r_gi_g;
    let (w_i, w_j) = (i.w_gi_g, j.w_gi_g);
    let v = i.v_gi_g - j.v_gi_g - w_j.cross(d);
    let by_i = skew_times(w_j, &skew(i.r_bi_g)) - skew(w_i.cross(i.r_bi_g));
    let by_j = skew(w_j.cross(j.r_bi_g) + v) - skew_times(d, &skew(w_j)) - skew_times(w_j, &skew(j.r_bi_g));
    (by_i, by_j)
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
    let loads = [axes.rot_gi * f, axes.rot_gi * t];
    let stiffness = tangent.stiffness();
    let zero = Columns { r: [DMat3::ZERO; 2], phi: [DMat3::ZERO; 2] };
    let turned = Columns { phi: loads.map(|vector| -skew(vector * stiffness)), ..zero };
    let (i, j) = (state.frame(i), j.map(|j| state.frame(j)));
    add_rows(state, i, j, loads, &[(i, zero), (axes, turned)], false, tangent);
    if let Some(j) = j {
        // J moves the arm of the reaction only.
        let zero = [DMat3::ZERO; 2];
        let (r, phi) = arm_by_j(i, j, loads, stiffness);
        emit(state, j, j, [zero[0], r], [zero[1], phi], tangent);
    }
}

/// Change of the reaction's torque `-t - p x f` about J's centre of mass with the motion of J's
/// body, for fixed `f` and `t`: the arm `p` to I changes, and the components are J's body's.
fn arm_by_j(i: &FrameMotion, j: &FrameMotion, [f, t]: [DVec3; 2], stiffness: f64) -> (DMat3, DMat3) {
    let arm = j.r_bi_g + i.r_gi_g - j.r_gi_g;
    (-skew(f * stiffness), skew((-t - arm.cross(f)) * stiffness))
}

/// Adds rows for the loads on I's body and, if there is a J, on J's body, from the derivative of
/// the load on I with respect to the bodies of two frames; the first is I, the second J or not.
fn add_rows(
    state: &State,
    i: &FrameMotion,
    j: Option<&FrameMotion>,
    loads: [DVec3; 2],
    columns: &[(&FrameMotion, Columns); 2],
    second_is_j: bool,
    tangent: &mut dyn Tangent,
) {
    let stiffness = tangent.stiffness();
    let [f, t] = loads;
    let skew_f_arm = skew_times(f * stiffness, &skew(i.r_bi_g));
    // Torque about a centre of mass with the arm to I.
    let moment = |arm: DVec3, by: &[DMat3; 2]| by[1] + skew_times(arm, &by[0]);
    for (at, (frame, by)) in columns.iter().enumerate() {
        let mut spin = moment(i.r_bi_g, &by.phi);
        if at == 0 {
            spin += skew_f_arm + skew((t + i.r_bi_g.cross(f)) * stiffness);
        }
        emit(state, i, frame, [by.r[0], moment(i.r_bi_g, &by.r)], [by.phi[0], spin], tangent);
    }
    let Some(j) = j else { return };
    let arm = j.r_bi_g + i.r_gi_g - j.r_gi_g;
    for (at, (frame, by)) in columns.iter().enumerate() {
        let mut translation = -moment(arm, &by.r);
        let mut spin = -moment(arm, &by.phi);
        if at == 0 {
            translation += skew(f * stiffness);
            spin -= skew_f_arm;
        } else if second_is_j {
            let (by_r, by_phi) = arm_by_j(i, j, loads, stiffness);
            translation += by_r;
            spin += by_phi;
        }
        emit(state, j, frame, [-by.r[0], translation], [-by.phi[0], spin], tangent);
    }
}

/// Turns the torque row and the spin columns into body axes and hands the block over.
fn emit(
    state: &State,
    row: &FrameMotion,
    column: &FrameMotion,
    by_translation: [DMat3; 2],
    by_spin: [DMat3; 2],
    tangent: &mut dyn Tangent,
) {
    if row.body == GROUND || column.body == GROUND {
        return;
    }
    let to_row = state.rotation(row.body).transpose();
    let from_column = state.rotation(column.body);
    let block = [
        [by_translation[0], by_spin[0] * from_column],
        [to_row * by_translation[1], to_row * by_spin[1] * from_column],
    ];
    tangent.add(row.body, column.body, &rows_of(&block));
}
