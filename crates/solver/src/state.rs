//! What every analysis shares: the state, the observer, the counts, and how a run can fail.

use std::fmt;

use crate::{Dae, Evaluation, Scales};

/// Position, velocity, acceleration and multipliers at one time, SI.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct SystemState {
    pub t: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub a: Vec<f64>,
    pub lambda: Vec<f64>,
}

impl SystemState {
    /// At rest at the given positions, without accelerations and multipliers.
    pub fn at_rest(dae: &dyn Dae, t: f64, q: Vec<f64>) -> Self {
        let (n, m) = (dae.velocities(), dae.constraints());
        Self { t, q, v: vec![0.0; n], a: vec![0.0; n], lambda: vec![0.0; m] }
    }

    /// Gives accelerations and multipliers the sizes the problem has now: redundant constraints
    /// may have been taken out since.
    pub(crate) fn fit(&mut self, dae: &dyn Dae) {
        self.v.resize(dae.velocities(), 0.0);
        self.a.resize(dae.velocities(), 0.0);
        self.lambda.resize(dae.constraints(), 0.0);
    }
}

/// Whether an analysis goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    Continue,
    Stop,
}

/// Where a run stands, after each accepted step or iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    pub t: f64,
    pub end: f64,
    /// Size of the last step, s; zero in statics.
    pub step: f64,
    pub statistics: Statistics,
}

/// Receives results and may stop a run; everything delivered before stays valid.
pub trait Observer {
    /// A result at an output time: accelerations and multipliers are consistent.
    fn output(&mut self, dae: &mut dyn Dae, state: &SystemState) -> Control;

    fn progress(&mut self, progress: &Progress) -> Control {
        let _ = progress;
        Control::Continue
    }
}

/// An observer that wants nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Observer for Silent {
    fn output(&mut self, _dae: &mut dyn Dae, _state: &SystemState) -> Control {
        Control::Continue
    }
}

/// The work a run needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Statistics {
    /// Accepted steps (load or pseudo-time steps in statics).
    pub steps: usize,
    /// Steps repeated because the error was too large.
    pub rejected: usize,
    /// Steps repeated because Newton's method failed.
    pub failures: usize,
    pub residuals: usize,
    pub iterations: usize,
    pub jacobians: usize,
    pub factorisations: usize,
    /// True when the observer ended the run before its end.
    pub stopped: bool,
    /// True when the general factorisation had to replace that by blocks.
    pub general: bool,
}

/// Why an analysis could not go on.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// Newton's method does not converge at the smallest step.
    NoConvergence,
    /// The error test fails at the smallest step.
    ErrorTest,
    /// The matrix has no inverse.
    Singular,
    /// The equations cannot be evaluated.
    Evaluation(Evaluation),
    /// The constraints cannot be met.
    Constraints,
    /// An option is out of its range.
    Option(&'static str),
}

/// A failed analysis, with what a user needs to find the cause.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    pub reason: Reason,
    pub t: f64,
    /// Step size at the end, s; zero where there is none.
    pub step: f64,
    /// Description of the unknown with the largest correction or residual, by [`Dae::describe`].
    pub unknown: Option<String>,
    /// Size of that correction or residual, SI.
    pub size: f64,
}

impl Failure {
    pub(crate) fn new(reason: Reason, t: f64) -> Self {
        Self { reason, t, step: 0.0, unknown: None, size: 0.0 }
    }

    pub(crate) fn evaluation(t: f64) -> impl Fn(Evaluation) -> Self {
        move |evaluation| Self::new(Reason::Evaluation(evaluation), t)
    }

    pub(crate) fn at(mut self, dae: &dyn Dae, unknown: usize, size: f64) -> Self {
        self.unknown = Some(dae.describe(unknown));
        self.size = size;
        self
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let t = self.t;
        match &self.reason {
            Reason::NoConvergence => write!(f, "the iteration does not converge at t = {t:.6} s")?,
            Reason::ErrorTest => write!(f, "the error tolerance cannot be met at t = {t:.6} s")?,
            Reason::Singular => write!(f, "the equations have no unique solution at t = {t:.6} s")?,
            Reason::Evaluation(evaluation) => write!(f, "at t = {t:.6} s: {}", evaluation.message)?,
            Reason::Constraints => write!(f, "the constraints cannot be satisfied at t = {t:.6} s")?,
            Reason::Option(text) => write!(f, "{text}")?,
        }
        if self.step > 0.0 {
            write!(f, " with a step of {:.3e} s", self.step)?;
        }
        match (&self.unknown, &self.reason) {
            (Some(unknown), Reason::Singular) => write!(f, "; `{unknown}` is not determined"),
            (Some(unknown), _) => write!(f, "; `{unknown}` is off the most, by {:.3e}", self.size),
            _ => Ok(()),
        }
    }
}

impl std::error::Error for Failure {}

/// Weighted size of an increment: within each block the root mean square, then the largest of the
/// blocks, so that a part that moves is not hidden by a thousand that rest.
pub(crate) struct Norm {
    reciprocals: Vec<f64>,
    blocks: Vec<usize>,
}

impl Norm {
    /// An increment of `tolerance` times its scale has size one.
    pub fn new(dae: &dyn Dae, tolerance: f64) -> Self {
        Self::with(dae, &dae.scales(), tolerance)
    }

    /// The same with units instead of scales.
    pub fn of_units(dae: &dyn Dae, tolerance: f64) -> Self {
        Self::with(dae, &dae.units(), tolerance)
    }

    fn with(dae: &dyn Dae, scales: &Scales, tolerance: f64) -> Self {
        let pattern = dae.pattern();
        let mut reciprocals: Vec<f64> = scales.increments.iter().map(|s| 1.0 / (tolerance * s)).collect();
        reciprocals.resize(dae.velocities(), 1.0 / tolerance);
        Self { reciprocals, blocks: pattern.sizes[..pattern.velocity_blocks].to_vec() }
    }

    pub fn of(&self, x: &[f64]) -> f64 {
        let mut worst: f64 = 0.0;
        let (mut x, mut reciprocals) = (x, &self.reciprocals[..]);
        for &size in &self.blocks {
            let (block, rest) = x.split_at(size);
            let (weights, others) = reciprocals.split_at(size);
            let sum: f64 = block.iter().zip(weights).map(|(xi, wi)| (xi * wi) * (xi * wi)).sum();
            let mean = sum / size.max(1) as f64;
            if mean > worst || mean.is_nan() {
                worst = mean;
                if mean.is_nan() {
                    return f64::INFINITY;
                }
            }
            (x, reciprocals) = (rest, others);
        }
        worst.sqrt()
    }

    /// The largest weighted entry.
    pub fn worst(&self, x: &[f64]) -> usize {
        let mut best = (0, -1.0);
        for (i, (xi, wi)) in x.iter().zip(&self.reciprocals).enumerate() {
            let size = (xi * wi).abs();
            if size > best.1 || size.is_nan() {
                best = (i, if size.is_nan() { f64::INFINITY } else { size });
            }
        }
        best.0
    }
}
