//! Linear modes about a state: eigenvalues of `M x'' + C x' + K x + B^T lambda = 0`, `B x = 0`.
//!
//! Motions that meet the constraints are `x = Z y` with an orthonormal basis `Z` of the null space
//! of `B`. The eigenvalues of the reduced problem are found by shift and invert, `s = sigma + 1/mu`:
//! that keeps the low ones accurate when the highest are millions of times larger, does not need
//! an invertible mass matrix, and is not disturbed by rigid modes.

use crate::dense::{Lu, Matrix, eigenpairs, null_space};
use crate::linear::NewtonMatrix;
use crate::{Dae, Failure, JacobianPoint, Reason, SystemState};

/// What to find.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeOptions {
    /// Problems with more freedoms are refused: the dense method's cost grows with the cube.
    pub largest: usize,
}

impl Default for ModeOptions {
    fn default() -> Self {
        Self { largest: 3000 }
    }
}

/// A real eigenvalue, or a pair of conjugate ones (the one with positive imaginary part).
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Real and imaginary part, 1/s.
    pub eigenvalue: [f64; 2],
    /// True when the conjugate eigenvalue belongs to this mode too.
    pub pair: bool,
    /// Amplitude of each velocity-level unknown, real and imaginary part; the largest is 1.
    pub shape: Vec<[f64; 2]>,
}

impl Mode {
    /// `|s| / 2 pi`, Hz.
    pub fn undamped_frequency(&self) -> f64 {
        self.magnitude() / std::f64::consts::TAU
    }

    /// `-Re s / |s|`; 1 and more than critical damping for real eigenvalues that decay.
    pub fn damping_ratio(&self) -> f64 {
        let size = self.magnitude();
        if size > 0.0 { -self.eigenvalue[0] / size } else { 0.0 }
    }

    /// Real and imaginary part in cycles per second, as eigenvalue tables print them.
    pub fn cycles(&self) -> [f64; 2] {
        self.eigenvalue.map(|part| part / std::f64::consts::TAU)
    }

    fn magnitude(&self) -> f64 {
        self.eigenvalue[0].hypot(self.eigenvalue[1])
    }
}

/// All modes, by rising undamped frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {
    pub modes: Vec<Mode>,
    /// Number of independent motions.
    pub freedoms: usize,
}

/// Linearises at `state` and finds the modes. The state should be an equilibrium or a steady motion,
/// with its multipliers and accelerations.
pub fn modes(dae: &mut dyn Dae, state: &SystemState, options: &ModeOptions) -> Result<Modes, Failure> {
    let t = state.t;
    let (n, m) = (dae.velocities(), dae.constraints());
    if n > options.largest.saturating_add(m) {
        return Err(Failure::new(Reason::Option("the model has too many freedoms for a dense modal analysis"), t));
    }
    let mut state = state.clone();
    state.fit(dae);
    let mut matrix = NewtonMatrix::new(&dae.pattern());
    let mut part = |mass: f64, damping: f64, stiffness: f64| -> Result<(Matrix, Matrix), Failure> {
        let SystemState { t, q, v, a, lambda } = &state;
        let at = JacobianPoint { t: *t, q, v, a, lambda, mass, damping, stiffness };
        matrix.assemble(dae, at).map_err(Failure::evaluation(*t))?;
        Ok(dense(&matrix, n, m))
    };
    let (mass, constraints) = part(1.0, 0.0, 0.0)?;
    let (damping, _) = part(0.0, 1.0, 0.0)?;
    let (stiffness, _) = part(0.0, 0.0, 1.0)?;
    let basis = null_space(&constraints, crate::redundancy::TOLERANCE);
    let freedoms = basis.columns();
    if freedoms == 0 {
        return Ok(Modes { modes: Vec::new(), freedoms });
    }
    let reduce = |full: &Matrix| basis.transposed_times(&full.times(&basis));
    let reduced = Reduced { mass: reduce(&mass), damping: reduce(&damping), stiffness: reduce(&stiffness) };
    let found = reduced.eigenvalues().ok_or_else(|| Failure::new(Reason::NoConvergence, t))?;
    let mut modes: Vec<Mode> = found
        .into_iter()
        .map(|(eigenvalue, [real, imaginary])| {
            let (real, imaginary) = (basis.times_vector(&real), basis.times_vector(&imaginary));
            let shape = normalised(real.into_iter().zip(imaginary).map(|(re, im)| [re, im]).collect());
            Mode { eigenvalue, pair: eigenvalue[1] > 0.0, shape }
        })
        .collect();
    modes.sort_by(|a, b| a.magnitude().total_cmp(&b.magnitude()).then(a.eigenvalue[0].total_cmp(&b.eigenvalue[0])));
    Ok(Modes { modes, freedoms })
}

/// The velocity block and the constraint rows of an assembled matrix.
fn dense(matrix: &NewtonMatrix, n: usize, m: usize) -> (Matrix, Matrix) {
    let (mut velocity, mut constraints) = (Matrix::zeros(n, n), Matrix::zeros(m, n));
    for (row, column, values) in matrix.blocks() {
        let (first, from, size) = (matrix.offset(row), matrix.offset(column), matrix.size(row));
        if from >= n {
            continue;
        }
        for (at, &value) in values.iter().enumerate() {
            let (i, j) = (first + at % size, from + at / size);
            if i < n {
                velocity[(i, j)] = value;
            } else {
                constraints[(i - n, j)] = value;
            }
        }
    }
    (velocity, constraints)
}

/// Divides by the largest amplitude, which becomes real and 1.
fn normalised(mut shape: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let mut best = [0.0, 0.0];
    let mut largest = 0.0;
    for &[re, im] in &shape {
        let size = re * re + im * im;
        // The first of equals, whatever rounding says.
        if size > largest * (1.0 + 1e-9) {
            largest = size;
            best = [re, im];
        }
    }
    if largest > 0.0 {
        for entry in &mut shape {
            let [re, im] = *entry;
            *entry = [(re * best[0] + im * best[1]) / largest, (im * best[0] - re * best[1]) / largest];
        }
    }
    shape
}

/// Shifts to try, as shares of about the highest frequency: below the highest frequencies, so that the
/// low ones are seen sharply; not so far below that the inertia of rigid motions drowns in the rounding
/// of the stiffness. Rarely the double shifts of the QR iteration go round in circles on one of these
/// matrices; the next shift gives another matrix.
const SHIFTS: [f64; 4] = [0.05, 0.04, 0.07, 0.1];

/// Highest frequency assumed of a model without stiffness or mass: the first shift is then 1 rad/s.
const NO_SCALE: f64 = 1.0 / SHIFTS[0];

struct Reduced {
    mass: Matrix,
    damping: Matrix,
    stiffness: Matrix,
}

/// Real and imaginary part.
type Eigenvector = [Vec<f64>; 2];

impl Reduced {
    /// Finite eigenvalues with non-negative imaginary part, and their vectors.
    fn eigenvalues(&self) -> Option<Vec<([f64; 2], Eigenvector)>> {
        let f = self.mass.rows();
        let diagonal = |a: &Matrix| (0..f).map(|i| a[(i, i)].abs()).sum::<f64>();
        let (mass, stiffness) = (diagonal(&self.mass), diagonal(&self.stiffness));
        let highest = (stiffness / mass).sqrt();
        let unit = if highest.is_finite() && highest > 0.0 { highest } else { NO_SCALE };
        SHIFTS.iter().find_map(|share| self.eigenvalues_from(share * unit))
    }

    /// The same by the eigenvalues of the inverse of what is left of the equations at a shift.
    fn eigenvalues_from(&self, shift: f64) -> Option<Vec<([f64; 2], Eigenvector)>> {
        let f = self.mass.rows();
        let pencil = Matrix::from_fn(f, f, |i, j| {
            shift * (shift * self.mass[(i, j)] + self.damping[(i, j)]) + self.stiffness[(i, j)]
        });
        let factors = Lu::new(pencil);
        let mut from_position = Matrix::from_fn(f, f, |i, j| -(self.damping[(i, j)] + shift * self.mass[(i, j)]));
        let mut from_velocity = Matrix::from_fn(f, f, |i, j| -shift * self.mass[(i, j)]);
        for j in 0..f {
            factors.solve(from_position.column_mut(j));
            factors.solve(from_velocity.column_mut(j));
        }
        // Positions, then velocities divided by the shift.
        let operator = Matrix::from_fn(2 * f, 2 * f, |i, j| {
            let value = if j < f { from_position[(i % f, j)] } else { from_velocity[(i % f, j - f)] };
            if i >= f && i - f == j { value + 1.0 / shift } else { value }
        });
        let pairs = eigenpairs(operator)?;
        let largest = pairs.iter().map(|pair| pair.value[0].hypot(pair.value[1])).fold(0.0, f64::max);
        let mut found = Vec::new();
        for pair in pairs {
            let [re, im] = pair.value;
            let size2 = re * re + im * im;
            // Zero stands for an infinite eigenvalue: a motion without mass.
            if size2.sqrt() <= 1e-15 * largest {
                continue;
            }
            // The inverse of the conjugate has the positive imaginary part: so the vector's
            // conjugate belongs to it.
            let eigenvalue = [shift + re / size2, im / size2];
            let part = |at: usize, sign: f64| pair.vector[..f].iter().map(|x| sign * x[at]).collect();
            found.push((eigenvalue, [part(0, 1.0), part(1, -1.0)]));
        }
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problems::oscillator::SpringChain;
    use crate::problems::pendulum::Pendulum;

    fn of(problem: &mut dyn Dae, q: Vec<f64>) -> Modes {
        let mut state = SystemState::at_rest(problem, 0.0, q);
        crate::initial::accelerations(problem, &mut state).unwrap();
        modes(problem, &state, &ModeOptions::default()).unwrap()
    }

    /// Truth: a chain fixed at one end has w_k = 2 sqrt(k/m) sin((2 k - 1) pi / (4 n + 2)), and with
    /// damping c = b k the ratio b w_k / 2. Masses swing like sines.
    #[test]
    fn a_spring_chain_has_the_modes_of_the_closed_form() {
        let (n, mass, stiffness, damping) = (12, 0.5, 800.0, 0.4);
        let mut chain = SpringChain::uniform(n, mass, stiffness, damping);
        let found = of(&mut chain, vec![0.0; n]);
        assert_eq!(found.modes.len(), n);
        for (k, mode) in found.modes.iter().enumerate() {
            let phase = (2 * k + 1) as f64 * std::f64::consts::PI / (4 * n + 2) as f64;
            let w = 2.0 * (stiffness / mass).sqrt() * phase.sin();
            assert!((mode.undamped_frequency() * std::f64::consts::TAU / w - 1.0).abs() < 1e-10, "{k}");
            let ratio = 0.5 * damping / stiffness * w;
            assert!((mode.damping_ratio() - ratio).abs() < 1e-10, "{k}: {} {ratio}", mode.damping_ratio());
            assert!(mode.pair);
            let expected: Vec<f64> = (1..=n).map(|i| (2.0 * phase * i as f64).sin()).collect();
            let last = mode.shape[n - 1][0] / expected[n - 1];
            for (i, entry) in mode.shape.iter().enumerate() {
                // Proportional damping: real shapes.
                assert!((entry[0] - last * expected[i]).abs() < 1e-8 && entry[1].abs() < 1e-8, "{k} {i} {entry:?}");
            }
        }
    }

    /// Truth: masses 1e12 apart in frequency: sqrt(1) and sqrt(1e12) rad/s (weakly coupled, so to
    /// 1e-12 relative). The low one keeps its digits.
    #[test]
    fn low_frequencies_are_accurate_beside_high_ones() {
        let mut pair = SpringChain::uniform(2, 1.0, 1.0, 0.0);
        pair.stiffness = vec![2.0, 1e12];
        let found = of(&mut pair, vec![0.0; 2]);
        // Both masses on the soft spring: w^2 = 2 / 2.
        let w = found.modes[0].undamped_frequency() * std::f64::consts::TAU;
        // The matrix holds 1e12 + 2 with 1e-4 of rounding, which is all there is to know.
        assert!((w - 1.0).abs() < 1e-3, "{w}");
    }

    /// Truth: (s + w)^2 = 0 twice at critical damping; a double root is only known to the square
    /// root of rounding. Beyond it two real roots with the product w^2.
    #[test]
    fn critical_and_stronger_damping_give_real_roots() {
        let mut critical = SpringChain::uniform(1, 2.0, 2.0 * 9.0, 2.0 * 2.0 * 3.0);
        let found = of(&mut critical, vec![0.0]);
        for mode in &found.modes {
            assert!((mode.eigenvalue[0] + 3.0).abs() < 1e-5 && mode.eigenvalue[1].abs() < 1e-5, "{mode:?}");
            assert!((mode.damping_ratio() - 1.0).abs() < 1e-5);
        }
        let mut strong = SpringChain::uniform(1, 1.0, 4.0, 5.0);
        let found = of(&mut strong, vec![0.0]);
        let roots: Vec<f64> = found.modes.iter().map(|mode| mode.eigenvalue[0]).collect();
        assert!((roots[0] + 1.0).abs() < 1e-10 && (roots[1] + 4.0).abs() < 1e-10, "{roots:?}");
        assert!(found.modes.iter().all(|mode| !mode.pair));
    }

    /// Truth: a hanging pendulum swings with sqrt(g / l), and only sideways.
    #[test]
    fn a_pendulum_has_one_mode() {
        let mut pendulum = Pendulum { mass: 3.0, length: 0.5, gravity: 9.80665, scale: 1.0 };
        let found = of(&mut pendulum, vec![0.0, -0.5]);
        assert_eq!(found.freedoms, 1);
        assert_eq!(found.modes.len(), 1);
        let w = found.modes[0].eigenvalue[1];
        assert!((w / (9.80665f64 / 0.5).sqrt() - 1.0).abs() < 1e-10, "{w}");
        assert!(found.modes[0].shape[1][0].abs() < 1e-12);
    }

    /// Truth: two free masses on a spring have a rigid mode at zero and sqrt(2 k / m); a mass of
    /// zero adds no mode.
    #[test]
    fn rigid_modes_stay_and_massless_motions_give_none() {
        let mut free = SpringChain::uniform(2, 1.0, 50.0, 0.0);
        free.stiffness[0] = 0.0;
        let found = of(&mut free, vec![0.0; 2]);
        let w = |k: usize| found.modes[k].undamped_frequency() * std::f64::consts::TAU;
        assert!(w(0) < 1e-5, "{}", w(0));
        let elastic = found.modes.last().unwrap();
        assert!((elastic.eigenvalue[1] - 10.0).abs() < 1e-9, "{elastic:?}");
        let mut massless = SpringChain::uniform(2, 1.0, 100.0, 0.0);
        massless.mass[0] = 0.0;
        let state = SystemState::at_rest(&massless, 0.0, vec![0.0; 2]);
        let found = modes(&mut massless, &state, &ModeOptions::default()).unwrap();
        // Two springs in series under one mass.
        assert_eq!(found.modes.len(), 1, "{found:?}");
        assert!((found.modes[0].eigenvalue[1] - 50f64.sqrt()).abs() < 1e-9);
    }
}
