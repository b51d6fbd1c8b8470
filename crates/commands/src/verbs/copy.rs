//! `* copy`: an object with everything below it once more, under another name.

use schema::{Dimension, Field, Kind, Names, Rule, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry,
    shared::{self, Outcome},
    twins::Twins,
};
use crate::{Interpreter, call::Call, interpreter::Flow, lookup};

const fn verb(path: &'static str, fields: &'static [Field]) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc: "copies an object and what is below it" }, copy)
}

const fn old(name: &'static str, class: &'static str) -> Field {
    Field::object(name, class).current().doc("object to copy")
}

const fn new(name: &'static str, class: &'static str) -> Field {
    Field::new(name, Kind::Object(Names::New, class)).doc("name of the copy; generated if not given")
}

pub const MODEL: VerbEntry = entry(
    Verb {
        path: "model copy",
        fields: &[
            old("model_name", "model"),
            Field::object("analysis_name", "analysis").doc("run from which the copy takes its state"),
            Field::integer("frame_number").default(1.0).doc("output step of the run"),
            Field::real("time", Dimension::TIME).default(0.0).doc("time within the run"),
            Field::yes_no("include_contact_steps").default_word("no").doc("count the steps at contacts too"),
            Field::yes_no("more_results").default_word("no").doc("take further results"),
            Field::yes_no("index_time").default_word("no").doc("count steps by time"),
            new("new_model_name", "model"),
            shared::VIEWS,
        ],
        rules: &[Rule::AtMostOne(&["frame_number", "time"])],
        doc: "copies a model as it is built",
    },
    copy,
);
pub const PART: VerbEntry = entry(
    Verb {
        path: "part copy",
        fields: &[
            old("part_name", "body"),
            new("new_part_name", "body"),
            shared::VIEWS,
            old("flexible_body_name", "flexible_body"),
            new("new_flexible_body_name", "flexible_body"),
            old("point_mass_name", "point_mass"),
            new("new_point_mass_name", "point_mass"),
            old("equation_name", "equation"),
            new("new_equation_name", "equation"),
        ],
        rules: &[
            Rule::AtMostOne(&["part_name", "flexible_body_name", "point_mass_name", "equation_name"]),
            Rule::AtMostOne(&["new_part_name", "new_equation_name", "new_flexible_body_name", "new_point_mass_name"]),
        ],
        doc: "copies a body with its markers and shapes",
    },
    copy,
);
pub const MARKER: VerbEntry = verb("marker copy", &[old("marker_name", "marker"), new("new_marker_name", "marker")]);
pub const POINT: VerbEntry = verb("point copy", &[old("point_name", "point"), new("new_point_name", "point")]);
pub const FORCE: VerbEntry = verb("force copy", &[old("force_name", "force"), new("new_force_name", "force")]);
pub const CONTACT: VerbEntry =
    verb("contact copy", &[old("contact_name", "contact"), new("new_contact_name", "contact")]);
pub const CONSTRAINT: VerbEntry =
    verb("constraint copy", &[old("constraint_name", "constraint"), new("new_constraint_name", "constraint")]);
pub const GEOMETRY: VerbEntry =
    verb("geometry copy", &[old("geometry_name", "geometry"), new("new_geometry_name", "geometry")]);
pub const DATA_ELEMENT: VerbEntry = verb(
    "data_element copy",
    &[old("data_element_name", "data_element"), new("new_data_element_name", "data_element")],
);
pub const SECTION: VerbEntry =
    verb("section copy", &[old("section_name", "section"), new("new_section_name", "section")]);
pub const GROUP: VerbEntry = verb("group copy", &[old("group_name", "group"), new("new_group_name", "group")]);
pub const SCRIPT: VerbEntry =
    verb("simulation script copy", &[old("sim_script_name", "script"), new("new_sim_script_name", "script")]);
pub const ENTITY: VerbEntry = verb("entity copy", &[old("entity_name", "any"), new("new_entity_name", "any")]);

fn copy(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let parameters = call.parameters.clone();
    // The pair that is meant: the one of which something is given, otherwise the first.
    let is_pair = |name: &str| parameters.iter().any(|p| *p.name == *format!("new_{name}"));
    let pairs = || parameters.iter().filter(|p| is_pair(&p.name));
    let given = |name: &str| call.given.iter().any(|g| &*call.parameters[g.parameter].name == name);
    let Some(old) =
        pairs().find(|p| given(&p.name) || given(&format!("new_{}", p.name))).or_else(|| pairs().next()).cloned()
    else {
        return Ok(Flow::Next);
    };
    let wanted = match old.field.kind {
        Kind::Object(_, wanted) => wanted,
        _ => "any",
    };
    let Some(id) = interpreter.object_argument(call, &old.name)?.or_else(|| interpreter.database.current(wanted))
    else {
        return Err(vec![call.missing(&[&old.name])]);
    };
    let object = interpreter.database.object(id);
    let (class, parent) = (object.class, object.parent);
    if class.id == "ground" {
        return Err(vec![
            Diagnostic::error("name/permanent", "the ground of a model cannot be copied")
                .at(call.span, "a model has one ground")
                .help("copy its markers one by one"),
        ]);
    }
    let (place, typed, span) = if let Some(argument) = call.argument(&format!("new_{}", old.name)) {
        let typed = interpreter.text_argument(call, argument)?;
        let mut place =
            lookup::new_name(&interpreter.database, &interpreter.registry, class, &typed, argument.value_span)
                .map_err(|e| vec![e])?;
        if !typed.starts_with('.') {
            place.parent = parent;
        }
        (place, typed, argument.value_span)
    } else {
        let name = interpreter.generate_name(class, parent);
        (lookup::NewName { parent, name: name.clone() }, name, call.keywords)
    };
    let twins = interpreter.make_twins(&[(id, place)], Twins::new(), &typed, span)?;
    if let Some(twin) = twins.get(&id) {
        interpreter.database.make_current(*twin);
    }
    Ok(Flow::Next)
}
