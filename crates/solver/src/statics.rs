//! Static equilibrium: positions and multipliers with `r(q, v = 0, a = 0, lambda) = 0`, `Phi = 0`.
//!
//! Three ways, each tried when the one before has failed:
//!
//! 1. Newton's method with limited steps. Corrections decide, not the residual: that is no measure
//!    where a rod is a million times stiffer in tension than in bending.
//! 2. Loading: the load that would hold the structure where it begins is known (it is the residual
//!    there) and taken away step by step, each step starting in the direction of the last.
//! 3. Relaxation: implicit Euler steps `M (q - q_old) / tau + r = 0`, which descend the potential
//!    energy for any `tau`, with `tau` growing until it does not matter. Mechanisms that must swing
//!    to their equilibrium end here.

use crate::initial::{self, largest};
use crate::linear::{FactorKind, NewtonMatrix};
use crate::state::Norm;
use crate::{Control, Dae, Evaluation, Failure, JacobianPoint, Observer, Progress, Reason, Statistics, SystemState};

/// Corrections, in model length units and radians, that may be rounding.
const TINY: f64 = 1e-7;
/// Corrections in the same units, and forces in N, that may be left where no more can be reached.
const ENOUGH: f64 = 1e-4;

/// How to look for the equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct StaticOptions {
    /// Corrections below this, in model length units and radians, count as none.
    pub error: f64,
    /// Largest force or torque left over, N and N m.
    pub imbalance: f64,
    /// Iterations of Newton's method before the loads are applied step by step.
    pub maxit: usize,
    /// Iterations with loads step by step before the relaxation begins; 0 to do without.
    pub loading: usize,
    /// Iterations of the relaxation; 0 to do without.
    pub relaxation: usize,
    /// Part of mass and damping matrices added to the matrix, not to the balance, so that
    /// directions without stiffness are determined.
    pub stability: f64,
    /// Largest step of an iteration, m and rad (see [`Dae::is_rotation`]).
    pub tlimit: f64,
    pub alimit: f64,
}

impl Default for StaticOptions {
    fn default() -> Self {
        Self {
            error: 1e-4,
            imbalance: 1e-4,
            maxit: 50,
            loading: 500,
            relaxation: 1000,
            stability: 1e-5,
            tlimit: 1e20,
            alimit: std::f64::consts::PI / 18.0,
        }
    }
}

/// How the equilibrium was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StaticMethod {
    Newton,
    /// By loads applied step by step.
    Loading,
    Relaxation,
}

/// The equilibrium found.
#[derive(Clone, Debug, PartialEq)]
pub struct StaticReport {
    pub iterations: usize,
    /// Largest force or torque left over, N and N m, and where.
    pub imbalance: f64,
    pub imbalance_at: Option<String>,
    pub method: StaticMethod,
    pub statistics: Statistics,
}

/// Finds the equilibrium near `state.q`. The observer sees the progress; the result is the state.
///
/// Velocities and accelerations of the state become zero. A failure leaves the state as it was; an
/// observer's stop leaves the last iterate and sets `statistics.stopped`.
pub fn equilibrium(
    dae: &mut dyn Dae,
    state: &mut SystemState,
    options: &StaticOptions,
    observer: &mut dyn Observer,
) -> Result<StaticReport, Failure> {
    let positive = |x: f64| x > 0.0;
    let checks = [
        (positive(options.error), "ERROR must be greater than zero"),
        (positive(options.imbalance), "IMBALANCE must be greater than zero"),
        (options.stability >= 0.0, "STABILITY must not be negative"),
        (positive(options.tlimit), "TLIMIT must be greater than zero"),
        (positive(options.alimit), "ALIMIT must be greater than zero"),
    ];
    if let Some((_, text)) = checks.into_iter().find(|(fine, _)| !fine) {
        return Err(Failure::new(Reason::Option(text), state.t));
    }
    let mut search = Search::new(dae, state, options);
    let mut method = StaticMethod::Newton;
    let mut outcome = search.newton(dae, Goal::Balance, options.maxit, observer);
    if matches!(outcome, Outcome::Failed(_)) && options.loading > 0 {
        method = StaticMethod::Loading;
        search.restart(state);
        outcome = search.load(dae, observer);
    }
    if matches!(outcome, Outcome::Failed(_)) && options.relaxation > 0 {
        method = StaticMethod::Relaxation;
        search.restart(state);
        outcome = search.relax(dae, observer);
    }
    match outcome {
        Outcome::Failed(reason) => return Err(search.failure(dae, reason)),
        Outcome::Stopped => search.statistics.stopped = true,
        Outcome::Converged => {}
    }
    state.clone_from(&search.state);
    state.v.fill(0.0);
    state.a.fill(0.0);
    let n = state.v.len();
    search.residual(dae, Goal::Balance).map_err(Failure::evaluation(state.t))?;
    let (worst, imbalance) = largest(&search.right[..n]);
    search.statistics.general = search.matrix.kind() == FactorKind::General;
    Ok(StaticReport {
        iterations: search.statistics.iterations,
        imbalance,
        imbalance_at: (imbalance > 0.0).then(|| dae.describe(worst)),
        method,
        statistics: search.statistics,
    })
}

/// What is being solved for.
#[derive(Clone, Copy)]
enum Goal {
    /// Equilibrium.
    Balance,
    /// Equilibrium with a share of the load that would hold the structure where it began.
    Held(f64),
    /// A step of the relaxation, with its pseudo-time squared.
    Relaxed(f64),
}

enum Outcome {
    Converged,
    Failed(Reason),
    Stopped,
}

struct Search<'a> {
    options: &'a StaticOptions,
    state: SystemState,
    trial: SystemState,
    /// Where the relaxation step began.
    anchor: Vec<f64>,
    matrix: NewtonMatrix,
    norm: Norm,
    limits: Vec<f64>,
    /// Residual, sign reversed.
    right: Vec<f64>,
    /// The same where the search began.
    held: Vec<f64>,
    /// Reactions where the search began.
    reactions: Vec<f64>,
    /// Size of corrections that end the intermediate problems of a continuation.
    loose: f64,
    dx: Vec<f64>,
    increment: Vec<f64>,
    statistics: Statistics,
}

impl<'a> Search<'a> {
    fn new(dae: &mut dyn Dae, state: &SystemState, options: &'a StaticOptions) -> Self {
        let (n, m) = (dae.velocities(), dae.constraints());
        let mut start = state.clone();
        start.fit(dae);
        start.v.fill(0.0);
        start.a.fill(0.0);
        // Reactions carry geometric stiffness, so a good guess of them matters: those at rest.
        let mut guess = start.clone();
        if m > 0 && initial::accelerations(dae, &mut guess).is_ok() {
            start.lambda.clone_from(&guess.lambda);
        }
        let limits = (0..n).map(|i| if dae.is_rotation(i) { options.alimit } else { options.tlimit }).collect();
        Self {
            options,
            trial: start.clone(),
            anchor: start.q.clone(),
            matrix: NewtonMatrix::new(&dae.pattern()),
            norm: Norm::of_units(dae, options.error),
            limits,
            right: vec![0.0; n + m],
            held: vec![0.0; n + m],
            reactions: start.lambda.clone(),
            loose: (1e-3 / options.error).max(1.0),
            dx: vec![0.0; n + m],
            increment: vec![0.0; n],
            statistics: Statistics::default(),
            state: start,
        }
    }

    fn restart(&mut self, state: &SystemState) {
        self.state.q.clone_from(&state.q);
        self.state.a.fill(0.0);
        self.state.lambda.clone_from(&self.reactions);
    }

    fn failure(&mut self, dae: &mut dyn Dae, reason: Reason) -> Failure {
        let n = self.state.v.len();
        let failure = Failure::new(reason, self.state.t);
        self.state.a.fill(0.0);
        if self.residual(dae, Goal::Balance).is_err() {
            return failure;
        }
        let (worst, size) = largest(&self.right[..n]);
        failure.at(dae, worst, size)
    }

    /// Fills `right` with the negative residual of `state`.
    fn residual(&mut self, dae: &mut dyn Dae, goal: Goal) -> Result<(), Evaluation> {
        let n = self.state.v.len();
        self.statistics.residuals += 1;
        if let Goal::Relaxed(tau) = goal {
            dae.difference(&self.anchor, &self.state.q, &mut self.state.a);
            self.state.a.iter_mut().for_each(|a| *a /= tau);
        }
        let SystemState { t, q, v, a, lambda } = &self.state;
        dae.residual(*t, q, v, a, lambda, &mut self.right[..n])?;
        dae.constraint_residual(*t, q, &mut self.right[n..])?;
        self.right.iter_mut().for_each(|r| *r = -*r);
        if let Goal::Held(share) = goal {
            for (ri, hi) in self.right.iter_mut().zip(&self.held) {
                *ri -= share * hi;
            }
        }
        Ok(())
    }

    /// Moves from `trial` (the last accepted iterate) by `factor * dx`.
    fn go(&mut self, dae: &dyn Dae, factor: f64) {
        let n = self.state.v.len();
        for i in 0..n {
            self.increment[i] = factor * self.dx[i];
        }
        dae.retract(&self.trial.q, &self.increment, &mut self.state.q);
        for (i, li) in self.state.lambda.iter_mut().enumerate() {
            *li = self.trial.lambda[i] + factor * self.dx[n + i];
        }
    }

    fn factor(&mut self, dae: &mut dyn Dae, goal: Goal) -> Result<(), Reason> {
        let (mass, damping) = match goal {
            Goal::Balance | Goal::Held(_) => (self.options.stability, self.options.stability),
            Goal::Relaxed(tau) => (1.0 / tau, 0.0),
        };
        let SystemState { t, q, v, a, lambda } = &self.state;
        let at = JacobianPoint { t: *t, q, v, a, lambda, mass, damping, stiffness: 1.0 };
        self.statistics.jacobians += 1;
        self.statistics.factorisations += 1;
        self.matrix.suspect();
        self.matrix.assemble(dae, at).map_err(Reason::Evaluation)?;
        self.matrix.factor().map_err(|_| Reason::Singular)
    }

    /// Newton's method from `state`, with limited steps.
    ///
    /// Corrections may grow at first: a bar that bends is stretched by the first step and set right
    /// by the next. So they are only given a number of iterations to become small.
    fn newton(&mut self, dae: &mut dyn Dae, goal: Goal, iterations: usize, observer: &mut dyn Observer) -> Outcome {
        let n = self.state.v.len();
        let mut last = f64::INFINITY;
        if let Err(evaluation) = self.residual(dae, goal) {
            return Outcome::Failed(Reason::Evaluation(evaluation));
        }
        for _ in 0..iterations {
            self.statistics.iterations += 1;
            if let Err(reason) = self.factor(dae, goal) {
                return Outcome::Failed(reason);
            }
            self.dx.copy_from_slice(&self.right);
            self.matrix.solve_refined(&mut self.dx);
            let size = self.norm.of(&self.dx[..n]);
            if !size.is_finite() {
                return Outcome::Failed(Reason::NoConvergence);
            }
            let mut factor = self.dx.iter().zip(&self.limits).map(|(x, limit)| limit / x.abs()).fold(1.0, f64::min);
            self.trial.q.clone_from(&self.state.q);
            self.trial.lambda.clone_from(&self.state.lambda);
            // Where the equations cannot be evaluated a shorter step may do.
            let mut trouble = None;
            for _ in 0..8 {
                self.go(dae, factor);
                trouble = self.residual(dae, goal).err();
                if trouble.is_none() {
                    break;
                }
                factor *= 0.25;
            }
            if let Some(evaluation) = trouble {
                return Outcome::Failed(Reason::Evaluation(evaluation));
            }
            let progress = Progress { t: self.state.t, end: self.state.t, step: 0.0, statistics: self.statistics };
            if observer.progress(&progress) == Control::Stop {
                return Outcome::Stopped;
            }
            // On the way corrections need to be small only as seen from the next step.
            let limit = if matches!(goal, Goal::Balance) { 1.0 } else { self.loose };
            // Rounding of stiff structures can keep the balance above its limit, and the corrections
            // above theirs if that is very small: stop when they do not shrink any more.
            let (imbalance, moved) = (largest(&self.right[..n]).1, size * self.options.error);
            let small = moved <= TINY || (moved <= ENOUGH && imbalance <= ENOUGH);
            let stuck = (size <= 1e-3 || small) && size >= 0.5 * last;
            if factor >= 1.0 && (size <= limit || stuck) {
                let balanced = imbalance <= self.options.imbalance;
                if balanced || stuck || !matches!(goal, Goal::Balance) {
                    self.statistics.steps += 1;
                    return Outcome::Converged;
                }
            }
            last = size;
        }
        Outcome::Failed(Reason::NoConvergence)
    }

    /// Takes away, piece by piece, the load that would hold the structure where it begins.
    fn load(&mut self, dae: &mut dyn Dae, observer: &mut dyn Observer) -> Outcome {
        let n = self.state.v.len();
        if let Err(evaluation) = self.residual(dae, Goal::Balance) {
            return Outcome::Failed(Reason::Evaluation(evaluation));
        }
        self.held.copy_from_slice(&self.right);
        let stop = self.statistics.iterations + self.options.loading;
        let (mut share, mut step): (f64, f64) = (0.0, 0.1);
        let (mut before, mut last_step) = (self.state.clone(), 0.0);
        let mut moved = vec![0.0; n];
        let mut reason = Reason::NoConvergence;
        while self.statistics.iterations < stop && step > 1e-5 {
            let kept = self.state.clone();
            // Go on the way it went.
            if last_step > 0.0 {
                let ratio = step / last_step;
                dae.difference(&before.q, &kept.q, &mut moved);
                for d in &mut moved {
                    *d *= ratio;
                }
                dae.retract(&kept.q, &moved, &mut self.state.q);
                for (i, li) in self.state.lambda.iter_mut().enumerate() {
                    *li += ratio * (kept.lambda[i] - before.lambda[i]);
                }
            }
            let next = (share + step).min(1.0);
            let goal = if next >= 1.0 { Goal::Balance } else { Goal::Held(1.0 - next) };
            let start = self.statistics.iterations;
            match self.newton(dae, goal, 12, observer) {
                Outcome::Converged if next >= 1.0 => return Outcome::Converged,
                Outcome::Converged => {
                    let needed = self.statistics.iterations - start;
                    (before, last_step) = (kept, next - share);
                    share = next;
                    step *= match needed {
                        0..=4 => 2.0,
                        5..=8 => 1.3,
                        _ => 0.7,
                    };
                    step = step.min(1.0 - share);
                }
                Outcome::Failed(failed) => {
                    reason = failed;
                    self.state = kept;
                    step *= 0.25;
                }
                Outcome::Stopped => return Outcome::Stopped,
            }
        }
        Outcome::Failed(reason)
    }

    /// Implicit Euler steps of growing size, then Newton's method.
    fn relax(&mut self, dae: &mut dyn Dae, observer: &mut dyn Observer) -> Outcome {
        let n = self.state.v.len();
        let stop = self.statistics.iterations + self.options.relaxation;
        // Square of a pseudo-time: bodies fall some millimetres in the first step.
        let mut tau: f64 = 1e-3;
        let mut reason = Reason::NoConvergence;
        let mut moved = vec![0.0; n];
        while self.statistics.iterations < stop {
            self.anchor.clone_from(&self.state.q);
            let reactions = self.state.lambda.clone();
            let before = self.statistics.iterations;
            match self.newton(dae, Goal::Relaxed(tau), 12, observer) {
                Outcome::Stopped => return Outcome::Stopped,
                Outcome::Failed(failed) => {
                    reason = failed;
                    self.state.q.clone_from(&self.anchor);
                    self.state.lambda.clone_from(&reactions);
                    tau *= 0.1;
                    if tau < 1e-18 {
                        break;
                    }
                    continue;
                }
                Outcome::Converged => {}
            }
            dae.difference(&self.anchor, &self.state.q, &mut moved);
            // Few iterations: the next step may be bolder.
            let needed = self.statistics.iterations - before;
            tau *= if needed <= 3 {
                10.0
            } else if needed <= 6 {
                3.0
            } else {
                1.0
            };
            // Slow enough for Newton to try: the force that moved it is a small part.
            if self.norm.of(&moved) < 1e3 || tau > 1e3 {
                let kept = self.state.clone();
                self.state.a.fill(0.0);
                match self.newton(dae, Goal::Balance, 12, observer) {
                    Outcome::Failed(failed) => {
                        reason = failed;
                        self.state = kept;
                        if tau > 1e12 {
                            break;
                        }
                    }
                    other => return other,
                }
            }
        }
        Outcome::Failed(reason)
    }
}
