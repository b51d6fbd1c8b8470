//! A system that turns steadily as a whole about a fixed line: what is at rest in the turning axes is an
//! equilibrium, and its small motions have constant coefficients there.
//!
//! In these axes a body's increment `x = [dr | dtheta]` keeps its meaning: `dr` in the ground axes of
//! this instant, `dtheta` in body axes. With the spin `W` of the whole, `w = R^T W` of a body,
//!
//! ```text
//! translation:  v = W x (r - p) + x' + W x x        rotation:  omega = w + x' + w x x
//!               a = W x (W x (r - p)) + x'' + 2 W x x' + W x (W x x)     alpha = x'' + w x x'
//! ```
//!
//! so the system seen from there is again a [`Dae`], whose statics is the steady motion.

use glam::{DMat3, DVec3};
use solver::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

use crate::motion::{put, vec3};
use crate::{System, skew};

/// A system as seen from axes that turn steadily.
pub struct Spin<'a> {
    system: &'a mut System,
    /// A point of the line, m, ground axes.
    point_g: DVec3,
    /// Angular velocity of the whole, rad/s, ground axes.
    w_whole_g: DVec3,
    v: Vec<f64>,
    a: Vec<f64>,
}

impl<'a> Spin<'a> {
    pub fn new(system: &'a mut System, point_g: DVec3, w_whole_g: DVec3) -> Self {
        let n = system.layout.velocities;
        Self { system, point_g, w_whole_g, v: vec![0.0; n], a: vec![0.0; n] }
    }

    /// The system at rest in the turning axes: its velocities and accelerations in ground.
    pub fn steady(&mut self, q: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let zero = vec![0.0; self.v.len()];
        self.absolute(q, &zero, &zero);
        (self.v.clone(), self.a.clone())
    }

    /// What does not turn with the whole: the equation that a steady motion would break the most, with
    /// the rate at which it does, 1/s. Nothing where all equations are kept to rounding.
    pub fn broken_equation(&mut self, t: f64, q: &[f64]) -> Result<Option<(String, f64)>, Evaluation> {
        let (v, _) = self.steady(q);
        let mut rates = vec![0.0; self.constraints()];
        self.system.constraint_velocity(t, q, &mut rates)?;
        let active = self.system.constraint_rows(t, q)?.into_iter().filter(|row| row.active);
        let mut worst = (0, 0.0_f64, 1.0_f64);
        for (at, row) in active.enumerate() {
            let terms = || row.entries.iter().map(|(k, value)| value * v[*k]);
            let rate = rates[at] + terms().sum::<f64>();
            let size = terms().fold(rates[at].abs(), |most, term| most.max(term.abs()));
            if rate.abs() > worst.1.abs() {
                worst = (at, rate, size.max(1e-300));
            }
        }
        let (at, rate, size) = worst;
        // Motions are typed with six digits or so.
        let broken = rate.abs() > 1e-5 * size.max(self.w_whole_g.length());
        Ok(broken.then(|| (self.system.describe(self.system.layout.velocities + at), rate)))
    }

    /// Velocities and accelerations in ground from those in the turning axes.
    fn absolute(&mut self, q: &[f64], v: &[f64], a: &[f64]) {
        self.system.update(0.0, q, None);
        let spin = self.w_whole_g;
        for (at, slot) in self.system.layout.bodies.iter().enumerate() {
            let k = slot.velocity;
            let r = vec3(q, slot.position) - self.point_g;
            let dragged = spin.cross(r);
            put(dragged + vec3(v, k), &mut self.v, k);
            put(spin.cross(dragged) + 2.0 * spin.cross(vec3(v, k)) + vec3(a, k), &mut self.a, k);
            if slot.size == 6 {
                let w = self.system.state.rotations[at].transpose() * spin;
                put(w + vec3(v, k + 3), &mut self.v, k + 3);
                put(w.cross(vec3(v, k + 3)) + vec3(a, k + 3), &mut self.a, k + 3);
            }
        }
    }

    /// Adds `factor * block * [translation 0; 0 rotation]` for each block of velocities.
    fn add_turned(
        &mut self,
        at: JacobianPoint<'_>,
        turn: impl Fn(DVec3, DVec3) -> [DMat3; 2],
        add: &mut dyn FnMut(usize, usize, &[f64]),
    ) -> Result<(), Evaluation> {
        self.system.update(at.t, at.q, None);
        let spin = self.w_whole_g;
        let rotations = self.system.state.rotations.iter();
        let turns: Vec<[DMat3; 2]> = rotations.map(|rot_gb| turn(spin, rot_gb.transpose() * spin)).collect();
        let sizes: Vec<usize> = self.system.layout.bodies.iter().map(|slot| slot.size).collect();
        let mut product = [0.0; 36];
        self.system.jacobian(at, &mut |row, column, values| {
            // Multipliers have been added before.
            let (Some(&rows), Some(&columns)) = (sizes.get(row), sizes.get(column)) else { return };
            let product = &mut product[..rows * columns];
            product.fill(0.0);
            for (part, turn) in turns[column].iter().enumerate().take(columns / 3) {
                for j in 0..3 {
                    for k in 0..3 {
                        let factor = turn.col(j)[k];
                        for i in 0..rows {
                            product[(3 * part + j) * rows + i] += values[(3 * part + k) * rows + i] * factor;
                        }
                    }
                }
            }
            add(row, column, product);
        })
    }
}

impl Dae for Spin<'_> {
    fn positions(&self) -> usize {
        self.system.positions()
    }

    fn velocities(&self) -> usize {
        self.system.velocities()
    }

    fn constraints(&self) -> usize {
        self.system.constraints()
    }

    fn pattern(&self) -> Pattern {
        self.system.pattern()
    }

    fn mass_pattern(&self) -> Pattern {
        self.system.mass_pattern()
    }

    fn scales(&self) -> Scales {
        self.system.scales()
    }

    fn units(&self) -> Scales {
        self.system.units()
    }

    fn is_linear_in_accelerations(&self) -> bool {
        self.system.is_linear_in_accelerations()
    }

    fn mass_is_constant(&self) -> bool {
        self.system.mass_is_constant()
    }

    fn is_rotation(&self, velocity: usize) -> bool {
        self.system.is_rotation(velocity)
    }

    fn retract(&self, q: &[f64], increment: &[f64], out: &mut [f64]) {
        self.system.retract(q, increment, out);
    }

    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]) {
        self.system.difference(q0, q1, out);
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
        self.absolute(q, v, a);
        self.system.residual(t, q, &self.v, &self.a, lambda, r)
    }

    fn constraint_residual(&mut self, t: f64, q: &[f64], phi: &mut [f64]) -> Result<(), Evaluation> {
        self.system.constraint_residual(t, q, phi)
    }

    /// Zero: the equations turn with the whole (see [`Spin::broken_equation`]).
    fn constraint_velocity(&mut self, _: f64, _: &[f64], phi_t: &mut [f64]) -> Result<(), Evaluation> {
        phi_t.fill(0.0);
        Ok(())
    }

    /// Zero for what is at rest in the turning axes, which is all that is asked for.
    fn constraint_acceleration(&mut self, _: f64, _: &[f64], _: &[f64], gamma: &mut [f64]) -> Result<(), Evaluation> {
        gamma.fill(0.0);
        Ok(())
    }

    /// About rest in the turning axes.
    fn jacobian(&mut self, at: JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) -> Result<(), Evaluation> {
        self.absolute(at.q, at.v, at.a);
        let (v, a) = (self.v.clone(), self.a.clone());
        let inner = JacobianPoint { v: &v, a: &a, ..at };
        self.system.jacobian(inner, add)?;
        if at.stiffness == 0.0 && at.damping == 0.0 {
            return Ok(());
        }
        let (stiffness, damping) = (at.stiffness, at.damping);
        let by_mass = JacobianPoint { mass: 1.0, damping: 0.0, stiffness: 0.0, ..inner };
        self.add_turned(
            by_mass,
            |g, b| {
                let (turn_g, turn_b) = (skew(g), skew(b));
                [turn_g * (2.0 * damping) + turn_g * turn_g * stiffness, turn_b * damping]
            },
            add,
        )?;
        if stiffness == 0.0 {
            return Ok(());
        }
        let by_velocity = JacobianPoint { mass: 0.0, damping: 1.0, stiffness: 0.0, ..inner };
        self.add_turned(by_velocity, |g, b| [skew(g) * stiffness, skew(b) * stiffness], add)
    }

    fn as_any(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self.system)
    }

    fn describe(&self, unknown: usize) -> String {
        self.system.describe(unknown)
    }
}
