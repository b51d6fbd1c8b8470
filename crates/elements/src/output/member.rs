//! What goes through a member (a beam), what it stores and what it takes: one list of columns.

use equations::{BodyId, Force, FrameId, FrameLoad, Loads, Side, State};
use glam::DVec3;
use schema::Dimension;

use super::{outputs::Quantity, vector};
use crate::lower::Lowering;

const POWER: Dimension = Dimension::of(1, 0, -1, 1, 0);

/// Name and dimension of each column, in the order of [`values`]. Forces and moments are those that the
/// piece on the side of I exerts on the piece on the side of J, in the axes of the section: tension is
/// positive, dMY/dx = VZ and dMZ/dx = -VY.
pub const COLUMNS: [(&str, Dimension); 13] = [
    ("N", Dimension::FORCE),
    ("VY", Dimension::FORCE),
    ("VZ", Dimension::FORCE),
    ("T_J", Dimension::TORQUE),
    ("MY_J", Dimension::TORQUE),
    ("MZ_J", Dimension::TORQUE),
    ("T_I", Dimension::TORQUE),
    ("MY_I", Dimension::TORQUE),
    ("MZ_I", Dimension::TORQUE),
    ("ANGLE", Dimension::ANGLE),
    ("ENERGY", Dimension::ENERGY),
    ("POWER", POWER),
    ("RESIDUAL", Dimension::NONE),
];

/// One value for each of [`COLUMNS`], SI.
pub type Values = [f64; COLUMNS.len()];

/// The values of one member; zeros for an element without sections.
pub(crate) fn values(force: &dyn Force, state: &State) -> Values {
    let Some(member) = force.member() else { return [0.0; COLUMNS.len()] };
    let inside = member.inside(state);
    let mut values = [0.0; COLUMNS.len()];
    for (three, vector) in values.chunks_mut(3).zip([inside.force, inside.moment_j, inside.moment_i]) {
        three.copy_from_slice(&vector.to_array());
    }
    let rest = [inside.angle, force.energy(state), force.dissipation(state), residual(force, state)];
    values[9..].copy_from_slice(&rest);
    values
}

/// Adds the columns of one member.
pub(crate) fn add(lowering: &mut Lowering<'_>, element: model::ObjectId, force: usize) {
    let set = lowering.database.object(element).name.clone();
    for (which, (name, dimension)) in COLUMNS.iter().enumerate() {
        vector::add(lowering, format!("{set}.{name}"), Quantity::Member { force, which }, *dimension);
    }
}

/// How far the loads that an element puts on its bodies are from balance: the sum of forces and the sum
/// of moments about J, as parts of the largest force and the largest moment. Each load is taken as the
/// equations get it, at the centre of mass of its body. Rounding, if all is well: where a force acts along
/// the line to J its moment is rounding itself, so that a force on its distance counts as a moment too.
fn residual(force: &dyn Force, state: &State) -> f64 {
    let Some(at) = force.frame(Side::J) else { return 0.0 };
    let mut sum = Sum { about: state.frame(at).r_gi_g, ..Sum::default() };
    if force.add_loads(state, &mut sum).is_err() {
        return f64::NAN;
    }
    let part = |sum: DVec3, largest: f64| if largest > 0.0 { sum.length() / largest } else { 0.0 };
    part(sum.force, sum.largest_force).max(part(sum.moment, sum.largest_moment))
}

/// Adds up loads about a point.
#[derive(Default)]
struct Sum {
    about: DVec3,
    force: DVec3,
    moment: DVec3,
    largest_force: f64,
    largest_moment: f64,
}

impl Sum {
    fn add(&mut self, at: DVec3, f_g: DVec3, t_g: DVec3) {
        self.force += f_g;
        self.moment += (at - self.about).cross(f_g) + t_g;
        self.largest_force = self.largest_force.max(f_g.length());
        self.largest_moment = self.largest_moment.max((at - self.about).length() * f_g.length()).max(t_g.length());
    }
}

impl Loads for Sum {
    fn at_frame(&mut self, state: &State, frame: FrameId, load: FrameLoad) {
        let frame = state.frame(frame);
        self.at_body(state, frame.body, load.f_g, load.t_g + frame.r_bi_g.cross(load.f_g));
    }

    fn at_body(&mut self, state: &State, body: BodyId, f_g: DVec3, t_g: DVec3) {
        // Ground has its origin for a centre.
        let centre = state.body(body).map_or(DVec3::ZERO, |motion| motion.r_gb_g);
        self.add(centre, f_g, t_g);
    }
}
