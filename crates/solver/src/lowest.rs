//! The lowest undamped modes of models of any size, and how damping acts on them: subspace iteration
//! with the sparse factors of `K + w^2 M` under the constraints (Bathe, Finite Element Procedures,
//! section 11.6). One factorisation and a dozen vectors instead of all modes at once.

use crate::dense::{Matrix, eigenpairs};
use crate::linear::NewtonMatrix;
use crate::{Dae, Failure, JacobianPoint, Reason, SystemState};

/// An undamped mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowMode {
    /// rad/s; 0 for a motion without stiffness.
    pub frequency: f64,
    /// `x C x / (2 w x M x)` of its shape: exact where damping is proportional to stiffness.
    pub damping_ratio: f64,
}

/// Stiffness against mass of a rigid motion, as a share of the largest: what rounding leaves of zero.
const RIGID: f64 = 1e-13;
/// Relative change of the lowest elastic frequency at which the iteration ends.
const SETTLED: f64 = 1e-6;
/// Most times the shift is moved to where the lowest frequency is.
const SHIFTS: usize = 6;
/// Most iterations with one shift.
const ITERATIONS: usize = 20;

/// The lowest modes about a state, by rising frequency, as many as `vectors` iterated ones show; the
/// lowest elastic one among them is converged, and so are those below it. Empty if all motions that
/// were iterated are rigid: then more vectors are needed.
///
/// # Errors
/// If the equations cannot be evaluated, or a motion has neither mass nor stiffness.
pub fn lowest_modes(dae: &mut dyn Dae, state: &SystemState, vectors: usize) -> Result<Vec<LowMode>, Failure> {
    let mut state = state.clone();
    state.fit(dae);
    let mut search = Search::new(dae, &state)?;
    let highest = search.highest();
    let mut shift = if highest > 0.0 && highest.is_finite() { 1e-3 * highest } else { 1.0 };
    let mut basis = search.start(vectors.min(search.n));
    let (mut found, mut last) = (Vec::new(), f64::INFINITY);
    for _ in 0..SHIFTS {
        search.factor(shift)?;
        let mut lowest = f64::INFINITY;
        for _ in 0..ITERATIONS {
            (basis, found) =
                search.improve(&basis, shift).ok_or_else(|| Failure::new(Reason::NoConvergence, state.t))?;
            let elastic = found.iter().find(|m| m.frequency > 0.0).map(|m| m.frequency);
            let Some(now) = elastic else { break };
            let settled = (now - lowest).abs() <= SETTLED * now;
            lowest = now;
            if settled {
                break;
            }
        }
        if !lowest.is_finite() {
            // Rigid motions only: a smaller shift shows nothing else.
            break;
        }
        if (lowest - last).abs() <= SETTLED.sqrt() * lowest {
            return Ok(found);
        }
        (last, shift) = (lowest, lowest);
    }
    found.retain(|_| last.is_finite());
    Ok(found)
}

struct Search {
    n: usize,
    unknowns: usize,
    time: f64,
    mass: NewtonMatrix,
    damping: NewtonMatrix,
    stiffness: NewtonMatrix,
    shifted: NewtonMatrix,
    pattern: crate::Pattern,
}

impl Search {
    fn new(dae: &mut dyn Dae, state: &SystemState) -> Result<Search, Failure> {
        let pattern = dae.pattern();
        let mut part = |mass: f64, damping: f64, stiffness: f64| -> Result<NewtonMatrix, Failure> {
            let SystemState { t, q, v, a, lambda } = state;
            let mut matrix = NewtonMatrix::new(&pattern);
            let at = JacobianPoint { t: *t, q, v, a, lambda, mass, damping, stiffness };
            matrix.assemble(dae, at).map_err(Failure::evaluation(*t))?;
            Ok(matrix)
        };
        let (mass, damping, stiffness) = (part(1.0, 0.0, 0.0)?, part(0.0, 1.0, 0.0)?, part(0.0, 0.0, 1.0)?);
        let shifted = NewtonMatrix::new(&pattern);
        let n = dae.velocities();
        Ok(Search { n, unknowns: mass.unknowns(), time: state.t, mass, damping, stiffness, shifted, pattern })
    }

    /// About the highest frequency, from the traces of the matrices.
    fn highest(&self) -> f64 {
        let trace = |matrix: &NewtonMatrix| {
            let mut sum = 0.0;
            for (row, column, values) in matrix.blocks().filter(|(r, c, _)| r == c && *r < self.pattern.velocity_blocks)
            {
                debug_assert_eq!(row, column);
                sum += (0..matrix.size(row)).map(|i| values[i * matrix.size(row) + i].abs()).sum::<f64>();
            }
            sum
        };
        (trace(&self.stiffness) / trace(&self.mass)).sqrt()
    }

    /// Vectors that no mode is orthogonal to, always the same.
    fn start(&self, count: usize) -> Vec<Vec<f64>> {
        let mut seed = 0x9E37_79B9_7F4A_7C15_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        (0..count).map(|_| (0..self.n).map(|_| next()).collect()).collect()
    }

    /// Factors `K + shift^2 M` with the constraints.
    fn factor(&mut self, shift: f64) -> Result<(), Failure> {
        self.shifted.clear();
        let velocity_blocks = self.pattern.velocity_blocks;
        for (row, column, values) in self.stiffness.blocks() {
            self.shifted.add(row, column, values);
        }
        for (row, column, values) in self.mass.blocks() {
            // The constraints stand in both.
            if row < velocity_blocks && column < velocity_blocks {
                let scaled: Vec<f64> = values.iter().map(|x| x * shift * shift).collect();
                self.shifted.add(row, column, &scaled);
            }
        }
        self.shifted.suspect();
        self.shifted.factor().map_err(|_| Failure::new(Reason::Singular, self.time))
    }

    fn times(&self, matrix: &NewtonMatrix, x: &[f64]) -> Vec<f64> {
        let mut padded = x.to_vec();
        padded.resize(self.unknowns, 0.0);
        let mut y = vec![0.0; self.unknowns];
        matrix.multiply(&padded, &mut y);
        y.truncate(self.n);
        y
    }

    /// One step of the iteration: better vectors, and the modes they show.
    fn improve(&mut self, basis: &[Vec<f64>], shift: f64) -> Option<(Vec<Vec<f64>>, Vec<LowMode>)> {
        let mut vectors: Vec<Vec<f64>> = Vec::new();
        for x in basis {
            let mut y = self.times(&self.mass, x);
            y.resize(self.unknowns, 0.0);
            self.shifted.solve_refined(&mut y);
            y.truncate(self.n);
            // Orthonormal in the mass; twice, so that nothing of the others is left.
            for _ in 0..2 {
                for other in &vectors {
                    let share = dot(&self.times(&self.mass, other), &y);
                    y.iter_mut().zip(other).for_each(|(yi, oi)| *yi -= share * oi);
                }
            }
            let square = dot(&self.times(&self.mass, &y), &y);
            if square > 0.0 && square.is_finite() {
                let size = square.sqrt();
                y.iter_mut().for_each(|yi| *yi /= size);
                vectors.push(y);
            }
        }
        let p = vectors.len();
        if p == 0 {
            return None;
        }
        let images: Vec<Vec<f64>> = vectors.iter().map(|x| self.times(&self.stiffness, x)).collect();
        let reduced = Matrix::from_fn(p, p, |i, j| 0.5 * (dot(&vectors[i], &images[j]) + dot(&vectors[j], &images[i])));
        let mut pairs = eigenpairs(reduced)?;
        pairs.sort_by(|a, b| a.value[0].total_cmp(&b.value[0]));
        let least = RIGID * self.highest().powi(2).max(shift * shift);
        let mut turned = Vec::with_capacity(p);
        let mut modes = Vec::with_capacity(p);
        for pair in &pairs {
            let mut x = vec![0.0; self.n];
            for (vector, share) in vectors.iter().zip(&pair.vector) {
                x.iter_mut().zip(vector).for_each(|(xi, vi)| *xi += share[0] * vi);
            }
            let mass = dot(&self.times(&self.mass, &x), &x);
            let frequency = if pair.value[0] > least { pair.value[0].sqrt() } else { 0.0 };
            let damped = dot(&self.times(&self.damping, &x), &x);
            let damping_ratio = if frequency > 0.0 { damped / (2.0 * frequency * mass) } else { 0.0 };
            modes.push(LowMode { frequency, damping_ratio });
            turned.push(x);
        }
        Some((turned, modes))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problems::oscillator::SpringChain;
    use crate::problems::pendulum::Pendulum;

    /// Truth: w_1 = 2 sqrt(k/m) sin(pi / (4 n + 2)) of a chain fixed at one end, and damping c = b k
    /// gives b w_1 / 2; the free chain has a rigid motion and w = 2 sqrt(k/m) sin(pi / 2 n). The
    /// iteration ends at changes of 1e-6, and the frequency of a shape is of second order in its error.
    #[test]
    fn long_chains_have_the_lowest_mode_of_the_closed_form() {
        for n in [1_usize, 2, 30, 2000] {
            let (mass, stiffness, damping) = (0.5, 800.0, 0.4);
            let mut chain = SpringChain::uniform(n, mass, stiffness, damping);
            let state = SystemState::at_rest(&chain, 0.0, vec![0.0; n]);
            let found = lowest_modes(&mut chain, &state, 12).unwrap();
            let w = 2.0 * (stiffness / mass).sqrt() * (std::f64::consts::PI / (4 * n + 2) as f64).sin();
            assert!((found[0].frequency / w - 1.0).abs() < 1e-6, "{n}: {} {w}", found[0].frequency);
            assert!((found[0].damping_ratio / (0.5 * damping / stiffness * w) - 1.0).abs() < 1e-6, "{n}");
            if n < 2 {
                continue;
            }
            chain.stiffness[0] = 0.0;
            let found = lowest_modes(&mut chain, &state, 12).unwrap();
            let w = 2.0 * (stiffness / mass).sqrt() * (std::f64::consts::PI / (2 * n) as f64).sin();
            assert_eq!(found[0].frequency, 0.0, "{n}");
            assert!((found[1].frequency / w - 1.0).abs() < 1e-6, "{n}: {} {w}", found[1].frequency);
        }
    }

    /// Truth: a hanging pendulum swings with sqrt(g / l); its other coordinate is held.
    #[test]
    fn constraints_are_kept() {
        let mut pendulum = Pendulum { mass: 3.0, length: 0.5, gravity: 9.80665, scale: 1.0 };
        let mut state = SystemState::at_rest(&pendulum, 0.0, vec![0.0, -0.5]);
        crate::initial::accelerations(&mut pendulum, &mut state).unwrap();
        let found = lowest_modes(&mut pendulum, &state, 12).unwrap();
        assert_eq!(found.len(), 1);
        assert!((found[0].frequency / (9.80665f64 / 0.5).sqrt() - 1.0).abs() < 1e-9, "{found:?}");
    }
}
