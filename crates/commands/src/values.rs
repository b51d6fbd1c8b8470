//! Arguments become values of cells: numbers with their units, words, texts, objects, functions.

use std::borrow::Cow;

use expressions::is_rate_of_angle;
use model::{Array, CellKey, Database, Expression, FunctionText, ObjectId, Source, Value};
use schema::{Dimension, Field, Kind, Registry, parse_unit_expression};
use smallvec::{SmallVec, smallvec};
use syntax::command::{Argument, Item, ItemKind, parse_expression};
use text::{Diagnostic, Sources, Span};

use crate::{
    evaluation::{self, Outcome},
    function_text, lookup,
    program::Program,
    words::{Match, did_you_mean, is_pattern, match_word},
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
/// The objects a name means, and what is to be said of them.
type Named = (SmallVec<[ObjectId; 1]>, Option<Diagnostic>);
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
        if values.len() < field.count.least || values.len() > field.count.most {
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
            (true, _) => Source::Elements(elements),
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
            .help(format!("give {wanted} {noun}{plural}, separated by commas"))
            .adams(format!("{wanted} values are required for '{}'.", field.name))
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
            return Err(vec![error]);
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

    // ---- words ----

    fn plain<'i>(&'i self, item: &'i Item) -> Result<Cow<'i, str>, Errors> {
        match &item.kind {
            ItemKind::Text(text) => Ok(Cow::Borrowed(text)),
            ItemKind::Word | ItemKind::Number { .. } => Ok(Cow::Borrowed(self.word(item.span))),
            ItemKind::Expression(e) => {
                let outcome = evaluation::evaluate(e, self.database, self.sources, self.world, self.owner)?;
                Ok(Cow::Owned(text_of(&outcome.value, self.database)))
            }
        }
    }

    fn boolean(&mut self, field: &Field, argument: &Argument, yes: &str, no: &str) -> Result<Draft, Errors> {
        let [item] = argument.values.as_slice() else {
            return Err(vec![Self::count_error(field, argument, argument.values.len())]);
        };
        let typed = self.plain(item)?;
        let flag = match match_word([yes, no], &typed) {
            Match::One(i) => Some(i == 0),
            _ => match typed.to_ascii_lowercase().as_str() {
                "yes" | "on" | "true" | "1" => Some(true),
                "no" | "off" | "false" | "0" => Some(false),
                _ => None,
            },
        };
        flag.map(|f| Draft::literal(Value::Flag(f))).ok_or_else(|| {
            vec![
                Diagnostic::error("command/unknown-word", format!("`{}` is `{yes}` or `{no}`", field.name))
                    .at(item.span, format!("`{typed}` is neither"))
                    .adams(format!("'{typed}' is not a valid choice for '{}'.", field.name)),
            ]
        })
    }

    fn choices(&mut self, field: &Field, argument: &Argument, words: &[&'static str]) -> Result<Draft, Errors> {
        let mut chosen = Vec::new();
        for item in &argument.values {
            let typed = self.plain(item)?;
            match match_word(words.iter().copied(), &typed) {
                Match::One(i) => chosen.push(words[i].to_string()),
                Match::Many(found) => {
                    let names: Vec<&str> = found.iter().map(|i| words[*i]).collect();
                    return Err(vec![
                        Diagnostic::error(
                            "command/ambiguous-abbreviation",
                            format!("`{typed}` may stand for {}", names.join(", ")),
                        )
                        .at(item.span, "ambiguous")
                        .adams(format!("'{typed}' is ambiguous.")),
                    ]);
                }
                Match::None => {
                    let error = Diagnostic::error(
                        "command/unknown-word",
                        format!("`{typed}` is not a choice for `{}`", field.name),
                    )
                    .at(item.span, format!("wants {}", words.join(", ")))
                    .adams(format!("'{typed}' is not a valid choice for '{}'.", field.name));
                    let words = words.iter().copied();
                    let guessed = did_you_mean(error, words, &typed, item.span, str::to_string);
                    return Err(vec![guessed.unwrap_or_else(|error| error)]);
                }
            }
        }
        Self::text_value(field, argument, chosen)
    }

    fn text_value(field: &Field, argument: &Argument, mut texts: Vec<String>) -> Result<Draft, Errors> {
        if texts.len() > field.count.most || texts.len() < field.count.least {
            return Err(vec![Self::count_error(field, argument, texts.len())]);
        }
        let value =
            if field.count.most == 1 { Value::Text(texts.pop().unwrap_or_default()) } else { Value::Texts(texts) };
        Ok(Draft::literal(value))
    }

    fn texts(&mut self, field: &Field, argument: &Argument) -> Result<Draft, Errors> {
        let mut texts = Vec::new();
        let mut kept = None;
        let mut reads = Vec::new();
        for item in &argument.values {
            if let Some(outcome) = self.evaluate(item)? {
                match &outcome.value {
                    Value::Texts(list) => texts.extend(list.iter().cloned()),
                    other => texts.push(text_of(other, self.database)),
                }
                if argument.values.len() == 1 && !outcome.reads.is_empty() {
                    kept = outcome.kept;
                    reads = outcome.reads;
                }
            } else {
                texts.push(self.plain(item)?.into_owned());
            }
        }
        let mut draft = Self::text_value(field, argument, texts)?;
        if let Some(expression) = kept {
            draft.source = Source::Expression(Box::new(expression));
            draft.reads = reads;
        }
        Ok(draft)
    }

    fn function(&mut self, _field: &Field, argument: &Argument) -> Result<Draft, Errors> {
        let mut text = String::new();
        for item in &argument.values {
            match self.evaluate(item)? {
                Some(outcome) => text.push_str(&text_of(&outcome.value, self.database)),
                None => text.push_str(&self.plain(item)?),
            }
        }
        let (bound, unknown) = function_text::bind(self.database, &text);
        for name in unknown {
            self.warnings.push(
                Diagnostic::warning("name/not-found", format!("the function names `{name}`, which does not exist"))
                    .at(argument.value_span, "kept as text")
                    .note("it must exist when the model is simulated, and does not follow a renaming"),
            );
        }
        Ok(Draft::literal(Value::Function(bound)))
    }

    // ---- objects ----

    fn objects(&mut self, field: &Field, argument: &Argument, wanted: &str) -> Result<Draft, Errors> {
        let mut found: SmallVec<[ObjectId; 1]> = SmallVec::new();
        let mut kept = None;
        let mut reads = Vec::new();
        let many = field.count.most > 1;
        for item in &argument.values {
            if let Some(outcome) = self.evaluate(item)? {
                match &outcome.value {
                    Value::Nothing => {}
                    Value::Text(name) => {
                        let (ids, said) = self.named(name, wanted, many, item.span)?;
                        self.warnings.extend(said);
                        found.extend(ids);
                    }
                    Value::Texts(names) => {
                        for name in names {
                            let (ids, said) = self.named(name, wanted, many, item.span)?;
                            self.warnings.extend(said);
                            found.extend(ids);
                        }
                    }
                    other => {
                        let objects = other.objects();
                        if objects.is_empty() {
                            return Err(vec![self.not_an_object(field, wanted, item.span)]);
                        }
                        for object in objects {
                            found.push(self.as_wanted(object, wanted, item.span)?);
                        }
                    }
                }
                if argument.values.len() == 1 {
                    kept = outcome.kept;
                    reads = outcome.reads;
                }
            } else if let ItemKind::Number { .. } = item.kind {
                return Err(vec![self.not_an_object(field, wanted, item.span)]);
            } else {
                let name = self.plain(item)?;
                if name.eq_ignore_ascii_case("none") && found.is_empty() && argument.values.len() == 1 {
                    return Ok(Draft::literal(Value::Nothing));
                }
                let (ids, said) = self.named(&name, wanted, many, item.span)?;
                self.warnings.extend(said);
                found.extend(ids);
            }
        }
        if found.len() > field.count.most {
            return Err(vec![Self::count_error(field, argument, found.len())]);
        }
        let value = match (many, found.as_slice()) {
            (false, [one]) => Value::Object(*one),
            (false, _) => Value::Nothing,
            (true, _) => Value::Objects(found.into_vec()),
        };
        let source = kept.map_or(Source::Literal, |e| Source::Expression(Box::new(e)));
        Ok(Draft { value, source, reads })
    }

    /// The objects a name means, and what is said of a pattern that means several.
    fn named(&self, name: &str, wanted: &str, many: bool, span: Span) -> Result<Named, Errors> {
        let mut said = None;
        let outcome = if many && is_pattern(name) {
            let found = lookup::find_all(self.database, self.registry, name, wanted, span);
            if let Ok(found) = &found
                && found.len() > 1
            {
                said = Some(lookup::several(self.database, self.registry, name, wanted, found).at(span, ""));
            }
            found.map(SmallVec::from_vec)
        } else {
            lookup::find(self.database, self.registry, name, wanted, span).map(|id| smallvec![id])
        };
        outcome.map(|found| (found, said)).map_err(|e| vec![e])
    }

    fn as_wanted(&self, id: ObjectId, wanted: &str, span: Span) -> Result<ObjectId, Errors> {
        let class = self.database.object(id).class;
        if class.is(wanted) {
            return Ok(id);
        }
        let word = lookup::word_of(self.registry, wanted);
        let name = self.database.full_name(id);
        Err(vec![
            Diagnostic::error(
                "name/wrong-kind",
                format!("`{name}` is a {}, not a {}", class.word.to_lowercase(), word.to_lowercase()),
            )
            .at(span, format!("a {} is wanted", word.to_lowercase()))
            .adams(format!("No {word} named '{name}' was found.")),
        ])
    }

    fn not_an_object(&self, field: &Field, wanted: &str, span: Span) -> Diagnostic {
        let word = lookup::word_of(self.registry, wanted).to_lowercase();
        Diagnostic::error("value/not-an-object", format!("`{}` wants the name of a {word}", field.name))
            .at(span, "names nothing")
            .adams("Invalid input. Enter '.' or an entity name.")
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
