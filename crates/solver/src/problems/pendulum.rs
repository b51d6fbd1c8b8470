//! A point mass on a rigid rod in a plane, in Cartesian coordinates with one constraint.

use crate::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

/// `Phi = (x^2 + y^2 - l^2) / 2`, gravity along -y.
#[derive(Clone, Debug)]
pub struct Pendulum {
    pub mass: f64,
    pub length: f64,
    pub gravity: f64,
    /// Units of the increments in m, as a model in mm would have.
    pub scale: f64,
}

impl Dae for Pendulum {
    fn positions(&self) -> usize {
        2
    }
    fn velocities(&self) -> usize {
        2
    }
    fn constraints(&self) -> usize {
        1
    }
    fn pattern(&self) -> Pattern {
        Pattern { sizes: vec![2, 1], velocity_blocks: 1, pairs: vec![(0, 1), (1, 0)] }
    }
    fn scales(&self) -> Scales {
        Scales { increments: vec![self.scale; 2] }
    }
    fn retract(&self, q: &[f64], increment: &[f64], out: &mut [f64]) {
        out[0] = q[0] + increment[0];
        out[1] = q[1] + increment[1];
    }
    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]) {
        out[0] = q1[0] - q0[0];
        out[1] = q1[1] - q0[1];
    }
    fn residual(
        &mut self,
        _t: f64,
        q: &[f64],
        _v: &[f64],
        a: &[f64],
        l: &[f64],
        r: &mut [f64],
    ) -> Result<(), Evaluation> {
        r[0] = self.mass * a[0] + q[0] * l[0];
        r[1] = self.mass * (a[1] + self.gravity) + q[1] * l[0];
        Ok(())
    }
    fn constraint_residual(&mut self, _t: f64, q: &[f64], phi: &mut [f64]) -> Result<(), Evaluation> {
        phi[0] = (q[0] * q[0] + q[1] * q[1] - self.length * self.length) / 2.0;
        Ok(())
    }
    fn constraint_velocity(&mut self, _t: f64, _q: &[f64], phi_t: &mut [f64]) -> Result<(), Evaluation> {
        phi_t[0] = 0.0;
        Ok(())
    }
    fn constraint_acceleration(&mut self, _t: f64, _q: &[f64], v: &[f64], gamma: &mut [f64]) -> Result<(), Evaluation> {
        gamma[0] = v[0] * v[0] + v[1] * v[1];
        Ok(())
    }
    fn jacobian(&mut self, at: JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) -> Result<(), Evaluation> {
        let d = at.mass * self.mass + at.stiffness * at.lambda[0];
        add(0, 0, &[d, 0.0, 0.0, d]);
        add(0, 1, &[at.q[0], at.q[1]]);
        add(1, 0, &[at.q[0], at.q[1]]);
        Ok(())
    }
    fn describe(&self, unknown: usize) -> String {
        ["x", "y", "rod"].get(unknown).map_or_else(String::new, |name| (*name).to_string())
    }
}

mod tests {
    use super::*;
    use crate::problems::Recorder;
    use crate::{IntegratorOptions, Method, StaticOptions, SystemState, equilibrium, initial, integrate, output_times};

    fn pendulum() -> Pendulum {
        Pendulum { mass: 3.0, length: 1.0, gravity: 9.80665, scale: 1.0 }
    }

    fn released(angle: f64) -> SystemState {
        SystemState::at_rest(&pendulum(), 0.0, vec![angle.sin(), -angle.cos()])
    }

    /// Truth: T = 4 K(sin 30 deg) sqrt(l/g) = 2.153242351783843 s for a release at 60 degrees;
    /// after five periods the mass is back at rest. Error of the period to second order at an
    /// error of 1e-8 per step.
    #[test]
    fn the_period_is_that_of_the_elliptic_integral() {
        let period = 2.153_242_351_783_843;
        for method in [Method::Hht { alpha: -0.05 }, Method::GeneralisedAlpha { rho: 0.9 }] {
            let mut state = released(60f64.to_radians());
            let options = IntegratorOptions { method, error: 1e-8, ..Default::default() };
            let end = 5.0 * period;
            integrate(&mut pendulum(), &mut state, end, &output_times(0.0, end, 50), &options, &mut crate::Silent)
                .unwrap();
            let speed = state.v[0].hypot(state.v[1]);
            // Speed is acceleration times the phase error: 8.5 m/s^2 times 1e-4 s.
            assert!(speed < 1e-3, "{method:?}: {speed}");
        }
    }

    /// Truth: energy, the rod's force m (g cos + v^2 / l) and the constraints at all levels.
    #[test]
    fn outputs_satisfy_all_constraints_and_the_rod_force_is_right() {
        let mut state = released(90f64.to_radians());
        let mut recorder = Recorder::default();
        let options = IntegratorOptions { error: 1e-7, ..Default::default() };
        integrate(&mut pendulum(), &mut state, 2.1, &output_times(0.0, 2.0, 40), &options, &mut recorder).unwrap();
        // The state that is left counts as an output.
        recorder.states.push(state);
        for s in &recorder.states {
            let (q, v, a) = (&s.q, &s.v, &s.a);
            assert!((q[0].hypot(q[1]) - 1.0).abs() < 1e-8);
            assert!((q[0] * v[0] + q[1] * v[1]).abs() < 1e-8, "{}", q[0] * v[0] + q[1] * v[1]);
            assert!((q[0] * a[0] + q[1] * a[1] + v[0] * v[0] + v[1] * v[1]).abs() < 1e-9);
            let speed2 = v[0] * v[0] + v[1] * v[1];
            // Energy: v^2 = -2 g y, to some e^(2/3) = 2e-5 of 20 m^2/s^2 for an error e per step.
            assert!((speed2 + 2.0 * 9.80665 * q[1]).abs() < 10.0 * 2e-5 * 20.0, "{}", speed2 + 2.0 * 9.80665 * q[1]);
            let force = 3.0 * (-9.80665 * q[1] + speed2);
            assert!((s.lambda[0] - force).abs() < 1e-7 * 100.0, "{} {force}", s.lambda[0]);
        }
    }

    /// Truth: all members are of second order, also with constraints.
    #[test]
    fn the_order_is_two_with_a_constraint() {
        for method in [Method::Hht { alpha: -0.3 }, Method::GeneralisedAlpha { rho: 0.8 }] {
            let end = |steps: usize| {
                let mut state = released(1.0);
                let options = IntegratorOptions { method, fixed: true, error: 1e-9, ..Default::default() };
                integrate(
                    &mut pendulum(),
                    &mut state,
                    1.0,
                    &output_times(0.0, 1.0, steps),
                    &options,
                    &mut crate::Silent,
                )
                .unwrap();
                state.q[0]
            };
            let (a, b, c) = (end(200), end(400), end(800));
            let order = ((a - b) / (b - c)).log2();
            // The first step starts from an acceleration that is not shifted yet: a third-order
            // trace of that remains at these steps.
            assert!((order - 2.0).abs() < 0.2, "{method:?}: {order}");
        }
    }

    /// Truth: the nearest point of the circle to (2, 0.1) lies on the ray to it, and the nearest
    /// velocity is the tangential part.
    #[test]
    fn assembly_goes_to_the_nearest_consistent_state() {
        let mut problem = pendulum();
        let mut state = SystemState::at_rest(&problem, 0.0, vec![2.0, 0.1]);
        state.v = vec![0.3, 1.0];
        initial::displacements(&mut problem, &mut state, &[]).unwrap();
        assert!((state.q[1] / state.q[0] - 0.05).abs() < 1e-9);
        assert!((state.q[0].hypot(state.q[1]) - 1.0).abs() < 1e-12);
        initial::velocities(&mut problem, &mut state, &[]).unwrap();
        let (x, y) = (state.q[0], state.q[1]);
        let tangential = -0.3 * y + x;
        assert!((state.v[0] + y * tangential).abs() < 1e-12 && (state.v[1] - x * tangential).abs() < 1e-12);
    }

    /// Truth: with y exact only x moves: x = sqrt(1 - y^2), to the ratio of the weights.
    #[test]
    fn exact_coordinates_stay() {
        let mut problem = pendulum();
        let mut state = SystemState::at_rest(&problem, 0.0, vec![1.2, 0.6]);
        initial::displacements(&mut problem, &mut state, &[1.0, initial::EXACT]).unwrap();
        assert!((state.q[1] - 0.6).abs() < 1e-9 && (state.q[0] - 0.8).abs() < 1e-9, "{:?}", state.q);
    }

    /// Truth: at rest the rod is vertical and carries m g; released below the pin, the mass hangs
    /// (above it there is a second, unstable equilibrium, which Newton's method may find). There is
    /// no stiffness along the path, and the speed is ignored.
    #[test]
    fn the_rod_is_vertical_in_equilibrium() {
        for angle in [0.0, 0.3, 1.0, 1.5, 1.6, 2.5, 3.1] {
            let mut problem = pendulum();
            let mut state = released(angle);
            state.v = vec![1.0, 2.0];
            let options = StaticOptions { error: 1e-8, imbalance: 1e-8, tlimit: 0.2, ..Default::default() };
            let report = equilibrium(&mut problem, &mut state, &options, &mut crate::Silent).unwrap();
            assert!(state.q[0].abs() < 1e-7, "{angle}: {state:?} {report:?}");
            assert!((state.lambda[0].abs() - 3.0 * 9.80665).abs() < 1e-6, "{angle}: {state:?}");
            if angle < 1.55 {
                assert!(state.q[1] < 0.0, "{angle}: {state:?} {report:?}");
            }
        }
    }

    #[test]
    fn impossible_constraints_are_reported_with_the_worst() {
        // A rod of imaginary length: no point satisfies it.
        struct Impossible(Pendulum);
        impl Dae for Impossible {
            fn positions(&self) -> usize {
                2
            }
            fn velocities(&self) -> usize {
                2
            }
            fn constraints(&self) -> usize {
                1
            }
            fn pattern(&self) -> Pattern {
                self.0.pattern()
            }
            fn scales(&self) -> Scales {
                self.0.scales()
            }
            fn retract(&self, q: &[f64], i: &[f64], out: &mut [f64]) {
                self.0.retract(q, i, out);
            }
            fn difference(&self, a: &[f64], b: &[f64], out: &mut [f64]) {
                self.0.difference(a, b, out);
            }
            fn residual(
                &mut self,
                t: f64,
                q: &[f64],
                v: &[f64],
                a: &[f64],
                l: &[f64],
                r: &mut [f64],
            ) -> Result<(), Evaluation> {
                self.0.residual(t, q, v, a, l, r)
            }
            fn constraint_residual(&mut self, _: f64, q: &[f64], phi: &mut [f64]) -> Result<(), Evaluation> {
                phi[0] = (q[0] * q[0] + q[1] * q[1] + 1.0) / 2.0;
                Ok(())
            }
            fn constraint_velocity(&mut self, t: f64, q: &[f64], p: &mut [f64]) -> Result<(), Evaluation> {
                self.0.constraint_velocity(t, q, p)
            }
            fn constraint_acceleration(
                &mut self,
                t: f64,
                q: &[f64],
                v: &[f64],
                g: &mut [f64],
            ) -> Result<(), Evaluation> {
                self.0.constraint_acceleration(t, q, v, g)
            }
            fn jacobian(
                &mut self,
                at: JacobianPoint<'_>,
                add: &mut dyn FnMut(usize, usize, &[f64]),
            ) -> Result<(), Evaluation> {
                self.0.jacobian(at, add)
            }
            fn describe(&self, unknown: usize) -> String {
                self.0.describe(unknown)
            }
        }
        let mut problem = Impossible(pendulum());
        let mut state = SystemState::at_rest(&problem, 0.0, vec![2.0, 0.1]);
        let failure = initial::displacements(&mut problem, &mut state, &[]).unwrap_err();
        assert_eq!(failure.unknown.as_deref(), Some("rod"));
        assert!(failure.to_string().contains("`rod`"), "{failure}");
    }
}
