//! What an element plugs into: `Force` for loads, `Constraint` for equations.
//!
//! Increments of a body are `[dr | dtheta]`: translation of the centre of mass in ground axes, then
//! rotation in **body** axes (`R <- R exp(dtheta x)`). Velocities are `[v | w]` likewise: ground,
//! then body axes. Generalised loads match: force in ground axes, torque about the centre of mass
//! in body axes. Implementations of the accumulators do the arithmetic; elements work with frames.

use std::sync::Arc;

use glam::{DMat3, DVec3};
use solver::Evaluation;

use crate::{BodyId, FrameId, Gradient, LoadCotangent, State};

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

/// What goes through a member between its two markers: at a cut, the load that the piece on the side
/// of I exerts on the piece on the side of J. In the axes of the member's section, x along it.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Inside {
    /// Axial force (tension positive) and shear forces, N; the same at every cut.
    pub force: DVec3,
    /// Torque and bending moments where the member meets J, N m: the load on J.
    pub moment_j: DVec3,
    /// The same where it meets I: minus the load on I.
    pub moment_i: DVec3,
    /// The largest rotation that the member's law sees, rad.
    pub angle: f64,
}

impl Inside {
    /// Torque and bending moments at the point that lies a share `station` of the straight line from J
    /// (0) to I (1) along.
    pub fn moment(&self, station: f64) -> DVec3 {
        self.moment_j * (1.0 - station) + self.moment_i * station
    }
}

/// An element with sections between its markers.
pub trait Member {
    fn inside(&self, state: &State) -> Inside;
}

/// An element whose load depends on positions and velocities of its two markers and on nothing else,
/// so that functions can ask for it.
pub trait LoadOfState {
    /// Adds the derivative of a number that depends on the load at a side.
    fn add_load_gradient(&self, state: &State, side: Side, of: &LoadCotangent, gradient: &mut Gradient);
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
    /// Power that damping takes, W; zero for elements without damping.
    fn dissipation(&self, _state: &State) -> f64 {
        0.0
    }
    /// What goes through the element, if it has sections.
    fn member(&self) -> Option<&dyn Member> {
        None
    }
    /// The load with its derivative, if it follows from the motion of the two markers alone.
    fn load_of_state(&self) -> Option<&dyn LoadOfState> {
        None
    }
    /// A trouble with the present state (angles beyond validity, ...); asked at each output.
    fn concern(&self, _state: &State) -> Option<Concern> {
        None
    }
}

/// A force that others read while it acts.
impl Force for Arc<dyn Force> {
    fn name(&self) -> &str {
        self.as_ref().name()
    }

    fn bodies(&self) -> Vec<BodyId> {
        self.as_ref().bodies()
    }

    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation> {
        self.as_ref().add_loads(state, loads)
    }

    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation> {
        self.as_ref().add_tangent(state, tangent)
    }

    fn load_at(&self, state: &State, side: Side) -> FrameLoad {
        self.as_ref().load_at(state, side)
    }

    fn frame(&self, side: Side) -> Option<FrameId> {
        self.as_ref().frame(side)
    }

    fn energy(&self, state: &State) -> f64 {
        self.as_ref().energy(state)
    }

    fn dissipation(&self, state: &State) -> f64 {
        self.as_ref().dissipation(state)
    }

    fn member(&self) -> Option<&dyn Member> {
        self.as_ref().member()
    }

    fn load_of_state(&self) -> Option<&dyn LoadOfState> {
        self.as_ref().load_of_state()
    }

    fn concern(&self, state: &State) -> Option<Concern> {
        self.as_ref().concern(state)
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
