//! The steps of one evaluation: positions, velocities, loads, constraints, residual, Newton matrix.

use glam::DVec3;
use solver::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

use crate::accumulators::Blocks;
use crate::motion::{exponential, logarithm, put, put_quaternion, quaternion, vec3};
use crate::system::spread;
use crate::{Axis, Constraint, State, System};

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

    fn mass_pattern(&self) -> Pattern {
        self.layout.mass_pattern(&self.constraints)
    }

    /// Translations weigh against a tenth of the size of the model, so that the accuracy of a run
    /// does not depend on the unit the model is written in; of one unit where the model is smaller.
    /// A tenth, because forces of stiff elements show errors that positions hide: at an error of
    /// 1e-5 each step is then right to a millionth of the model's size.
    fn scales(&self) -> Scales {
        self.scales_with(0.1 * self.length_unit.max(self.size))
    }

    fn units(&self) -> Scales {
        self.scales_with(self.length_unit)
    }

    fn is_linear_in_accelerations(&self) -> bool {
        // Loads see positions and velocities only.
        true
    }

    fn mass_is_constant(&self) -> bool {
        // Inertias are in body axes.
        true
    }

    fn is_rotation(&self, velocity: usize) -> bool {
        // Bodies lie in the order of their velocities.
        let after = self.layout.bodies.partition_point(|slot| slot.velocity <= velocity);
        self.layout.bodies[..after].last().is_some_and(|slot| (3..slot.size).contains(&(velocity - slot.velocity)))
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
        self.balance_momentum(a, r);
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
        // Without both factors only masses and constraints are wanted.
        if stiffness != 0.0 || damping != 0.0 {
            for force in &self.forces {
                force.add_tangent(&self.state, &mut tangent)?;
            }
        }
        self.add_constraints(&at, add)
    }

    fn as_any(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
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

impl System {
    fn scales_with(&self, translation: f64) -> Scales {
        let mut increments = vec![1.0; self.layout.velocities];
        for slot in &self.layout.bodies {
            increments[slot.velocity..slot.velocity + 3].fill(translation);
        }
        Scales { increments }
    }

    /// Forces and gravity on all bodies, before the load factor.
    fn collect_loads(&mut self) -> Result<(), Evaluation> {
        for (load, body) in self.loads.loads.iter_mut().zip(&self.bodies) {
            *load = [body.mass * self.gravity_g, DVec3::ZERO];
        }
        for force in &self.forces {
            force.add_loads(&self.state, &mut self.loads)?;
        }
        Ok(())
    }

    /// `r`: rate of momentum minus the collected loads.
    fn balance_momentum(&self, a: &[f64], r: &mut [f64]) {
        for (at, (body, slot)) in self.bodies.iter().zip(&self.layout.bodies).enumerate() {
            let [f_g, t_b] = self.loads.loads[at].map(|load| load * self.load_factor);
            put(body.mass * vec3(a, slot.velocity) - f_g, r, slot.velocity);
            if slot.size == 6 {
                let (w, inertia) = (self.state.bodies[at].w_gb_b, body.inertia_c_b);
                let rate = inertia * vec3(a, slot.velocity + 3) + w.cross(inertia * w);
                put(rate - t_b, r, slot.velocity + 3);
            }
        }
    }

    /// Adds `B^T lambda`, minus the loads of the constraints.
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
            if at.stiffness == 0.0 {
                continue;
            }
            let multipliers = &mut self.scratch[..slot.active.len()];
            spread(slot, at.lambda, multipliers);
            let mut tangent = Blocks { layout: &self.layout, stiffness: -at.stiffness, damping: 0.0, add: &mut *add };
            constraint.add_tangent(&self.state, multipliers, &mut tangent);
        }
        Ok(())
    }
}
