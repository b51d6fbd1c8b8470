//! The derivative of a load between two frames as one number, for functions that ask for it: the
//! same chain rule as in `relative`, read backwards.

use glam::DVec3;

use crate::matrix::{blocks, halves};
use crate::{FrameCotangent, FrameId, Gradient, Side, State};

/// What a number makes of a load at a frame's origin: `ds = f . df_g + t . dt_g`, ground axes.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct LoadCotangent {
    pub f: DVec3,
    pub t: DVec3,
}

/// Adds the derivative of `s = of.f . f_g + of.t . t_g`, with fixed `of`, of the load at a side.
///
/// `load` is the load on I in J axes; its derivatives are those of
/// [`tangent_between`](crate::tangent_between), and so is the chain rule:
///
/// ```text
/// df_g = dphi_J x f_g + R_J (K [dd; psi] + C [dV; dW])        the same for the torque t_g
/// ```
///
/// The load on J is `-f` and `-t - d x f`.
#[allow(clippy::too_many_arguments)] // the arguments of `tangent_between`, and what is asked for
pub fn load_gradient(
    state: &State,
    (i, j): (FrameId, FrameId),
    side: Side,
    load: &[f64; 6],
    d_load_d_displacement: &[[f64; 6]; 6],
    d_load_d_velocity: &[[f64; 6]; 6],
    of: &LoadCotangent,
    gradient: &mut Gradient,
) {
    let (i, j) = (state.frame(i), state.frame(j));
    let (rot, to_j) = (j.rot_gi, j.rot_gi.transpose());
    let (f, t) = halves(load);
    let (f, t) = (rot * f, rot * t);
    let d = i.r_gi_g - j.r_gi_g;
    // What the number makes of the load on I, and of the arm itself.
    let (u, w, by_arm) = match side {
        Side::I => (of.f, of.t, DVec3::ZERO),
        Side::J => (-of.f - of.t.cross(d), -of.t, -f.cross(of.t)),
    };
    let turned = [to_j * u, to_j * w];
    let back = |k: &[[f64; 6]; 6]| {
        let k = blocks(k);
        let column = |at: usize| rot * (k[0][at].transpose() * turned[0] + k[1][at].transpose() * turned[1]);
        [column(0), column(1)]
    };
    let [by_d, by_psi] = back(d_load_d_displacement);
    let [by_v, by_w] = back(d_load_d_velocity);
    let by_d = by_d + by_arm;
    let v = i.v_gi_g - j.v_gi_g - j.w_gi_g.cross(d);
    let spin = i.w_gi_g - j.w_gi_g;
    let by_r = by_d - by_v.cross(j.w_gi_g);
    // The arm itself does not see J turn, unlike the components of `d` in J axes.
    let seen_turning = by_d - by_arm;
    let on_i = FrameCotangent { r: by_r, phi: by_psi, v: by_v, w: by_w };
    let on_j = FrameCotangent {
        r: -by_r,
        phi: seen_turning.cross(d) - by_psi - v.cross(by_v) - spin.cross(by_w) + f.cross(u) + t.cross(w),
        v: -by_v,
        w: -by_w - d.cross(by_v),
    };
    gradient.add_frame(state, i, &on_i);
    gradient.add_frame(state, j, &on_j);
}
