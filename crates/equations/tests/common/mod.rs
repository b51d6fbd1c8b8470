//! What the tests of this room share: reproducible numbers, a scene, derivatives by differences.
#![allow(dead_code)] // each test file uses a part

use equations::{
    Axis, Body, BodyId, BodyMotion, Force, Frame, FrameId, FrameLoad, Loads, ScalarAction, Side, State, Tangent,
    apply_between, apply_scalar, measures, relative, tangent_between, tangent_scalar,
};
use glam::{DMat3, DQuat, DVec3};
use solver::{Dae, Evaluation};

/// SplitMix64: the same numbers on every machine.
pub struct Random(pub u64);

impl Random {
    /// Uniform in (-1, 1).
    pub fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    pub fn rotation(&mut self) -> DQuat {
        DQuat::from_xyzw(self.number(), self.number(), self.number(), self.number()).normalize()
    }

    pub fn numbers(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.number()).collect()
    }
}

pub fn body(name: &str, random: &mut Random, point_mass: bool) -> Body {
    let axes = DMat3::from_quat(random.rotation());
    let inertia = axes * DMat3::from_diagonal(DVec3::new(0.7, 1.1, 1.6)) * axes.transpose();
    Body {
        name: name.into(),
        mass: 2.5,
        inertia_c_b: if point_mass { DMat3::ZERO } else { inertia },
        point_mass,
        initial: motion(random.vector(), random.rotation(), random.vector(), random.vector()),
        exact: [false; 6],
    }
}

pub fn motion(r: DVec3, q: DQuat, v: DVec3, w: DVec3) -> BodyMotion {
    BodyMotion { r_gb_g: r, q_gb: q, v_gb_g: v, w_gb_b: w, a_gb_g: DVec3::ZERO, alpha_gb_b: DVec3::ZERO }
}

pub fn frame(name: &str, body: BodyId, random: &mut Random) -> Frame {
    Frame { name: name.into(), body, r_bi_b: random.vector(), rot_bi: DMat3::from_quat(random.rotation()) }
}

/// Derivative of a vector function at 0 in one direction, by the central difference of sixth
/// order. Step 4e-4: rounding about 1e-16 / h = 3e-13 of the value, truncation h^6 = 4e-21 of the
/// seventh derivative, which angles near their singular pose drive up; tests allow [`FLOOR`].
pub fn slope(mut f: impl FnMut(f64) -> Vec<f64>) -> Vec<f64> {
    const H: f64 = 4e-4;
    let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
    let mut sum: Vec<f64> = Vec::new();
    for (steps, weight) in weights {
        let (ahead, behind) = (f(steps * H), f(-steps * H));
        sum.resize(ahead.len(), 0.0);
        for ((sum, ahead), behind) in sum.iter_mut().zip(ahead).zip(behind) {
            *sum += weight * (ahead - behind) / (60.0 * H);
        }
    }
    sum
}

/// What [`slope`] may be wrong by, for values up to 100 and seventh derivatives up to 1e11.
pub const FLOOR: f64 = 2e-9;

pub fn assert_all_close(got: &[f64], wanted: &[f64], tolerance: f64, what: &str) {
    assert_eq!(got.len(), wanted.len(), "{what}: lengths");
    let scale = wanted.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
    for (at, (got, wanted)) in got.iter().zip(wanted).enumerate() {
        assert!((got - wanted).abs() <= tolerance * scale, "{what} [{at}]: {got} is not {wanted}");
    }
}

/// The Newton matrix as rows.
pub fn dense(system: &mut impl Dae, at: solver::JacobianPoint<'_>) -> Vec<Vec<f64>> {
    let pattern = system.pattern();
    let mut offsets = vec![0];
    for size in &pattern.sizes {
        offsets.push(offsets.last().unwrap() + size);
    }
    let total = *offsets.last().unwrap();
    let mut matrix = vec![vec![0.0; total]; total];
    system
        .jacobian(at, &mut |row, column, values| {
            assert!(
                row == column || pattern.pairs.contains(&(row, column)),
                "block {row},{column} is not in the pattern"
            );
            assert_eq!(values.len(), pattern.sizes[row] * pattern.sizes[column]);
            for (k, value) in values.iter().enumerate() {
                matrix[offsets[row] + k % pattern.sizes[row]][offsets[column] + k / pattern.sizes[row]] += value;
            }
        })
        .unwrap();
    matrix
}

/// A test force between two frames: a full linear law with cross terms, plus a nonlinear axial
/// part along the line and a torque about z of J that depends on the velocity.
pub struct Coupling {
    pub i: FrameId,
    pub j: FrameId,
    pub bodies: Vec<BodyId>,
    pub stiffness: [[f64; 6]; 6],
    pub damping: [[f64; 6]; 6],
    pub with_reaction: bool,
}

impl Coupling {
    pub fn new(frames: &[Frame], i: FrameId, j: FrameId, random: &mut Random) -> Self {
        let mut matrix = || std::array::from_fn(|_| std::array::from_fn(|_| random.number()));
        let (stiffness, damping) = (matrix(), matrix());
        let mut bodies: Vec<_> = [i, j].map(|frame| frames[frame.0 as usize].body).to_vec();
        bodies.retain(|body| *body != equations::GROUND);
        bodies.dedup();
        Self { i, j, bodies, stiffness, damping, with_reaction: true }
    }

    /// `F = -K [d | sin-like angles] - C [V | W]`: the angles are the three off-diagonal entries
    /// of the rotation, so their derivative is simple and exact.
    fn law(&self, state: &State) -> ([f64; 6], [[f64; 6]; 6]) {
        let x = relative(state, self.i, self.j);
        let (d, v, w) = (x.d_ji_j, x.v_ji_j, x.w_ji_j);
        let (cx, cy, cz) = (x.rot_ji.x_axis, x.rot_ji.y_axis, x.rot_ji.z_axis);
        // R32, R13, R21 and the derivative for a spin psi: dR = psi x columns
        let angles = [cy.z, cz.x, cx.y];
        let spin = [[cy.y, -cy.x, 0.0], [0.0, cz.z, -cz.y], [-cx.z, 0.0, cx.x]];
        let q = [d.x, d.y, d.z, angles[0], angles[1], angles[2]];
        let qdot = [v.x, v.y, v.z, w.x, w.y, w.z];
        let load = std::array::from_fn(|r| {
            -(0..6).map(|c| self.stiffness[r][c] * q[c] + self.damping[r][c] * qdot[c]).sum::<f64>()
        });
        let by_displacement = std::array::from_fn(|r| {
            std::array::from_fn(|c| {
                if c < 3 {
                    -self.stiffness[r][c]
                } else {
                    -(0..3).map(|k| self.stiffness[r][3 + k] * spin[k][c - 3]).sum::<f64>()
                }
            })
        });
        (load, by_displacement)
    }

    fn scalars(&self, state: &State, gradient: Option<&mut equations::Gradient>) -> (f64, f64, equations::Gradient) {
        let mut radial = equations::Gradient::new();
        let length = measures::distance(state, self.i, Some(self.j), gradient);
        let rate = measures::radial_velocity(state, self.i, Some(self.j), None, Some(&mut radial));
        (length * length + 0.3 * rate, 2.0 * length, radial)
    }
}

impl Force for Coupling {
    fn name(&self) -> &'static str {
        ".m.coupling"
    }

    fn bodies(&self) -> Vec<BodyId> {
        self.bodies.clone()
    }

    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation> {
        apply_between(state, self.i, self.j, &self.law(state).0, loads);
        let (value, ..) = self.scalars(state, None);
        apply_scalar(state, self.i, self.j, ScalarAction::Line, self.with_reaction, value, loads);
        let w = measures::angular_velocity(state, Axis::Z, self.i, Some(self.j), Some(self.j), None);
        apply_scalar(state, self.i, self.j, ScalarAction::Torque(Axis::Z), self.with_reaction, -0.7 * w, loads);
        Ok(())
    }

    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation> {
        let (load, by_displacement) = self.law(state);
        let by_velocity = self.damping.map(|row| row.map(|value| -value));
        tangent_between(state, self.i, self.j, &load, &by_displacement, &by_velocity, tangent);
        let mut length = equations::Gradient::new();
        let (value, factor, radial) = self.scalars(state, Some(&mut length));
        let mut gradient = equations::Gradient::new();
        gradient.add_scaled(factor, &length);
        gradient.add_scaled(0.3, &radial);
        let (i, j, reaction) = (self.i, self.j, self.with_reaction);
        tangent_scalar(state, i, j, ScalarAction::Line, reaction, value, &gradient, tangent);
        let mut spin = equations::Gradient::new();
        let w = measures::angular_velocity(state, Axis::Z, i, Some(j), Some(j), Some(&mut spin));
        gradient.clear();
        gradient.add_scaled(-0.7, &spin);
        tangent_scalar(state, i, j, ScalarAction::Torque(Axis::Z), reaction, -0.7 * w, &gradient, tangent);
        Ok(())
    }

    fn load_at(&self, _state: &State, _side: Side) -> FrameLoad {
        FrameLoad::default()
    }

    fn frame(&self, side: Side) -> Option<FrameId> {
        Some(if side == Side::I { self.i } else { self.j })
    }
}
