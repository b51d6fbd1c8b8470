//! `* delete`: objects go away with everything below them, unless something else refers to them.

use model::ObjectId;
use schema::{Field, Rule, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry,
    shared::{self, Outcome},
};
use crate::{Interpreter, call::Call, interpreter::Flow, words::referring};

const fn verb(path: &'static str, fields: &'static [Field]) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc: "deletes objects and all that belongs to them" }, delete)
}

const fn of(name: &'static str, class: &'static str) -> Field {
    Field::objects(name, class).doc("objects to delete; patterns are allowed")
}

const PARTS: &[&str] = &[
    "part_name",
    "flexible_body_name",
    "external_system_name",
    "point_mass_name",
    "equation_name",
    "rigid_stress_name",
    "fe_part_name",
    "fe_node_name",
];

pub const MODEL: VerbEntry = entry(
    Verb {
        path: "model delete",
        fields: &[of("model_name", "model"), of("analysis_name", "analysis")],
        rules: &[Rule::AtMostOne(&["model_name", "analysis_name"])],
        doc: "deletes models with everything in them",
    },
    delete,
);
pub const PART: VerbEntry = entry(
    Verb {
        path: "part delete",
        fields: &[
            of("part_name", "body"),
            of("flexible_body_name", "flexible_body"),
            of("external_system_name", "external_system"),
            of("point_mass_name", "point_mass"),
            of("equation_name", "equation"),
            of("rigid_stress_name", "rigid_stress"),
            of("fe_part_name", "fe_part"),
            of("fe_node_name", "fe_node"),
        ],
        rules: &[Rule::AtMostOne(PARTS)],
        doc: "deletes bodies with their markers and shapes",
    },
    delete,
);
pub const MARKER: VerbEntry = verb("marker delete", &[of("marker_name", "marker")]);
pub const FLOATING_MARKER: VerbEntry = verb("floating_marker delete", &[of("floating_marker_name", "floating_marker")]);
pub const POINT: VerbEntry = verb("point delete", &[of("point_name", "point")]);
pub const GEOMETRY: VerbEntry = verb("geometry delete", &[of("geometry_name", "geometry")]);
pub const CONSTRAINT: VerbEntry = verb("constraint delete", &[of("constraint_name", "constraint")]);
pub const FORCE: VerbEntry = verb("force delete", &[of("force_name", "force")]);
pub const CONTACT: VerbEntry = verb("contact delete", &[of("contact_name", "contact")]);
pub const DATA_ELEMENT: VerbEntry = verb("data_element delete", &[of("data_element_name", "data_element")]);
pub const MEASURE: VerbEntry = verb("measure delete", &[of("measure_name", "measure")]);
pub const REQUEST: VerbEntry = verb("output_control delete request", &[of("request_name", "request")]);
pub const SENSOR: VerbEntry = verb("executive_control delete sensor", &[of("sensor_name", "sensor")]);
pub const MATERIAL: VerbEntry = verb("material delete", &[of("material_name", "material")]);
pub const SECTION: VerbEntry = verb("section delete", &[of("section_name", "section")]);
pub const VARIABLE: VerbEntry = verb("variable delete", &[of("variable_name", "variable")]);
pub const GROUP: VerbEntry = verb("group delete", &[of("group_name", "group")]);
pub const MACRO: VerbEntry = verb("macro delete", &[of("macro_name", "macro")]);
pub const SCRIPT: VerbEntry = verb("simulation script delete", &[of("sim_script_name", "script")]);
pub const ANALYSIS: VerbEntry = verb("analysis delete", &[of("analysis_name", "analysis")]);
pub const ENTITY: VerbEntry = verb("entity delete", &[of("entity_name", "any"), shared::TYPE_FILTER]);

fn delete(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some(first) = call.parameters.first().map(|p| p.name.clone()) else { return Ok(Flow::Next) };
    let mut chosen = Vec::new();
    for (parameter, argument) in call.objects() {
        let field = parameter.field;
        chosen.extend(interpreter.read_value(call, &field, argument, None)?.value.objects());
    }
    shared::filter_by_type(interpreter, call, &mut chosen)?;
    if call.objects().next().is_none() {
        return Err(vec![call.missing(&[&first])]);
    }
    interpreter.delete_objects(&chosen, call)?;
    Ok(Flow::Next)
}

impl Interpreter {
    /// Deletes objects and all below them; refused, with their names, while others refer to them.
    pub(crate) fn delete_objects(&mut self, chosen: &[ObjectId], call: &Call) -> Outcome<()> {
        let mut gone = Vec::new();
        for &id in chosen {
            let object = self.database.object(id);
            let ground = object.class.id == "ground" && !chosen.iter().any(|c| Some(*c) == object.parent);
            if ground || self.is_built_in(id) {
                let what = if ground { "the ground of a model" } else { "what belongs to every session" };
                return Err(vec![
                    Diagnostic::error("name/permanent", format!("{what} cannot be deleted"))
                        .at(call.span, format!("`{}` stays", self.database.full_name(id)))
                        .help(if ground { "delete the model instead" } else { "choose objects of a model" }),
                ]);
            }
            gone.extend(self.database.subtree(id));
        }
        let dependents = self.dependents_of(&gone);
        // A group does not keep its members alive.
        let (groups, others): (Vec<_>, Vec<_>) =
            dependents.into_iter().partition(|d| self.database.object(*d).class.id == "group");
        // What refers to any of them refers to what is below one of them: the first such is named.
        for &id in chosen.iter().filter(|_| !others.is_empty()) {
            let mut users = self.dependents_of(&self.database.subtree(id));
            users.retain(|user| others.contains(user));
            if users.is_empty() {
                continue;
            }
            let names: Vec<String> = users.iter().take(16).map(|d| self.database.full_name(*d)).collect();
            let what = self.database.full_name(id);
            return Err(vec![
                Diagnostic::error(
                    "name/has-dependents",
                    format!("`{what}` cannot be deleted: {}", referring(users.len())),
                )
                .at(call.span, format!("used by {}", names.join(", ")))
                .help("delete or change these first, or name them in the same command")
                .adams(format!("The object {what} was not deleted because "))
                .adams(format!("{} objects depend on it.", users.len()))
                .adams(names.join(", ")),
            ]);
        }
        for group in groups {
            let rest = shared::members(&self.database, group).into_iter().filter(|m| !gone.contains(m)).collect();
            self.database.set_value(group, "objects_in_group", model::Value::Objects(rest));
        }
        if self.database.settings().default_frame.is_some_and(|f| gone.contains(&f)) {
            self.database.set_default_frame(None);
        }
        for &id in chosen {
            if self.database.get(id).is_some() {
                self.database.remove(id);
            }
        }
        self.names.forget();
        Ok(())
    }

    /// Whether an object is there from the start of a session.
    pub(crate) fn is_built_in(&self, id: ObjectId) -> bool {
        let object = self.database.object(id);
        object.parent.is_none()
            && (object.class.id == "group" && object.name == crate::interpreter::SELECT_LIST
                || object.class.id == "library" && object.name == "mdi")
    }
}
