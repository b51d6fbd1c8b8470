//! The equations of motion of all bodies: what the solver solves.

use glam::DVec3;
use solver::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

use crate::layout::Layout;
use crate::pipeline::{self, Blocks, BodyLoads, exponential, logarithm, put, put_quaternion, quaternion, vec3};
use crate::{Axis, Body, BodyId, Constraint, ConstraintRows, Force, Frame, FrameId, FrameLoad, GROUND, Side, State};

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
    bodies: Vec<Body>,
    frames: Vec<Frame>,
    forces: Vec<Box<dyn Force>>,
    constraints: Vec<Box<dyn Constraint>>,
    gravity_g: DVec3,
    load_factor: f64,
    length_unit: f64,
    layout: Layout,
    state: State,
    cache: Cache,
    loads: BodyLoads,
    rows: Vec<ConstraintRows>,
    /// As long as the largest constraint has equations.
    scratch: Vec<f64>,
    /// As long as the largest block of constraint rows.
    block: Vec<f64>,
}

/// What the state was computed from.
#[derive(Default)]
struct Cache {
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
        let layout = Layout::new(&bodies, &constraints);
        let rows: Vec<_> = constraints.iter().map(|c| ConstraintRows::for_constraint(c.as_ref())).collect();
        let most = constraints.iter().map(|c| c.equations()).max().unwrap_or(0);
        let state = pipeline::new_state(&bodies, &frames);
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

    /// Length of the model's unit in metres; sets the error norm.
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
            pipeline::set_accelerations(&mut self.state, &self.layout, a);
            self.cache.accelerated = a.is_some();
        }
        &self.state
    }

    fn update(&mut self, t: f64, q: &[f64], v: Option<&[f64]>) {
        self.state.time = t;
        if !self.cache.placed || self.cache.q != q {
            pipeline::place(&mut self.state, &self.layout, &self.bodies, &self.frames, q);
            self.cache.q.copy_from_slice(q);
            (self.cache.placed, self.cache.moving) = (true, false);
        }
        let Some(v) = v else { return };
        if !self.cache.moving || self.cache.v != v {
            let moving = (!self.state.statics).then_some(v);
            pipeline::set_velocities(&mut self.state, &self.layout, moving);
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

    /// Forces and gravity on all bodies, times the load factor.
    fn collect_loads(&mut self) -> Result<(), Evaluation> {
        for (load, body) in self.loads.loads.iter_mut().zip(&self.bodies) {
            *load = [body.mass * self.gravity_g, DVec3::ZERO];
        }
        for force in &self.forces {
            force.add_loads(&self.state, &mut self.loads)?;
        }
        Ok(())
    }

    /// Subtracts `B^T lambda`: adds it to the residual.
    fn add_reactions(&mut self, lambda: &[f64], r: &mut [f64]) -> Result<(), Evaluation> {
        for ((constraint, slot), rows) in self.constraints.iter().zip(&self.layout.constraints).zip(&mut self.rows) {
            if slot.block.is_none() {
                continue;
            }
            rows.clear();
            constraint.jacobian(&self.state, rows)?;
            for (body, rows) in &rows.blocks {
                let place = &self.layout.bodies[body.0 as usize];
                let sums = &mut r[place.velocity..place.velocity + place.size];
                for (at, &equation) in slot.equations.iter().enumerate() {
                    for (sum, value) in sums.iter_mut().zip(&rows[equation]) {
                        *sum += value * lambda[slot.multiplier + at];
                    }
                }
            }
        }
        Ok(())
    }

    /// Names what made the residual infinite or undefined.
    fn blame(&mut self, unknown: usize) -> Evaluation {
        for force in &self.forces {
            self.loads.loads.fill([DVec3::ZERO; 2]);
            let done = force.add_loads(&self.state, &mut self.loads);
            if done.is_err() || self.loads.loads.iter().flatten().any(|vector| !vector.is_finite()) {
                return Evaluation { message: format!("the load of `{}` is not a finite number", force.name()) };
            }
        }
        let equation = self.describe(unknown);
        Evaluation { message: format!("the equation of {equation} has no finite value") }
    }

    /// Runs one of the constraints' vector functions on the active equations.
    fn gather(
        &mut self,
        out: &mut [f64],
        evaluate: impl Fn(&dyn Constraint, &State, &mut [f64]) -> Result<(), Evaluation>,
    ) -> Result<(), Evaluation> {
        for (constraint, slot) in self.constraints.iter().zip(&self.layout.constraints) {
            let values = &mut self.scratch[..slot.active.len()];
            evaluate(constraint.as_ref(), &self.state, values)?;
            for (at, &equation) in slot.equations.iter().enumerate() {
                out[slot.multiplier + at] = values[equation];
            }
        }
        Ok(())
    }

    fn add_inertia(&self, at: &JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) {
        for (block, (body, slot)) in self.bodies.iter().zip(&self.layout.bodies).enumerate() {
            let mass = at.mass * body.mass;
            if slot.size == 3 {
                add(block, block, &[mass, 0.0, 0.0, 0.0, mass, 0.0, 0.0, 0.0, mass]);
                continue;
            }
            let inertia = body.inertia_c_b;
            let w = self.state.bodies[block].w_gb_b;
            // d(w x J w)/dw
            let gyroscopic = crate::skew(w) * inertia - crate::skew(inertia * w);
            let rotation = inertia * at.mass + gyroscopic * at.damping;
            let mut values = [0.0; 36];
            for c in 0..3 {
                values[7 * c] = mass;
                values[6 * (c + 3) + 3..6 * (c + 3) + 6].copy_from_slice(&rotation.col(c).to_array());
            }
            add(block, block, &values);
        }
    }

    fn add_constraints(
        &mut self,
        at: &JacobianPoint<'_>,
        add: &mut dyn FnMut(usize, usize, &[f64]),
    ) -> Result<(), Evaluation> {
        for ((constraint, slot), rows) in self.constraints.iter().zip(&self.layout.constraints).zip(&mut self.rows) {
            let Some(block) = slot.block else { continue };
            rows.clear();
            constraint.jacobian(&self.state, rows)?;
            let count = slot.equations.len();
            for (body, rows) in &rows.blocks {
                let body = body.0 as usize;
                let size = self.layout.bodies[body].size;
                let values = &mut self.block[..count * size];
                for (r, &equation) in slot.equations.iter().enumerate() {
                    for c in 0..size {
                        values[c * count + r] = rows[equation][c];
                    }
                }
                add(block, body, values);
                for (r, &equation) in slot.equations.iter().enumerate() {
                    values[r * size..(r + 1) * size].copy_from_slice(&rows[equation][..size]);
                }
                add(body, block, values);
            }
            let multipliers = &mut self.scratch[..slot.active.len()];
            spread(slot, at.lambda, multipliers);
            let mut tangent = Blocks { layout: &self.layout, stiffness: -at.stiffness, damping: 0.0, add: &mut *add };
            constraint.add_tangent(&self.state, multipliers, &mut tangent);
        }
        Ok(())
    }
}

/// Multipliers of all equations of a constraint from those of the active ones.
fn spread(slot: &crate::layout::ConstraintSlot, lambda: &[f64], full: &mut [f64]) {
    full.fill(0.0);
    for (at, &equation) in slot.equations.iter().enumerate() {
        full[equation] = lambda[slot.multiplier + at];
    }
}

impl Dae for System {
    fn positions(&self) -> usize {
        self.layout.positions
    }

    fn velocities(&self) -> usize {
        self.layout.velocities
    }

    fn constraints(&self) -> usize {
        self.layout.multipliers
    }

    fn pattern(&self) -> Pattern {
        self.layout.pattern(&self.forces, &self.constraints)
    }

    fn scales(&self) -> Scales {
        let mut increments = vec![1.0; self.layout.velocities];
        for slot in &self.layout.bodies {
            increments[slot.velocity..slot.velocity + 3].fill(self.length_unit);
        }
        Scales { increments }
    }

    fn retract(&self, q: &[f64], increment: &[f64], out: &mut [f64]) {
        for slot in &self.layout.bodies {
            put(vec3(q, slot.position) + vec3(increment, slot.velocity), out, slot.position);
            if slot.size == 6 {
                let turned = quaternion(q, slot) * exponential(vec3(increment, slot.velocity + 3));
                put_quaternion(turned.normalize(), out, slot);
            }
        }
    }

    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]) {
        for slot in &self.layout.bodies {
            put(vec3(q1, slot.position) - vec3(q0, slot.position), out, slot.velocity);
            if slot.size == 6 {
                let turn = quaternion(q0, slot).conjugate() * quaternion(q1, slot);
                put(logarithm(turn), out, slot.velocity + 3);
            }
        }
    }

    fn residual(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        lambda: &[f64],
        r: &mut [f64],
    ) -> Result<(), Evaluation> {
        self.update(t, q, Some(v));
        self.collect_loads()?;
        for (at, (body, slot)) in self.bodies.iter().zip(&self.layout.bodies).enumerate() {
            let [f_g, t_b] = self.loads.loads[at].map(|load| load * self.load_factor);
            put(body.mass * vec3(a, slot.velocity) - f_g, r, slot.velocity);
            if slot.size == 6 {
                let (w, inertia) = (self.state.bodies[at].w_gb_b, body.inertia_c_b);
                let rate = inertia * vec3(a, slot.velocity + 3) + w.cross(inertia * w);
                put(rate - t_b, r, slot.velocity + 3);
            }
        }
        self.add_reactions(lambda, r)?;
        match r.iter().position(|value| !value.is_finite()) {
            Some(unknown) => Err(self.blame(unknown)),
            None => Ok(()),
        }
    }

    fn constraint_residual(&mut self, t: f64, q: &[f64], phi: &mut [f64]) -> Result<(), Evaluation> {
        self.update(t, q, None);
        self.gather(phi, |constraint, state, values| constraint.residual(state, values))
    }

    fn constraint_velocity(&mut self, t: f64, q: &[f64], phi_t: &mut [f64]) -> Result<(), Evaluation> {
        self.update(t, q, None);
        self.gather(phi_t, |constraint, state, values| {
            constraint.velocity(state, values);
            Ok(())
        })
    }

    fn constraint_acceleration(&mut self, t: f64, q: &[f64], v: &[f64], gamma: &mut [f64]) -> Result<(), Evaluation> {
        self.update(t, q, Some(v));
        self.gather(gamma, |constraint, state, values| constraint.acceleration(state, values))
    }

    fn jacobian(&mut self, at: JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) -> Result<(), Evaluation> {
        self.update(at.t, at.q, Some(at.v));
        self.add_inertia(&at, add);
        let (stiffness, damping) = (-self.load_factor * at.stiffness, -self.load_factor * at.damping);
        let mut tangent = Blocks { layout: &self.layout, stiffness, damping, add: &mut *add };
        for force in &self.forces {
            force.add_tangent(&self.state, &mut tangent)?;
        }
        self.add_constraints(&at, add)
    }

    fn describe(&self, unknown: usize) -> String {
        let axes = Axis::ALL.map(|axis| axis.letter().to_ascii_lowercase());
        for (body, slot) in self.bodies.iter().zip(&self.layout.bodies) {
            match unknown.checked_sub(slot.velocity) {
                Some(at) if at < 3 => return format!("{} translation {}", body.name, axes[at]),
                Some(at) if at < slot.size => return format!("{} rotation about {}", body.name, axes[at - 3]),
                _ => {}
            }
        }
        let multiplier = unknown.wrapping_sub(self.layout.velocities);
        for (constraint, slot) in self.constraints.iter().zip(&self.layout.constraints) {
            if let Some(&equation) = multiplier.checked_sub(slot.multiplier).and_then(|at| slot.equations.get(at)) {
                return format!("{} {}", constraint.name(), constraint.equation_name(equation).0);
            }
        }
        format!("unknown {unknown}")
    }
}
