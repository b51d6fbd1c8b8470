//! `* delete`: objects go away with everything below them, unless something else refers to them.

use schema::{Field, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow};

const fn verb(path: &'static str, fields: &'static [Field]) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc: "deletes objects" }, delete)
}

const fn of(name: &'static str, class: &'static str) -> Field {
    Field::objects(name, class).doc("objects to delete; patterns are allowed")
}

pub const MODEL: VerbEntry = verb("model delete", &[of("model_name", "model")]);
pub const PART: VerbEntry = verb("part delete", &[of("part_name", "body"), of("point_mass_name", "point_mass")]);
pub const MARKER: VerbEntry = verb("marker delete", &[of("marker_name", "marker")]);
pub const POINT: VerbEntry = verb("point delete", &[of("point_name", "point")]);
pub const GEOMETRY: VerbEntry = verb("geometry delete", &[of("geometry_name", "geometry")]);
pub const CONSTRAINT: VerbEntry = verb("constraint delete", &[of("constraint_name", "constraint")]);
pub const FORCE: VerbEntry = verb("force delete", &[of("force_name", "force")]);
pub const DATA_ELEMENT: VerbEntry = verb("data_element delete", &[of("data_element_name", "data_element")]);
pub const MEASURE: VerbEntry = verb("measure delete", &[of("measure_name", "measure")]);
pub const REQUEST: VerbEntry = verb("output_control delete request", &[of("request_name", "request")]);
pub const MATERIAL: VerbEntry = verb("material delete", &[of("material_name", "material")]);
pub const VARIABLE: VerbEntry = verb("variable delete", &[of("variable_name", "variable")]);
pub const GROUP: VerbEntry = verb("group delete", &[of("group_name", "group")]);
pub const MACRO: VerbEntry = verb("macro delete", &[of("macro_name", "macro")]);
pub const SCRIPT: VerbEntry = verb("simulation script delete", &[of("sim_script_name", "script")]);
pub const ANALYSIS: VerbEntry = verb("analysis delete", &[of("analysis_name", "analysis")]);
pub const ENTITY: VerbEntry = verb(
    "entity delete",
    &[of("entity_name", "any"), Field::text("type_filter").doc("take only objects of this type")],
);

fn delete(interpreter: &mut Interpreter, call: &Call) -> Result<Flow, Vec<Diagnostic>> {
    let Some(first) = call.parameters.first().map(|p| p.name.clone()) else { return Ok(Flow::Next) };
    let mut chosen = Vec::new();
    for (parameter, argument) in call.all() {
        let field = parameter.field;
        if field.name != "type_filter" {
            chosen.extend(interpreter.read_value(call, &field, argument, None)?.value.objects());
        }
    }
    if let Some(wanted) = interpreter.word_of(call, "type_filter")? {
        let wanted = wanted.to_ascii_lowercase();
        chosen.retain(|id| {
            let class = interpreter.database.object(*id).class;
            class.is(&wanted) || class.word.eq_ignore_ascii_case(&wanted)
        });
    }
    if call.given.is_empty() {
        return Err(vec![call.missing(&[&first])]);
    }
    interpreter.delete_objects(&chosen, call)?;
    Ok(Flow::Next)
}

impl Interpreter {
    /// Deletes objects and all below them; refused, with their names, while others refer to them.
    pub(crate) fn delete_objects(&mut self, chosen: &[model::ObjectId], call: &Call) -> Result<(), Vec<Diagnostic>> {
        let mut gone = Vec::new();
        for &id in chosen {
            let object = self.database.object(id);
            if object.class.id == "ground" && !chosen.iter().any(|c| Some(*c) == object.parent) {
                return Err(vec![
                    Diagnostic::error("name/permanent", "the ground of a model cannot be deleted")
                        .at(call.span, "delete the model instead"),
                ]);
            }
            gone.extend(self.database.subtree(id));
        }
        let dependents = self.dependents_of(&gone);
        // A group does not keep its members alive; the settings of a model go with it.
        let (groups, others): (Vec<_>, Vec<_>) =
            dependents.into_iter().partition(|d| self.database.object(*d).class.id == "group");
        if !others.is_empty() {
            let names: Vec<String> = others.iter().take(16).map(|d| self.database.full_name(*d)).collect();
            let what = chosen.first().map(|id| self.database.full_name(*id)).unwrap_or_default();
            return Err(vec![
                Diagnostic::error(
                    "name/has-dependents",
                    format!("`{what}` cannot be deleted: {} objects refer to it", others.len()),
                )
                .at(call.span, format!("used by {}", names.join(", ")))
                .help("delete or change these first, or name them in the same command")
                .adams(format!("The object {what} was not deleted because "))
                .adams(format!("{} objects depend on it.", others.len()))
                .adams(names.join(", ")),
            ]);
        }
        for group in groups {
            let members = self.database.value(group, "objects_in_group").map(model::Value::objects).unwrap_or_default();
            let rest = members.into_iter().filter(|m| !gone.contains(m)).collect();
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
}
