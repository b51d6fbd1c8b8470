//! Cells of objects from arguments: numbers with their units, references, words, texts, functions.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use model::{Array, Cell, CellKey, Database, ObjectId, Source, UnitsId, Value};
use schema::{Count, Default, Field, Kind, Registry};
use text::{Diagnostic, FileId, Span};

use super::{
    Entry, Loaded, Naming, Statements, guess,
    statement::{Argument, Statement},
    values::{self, Number},
};
use crate::statements;

/// Makes the objects of a model.
pub(crate) struct Builder<'a> {
    pub database: &'a mut Database,
    pub registry: &'a Registry,
    pub text: &'a str,
    pub model: ObjectId,
    pub(super) file: FileId,
    /// Objects by statement and number.
    pub(super) numbers: HashMap<(&'static str, i64), ObjectId>,
    /// Objects that are not read, with a warning: what refers to them gets one too.
    pub(super) left_out: HashSet<(&'static str, i64)>,
    /// How often a name that is taken was asked for.
    pub(super) taken: HashMap<(ObjectId, String), usize>,
    /// The units of the dataset with degrees, and with radians.
    pub(super) degrees: UnitsId,
    pub(super) radians: UnitsId,
    /// Where the functions of objects stand.
    pub(super) functions: Vec<(CellKey, Span)>,
    pub diagnostics: Vec<Diagnostic>,
}

pub(super) fn build(
    database: &mut Database,
    registry: &Registry,
    (file, text): (FileId, &str),
    found: Statements,
    naming: Naming<'_>,
) -> Result<Loaded, Vec<Diagnostic>> {
    let mut diagnostics = found.diagnostics;
    let (statements, repeated) = merged(found.statements);
    diagnostics.extend(repeated);
    if statements.is_empty() && guess::looks_like_commands(text) {
        return Err(vec![guess::command_file(file)]);
    }
    if statements.is_empty() {
        let mut nothing = Diagnostic::error("dataset/empty", "the dataset has no statement that is understood");
        // A file of another kind would get an error for each of its lines.
        if diagnostics.len() > 3 {
            let first = diagnostics.iter().find(|d| d.is_error()).and_then(|d| d.primary.as_ref());
            if let Some(label) = first {
                nothing = nothing.at(label.span, "the first line that is no statement");
            }
            diagnostics.clear();
        }
        diagnostics.push(nothing.help("a dataset is a title line, statements such as `PART/1, GROUND`, and `END`"));
        return Err(diagnostics);
    }
    let title = found.title.strip_prefix(super::TITLE).or_else(|| found.title.strip_prefix(super::OLD_TITLE));
    let titled = title.map(str::trim).filter(|name| is_name(name));
    let name = naming.model.or(titled).unwrap_or(naming.otherwise);
    let name: String = name.chars().map(|c| if matches!(c, '.' | '"') { '_' } else { c }).collect();
    let name = if name.trim().is_empty() { "MODEL_1".to_string() } else { name };
    let class = registry.class("model").ok_or_else(Vec::new)?;
    let model = database.create(class, None, &name).map_err(|_| {
        let taken = format!("there is a model `.{name}` already");
        vec![Diagnostic::error("dataset/model-exists", taken).help("give the new one a name: `model_name = ...`")]
    })?;
    let old = *database.units();
    let (degrees, radians) = (database.settings().units, database.settings().units);
    let mut builder = Builder {
        database,
        registry,
        text,
        model,
        file,
        numbers: HashMap::new(),
        left_out: HashSet::new(),
        taken: HashMap::new(),
        degrees,
        radians,
        functions: Vec::new(),
        diagnostics,
    };
    builder.units(&statements, old);
    if class.cell_index("fit_to_view").is_some() {
        builder.database.set_value(model, "fit_to_view", Value::Flag(true));
    }
    if titled.is_none() && !found.title.trim().is_empty() {
        builder.database.set_value(model, "title", Value::Text(found.title.trim().to_string()));
    }
    let mut comments = found.model_comments;
    let mut of_units: Vec<_> =
        statements.iter().filter(|s| s.name == "UNITS" && !s.inactive).flat_map(|s| s.comments.clone()).collect();
    if comments.is_empty() {
        comments.append(&mut of_units);
    }
    builder.objects(&statements, &mut comments);
    comments.extend(found.trailing_comments);
    // Those of UNITS, which is no object, keep their place behind the line that ends those of the model.
    if !of_units.is_empty() {
        comments.push(super::END_OF_MODEL_COMMENTS.to_string());
        comments.append(&mut of_units);
    }
    if !comments.is_empty() {
        builder.database.set_value(model, "comments", Value::Texts(comments));
    }
    super::in_order(&mut builder.diagnostics);
    Ok(Loaded { model, functions: builder.functions, diagnostics: builder.diagnostics })
}

/// Settings, and gravity, that are given in several statements as one of each: of what two say, the last one counts.
fn merged(all: Vec<Statement>) -> (Vec<Statement>, Vec<Diagnostic>) {
    let mut merged: Vec<Statement> = Vec::with_capacity(all.len());
    let mut repeated = Vec::new();
    for statement in all {
        let setting = statement.name != "UNITS" && !statements::has_number(statement.name) && !statement.inactive;
        let earlier = merged.iter_mut().find(|s| setting && s.name == statement.name && !s.inactive);
        let Some(earlier) = earlier else {
            merged.push(statement);
            continue;
        };
        let message = format!("there is a second {}/: of what both say, the last one counts", statement.name);
        let second = Diagnostic::warning("dataset/second-setting", message).at(statement.head, "this one counts");
        repeated.push(second.label(earlier.head, "the first one").help("make one statement of them"));
        earlier.arguments.extend(statement.arguments);
        earlier.comments.extend(statement.comments);
    }
    (merged, repeated)
}

/// How many values there may be, in words.
pub(super) fn wanted(count: Count) -> String {
    match (count.least, count.most) {
        (least, most) if least == most => least.to_string(),
        (least, usize::MAX) => format!("at least {least}"),
        (least, most) => format!("{least} to {most}"),
    }
}

/// Whether a title ends in what is a name, and not a sentence.
fn is_name(name: &str) -> bool {
    !name.is_empty() && name.len() <= 200 && !name.contains(['.', '"', ':', '#', '\t'])
}

impl Builder<'_> {
    pub fn span(&self, range: &Range<usize>) -> Span {
        Span::new(self.file, range.start, range.end)
    }

    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// The numbers of an argument with their places; `None`, and reported, if something else is there.
    pub fn list(&mut self, argument: &Argument) -> Option<Vec<(Number, Range<usize>)>> {
        let items = argument.items(self.text);
        let mut numbers = Vec::with_capacity(items.len());
        for (item, range) in items {
            let Some(number) = values::parse(item) else {
                let at = self.span(&range);
                self.report(values::no_number(item, &argument.keyword, at));
                return None;
            };
            numbers.push((number, range));
        }
        Some(numbers)
    }

    /// The numbers of an argument as SI angles where they are angles.
    pub fn plain(&mut self, argument: &Argument) -> Option<Vec<f64>> {
        let list = self.list(argument)?;
        Some(list.into_iter().map(|(n, _)| if n.degrees { n.value.to_radians() } else { n.value }).collect())
    }

    /// Numbers that must be so many.
    pub fn exactly<const N: usize>(&mut self, argument: &Argument) -> Option<[f64; N]> {
        let values = self.plain(argument)?;
        let array = <[f64; N]>::try_from(values.as_slice()).ok();
        if array.is_none() {
            self.count(argument, values.len(), &N.to_string());
        }
        array
    }

    /// Stores a value of the dataset's units.
    pub fn store(&mut self, id: ObjectId, field: &str, value: Value) {
        self.store_in(id, field, value, self.degrees);
    }

    fn store_in(&mut self, id: ObjectId, field: &str, value: Value, units: UnitsId) {
        if let Some(index) = self.database.object(id).class.cell_index(field) {
            let cell = Cell { value, units, source: Source::Literal };
            self.database.set_cell(CellKey::new(id, index), Some(cell));
        }
    }

    /// The field of a class by its name.
    pub fn field(entry: &Entry<'_>, name: &str) -> Option<&'static Field> {
        entry.class.cell_index(name).map(|index| entry.class.field(index))
    }

    /// Stores the numbers of an argument in a field.
    pub fn set_numbers(&mut self, entry: &Entry<'_>, name: &str, argument: &Argument) {
        let Some(list) = self.list(argument) else { return };
        self.set_listed(entry, name, argument, &list);
    }

    /// Stores numbers in a field of a class: as many as it takes, in degrees where they are so.
    pub fn set_listed(&mut self, entry: &Entry<'_>, name: &str, argument: &Argument, list: &[(Number, Range<usize>)]) {
        let Some(field) = Self::field(entry, name) else { return };
        if list.len() < field.count.least || list.len() > field.count.most {
            return self.count(argument, list.len(), &wanted(field.count));
        }
        let d = field.dimension;
        // Speeds of turning are angles over time, which their dimension does not show.
        let material = d.length != 0 || d.mass != 0 || d.force != 0;
        if material
            && d.angle == 0
            && let Some((_, range)) = list.iter().find(|(n, _)| n.degrees)
        {
            let message = format!("`{}` of {} is no angle: `D` makes degrees of it", argument.keyword, entry.name());
            let at = self.span(range);
            let degrees = Diagnostic::warning("dataset/degrees", message).at(at, "taken as degrees, in radians");
            self.report(degrees.help("write an exponent with `E`"));
        }
        let angle = statements::is_angle(d);
        let in_degrees = angle && list.iter().any(|(n, _)| n.degrees);
        let number = |n: &Number| match (n.degrees, in_degrees) {
            (true, false) => n.value.to_radians(),
            (false, true) => n.value.to_degrees(),
            _ => n.value,
        };
        let values: Vec<f64> = list.iter().map(|(n, _)| number(n)).collect();
        if field.kind == Kind::Integer
            && let Some((x, (_, range))) = values.iter().zip(list).find(|(x, _)| x.fract() != 0.0)
        {
            let message = format!("`{}` of {} is {x}: it must be a whole number", argument.keyword, entry.name());
            let at = self.span(range);
            return self.report(Diagnostic::error("dataset/number", message).at(at, "not whole"));
        }
        if let Some((x, (_, range))) = values.iter().zip(list).find(|(x, _)| !field.limit.allows(**x)) {
            let message = format!("`{}` of {} is {x}: it must be {}", argument.keyword, entry.name(), field.limit);
            let at = self.span(range);
            self.report(Diagnostic::warning("dataset/outside", message).at(at, "outside").help("give another value"));
        }
        let units = if d.angle != 0 && !in_degrees { self.radians } else { self.degrees };
        let value = match (values.as_slice(), field.kind) {
            ([x], Kind::Integer) if field.count.most == 1 && x.fract() == 0.0 && x.abs() < 9e15 => {
                Value::Integer(*x as i64)
            }
            ([x], _) if field.count.most == 1 => Value::Number(*x),
            _ => Value::Array(Array::column(values)),
        };
        self.store_in(entry.id, field.name, value, units);
    }

    /// Stores three angles in radians.
    pub fn set_angles(&mut self, id: ObjectId, field: &str, radians: [f64; 3]) {
        self.store_in(id, field, Value::Array(Array::column(radians.to_vec())), self.radians);
    }

    /// The object an item names by its number.
    pub fn object(
        &mut self,
        entry: &Entry<'_>,
        argument: &Argument,
        (item, range): (&str, Range<usize>),
        statements: &[&'static str],
        wanted: &str,
    ) -> Option<ObjectId> {
        let at = self.span(&range);
        let Some(number) = item.parse::<i64>().ok().filter(|n| *n > 0) else {
            let shown: String = item.chars().take(40).collect();
            let message =
                format!("`{}` needs the number of a {}, not `{shown}`", argument.keyword, statements.join(" or "));
            let mut wrong = Diagnostic::error("dataset/reference", message).at(at, "a number was expected");
            if let Some(list) = values::list_of(item, |item| item.parse::<i64>().is_ok()) {
                wrong = wrong.fix(format!("part them by commas: `{list}`"), at, list);
            } else if values::is_word(item) {
                wrong = wrong.help(format!("an argument of its own is written `{item} = ...`"));
            }
            self.report(wrong);
            return None;
        };
        let found = statements.iter().find_map(|s| self.numbers.get(&(*s, number)).copied());
        let Some(found) = found else {
            let kinds = statements.join(" or ");
            if statements.iter().any(|s| self.left_out.contains(&(*s, number))) {
                let message = format!("{} refers to {kinds}/{number}, which is not read", entry.name());
                let unread = Diagnostic::warning("dataset/refers-to-unread", message);
                self.report(unread.at(at, "left out"));
                return None;
            }
            let message = format!("{} refers to {kinds}/{number}, which is not there", entry.name());
            self.report(
                Diagnostic::error("dataset/unknown-id", message).at(at, format!("there is no {kinds}/{number}")),
            );
            return None;
        };
        let class = self.database.object(found).class;
        if !class.is(wanted) {
            let message =
                format!("`{}` of {} cannot be a {}", argument.keyword, entry.name(), class.word.to_lowercase());
            let label = format!("{}/{number} is a {}", statements.join(" or "), class.word.to_lowercase());
            self.report(Diagnostic::error("dataset/wrong-kind", message).at(at, label));
            return None;
        }
        Some(found)
    }

    /// Stores the objects of an argument.
    pub fn set_objects(&mut self, entry: &Entry<'_>, field: &Field, argument: &Argument) {
        let Kind::Object(_, wanted) = field.kind else { return };
        let statements = self.statements_of(wanted, entry.statement.name, &argument.keyword);
        let items = argument.items(self.text);
        let given = items.len();
        // What is no number at all tells more than how many there are.
        if let Some(item) = items.iter().find(|(item, _)| item.parse::<i64>().is_err()).filter(|_| given > 1) {
            self.object(entry, argument, item.clone(), &statements, wanted);
            return;
        }
        if given < field.count.least || given > field.count.most {
            return self.count(argument, given, &self::wanted(field.count));
        }
        let found: Vec<_> =
            items.into_iter().filter_map(|item| self.object(entry, argument, item, &statements, wanted)).collect();
        if found.len() != given {
            return;
        }
        let value = match found.as_slice() {
            [one] if field.count.most == 1 => Value::Object(*one),
            _ => Value::Objects(found),
        };
        self.store(entry.id, field.name, value);
    }

    /// The statements whose objects a field may refer to.
    fn statements_of(&self, wanted: &str, statement: &str, keyword: &str) -> Vec<&'static str> {
        if wanted == "any" {
            return vec![match (statement, keyword) {
                (_, "CURVE") => "CURVE",
                ("LSE", "A" | "B" | "C" | "D") | (_, "KMATRIX" | "CMATRIX" | "MATRIX") => "MATRIX",
                _ => "ARRAY",
            }];
        }
        let mut statements: Vec<_> =
            self.registry.classes.iter().filter(|c| c.is(wanted)).filter_map(|c| c.statement).collect();
        statements.dedup();
        // Where an element is asked for and another one has that number, the message says so.
        if wanted == "marker" || wanted == "floating_marker" {
            return vec!["MARKER"];
        }
        statements
    }

    /// What a new object has where nothing is given.
    pub fn defaults(&mut self, entry: &Entry<'_>) {
        let zero = statements::zero_if_left_out(entry.statement.name);
        for field in entry.class.groups.iter().filter(|g| g.creates).flat_map(|g| g.fields) {
            let given = entry
                .class
                .cell_index(field.name)
                .is_none_or(|cell| self.database.object(entry.id).cells.get(cell).is_some());
            if given || field.usage == schema::Use::Modify || statements::required(entry.statement.name, field.keyword)
            {
                continue;
            }
            let number = matches!(field.default, Default::Number(_)) && field.kind != Kind::Integer;
            let field = if zero && number { &field.default(0.0) } else { field };
            let Some(value) = Value::of_default(field) else { continue };
            self.store(entry.id, field.name, value);
        }
    }
}
