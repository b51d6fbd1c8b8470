//! Where each body and each constraint has its unknowns. Arithmetic on offsets happens here only.

use solver::Pattern;

use crate::{Body, BodyId, Constraint, Force};

/// Place of a body in the vectors of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodySlot {
    pub position: usize,
    pub velocity: usize,
    /// 6, or 3 for a point mass.
    pub size: usize,
}

/// Place of a constraint among the multipliers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConstraintSlot {
    /// Offset among the multipliers.
    pub multiplier: usize,
    /// Number of the block; none if no equation is active.
    pub block: Option<usize>,
    /// Which equations are active.
    pub active: Vec<bool>,
    /// The active equations in order.
    pub equations: Vec<usize>,
}

/// Offsets of everything.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    pub bodies: Vec<BodySlot>,
    pub constraints: Vec<ConstraintSlot>,
    pub positions: usize,
    pub velocities: usize,
    pub multipliers: usize,
    /// Number of blocks, bodies and constraints together.
    blocks: usize,
}

impl Layout {
    pub fn new(bodies: &[Body], constraints: &[Box<dyn Constraint>]) -> Self {
        let mut layout = Self::default();
        for body in bodies {
            let (position, velocity) = (layout.positions, layout.velocities);
            let (stored, size) = if body.point_mass { (3, 3) } else { (7, 6) };
            layout.bodies.push(BodySlot { position, velocity, size });
            layout.positions += stored;
            layout.velocities += size;
        }
        layout.constraints = constraints
            .iter()
            .map(|constraint| ConstraintSlot {
                multiplier: 0,
                block: None,
                active: vec![true; constraint.equations()],
                equations: Vec::new(),
            })
            .collect();
        layout.number_constraints();
        layout
    }

    /// Switches one equation and numbers the multipliers anew.
    pub fn set_active(&mut self, constraint: usize, equation: usize, active: bool) {
        if let Some(flag) = self.constraints.get_mut(constraint).and_then(|slot| slot.active.get_mut(equation)) {
            *flag = active;
            self.number_constraints();
        }
    }

    fn number_constraints(&mut self) {
        self.multipliers = 0;
        self.blocks = self.bodies.len();
        for slot in &mut self.constraints {
            slot.multiplier = self.multipliers;
            slot.equations.clear();
            slot.equations.extend((0..slot.active.len()).filter(|&equation| slot.active[equation]));
            self.multipliers += slot.equations.len();
            slot.block = (!slot.equations.is_empty()).then_some(self.blocks);
            self.blocks += usize::from(slot.block.is_some());
        }
    }

    pub fn pattern(&self, forces: &[Box<dyn Force>], constraints: &[Box<dyn Constraint>]) -> Pattern {
        let mut pairs = Vec::new();
        let mut couple = |bodies: &[BodyId]| {
            for (at, a) in bodies.iter().enumerate() {
                for b in &bodies[at + 1..] {
                    if a != b {
                        pairs.push((a.0 as usize, b.0 as usize));
                    }
                }
            }
        };
        for force in forces {
            couple(&force.bodies());
        }
        for constraint in constraints {
            couple(&constraint.bodies());
        }
        self.with_constraints(constraints, pairs)
    }

    /// The pattern of masses and constraints alone.
    pub fn mass_pattern(&self, constraints: &[Box<dyn Constraint>]) -> Pattern {
        self.with_constraints(constraints, Vec::new())
    }

    fn with_constraints(&self, constraints: &[Box<dyn Constraint>], mut pairs: Vec<(usize, usize)>) -> Pattern {
        let mut sizes: Vec<usize> = self.bodies.iter().map(|slot| slot.size).collect();
        sizes.extend(self.constraints.iter().map(|slot| slot.equations.len()).filter(|&size| size > 0));
        for (slot, constraint) in self.constraints.iter().zip(constraints) {
            if let Some(block) = slot.block {
                pairs.extend(constraint.bodies().iter().map(|body| (body.0 as usize, block)));
            }
        }
        let mirrored: Vec<_> = pairs.iter().map(|&(row, column)| (column, row)).collect();
        pairs.extend(mirrored);
        pairs.sort_unstable();
        pairs.dedup();
        Pattern { sizes, velocity_blocks: self.bodies.len(), pairs }
    }
}
