//! Masses on a line with springs and dampers: linear, with closed forms.

use crate::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

/// Masses `0..n` in a row; spring `i` joins mass `i` to the one before it, the first to ground.
#[derive(Clone, Debug)]
pub struct SpringChain {
    pub mass: Vec<f64>,
    pub stiffness: Vec<f64>,
    pub damping: Vec<f64>,
    /// Constant load on each mass.
    pub load: Vec<f64>,
}

impl SpringChain {
    pub fn uniform(n: usize, mass: f64, stiffness: f64, damping: f64) -> Self {
        Self { mass: vec![mass; n], stiffness: vec![stiffness; n], damping: vec![damping; n], load: vec![0.0; n] }
    }
}

impl Dae for SpringChain {
    fn positions(&self) -> usize {
        self.mass.len()
    }
    fn velocities(&self) -> usize {
        self.mass.len()
    }
    fn constraints(&self) -> usize {
        0
    }
    fn pattern(&self) -> Pattern {
        let n = self.mass.len();
        let pairs = (1..n).flat_map(|i| [(i - 1, i), (i, i - 1)]).collect();
        Pattern { sizes: vec![1; n], velocity_blocks: n, pairs }
    }
    fn scales(&self) -> Scales {
        Scales { increments: vec![1.0; self.mass.len()] }
    }
    fn retract(&self, q: &[f64], increment: &[f64], out: &mut [f64]) {
        for i in 0..q.len() {
            out[i] = q[i] + increment[i];
        }
    }
    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]) {
        for i in 0..q0.len() {
            out[i] = q1[i] - q0[i];
        }
    }
    fn residual(
        &mut self,
        _t: f64,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        _: &[f64],
        r: &mut [f64],
    ) -> Result<(), Evaluation> {
        for i in 0..q.len() {
            r[i] = self.mass[i] * a[i] - self.load[i];
        }
        for i in 0..q.len() {
            let (q0, v0) = if i == 0 { (0.0, 0.0) } else { (q[i - 1], v[i - 1]) };
            let force = self.stiffness[i] * (q[i] - q0) + self.damping[i] * (v[i] - v0);
            r[i] += force;
            if i > 0 {
                r[i - 1] -= force;
            }
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
        for i in 0..self.mass.len() {
            let k = at.stiffness * self.stiffness[i] + at.damping * self.damping[i];
            add(i, i, &[at.mass * self.mass[i] + k]);
            if i > 0 {
                add(i - 1, i - 1, &[k]);
                add(i, i - 1, &[-k]);
                add(i - 1, i, &[-k]);
            }
        }
        Ok(())
    }
    fn describe(&self, unknown: usize) -> String {
        format!("mass {unknown}")
    }
}

mod tests {
    use super::*;
    use crate::problems::Recorder;
    use crate::{IntegratorOptions, Method, SystemState, integrate, output_times};

    const METHODS: [Method; 4] = [
        Method::Hht { alpha: -0.3 },
        Method::GeneralisedAlpha { rho: 0.8 },
        Method::GeneralisedAlpha { rho: 1.0 },
        Method::Newmark { beta: 0.25, gamma: 0.5 },
    ];

    /// x'' + 2 d w x' + w^2 x = 0, x(0) = 1, x'(0) = 0.
    fn damped(t: f64, w: f64, d: f64) -> f64 {
        let wd = w * (1.0 - d * d).sqrt();
        (-d * w * t).exp() * ((wd * t).cos() + d * w / wd * (wd * t).sin())
    }

    fn oscillator(w: f64, d: f64) -> SpringChain {
        SpringChain::uniform(1, 2.0, 2.0 * w * w, 4.0 * d * w)
    }

    fn largest_error(options: &IntegratorOptions, end: f64, steps: usize) -> f64 {
        let (w, d) = (3.0, 0.05);
        let mut problem = oscillator(w, d);
        let mut state = SystemState::at_rest(&problem, 0.0, vec![1.0]);
        let mut recorder = Recorder::default();
        integrate(&mut problem, &mut state, end, &output_times(0.0, end, steps), options, &mut recorder).unwrap();
        assert_eq!(recorder.states.len(), steps);
        recorder.states.iter().map(|s| (s.q[0] - damped(s.t, w, d)).abs()).fold(0.0, f64::max)
    }

    /// Truth: all members are of second order, so halving the step divides the error by four. The
    /// band allows for the third-order term at these steps.
    #[test]
    fn the_error_falls_with_the_square_of_the_step() {
        for method in METHODS {
            let error = |steps| {
                let options = IntegratorOptions { method, fixed: true, error: 1e-9, ..Default::default() };
                largest_error(&options, 4.0, steps)
            };
            let order = (error(800) / error(1600)).log2();
            assert!((order - 2.0).abs() < 0.08, "{method:?}: order {order}");
        }
    }

    /// Truth: `M a = Q` at outputs and in the state that a run leaves, to rounding, whatever the
    /// corrector left; there are no constraints here that would call for a projection.
    #[test]
    fn outputs_and_the_last_state_balance() {
        for interpolate in [false, true] {
            let mut chain = SpringChain::uniform(5, 0.5, 4e4, 2.0);
            let mut state = SystemState::at_rest(&chain, 0.0, vec![0.0, 0.1, 0.0, -0.2, 0.3]);
            let mut recorder = Recorder::default();
            let options = IntegratorOptions { error: 1e-4, corrector: 0.5, interpolate, ..Default::default() };
            let outputs = output_times(0.0, 0.5, 17);
            integrate(&mut chain, &mut state, 0.6, &outputs, &options, &mut recorder).unwrap();
            assert_eq!(state.t, 0.6);
            recorder.states.push(state);
            let mut r = vec![0.0; 5];
            for s in &recorder.states {
                chain.residual(s.t, &s.q, &s.v, &s.a, &[], &mut r).unwrap();
                // Spring forces are about 1e4 N.
                assert!(r.iter().all(|r| r.abs() < 1e-10), "{} s: {r:?}", s.t);
            }
        }
    }

    /// Truth: the closed form. An error of `e` in each step of a method of second order sums to a
    /// multiple of `e^(2/3)`; the amplitude is 1, the phase 15 rad, and 10 is generous for both.
    #[test]
    fn the_requested_error_is_honoured() {
        for method in METHODS {
            let mut previous = f64::INFINITY;
            for error in [1e-4, 1e-5, 1e-6, 1e-7] {
                let found = largest_error(&IntegratorOptions { method, error, ..Default::default() }, 5.0, 10);
                assert!(found < 10.0 * error.powf(2.0 / 3.0), "{method:?} {error}: {found}");
                assert!(found < 0.5 * previous, "{method:?} {error}: {found} after {previous}");
                previous = found;
            }
        }
    }

    /// Truth: interpolation is of third order, so it does not spoil the second-order states.
    #[test]
    fn outputs_between_steps_are_as_good_as_steps() {
        let options = IntegratorOptions { error: 1e-6, interpolate: true, hmax: Some(0.2), ..Default::default() };
        let found = largest_error(&options, 5.0, 500);
        assert!(found < 10.0 * 1e-6f64.powf(2.0 / 3.0), "{found}");
    }

    /// Truth: without damping and with rho = 1 the trapezoidal rule keeps the energy of a linear
    /// system to rounding; with HHT it falls.
    #[test]
    fn energy_is_kept_or_lost_as_the_method_says() {
        let energy_after = |method| {
            let mut problem = SpringChain::uniform(5, 1.0, 100.0, 0.0);
            let mut state = SystemState::at_rest(&problem, 0.0, vec![1.0, 0.0, 0.0, 0.0, -0.5]);
            let energy = |s: &SystemState| {
                (0..5)
                    .map(|i| {
                        let d = s.q[i] - if i == 0 { 0.0 } else { s.q[i - 1] };
                        0.5 * s.v[i] * s.v[i] + 50.0 * d * d
                    })
                    .sum::<f64>()
            };
            let start = energy(&state);
            // Constant steps: the rule keeps energy for these only.
            let options = IntegratorOptions { method, fixed: true, error: 1e-10, ..Default::default() };
            integrate(&mut problem, &mut state, 10.0, &output_times(0.0, 10.0, 1000), &options, &mut crate::Silent)
                .unwrap();
            energy(&state) / start - 1.0
        };
        let kept = energy_after(Method::Newmark { beta: 0.25, gamma: 0.5 });
        assert!(kept.abs() < 1e-9, "{kept}");
        let lost = energy_after(Method::Hht { alpha: -0.3 });
        assert!(lost < -1e-4 && lost > -0.9, "{lost}");
    }

    /// Truth: the slow mass follows 1 - cos as if the stiff spring were rigid; steps must follow
    /// the slow motion (period 6.3 s), not the fast one (6e-6 s).
    #[test]
    fn a_stiff_damped_pair_needs_few_steps() {
        let mut problem = SpringChain {
            mass: vec![0.5, 0.5],
            stiffness: vec![1.0, 1e12],
            damping: vec![0.0, 1e5],
            load: vec![0.0, 1.0],
        };
        let mut state = SystemState::at_rest(&problem, 0.0, vec![0.0, 0.0]);
        let options = IntegratorOptions { error: 1e-6, ..Default::default() };
        let statistics =
            integrate(&mut problem, &mut state, 6.0, &output_times(0.0, 6.0, 6), &options, &mut crate::Silent).unwrap();
        assert!((state.q[0] - (1.0 - 6.0f64.cos())).abs() < 1e-3, "{:?}", state.q);
        assert!(statistics.steps < 2000, "{statistics:?}");
    }

    #[test]
    fn an_observer_can_stop_a_run() {
        struct Stopper(usize);
        impl crate::Observer for Stopper {
            fn output(&mut self, _: &mut dyn Dae, _: &SystemState) -> crate::Control {
                self.0 += 1;
                if self.0 == 3 { crate::Control::Stop } else { crate::Control::Continue }
            }
        }
        let mut problem = oscillator(3.0, 0.0);
        let mut state = SystemState::at_rest(&problem, 0.0, vec![1.0]);
        let mut stopper = Stopper(0);
        let statistics = integrate(
            &mut problem,
            &mut state,
            1.0,
            &output_times(0.0, 1.0, 10),
            &IntegratorOptions::default(),
            &mut stopper,
        )
        .unwrap();
        assert!(statistics.stopped);
        assert_eq!(stopper.0, 3);
        assert!((state.t - 0.3).abs() < 1e-12);
    }
}
