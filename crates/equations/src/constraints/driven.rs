//! A motion: one equation between two frames that follows a function of time.

use std::f64::consts::TAU;

use solver::Evaluation;

use super::equation::{Angle, Equation, Terms};
use super::pair::{Ends, accumulate};
use crate::{Axis, BodyId, Constraint, ConstraintRows, Frame, FrameId, FrameLoad, Side, State, Tangent};

/// A function of time in SI: value and first two derivatives.
pub trait TimeFunction: Send + Sync {
    fn jet(&self, t: f64) -> [f64; 3];
}

impl<F: Fn(f64) -> [f64; 3] + Send + Sync> TimeFunction for F {
    fn jet(&self, t: f64) -> [f64; 3] {
        self(t)
    }
}

/// What a motion prescribes: displacement of I relative to J.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drive {
    /// Along an axis of J; `Z` is the coordinate of a translational joint.
    Translation(Axis),
    /// Angle from x of J to x of I about z of J, over any number of turns: the coordinate of a
    /// revolute joint.
    Rotation,
    /// Body angles 1-2-3 of I relative to J.
    B1,
    B2,
    B3,
}

impl Drive {
    fn equation(self) -> Equation {
        match self {
            Drive::Translation(axis) => Equation::Along(axis),
            Drive::Rotation => Equation::Angle(Angle::Z),
            Drive::B1 => Equation::Angle(Angle::X),
            Drive::B2 => Equation::Angle(Angle::Middle),
            Drive::B3 => Equation::Angle(Angle::Last),
        }
    }
}

/// `coordinate of I relative to J = f(t)`.
pub struct Driven {
    name: String,
    ends: Ends,
    drive: Drive,
    function: Box<dyn TimeFunction>,
}

impl Driven {
    /// `frames` is the table that `i` and `j` index.
    pub fn new(
        name: String,
        frames: &[Frame],
        i: FrameId,
        j: FrameId,
        drive: Drive,
        function: Box<dyn TimeFunction>,
    ) -> Self {
        Self { name, ends: Ends::new(frames, i, j), drive, function }
    }

    fn terms(&self, state: &State) -> Result<Terms, Evaluation> {
        let (i, j) = self.ends.motions(state);
        self.drive.equation().terms(i, j).map_err(|error| self.named(&error))
    }

    fn named(&self, error: &Evaluation) -> Evaluation {
        Evaluation { message: format!("`{}`: {}", self.name, error.message) }
    }

    fn load_terms(&self, state: &State, lambda: &[f64]) -> Terms {
        let mut sum = Terms::ZERO;
        if let (Ok(terms), Some(&lambda)) = (self.terms(state), lambda.first()) {
            accumulate(&mut sum, lambda, &terms);
        }
        sum
    }
}

impl Constraint for Driven {
    fn name(&self) -> &str {
        &self.name
    }

    fn kind(&self) -> &'static str {
        "Motion"
    }

    fn equations(&self) -> usize {
        1
    }

    fn equation_name(&self, _equation: usize) -> (String, String) {
        self.drive.equation().name()
    }

    fn bodies(&self) -> Vec<BodyId> {
        self.ends.bodies()
    }

    fn residual(&self, state: &State, phi: &mut [f64]) -> Result<(), Evaluation> {
        let (i, j) = self.ends.motions(state);
        let [wanted, ..] = self.function.jet(state.time);
        if !wanted.is_finite() {
            let message = format!("the function of `{}` is {wanted} at time {}", self.name, state.time);
            return Err(Evaluation { message });
        }
        let equation = self.drive.equation();
        let difference = equation.value(i, j).map_err(|error| self.named(&error))? - wanted;
        phi[0] = match (equation, self.drive) {
            // Turns add up: the residual is the shorter way to the wanted angle. The second of the
            // angles 1-2-3 cannot turn over, so a wanted angle beyond 90 degrees has to fail.
            (Equation::Angle(_), Drive::Rotation | Drive::B1 | Drive::B3) => wrapped(difference),
            _ => difference,
        };
        Ok(())
    }

    fn jacobian(&self, state: &State, rows: &mut ConstraintRows) -> Result<(), Evaluation> {
        self.ends.add_row(state, 0, &self.terms(state)?, rows);
        Ok(())
    }

    fn velocity(&self, state: &State, phi_t: &mut [f64]) {
        phi_t[0] = -self.function.jet(state.time)[1];
    }

    fn acceleration(&self, state: &State, gamma: &mut [f64]) -> Result<(), Evaluation> {
        gamma[0] = self.terms(state)?.gamma - self.function.jet(state.time)[2];
        Ok(())
    }

    fn add_tangent(&self, state: &State, lambda: &[f64], tangent: &mut dyn Tangent) {
        self.ends.add_tangent(state, &self.load_terms(state, lambda), tangent);
    }

    fn load_at(&self, state: &State, lambda: &[f64], side: Side) -> FrameLoad {
        self.ends.load_at(state, &self.load_terms(state, lambda), side)
    }

    fn frame(&self, side: Side) -> Option<FrameId> {
        Some(self.ends.frame(side))
    }
}

/// Angle of at most half a turn that differs by whole turns.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
