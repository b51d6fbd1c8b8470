//! Expressions in cells: computing what a cell stores, and everything that depends on it.
//!
//! A location or orientation is stored in the frame of the owner's parent. Beside it may stand a
//! cell `relative_to`: then the expression's value is in that frame and is converted.

use model::{
    Array, Cell, CellKey, Database, Expression, ObjectId, Pose, Sequence, Source, Value, angles_of, rotation_of,
};
use schema::{Field, Kind};
use text::{Diagnostic, Sources};

use crate::{
    Scope, arithmetic,
    evaluate::{Evaluated, Evaluator, describe},
    scope::{Outcome, problem},
};

/// Converts locations (three numbers each, current length unit) from a frame, or from global, to
/// the frame that an object's locations are stored in: its parent's.
pub fn convert_location(database: &Database, values: &[f64], from: Option<ObjectId>, owner: ObjectId) -> Vec<f64> {
    convert(database, values, from, parent(database, owner), false)
}

/// Converts body 3-1-3 orientations (current angle unit) like [`convert_location`].
pub fn convert_orientation(database: &Database, values: &[f64], from: Option<ObjectId>, owner: ObjectId) -> Vec<f64> {
    convert(database, values, from, parent(database, owner), true)
}

fn parent(database: &Database, owner: ObjectId) -> Option<ObjectId> {
    database.get(owner).and_then(|o| o.parent)
}

fn pose(database: &Database, frame: Option<ObjectId>) -> Pose {
    frame.filter(|f| database.get(*f).is_some()).map_or(Pose::GLOBAL, |f| database.global_pose(f))
}

fn convert(
    database: &Database,
    values: &[f64],
    from: Option<ObjectId>,
    to: Option<ObjectId>,
    orientation: bool,
) -> Vec<f64> {
    let (source, target) = (pose(database, from), pose(database, to));
    // Equal frames keep the author's digits.
    if from == to || source == target {
        return values.to_vec();
    }
    let change = target.inverse().then(&source);
    let angle = database.units().angle.si;
    let mut out = Vec::with_capacity(values.len());
    for triple in values.chunks(3) {
        let [a, b, c] = *triple else {
            out.extend_from_slice(triple);
            continue;
        };
        if orientation {
            let turned = change.rotation * rotation_of(Sequence::BODY_313, [a, b, c].map(|x| x * angle));
            out.extend(angles_of(&turned).map(|x| x / angle));
        } else {
            let point = change.origin + change.rotation * glam::DVec3::new(a, b, c);
            out.extend(point.to_array());
        }
    }
    out
}

/// What a cell of an object stores for a source that holds expressions: its value in the units in
/// force, of the field's type and in the parent's frame, and every cell it depends on. Elements of
/// a list that are no expressions are taken from the present value of the cell.
#[allow(clippy::result_large_err)]
pub fn compute(database: &Database, key: CellKey, source: &Source) -> Result<Evaluated, Diagnostic> {
    let sources = Sources::default();
    let scope = Scope::new(database, &sources).owned_by(key.object);
    computed(&scope, key, source).map_err(|e| *e)
}

fn computed(scope: &Scope, key: CellKey, source: &Source) -> Outcome<Evaluated> {
    let database = scope.database;
    let object = database.get(key.object).ok_or_else(crate::attributes::deleted)?;
    let field = object.class.fields().nth(key.cell as usize).ok_or_else(crate::attributes::deleted)?;
    let mut evaluator = Evaluator::new(*scope);
    let relative_to = frame_of(database, key.object, field, &mut evaluator);
    let orientation = field.kind == Kind::Orientation;
    let (value, dimension) = match source {
        Source::Literal => {
            let value = object.cells.get(key.cell as usize).map_or(Value::Nothing, |c| c.value.clone());
            return Ok(Evaluated { value, dimension: None, reads: Vec::new() });
        }
        Source::Expression(expression) => {
            let value = shaped(evaluator.node(&expression.root)?, field, scope)?;
            let radians = crate::dimension::radians_per_time(&expression.root, field.dimension, database);
            let value = match value {
                Value::Number(x) => Value::Number(x * radians),
                other => other,
            };
            (value, crate::dimension::certain_dimension(&expression.root))
        }
        Source::Elements(elements) => {
            let mut present = present_elements(database, key, elements.len());
            if let (Some(from), Present::Numbers(numbers)) = (relative_to, &mut present) {
                // The stored elements are in the parent's frame: back to where they were typed.
                *numbers = convert(database, numbers, object.parent, Some(from), orientation);
            }
            (merged(&mut evaluator, present, elements, field, scope)?, None)
        }
    };
    let value = match (relative_to, value) {
        (Some(from), Value::Array(a)) => {
            Value::Array(Array { values: convert(database, &a.values, Some(from), object.parent, orientation), ..a })
        }
        (_, value) => value,
    };
    Ok(Evaluated { value, dimension, reads: evaluator.reads })
}

/// The frame of a location or orientation given by `relative_to`; notes what the conversion reads.
fn frame_of(database: &Database, owner: ObjectId, field: &Field, evaluator: &mut Evaluator) -> Option<ObjectId> {
    if !(matches!(field.kind, Kind::Location | Kind::Orientation) && matches!(field.name, "location" | "orientation")) {
        return None;
    }
    let class = database.object(owner).class;
    let cell = class.cell_index("relative_to")?;
    let from = database.reference(owner, "relative_to")?;
    evaluator.read(CellKey::new(owner, cell));
    let parent = parent(database, owner);
    if Some(from) != parent && from != owner {
        if field.kind == Kind::Orientation {
            evaluator.turn(Some(from));
            evaluator.turn(parent);
        } else {
            evaluator.pose(Some(from));
            evaluator.pose(parent);
        }
        return Some(from);
    }
    None
}

enum Present {
    Numbers(Vec<f64>),
    Texts(Vec<String>),
    Objects(Vec<ObjectId>),
}

fn present_elements(database: &Database, key: CellKey, length: usize) -> Present {
    let object = database.object(key.object);
    let field = object.class.field(key.cell as usize);
    let value = object.cells.get(key.cell as usize).map(|c| &c.value);
    match value {
        Some(Value::Text(text)) => Present::Texts(vec![text.clone(); length]),
        Some(Value::Texts(texts)) => Present::Texts(texts.clone()),
        Some(Value::Object(id)) => Present::Objects(vec![*id; length]),
        Some(Value::Objects(ids)) => Present::Objects(ids.clone()),
        _ => {
            let mut numbers = database.numbers(key.object, field.name).unwrap_or_default();
            numbers.resize(length, 0.0);
            Present::Numbers(numbers)
        }
    }
}

fn merged(
    evaluator: &mut Evaluator,
    present: Present,
    elements: &[Option<Expression>],
    field: &Field,
    scope: &Scope,
) -> Outcome<Value> {
    let mut numbers = match present {
        Present::Numbers(numbers) => numbers,
        Present::Texts(mut texts) => {
            texts.resize(elements.len(), String::new());
            for (text, element) in texts.iter_mut().zip(elements) {
                if let Some(expression) = element {
                    *text = arithmetic::text_of(&evaluator.node(&expression.root)?, scope)?;
                }
            }
            return Ok(Value::Texts(texts));
        }
        Present::Objects(mut objects) => {
            for (i, element) in elements.iter().enumerate() {
                if let Some(expression) = element {
                    let found = crate::names::object_or_problem(&evaluator.node(&expression.root)?, scope)?;
                    match objects.get_mut(i) {
                        Some(place) => *place = found,
                        None => objects.push(found),
                    }
                }
            }
            return Ok(Value::Objects(objects));
        }
    };
    for (number, element) in numbers.iter_mut().zip(elements) {
        if let Some(expression) = element {
            *number = number_of(&evaluator.node(&expression.root)?, scope)?;
        }
    }
    shaped(Value::Array(Array::column(numbers)), field, scope)
}

/// A number; a text is evaluated as an expression, as Adams does in a numeric place.
fn number_of(value: &Value, scope: &Scope) -> Outcome<f64> {
    value.as_number().ok_or_else(|| arithmetic::not_a_number(value)).or_else(|e| match value {
        Value::Text(text) => {
            let value = evaluate_text(text, scope).ok_or(e)?;
            value.as_number().ok_or_else(|| arithmetic::not_a_number(&value))
        }
        _ => Err(e),
    })
}

/// The value of a text read as an expression; `None` if it is none.
fn evaluate_text(text: &str, scope: &Scope) -> Option<Value> {
    let mut sources = Sources::default();
    let file = sources.add("<text value>", text);
    let (tree, errors) = syntax::command::parse_expression(file, text, 0);
    if !errors.is_empty() {
        return None;
    }
    let scope = Scope { sources: &sources, ..*scope };
    match crate::bind(&tree, &scope).ok()? {
        crate::Bound::Value(evaluated) => Some(evaluated.value),
        crate::Bound::Expression(expression) => crate::evaluate(&expression, &scope).ok().map(|e| e.value),
    }
}

/// A value in the type of its field.
fn shaped(value: Value, field: &Field, scope: &Scope) -> Outcome<Value> {
    let many = field.count.most > 1;
    let wrong =
        |value: &Value| problem("expression/wrong-type", format!("`{}` cannot be {}", field.name, describe(value)));
    Ok(match field.kind {
        Kind::Real | Kind::Integer | Kind::Location | Kind::Orientation => {
            let numbers = match value.as_numbers() {
                Some(numbers) => numbers,
                None => match &value {
                    Value::Text(text) => {
                        evaluate_text(text, scope).and_then(|v| v.as_numbers()).ok_or_else(|| wrong(&value))?
                    }
                    Value::Texts(list) => {
                        list.iter().map(|t| number_of(&Value::Text(t.clone()), scope)).collect::<Outcome<_>>()?
                    }
                    _ => return Err(wrong(&value)),
                },
            };
            let full = field.symmetric.filter(|side| numbers.len() == side * side);
            let numbers = match full {
                Some(side) => {
                    schema::lower_triangle(&numbers, side).map_err(|pair| not_symmetric(field, side, pair))?
                }
                None => numbers,
            };
            if !(field.count.least..=field.count.most).contains(&numbers.len()) {
                return Err(problem(
                    "expression/wrong-count",
                    format!(
                        "`{}` needs {} numbers, the expression gives {}",
                        field.name,
                        field.count.least,
                        numbers.len()
                    ),
                ));
            }
            if field.kind == Kind::Integer && numbers.iter().any(|x| x.fract() != 0.0) {
                return Err(Box::new(wrong(&value).help("an integer is needed")));
            }
            match numbers.as_slice() {
                [x] if field.kind == Kind::Integer => Value::Integer(*x as i64),
                [x] if !many => Value::Number(*x),
                _ => Value::Array(Array::column(numbers)),
            }
        }
        Kind::Boolean(..) => Value::Flag(arithmetic::truth(&value)?),
        Kind::Choice(_) | Kind::Text | Kind::File => match value {
            Value::Texts(list) if many => Value::Texts(list),
            other => Value::Text(arithmetic::text_of(&other, scope)?),
        },
        Kind::Function => Value::Function(model::FunctionText::plain(arithmetic::text_of(&value, scope)?)),
        Kind::Object(..) => match value {
            Value::Nothing => Value::Nothing,
            Value::Objects(list) if many => Value::Objects(list),
            Value::Texts(list) if many => Value::Objects(
                list.into_iter()
                    .map(|t| crate::names::object_or_problem(&Value::Text(t), scope))
                    .collect::<Outcome<_>>()?,
            ),
            other => Value::Object(crate::names::object_or_problem(&other, scope)?),
        },
        Kind::Any => value,
    })
}

/// A matrix that an expression gives and that is not symmetric where it must be.
fn not_symmetric(field: &Field, side: usize, pair: schema::Unequal) -> Box<Diagnostic> {
    let place = |index| schema::place_by_columns(index, side);
    let ((row, column), (twin_row, twin_column)) = (place(pair.above), place(pair.below));
    problem(
        "value/not-symmetric",
        format!(
            "`{}` is not symmetric: its expression gives different numbers in row {row}, column {column} and row \
             {twin_row}, column {twin_column}",
            field.name
        ),
    )
}

/// Stands among the cells an expression read if its value follows from which objects there are and
/// how they are called. It is no cell of an object.
pub const STRUCTURE: CellKey = CellKey { object: ObjectId(u32::MAX), cell: u16::MAX };

/// Evaluates again what follows from which objects there are; to be called after commands that
/// changed the model. A cell that cannot be computed any more keeps its value, is left alone from
/// then on, and is returned as a warning.
#[allow(clippy::result_large_err)]
pub fn restructure(database: &mut Database) -> Result<Vec<Diagnostic>, Diagnostic> {
    let mut warnings = Vec::new();
    for key in database.dependents(STRUCTURE).to_vec() {
        let Some(object) = database.get(key.object) else { continue };
        let Some(cell) = object.cells.get(key.cell as usize) else { continue };
        let (source, old) = (cell.source.clone(), cell.value.clone());
        match compute(database, key, &source) {
            Ok(computed) => {
                let units = database.settings().units;
                let changed = computed.value != old;
                if database.reads(key) != computed.reads {
                    database.set_reads(key, computed.reads);
                }
                if changed {
                    database.set_cell(key, Some(Cell { value: computed.value, units, source }));
                    recompute(database, &[key])?;
                }
            }
            Err(error) => {
                let rest = database.reads(key).iter().copied().filter(|r| *r != STRUCTURE).collect();
                database.set_reads(key, rest);
                let name = cell_name(database, key);
                warnings.push(
                    Diagnostic::warning(
                        "expression/no-longer-valid",
                        format!("`{name}` keeps its value: {}", error.message),
                    )
                    .note("its expression asks the database and has no value any more"),
                );
            }
        }
    }
    Ok(warnings)
}

/// Evaluates again everything that depends on changed cells, each after what it reads. A circle is
/// an error that names its cells. On an error the caller rolls back.
#[allow(clippy::result_large_err)]
pub fn recompute(database: &mut Database, changed: &[CellKey]) -> Result<(), Diagnostic> {
    let order = database.affected(changed).map_err(|circle| circle_error(database, &circle.0))?;
    for key in order {
        let Some(object) = database.get(key.object) else { continue };
        let Some(cell) = object.cells.get(key.cell as usize) else { continue };
        if !cell.is_expression() {
            continue;
        }
        let source = cell.source.clone();
        let (old, old_units) = (cell.value.clone(), cell.units);
        let computed = compute(database, key, &source).map_err(|e| in_cell(e, &cell_name(database, key)))?;
        let units = database.settings().units;
        if computed.value != old || units != old_units {
            database.set_cell(key, Some(Cell { value: computed.value, units, source }));
        }
        if database.reads(key) != computed.reads {
            database.set_reads(key, computed.reads);
            // New reads may close a circle that the order above could not see.
            database.affected(&[key]).map_err(|circle| circle_error(database, &circle.0))?;
        }
    }
    Ok(())
}

pub(crate) fn cell_name(database: &Database, key: CellKey) -> String {
    let field = database.get(key.object).and_then(|o| o.class.fields().nth(key.cell as usize)).map_or("", |f| f.name);
    format!("{}.{field}", database.full_name(key.object))
}

fn in_cell(diagnostic: Diagnostic, cell: &str) -> Diagnostic {
    diagnostic.note(format!("in the expression of `{cell}`"))
}

fn circle_error(database: &Database, cells: &[CellKey]) -> Diagnostic {
    let names: Vec<String> = cells.iter().map(|c| format!("`{}`", cell_name(database, *c))).collect();
    let message = match names.as_slice() {
        [one] => format!("{one} would depend on itself"),
        several => format!("{} would depend on each other in a circle", several.join(", ")),
    };
    Diagnostic::error("expression/circle", message).help("use EVAL to take the present value of one of them")
}
