//! The lowest undamped modes of models of any size, and how damping acts on them: subspace iteration
//! with the sparse factors of `K + w^2 M` under the constraints (Bathe, Finite Element Procedures,
//! section 11.6). One factorisation and a dozen vectors instead of all modes at once.

use crate::dense::{Matrix, eigenpairs};
use crate::linear::NewtonMatrix;
use crate::{Dae, Failure, JacobianPoint, Reason, SystemState};

/// An undamped mode.
#[derive(Clone, Debug, PartialEq)]
pub struct LowMode {
    /// rad/s; 0 for a motion without stiffness.
    pub frequency: f64,
    /// `x C x / (2 w x M x)` of its shape: exact where damping is proportional to stiffness.
    pub damping_ratio: f64,
    /// Increments of the velocities' unknowns, of one unit of `x M x`.
    pub shape: Vec<f64>,
}

/// What a search thinks of an elastic motion that it meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// Not what is looked for.
    Other,
    /// The lowest of these is wanted.
    Wanted,
    /// Nothing more need be known, if it is a motion of its own or a mixture of modes below this frequency,
    /// rad/s, alone.
    Enough(f64),
}

/// What a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// If the search is settled, the lowest wanted one is converged, and so are those below it; the others are
    /// about right. By rising frequency.
    pub modes: Vec<LowMode>,
    /// Index of the lowest wanted one; none if none of the motions was.
    pub lowest: Option<usize>,
    /// Whether a motion was enough, which ended the search. It need not be a mode yet, but the lowest
    /// elastic frequency is not above its frequency (Rayleigh's principle).
    pub enough: bool,
    /// Whether the lowest wanted one did not change any more. If it did, its frequency is not above the one
    /// that is given.
    pub settled: bool,
}

/// Stiffness against mass of a rigid motion, as a share of the largest: what rounding leaves of zero.
const RIGID: f64 = 1e-13;
/// Relative change of the lowest wanted frequency at which the iteration ends.
const SETTLED: f64 = 1e-9;
/// The same while the shift is still far from that frequency.
const ABOUT: f64 = 1e-2;
/// Relative change below which a motion is taken for one that may be enough: it is no mixture of others
/// any more.
const UNMIXED: f64 = 0.05;
/// Size of what a mixture of modes may hold of those above a limit, as a part of its own: with a frequency a
/// million times as high its energy is still a part in a hundred million.
const PURE: f64 = 1e-10;
/// What is left of a vector when the others are taken out of it, as a part of its size, below which it is
/// rounding. Where the constraints leave fewer motions than there are vectors, the surplus ones are
/// combinations of the others and what is left, about 1e-14, breaks the constraints. A motion of its
/// own has less than this only if it is a hundred thousand times as fast as the slowest.
const NOTHING: f64 = 1e-10;
/// Most times the shift is moved to where the lowest frequency is.
const SHIFTS: usize = 12;
/// Most iterations with one shift: a good shift needs few, and a better one helps more than many.
const ITERATIONS: usize = 6;
/// Most iterations with the last shift.
const LAST: usize = 30;

/// Vectors and their products with the mass.
struct Basis {
    vectors: Vec<Vec<f64>>,
    images: Vec<Vec<f64>>,
    /// The shifts of the iterations so far.
    shifts: Vec<f64>,
}

impl Basis {
    /// What the iterations have left of modes of a frequency, or a higher one, beside those of another:
    /// each divides a mode by shift^2 + frequency^2.
    fn left(&self, of: f64, beside: f64) -> f64 {
        self.shifts.iter().map(|shift| (shift * shift + beside * beside) / (shift * shift + of * of)).product()
    }
}

/// A search for the lowest modes about a state.
pub struct LowestModes {
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

impl LowestModes {
    /// Linearises about a state.
    ///
    /// # Errors
    /// If the equations cannot be evaluated.
    pub fn new(dae: &mut dyn Dae, state: &SystemState) -> Result<LowestModes, Failure> {
        let mut state = state.clone();
        state.fit(dae);
        let pattern = dae.pattern();
        let mut part = |mass: f64, damping: f64, stiffness: f64| -> Result<NewtonMatrix, Failure> {
            let SystemState { t, q, v, a, lambda } = &state;
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
            LowestModes { n, unknowns, time: state.t, mass, damping, stiffness, shifted, pattern, highest: 0.0 };
        search.highest = search.estimate();
        Ok(search)
    }

    /// The lowest modes that `vectors` iterated vectors show, until the lowest of those that are wanted is
    /// converged or a motion is enough.
    ///
    /// # Errors
    /// If a motion has neither mass nor stiffness.
    pub fn find(&mut self, vectors: usize, mut look: impl FnMut(&LowMode) -> Look) -> Result<Found, Failure> {
        let highest = self.highest;
        // Low, because long structures are far below their highest frequency; not so low that rigid motions drown
        // all others.
        let mut shift = if highest > 0.0 && highest.is_finite() { 1e-5 * highest } else { 1.0 };
        let mut basis = self.start(vectors.min(self.n));
        let mut last = f64::INFINITY;
        for _ in 0..SHIFTS {
            self.factor(shift)?;
            let found = self.settle(&mut basis, shift, (ABOUT, ITERATIONS), &mut look)?;
            let Some(lowest) = found.lowest_frequency().filter(|_| !found.enough) else { return Ok(found) };
            if (lowest - last).abs() <= ABOUT * lowest {
                break;
            }
            (last, shift) = (lowest, lowest);
        }
        self.settle(&mut basis, shift, (SETTLED, LAST), &mut look)
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
        Basis { vectors, images, shifts: Vec::new() }
    }

    /// Iterates until the lowest wanted frequency changes by less than a share of it, or enough is known.
    fn settle(
        &mut self,
        basis: &mut Basis,
        shift: f64,
        (share, most): (f64, usize),
        look: &mut dyn FnMut(&LowMode) -> Look,
    ) -> Result<Found, Failure> {
        let mut last: Option<Found> = None;
        for _ in 0..most {
            let modes = self.improve(basis, shift).ok_or_else(|| Failure::new(Reason::NoConvergence, self.time))?;
            let mut now = Found { modes, lowest: None, enough: false, settled: false };
            let before = |at: usize| last.as_ref().and_then(|l| l.modes.get(at)).map_or(f64::INFINITY, |m| m.frequency);
            for (at, mode) in now.modes.iter().enumerate().filter(|(_, mode)| mode.frequency > 0.0) {
                match look(mode) {
                    Look::Other => continue,
                    Look::Wanted => {}
                    Look::Enough(limit) => {
                        let own = (mode.frequency - before(at)).abs() <= UNMIXED * mode.frequency;
                        let below = mode.frequency < limit && basis.left(limit, mode.frequency) <= PURE;
                        now.enough |= own || below;
                    }
                }
                now.lowest = now.lowest.or(Some(at));
            }
            // A smaller shift shows nothing else of motions without stiffness.
            let rigid = now.modes.iter().all(|mode| mode.frequency == 0.0);
            let frequency = now.lowest_frequency();
            let settled = match (frequency, last.as_ref().and_then(Found::lowest_frequency)) {
                (Some(now), Some(last)) => (now - last).abs() <= share * now,
                _ => false,
            };
            now.settled = settled;
            let ends = rigid || settled || now.enough;
            last = Some(now);
            if ends {
                break;
            }
        }
        last.ok_or_else(|| Failure::new(Reason::NoConvergence, self.time))
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
        let mut new = Basis { vectors: Vec::new(), images: Vec::new(), shifts: std::mem::take(&mut basis.shifts) };
        new.shifts.push(shift);
        for image in &basis.images {
            let mut y = image.clone();
            y.resize(self.unknowns, 0.0);
            // Unrefined: the next step corrects what this one leaves, and the modes are those of the matrices.
            self.shifted.solve(&mut y);
            y.truncate(self.n);
            let before = dot(&self.times(&self.mass, &y), &y);
            // Orthonormal in the mass; twice, so that nothing of the others is left.
            for _ in 0..2 {
                for (vector, image) in new.vectors.iter().zip(&new.images) {
                    let share = dot(image, &y);
                    add(&mut y, vector, -share);
                }
            }
            let mut image = self.times(&self.mass, &y);
            let square = dot(&image, &y);
            if square > NOTHING * NOTHING * before && square.is_finite() {
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
        let mut turned =
            Basis { vectors: Vec::with_capacity(p), images: Vec::with_capacity(p), shifts: new.shifts.clone() };
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
            modes.push(LowMode { frequency, damping_ratio, shape: x.clone() });
            turned.vectors.push(x);
            turned.images.push(image);
        }
        *basis = turned;
        Some(modes)
    }
}

impl Found {
    fn lowest_frequency(&self) -> Option<f64> {
        self.lowest.and_then(|at| self.modes.get(at)).map(|mode| mode.frequency)
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

    fn modes(dae: &mut dyn Dae, state: &SystemState) -> Vec<LowMode> {
        LowestModes::new(dae, state).unwrap().find(12, |_| Look::Wanted).unwrap().modes
    }

    /// Truth: w_1 = 2 sqrt(k/m) sin(pi / (4 n + 2)) of a chain fixed at one end, and damping c = b k
    /// gives b w_1 / 2; the free chain has a rigid motion and w = 2 sqrt(k/m) sin(pi / 2 n). The
    /// iteration ends at changes of 1e-6, and the frequency of a shape is of second order in its error.
    #[test]
    fn long_chains_have_the_lowest_mode_of_the_closed_form() {
        for n in [1_usize, 2, 30, 2000] {
            let (mass, stiffness, damping) = (0.5, 800.0, 0.4);
            let mut chain = SpringChain::uniform(n, mass, stiffness, damping);
            let state = SystemState::at_rest(&chain, 0.0, vec![0.0; n]);
            let found = modes(&mut chain, &state);
            let w = 2.0 * (stiffness / mass).sqrt() * (std::f64::consts::PI / (4 * n + 2) as f64).sin();
            assert!((found[0].frequency / w - 1.0).abs() < 1e-6, "{n}: {} {w}", found[0].frequency);
            assert!((found[0].damping_ratio / (0.5 * damping / stiffness * w) - 1.0).abs() < 1e-6, "{n}");
            if n < 2 {
                continue;
            }
            chain.stiffness[0] = 0.0;
            let found = modes(&mut chain, &state);
            let w = 2.0 * (stiffness / mass).sqrt() * (std::f64::consts::PI / (2 * n) as f64).sin();
            assert_eq!(found[0].frequency, 0.0, "{n}");
            assert!((found[1].frequency / w - 1.0).abs() < 1e-6, "{n}: {} {w}", found[1].frequency);
        }
    }

    /// Where modes lie so close together that none is soon found by itself, a mixture of those below a limit is
    /// enough. A stiff spring lifts the first shift to sqrt(2 1E14 / 1000) 1E-5 = 4.5 rad/s, and a hundred modes of
    /// the chain are below it, 2 sqrt(k/m) (2 i - 1) pi / (4 n + 2) = 0.03, 0.09, ... rad/s. What the limit of
    /// 70 rad/s leaves of those above is (4.5/70)^2 an iteration, so that five of them make it less than 1E-10.
    #[test]
    fn a_mixture_of_modes_below_a_limit_is_enough() {
        let n = 2000;
        let mut chain = SpringChain::uniform(n, 0.5, 800.0, 0.4);
        chain.stiffness[n - 1] = 1e14;
        let state = SystemState::at_rest(&chain, 0.0, vec![0.0; n]);
        let mut search = LowestModes::new(&mut chain, &state).unwrap();
        let mut looks = |limit: f64| {
            let mut looks = 0;
            let found = search.find(12, |_| {
                looks += 1;
                Look::Enough(limit)
            });
            assert!(found.unwrap().enough);
            looks
        };
        assert_eq!(looks(70.0), 12 * 5);
        assert!(looks(0.0) > 12 * 5, "without a limit a motion must be one of its own");
    }

    /// Truth: a hanging pendulum swings with sqrt(g / l); its other coordinate is held.
    #[test]
    fn constraints_are_kept() {
        let mut pendulum = Pendulum { mass: 3.0, length: 0.5, gravity: 9.80665, scale: 1.0 };
        let mut state = SystemState::at_rest(&pendulum, 0.0, vec![0.0, -0.5]);
        crate::initial::accelerations(&mut pendulum, &mut state).unwrap();
        let found = modes(&mut pendulum, &state);
        assert_eq!(found.len(), 1);
        assert!((found[0].frequency / (9.80665f64 / 0.5).sqrt() - 1.0).abs() < 1e-9, "{found:?}");
    }
}
