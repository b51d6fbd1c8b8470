//! Initial conditions: positions that meet the constraints, then velocities, then accelerations
//! and multipliers.

use crate::linear::NewtonMatrix;
use crate::state::Norm;
use crate::{Dae, Failure, JacobianPoint, Reason, SystemState};

/// Weight of a coordinate that assembly should keep; others have 1.
pub const EXACT: f64 = 1e10;

/// What assembly did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly {
    pub iterations: usize,
    /// Largest constraint residual left, SI.
    pub residual: f64,
}

const ITERATIONS: usize = 60;
/// Corrections below this, in model units and radians, end the iteration.
const CONVERGED: f64 = 1e-10;

fn constraints_only(state: &SystemState) -> JacobianPoint<'_> {
    let SystemState { t, q, v, a, lambda } = state;
    JacobianPoint { t: *t, q, v, a, lambda, mass: 0.0, damping: 0.0, stiffness: 0.0 }
}

/// Weights per squared model unit.
fn weighted(dae: &dyn Dae, weights: &[f64]) -> Vec<f64> {
    let units = dae.units().increments;
    (0..dae.velocities())
        .map(|i| {
            let unit = units.get(i).copied().unwrap_or(1.0);
            weights.get(i).copied().unwrap_or(1.0) / (unit * unit)
        })
        .collect()
}

/// Moves `state.q` to the nearest positions, in the weighted sense, that meet the constraints.
///
/// `weights` has one entry for each velocity-level unknown (empty: all 1), see [`EXACT`].
pub fn displacements(dae: &mut dyn Dae, state: &mut SystemState, weights: &[f64]) -> Result<Assembly, Failure> {
    state.fit(dae);
    let (n, m, t) = (dae.velocities(), dae.constraints(), state.t);
    if m == 0 {
        return Ok(Assembly { iterations: 0, residual: 0.0 });
    }
    let weights = weighted(dae, weights);
    let norm = Norm::of_units(dae, 1.0);
    let mut matrix = NewtonMatrix::new(&dae.mass_pattern());
    let start = state.q.clone();
    let mut moved = vec![0.0; n];
    let mut next = state.q.clone();
    let mut x = vec![0.0; n + m];
    let mut last = f64::INFINITY;
    for iteration in 1..=ITERATIONS {
        dae.constraint_residual(t, &state.q, &mut x[n..]).map_err(Failure::evaluation(t))?;
        dae.difference(&start, &state.q, &mut moved);
        for i in 0..n {
            x[i] = -weights[i] * moved[i];
        }
        x[n..].iter_mut().for_each(|phi| *phi = -*phi);
        let residual = x[n..].iter().fold(0.0, |largest: f64, phi| largest.max(phi.abs()));
        matrix.assemble(dae, constraints_only(state)).map_err(Failure::evaluation(t))?;
        matrix.add_to_diagonal(&weights);
        matrix.factor().map_err(|singular| Failure::new(Reason::Singular, t).at(dae, singular.unknown, residual))?;
        matrix.solve_refined(&mut x);
        // Far from assembled, a full step can turn parts by more than the linearisation bears.
        let size = norm.of(&x[..n]);
        if !size.is_finite() {
            break;
        }
        let turn = (0..n).filter(|&i| dae.is_rotation(i)).map(|i| x[i].abs()).fold(0.0, f64::max);
        let factor = if turn > 0.5 { 0.5 / turn } else { 1.0 };
        x[..n].iter_mut().for_each(|xi| *xi *= factor);
        dae.retract(&state.q, &x[..n], &mut next);
        std::mem::swap(&mut state.q, &mut next);
        // Rounding of large coordinates can keep corrections above the limit: stop when stuck there.
        if size < CONVERGED || (size < 1e-7 && size >= 0.5 * last) {
            dae.constraint_residual(t, &state.q, &mut x[n..]).map_err(Failure::evaluation(t))?;
            let residual = x[n..].iter().fold(0.0, |largest: f64, phi| largest.max(phi.abs()));
            return Ok(Assembly { iterations: iteration, residual });
        }
        last = size;
    }
    dae.constraint_residual(t, &state.q, &mut x[n..]).map_err(Failure::evaluation(t))?;
    let (worst, size) = largest(&x[n..]);
    Err(Failure::new(Reason::Constraints, t).at(dae, n + worst, size))
}

/// Moves `state.v` to the nearest velocities, in the weighted sense, with `B v = -Phi_t`.
pub fn velocities(dae: &mut dyn Dae, state: &mut SystemState, weights: &[f64]) -> Result<(), Failure> {
    state.fit(dae);
    let (n, m, t) = (dae.velocities(), dae.constraints(), state.t);
    if m == 0 {
        return Ok(());
    }
    let weights = weighted(dae, weights);
    let mut matrix = NewtonMatrix::new(&dae.mass_pattern());
    let mut x = vec![0.0; n + m];
    dae.constraint_velocity(t, &state.q, &mut x[n..]).map_err(Failure::evaluation(t))?;
    x[n..].iter_mut().for_each(|phi| *phi = -*phi);
    for i in 0..n {
        x[i] = weights[i] * state.v[i];
    }
    matrix.assemble(dae, constraints_only(state)).map_err(Failure::evaluation(t))?;
    matrix.add_to_diagonal(&weights);
    matrix.factor().map_err(|singular| Failure::new(Reason::Singular, t).at(dae, singular.unknown, 0.0))?;
    matrix.solve_refined(&mut x);
    state.v.copy_from_slice(&x[..n]);
    Ok(())
}

/// Finds `state.a` and `state.lambda` from the equations of motion and `B a = -gamma`.
pub fn accelerations(dae: &mut dyn Dae, state: &mut SystemState) -> Result<(), Failure> {
    state.fit(dae);
    let mut matrix = NewtonMatrix::new(&dae.mass_pattern());
    Accelerations::default().find(dae, state, &mut matrix)
}

/// The same with memory that is used again: once for each output of a run.
#[derive(Default)]
pub(crate) struct Accelerations {
    /// True when the matrix given holds factors that serve all states.
    factored: bool,
    x: Vec<f64>,
    rate: Vec<f64>,
}

impl Accelerations {
    pub fn find(
        &mut self,
        dae: &mut dyn Dae,
        state: &mut SystemState,
        matrix: &mut NewtonMatrix,
    ) -> Result<(), Failure> {
        if self.factored {
            return self.solve(dae, state, matrix);
        }
        let SystemState { t, q, v, a, lambda } = &*state;
        let t = *t;
        let at = JacobianPoint { t, q, v, a, lambda, mass: 1.0, damping: 0.0, stiffness: 0.0 };
        matrix.assemble(dae, at).map_err(Failure::evaluation(t))?;
        matrix.factor().map_err(|singular| Failure::new(Reason::Singular, t).at(dae, singular.unknown, 0.0))?;
        self.factored = dae.constraints() == 0 && dae.mass_is_constant();
        self.solve(dae, state, matrix)
    }

    /// The same with the matrix already assembled and factored at this state.
    pub fn solve(
        &mut self,
        dae: &mut dyn Dae,
        state: &mut SystemState,
        matrix: &mut NewtonMatrix,
    ) -> Result<(), Failure> {
        let (n, m, t) = (dae.velocities(), dae.constraints(), state.t);
        self.x.resize(n + m, 0.0);
        self.rate.resize(m, 0.0);
        // Linear but for loads that depend on accelerations or reactions; the second pass also
        // removes rounding.
        let mut last = f64::INFINITY;
        for _ in 0..10 {
            let SystemState { q, v, a, lambda, .. } = &*state;
            dae.residual(t, q, v, a, lambda, &mut self.x[..n]).map_err(Failure::evaluation(t))?;
            dae.constraint_acceleration(t, q, v, &mut self.rate).map_err(Failure::evaluation(t))?;
            matrix.multiply_constraints(a, &mut self.x[n..]);
            for i in 0..m {
                self.x[n + i] += self.rate[i];
            }
            self.x.iter_mut().for_each(|xi| *xi = -*xi);
            if m == 0 {
                // Inertias have nothing to refine.
                matrix.solve(&mut self.x);
            } else {
                matrix.solve_refined(&mut self.x);
            }
            let (mut change, mut size): (f64, f64) = (0.0, 0.0);
            for (ai, xi) in state.a.iter_mut().zip(&self.x[..n]) {
                *ai += xi;
                change = change.max(xi.abs());
                size = size.max(ai.abs());
            }
            for (li, xi) in state.lambda.iter_mut().zip(&self.x[n..]) {
                *li += xi;
            }
            if !change.is_finite() {
                let (worst, size) = largest(&self.x);
                return Err(Failure::new(Reason::Singular, t).at(dae, worst, size));
            }
            if dae.is_linear_in_accelerations() || change <= 1e-9 * size || change >= 0.5 * last {
                break;
            }
            last = change;
        }
        Ok(())
    }
}

/// Index and size of the largest entry; zero for an empty slice.
pub(crate) fn largest(x: &[f64]) -> (usize, f64) {
    let mut best = (0, 0.0);
    for (i, xi) in x.iter().enumerate() {
        if xi.abs() > best.1 || xi.is_nan() {
            best = (i, xi.abs());
        }
    }
    best
}
