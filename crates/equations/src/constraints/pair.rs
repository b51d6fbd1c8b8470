//! A constraint of several primitive equations between frames I and J: every joint and primitive.

use solver::Evaluation;

use super::equation::{Equation, Terms};
use crate::matrix::six;
use crate::relative::{between, load_of_reaction};
use crate::{
    Axis, BodyId, Concern, Constraint, ConstraintRows, Frame, FrameId, FrameLoad, FrameMotion, GROUND, Side, State,
    Tangent,
};

use Axis::{X, Y, Z};
use Equation::{Along, Dot};

/// Two frames and the bodies they are on.
#[derive(Clone, Debug)]
pub(super) struct Ends {
    pub(super) i: FrameId,
    pub(super) j: FrameId,
    bodies: [BodyId; 2],
}

impl Ends {
    /// `frames` is the table that `i` and `j` index.
    pub(super) fn new(frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        let body = |id: FrameId| frames.get(id.0 as usize).map_or(GROUND, |frame| frame.body);
        Self { i, j, bodies: [body(i), body(j)] }
    }

    pub(super) fn bodies(&self) -> Vec<BodyId> {
        let [i, j] = self.bodies;
        [i, j]
            .into_iter()
            .enumerate()
            .filter(|&(at, body)| body != GROUND && (at == 0 || body != i))
            .map(|(_, body)| body)
            .collect()
    }

    pub(super) fn motions<'a>(&self, state: &'a State) -> (&'a FrameMotion, &'a FrameMotion) {
        (state.frame(self.i), state.frame(self.j))
    }

    pub(super) fn frame(&self, side: Side) -> FrameId {
        match side {
            Side::I => self.i,
            Side::J => self.j,
        }
    }

    /// Adds the row of an equation: minus the generalised loads for a multiplier of 1.
    pub(super) fn add_row(&self, state: &State, equation: usize, terms: &Terms, rows: &mut ConstraintRows) {
        let (i, j) = self.motions(state);
        let on_i = FrameLoad { f_g: j.rot_gi * terms.by_d, t_g: j.rot_gi * terms.by_psi };
        for (frame, load) in [(i, on_i), (j, load_of_reaction(i, j, on_i))] {
            if frame.body != GROUND {
                let torque = state.rotation(frame.body).transpose() * (load.t_g + frame.r_bi_g.cross(load.f_g));
                rows.add(frame.body, equation, &six(load.f_g, torque));
            }
        }
    }

    /// Adds the derivative of the loads of all equations, given as the sums of `lambda * terms`.
    pub(super) fn add_tangent(&self, state: &State, sum: &Terms, tangent: &mut dyn Tangent) {
        let load = six(-sum.by_d, -sum.by_psi);
        let stiffness = sum.stiffness().map(|row| row.map(|block| -block));
        between(state, self.i, self.j, true, &load, &stiffness, None, tangent);
    }

    pub(super) fn load_at(&self, state: &State, sum: &Terms, side: Side) -> FrameLoad {
        let (i, j) = self.motions(state);
        let on_i = FrameLoad { f_g: -(j.rot_gi * sum.by_d), t_g: -(j.rot_gi * sum.by_psi) };
        match side {
            Side::I => on_i,
            Side::J => load_of_reaction(i, j, on_i),
        }
    }
}

/// Sum of `lambda * terms`, as far as loads need it.
pub(super) fn accumulate(sum: &mut Terms, lambda: f64, terms: &Terms) {
    sum.by_d += lambda * terms.by_d;
    sum.by_psi += lambda * terms.by_psi;
    sum.curvature += terms.curvature * lambda;
}

/// Several equations `= 0` between two frames.
#[derive(Clone, Debug)]
pub struct Pair {
    name: String,
    kind: &'static str,
    ends: Ends,
    equations: Vec<Equation>,
    /// Pairs of axes that must point the same way; the equations allow opposite ones too.
    same_way: &'static [Axis],
}

impl Pair {
    /// A constraint of any equations. `frames` is the table that `i` and `j` index.
    pub fn new(
        name: String,
        kind: &'static str,
        frames: &[Frame],
        i: FrameId,
        j: FrameId,
        equations: Vec<Equation>,
        same_way: &'static [Axis],
    ) -> Self {
        Self { name, kind, ends: Ends::new(frames, i, j), equations, same_way }
    }

    /// Frames coincide.
    pub fn fixed(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        let equations = vec![Along(X), Along(Y), Along(Z), Dot(Z, X), Dot(Z, Y), Dot(X, Y)];
        Self::new(name, "Fixed Joint", frames, i, j, equations, &[X, Z])
    }

    /// Origins coincide, z axes too.
    pub fn revolute(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        let equations = vec![Along(X), Along(Y), Along(Z), Dot(Z, X), Dot(Z, Y)];
        Self::new(name, "Revolute Joint", frames, i, j, equations, &[Z])
    }

    /// Origins coincide.
    pub fn spherical(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Spherical Joint", frames, i, j, vec![Along(X), Along(Y), Along(Z)], &[])
    }

    /// I slides along z of J without turning.
    pub fn translational(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        let equations = vec![Along(X), Along(Y), Dot(Z, X), Dot(Z, Y), Dot(X, Y)];
        Self::new(name, "Translational Joint", frames, i, j, equations, &[X, Z])
    }

    /// I slides along z of J and turns about it.
    pub fn cylindrical(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        let equations = vec![Along(X), Along(Y), Dot(Z, X), Dot(Z, Y)];
        Self::new(name, "Cylindrical Joint", frames, i, j, equations, &[Z])
    }

    /// Origins coincide, z axes are perpendicular: they are the pins of the cross.
    pub fn universal(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Universal Joint", frames, i, j, vec![Along(X), Along(Y), Along(Z), Dot(Z, Z)], &[])
    }

    /// Origins coincide, x of I is perpendicular to y of J.
    pub fn hooke(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Hooke Joint", frames, i, j, vec![Along(X), Along(Y), Along(Z), Dot(X, Y)], &[])
    }

    /// I stays in the x-y plane of J with parallel z axes.
    pub fn planar(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Planar Joint", frames, i, j, vec![Along(Z), Dot(Z, X), Dot(Z, Y)], &[])
    }

    /// Primitive: origins coincide.
    pub fn at_point(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Atpoint Primitive_Joint", frames, i, j, vec![Along(X), Along(Y), Along(Z)], &[])
    }

    /// Primitive: origin of I on z of J.
    pub fn inline(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Inline Primitive_Joint", frames, i, j, vec![Along(X), Along(Y)], &[])
    }

    /// Primitive: origin of I in the x-y plane of J.
    pub fn inplane(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Inplane Primitive_Joint", frames, i, j, vec![Along(Z)], &[])
    }

    /// Primitive: axes of I and J agree.
    pub fn orientation(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Orientation Primitive_Joint", frames, i, j, vec![Dot(Z, X), Dot(Z, Y), Dot(X, Y)], &[X, Z])
    }

    /// Primitive: z axes are parallel.
    pub fn parallel_axes(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Parallel_axes Primitive_Joint", frames, i, j, vec![Dot(Z, X), Dot(Z, Y)], &[])
    }

    /// Primitive: z axes are perpendicular.
    pub fn perpendicular(name: String, frames: &[Frame], i: FrameId, j: FrameId) -> Self {
        Self::new(name, "Perpendicular Primitive_Joint", frames, i, j, vec![Dot(Z, Z)], &[])
    }

    pub fn list(&self) -> &[Equation] {
        &self.equations
    }

    /// Sum of multiplier times equation. Loads on a system with undefined angles are those of the
    /// defined equations: the residual of the others has already reported the failure.
    fn sum(&self, state: &State, lambda: &[f64]) -> Terms {
        let (i, j) = self.ends.motions(state);
        let mut sum = Terms::ZERO;
        for (equation, &lambda) in self.equations.iter().zip(lambda) {
            if let Ok(terms) = equation.terms(i, j) {
                accumulate(&mut sum, lambda, &terms);
            }
        }
        sum
    }
}

impl Constraint for Pair {
    fn name(&self) -> &str {
        &self.name
    }

    fn kind(&self) -> &'static str {
        self.kind
    }

    fn equations(&self) -> usize {
        self.equations.len()
    }

    fn equation_name(&self, equation: usize) -> (String, String) {
        self.equations.get(equation).map(|equation| equation.name()).unwrap_or_default()
    }

    fn bodies(&self) -> Vec<BodyId> {
        self.ends.bodies()
    }

    fn residual(&self, state: &State, phi: &mut [f64]) -> Result<(), Evaluation> {
        let (i, j) = self.ends.motions(state);
        for (phi, equation) in phi.iter_mut().zip(&self.equations) {
            *phi = equation.value(i, j)?;
        }
        Ok(())
    }

    fn jacobian(&self, state: &State, rows: &mut ConstraintRows) -> Result<(), Evaluation> {
        let (i, j) = self.ends.motions(state);
        for (at, equation) in self.equations.iter().enumerate() {
            self.ends.add_row(state, at, &equation.terms(i, j)?, rows);
        }
        Ok(())
    }

    fn acceleration(&self, state: &State, gamma: &mut [f64]) -> Result<(), Evaluation> {
        let (i, j) = self.ends.motions(state);
        for (gamma, equation) in gamma.iter_mut().zip(&self.equations) {
            *gamma = equation.terms(i, j)?.gamma;
        }
        Ok(())
    }

    fn add_tangent(&self, state: &State, lambda: &[f64], tangent: &mut dyn Tangent) {
        self.ends.add_tangent(state, &self.sum(state, lambda), tangent);
    }

    fn load_at(&self, state: &State, lambda: &[f64], side: Side) -> FrameLoad {
        self.ends.load_at(state, &self.sum(state, lambda), side)
    }

    fn frame(&self, side: Side) -> Option<FrameId> {
        Some(self.ends.frame(side))
    }

    fn concern(&self, state: &State) -> Option<Concern> {
        let (i, j) = self.ends.motions(state);
        let against = self.same_way.iter().map(|&axis| i.axis(axis).dot(j.axis(axis))).fold(1.0, f64::min);
        let sentence = "the axes of its markers point opposite ways";
        let size = against.clamp(-1.0, 1.0).acos().to_degrees();
        (against < 0.0).then_some(Concern { sentence, size, unit: "degrees", pieces: None })
    }
}
