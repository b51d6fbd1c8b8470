//! Design variables: one value, or a list of reals, integers, texts or objects, which may be set
//! element by element.

use model::{Array, CellKey, ObjectId, Source, Value};
use schema::{Count, Dimension, Field, Kind, Names, Quantity, Rule, Verb};
use text::{Diagnostic, Span};

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow, lookup, values::Draft};

type Outcome<T> = Result<T, Vec<Diagnostic>>;

const VALUES: [&str; 4] = ["real_value", "integer_value", "string_value", "object_value"];

const fn fields(name: Field) -> [Field; 13] {
    [
        name,
        Field::texts("comments").doc("lines kept with the object and written before it"),
        Field::real("real_value", Dimension::NONE).quantity_in("units").many().doc("real values"),
        Field::text("units").doc("kind of quantity of the value"),
        Field::real("range", Dimension::NONE)
            .quantity_in("units")
            .count(Count::exactly(2))
            .doc("lower and upper limit"),
        Field::real("allowed_values", Dimension::NONE).quantity_in("units").many().doc("values to choose from"),
        Field::choice("delta_type", &["absolute", "relative", "percent_relative"])
            .default_word("absolute")
            .doc("whether the range is absolute, added to the value, or percents of it"),
        Field::yes_no("use_range").doc("the range holds"),
        Field::yes_no("use_allowed_values").doc("only allowed values are taken"),
        Field::integer("integer_value").many().doc("integer values"),
        Field::texts("string_value").doc("texts"),
        Field::objects("object_value", "any").doc("objects"),
        Field::integer("index").doc("place in the list, from 1, that is set"),
    ]
}

const RULES: &[Rule] = &[Rule::AtMostOne(&VALUES)];
const NEW: Field = Field::new("variable_name", Kind::Object(Names::New, "variable")).doc("variable");
const OLD: Field = Field::new("variable_name", Kind::Object(Names::Old, "variable")).current().doc("variable");
const ANY: Field = Field::new("variable_name", Kind::Object(Names::OldOrNew, "variable")).doc("variable");

pub const CREATE: VerbEntry = entry(
    Verb { path: "variable create", fields: &fields(NEW), rules: RULES, doc: "creates a design variable" },
    create,
);
pub const SET: VerbEntry = entry(
    Verb { path: "variable set", fields: &fields(ANY), rules: RULES, doc: "creates or sets a design variable" },
    set,
);
const MODIFY_FIELDS: [Field; 14] = {
    let old = fields(OLD);
    let mut all = [OLD; 14];
    let mut i = 0;
    while i < 13 {
        all[i] = old[i];
        i += 1;
    }
    all[13] = Field::new("new_variable_name", Kind::Object(Names::New, "variable")).doc("new name");
    all
};
pub const MODIFY: VerbEntry = entry(
    Verb { path: "variable modify", fields: &MODIFY_FIELDS, rules: RULES, doc: "changes a design variable" },
    modify,
);

fn create(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (typed, span) = if let Some(argument) = call.argument("variable_name") {
        (interpreter.text_argument(call, argument)?, argument.value_span)
    } else {
        let parent = interpreter.database.current("model");
        let Some(class) = interpreter.registry.class("variable") else { return Ok(Flow::Skipped) };
        (interpreter.generate_name(class, parent), call.keywords)
    };
    let id = make(interpreter, &typed, span)?;
    fill(interpreter, call, id)?;
    if let Some(class) = interpreter.registry.class("variable")
        && let Some(cell) = class.cell_index("delta_type")
        && interpreter.database.object(id).cells.get(cell).is_none()
    {
        interpreter.store(CellKey::new(id, cell), Draft::literal(Value::Text("absolute".into())));
    }
    Ok(Flow::Next)
}

/// A new variable: in the current model, or at the top if there is none.
fn make(interpreter: &mut Interpreter, typed: &str, span: text::Span) -> Outcome<ObjectId> {
    let Some(class) = interpreter.registry.class("variable") else {
        return Err(vec![Diagnostic::error("name/no-parent", "this session knows no variables").at(span, "")]);
    };
    let place = lookup::new_name(&interpreter.database, &interpreter.registry, class, typed, span);
    let place = match place {
        Ok(mut place) => {
            // A bare name belongs to the model, not to the current part.
            if !typed.starts_with('.') {
                place.parent = interpreter.database.current("model");
            }
            place
        }
        Err(_) if !typed.contains('.') => lookup::NewName { parent: None, name: typed.trim_matches('"').to_string() },
        Err(e) => return Err(vec![e]),
    };
    let id = interpreter
        .database
        .create(class, place.parent, &place.name)
        .map_err(|t| vec![lookup::taken(&interpreter.database, class, typed, t.0, span)])?;
    interpreter.names.created(&interpreter.database, id);
    interpreter.database.make_current(id);
    Ok(id)
}

fn set(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some(argument) = call.argument("variable_name") else { return Err(vec![call.missing(&["variable_name"])]) };
    let typed = interpreter.text_argument(call, argument)?;
    let known = if typed.starts_with('.') {
        interpreter.database.find(&typed, "variable")
    } else {
        let steps = model::split_name(&typed);
        let model = interpreter.database.current("model");
        interpreter
            .database
            .descend(model, &steps, "variable")
            .or_else(|| interpreter.database.descend(None, &steps, "variable"))
    };
    let id = match known {
        Some(id) => id,
        None => make(interpreter, &typed, argument.value_span)?,
    };
    fill(interpreter, call, id)?;
    interpreter.database.make_current(id);
    Ok(Flow::Next)
}

fn modify(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some(id) =
        interpreter.object_argument(call, "variable_name")?.or_else(|| interpreter.database.current("variable"))
    else {
        return Err(vec![call.missing(&["variable_name"])]);
    };
    fill(interpreter, call, id)?;
    interpreter.database.make_current(id);
    if let Some(argument) = call.argument("new_variable_name") {
        let typed = interpreter.text_argument(call, argument)?;
        interpreter.rename(id, &typed, argument.value_span)?;
    }
    Ok(Flow::Next)
}

/// Stores what is given; a value of one type takes those of the others away.
fn fill(interpreter: &mut Interpreter, call: &Call, id: ObjectId) -> Outcome<()> {
    let class = interpreter.database.object(id).class;
    let index = interpreter.number_argument(call, "index")?.map(|x| x as i64);
    if let Some(units) = interpreter.word_of(call, "units")?
        && Quantity::named(&units).is_none()
    {
        let span = call.argument("units").map_or(call.span, |a| a.value_span);
        interpreter.report.diagnostics.push(
            Diagnostic::warning("unit/unknown", format!("`{units}` is no kind of quantity Flexure knows"))
                .at(span, "the value is not converted when units change"),
        );
    }
    let mut changed = Vec::new();
    for (parameter, argument) in call.all() {
        let field = parameter.field;
        if matches!(field.name, "variable_name" | "new_variable_name" | "index") {
            continue;
        }
        let Some(cell) = class.cell_index(field.name) else { continue };
        let key = CellKey::new(id, cell);
        let mut draft = interpreter.read_value(call, &field, argument, Some(id))?;
        if VALUES.contains(&field.name) {
            if let Some(index) = index {
                draft = set_element(interpreter, id, field.name, index, draft, argument.value_span)?;
            } else {
                draft.value = simplified(draft.value, field.kind);
            }
            for other in VALUES.iter().filter(|v| **v != field.name) {
                if let Some(cell) = class.cell_index(other)
                    && interpreter.database.object(id).cells.get(cell).is_some()
                {
                    let key = CellKey::new(id, cell);
                    interpreter.database.set_reads(key, Vec::new());
                    interpreter.database.set_cell(key, None);
                    changed.push(key);
                }
            }
        }
        interpreter.store(key, draft);
        changed.push(key);
    }
    interpreter.recompute(&changed, call.span)?;
    if VALUES.iter().any(|v| call.given.iter().any(|g| &*call.parameters[g.parameter].name == *v)) {
        warn_outside(interpreter, id, call.span);
    }
    Ok(())
}

/// The lowest and highest value a design variable may take, as its range counts.
pub fn limits(database: &model::Database, id: ObjectId) -> Option<(f64, f64)> {
    let range = database.numbers(id, "range")?;
    let &[low, high] = range.as_slice() else { return None };
    let value = database.number(id, "real_value").or_else(|| database.number(id, "integer_value")).unwrap_or(0.0);
    Some(match database.text(id, "delta_type") {
        Some("relative") => (value + low, value + high),
        Some("percent_relative") => (value * (1.0 + low / 100.0), value * (1.0 + high / 100.0)),
        _ => (low, high),
    })
}

/// Says that the value of a variable is outside of what it allows; the value is stored.
pub(crate) fn warn_outside(interpreter: &mut Interpreter, id: ObjectId, span: Span) {
    let database = &interpreter.database;
    let values = database.numbers(id, "real_value").or_else(|| database.numbers(id, "integer_value"));
    let Some(values) = values else { return };
    let name = database.full_name(id);
    let mut troubles = Vec::new();
    // Relative limits move with the value and always hold.
    let absolute = matches!(database.text(id, "delta_type"), None | Some("absolute"));
    if database.flag(id, "use_range") == Some(true)
        && absolute
        && let Some((low, high)) = limits(database, id)
        && let Some(x) = values.iter().find(|x| **x < low.min(high) || **x > low.max(high))
    {
        troubles.push(format!("`{name}` is {x}; its range is {low} to {high}"));
    }
    if database.flag(id, "use_allowed_values") == Some(true)
        && let Some(allowed) = database.numbers(id, "allowed_values")
        && let Some(x) = values.iter().find(|x| !allowed.iter().any(|a| (a - **x).abs() <= 1e-12 * a.abs()))
    {
        let list = allowed.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
        troubles.push(format!("`{name}` is {x}; its allowed values are {list}"));
    }
    for trouble in troubles {
        interpreter.report.diagnostics.push(
            Diagnostic::warning("value/outside-limit", trouble)
                .at(span, "stored all the same")
                .help("give another value, or switch the limit off with `use_range = no` or `use_allowed_values = no`"),
        );
    }
}

impl Interpreter {
    /// Gives a variable a text as its value.
    pub(crate) fn set_variable_text(&mut self, id: ObjectId, text: &str, call: &Call) -> Outcome<()> {
        let class = self.database.object(id).class;
        let mut changed = Vec::new();
        for name in VALUES {
            let Some(cell) = class.cell_index(name) else { continue };
            let key = CellKey::new(id, cell);
            if name == "string_value" {
                self.store(key, Draft::literal(Value::Text(text.to_string())));
            } else if self.database.object(id).cells.get(cell).is_some() {
                self.database.set_reads(key, Vec::new());
                self.database.set_cell(key, None);
            } else {
                continue;
            }
            changed.push(key);
        }
        self.recompute(&changed, call.span)
    }
}

/// A list of one is the value itself.
fn simplified(value: Value, kind: Kind) -> Value {
    match value {
        Value::Array(Array { values, .. }) if values.len() == 1 && kind == Kind::Integer => {
            Value::Integer(values[0] as i64)
        }
        Value::Array(Array { values, .. }) if values.len() == 1 => Value::Number(values[0]),
        Value::Texts(mut texts) if texts.len() == 1 => Value::Text(texts.remove(0)),
        Value::Objects(ids) if ids.len() == 1 => Value::Object(ids[0]),
        other => other,
    }
}

fn set_element(
    interpreter: &Interpreter,
    id: ObjectId,
    name: &str,
    index: i64,
    draft: Draft,
    span: text::Span,
) -> Outcome<Draft> {
    let old = interpreter.database.value(id, name).cloned();
    let Some(at) = usize::try_from(index - 1).ok().filter(|at| *at < 1_000_000) else {
        return Err(vec![
            Diagnostic::error("value/out-of-range", "`index` counts from 1").at(span, format!("index {index}")),
        ]);
    };
    let value = match (&draft.value, old) {
        (Value::Texts(new), old) => {
            let mut list = match old {
                Some(Value::Texts(list)) => list,
                Some(Value::Text(text)) => vec![text],
                _ => Vec::new(),
            };
            list.resize(list.len().max(at + 1), String::new());
            list[at] = new.first().cloned().unwrap_or_default();
            Value::Texts(list)
        }
        (Value::Objects(new), old) => {
            let mut list = old.map(|o| o.objects()).unwrap_or_default();
            let Some(&first) = new.first() else { return Ok(draft) };
            list.resize(list.len().max(at + 1), first);
            list[at] = first;
            Value::Objects(list)
        }
        (new, old) => {
            let mut list = old.and_then(|o| o.as_numbers()).unwrap_or_default();
            list.resize(list.len().max(at + 1), 0.0);
            list[at] = new.as_numbers().and_then(|n| n.first().copied()).unwrap_or(0.0);
            Value::Array(Array::column(list))
        }
    };
    Ok(Draft { value, source: Source::Literal, reads: Vec::new() })
}
