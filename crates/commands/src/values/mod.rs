//! Arguments become values of cells: numbers with their units, words, texts, objects, functions.

mod objects;
mod words;

use expressions::is_rate_of_angle;
use model::{Array, CellKey, Database, Expression, FunctionText, ObjectId, Source, Value};
use schema::{Dimension, Field, Kind, Registry, parse_unit_expression};
use smallvec::{SmallVec, smallvec};
use syntax::command::{Argument, Item, ItemKind, parse_expression};
use text::{Diagnostic, Sources, Span};

use crate::{
    evaluation::{self, Outcome},
    lookup,
    program::Program,
    symmetric,
};

/// A value for a cell, not yet stored.
#[derive(Clone, Debug)]
pub struct Draft {
    pub value: Value,
    pub source: Source,
    pub reads: Vec<CellKey>,
}

impl Draft {
    pub fn literal(value: Value) -> Draft {
        Draft { value, source: Source::Literal, reads: Vec::new() }
    }
}

/// What reading a value needs.
pub struct Reader<'a> {
    pub database: &'a Database,
    pub registry: &'a Registry,
    pub sources: &'a Sources,
    pub program: &'a Program,
    pub world: &'a expressions::World,
    /// The object whose cell is filled.
    pub owner: Option<ObjectId>,
    pub warnings: Vec<Diagnostic>,
}

type Errors = Vec<Diagnostic>;
/// The numbers of one value, the expression to keep, and what it reads.
type NumberItem = (Numbers, Option<Expression>, Vec<CellKey>);
/// Rarely more than a location.
type Numbers = SmallVec<[f64; 3]>;

impl Reader<'_> {
    /// Reads the values of an argument as its field wants them.
    pub fn read(&mut self, field: &Field, argument: &Argument) -> Result<Draft, Errors> {
        if argument.values.is_empty() {
            let error = Diagnostic::error("command/missing-value", format!("`{}` has no value", field.name))
                .at(argument.name, "a value is missing behind `=`")
                .adams(match field.kind {
                    Kind::Object(..) => "Invalid input. Enter '.' or an entity name.",
                    Kind::Text | Kind::File | Kind::Function => "Invalid input. Enter a quoted string.",
                    _ => "Invalid input. Enter a value.",
                });
            return Err(vec![error]);
        }
        match field.kind {
            Kind::Integer | Kind::Real | Kind::Location | Kind::Orientation => self.numbers(field, argument),
            Kind::Boolean(yes, no) => self.boolean(field, argument, yes, no),
            Kind::Choice(words) => self.choices(field, argument, words),
            Kind::Text | Kind::File => self.texts(field, argument),
            Kind::Function => self.function(field, argument),
            Kind::Object(_, wanted) => self.objects(field, argument, wanted),
            Kind::Any => self.any(field, argument),
        }
    }

    pub fn evaluate(&self, item: &Item) -> Result<Option<Outcome>, Errors> {
        match &item.kind {
            ItemKind::Expression(e) => {
                evaluation::evaluate(e, self.database, self.sources, self.world, self.owner).map(Some)
            }
            _ => Ok(None),
        }
    }

    fn word(&self, span: Span) -> &str {
        self.program.word(span)
    }

    // ---- numbers ----

    fn numbers(&mut self, field: &Field, argument: &Argument) -> Result<Draft, Errors> {
        let mut values = Numbers::with_capacity(argument.values.len());
        let mut elements: Vec<Option<Expression>> = Vec::new();
        let mut reads = Vec::new();
        let (mut kept_any, mut errors) = (false, Vec::new());
        let count = argument.values.len();
        for (i, item) in argument.values.iter().enumerate() {
            match self.number_item(field, item) {
                Ok((numbers, kept, item_reads)) => {
                    if numbers.len() != 1 && count != 1 && kept.is_some() {
                        errors.push(
                            Diagnostic::error(
                                "command/wrong-count",
                                format!("this element of `{}` yields {} numbers", field.name, numbers.len()),
                            )
                            .at(item.span, "one number is wanted here")
                            .adams("Invalid input. Enter return or a parameter."),
                        );
                    }
                    values.extend(numbers);
                    if kept.is_some() {
                        kept_any = true;
                        elements.resize(count, None);
                        elements[i] = kept;
                    }
                    reads.extend(item_reads);
                }
                Err(mut e) => errors.append(&mut e),
            }
        }
        if !errors.is_empty() {
            // A list of words where numbers are wanted: the number of values says more.
            let words = argument.values.iter().all(|i| !matches!(i.kind, ItemKind::Expression(_)));
            if field.count.most != usize::MAX && field.count.least > 1 && values.is_empty() && words {
                errors.insert(0, Self::count_error(field, argument, count));
            }
            return Err(errors);
        }
        let full = field.symmetric.is_some_and(|side| values.len() == side * side);
        if !full && (values.len() < field.count.least || values.len() > field.count.most) {
            return Err(vec![Self::count_error(field, argument, values.len())]);
        }
        for (x, item) in values.iter().zip(argument.values.iter().chain(std::iter::repeat(&argument.values[0]))) {
            if !x.is_finite() {
                let error = Diagnostic::error("value/not-finite", format!("`{}` must be a finite number", field.name))
                    .at(item.span, format!("this is {x}"))
                    .adams("Invalid input. Enter a real number.");
                return Err(vec![error]);
            }
            if field.kind == Kind::Integer && (x.fract() != 0.0 || x.abs() > 9.0e15) {
                let error = Diagnostic::error("value/not-integer", format!("`{}` wants a whole number", field.name))
                    .at(item.span, format!("this is {x}"))
                    .adams("Invalid input. Enter an integer.");
                return Err(vec![error]);
            }
        }
        if let Some((triangle, kept)) = symmetric::folded(field, argument, &values, &elements).map_err(|e| vec![e])? {
            values = triangle.into();
            if count > 1 {
                elements = kept;
            }
        }
        self.warn_outside(field, &values, argument);
        let value = match (field.kind, values.as_slice()) {
            (Kind::Integer, [one]) if field.count.most == 1 => Value::Integer(*one as i64),
            (Kind::Real, [one]) if field.count.most == 1 => Value::Number(*one),
            _ => Value::Array(Array::column(values.into_vec())),
        };
        let source = match (kept_any, count) {
            (false, _) => Source::Literal,
            (true, 1) => match elements.pop().flatten() {
                Some(e) => Source::Expression(Box::new(e)),
                None => Source::Literal,
            },
            (true, _) => Source::Elements(Box::new(elements)),
        };
        Ok(Draft { value, source, reads })
    }

    /// Warns of numbers that the field has no use for; they are stored, and refused by a simulation.
    fn warn_outside(&mut self, field: &Field, values: &[f64], argument: &Argument) {
        for (i, x) in values.iter().enumerate().filter(|(_, x)| !field.limit.allows(**x)) {
            let item = if argument.values.len() == values.len() { argument.values.get(i) } else { None };
            let span = item.map_or(argument.value_span, |item| item.span);
            let message = format!("`{}` is {x}; it must be {}", field.name, field.limit);
            let mut warning =
                Diagnostic::warning("value/outside-limit", message).at(span, format!("not {}", field.limit));
            if !field.doc.is_empty() {
                warning = warning.note(format!("`{}`: {}", field.name, field.doc));
            }
            self.warnings.push(warning);
        }
    }

    fn count_error(field: &Field, argument: &Argument, found: usize) -> Diagnostic {
        let wanted = match (field.count.least, field.count.most) {
            (least, _) if let Some(side) = field.symmetric => format!("{least} or {}", side * side),
            (least, most) if least == most => format!("{least}"),
            (least, usize::MAX) => format!("at least {least}"),
            (least, most) => format!("{least} to {most}"),
        };
        let noun = match field.kind {
            Kind::Integer | Kind::Real | Kind::Location | Kind::Orientation => "number",
            _ => "value",
        };
        let plural = if wanted == "1" { "" } else { "s" };
        Diagnostic::error("command/wrong-count", format!("`{}` wants {wanted} {noun}{plural}, not {found}", field.name))
            .at(argument.value_span, format!("{found} given"))
            .help(if wanted == "1" {
                format!("give one {noun}")
            } else {
                format!("give {wanted} {noun}s, separated by commas")
            })
            .adams(format!(
                "{} values are required for '{}'.",
                if field.symmetric.is_some() { field.count.least.to_string() } else { wanted },
                field.name
            ))
    }

    fn number_item(&mut self, field: &Field, item: &Item) -> Result<NumberItem, Errors> {
        match &item.kind {
            ItemKind::Number { value, unit: None } => Ok((smallvec![*value], None, Vec::new())),
            ItemKind::Number { value, unit: Some(unit) } => {
                Ok((smallvec![self.with_unit(field, *value, unit, item.span)?], None, Vec::new()))
            }
            ItemKind::Expression(e) => {
                let outcome = evaluation::evaluate(e, self.database, self.sources, self.world, self.owner)?;
                if let Value::Text(text) = &outcome.value {
                    // A text in the place of a number is read as an expression itself.
                    let numbers = self.number_text(field, text, item.span)?;
                    return Ok((numbers.into(), None, Vec::new()));
                }
                let Some(numbers) = outcome.value.as_numbers() else {
                    return Err(vec![not_a_number(field, item.span, &describe(&outcome.value))]);
                };
                if let Some(found) = outcome.dimension {
                    self.check_dimension(field, found, &outcome, item.span)?;
                }
                let radians = match (&outcome.kept, outcome.dimension) {
                    (Some(kept), _) => evaluation::radians_per_time(kept, field, self.database),
                    (None, Some(found)) if field.dimension == Dimension::PER_TIME && is_rate_of_angle(found) => {
                        self.database.units().angle.si
                    }
                    _ => 1.0,
                };
                let numbers = numbers.into_iter().map(|x| x * radians).collect();
                Ok((numbers, outcome.kept, outcome.reads))
            }
            ItemKind::Text(text) => Ok((self.number_text(field, text, item.span)?.into(), None, Vec::new())),
            ItemKind::Word => {
                let word = self.word(item.span);
                let mut error = not_a_number(field, item.span, "a word");
                if lookup::search_one(self.database, word, "variable").is_some() {
                    error = error.fix("a variable is referred to in parentheses", item.span, format!("({word})"));
                }
                Err(vec![error])
            }
        }
    }

    fn number_text(&self, field: &Field, text: &str, span: Span) -> Result<Vec<f64>, Errors> {
        if let Ok(number) = text.trim().parse::<f64>() {
            return Ok(vec![number]);
        }
        let parsed = parse_expression(span.file, text, span.start as usize + 1);
        let usable = parsed.1.iter().all(|d| !d.is_error());
        let value = if usable {
            evaluation::evaluate(&parsed.0, self.database, self.sources, self.world, self.owner).ok().map(|o| o.value)
        } else {
            None
        };
        value
            .and_then(|v| v.as_numbers())
            .ok_or_else(|| vec![not_a_number(field, span, &format!("the text \"{text}\""))])
    }

    /// A plain number with a unit behind it, in current units.
    fn with_unit(&self, field: &Field, value: f64, unit: &str, span: Span) -> Result<f64, Errors> {
        let known = if unit.eq_ignore_ascii_case("d") {
            Some((Dimension::ANGLE, std::f64::consts::PI / 180.0))
        } else {
            parse_unit_expression(unit)
        };
        let Some((dimension, si)) = known else {
            let error = Diagnostic::error("unit/unknown", format!("`{unit}` is not a unit"))
                .at(span, "unknown unit")
                .adams("Invalid input. Enter return or a parameter.");
            return Err(vec![expressions::with_units(error, unit, Some(field.dimension))]);
        };
        let units = self.database.units();
        // An angle unit on a rate or a stiffness concerns its angle alone.
        let angle_part = dimension == Dimension::ANGLE && field.dimension.angle == 1;
        if field.dimension == Dimension::PER_TIME && is_rate_of_angle(dimension) {
            // Radians per time, whatever the angle unit is; `72d` is an angle per unit of time.
            return Ok(value * (si / units.factor(Dimension { angle: 0, ..dimension })));
        }
        if dimension != field.dimension && field.dimension != Dimension::NONE && !angle_part {
            return Err(vec![wrong_dimension(self.database, field, dimension, span)]);
        }
        Ok(value * (si / units.factor(dimension)))
    }

    fn check_dimension(
        &mut self,
        field: &Field,
        found: Dimension,
        outcome: &Outcome,
        span: Span,
    ) -> Result<(), Errors> {
        let wanted = field.dimension;
        let same = Dimension { angle: wanted.angle, ..found } == wanted;
        let rate = wanted == Dimension::PER_TIME && is_rate_of_angle(found);
        if same || rate || wanted == Dimension::NONE || found == Dimension::NONE || field.kind == Kind::Integer {
            return Ok(());
        }
        let error = wrong_dimension(self.database, field, found, span);
        if outcome.kept.as_ref().is_some_and(evaluation::is_plain_quantity) {
            return Err(vec![error]);
        }
        self.warnings.push(Diagnostic { severity: text::Severity::Warning, adams_text: Vec::new(), ..error });
        Ok(())
    }

    fn any(&mut self, field: &Field, argument: &Argument) -> Result<Draft, Errors> {
        if let [item] = argument.values.as_slice()
            && let Some(outcome) = self.evaluate(item)?
        {
            let source = outcome.kept.map_or(Source::Literal, |e| Source::Expression(Box::new(e)));
            return Ok(Draft { value: outcome.value, source, reads: outcome.reads });
        }
        if argument.values.iter().all(|i| matches!(i.kind, ItemKind::Number { .. })) {
            return self.numbers(&Field { kind: Kind::Real, ..*field }, argument);
        }
        self.texts(field, argument)
    }
}

/// The text form of a value where a text is wanted.
pub fn text_of(value: &Value, database: &Database) -> String {
    match value {
        Value::Nothing => "none".into(),
        Value::Number(x) => format!("{x:?}"),
        Value::Integer(i) => i.to_string(),
        Value::Flag(b) => i64::from(*b).to_string(),
        Value::Text(text) => text.clone(),
        Value::Object(id) => database.full_name(*id),
        Value::Array(array) => array.values.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(", "),
        Value::Texts(texts) => texts.join(", "),
        Value::Objects(ids) => ids.iter().map(|id| database.full_name(*id)).collect::<Vec<_>>().join(", "),
        Value::Function(function) => function_string(function, database),
    }
}

/// A function text with full names.
pub fn function_string(function: &FunctionText, database: &Database) -> String {
    function.write(|id| if database.get(id).is_some() { database.full_name(id) } else { "(deleted)".into() })
}

fn describe(value: &Value) -> String {
    match value {
        Value::Object(_) | Value::Objects(_) => "an object".into(),
        Value::Nothing => "no object".into(),
        _ => "no number".into(),
    }
}

fn not_a_number(field: &Field, span: Span, found: &str) -> Diagnostic {
    Diagnostic::error("value/not-a-number", format!("`{}` wants a number, not {found}", field.name))
        .at(span, "not a number")
        .adams("Invalid input. Enter a real number.")
}

fn wrong_dimension(database: &Database, field: &Field, found: Dimension, span: Span) -> Diagnostic {
    let name = |d: Dimension| d.name().map_or_else(|| database.units().label(d), |n| n.replace('_', " "));
    let wanted = database.units().label(field.dimension);
    Diagnostic::error(
        "unit/wrong-dimension",
        format!(
            "`{}` is of the kind {}, but the value is of the kind {}",
            field.name,
            name(field.dimension),
            name(found)
        ),
    )
    .at(span, format!("this is in {}", database.units().label(found)))
    .note(format!("a plain number is read in {wanted}"))
    .adams("The units of the expression are not those of the parameter.")
}
