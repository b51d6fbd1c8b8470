//! What a run records: named columns in model units, each a quantity of the equations.

use std::cell::Cell;
use std::collections::{BTreeMap, HashSet};

use equations::{FrameId, FrameLoad, Gradient, Side, State, System};
use functions::{Component, Measure};
use glam::{DQuat, DVec3};
use solver::Dae;

use super::member;
use crate::{
    lower::LoadId,
    runtime::{self, Compiled, loads::component_of, measure},
};

/// One column.
#[derive(Clone, Debug)]
pub struct Column {
    /// `<result set>.<component>`.
    pub name: String,
    /// Unit label of the model's units; empty for a plain number.
    pub unit: String,
    pub quantity: Quantity,
    /// Model units per SI unit.
    pub factor: f64,
}

/// What a column shows. SI; angles in radians.
#[derive(Clone, Debug)]
pub enum Quantity {
    Time,
    Measure(Measure),
    /// A run-time function; its value is in model units already.
    Function(Compiled),
    /// Total rotation of I relative to J, 0 to pi.
    Turn {
        i: FrameId,
        j: Option<FrameId>,
    },
    /// One of the polar components of a vector given by three measures.
    Polar {
        of: [Measure; 3],
        component: Polar,
    },
    /// One of the columns of a member, a force of the system.
    Member {
        force: usize,
        which: usize,
    },
    /// Energy of a body: translation, rotation, or both.
    KineticEnergy {
        body: usize,
        translation: bool,
        rotation: bool,
    },
}

/// Cylindrical and spherical components of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Polar {
    /// Distance from the z axis.
    Radius,
    /// Distance from the origin.
    Distance,
    /// Angle about z from x.
    Azimuth,
    /// Angle from z.
    Inclination,
}

/// Who acts at a marker, from elements between it and another one.
type AtMarkers = BTreeMap<(u32, Option<u32>), Vec<(LoadId, Side)>>;

/// The columns of a run. Evaluation keeps track of angles so that they count whole turns.
#[derive(Debug, Default)]
pub struct Outputs {
    columns: Vec<Column>,
    /// One list for each column, one entry for each of its measures.
    branches: Vec<Vec<Branch>>,
    loads: BTreeMap<u32, LoadId>,
    /// Loads at markers: `(marker, other marker)` to who acts there.
    at_markers: AtMarkers,
}

/// The last value of an angle, from which the next is expected.
#[derive(Clone, Copy, Debug, Default)]
struct Branch {
    time: f64,
    angle: f64,
    rate: f64,
}

impl Outputs {
    /// The columns of a system; a column's name is made unique where two agree.
    pub(crate) fn new(mut columns: Vec<Column>, loads: &BTreeMap<model::ObjectId, LoadId>, ends: &[Ends]) -> Outputs {
        let mut used = HashSet::new();
        for column in &mut columns {
            let first = column.name.clone();
            let mut count = 1;
            while !used.insert(column.name.to_ascii_lowercase()) {
                count += 1;
                column.name = format!("{first}_{count}");
            }
        }
        let branches = columns.iter().map(|c| vec![Branch::default(); measures_of(&c.quantity).len()]).collect();
        let loads = loads.iter().map(|(object, load)| (object.0, *load)).collect();
        let mut outputs = Outputs { columns, branches, loads, at_markers: BTreeMap::new() };
        let wanted: Vec<(u32, Option<u32>)> = outputs
            .columns
            .iter()
            .flat_map(|c| measures_of(&c.quantity))
            .filter_map(|m| match m {
                Measure::MarkerLoad { i, j, .. } => Some((i, j)),
                _ => None,
            })
            .collect();
        for key in wanted {
            let acting = acting_at(ends, FrameId(key.0), key.1.map(FrameId));
            outputs.at_markers.insert(key, acting);
        }
        outputs
    }

    /// Name and unit of each column; the first is time.
    pub fn columns(&self) -> Vec<(String, String)> {
        self.columns.iter().map(|c| (c.name.clone(), c.unit.clone())).collect()
    }

    pub fn len(&self) -> usize {
        self.columns.len()
    }

    pub fn is_empty(&self) -> bool {
        self.columns.is_empty()
    }

    /// Fills a row with the values of all columns in model units. Calls in the order of time keep
    /// angles continuous.
    #[allow(clippy::too_many_arguments)] // the solver's view of one instant
    pub fn evaluate(
        &mut self,
        system: &mut System,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        lambda: &[f64],
        row: &mut [f64],
    ) {
        let accelerations = (a.len() == system.velocities()).then_some(a);
        system.state(t, q, v, accelerations);
        let system = &*system;
        let instant = Instant {
            system,
            state: system.last_state(),
            lambda,
            loads: &self.loads,
            at: &self.at_markers,
            member: Cell::new(None),
        };
        for ((value, column), branches) in row.iter_mut().zip(&self.columns).zip(&mut self.branches) {
            *value = instant.value(&column.quantity, branches) * column.factor;
        }
    }
}

/// The two frames of a force or constraint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ends {
    pub load: LoadId,
    pub i: Option<FrameId>,
    pub j: Option<FrameId>,
}

/// What acts at a marker, from elements between it and another one (from all, if none is named).
fn acting_at(ends: &[Ends], marker: FrameId, other: Option<FrameId>) -> Vec<(LoadId, Side)> {
    let mut acting = Vec::new();
    for end in ends {
        if end.i == Some(marker) && (other.is_none() || end.j == other) {
            acting.push((end.load, Side::I));
        }
        if end.j == Some(marker) && (other.is_none() || end.i == other) {
            acting.push((end.load, Side::J));
        }
    }
    acting
}

fn measures_of(quantity: &Quantity) -> Vec<Measure> {
    match quantity {
        Quantity::Measure(measure) => vec![*measure],
        Quantity::Function(compiled) => compiled.function.measures().to_vec(),
        Quantity::Polar { of, .. } => of.to_vec(),
        Quantity::Time | Quantity::Turn { .. } | Quantity::Member { .. } | Quantity::KineticEnergy { .. } => Vec::new(),
    }
}

/// One instant of a run.
struct Instant<'a> {
    system: &'a System,
    state: &'a State,
    lambda: &'a [f64],
    loads: &'a BTreeMap<u32, LoadId>,
    at: &'a AtMarkers,
    /// The member looked at last: its columns follow one another and are computed at once.
    member: Cell<Option<(usize, member::Values)>>,
}

impl Instant<'_> {
    fn value(&self, quantity: &Quantity, branches: &mut [Branch]) -> f64 {
        match quantity {
            Quantity::Time => self.state.time,
            Quantity::Measure(measure) => branches.first_mut().map_or(0.0, |branch| self.measured(measure, branch)),
            Quantity::Function(compiled) => self.function(compiled, branches),
            Quantity::Turn { i, j } => {
                let (i, j) = (self.state.frame(*i), self.state.frame_or_global(*j));
                let turn = DQuat::from_mat3(&(j.rot_gi.transpose() * i.rot_gi));
                2.0 * turn.xyz().length().atan2(turn.w.abs())
            }
            Quantity::Polar { of, component } => {
                let mut vector = DVec3::ZERO;
                for ((axis, measure), branch) in of.iter().enumerate().zip(branches) {
                    vector[axis] = self.measured(measure, branch);
                }
                let radius = vector.x.hypot(vector.y);
                match component {
                    Polar::Radius => radius,
                    Polar::Distance => vector.length(),
                    Polar::Azimuth => vector.y.atan2(vector.x),
                    Polar::Inclination => radius.atan2(vector.z),
                }
            }
            Quantity::Member { force, which } => {
                let values = match self.member.get() {
                    Some((known, values)) if known == *force => values,
                    _ => member::values(self.system.force_list()[*force].as_ref(), self.state),
                };
                self.member.set(Some((*force, values)));
                values[*which]
            }
            Quantity::KineticEnergy { body, translation, rotation } => {
                let (data, motion) = (&self.system.bodies()[*body], &self.state.bodies[*body]);
                let w = motion.w_gb_b;
                let moving = 0.5 * data.mass * motion.v_gb_g.length_squared();
                let turning = 0.5 * w.dot(data.inertia_c_b * w);
                f64::from(u8::from(*translation)) * moving + f64::from(u8::from(*rotation)) * turning
            }
        }
    }

    fn function(&self, compiled: &Compiled, branches: &mut [Branch]) -> f64 {
        let measures = compiled.function.measures();
        let mut values = smallvec::SmallVec::<[f64; 8]>::new();
        for ((measure, factor), branch) in measures.iter().zip(&compiled.factors).zip(branches) {
            values.push(self.measured(measure, branch) * factor);
        }
        compiled.function.value(self.state.time * compiled.time, &values)
    }

    fn measured(&self, measure: &Measure, branch: &mut Branch) -> f64 {
        if let Some(value) = measure::acceleration(measure, self.state) {
            return value;
        }
        match *measure {
            Measure::Load { element, j_flag, component, rm } => {
                let side = if j_flag { Side::J } else { Side::I };
                let load = self.loads.get(&element).map(|&load| self.load(load, side)).unwrap_or_default();
                component_of(self.state, load, component, rm)
            }
            Measure::MarkerLoad { torque, component, i, j, k } => {
                let mut sum = FrameLoad::default();
                for &(load, side) in self.at.get(&(i, j)).into_iter().flatten() {
                    let one = self.load(load, side);
                    sum = FrameLoad { f_g: sum.f_g + one.f_g, t_g: sum.t_g + one.t_g };
                }
                let offset = match component {
                    Component::Magnitude => 1,
                    Component::X => 2,
                    Component::Y => 3,
                    Component::Z => 4,
                };
                component_of(self.state, sum, offset + if torque { 4 } else { 0 }, k)
            }
            _ if measure::turns_over(measure) => self.angle(measure, branch),
            _ => measure::value(measure, self.state, 0.0, None),
        }
    }

    /// An angle on the branch that its rate leads to.
    fn angle(&self, measure: &Measure, branch: &mut Branch) -> f64 {
        let mut gradient = Gradient::new();
        let raw = measure::value(measure, self.state, 0.0, Some(&mut gradient));
        let rate: f64 = gradient
            .entries()
            .iter()
            .filter_map(|(body, slopes)| {
                let motion = self.state.body(*body)?;
                let (by_r, by_turn) = (DVec3::from_slice(&slopes[0..3]), DVec3::from_slice(&slopes[3..6]));
                Some(by_r.dot(motion.v_gb_g) + by_turn.dot(motion.w_gb_b))
            })
            .sum();
        let expected = branch.angle + 0.5 * (branch.rate + rate) * (self.state.time - branch.time);
        let angle = equations::measures::nearest(raw, expected);
        *branch = Branch { time: self.state.time, angle, rate };
        angle
    }

    fn load(&self, load: LoadId, side: Side) -> FrameLoad {
        match load {
            LoadId::Force(index) => self.system.force_list()[index].load_at(self.state, side),
            LoadId::Constraint(_) if self.lambda.len() != Dae::constraints(self.system) => FrameLoad::default(),
            LoadId::Constraint(index) => self.system.reaction(index, self.lambda, side),
        }
    }
}

/// Ends of all forces and constraints of a system.
pub(crate) fn ends_of(
    forces: &[Box<dyn equations::Force>],
    constraints: &[Box<dyn equations::Constraint>],
) -> Vec<Ends> {
    let forces = forces.iter().enumerate().map(|(at, force)| Ends {
        load: LoadId::Force(at),
        i: force.frame(Side::I),
        j: force.frame(Side::J),
    });
    let constraints = constraints.iter().enumerate().map(|(at, constraint)| Ends {
        load: LoadId::Constraint(at),
        i: constraint.frame(Side::I),
        j: constraint.frame(Side::J),
    });
    forces.chain(constraints).collect()
}

impl Column {
    /// Units and factor from a dimension.
    pub(crate) fn new(name: String, quantity: Quantity, unit: &Unit<'_>) -> Column {
        let Unit(units, dimension) = *unit;
        Column { name, unit: units.label(dimension), quantity, factor: 1.0 / units.factor(dimension) }
    }

    pub(crate) fn of_function(name: String, unit: String, compiled: runtime::Compiled) -> Column {
        Column { name, unit, quantity: Quantity::Function(compiled), factor: 1.0 }
    }
}

/// Model units and a dimension.
pub(crate) struct Unit<'a>(pub &'a schema::UnitSystem, pub schema::Dimension);
