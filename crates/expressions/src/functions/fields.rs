//! Functions about fields: what a type has, what a cell holds.

use model::{Cell, Expression, Node, ObjectId, Source, Value};
use schema::{Class, Dimension, Field, Kind};

use super::{Arguments, Function, dependents::references, function, searching};
use crate::{
    arithmetic::flag,
    attributes::{ALIASES, Attribute, attribute},
    names::{Steps, reach},
    print::{number_text, print},
    scope::Outcome,
};

pub const TABLE: &[Function] = &[
    function(
        "DB_FIELD_FILTER",
        "filters, fields",
        "fields that fit filters such as t=real, c=1, object_type=marker",
        filter,
    ),
    function("DB_FIELD_TYPE", "type, field", "type of data in a field, such as REAL or STRING", |a| {
        let (class, name) = (class(a, 0)?, a.text(1)?);
        let field = class.fields().find(|f| f.name.eq_ignore_ascii_case(name.trim()));
        let field = field.ok_or_else(|| a.error(format!("a {} has no field \"{name}\"", class.id)))?;
        Ok(Value::Text(type_of(field).to_string()))
    }),
    function("DB_FULL_TYPE_FIELDS", "type", "names of the fields of a type, short forms too", |a| {
        let class = class(a, 0)?;
        let mut names = field_names(class);
        let short = ALIASES.iter().filter(|(_, full)| class.cell_index(full).is_some());
        names.extend(short.map(|(short, _)| (*short).to_string()));
        Ok(Value::Texts(names))
    }),
    function("DB_TYPE_FIELDS", "type", "names of the fields of a type", |a| {
        Ok(Value::Texts(field_names(class(a, 0)?)))
    }),
    searching("EXPR_EXISTS", "field", "1 if a field holds an expression", |a| {
        Ok(flag(!expression_text(a)?.is_empty()))
    }),
    searching("EXPR_REFERENCE", "field, n", "the n-th object or field that the expression of a field uses", |a| {
        let n = a.integer(1)?;
        let all = all_references(a)?;
        let found = usize::try_from(n).ok().and_then(|n| n.checked_sub(1)).and_then(|n| all.into_iter().nth(n));
        Ok(Value::Text(found.map_or_else(String::new, |root| print(&Expression { root }, a.database()))))
    }),
    searching("EXPR_REFERENCES", "field", "how many objects and fields the expression of a field uses", |a| {
        Ok(Value::Integer(all_references(a)?.len() as i64))
    }),
    searching("EXPR_STRING", "field", "text of the expression in a field", |a| Ok(Value::Text(expression_text(a)?))),
    searching("PARAM_STRING", "field", "value of a field as a command file writes it", |a| {
        let text = parameter_text(a, true)?;
        Ok(Value::Text(text))
    }),
    searching("USER_STRING", "field", "value of a field as a plain text", |a| {
        let text = parameter_text(a, false)?;
        Ok(Value::Text(text))
    }),
];

/// The class a text names: by its id, or by Adams' word for it.
fn class(a: &Arguments, i: usize) -> Outcome<&'static Class> {
    let wanted = a.text(i)?.trim().to_ascii_lowercase();
    let known = a.evaluator.scope.world.map_or(&[][..], |w| w.classes.as_slice()).iter().copied();
    let database = a.database();
    let used = database.ids().map(|o| database.object(o).class);
    let mut all: Vec<&'static Class> = known.chain(used).collect();
    let exact = all.iter().find(|c| c.id == wanted);
    let word = || all.iter().find(|c| c.word.eq_ignore_ascii_case(&wanted.replace('_', " ")));
    if let Some(found) = exact.or_else(word) {
        return Ok(found);
    }
    all.sort_by_key(|c| c.id);
    let error = a.error(format!("\"{wanted}\" is not a type of object"));
    Err(match crate::names::nearest(&wanted, all.iter().map(|c| c.id)) {
        Some(near) => Box::new(error.help(format!("did you mean `{near}`?"))),
        None => error,
    })
}

fn field_names(class: &Class) -> Vec<String> {
    let mut names: Vec<&str> = class.fields().map(|f| f.name).collect();
    super::dependents::once(&mut names);
    names.into_iter().map(str::to_string).collect()
}

fn type_of(field: &Field) -> &'static str {
    match field.kind {
        Kind::Real => "REAL",
        Kind::Integer => "INTEGER",
        Kind::Boolean(..) => "BOOLEAN",
        Kind::Text | Kind::Choice(_) | Kind::File | Kind::Function => "STRING",
        Kind::Location => "LOCATION",
        Kind::Orientation => "ORIENTATION",
        Kind::Object(..) => "OBJECT",
        Kind::Any => "ANY",
    }
}

/// Filters are `object_type=`, `t=`, `c=`, `alias=` and `assoc=`, with `=` or `:`.
fn filter(a: &mut Arguments) -> Outcome<Value> {
    let (filters, mut names) = (a.texts(0)?, a.texts(1)?);
    let mut conditions = Vec::new();
    let mut of: Option<&'static Class> = None;
    for filter in &filters {
        let (key, value) = filter
            .split_once(['=', ':'])
            .map(|(k, v)| (k.trim().to_ascii_lowercase(), v.trim().to_ascii_lowercase()))
            .ok_or_else(|| a.error(format!("\"{filter}\" is not a filter such as \"t=real\"")))?;
        if key == "object_type" {
            let known = Arguments { name: a.name, values: &[Value::Text(value)], evaluator: &mut *a.evaluator };
            of = Some(class(&known, 0)?);
        } else if matches!(key.as_str(), "t" | "c" | "alias" | "assoc") {
            conditions.push((key, value));
        } else {
            return Err(a.error(format!("there is no filter \"{key}\"")));
        }
    }
    let Some(class) = of else { return Err(a.error("a filter object_type= is needed")) };
    names.retain(|name| {
        let short = ALIASES.iter().find(|(short, _)| short.eq_ignore_ascii_case(name));
        let full = short.map_or(name.as_str(), |(_, full)| full);
        let Some(field) = class.fields().find(|f| f.name.eq_ignore_ascii_case(full)) else { return false };
        conditions.iter().all(|(key, value)| match key.as_str() {
            "t" => has_type(field, value),
            "c" => value.parse::<usize>().is_ok_and(|n| {
                if n == 0 { field.count.most == usize::MAX } else { field.count.least == n && field.count.most == n }
            }),
            "alias" => short.is_some() == (value == "true"),
            _ => value == "reference" && matches!(field.kind, Kind::Object(..)),
        })
    });
    Ok(Value::Texts(names))
}

fn has_type(field: &Field, wanted: &str) -> bool {
    match wanted {
        "bool" => matches!(field.kind, Kind::Boolean(..)),
        "string" => matches!(field.kind, Kind::Text | Kind::Choice(_) | Kind::File | Kind::Function),
        "real" => field.kind == Kind::Real,
        "integer" => field.kind == Kind::Integer,
        "point" => matches!(field.kind, Kind::Location | Kind::Orientation),
        kind => matches!(field.kind, Kind::Object(_, family) if family == kind || family == "any"),
    }
}

/// The cell that a text such as `mar1.location` names: its owner, field index and content. A
/// variable alone means its value.
fn named_cell<'a>(a: &'a Arguments) -> Outcome<(ObjectId, usize, Option<&'a Cell>)> {
    let name = a.text(0)?;
    let database = a.database();
    let wrong = || a.error(format!("\"{name}\" names no field of an object"));
    let steps = Steps::of(name.trim());
    let reached = reach(database, &steps).map_err(|_| wrong())?;
    let object = database.object(reached.object);
    let index = match &steps.names[reached.steps..] {
        [field] => match attribute(database, reached.object, field) {
            Some(Attribute::Field(index)) => index,
            _ => return Err(wrong()),
        },
        [] if object.class.id == "variable" => {
            crate::attributes::value_cell(database, reached.object).ok_or_else(wrong)?
        }
        _ => return Err(wrong()),
    };
    Ok((reached.object, index, object.cells.get(index)))
}

/// Dimension of the field that a text names.
pub(super) fn dimension_of(a: &Arguments) -> Outcome<Dimension> {
    let (object, index, _) = named_cell(a)?;
    Ok(a.database().field(object, index).dimension)
}

fn all_references(a: &Arguments) -> Outcome<Vec<Node>> {
    let (_, _, cell) = named_cell(a)?;
    let mut found = Vec::new();
    for expression in cell.map(Cell::expressions).unwrap_or_default() {
        references(&expression.root, &mut found);
    }
    Ok(found)
}

fn expression_text(a: &Arguments) -> Outcome<String> {
    let (_, _, cell) = named_cell(a)?;
    Ok(match cell.map(|c| &c.source) {
        Some(Source::Expression(e)) => format!("({})", print(e, a.database())),
        Some(Source::Elements(list)) => {
            list.iter().flatten().map(|e| format!("({})", print(e, a.database()))).collect::<Vec<_>>().join(", ")
        }
        _ => String::new(),
    })
}

fn parameter_text(a: &Arguments, as_typed: bool) -> Outcome<String> {
    let (object, index, cell) = named_cell(a)?;
    let database = a.database();
    let Some(cell) = cell else { return Ok(String::new()) };
    if let (Source::Expression(e), true) = (&cell.source, as_typed) {
        return Ok(format!("({})", print(e, database)));
    }
    let field = database.object(object).class.field(index);
    let degrees = as_typed && field.kind == Kind::Orientation && database.units().angle.name == "degrees";
    let suffix = if degrees { "d" } else { "" };
    let number = |x: f64| format!("{}{suffix}", number_text(x));
    let quote = |t: &String| if as_typed { format!("\"{t}\"") } else { t.clone() };
    let function = |f: &model::FunctionText| f.write(|o| database.full_name(o));
    Ok(match &cell.value {
        Value::Text(text) => quote(text),
        Value::Texts(list) => list.iter().map(quote).collect::<Vec<_>>().join(", "),
        Value::Object(o) if database.get(*o).is_some() => database.full_name(*o),
        Value::Objects(list) => {
            let living = list.iter().filter(|o| database.get(**o).is_some());
            living.map(|o| database.full_name(*o)).collect::<Vec<_>>().join(", ")
        }
        Value::Integer(i) => i.to_string(),
        Value::Flag(yes) => match field.kind {
            Kind::Boolean(t, f) => if *yes { t } else { f }.to_string(),
            _ => i32::from(*yes).to_string(),
        },
        Value::Function(f) => quote(&function(f)),
        Value::Nothing | Value::Object(_) => String::new(),
        Value::Number(_) | Value::Array(_) => {
            let numbers = database.numbers(object, field.name).unwrap_or_default();
            numbers.into_iter().map(number).collect::<Vec<_>>().join(", ")
        }
    })
}
