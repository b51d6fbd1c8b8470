//! `move ...`: objects put somewhere else. Elements between markers move with their markers; what
//! is below a moved object moves with it.

use glam::{DMat3, DVec3};
use model::{Array, CellKey, CoordinateSystem, ObjectId, Pose, Sequence, Value, angles_of, rotation_of};
use schema::{Dimension, Field, Kind, Rule, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry,
    shared::{self, Outcome},
};
use crate::{Interpreter, call::Call, interpreter::Flow, place, values::Draft};

const fn of(name: &'static str, class: &'static str) -> Field {
    Field::objects(name, class).doc("objects to move")
}

const fn number(name: &'static str, doc: &'static str) -> Field {
    Field::real(name, Dimension::NONE).doc(doc)
}

const OBJECTS: [Field; 10] = [
    of("marker_name", "marker"),
    of("part_name", "body"),
    of("flexible_body_name", "flexible_body"),
    of("external_system_name", "external_system"),
    of("point_mass_name", "point_mass"),
    of("geometry_name", "geometry"),
    of("constraint_name", "constraint"),
    of("force_name", "force"),
    Field::object("group_name", "group").doc("group whose members to move"),
    of("entity_name", "any"),
];
const C: [Field; 3] = [
    number("c1", "first coordinate in the current coordinate system"),
    number("c2", "second coordinate in the current coordinate system"),
    number("c3", "third coordinate in the current coordinate system"),
];
const A: [Field; 3] = [
    number("a1", "first angle in the current sequence"),
    number("a2", "second angle in the current sequence"),
    number("a3", "third angle in the current sequence"),
];
const FRAMES: [Field; 5] = [
    Field::object("csmodel_name", "model").doc("model in whose global frame numbers are given"),
    Field::object("cspart_name", "body").doc("part in whose frame numbers are given"),
    Field::object("csmarker_name", "marker").doc("marker in whose frame numbers are given"),
    Field::text("csview_name").doc("view in whose frame numbers are given; views do not exist in Flexure"),
    Field::object("csentity_name", "any").doc("object in whose frame numbers are given"),
];
const MOVED: &[&str] = &[
    "marker_name",
    "part_name",
    "flexible_body_name",
    "external_system_name",
    "point_mass_name",
    "geometry_name",
    "constraint_name",
    "force_name",
    "group_name",
    "entity_name",
];
const FRAME_NAMES: &[&str] = &["csmodel_name", "cspart_name", "csmarker_name", "csview_name", "csentity_name"];
const RULES: &[Rule] = &[Rule::AtMostOne(MOVED), Rule::AtMostOne(FRAME_NAMES)];

/// Several tables of fields as one.
const fn joined<const N: usize>(lists: &[&[Field]]) -> [Field; N] {
    let mut all = [OBJECTS[0]; N];
    let (mut list, mut at) = (0, 0);
    while list < lists.len() {
        let mut i = 0;
        while i < lists[list].len() {
            all[at] = lists[list][i];
            at += 1;
            i += 1;
        }
        list += 1;
    }
    all
}

const INCREMENTALLY: Field =
    Field::yes_no("incrementally").default_word("no").doc("numbers are added to the present place");
const ABOUT: Field = Field::yes_no("about").default_word("no").doc("turn about the origin of the frame, places too");

pub const OBJECT: VerbEntry = entry(
    Verb {
        path: "move object",
        fields: &joined::<22>(&[&OBJECTS, &C, &A, &FRAMES, &[INCREMENTALLY]]),
        rules: RULES,
        doc: "puts objects at a place and in a direction given in a frame",
    },
    object,
);
pub const TRANSLATION: VerbEntry = entry(
    Verb {
        path: "move translation",
        fields: &joined::<18>(&[&OBJECTS, &C, &FRAMES]),
        rules: RULES,
        doc: "shifts objects along the axes of a frame",
    },
    translation,
);
pub const ROTATION: VerbEntry = entry(
    Verb {
        path: "move rotation",
        fields: &joined::<19>(&[&OBJECTS, &[ABOUT], &A, &FRAMES]),
        rules: RULES,
        doc: "turns objects about axes of a frame, each in its place or all about its origin",
    },
    rotation,
);

fn translation(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let frame = frame(interpreter, call)?;
    let given = three(interpreter, call, ["c1", "c2", "c3"], true)?.map(|x| x.unwrap_or(0.0));
    let shift = frame.rotation * place::cartesian(&interpreter.database, &given);
    each(interpreter, call, |_, pose| Pose { origin: pose.origin + shift, ..pose })
}

fn rotation(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let frame = frame(interpreter, call)?;
    let given = three(interpreter, call, ["a1", "a2", "a3"], true)?.map(|x| x.unwrap_or(0.0));
    let about = interpreter.flag_argument(call, "about")? == Some(true);
    let turn = frame.rotation * rotation_by(interpreter, given) * frame.rotation.transpose();
    each(interpreter, call, |_, pose| Pose {
        origin: if about { frame.origin + turn * (pose.origin - frame.origin) } else { pose.origin },
        rotation: turn * pose.rotation,
    })
}

fn object(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let frame = frame(interpreter, call)?;
    let c = three(interpreter, call, ["c1", "c2", "c3"], false)?;
    let a = three(interpreter, call, ["a1", "a2", "a3"], false)?;
    let add = interpreter.flag_argument(call, "incrementally")? == Some(true);
    let angle = interpreter.database.units().angle.si;
    let sequence = interpreter.database.settings().sequence;
    // Angles that are not given stay as they are; only those of body 3-1-3 can be told from a direction.
    if let (false, Some(first), true) =
        (add, ["a1", "a2", "a3"].iter().zip(&a).find(|(_, x)| x.is_none()), a.iter().any(Option::is_some))
        && sequence != Sequence::BODY_313
    {
        return Err(vec![call.missing(&[first.0])]);
    }
    let filled = |given: [Option<f64>; 3], now: [f64; 3]| [0, 1, 2].map(|k| given[k].unwrap_or(now[k]));
    each(interpreter, call, |interpreter, pose| {
        let mut new = pose;
        if c.iter().any(Option::is_some) {
            let now = frame.rotation.transpose() * (pose.origin - frame.origin);
            new.origin = if add {
                pose.origin + frame.rotation * place::cartesian(&interpreter.database, &c.map(|x| x.unwrap_or(0.0)))
            } else {
                let all = filled(c, coordinates(interpreter, now));
                frame.origin + frame.rotation * place::cartesian(&interpreter.database, &all)
            };
        }
        if a.iter().any(Option::is_some) {
            new.rotation = if add {
                let turn = rotation_by(interpreter, a.map(|x| x.unwrap_or(0.0)));
                frame.rotation * turn * frame.rotation.transpose() * pose.rotation
            } else {
                let now = frame.rotation.transpose() * pose.rotation;
                frame.rotation * rotation_by(interpreter, filled(a, angles_of(&now).map(|x| x / angle)))
            };
        }
        new
    })
}

fn rotation_by(interpreter: &Interpreter, angles: [f64; 3]) -> DMat3 {
    let angle = interpreter.database.units().angle.si;
    rotation_of(interpreter.database.settings().sequence, angles.map(|a| a * angle))
}

/// Cartesian coordinates as the current coordinate system has them.
fn coordinates(interpreter: &Interpreter, v: DVec3) -> [f64; 3] {
    let angle = interpreter.database.units().angle.si;
    let turn = v.y.atan2(v.x) / angle;
    match interpreter.database.settings().coordinate_system {
        CoordinateSystem::Cartesian => v.to_array(),
        CoordinateSystem::Cylindrical => [v.x.hypot(v.y), turn, v.z],
        CoordinateSystem::Spherical => [v.length(), turn, v.x.hypot(v.y).atan2(v.z) / angle],
    }
}

fn three(interpreter: &mut Interpreter, call: &Call, names: [&str; 3], required: bool) -> Outcome<[Option<f64>; 3]> {
    let mut found = [None; 3];
    for (slot, name) in found.iter_mut().zip(names) {
        *slot = interpreter.number_argument(call, name)?;
        if required && slot.is_none() {
            return Err(vec![call.missing(&[name])]);
        }
    }
    Ok(found)
}

/// The frame in which numbers are given, in global axes.
fn frame(interpreter: &mut Interpreter, call: &Call) -> Outcome<Pose> {
    if let Some(argument) = call.argument("csview_name") {
        return Err(vec![
            Diagnostic::error("move/view", "a view is no frame in Flexure")
                .at(argument.value_span, "views do not exist")
                .help("give a marker with `csmarker_name`"),
        ]);
    }
    for name in ["csmodel_name", "cspart_name", "csmarker_name", "csentity_name"] {
        if let Some(id) = interpreter.object_argument(call, name)? {
            return Ok(interpreter.database.global_pose(id));
        }
    }
    let database = &interpreter.database;
    let frame = database.settings().default_frame.filter(|f| database.get(*f).is_some());
    Ok(frame.map_or(Pose::GLOBAL, |f| database.global_pose(f)))
}

/// Moves everything a command names by a rule for global poses.
fn each(interpreter: &mut Interpreter, call: &Call, rule: impl Fn(&Interpreter, Pose) -> Pose) -> Outcome<Flow> {
    let mut named = Vec::new();
    for (parameter, argument) in call.objects().filter(|(p, _)| MOVED.contains(&&*p.name)) {
        named.extend(interpreter.read_value(call, &parameter.field, argument, None)?.value.objects());
    }
    if named.is_empty() {
        return Err(vec![call.missing(&["marker_name"])]);
    }
    let mut moved = Vec::new();
    for id in shared::expanded(&interpreter.database, &named) {
        let carriers = interpreter.carriers(id);
        if carriers.is_empty() {
            let name = interpreter.database.full_name(id);
            return Err(vec![
                Diagnostic::error("move/no-place", format!("`{name}` has no place of its own"))
                    .at(call.span, "cannot be moved")
                    .help("move the part or the markers it belongs to"),
            ]);
        }
        moved.extend(carriers.into_iter().filter(|c| !moved.contains(c)).collect::<Vec<_>>());
    }
    // What is below something that moves has moved already.
    let all = moved.clone();
    moved.retain(|id| {
        let mut parent = interpreter.database.object(*id).parent;
        while let Some(p) = parent {
            if all.contains(&p) {
                return false;
            }
            parent = interpreter.database.object(p).parent;
        }
        true
    });
    let mut changed = Vec::new();
    for id in moved {
        let pose = rule(interpreter, interpreter.database.global_pose(id));
        interpreter.put_at(id, &pose, &mut changed);
    }
    interpreter.recompute(&changed, call.span)?;
    Ok(Flow::Next)
}

impl Interpreter {
    /// The objects whose places make the place of another: itself, or the markers it is between.
    fn carriers(&self, id: ObjectId) -> Vec<ObjectId> {
        let object = self.database.object(id);
        if object.class.id == "ground" {
            return Vec::new();
        }
        if object
            .class
            .fields()
            .any(|f| f.name == "location" && f.kind == Kind::Location && f.usage != schema::Use::Create)
        {
            return vec![id];
        }
        let referred = object.cells.values().flat_map(|c| c.value.objects());
        let mut found: Vec<ObjectId> = Vec::new();
        for marker in referred.filter(|r| self.database.get(*r).is_some_and(|o| o.class.is("marker"))) {
            if !found.contains(&marker) {
                found.push(marker);
            }
        }
        found
    }

    /// Puts an object at a pose in global axes. Expressions for its place are replaced.
    pub(crate) fn put_at(&mut self, id: ObjectId, pose: &Pose, changed: &mut Vec<CellKey>) {
        let object = self.database.object(id);
        let class = object.class;
        let parent = object.parent.map_or(Pose::GLOBAL, |p| self.database.global_pose(p));
        let old = self.database.global_pose(id);
        let local = parent.inverse().then(pose);
        let angle = self.database.units().angle.si;
        let angles = angles_of(&local.rotation).map(|a| a / angle);
        let turned = !old.rotation.abs_diff_eq(pose.rotation, 1e-15);
        for (name, numbers, wanted) in
            [("location", local.origin.to_array(), old.origin != pose.origin), ("orientation", angles, turned)]
        {
            if let (true, Some(cell)) = (wanted, class.cell_index(name)) {
                let key = CellKey::new(id, cell);
                self.store(key, Draft::literal(Value::Array(Array::column(numbers.to_vec()))));
                changed.push(key);
            }
        }
    }
}
