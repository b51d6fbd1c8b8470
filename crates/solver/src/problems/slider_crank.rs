//! A slider-crank in a plane: crank and rod with `x y angle`, the slider with `x y`, seven
//! constraint equations, one freedom.

use crate::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

/// Bodies are uniform rods; the crank turns about the origin, the slider runs along x.
#[derive(Clone, Debug)]
pub struct SliderCrank {
    pub crank: f64,
    pub rod: f64,
    /// Masses of crank, rod and slider, kg.
    pub mass: [f64; 3],
}

/// A point of a body: index of its first coordinate, and the arm along its own x if it turns.
#[derive(Clone, Copy)]
struct Point {
    block: usize,
    arm: Option<f64>,
}

impl Point {
    fn first(self) -> usize {
        3 * self.block
    }
    fn at(self, q: &[f64]) -> [f64; 2] {
        let (x, y) = (q[self.first()], q[self.first() + 1]);
        self.arm.map_or([x, y], |s| {
            let (sin, cos) = q[self.first() + 2].sin_cos();
            [x + s * cos, y + s * sin]
        })
    }
    /// First derivative by the angle; the second is minus the arm.
    fn turned(self, q: &[f64]) -> [f64; 2] {
        self.arm.map_or([0.0; 2], |s| {
            let (sin, cos) = q[self.first() + 2].sin_cos();
            [-s * sin, s * cos]
        })
    }
    fn arm(self, q: &[f64]) -> [f64; 2] {
        let [dx, dy] = self.turned(q);
        [dy, -dx]
    }
}

impl SliderCrank {
    /// Point equations `point - other = 0`; multiplier blocks 3, 4, 5 of two equations each, then
    /// block 6: the slider's height.
    fn pins(&self) -> [(Point, Option<Point>); 3] {
        let point = |block, arm| Point { block, arm };
        [
            (point(0, Some(-self.crank / 2.0)), None),
            (point(1, Some(-self.rod / 2.0)), Some(point(0, Some(self.crank / 2.0)))),
            (point(2, None), Some(point(1, Some(self.rod / 2.0)))),
        ]
    }

    fn inertia(&self) -> [f64; 8] {
        let [a, b, c] = self.mass;
        [a, a, a * self.crank * self.crank / 12.0, b, b, b * self.rod * self.rod / 12.0, c, c]
    }

    /// Positions for an angle of the crank.
    pub fn placed(&self, angle: f64) -> Vec<f64> {
        let (sin, cos) = angle.sin_cos();
        let (x, y) = (self.crank * cos, self.crank * sin);
        let tilt = -(y / self.rod).asin();
        let end = x + self.rod * tilt.cos();
        vec![x / 2.0, y / 2.0, angle, x.midpoint(end), y / 2.0, tilt, end, 0.0]
    }

    /// Kinetic energy at unit speed of the crank: half the effective inertia.
    pub fn half_inertia(&self, angle: f64) -> f64 {
        // Closed form: velocities of all bodies from the geometry.
        let (sin, cos) = angle.sin_cos();
        let tilt_sin = -self.crank * sin / self.rod;
        let tilt_cos = (1.0 - tilt_sin * tilt_sin).sqrt();
        let tilt_rate = -self.crank * cos / (self.rod * tilt_cos);
        let (vx, vy) = (-self.crank * sin, self.crank * cos);
        let slider = vx - self.rod * tilt_sin * tilt_rate;
        let [a, b, c] = self.mass;
        let crank = a * self.crank * self.crank / 3.0;
        let centre = vx.midpoint(slider).powi(2) + (vy / 2.0).powi(2);
        let rod = b * (centre + self.rod * self.rod / 12.0 * tilt_rate * tilt_rate);
        0.5 * (crank + rod + c * slider * slider)
    }
}

impl Dae for SliderCrank {
    fn positions(&self) -> usize {
        8
    }
    fn velocities(&self) -> usize {
        8
    }
    fn constraints(&self) -> usize {
        7
    }
    fn pattern(&self) -> Pattern {
        let pairs = [(0, 3), (1, 4), (0, 4), (2, 5), (1, 5), (2, 6)];
        let pairs = pairs.into_iter().flat_map(|(a, b)| [(a, b), (b, a)]).collect();
        Pattern { sizes: vec![3, 3, 2, 2, 2, 2, 1], velocity_blocks: 3, pairs }
    }
    fn scales(&self) -> Scales {
        Scales { increments: vec![1.0; 8] }
    }
    fn retract(&self, q: &[f64], increment: &[f64], out: &mut [f64]) {
        for i in 0..8 {
            out[i] = q[i] + increment[i];
        }
    }
    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]) {
        for i in 0..8 {
            out[i] = q1[i] - q0[i];
        }
    }
    fn residual(
        &mut self,
        _: f64,
        q: &[f64],
        _: &[f64],
        a: &[f64],
        l: &[f64],
        r: &mut [f64],
    ) -> Result<(), Evaluation> {
        for (i, inertia) in self.inertia().into_iter().enumerate() {
            r[i] = inertia * a[i];
        }
        for (k, (point, other)) in self.pins().into_iter().enumerate() {
            let f = [l[2 * k], l[2 * k + 1]];
            for (p, sign) in [(Some(point), 1.0), (other, -1.0)] {
                let Some(p) = p else { continue };
                r[p.first()] += sign * f[0];
                r[p.first() + 1] += sign * f[1];
                if p.arm.is_some() {
                    let d = p.turned(q);
                    r[p.first() + 2] += sign * (f[0] * d[0] + f[1] * d[1]);
                }
            }
        }
        r[7] += l[6];
        Ok(())
    }
    fn constraint_residual(&mut self, _: f64, q: &[f64], phi: &mut [f64]) -> Result<(), Evaluation> {
        for (k, (point, other)) in self.pins().into_iter().enumerate() {
            let (p, o) = (point.at(q), other.map_or([0.0; 2], |other| other.at(q)));
            phi[2 * k] = p[0] - o[0];
            phi[2 * k + 1] = p[1] - o[1];
        }
        phi[6] = q[7];
        Ok(())
    }
    fn constraint_velocity(&mut self, _: f64, _: &[f64], phi_t: &mut [f64]) -> Result<(), Evaluation> {
        phi_t.fill(0.0);
        Ok(())
    }
    fn constraint_acceleration(&mut self, _: f64, q: &[f64], v: &[f64], gamma: &mut [f64]) -> Result<(), Evaluation> {
        gamma.fill(0.0);
        for (k, (point, other)) in self.pins().into_iter().enumerate() {
            for (p, sign) in [(Some(point), 1.0), (other, -1.0)] {
                let Some(p) = p.filter(|p| p.arm.is_some()) else { continue };
                let (arm, w) = (p.arm(q), v[p.first() + 2]);
                gamma[2 * k] -= sign * arm[0] * w * w;
                gamma[2 * k + 1] -= sign * arm[1] * w * w;
            }
        }
        Ok(())
    }
    fn jacobian(&mut self, at: JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) -> Result<(), Evaluation> {
        let m = self.inertia().map(|m| m * at.mass);
        add(0, 0, &[m[0], 0.0, 0.0, 0.0, m[1], 0.0, 0.0, 0.0, m[2]]);
        add(1, 1, &[m[3], 0.0, 0.0, 0.0, m[4], 0.0, 0.0, 0.0, m[5]]);
        add(2, 2, &[m[6], 0.0, 0.0, m[7]]);
        for (k, (point, other)) in self.pins().into_iter().enumerate() {
            let f = [at.lambda[2 * k], at.lambda[2 * k + 1]];
            for (p, sign) in [(Some(point), 1.0), (other, -1.0)] {
                let Some(p) = p else { continue };
                if p.arm.is_some() {
                    let (d, arm) = (p.turned(at.q), p.arm(at.q));
                    let bent = -sign * at.stiffness * (f[0] * arm[0] + f[1] * arm[1]);
                    add(p.block, p.block, &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, bent]);
                    add(3 + k, p.block, &[sign, 0.0, 0.0, sign, sign * d[0], sign * d[1]]);
                    add(p.block, 3 + k, &[sign, 0.0, sign * d[0], 0.0, sign, sign * d[1]]);
                } else {
                    add(3 + k, p.block, &[sign, 0.0, 0.0, sign]);
                    add(p.block, 3 + k, &[sign, 0.0, 0.0, sign]);
                }
            }
        }
        add(6, 2, &[0.0, 1.0]);
        add(2, 6, &[0.0, 1.0]);
        Ok(())
    }
    fn describe(&self, unknown: usize) -> String {
        format!("unknown {unknown}")
    }
}

mod tests {
    use super::*;
    use crate::problems::Recorder;
    use crate::redundancy;
    use crate::{IntegratorOptions, Method, Statistics, SystemState, initial, integrate, output_times};

    fn mechanism() -> SliderCrank {
        SliderCrank { crank: 0.1, rod: 0.25, mass: [1.0, 0.8, 0.5] }
    }

    fn turned(method: Method, error: f64) -> (Vec<SystemState>, Statistics) {
        let mut problem = mechanism();
        let mut state = SystemState::at_rest(&problem, 0.0, problem.placed(0.4));
        state.v[2] = 20.0;
        // The crank's speed is meant; everything else follows.
        let mut weights = vec![1e-6; 8];
        weights[2] = 1.0;
        initial::velocities(&mut problem, &mut state, &weights).unwrap();
        assert!((state.v[2] - 20.0).abs() < 1e-3);
        let mut recorder = Recorder::default();
        let options = IntegratorOptions { method, error, ..Default::default() };
        let statistics =
            integrate(&mut problem, &mut state, 1.0, &output_times(0.0, 1.0, 100), &options, &mut recorder).unwrap();
        (recorder.states, statistics)
    }

    /// Truth: without loads the kinetic energy stays, so the crank's speed follows from its angle:
    /// w = w0 sqrt(I(a0) / I(a)). Three turns at 20 rad/s; the error of second order as for the
    /// pendulum.
    #[test]
    fn the_crank_speed_follows_from_the_energy() {
        for method in [Method::GeneralisedAlpha { rho: 0.8 }, Method::Hht { alpha: -0.1 }] {
            let problem = mechanism();
            let (states, _) = turned(method, 1e-7);
            let energy = problem.half_inertia(0.4) * 20.0 * 20.0;
            for s in &states {
                let expected = (energy / problem.half_inertia(s.q[2])).sqrt();
                assert!((s.v[2] / expected - 1.0).abs() < 2e-3, "{method:?} {}: {} {expected}", s.t, s.v[2]);
                // All levels of the constraints hold at outputs.
                let placed = problem.placed(s.q[2]);
                assert!((s.q[6] - placed[6]).abs() < 1e-8);
                assert!(s.v[7].abs() < 1e-9 && s.a[7].abs() < 1e-7, "{:?}", s.v[7]);
            }
        }
    }

    /// Truth: a plane mechanism of one freedom has no redundant equation in its plane.
    #[test]
    fn no_equation_is_redundant() {
        let mut problem = mechanism();
        let state = SystemState::at_rest(&problem, 0.0, problem.placed(0.4));
        let jacobian = redundancy::jacobian(&mut problem, &state).unwrap();
        assert!(redundancy::find(&jacobian, &[0.0; 7], redundancy::TOLERANCE).is_empty());
    }

    /// Memory of the work: guards against a corrector that silently does more.
    #[test]
    fn the_work_does_not_grow() {
        let (_, work) = turned(Method::default(), 1e-5);
        println!("{work:?}");
        assert!(work.iterations < 5 * (work.steps + work.rejected), "{work:?}");
        assert!(work.steps < 3000, "{work:?}");
    }
}
