//! What an element plugs into: `Force` for loads, `Constraint` for equations.
//!
//! Increments of a body are `[dr | dtheta]`: translation of the centre of mass in ground axes, then
//! rotation in **body** axes (`R <- R exp(dtheta x)`). Velocities are `[v | w]` likewise: ground,
//! then body axes. Generalised loads match: force in ground axes, torque about the centre of mass
//! in body axes. Implementations of the accumulators do the arithmetic; elements work with frames.

use glam::{DMat3, DVec3};
use solver::Evaluation;

use crate::{BodyId, FrameId, State};

/// Force and torque at a frame's origin on the frame's body, ground axes.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct FrameLoad {
    pub f_g: DVec3,
    pub t_g: DVec3,
}

/// Which end of a two-marker element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    I,
    J,
}

/// Accumulator of generalised loads on bodies.
pub trait Loads {
    /// Adds a load that acts at a frame's current origin.
    fn at_frame(&mut self, state: &State, frame: FrameId, load: FrameLoad);
    /// Adds a force (ground axes) at the centre of mass and a torque about it (ground axes).
    fn at_body(&mut self, state: &State, body: BodyId, f_g: DVec3, t_g: DVec3);
}

/// Accumulator of the derivative of generalised loads with respect to increments and velocities.
pub trait Tangent {
    /// Factor of d(load)/d(increment) wanted.
    fn stiffness(&self) -> f64;
    /// Factor of d(load)/d(velocity) wanted.
    fn damping(&self) -> f64;
    /// Adds `block` (6x6, row-major, row = component of the generalised load on `row`, column =
    /// increment of `column`): already multiplied by the factors. Blocks on ground are dropped.
    fn add(&mut self, row: BodyId, column: BodyId, block: &[[f64; 6]; 6]);
}

/// A trouble with the present state that the user should know.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Concern {
    /// What is wrong, to be read behind the element's name: `bent beyond what ... describes`.
    pub sentence: &'static str,
    /// How bad it is, in `unit`; grows with the trouble.
    pub size: f64,
    /// `degrees`, `mm`.
    pub unit: &'static str,
    /// How many elements in place of this one would be free of it, where that helps.
    pub pieces: Option<u32>,
}

/// An element that applies loads.
pub trait Force: Send + Sync {
    /// Full name in the model.
    fn name(&self) -> &str;
    /// Bodies whose motion the loads depend on or that are loaded, without ground.
    fn bodies(&self) -> Vec<BodyId>;
    /// Adds the loads on all bodies.
    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation>;
    /// Adds the derivative of what [`Force::add_loads`] adds.
    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation>;
    /// The load this element applies at its I or J marker's origin, for requests.
    fn load_at(&self, state: &State, side: Side) -> FrameLoad;
    /// The marker of a side, if the element acts at a marker there.
    fn frame(&self, side: Side) -> Option<FrameId>;
    /// Elastic energy stored, J; zero for elements without potential.
    fn energy(&self, _state: &State) -> f64 {
        0.0
    }
    /// A trouble with the present state (angles beyond validity, ...); asked at each output.
    fn concern(&self, _state: &State) -> Option<Concern> {
        None
    }
}

/// Rows of a constraint's Jacobian: `rows x 6` per body, row-major, increments as above.
#[derive(Clone, Debug, Default)]
pub struct ConstraintRows {
    /// For each body (without ground) its block: one `[f64; 6]` for each equation.
    pub blocks: Vec<(BodyId, Vec<[f64; 6]>)>,
}

impl ConstraintRows {
    /// Zero rows for a constraint, in the shape that [`Constraint::jacobian`] is given.
    pub fn for_constraint(constraint: &dyn Constraint) -> Self {
        let equations = constraint.equations();
        Self { blocks: constraint.bodies().into_iter().map(|body| (body, vec![[0.0; 6]; equations])).collect() }
    }

    pub fn clear(&mut self) {
        for (_, rows) in &mut self.blocks {
            rows.fill([0.0; 6]);
        }
    }

    /// Adds to the row of an equation; what concerns ground is dropped.
    pub fn add(&mut self, body: BodyId, equation: usize, values: &[f64; 6]) {
        for (owner, rows) in &mut self.blocks {
            if *owner == body {
                if let Some(row) = rows.get_mut(equation) {
                    for (sum, value) in row.iter_mut().zip(values) {
                        *sum += value;
                    }
                }
                return;
            }
        }
        debug_assert!(body == crate::GROUND, "a constraint has a row for a body it did not announce");
    }
}

/// An element that adds equations `Phi(t, q) = 0`.
pub trait Constraint: Send + Sync {
    fn name(&self) -> &str;
    /// What the element is called in reports: `Revolute Joint`, `Motion`.
    fn kind(&self) -> &'static str;
    /// Number of equations.
    fn equations(&self) -> usize;
    /// Name of an equation as Adams prints it: `Zi.Xj`, `Xi.Yj`, `X`, ...; and in words:
    /// `Rotation Between Zi & Xj`, `Translation Along Xj`.
    fn equation_name(&self, equation: usize) -> (String, String);
    fn bodies(&self) -> Vec<BodyId>;
    fn residual(&self, state: &State, phi: &mut [f64]) -> Result<(), Evaluation>;
    /// `B`, with exactly the blocks of [`Constraint::bodies`] in that order. `rows` comes with
    /// these blocks, [`Constraint::equations`] rows each, all zero.
    fn jacobian(&self, state: &State, rows: &mut ConstraintRows) -> Result<(), Evaluation>;
    /// `Phi_t`: zero unless the constraint is driven.
    fn velocity(&self, _state: &State, phi_t: &mut [f64]) {
        phi_t.fill(0.0);
    }
    /// `gamma` with `B a + gamma = 0`.
    fn acceleration(&self, state: &State, gamma: &mut [f64]) -> Result<(), Evaluation>;
    /// Adds the derivative of `-B^T lambda` (the generalised load of the constraint) with respect
    /// to increments.
    fn add_tangent(&self, state: &State, lambda: &[f64], tangent: &mut dyn Tangent);
    /// Load on the body of the I or J marker, at that marker's origin, from multipliers.
    fn load_at(&self, state: &State, lambda: &[f64], side: Side) -> FrameLoad;
    fn frame(&self, side: Side) -> Option<FrameId>;
    /// Troubles with the present state, as in [`Force::concern`]: axes that point opposite ways.
    fn concern(&self, _state: &State) -> Option<Concern> {
        None
    }
}

/// Skew matrix: `skew(a) * b = a x b`.
pub fn skew(a: DVec3) -> DMat3 {
    DMat3::from_cols(DVec3::new(0.0, a.z, -a.y), DVec3::new(-a.z, 0.0, a.x), DVec3::new(a.y, -a.x, 0.0))
}
