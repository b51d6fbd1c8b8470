//! What a model looks like: its shapes once, where they are at any time, and line pictures of them.
//! Nothing here knows a view; colours are the only thing beyond geometry.

use glam::DVec3;
use model::{Database, ObjectId, Pose};
use results::Polyline;
use text::Diagnostic;

use crate::{
    geometry::{self, Placed, spring_damper_graphic},
    place::{Cells, OnBody, global_pose},
};

#[path = "forces/beam/draw.rs"]
mod beam_line;

/// A shape fixed in a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    pub id: ObjectId,
    pub placed: Placed,
    /// Red, green, blue.
    pub colour: [u8; 3],
}

/// What hangs between two bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Between {
    pub id: ObjectId,
    pub i: OnBody,
    pub j: OnBody,
    pub look: Look,
    pub colour: [u8; 3],
}

/// How something between two frames is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// The centre line of a beam.
    Beam,
    /// A coil; diameter in metre.
    Coil { turns: f64, diameter: f64 },
}

/// A place where a view that knows loads may draw one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    pub id: ObjectId,
    /// The force or constraint whose load is shown.
    pub of: ObjectId,
    pub at: OnBody,
}

/// Everything visible of a model. Built once; drawn at any positions of the bodies.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    pub solids: Vec<Solid>,
    pub between: Vec<Between>,
    pub arrows: Vec<Arrow>,
    /// What could not be drawn, and why.
    pub troubles: Vec<Diagnostic>,
}

impl Scene {
    /// What is visible below a model.
    pub fn of(database: &Database, model: ObjectId) -> Scene {
        let mut scene = Scene::default();
        for id in database.below(model, "any") {
            let class = database.object(id).class;
            if !(class.is("geometry") || class.id == "beam") || !visible(database, id) {
                continue;
            }
            if let Some(shape) = geometry::shape(database, id) {
                match shape {
                    Ok(placed) => scene.solids.push(Solid { id, placed, colour: colour(database, id) }),
                    Err(trouble) => scene.troubles.push(trouble),
                }
                continue;
            }
            if let Err(trouble) = scene.add_other(database, id) {
                scene.troubles.push(trouble);
            }
        }
        scene
    }

    fn add_other(&mut self, database: &Database, id: ObjectId) -> Result<(), Diagnostic> {
        let cells = Cells { database, id };
        let look = match database.object(id).class.id {
            "beam" => Look::Beam,
            "spring_damper_graphic" => Look::Coil {
                turns: database.integer(id, "coil_count").unwrap_or(3).clamp(1, 200) as f64,
                diameter: cells.above_zero("diameter_of_spring")?,
            },
            _ => {
                if let Some(trouble) = geometry::not_drawn(database, id) {
                    return Err(trouble);
                }
                let of = ["force_element_name", "joint_name", "jprim_name", "curve_curve_name", "point_curve_name"];
                if let Some(of) = of.iter().find_map(|name| database.reference(id, name)) {
                    self.arrows.push(Arrow { id, of, at: cells.frame("applied_at_marker_name")? });
                }
                return Ok(());
            }
        };
        let (i, j) = (cells.frame("i_marker_name")?, cells.frame("j_marker_name")?);
        self.between.push(Between { id, i, j, look, colour: colour(database, id) });
        Ok(())
    }

    /// Lines of a wire picture in global axes, metre, with the bodies at the poses that `pose` gives
    /// (metre); a body without one is left out.
    pub fn lines(&self, pose: &dyn Fn(ObjectId) -> Option<Pose>) -> Vec<Polyline> {
        let at = |on: &OnBody| pose(on.body).map(|body| body.then(&on.pose));
        let mut lines = Vec::new();
        let mut add = |points: Vec<DVec3>, colour: [u8; 3], width: u32| {
            lines.push(Polyline { points: points.iter().map(DVec3::to_array).collect(), colour, opacity: 1.0, width });
        };
        for solid in &self.solids {
            let Some(frame) = at(&solid.placed.on) else { continue };
            for line in solid.placed.shape.lines() {
                add(line.iter().map(|p| frame.origin + frame.rotation * *p).collect(), solid.colour, 1);
            }
        }
        for element in &self.between {
            let (Some(i), Some(j)) = (at(&element.i), at(&element.j)) else { continue };
            match element.look {
                Look::Beam => add(beam_line::centre_line(&i, &j), element.colour, 2),
                Look::Coil { turns, diameter } => {
                    add(spring_damper_graphic::draw::coil(i.origin, j.origin, turns, diameter), element.colour, 1);
                }
            }
        }
        lines
    }
}

/// A wire picture of a model as it was built, metre, and what could not be drawn.
pub fn draw_model(database: &Database, model: ObjectId) -> (Vec<Polyline>, Vec<Diagnostic>) {
    let scene = Scene::of(database, model);
    let lines = scene.lines(&|body| Some(global_pose(database, body)));
    (lines, scene.troubles)
}

/// Whether neither the object nor what it is part of is switched off.
fn visible(database: &Database, id: ObjectId) -> bool {
    let off = |id| database.text(id, "visibility") == Some("off") || database.text(id, "active") == Some("off");
    !off(id) && database.object(id).parent.is_none_or(|parent| !off(parent))
}

/// The colour of an object, else that of its part, else one by kind.
fn colour(database: &Database, id: ObjectId) -> [u8; 3] {
    let own = database.text(id, "color").and_then(named);
    let parents = || database.text(database.object(id).parent?, "color").and_then(named);
    let usual = if database.object(id).class.id == "beam" { [200, 80, 40] } else { [70, 90, 110] };
    own.or_else(parents).unwrap_or(usual)
}

/// Colours by name, darkened where needed to be seen on white paper.
fn named(name: &str) -> Option<[u8; 3]> {
    let name = name.rsplit('.').next()?.to_ascii_lowercase();
    Some(match name.as_str() {
        "red" => [205, 40, 40],
        "green" => [40, 150, 60],
        "blue" => [40, 80, 200],
        "cyan" => [20, 150, 170],
        "magenta" => [180, 40, 160],
        "yellow" => [190, 160, 20],
        "maize" => [200, 150, 50],
        "coral" => [220, 110, 80],
        "peach" => [220, 150, 110],
        "aquamarine" => [60, 170, 140],
        "violet" => [130, 80, 190],
        "skyblue" => [90, 150, 210],
        "midnight_blue" => [30, 40, 110],
        "dimgray" => [90, 90, 90],
        "gray" | "grey" | "silver" => [130, 130, 130],
        "black" => [20, 20, 20],
        "white" | "light_gray" => [160, 160, 165],
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Build;
    use model::Value;

    /// Two parts with a link, joined by a beam and a spring; lengths in inch.
    fn example() -> (Build, ObjectId) {
        let mut b = Build::new();
        let model = b.make("model", None, "model", &[]);
        let red = ("color", Value::Text("RED".into()));
        let base = b.make("part", Some(model), "BASE", &[red]);
        let arm = b.make("part", Some(model), "ARM", &[]);
        let j = b.marker(base, "J", [0.0; 3], [0.0; 3]);
        let end = b.marker(base, "END", [2.0, 0.0, 0.0], [0.0; 3]);
        let i = b.marker(arm, "I", [10.0, 0.0, 0.0], [0.0; 3]);
        let object = Value::Object;
        let number = Value::Number;
        let link = [("i_marker", object(j)), ("j_marker", object(end)), ("width", number(1.0)), ("depth", number(0.5))];
        b.make("link", Some(base), "LINK", &link);
        b.make("beam", Some(model), "BEAM", &[("i_marker_name", object(i)), ("j_marker_name", object(j))]);
        b.make(
            "spring_damper_graphic",
            Some(base),
            "SPRING",
            &[("i_marker_name", object(i)), ("j_marker_name", object(j))],
        );
        (b, model)
    }

    #[test]
    fn a_model_is_drawn_in_metres_with_the_colours_of_its_parts() {
        let (b, model) = example();
        let (lines, troubles) = draw_model(&b.database, model);
        assert_eq!(troubles, []);
        let inch = 0.0254;
        // The beam goes from J to I, 10 inch along x.
        let beam = lines.iter().find(|l| l.width == 2).unwrap();
        assert_eq!(beam.points[0], [0.0; 3]);
        assert!((beam.points[8][0] - 10.0 * inch).abs() < 1e-15);
        // The link ends half a width beyond its markers and is half its depth above them.
        let red: Vec<_> = lines.iter().filter(|l| l.colour == [205, 40, 40] && l.width == 1).collect();
        let highest = |axis: usize| red.iter().flat_map(|l| &l.points).map(|p| p[axis]).fold(f64::MIN, f64::max);
        assert!((highest(2) - 0.5 * inch).abs() < 1e-12, "the spring is wider than the link is deep");
        assert!((highest(0) - 10.0 * inch).abs() < 1e-12);
    }

    #[test]
    fn bodies_move_their_shapes_and_those_without_a_place_are_left_out() {
        let (b, model) = example();
        let scene = Scene::of(&b.database, model);
        let arm = b.database.find(".model.ARM", "part").unwrap();
        let up = Pose { origin: DVec3::Z, rotation: glam::DMat3::IDENTITY };
        let lines = scene.lines(&|body| Some(if body == arm { up } else { Pose::GLOBAL }));
        let beam = lines.iter().find(|l| l.width == 2).unwrap();
        assert!((beam.points.last().unwrap()[2] - 1.0).abs() < 1e-15);
        let fewer = scene.lines(&|body| (body != arm).then_some(Pose::GLOBAL));
        assert!(fewer.iter().all(|l| l.width == 1) && !fewer.is_empty());
    }

    #[test]
    fn what_is_switched_off_is_not_drawn_and_what_is_wrong_is_told() {
        let (mut b, model) = example();
        let link = b.database.find(".model.BASE.LINK", "link").unwrap();
        b.database.set_value(link, "width", Value::Number(-1.0));
        let (_, troubles) = draw_model(&b.database, model);
        assert_eq!(troubles.len(), 1);
        assert_eq!(troubles[0].message, "link `.model.BASE.LINK` has a `width` that is not above zero");
        b.database.set_value(link, "visibility", Value::Text("off".into()));
        assert_eq!(draw_model(&b.database, model).1, []);
        let base = b.database.find(".model.BASE", "part").unwrap();
        b.database.set_value(base, "visibility", Value::Text("off".into()));
        assert!(draw_model(&b.database, model).0.iter().all(|l| l.width == 2), "only the beam is left");
    }
}
