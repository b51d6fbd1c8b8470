//! Bodies, frames on them, and where everything is.

use glam::{DMat3, DQuat, DVec3};

/// Index of a body in [`State::bodies`]; [`GROUND`] is none of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId(pub u32);

/// The body that does not move.
pub const GROUND: BodyId = BodyId(u32::MAX);

/// Index of a frame (marker).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FrameId(pub u32);

/// One axis of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    pub fn index(self) -> usize {
        match self {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        }
    }

    /// `X`, `Y` or `Z`.
    pub fn letter(self) -> char {
        match self {
            Axis::X => 'X',
            Axis::Y => 'Y',
            Axis::Z => 'Z',
        }
    }
}

/// A rigid part or a point mass. The body frame has its origin at the centre of mass.
#[derive(Clone, Debug)]
pub struct Body {
    /// Full name in the model, for messages.
    pub name: String,
    pub mass: f64,
    /// Inertia about the centre of mass in body axes, kg m^2. Zero for a point mass.
    pub inertia_c_b: DMat3,
    /// A point mass has three translations and keeps its orientation.
    pub point_mass: bool,
    /// Position of the centre of mass, orientation, velocity of the centre of mass (ground axes)
    /// and angular velocity (body axes) when the simulation starts.
    pub initial: BodyMotion,
    /// Components of the initial position (x y z, then rotations) that assembly should keep.
    pub exact: [bool; 6],
}

/// Where a body is and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMotion {
    /// Position of the centre of mass, ground axes.
    pub r_gb_g: DVec3,
    pub q_gb: DQuat,
    /// Velocity of the centre of mass, ground axes.
    pub v_gb_g: DVec3,
    /// Angular velocity, body axes.
    pub w_gb_b: DVec3,
    /// Acceleration of the centre of mass, ground axes. Zero where it is not known.
    pub a_gb_g: DVec3,
    /// Angular acceleration, body axes.
    pub alpha_gb_b: DVec3,
}

/// A marker: a frame fixed on a body.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Full name in the model, for messages.
    pub name: String,
    pub body: BodyId,
    /// Position from the body's centre of mass (from the origin for ground), body axes.
    pub r_bi_b: DVec3,
    /// Takes components in the marker to components in the body frame.
    pub rot_bi: DMat3,
}

/// Position and motion of a frame, all in ground axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMotion {
    pub body: BodyId,
    /// Arm from the body's centre of mass to the frame, ground axes.
    pub r_bi_g: DVec3,
    pub r_gi_g: DVec3,
    /// Columns are the axes of the frame.
    pub rot_gi: DMat3,
    pub v_gi_g: DVec3,
    pub w_gi_g: DVec3,
    pub a_gi_g: DVec3,
    pub alpha_gi_g: DVec3,
}

impl FrameMotion {
    /// Unit vector of one of the frame's axes, ground axes.
    pub fn axis(&self, axis: Axis) -> DVec3 {
        self.rot_gi.col(axis.index())
    }

    /// The ground frame: at rest at the origin.
    pub const GLOBAL: FrameMotion = FrameMotion {
        body: GROUND,
        r_bi_g: DVec3::ZERO,
        r_gi_g: DVec3::ZERO,
        rot_gi: DMat3::IDENTITY,
        v_gi_g: DVec3::ZERO,
        w_gi_g: DVec3::ZERO,
        a_gi_g: DVec3::ZERO,
        alpha_gi_g: DVec3::ZERO,
    };
}

/// Everything elements may look at during one evaluation. Built by the pipeline before elements
/// are asked; indexing is all it takes.
#[derive(Clone, Debug, Default)]
pub struct State {
    pub time: f64,
    pub bodies: Vec<BodyMotion>,
    /// Rotation matrix of each body, body to ground.
    pub rotations: Vec<DMat3>,
    /// Motion of every frame.
    pub frames: Vec<FrameMotion>,
    /// True in a static analysis: velocities are zero.
    pub statics: bool,
}

impl State {
    pub fn frame(&self, id: FrameId) -> &FrameMotion {
        &self.frames[id.0 as usize]
    }

    pub fn body(&self, id: BodyId) -> Option<&BodyMotion> {
        self.bodies.get(id.0 as usize)
    }

    /// Motion of a frame, of the ground frame if none is given.
    pub fn frame_or_global(&self, id: Option<FrameId>) -> &FrameMotion {
        id.map_or(&FrameMotion::GLOBAL, |id| self.frame(id))
    }

    /// Rotation matrix of a body, body to ground; identity for ground.
    pub fn rotation(&self, id: BodyId) -> DMat3 {
        self.rotations.get(id.0 as usize).copied().unwrap_or(DMat3::IDENTITY)
    }
}
