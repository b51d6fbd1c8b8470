//! The generalised-alpha method: steps, corrector, acceptance, outputs.
//!
//! With `x` the correction of the acceleration at the end of a step, the corrector solves
//!
//! ```text
//! [ M + c C + k K   B^T ] [ x       ]     [ r     ]      k = h^2 beta (1 - af) / (1 - am)
//! [ B               0   ] [ dlambda ] = - [ Phi/k ]      c = h gamma (1 - af) / (1 - am)
//! ```
//!
//! so that neither the matrix nor its condition depends on a small step.

use crate::initial::Accelerations;
use crate::linear::{FactorKind, NewtonMatrix};
use crate::state::Norm;
use crate::{Control, Dae, Evaluation, Failure, JacobianPoint, Observer, Progress, Reason, Statistics, SystemState};

use super::dense_output::interpolate;
use super::step_size::StepSize;
use super::{Coefficients, IntegratorOptions};

/// Largest rate of contraction with which factors are kept for the next step.
const GOOD_RATE: f64 = 0.3;
/// Change of the step, as a ratio, that calls for new factors.
const STALE_STEP: f64 = 1.2;

/// Integrates from `state.t` to `end` and reports the states at the output times.
///
/// Initial accelerations and multipliers are found first. On return, also after a failure or a
/// stop, `state` is the last one reached, its accelerations and multipliers consistent. Outputs at or before the start are reported at once.
pub fn integrate(
    dae: &mut dyn Dae,
    state: &mut SystemState,
    end: f64,
    outputs: &[f64],
    options: &IntegratorOptions,
    observer: &mut dyn Observer,
) -> Result<Statistics, Failure> {
    let mut run = Run::new(dae, state, end, outputs, options)?;
    let mut result = run.advance(dae, end, outputs, options, observer);
    if run.reported.t != run.now.t {
        run.reported.clone_from(&run.now);
        let consistent = run.make_consistent(dae);
        if result.is_ok() {
            result = consistent;
        }
    }
    run.matrices_used();
    std::mem::swap(state, &mut run.reported);
    result.map(|()| run.statistics)
}

/// Everything a run needs; built once.
struct Run {
    coefficients: Coefficients,
    norm: Norm,
    matrix: NewtonMatrix,
    /// `[M B^T; B 0]` at accepted states, for projection and consistent accelerations.
    consistent: NewtonMatrix,
    accelerations: Accelerations,
    /// Last accepted state; `a` is the true acceleration.
    now: SystemState,
    /// The state tried.
    next: SystemState,
    /// The state last reported.
    reported: SystemState,
    /// The acceleration-like variable of the method at both ends of the step.
    algorithmic: Vec<f64>,
    algorithmic_next: Vec<f64>,
    /// Step after which `algorithmic` was left, s.
    last_step: f64,
    /// Step of the present factors; zero when there are none.
    factored_step: f64,
    rate: f64,
    x: Vec<f64>,
    increment: Vec<f64>,
    positions: Vec<f64>,
    phi_t: Vec<f64>,
    /// True when `consistent` holds the factors at `now`.
    projected: bool,
    statistics: Statistics,
    /// The entry of `x` that was off the most when the corrector or the error test failed.
    trouble: Option<(usize, f64)>,
}

enum Corrector {
    Converged,
    Diverged,
}

impl Run {
    fn new(
        dae: &mut dyn Dae,
        state: &mut SystemState,
        end: f64,
        outputs: &[f64],
        options: &IntegratorOptions,
    ) -> Result<Self, Failure> {
        let option = |text| Failure::new(Reason::Option(text), state.t);
        let coefficients = options.method.coefficients().map_err(option)?;
        if !(options.error > 0.0 && options.error.is_finite()) {
            return Err(option("ERROR must be greater than zero"));
        }
        if !(end.is_finite() && end >= state.t) {
            return Err(option("the end time must not lie before the present time"));
        }
        if outputs.iter().any(|t| !t.is_finite()) || outputs.windows(2).any(|pair| pair[1] < pair[0]) {
            return Err(option("the output times must increase"));
        }
        state.fit(dae);
        let pattern = dae.pattern();
        let mut consistent = NewtonMatrix::new(&dae.mass_pattern());
        let mut accelerations = Accelerations::default();
        accelerations.find(dae, state, &mut consistent)?;
        let (n, m) = (dae.velocities(), dae.constraints());
        Ok(Self {
            coefficients,
            norm: Norm::new(dae, options.error),
            matrix: NewtonMatrix::new(&pattern),
            consistent,
            accelerations,
            now: state.clone(),
            next: state.clone(),
            reported: state.clone(),
            algorithmic: state.a.clone(),
            algorithmic_next: state.a.clone(),
            last_step: 0.0,
            factored_step: 0.0,
            rate: 1.0,
            x: vec![0.0; n + m],
            increment: vec![0.0; n],
            positions: state.q.clone(),
            phi_t: vec![0.0; m],
            projected: false,
            statistics: Statistics::default(),
            trouble: None,
        })
    }

    fn matrices_used(&mut self) {
        self.statistics.general =
            self.matrix.kind() == FactorKind::General || self.consistent.kind() == FactorKind::General;
    }

    fn advance(
        &mut self,
        dae: &mut dyn Dae,
        end: f64,
        outputs: &[f64],
        options: &IntegratorOptions,
        observer: &mut dyn Observer,
    ) -> Result<(), Failure> {
        let span = end - self.now.t;
        let first_output = outputs.iter().copied().find(|&t| t > self.now.t).unwrap_or(end);
        let hmax = options.hmax.unwrap_or(first_output - self.now.t).min(span);
        let hinit = options.hinit.unwrap_or(hmax / 20.0);
        let hmin = options.hmin.unwrap_or(1e-7 * hmax);
        let mut size = StepSize::new(hinit, hmin, hmax, options.fixed);
        let close = 1e-10 * span.max(f64::MIN_POSITIVE);
        let mut pending = outputs;
        while let Some((&t, rest)) = pending.split_first() {
            if t > self.now.t + close {
                break;
            }
            pending = rest;
            if observer.output(dae, &self.now) == Control::Stop {
                self.statistics.stopped = true;
                return Ok(());
            }
        }
        let mut from = self.now.clone();
        while end - self.now.t > close {
            let target = match pending.first() {
                Some(&t) if !options.interpolate => t.min(end),
                _ => end,
            };
            if options.interpolate {
                from.clone_from(&self.now);
            }
            self.step(dae, target, &mut size, options)?;
            let mut stop = false;
            while let Some((&t, rest)) = pending.split_first() {
                if t > self.now.t + close {
                    break;
                }
                pending = rest;
                stop |= self.report(dae, &from, t, options, observer)? == Control::Stop;
                if stop {
                    break;
                }
            }
            let progress = Progress { t: self.now.t, end, step: self.last_step, statistics: self.statistics };
            stop |= observer.progress(&progress) == Control::Stop;
            if stop {
                self.statistics.stopped = true;
                break;
            }
        }
        Ok(())
    }

    /// Reports the state at an output time at or before the present one.
    fn report(
        &mut self,
        dae: &mut dyn Dae,
        from: &SystemState,
        t: f64,
        options: &IntegratorOptions,
        observer: &mut dyn Observer,
    ) -> Result<Control, Failure> {
        self.reported.clone_from(&self.now);
        if options.interpolate && t < self.now.t {
            interpolate(dae, from, &self.now, t, &mut self.reported);
        }
        self.make_consistent(dae)?;
        Ok(observer.output(dae, &self.reported))
    }

    /// Accelerations and multipliers of `reported` from the equations themselves: those of the
    /// method are as accurate as the corrector left them, and multipliers lag by part of a step.
    fn make_consistent(&mut self, dae: &mut dyn Dae) -> Result<(), Failure> {
        if self.projected && self.reported.t == self.now.t {
            // The projection of the velocities has just factored this matrix.
            return self.accelerations.solve(dae, &mut self.reported, &mut self.consistent);
        }
        self.projected = false;
        // Without constraints it is no more than the inverse of each part's inertia.
        self.statistics.factorisations += usize::from(dae.constraints() > 0);
        self.accelerations.find(dae, &mut self.reported, &mut self.consistent)
    }

    /// Takes one step towards `target`, as long as error and corrector allow.
    fn step(
        &mut self,
        dae: &mut dyn Dae,
        target: f64,
        size: &mut StepSize,
        options: &IntegratorOptions,
    ) -> Result<(), Failure> {
        let mut evaluation = None;
        loop {
            let remaining = target - self.now.t;
            let h = size.towards(remaining);
            self.next.t = if h >= remaining { target } else { self.now.t + h };
            match self.attempt(dae, h, options) {
                Ok(Corrector::Converged) => {
                    let theta = if options.fixed { 0.0 } else { self.error(h) };
                    if theta <= 1.0 {
                        if let Err(trouble) = self.accept(dae, h) {
                            return Err(self.fail(dae, trouble, h));
                        }
                        size.accepted(h, theta);
                        return Ok(());
                    }
                    self.statistics.rejected += 1;
                    if !size.rejected(h, theta) {
                        return Err(self.failure(dae, Reason::ErrorTest, h));
                    }
                }
                outcome => {
                    if let Err(Trouble::Evaluation(message)) = &outcome {
                        evaluation = Some(message.clone());
                    }
                    self.statistics.failures += 1;
                    self.factored_step = 0.0;
                    self.matrix.suspect();
                    if !size.failed(h) {
                        let reason = evaluation.map_or(Reason::NoConvergence, Reason::Evaluation);
                        return Err(match outcome {
                            Err(trouble) => self.fail(dae, trouble, h),
                            Ok(_) => self.failure(dae, reason, h),
                        });
                    }
                }
            }
        }
    }

    fn failure(&self, dae: &dyn Dae, reason: Reason, h: f64) -> Failure {
        let mut failure = Failure::new(reason, self.now.t);
        failure.step = h;
        match self.trouble {
            Some((unknown, size)) => failure.at(dae, unknown, size),
            None => failure,
        }
    }

    fn fail(&mut self, dae: &dyn Dae, trouble: Trouble, h: f64) -> Failure {
        let reason = match trouble {
            Trouble::Evaluation(evaluation) => Reason::Evaluation(evaluation),
            Trouble::Singular(unknown) => {
                self.trouble = Some((unknown, 0.0));
                Reason::Singular
            }
        };
        self.failure(dae, reason, h)
    }

    /// Predicts and corrects with step `h`, with new factors if the old ones do not do.
    fn attempt(&mut self, dae: &mut dyn Dae, h: f64, options: &IntegratorOptions) -> Result<Corrector, Trouble> {
        let stale = self.factored_step <= 0.0
            || self.rate > GOOD_RATE
            || h > STALE_STEP * self.factored_step
            || self.factored_step > STALE_STEP * h;
        if !stale {
            self.predict(dae, h);
            if let Corrector::Converged = self.correct(dae, h, options)? {
                return Ok(Corrector::Converged);
            }
        }
        self.predict(dae, h);
        self.factor(dae, h)?;
        self.correct(dae, h, options)
    }

    /// Starts the step with constant acceleration of the method.
    fn predict(&mut self, dae: &dyn Dae, h: f64) {
        let Coefficients { am, af, beta, gamma } = self.coefficients;
        // The variable of the method leads or lags the acceleration by a part of the step: when
        // the step changes, so does that distance.
        let ratio = if self.last_step > 0.0 { (h / self.last_step).min(2.0) } else { 1.0 };
        let now = &self.now;
        for i in 0..now.v.len() {
            let a = now.a[i] + (self.algorithmic[i] - now.a[i]) * ratio;
            self.algorithmic_next[i] = a;
            self.next.a[i] = (a - af * now.a[i]) / (1.0 - af);
            self.increment[i] = h * now.v[i] + h * h * ((0.5 - beta) * a + beta * a);
            self.next.v[i] = now.v[i] + h * ((1.0 - gamma) * a + gamma * a);
        }
        debug_assert!(am < 1.0 && af < 1.0);
        self.next.lambda.copy_from_slice(&now.lambda);
        dae.retract(&now.q, &self.increment, &mut self.next.q);
    }

    /// Factors of stiffness and damping in the matrix.
    fn factors(&self, h: f64) -> (f64, f64) {
        let Coefficients { am, af, beta, gamma } = self.coefficients;
        let common = (1.0 - af) / (1.0 - am);
        (h * h * beta * common, h * gamma * common)
    }

    fn factor(&mut self, dae: &mut dyn Dae, h: f64) -> Result<(), Trouble> {
        let (stiffness, damping) = self.factors(h);
        let SystemState { t, q, v, a, lambda } = &self.next;
        let at = JacobianPoint { t: *t, q, v, a, lambda, mass: 1.0, damping, stiffness };
        self.factored_step = 0.0;
        self.statistics.jacobians += 1;
        self.matrix.assemble(dae, at)?;
        self.statistics.factorisations += 1;
        self.matrix.factor().map_err(|singular| Trouble::Singular(singular.unknown))?;
        self.factored_step = h;
        self.rate = GOOD_RATE;
        Ok(())
    }

    fn correct(&mut self, dae: &mut dyn Dae, h: f64, options: &IntegratorOptions) -> Result<Corrector, Trouble> {
        let n = self.now.v.len();
        let (stiffness, damping) = self.factors(h);
        let Coefficients { am, af, .. } = self.coefficients;
        let to_algorithmic = (1.0 - af) / (1.0 - am);
        let mut last: f64 = 0.0;
        for iteration in 0..options.maxit.max(1) {
            self.statistics.residuals += 1;
            self.statistics.iterations += 1;
            let SystemState { t, q, v, a, lambda } = &self.next;
            dae.residual(*t, q, v, a, lambda, &mut self.x[..n])?;
            dae.constraint_residual(*t, q, &mut self.x[n..])?;
            self.x[..n].iter_mut().for_each(|r| *r = -*r);
            self.x[n..].iter_mut().for_each(|phi| *phi /= -stiffness);
            self.matrix.solve(&mut self.x);
            for i in 0..n {
                let x = self.x[i];
                self.increment[i] = stiffness * x;
                self.next.a[i] += x;
                self.next.v[i] += damping * x;
                self.algorithmic_next[i] += to_algorithmic * x;
            }
            for (li, xi) in self.next.lambda.iter_mut().zip(&self.x[n..]) {
                *li += xi;
            }
            dae.retract(&self.next.q, &self.increment, &mut self.positions);
            std::mem::swap(&mut self.next.q, &mut self.positions);
            let change = self.norm.of(&self.increment);
            let worst = self.norm.worst(&self.increment);
            self.trouble = Some((worst, self.increment[worst]));
            if !change.is_finite() {
                return Ok(Corrector::Diverged);
            }
            if iteration > 0 {
                self.rate = (change / last.max(f64::MIN_POSITIVE)).max(1e-3);
            }
            // A rate seen in an earlier step may be out of date: the first correction is judged by
            // the worst rate that keeps factors.
            let rate = if iteration == 0 { GOOD_RATE } else { self.rate };
            let left = change * rate / (1.0 - rate).max(1e-3);
            if left <= options.corrector || change < 1e-9 * options.corrector {
                self.rate = self.rate.min(1.0);
                return Ok(Corrector::Converged);
            }
            if self.rate >= 0.9 && iteration > 0 {
                return Ok(Corrector::Diverged);
            }
            last = change;
        }
        Ok(Corrector::Diverged)
    }

    /// Local error in tolerances, from the change of the method's acceleration.
    fn error(&mut self, h: f64) -> f64 {
        let Coefficients { am, af, beta, .. } = self.coefficients;
        let factor = h * h * (beta + (am - af) / 2.0 - 1.0 / 6.0);
        let ratio = if self.last_step > 0.0 { (h / self.last_step).min(2.0) } else { 1.0 };
        for i in 0..self.now.v.len() {
            let a = self.now.a[i] + (self.algorithmic[i] - self.now.a[i]) * ratio;
            self.increment[i] = factor * (self.algorithmic_next[i] - a);
        }
        let worst = self.norm.worst(&self.increment);
        self.trouble = Some((worst, self.increment[worst]));
        self.norm.of(&self.increment)
    }

    fn accept(&mut self, dae: &mut dyn Dae, h: f64) -> Result<(), Trouble> {
        std::mem::swap(&mut self.now, &mut self.next);
        std::mem::swap(&mut self.algorithmic, &mut self.algorithmic_next);
        self.last_step = h;
        self.statistics.steps += 1;
        self.trouble = None;
        if dae.constraints() > 0 {
            self.project(dae)?;
        }
        Ok(())
    }

    /// Removes the part of the velocities that violates `B v = -Phi_t`, with the least kinetic
    /// energy. The constraint directions must be those of now: with older ones the correction
    /// would also change the free motion, and the method would lose an order.
    fn project(&mut self, dae: &mut dyn Dae) -> Result<(), Trouble> {
        let n = self.now.v.len();
        let SystemState { t, q, v, a, lambda } = &self.now;
        let at = JacobianPoint { t: *t, q, v, a, lambda, mass: 1.0, damping: 0.0, stiffness: 0.0 };
        self.projected = false;
        self.consistent.assemble(dae, at)?;
        dae.constraint_velocity(*t, q, &mut self.phi_t)?;
        self.consistent.multiply_constraints(&self.now.v, &mut self.x[n..]);
        for (xi, phi_t) in self.x[n..].iter_mut().zip(&self.phi_t) {
            *xi = -(*xi + phi_t);
        }
        if self.x[n..].iter().all(|xi| *xi == 0.0) {
            return Ok(());
        }
        self.x[..n].fill(0.0);
        self.statistics.factorisations += 1;
        self.consistent.factor().map_err(|singular| Trouble::Singular(singular.unknown))?;
        self.projected = true;
        self.consistent.solve(&mut self.x);
        for (vi, xi) in self.now.v.iter_mut().zip(&self.x[..n]) {
            *vi += xi;
        }
        Ok(())
    }
}

/// Why a step could not even be tried.
enum Trouble {
    Evaluation(Evaluation),
    Singular(usize),
}

impl From<Evaluation> for Trouble {
    fn from(evaluation: Evaluation) -> Self {
        Self::Evaluation(evaluation)
    }
}
