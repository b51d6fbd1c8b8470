//! The equations of motion of all bodies: what the solver solves.

use glam::DVec3;
use solver::Evaluation;

use crate::accumulators::BodyLoads;
use crate::layout::Layout;
use crate::motion::{self, put, put_quaternion};
use crate::{Body, BodyId, Constraint, ConstraintRows, Force, Frame, FrameId, FrameLoad, GROUND, Side, State};

/// One row of the constraint Jacobian, for the search of redundant equations.
#[derive(Clone, Debug, PartialEq)]
pub struct EquationRow {
    pub constraint: usize,
    pub equation: usize,
    pub active: bool,
    /// Value of the equation.
    pub phi: f64,
    /// Non-zero entries: index of the velocity unknown, value.
    pub entries: Vec<(usize, f64)>,
}

/// Bodies, frames, forces and constraints as a differential-algebraic system.
///
/// Positions are `[r | quaternion w x y z]` of each body (three numbers for a point mass),
/// velocities `[v_g | w_b]`, then one multiplier for each active equation.
pub struct System {
    pub(crate) bodies: Vec<Body>,
    pub(crate) frames: Vec<Frame>,
    pub(crate) forces: Vec<Box<dyn Force>>,
    pub(crate) constraints: Vec<Box<dyn Constraint>>,
    pub(crate) gravity_g: DVec3,
    pub(crate) load_factor: f64,
    pub(crate) length_unit: f64,
    /// Characteristic size at the start, m; see [`System::size`].
    pub(crate) size: f64,
    pub(crate) layout: Layout,
    pub(crate) state: State,
    pub(crate) cache: Cache,
    pub(crate) loads: BodyLoads,
    pub(crate) rows: Vec<ConstraintRows>,
    /// As long as the largest constraint has equations.
    pub(crate) scratch: Vec<f64>,
    /// As long as the largest block of constraint rows.
    pub(crate) block: Vec<f64>,
}

/// What the state was computed from.
#[derive(Default)]
pub(crate) struct Cache {
    q: Vec<f64>,
    v: Vec<f64>,
    placed: bool,
    moving: bool,
    accelerated: bool,
}

impl System {
    /// Fails if a frame or an element names a body that is not there.
    pub fn new(
        bodies: Vec<Body>,
        frames: Vec<Frame>,
        forces: Vec<Box<dyn Force>>,
        constraints: Vec<Box<dyn Constraint>>,
        gravity_g: DVec3,
    ) -> Result<Self, Evaluation> {
        let missing = |body: BodyId| body != GROUND && body.0 as usize >= bodies.len();
        let on_nothing = frames.iter().find(|frame| missing(frame.body)).map(|frame| frame.name.clone());
        let on_nothing = on_nothing.or_else(|| {
            let forces =
                forces.iter().map(|force| (force.name(), force.bodies(), [Side::I, Side::J].map(|s| force.frame(s))));
            let constraints =
                constraints.iter().map(|c| (c.name(), c.bodies(), [Side::I, Side::J].map(|s| c.frame(s))));
            let lost = |frame: &Option<FrameId>| frame.is_some_and(|frame| frame.0 as usize >= frames.len());
            let wrong = |(_, bodies, ends): &(&str, Vec<BodyId>, [Option<FrameId>; 2])| {
                bodies.iter().any(|&body| body == GROUND || missing(body)) || ends.iter().any(lost)
            };
            forces.chain(constraints).find(wrong).map(|(name, ..)| name.to_string())
        });
        if let Some(name) = on_nothing {
            return Err(Evaluation {
                message: format!("`{name}` refers to a body or marker that is not in the system"),
            });
        }
        let size = characteristic_size(&bodies, &frames, &forces, &constraints);
        let layout = Layout::new(&bodies, &constraints);
        let rows: Vec<_> = constraints.iter().map(|c| ConstraintRows::for_constraint(c.as_ref())).collect();
        let most = constraints.iter().map(|c| c.equations()).max().unwrap_or(0);
        let state = motion::new_state(&bodies, &frames);
        let cache = Cache { q: vec![0.0; layout.positions], v: vec![0.0; layout.velocities], ..Cache::default() };
        let loads = BodyLoads { loads: vec![[DVec3::ZERO; 2]; bodies.len()] };
        Ok(Self {
            bodies,
            frames,
            forces,
            constraints,
            gravity_g,
            load_factor: 1.0,
            length_unit: 1.0,
            size,
            layout,
            state,
            cache,
            loads,
            rows,
            scratch: vec![0.0; most],
            block: vec![0.0; 6 * most],
        })
    }

    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    pub fn force_list(&self) -> &[Box<dyn Force>] {
        &self.forces
    }

    pub fn constraint_list(&self) -> &[Box<dyn Constraint>] {
        &self.constraints
    }

    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    pub fn gravity_g(&self) -> DVec3 {
        self.gravity_g
    }

    /// Position and velocity vectors of the bodies' initial motion.
    pub fn initial_state(&self) -> (Vec<f64>, Vec<f64>) {
        let (mut q, mut v) = (vec![0.0; self.layout.positions], vec![0.0; self.layout.velocities]);
        for (body, slot) in self.bodies.iter().zip(&self.layout.bodies) {
            put(body.initial.r_gb_g, &mut q, slot.position);
            put(body.initial.v_gb_g, &mut v, slot.velocity);
            if slot.size == 6 {
                put_quaternion(body.initial.q_gb.normalize(), &mut q, slot);
                put(body.initial.w_gb_b, &mut v, slot.velocity + 3);
            }
        }
        (q, v)
    }

    /// Which velocity-level unknowns are exact in assembly: `EXACT` components of each body.
    pub fn exact(&self) -> Vec<bool> {
        let components = |(body, slot): (&Body, &crate::layout::BodySlot)| body.exact[..slot.size].to_vec();
        self.bodies.iter().zip(&self.layout.bodies).flat_map(components).collect()
    }

    /// Factor on forces and gravity, 1 unless loads are stepped.
    pub fn set_load_factor(&mut self, factor: f64) {
        self.load_factor = factor;
    }

    /// Largest distance, at the start, from the centroid of the bodies' centres of mass to a centre
    /// of mass or a marker on a body or under an element, m. It does not change when the model is
    /// moved or turned as a whole.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Length of the model's unit in metres: assembly and statics measure translations in it, and
    /// integration does where the model is smaller than one unit.
    pub fn set_length_unit(&mut self, metres: f64) {
        self.length_unit = metres;
    }

    /// In statics velocities are taken as zero, whatever the solver passes.
    pub fn set_statics(&mut self, statics: bool) {
        self.state.statics = statics;
        self.cache.moving = false;
    }

    /// Switches an equation of a constraint on or off. The layout of the multipliers and the
    /// pattern change.
    pub fn set_active(&mut self, constraint: usize, equation: usize, active: bool) {
        self.layout.set_active(constraint, equation, active);
    }

    /// Positions, velocities and, if `a` is given, accelerations of all bodies and frames.
    pub fn state(&mut self, t: f64, q: &[f64], v: &[f64], a: Option<&[f64]>) -> &State {
        self.update(t, q, Some(v));
        if a.is_some() || self.cache.accelerated {
            let a = if self.state.statics { None } else { a };
            motion::set_accelerations(&mut self.state, &self.layout, a);
            self.cache.accelerated = a.is_some();
        }
        &self.state
    }

    /// The state last computed, for what is read from a shared system.
    pub fn last_state(&self) -> &State {
        &self.state
    }

    /// Brings the state to a time, positions and, where given, velocities.
    pub(crate) fn update(&mut self, t: f64, q: &[f64], v: Option<&[f64]>) {
        self.state.time = t;
        if !self.cache.placed || self.cache.q != q {
            motion::place(&mut self.state, &self.layout, &self.bodies, &self.frames, q);
            self.cache.q.copy_from_slice(q);
            (self.cache.placed, self.cache.moving) = (true, false);
        }
        let Some(v) = v else { return };
        if !self.cache.moving || self.cache.v != v {
            let moving = (!self.state.statics).then_some(v);
            motion::set_velocities(&mut self.state, &self.layout, moving);
            self.cache.v.copy_from_slice(v);
            self.cache.moving = true;
        }
    }

    /// All rows of the constraint Jacobian, inactive ones too, in order of constraints and
    /// equations.
    pub fn constraint_rows(&mut self, t: f64, q: &[f64]) -> Result<Vec<EquationRow>, Evaluation> {
        self.update(t, q, None);
        let mut found = Vec::new();
        for (at, constraint) in self.constraints.iter().enumerate() {
            let rows = &mut self.rows[at];
            rows.clear();
            constraint.jacobian(&self.state, rows)?;
            let phi = &mut self.scratch[..constraint.equations()];
            constraint.residual(&self.state, phi)?;
            for (equation, &phi) in phi.iter().enumerate() {
                let mut entries = Vec::new();
                for (body, rows) in &rows.blocks {
                    let slot = &self.layout.bodies[body.0 as usize];
                    let row = rows[equation][..slot.size].iter().enumerate();
                    entries
                        .extend(row.filter(|(_, value)| **value != 0.0).map(|(c, value)| (slot.velocity + c, *value)));
                }
                let active = self.layout.constraints[at].active[equation];
                found.push(EquationRow { constraint: at, equation, active, phi, entries });
            }
        }
        Ok(found)
    }

    /// Multipliers of one constraint, zero for inactive equations, from the solver's vector.
    pub fn multipliers(&self, constraint: usize, lambda: &[f64]) -> Vec<f64> {
        let slot = &self.layout.constraints[constraint];
        let mut full = vec![0.0; slot.active.len()];
        spread(slot, lambda, &mut full);
        full
    }

    /// Load of a constraint on the body of its I or J marker, at that marker's origin, in the
    /// state last computed.
    pub fn reaction(&self, constraint: usize, lambda: &[f64], side: Side) -> FrameLoad {
        let multipliers = self.multipliers(constraint, lambda);
        self.constraints[constraint].load_at(&self.state, &multipliers, side)
    }

    pub fn total_mass(&self) -> f64 {
        self.bodies.iter().map(|body| body.mass).sum()
    }

    /// Kinetic energy in the state last computed, J.
    pub fn kinetic_energy(&self) -> f64 {
        let energy = |(body, motion): (&Body, &crate::BodyMotion)| {
            let spin = if body.point_mass { 0.0 } else { motion.w_gb_b.dot(body.inertia_c_b * motion.w_gb_b) };
            0.5 * (body.mass * motion.v_gb_g.length_squared() + spin)
        };
        self.bodies.iter().zip(&self.state.bodies).map(energy).sum()
    }

    /// Potential energy of gravity in the state last computed, J; zero with all mass at the origin.
    pub fn potential_energy(&self) -> f64 {
        self.bodies.iter().zip(&self.state.bodies).map(|(b, m)| -b.mass * self.gravity_g.dot(m.r_gb_g)).sum()
    }

    /// Energy stored in elastic elements in the state last computed, J.
    pub fn elastic_energy(&self) -> f64 {
        self.forces.iter().map(|force| force.energy(&self.state)).sum()
    }

    /// Power that damping takes in the state last computed, W.
    pub fn dissipation(&self) -> f64 {
        self.forces.iter().map(|force| force.dissipation(&self.state)).sum()
    }

    /// Linear momentum, and angular momentum about the ground origin, ground axes.
    pub fn momentum(&self) -> (DVec3, DVec3) {
        let mut sum = (DVec3::ZERO, DVec3::ZERO);
        for ((body, motion), rot_gb) in self.bodies.iter().zip(&self.state.bodies).zip(&self.state.rotations) {
            let linear = body.mass * motion.v_gb_g;
            sum.0 += linear;
            sum.1 += motion.r_gb_g.cross(linear);
            if !body.point_mass {
                sum.1 += *rot_gb * (body.inertia_c_b * motion.w_gb_b);
            }
        }
        sum
    }
}

/// See [`System::size`].
fn characteristic_size(
    bodies: &[Body],
    frames: &[Frame],
    forces: &[Box<dyn Force>],
    constraints: &[Box<dyn Constraint>],
) -> f64 {
    let centroid = bodies.iter().map(|body| body.initial.r_gb_g).sum::<DVec3>() / bodies.len().max(1) as f64;
    let place = |frame: &Frame| match bodies.get(frame.body.0 as usize) {
        Some(body) => body.initial.r_gb_g + body.initial.q_gb.normalize() * frame.r_bi_b,
        None => frame.r_bi_b,
    };
    // Markers on ground that nothing acts on may be anywhere: views, construction.
    let ends = |sides: [Option<FrameId>; 2]| sides.into_iter().flatten();
    let used = forces.iter().flat_map(|force| ends([Side::I, Side::J].map(|side| force.frame(side))));
    let used = used.chain(constraints.iter().flat_map(|c| ends([Side::I, Side::J].map(|side| c.frame(side)))));
    let used = used.filter_map(|id| frames.get(id.0 as usize));
    let on_bodies = frames.iter().filter(|frame| frame.body != GROUND);
    let places = bodies.iter().map(|body| body.initial.r_gb_g).chain(used.chain(on_bodies).map(place));
    let size = places.map(|r| r.distance(centroid)).fold(0.0, f64::max);
    if size.is_finite() { size } else { 0.0 }
}

/// Multipliers of all equations of a constraint from those of the active ones.
pub(crate) fn spread(slot: &crate::layout::ConstraintSlot, lambda: &[f64], full: &mut [f64]) {
    full.fill(0.0);
    for (at, &equation) in slot.equations.iter().enumerate() {
        full[equation] = lambda[slot.multiplier + at];
    }
}
