//! `list_info ...`: what a session holds, one line for each value. The layout is our own:
//! `Label : value (unit)`, from the tables of the classes. The listings themselves are in
//! [`super::listing`].

use model::ObjectId;
use schema::{Field, Kind, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry, listing,
    shared::{self, Outcome},
};
use crate::{Interpreter, call::Call, interpreter::Flow};

const BRIEF: Field = Field::on_off("brief").default_word("on").doc("short form: only values that are set");
const SHOW: Field = shared::SHOW;
const FILE: Field = Field::text("file_name").doc("file for the listing");
const LEVELS: Field = Field::integer("influencer_levels").doc("levels of objects this one depends on");

const fn verb(path: &'static str, fields: &'static [Field]) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc: "lists the values of objects" }, list)
}

const fn report(path: &'static str, fields: &'static [Field], run: super::Run, doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, run)
}

const fn of(name: &'static str, class: &'static str) -> Field {
    Field::objects(name, class).current().doc("objects to list")
}

pub const ENTITY: VerbEntry = verb(
    "list_info entity",
    &[
        of("entity_name", "any"),
        Field::integer("adams_id").doc("take only objects of this number"),
        LEVELS,
        shared::TYPE_FILTER,
        BRIEF,
        SHOW,
        FILE,
    ],
);
pub const FORCE: VerbEntry = verb(
    "list_info force",
    &[
        of("force_name", "force"),
        of("single_component_force_name", "single_component_force"),
        of("force_vector_name", "force_vector"),
        of("torque_vector_name", "torque_vector"),
        of("general_force_name", "general_force"),
        of("multi_point_force_name", "multi_point_force"),
        of("gravity_field_name", "gravity"),
        of("beam_name", "beam"),
        of("bushing_name", "bushing"),
        of("field_name", "field"),
        of("spring_damper_name", "spring_damper"),
        BRIEF,
        SHOW,
        FILE,
    ],
);
pub const PART: VerbEntry = verb(
    "list_info part",
    &[
        of("part_name", "body"),
        of("flexible_body_name", "flexible_body"),
        of("point_mass_name", "point_mass"),
        of("equation_name", "equation"),
        LEVELS,
        BRIEF,
        SHOW,
        FILE,
    ],
);
pub const MARKER: VerbEntry = verb("list_info marker", &[of("marker_name", "marker"), LEVELS, BRIEF, SHOW, FILE]);
pub const MODEL: VerbEntry = verb("list_info model", &[of("model_name", "model"), BRIEF, SHOW, FILE]);
pub const VARIABLE: VerbEntry = verb("list_info variable", &[of("variable_name", "variable"), BRIEF, SHOW, FILE]);
pub const GROUP: VerbEntry = verb("list_info group", &[of("group_name", "group"), BRIEF, SHOW, FILE]);
pub const MACRO: VerbEntry = verb("list_info macro", &[of("macro_name", "macro"), BRIEF, SHOW, FILE]);
pub const CONSTRAINT: VerbEntry = verb(
    "list_info constraint",
    &[
        of("constraint_name", "constraint"),
        of("joint_name", "joint"),
        of("gear_name", "gear"),
        of("coupler_name", "coupler"),
        of("jprim_name", "constraint"),
        of("point_curve_name", "point_curve"),
        of("curve_curve_name", "curve_curve"),
        of("motion_name", "motion"),
        of("user_constraint_name", "user_constraint"),
        BRIEF,
        SHOW,
        FILE,
    ],
);
pub const DATA_ELEMENT: VerbEntry = verb(
    "list_info data_element",
    &[
        of("data_element_name", "data_element"),
        of("curve_name", "data_element"),
        of("spline_name", "data_element"),
        of("variable_name", "data_element"),
        of("array_name", "data_element"),
        of("matrix_name", "data_element"),
        of("plant_input_name", "data_element"),
        of("plant_output_name", "data_element"),
        of("plant_state_name", "data_element"),
        of("string_name", "data_element"),
        BRIEF,
        SHOW,
        FILE,
    ],
);
pub const GEOMETRY: VerbEntry = verb(
    "list_info geometry",
    &[
        of("geometry_name", "geometry"),
        of("arc_name", "geometry"),
        of("block_name", "geometry"),
        of("circle_name", "geometry"),
        of("cylinder_name", "geometry"),
        of("frustum_name", "geometry"),
        of("force_name", "geometry"),
        of("outline_name", "geometry"),
        of("polyline_name", "geometry"),
        of("spring_damper_name", "geometry"),
        of("gstring_name", "geometry"),
        of("ellipsoid_name", "geometry"),
        of("torus_name", "geometry"),
        of("revolution_name", "geometry"),
        of("extrusion_name", "geometry"),
        of("plane_name", "geometry"),
        BRIEF,
        SHOW,
        FILE,
    ],
);
pub const NAMES: VerbEntry = report(
    "list_info names",
    &[of("entity_name", "any"), shared::TYPE_FILTER, BRIEF, SHOW, FILE],
    names,
    "lists full names, in the long form with types",
);
pub const TOPOLOGY: VerbEntry = report(
    "list_info topology",
    &[
        of("model_name", "model"),
        Field::choice("output_by", &["parts", "connections"]).default_word("parts").doc("what the lists are sorted by"),
        BRIEF,
        SHOW,
        FILE,
    ],
    topology,
    "lists which elements connect which parts",
);
pub const MEASURE: VerbEntry = report(
    "list_info measure",
    &[
        Field::object("i_marker_name", "frame").required().doc("marker to which the distance goes"),
        Field::object("j_marker_name", "frame").doc("marker from which it goes; the global origin if not given"),
        Field::object("r_marker_name", "frame").doc("marker along whose axes components are listed"),
        Field::object("model_name", "model").doc("model"),
        Field::object("analysis_name", "analysis").doc("run whose state is measured"),
        Field::text("configuration").doc("state that is measured"),
        Field::real("time", schema::Dimension::TIME).doc("time within the run"),
        Field::integer("frame_number").doc("output step of the run"),
        BRIEF,
        SHOW,
        FILE,
    ],
    measure,
    "lists the distance between two markers as the model is built",
);
pub const DEFAULTS: VerbEntry =
    report("list_info defaults", &[BRIEF, SHOW, FILE], defaults, "lists units, frames and current objects");
pub const NAME_GENERATION: VerbEntry =
    report("list_info name_generation", &[BRIEF, SHOW, FILE], name_generation, "lists how names are generated");
pub const UNDO: VerbEntry =
    report("list_info undo", &[BRIEF, SHOW, FILE], undo, "lists how many steps can be taken back and done again");

/// The objects a command names, or the current one of the first parameter.
fn chosen(interpreter: &mut Interpreter, call: &Call) -> Outcome<Vec<ObjectId>> {
    let mut ids = Vec::new();
    for (parameter, argument) in call.objects() {
        ids.extend(interpreter.read_value(call, &parameter.field, argument, None)?.value.objects());
    }
    let number = match call.field("adams_id") {
        Some(_) => interpreter.number_argument(call, "adams_id")?,
        None => None,
    };
    if call.objects().next().is_none() && number.is_some() {
        // A number alone is looked for in the whole model.
        ids.extend(interpreter.database.current("model").map(|m| interpreter.database.subtree(m)).unwrap_or_default());
    } else if call.objects().next().is_none() {
        let Some(first) = call.parameters.first() else { return Ok(ids) };
        let wanted = match first.field.kind {
            Kind::Object(_, wanted) => wanted,
            _ => "any",
        };
        match interpreter.database.current(wanted) {
            Some(id) => ids.push(id),
            None => return Err(vec![call.missing(&[&*first.name])]),
        }
    }
    if call.field("type_filter").is_some() {
        shared::filter_by_type(interpreter, call, &mut ids)?;
    }
    if let Some(number) = number {
        ids.retain(|id| interpreter.database.integer(*id, "adams_id") == Some(number as i64));
        if ids.is_empty() {
            let span = call.argument("adams_id").map_or(call.span, |a| a.value_span);
            let error = Diagnostic::error("name/not-found", format!("nothing has the number {number}"));
            return Err(vec![error.at(span, "not found").help("`list_info names` lists what there is")]);
        }
    }
    Ok(ids)
}

/// Shows lines and writes them to the file that is named.
pub fn deliver(interpreter: &mut Interpreter, call: &Call, lines: &[String]) -> Outcome<Flow> {
    if interpreter.flag_argument(call, "write_to_terminal")? != Some(false) {
        interpreter.show(lines);
    }
    interpreter.write_lines(call, "file_name", lines)?;
    Ok(Flow::Next)
}

fn brief(interpreter: &mut Interpreter, call: &Call) -> Outcome<bool> {
    Ok(interpreter.flag_argument(call, "brief")? != Some(false))
}

fn list(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let ids = chosen(interpreter, call)?;
    let brief = brief(interpreter, call)?;
    let mut levels = 0;
    if call.field("influencer_levels").is_some() {
        levels = interpreter.number_argument(call, "influencer_levels")?.unwrap_or(0.0).max(0.0) as usize;
    }
    let mut lines = Vec::new();
    for id in ids {
        if !lines.is_empty() {
            lines.push(String::new());
        }
        listing::describe(interpreter, id, brief, &mut lines);
        if levels > 0 {
            listing::influencers(interpreter, id, levels, &mut lines);
        }
    }
    deliver(interpreter, call, &lines)
}

fn names(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let ids = if call.argument("entity_name").is_some() {
        chosen(interpreter, call)?
    } else {
        let mut all: Vec<ObjectId> = match interpreter.database.current("model") {
            Some(model) => interpreter.database.subtree(model),
            None => interpreter.database.ids().collect(),
        };
        shared::filter_by_type(interpreter, call, &mut all)?;
        all
    };
    let brief = brief(interpreter, call)?;
    let database = &interpreter.database;
    let line = |id: &ObjectId| {
        let name = database.full_name(*id);
        if brief { name } else { format!("{name} : {}", database.object(*id).class.word) }
    };
    let lines: Vec<String> = ids.iter().map(line).collect();
    deliver(interpreter, call, &lines)
}

fn topology(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let models = chosen(interpreter, call)?;
    let by_parts = interpreter.word_of(call, "output_by")?.as_deref() != Some("connections");
    let brief = brief(interpreter, call)?;
    let mut lines = Vec::new();
    for model in models {
        listing::topology(&interpreter.database, model, by_parts, brief, &mut lines);
    }
    deliver(interpreter, call, &lines)
}

fn measure(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some(i) = interpreter.object_argument(call, "i_marker_name")? else {
        return Err(vec![call.missing(&["i_marker_name"])]);
    };
    let j = interpreter.object_argument(call, "j_marker_name")?;
    let r = interpreter.object_argument(call, "r_marker_name")?;
    interpreter.object_argument(call, "model_name")?;
    let brief = brief(interpreter, call)?;
    let database = &interpreter.database;
    let pose = |id: Option<ObjectId>| id.map_or(model::Pose::GLOBAL, |id| database.global_pose(id));
    let away = pose(r).rotation.transpose() * (pose(Some(i)).origin - pose(j).origin);
    let unit = database.units().label(schema::Dimension::LENGTH);
    let name = |id: Option<ObjectId>| id.map_or("global".to_string(), |id| database.full_name(id));
    let mut lines = vec![format!("From {} to {} along {}", name(j), name(Some(i)), name(r))];
    for (label, x) in [("Magnitude", away.length()), ("X", away.x), ("Y", away.y), ("Z", away.z)] {
        lines.push(format!("{label:<16}: {} ({unit})", listing::shown(x)));
    }
    if !brief {
        let turned = pose(j).rotation.transpose() * pose(Some(i)).rotation;
        let angle = database.units().angle;
        let angles = model::angles_of(&turned).map(|a| listing::shown(a / angle.si)).join(", ");
        lines.push(format!("{:<16}: {angles} ({})", "Body 3-1-3", angle.name));
    }
    deliver(interpreter, call, &lines)
}

fn defaults(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let brief = brief(interpreter, call)?;
    let lines = listing::defaults(interpreter, brief);
    deliver(interpreter, call, &lines)
}

fn name_generation(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let brief = brief(interpreter, call)?;
    let lines = super::name_generation::listing(&interpreter.database, brief);
    deliver(interpreter, call, &lines)
}

fn undo(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    brief(interpreter, call)?;
    let (done, undone) = interpreter.database.history_depth();
    let lines = [format!("{:<16}: {done}", "Undo steps"), format!("{:<16}: {undone}", "Redo steps")];
    deliver(interpreter, call, &lines)
}

/// The complaint of a listing that has nothing to compute from.
pub fn nothing_to_list(call: &Call, what: &str) -> Diagnostic {
    Diagnostic::error("list/nothing", format!("there is {what}")).at(call.span, "nothing to list")
}
