//! The socket between equations and solver.

/// Why an evaluation was impossible: a beam of zero length, a function outside its domain.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    pub message: String,
}

/// Block structure of the Newton matrix.
///
/// Unknowns are grouped in blocks (six increments of a rigid body, three of a point mass, the
/// multipliers of one constraint, the states of one element). A pair `(row, column)` is listed
/// where a non-zero block can occur; diagonal blocks are always present.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// Size of each block, in the order of the unknowns: first the velocity blocks, then the
    /// multiplier blocks.
    pub sizes: Vec<usize>,
    /// How many of the blocks belong to velocities; the rest are multipliers.
    pub velocity_blocks: usize,
    /// Off-diagonal block positions, symmetric in structure, without duplicates.
    pub pairs: Vec<(usize, usize)>,
}

/// Weights of the error norms, one for each velocity-level unknown.
#[derive(Clone, Debug, PartialEq)]
pub struct Scales {
    /// An increment of this size (SI, rad) weighs 1 in the norm.
    pub increments: Vec<f64>,
}

/// A second-order differential-algebraic system on a Lie group.
///
/// ```text
/// r(t, q, v, a, lambda) = M(q) a - Q(t, q, v) + B(t, q)^T lambda = 0
/// Phi(t, q) = 0,     B = dPhi / d(increment)
/// q' = q o exp(increment)
/// ```
///
/// Positions `q` are opaque to the solver (quaternions inside); `v`, `a` and increments have
/// `velocities()` entries; multipliers have `constraints()` entries. All in SI.
pub trait Dae {
    fn positions(&self) -> usize;
    fn velocities(&self) -> usize;
    fn constraints(&self) -> usize;
    fn pattern(&self) -> Pattern;

    /// Structure of the matrix without stiffness and damping: masses and constraints. The fewer
    /// blocks it has, the less consistent accelerations cost.
    fn mass_pattern(&self) -> Pattern {
        self.pattern()
    }

    /// Weights of the errors of integration.
    fn scales(&self) -> Scales;

    /// The unit that an increment of each velocity-level unknown is measured in by assembly and
    /// statics: 1 model length unit (in SI) or 1 rad.
    fn units(&self) -> Scales {
        self.scales()
    }

    /// True when accelerations and multipliers are in `r` as `M a + B^T lambda` and nowhere else:
    /// consistent ones are then found without iterating.
    fn is_linear_in_accelerations(&self) -> bool {
        false
    }

    /// True when `M` is the same in all states: without constraints it is then factored once.
    fn mass_is_constant(&self) -> bool {
        false
    }

    /// `out = q o exp(increment)`. `out` and `q` may not alias.
    fn retract(&self, q: &[f64], increment: &[f64], out: &mut [f64]);

    /// `out` such that `q1 = q0 o exp(out)`; the inverse of [`Dae::retract`].
    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]);

    /// Residual `r`; gyroscopic terms are part of `-Q`.
    fn residual(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        lambda: &[f64],
        r: &mut [f64],
    ) -> Result<(), Evaluation>;

    /// Constraint residual `Phi(t, q)`.
    fn constraint_residual(&mut self, t: f64, q: &[f64], phi: &mut [f64]) -> Result<(), Evaluation>;

    /// `Phi_t`, so that `B v + Phi_t = 0` for consistent velocities.
    fn constraint_velocity(&mut self, t: f64, q: &[f64], phi_t: &mut [f64]) -> Result<(), Evaluation>;

    /// `gamma`, so that `B a + gamma = 0` for consistent accelerations.
    fn constraint_acceleration(&mut self, t: f64, q: &[f64], v: &[f64], gamma: &mut [f64]) -> Result<(), Evaluation>;

    /// Adds the blocks of the Newton matrix to `add(row_block, column_block, values)`, values
    /// column-major:
    ///
    /// ```text
    /// [ mass * M + damping * C + stiffness * K     B^T ]        K = dr/d(increment), C = dr/dv
    /// [ B                                           0  ]
    /// ```
    ///
    /// `K` includes the derivative of `B^T lambda` and of `M a`. With `damping` and
    /// `stiffness` zero only `M` and `B` are wanted: that happens once per accepted step of a
    /// constrained system, so loads should then not be differentiated. Adding blocks in the same
    /// order every time is the fastest.
    fn jacobian(&mut self, at: JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) -> Result<(), Evaluation>;

    /// True for the velocity-level unknowns that are rotations (rad): statics limits their steps
    /// by an angle and those of the others by a length.
    fn is_rotation(&self, velocity: usize) -> bool {
        let _ = velocity;
        false
    }

    /// The problem itself, for an observer that knows what it is.
    fn as_any(&mut self) -> Option<&mut dyn std::any::Any> {
        None
    }

    /// Name of the unknown or equation, for messages: `.model.part translation x`,
    /// `.model.JOINT_1 Zi.Xj`. Unknowns are counted through velocities, then multipliers.
    fn describe(&self, unknown: usize) -> String;
}

/// Where and with which factors a Jacobian is wanted.
#[derive(Clone, Copy, Debug)]
pub struct JacobianPoint<'a> {
    pub t: f64,
    pub q: &'a [f64],
    pub v: &'a [f64],
    pub a: &'a [f64],
    pub lambda: &'a [f64],
    pub mass: f64,
    pub damping: f64,
    pub stiffness: f64,
}
