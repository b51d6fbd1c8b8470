//! A rigid body that tumbles without loads: rotations as unit quaternions, velocities in body axes.

use crate::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

/// Principal moments of inertia, kg m^2. Positions are a quaternion `w x y z`.
#[derive(Clone, Debug)]
pub struct FreeBody {
    pub inertia: [f64; 3],
}

fn product(a: &[f64], b: &[f64]) -> [f64; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

fn cross(a: &[f64], b: &[f64]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A body vector in ground axes.
pub fn to_ground(q: &[f64], x: [f64; 3]) -> [f64; 3] {
    let p = product(&product(q, &[0.0, x[0], x[1], x[2]]), &[q[0], -q[1], -q[2], -q[3]]);
    [p[1], p[2], p[3]]
}

impl FreeBody {
    pub fn momentum(&self, w: &[f64]) -> [f64; 3] {
        std::array::from_fn(|i| self.inertia[i] * w[i])
    }
}

impl Dae for FreeBody {
    fn positions(&self) -> usize {
        4
    }
    fn velocities(&self) -> usize {
        3
    }
    fn constraints(&self) -> usize {
        0
    }
    fn pattern(&self) -> Pattern {
        Pattern { sizes: vec![3], velocity_blocks: 1, pairs: Vec::new() }
    }
    fn scales(&self) -> Scales {
        Scales { increments: vec![1.0; 3] }
    }
    fn retract(&self, q: &[f64], d: &[f64], out: &mut [f64]) {
        let half = 0.5 * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        let f = if half < 1e-9 { 0.5 } else { 0.5 * half.sin() / half };
        let turned = product(q, &[half.cos(), f * d[0], f * d[1], f * d[2]]);
        let size = turned.iter().map(|x| x * x).sum::<f64>().sqrt();
        for (o, x) in out.iter_mut().zip(turned) {
            *o = x / size;
        }
    }
    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]) {
        let mut d = product(&[q0[0], -q0[1], -q0[2], -q0[3]], q1);
        if d[0] < 0.0 {
            d = d.map(|x| -x);
        }
        let sin = (d[1] * d[1] + d[2] * d[2] + d[3] * d[3]).sqrt();
        let f = if sin < 1e-9 { 2.0 } else { 2.0 * sin.atan2(d[0]) / sin };
        for i in 0..3 {
            out[i] = f * d[i + 1];
        }
    }
    fn residual(
        &mut self,
        _: f64,
        _: &[f64],
        w: &[f64],
        a: &[f64],
        _: &[f64],
        r: &mut [f64],
    ) -> Result<(), Evaluation> {
        let gyroscopic = cross(w, &self.momentum(w));
        for i in 0..3 {
            r[i] = self.inertia[i] * a[i] + gyroscopic[i];
        }
        Ok(())
    }
    fn constraint_residual(&mut self, _: f64, _: &[f64], _: &mut [f64]) -> Result<(), Evaluation> {
        Ok(())
    }
    fn constraint_velocity(&mut self, _: f64, _: &[f64], _: &mut [f64]) -> Result<(), Evaluation> {
        Ok(())
    }
    fn constraint_acceleration(&mut self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) -> Result<(), Evaluation> {
        Ok(())
    }
    fn jacobian(&mut self, at: JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) -> Result<(), Evaluation> {
        let mut block = [0.0; 9];
        for column in 0..3 {
            let mut unit = [0.0; 3];
            unit[column] = 1.0;
            let (a, b) = (cross(&unit, &self.momentum(at.v)), cross(at.v, &self.momentum(&unit)));
            for row in 0..3 {
                block[3 * column + row] = at.damping * (a[row] + b[row]);
            }
            block[4 * column] += at.mass * self.inertia[column];
        }
        add(0, 0, &block);
        Ok(())
    }
    fn describe(&self, unknown: usize) -> String {
        format!("rotation {unknown}")
    }
}

mod tests {
    use super::*;
    use crate::{IntegratorOptions, Method, Silent, SystemState, integrate, output_times};

    const METHODS: [Method; 3] =
        [Method::Hht { alpha: -0.3 }, Method::GeneralisedAlpha { rho: 0.8 }, Method::GeneralisedAlpha { rho: 1.0 }];

    fn tumbled(options: &IntegratorOptions, end: f64, steps: usize) -> SystemState {
        let mut body = FreeBody { inertia: [1.0, 2.0, 3.0] };
        let mut state = SystemState::at_rest(&body, 0.0, vec![1.0, 0.0, 0.0, 0.0]);
        // About the middle axis, which is unstable: it turns over.
        state.v = vec![0.05, 3.0, 0.02];
        integrate(&mut body, &mut state, end, &output_times(0.0, end, steps), options, &mut Silent).unwrap();
        state
    }

    /// Truth: angular momentum in ground axes and energy stay. About 8 turns of the unstable
    /// motion; e^(2/3) of the error per step, times the growth e^(1.7 * 3) or so before it turns.
    #[test]
    fn momentum_and_energy_stay() {
        let body = FreeBody { inertia: [1.0, 2.0, 3.0] };
        for method in METHODS {
            let state = tumbled(&IntegratorOptions { method, error: 1e-8, ..Default::default() }, 6.0, 60);
            assert!(state.v[1] < 2.9, "it has left the middle axis: {:?}", state.v);
            let start = body.momentum(&[0.05, 3.0, 0.02]);
            let now = to_ground(&state.q, body.momentum(&state.v));
            for i in 0..3 {
                assert!((now[i] - start[i]).abs() < 2e-3, "{method:?}: {now:?} {start:?}");
            }
            let energy = |w: &[f64]| (0..3).map(|i| 0.5 * body.inertia[i] * w[i] * w[i]).sum::<f64>();
            assert!((energy(&state.v) / energy(&[0.05, 3.0, 0.02]) - 1.0).abs() < 1e-4, "{method:?}");
        }
    }

    /// Truth: second order also on the rotation group, in positions and velocities.
    #[test]
    fn the_order_is_two_on_rotations() {
        for method in METHODS {
            let options = IntegratorOptions { method, fixed: true, error: 1e-10, ..Default::default() };
            let end = |steps| tumbled(&options, 3.0, steps);
            let (a, b, c) = (end(600), end(1200), end(2400));
            let distance = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
            for order in [
                (distance(&a.q, &b.q) / distance(&b.q, &c.q)).log2(),
                (distance(&a.v, &b.v) / distance(&b.v, &c.v)).log2(),
            ] {
                assert!((order - 2.0).abs() < 0.1, "{method:?}: {order}");
            }
        }
    }
}
