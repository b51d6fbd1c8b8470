//! Springs and dampers between two markers: a law turns the motion of I relative to J into the load
//! on I, and this file does the rest.

use equations::{
    BodyId, Concern, Force, FrameId, FrameLoad, Gradient, Inside, LoadCotangent, LoadOfState, Loads, Member, Relative,
    Side, State, Tangent, apply_between, load_gradient, load_of_reaction, relative, tangent_between,
};
use glam::{DMat3, DVec3};
use model::ObjectId;
use schema::Default;
use solver::Evaluation;
use text::Diagnostic;

use crate::lower::{Lowering, distinct_bodies, word_of};

/// Load on I, in J axes, with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    pub load: [f64; 6],
    /// d(load) / d[displacement, small rotation] of I relative to J, all in J axes.
    pub by_position: [[f64; 6]; 6],
    /// d(load) / d[velocity, angular velocity].
    pub by_velocity: [[f64; 6]; 6],
}

/// What the load follows from.
pub trait Law: Send + Sync {
    /// The load and its derivatives.
    fn response(&self, motion: &Relative) -> Response;
    /// The load alone, where that costs less.
    fn load(&self, motion: &Relative) -> [f64; 6] {
        self.response(motion).load
    }
    /// Elastic energy and that of the preload, J.
    fn energy(&self, motion: &Relative) -> f64;
    /// Power that the part of the load which vanishes at rest takes, W.
    fn dissipation(&self, motion: &Relative) -> f64 {
        let still = Relative { v_ji_j: DVec3::ZERO, w_ji_j: DVec3::ZERO, ..*motion };
        let (moving, still) = (self.load(motion), self.load(&still));
        let rates = [motion.v_ji_j.to_array(), motion.w_ji_j.to_array()].concat();
        (0..6).map(|k| (still[k] - moving[k]) * rates[k]).sum()
    }
    /// Whether there are sections between the markers, so that one can ask what goes through them.
    fn has_sections(&self) -> bool {
        false
    }
    /// Axes of the sections, x along the member, in J.
    fn section_axes(&self, _motion: &Relative) -> DMat3 {
        DMat3::IDENTITY
    }
    /// The largest rotation that the law sees, rad.
    fn largest_angle(&self, _motion: &Relative) -> f64 {
        0.0
    }
    /// Why there is no load in this state.
    fn trouble(&self, _motion: &Relative) -> Option<&'static str> {
        None
    }
    /// What the user should know about this state.
    fn concern(&self, _motion: &Relative) -> Option<Concern> {
        None
    }
}

/// A law between two frames.
#[derive(Clone, Debug)]
pub struct Elastic<L> {
    pub name: String,
    pub i: FrameId,
    pub j: FrameId,
    /// Bodies of the two frames.
    pub bodies: [BodyId; 2],
    pub law: L,
}

impl<L: Law> Elastic<L> {
    /// Motion of I relative to J, if there is a load in it.
    fn motion(&self, state: &State) -> Result<Relative, Evaluation> {
        let motion = relative(state, self.i, self.j);
        match self.law.trouble(&motion) {
            None => Ok(motion),
            Some(why) => Err(Evaluation { message: format!("`{}` at time {} s: {why}", self.name, state.time) }),
        }
    }
}

impl<L: Law> Force for Elastic<L> {
    fn name(&self) -> &str {
        &self.name
    }

    fn bodies(&self) -> Vec<BodyId> {
        distinct_bodies(&self.bodies)
    }

    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation> {
        let load = self.law.load(&self.motion(state)?);
        apply_between(state, self.i, self.j, &load, loads);
        Ok(())
    }

    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation> {
        let response = self.law.response(&self.motion(state)?);
        let (by_position, by_velocity) = (&response.by_position, &response.by_velocity);
        tangent_between(state, self.i, self.j, &response.load, by_position, by_velocity, tangent);
        Ok(())
    }

    fn load_at(&self, state: &State, side: Side) -> FrameLoad {
        let load = self.law.load(&relative(state, self.i, self.j));
        let (i, j) = (state.frame(self.i), state.frame(self.j));
        let on_i = FrameLoad {
            f_g: j.rot_gi * DVec3::new(load[0], load[1], load[2]),
            t_g: j.rot_gi * DVec3::new(load[3], load[4], load[5]),
        };
        match side {
            Side::I => on_i,
            Side::J => load_of_reaction(i, j, on_i),
        }
    }

    fn frame(&self, side: Side) -> Option<FrameId> {
        Some(match side {
            Side::I => self.i,
            Side::J => self.j,
        })
    }

    fn energy(&self, state: &State) -> f64 {
        self.law.energy(&relative(state, self.i, self.j))
    }

    fn dissipation(&self, state: &State) -> f64 {
        self.law.dissipation(&relative(state, self.i, self.j))
    }

    fn member(&self) -> Option<&dyn Member> {
        self.law.has_sections().then_some(self)
    }

    fn load_of_state(&self) -> Option<&dyn LoadOfState> {
        Some(self)
    }

    fn concern(&self, state: &State) -> Option<Concern> {
        self.law.concern(&relative(state, self.i, self.j))
    }
}

impl<L: Law> Member for Elastic<L> {
    fn inside(&self, state: &State) -> Inside {
        inside(&self.law, &relative(state, self.i, self.j))
    }
}

impl<L: Law> LoadOfState for Elastic<L> {
    fn add_load_gradient(&self, state: &State, side: Side, of: &LoadCotangent, gradient: &mut Gradient) {
        let Response { load, by_position, by_velocity } = self.law.response(&relative(state, self.i, self.j));
        load_gradient(state, (self.i, self.j), side, &load, &by_position, &by_velocity, of, gradient);
    }
}

/// What goes through a member: the loads on its ends, turned into the axes of its section.
///
/// The piece between a cut and I is in balance: it gets `-F`, `-T` from I, and at the cut the opposite
/// of what it does to the rest. So the rest gets `-F`, and about a point at `r` the moment
/// `-T - (d - r) x F`. Points are taken on the straight line from J to I.
pub fn inside<L: Law>(law: &L, motion: &Relative) -> Inside {
    let to_section = law.section_axes(motion).transpose();
    let [fx, fy, fz, tx, ty, tz] = law.load(motion);
    let (force, torque) = (DVec3::new(fx, fy, fz), DVec3::new(tx, ty, tz));
    Inside {
        force: to_section * -force,
        moment_j: to_section * (-torque - motion.d_ji_j.cross(force)),
        moment_i: to_section * -torque,
        angle: law.largest_angle(motion),
    }
}

/// Adds a law between the markers of an object, unless one of them or the law is missing.
pub fn add<L: Law + 'static>(lowering: &mut Lowering<'_>, object: ObjectId, law: Option<L>) {
    let i = lowering.frame_cell(object, "i_marker_name", "force/no-marker");
    let j = lowering.frame_cell(object, "j_marker_name", "force/no-marker");
    let (Some(i), Some(j), Some(law)) = (i, j, law) else { return };
    let bodies = [lowering.body_of_frame(i), lowering.body_of_frame(j)];
    let name = lowering.name(object);
    lowering.add_force(object, Box::new(Elastic { name, i, j, bodies, law }));
}

/// The numbers of a cell in SI, or the default of its field; reports what is no such list.
pub fn numbers<const N: usize>(lowering: &mut Lowering<'_>, object: ObjectId, cell: &str) -> Option<[f64; N]> {
    let database = lowering.database;
    let class = database.object(object).class;
    let given = database.si_numbers(object, cell).or_else(|| {
        let field = class.field(class.cell_index(cell)?);
        let Default::Number(x) = field.default else { return None };
        Some(vec![x * lowering.factor(field.dimension); N])
    });
    let found =
        given.and_then(|list| <[f64; N]>::try_from(list).ok()).filter(|list| list.iter().all(|x| x.is_finite()));
    if found.is_none() {
        let (name, word) = (lowering.name(object), word_of(database, object));
        let wanted = if N == 1 { "a finite number".to_string() } else { format!("{N} finite numbers") };
        lowering.report(
            Diagnostic::error("force/not-a-number", format!("`{cell}` of {word} `{name}` is not {wanted}"))
                .help(format!("give `{cell}` {wanted}")),
        );
    }
    found
}
