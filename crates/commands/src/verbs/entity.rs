//! `entity modify` and `entity attributes`: what every object has.

use model::CellKey;
use schema::{Field, Kind, Names, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry, shared};
use crate::{Interpreter, call::Call, interpreter::Flow};

type Outcome = Result<Flow, Vec<Diagnostic>>;

pub const MODIFY: VerbEntry = entry(
    Verb {
        path: "entity modify",
        fields: &[
            Field::object("entity_name", "any").current().doc("object"),
            Field::new("new_entity_name", Kind::Object(Names::New, "any")).doc("new name"),
            Field::integer("adams_id").doc("number in the solver's files"),
            Field::texts("comments").doc("lines kept with the object"),
        ],
        rules: &[],
        doc: "renames an object, or changes its number or comments",
    },
    modify,
);

fn modify(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let named = interpreter.object_argument(call, "entity_name")?;
    let Some(id) = named.or_else(|| interpreter.database.current("any")) else {
        return Err(vec![call.missing(&["entity_name"])]);
    };
    set_known_cells(interpreter, call, id, &["adams_id", "comments"])?;
    if let Some(argument) = call.argument("new_entity_name") {
        let typed = interpreter.text_argument(call, argument)?;
        interpreter.rename(id, &typed, argument.value_span)?;
    }
    Ok(Flow::Next)
}

pub const ATTRIBUTES: VerbEntry = entry(
    Verb {
        path: "entity attributes",
        fields: &[
            Field::objects("entity_name", "any").doc("objects; patterns are allowed"),
            shared::TYPE_FILTER,
            Field::integer("expr_visibility").doc("number or expression that shows or hides objects"),
            Field::integer("expr_active").doc("number or expression that switches objects on or off"),
        ],
        rules: &[],
        doc: "how objects look and whether they take part in simulations",
    },
    attributes,
);

fn attributes(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let mut ids = interpreter.objects_argument(call, "entity_name")?;
    if call.argument("entity_name").is_none() {
        return Err(vec![call.missing(&["entity_name"])]);
    }
    shared::filter_by_type(interpreter, call, &mut ids)?;
    for id in ids {
        let class = interpreter.database.object(id).class;
        let mut foreign = Vec::new();
        for (parameter, argument) in call.all() {
            let field = parameter.field;
            if matches!(field.name, "entity_name" | "type_filter") {
                continue;
            }
            let Some(cell) = class.cell_index(field.name) else {
                foreign.push(field.name);
                continue;
            };
            let draft = interpreter.read_value(call, &field, argument, Some(id))?;
            interpreter.store(CellKey::new(id, cell), draft);
        }
        if !foreign.is_empty() {
            let name = interpreter.database.full_name(id);
            interpreter.report.diagnostics.push(
                Diagnostic::warning("command/no-effect", format!("`{name}` has no {}", foreign.join(", ")))
                    .at(call.span, format!("a {} has no such attribute", class.word.to_lowercase())),
            );
        }
    }
    Ok(Flow::Next)
}

fn set_known_cells(
    interpreter: &mut Interpreter,
    call: &Call,
    id: ::model::ObjectId,
    names: &[&str],
) -> Result<(), Vec<Diagnostic>> {
    let class = interpreter.database.object(id).class;
    for name in names {
        let (Some(argument), Some(field)) = (call.argument(name), call.field(name).copied()) else { continue };
        let Some(cell) = class.cell_index(name) else {
            let what = class.word.to_lowercase();
            return Err(vec![
                Diagnostic::error("command/unknown-argument", format!("a {what} has no `{name}`"))
                    .at(argument.name, "no such value")
                    .adams(format!("'{name}' is not a valid parameter.")),
            ]);
        };
        let draft = interpreter.read_value(call, &field, argument, Some(id))?;
        interpreter.store(CellKey::new(id, cell), draft);
    }
    Ok(())
}
