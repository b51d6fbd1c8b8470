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
const SETTLED: f64 = 1e-9;
/// The same while the shift is still far from that frequency.
const ABOUT: f64 = 1e-2;
/// Most times the shift is moved to where the lowest frequency is.
const SHIFTS: usize = 12;
/// Most iterations with one shift: a good shift needs few, and a better one helps more than many.
const ITERATIONS: usize = 6;
/// Most iterations with the last shift.
const LAST: usize = 30;

/// The lowest modes about a state, by rising frequency, as many as `vectors` iterated ones show; the
/// lowest elastic one among them is converged, and so are those below it. Empty if all motions that
/// were iterated are rigid: then more vectors are needed.
///
/// The search ends early when `enough` says so of a motion it meets on the way. Such a motion is no
/// mode yet, but the lowest elastic frequency is not above its frequency (Rayleigh's principle).
///
/// # Errors
/// If the equations cannot be evaluated, or a motion has neither mass nor stiffness.
pub fn lowest_modes(
    dae: &mut dyn Dae,
    state: &SystemState,
    vectors: usize,
    enough: impl Fn(&LowMode) -> bool,
) -> Result<Vec<LowMode>, Failure> {
    let known = |modes: &[LowMode]| modes.iter().any(|mode| mode.frequency > 0.0 && enough(mode));
    let mut state = state.clone();
    state.fit(dae);
    let mut search = Search::new(dae, &state)?;
    let highest = search.highest;
    // Low, because long structures are far below their highest frequency; not so low that rigid motions drown
    // all others.
    let mut shift = if highest > 0.0 && highest.is_finite() { 1e-5 * highest } else { 1.0 };
    let mut basis = search.start(vectors.min(search.n));
    let mut last = f64::INFINITY;
    for _ in 0..SHIFTS {
        search.factor(shift)?;
        let found = search.settle(&mut basis, shift, (ABOUT, ITERATIONS), &known)?;
        let Some((lowest, modes)) = found else { return Ok(Vec::new()) };
        if known(&modes) {
            return Ok(modes);
        }
        if (lowest - last).abs() <= ABOUT * lowest {
            break;
        }
        (last, shift) = (lowest, lowest);
    }
    Ok(search.settle(&mut basis, shift, (SETTLED, LAST), &known)?.map(|(_, found)| found).unwrap_or_default())
}

/// Vectors and their products with the mass.
struct Basis {
    vectors: Vec<Vec<f64>>,
    images: Vec<Vec<f64>>,
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
    /// About the highest frequency, rad/s.
    highest: f64,
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
        let unknowns = mass.unknowns();
        let mut search =
            Search { n, unknowns, time: state.t, mass, damping, stiffness, shifted, pattern, highest: 0.0 };
        search.highest = search.estimate();
        Ok(search)
    }

    /// About the highest frequency, from the traces of the matrices.
    fn estimate(&self) -> f64 {
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
    fn start(&self, count: usize) -> Basis {
        let mut seed = 0x9E37_79B9_7F4A_7C15_u64;
        let mut next = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let vectors: Vec<Vec<f64>> = (0..count).map(|_| (0..self.n).map(|_| next()).collect()).collect();
        let images = vectors.iter().map(|x| self.times(&self.mass, x)).collect();
        Basis { vectors, images }
    }

    /// Iterates until the lowest elastic frequency changes by less than a share of it, or enough is known;
    /// that frequency and all modes. `None` if all are rigid.
    fn settle(
        &mut self,
        basis: &mut Basis,
        shift: f64,
        (share, most): (f64, usize),
        known: &dyn Fn(&[LowMode]) -> bool,
    ) -> Result<Option<(f64, Vec<LowMode>)>, Failure> {
        let mut lowest = f64::INFINITY;
        let mut found = Vec::new();
        for _ in 0..most {
            found = self.improve(basis, shift).ok_or_else(|| Failure::new(Reason::NoConvergence, self.time))?;
            // A smaller shift shows nothing else of motions without stiffness.
            let Some(now) = found.iter().find(|m| m.frequency > 0.0).map(|m| m.frequency) else { return Ok(None) };
            let settled = (now - lowest).abs() <= share * now;
            lowest = now;
            if settled || known(&found) {
                break;
            }
        }
        Ok(Some((lowest, found)))
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
    fn improve(&mut self, basis: &mut Basis, shift: f64) -> Option<Vec<LowMode>> {
        let mut new = Basis { vectors: Vec::new(), images: Vec::new() };
        for image in &basis.images {
            let mut y = image.clone();
            y.resize(self.unknowns, 0.0);
            // Unrefined: the next step corrects what this one leaves, and the modes are those of the matrices.
            self.shifted.solve(&mut y);
            y.truncate(self.n);
            // Orthonormal in the mass; twice, so that nothing of the others is left.
            for _ in 0..2 {
                for (vector, image) in new.vectors.iter().zip(&new.images) {
                    let share = dot(image, &y);
                    add(&mut y, vector, -share);
                }
            }
            let mut image = self.times(&self.mass, &y);
            let square = dot(&image, &y);
            if square > 0.0 && square.is_finite() {
                let factor = 1.0 / square.sqrt();
                y.iter_mut().chain(&mut image).for_each(|x| *x *= factor);
                new.vectors.push(y);
                new.images.push(image);
            }
        }
        let p = new.vectors.len();
        if p == 0 {
            return None;
        }
        let of =
            |matrix: &NewtonMatrix| -> Vec<Vec<f64>> { new.vectors.iter().map(|x| self.times(matrix, x)).collect() };
        let (stiffness, damping) = (of(&self.stiffness), of(&self.damping));
        let reduced = Matrix::from_fn(p, p, |i, j| {
            0.5 * (dot(&new.vectors[i], &stiffness[j]) + dot(&new.vectors[j], &stiffness[i]))
        });
        let mut pairs = eigenpairs(reduced)?;
        pairs.sort_by(|a, b| a.value[0].total_cmp(&b.value[0]));
        let least = RIGID * self.highest.powi(2).max(shift * shift);
        let mut turned = Basis { vectors: Vec::with_capacity(p), images: Vec::with_capacity(p) };
        let mut modes = Vec::with_capacity(p);
        for pair in &pairs {
            let combined = |all: &[Vec<f64>]| {
                let mut x = vec![0.0; self.n];
                all.iter().zip(&pair.vector).for_each(|(v, share)| add(&mut x, v, share[0]));
                x
            };
            let (x, image) = (combined(&new.vectors), combined(&new.images));
            let frequency = if pair.value[0] > least { pair.value[0].sqrt() } else { 0.0 };
            let damped = dot(&combined(&damping), &x);
            let damping_ratio = if frequency > 0.0 { damped / (2.0 * frequency * dot(&image, &x)) } else { 0.0 };
            modes.push(LowMode { frequency, damping_ratio });
            turned.vectors.push(x);
            turned.images.push(image);
        }
        *basis = turned;
        Some(modes)
    }
}

/// `y += factor x`
fn add(y: &mut [f64], x: &[f64], factor: f64) {
    y.iter_mut().zip(x).for_each(|(yi, xi)| *yi += factor * xi);
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
            let found = lowest_modes(&mut chain, &state, 12, |_| false).unwrap();
            let w = 2.0 * (stiffness / mass).sqrt() * (std::f64::consts::PI / (4 * n + 2) as f64).sin();
            assert!((found[0].frequency / w - 1.0).abs() < 1e-6, "{n}: {} {w}", found[0].frequency);
            assert!((found[0].damping_ratio / (0.5 * damping / stiffness * w) - 1.0).abs() < 1e-6, "{n}");
            if n < 2 {
                continue;
            }
            chain.stiffness[0] = 0.0;
            let found = lowest_modes(&mut chain, &state, 12, |_| false).unwrap();
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
        let found = lowest_modes(&mut pendulum, &state, 12, |_| false).unwrap();
        assert_eq!(found.len(), 1);
        assert!((found[0].frequency / (9.80665f64 / 0.5).sqrt() - 1.0).abs() < 1e-9, "{found:?}");
    }
}
