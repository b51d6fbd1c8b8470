//! States between steps: cubic in the increments, from positions and velocities at both ends.

use crate::{Dae, SystemState};

/// Fills `out` with the state at `t` between two accepted states.
pub fn interpolate(dae: &dyn Dae, from: &SystemState, to: &SystemState, t: f64, out: &mut SystemState) {
    let h = to.t - from.t;
    let s = if h > 0.0 { (t - from.t) / h } else { 1.0 };
    let n = from.v.len();
    let mut total = vec![0.0; n];
    dae.difference(&from.q, &to.q, &mut total);
    let (s2, s3) = (s * s, s * s * s);
    let (start, end) = (s3 - 2.0 * s2 + s, s3 - s2);
    let whole = 3.0 * s2 - 2.0 * s3;
    let increment: Vec<f64> = (0..n).map(|i| whole * total[i] + h * (start * from.v[i] + end * to.v[i])).collect();
    dae.retract(&from.q, &increment, &mut out.q);
    for i in 0..n {
        out.v[i] = from.v[i] + whole * (to.v[i] - from.v[i]) + h * (start * from.a[i] + end * to.a[i]);
        out.a[i] = from.a[i] + s * (to.a[i] - from.a[i]);
    }
    for (i, li) in out.lambda.iter_mut().enumerate() {
        *li = from.lambda[i] + s * (to.lambda[i] - from.lambda[i]);
    }
    out.t = t;
}
