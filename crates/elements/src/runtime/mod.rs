//! Run-time functions of a model: their text becomes a compiled function whose measures are those
//! of the equations, with exact derivatives. Functions live in model units, equations in SI; the
//! conversion is here and nowhere else.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use equations::{BodyId, GROUND, Gradient, State, constraints::TimeFunction};
use functions::{Function, Resolver};
use model::{Database, FunctionText, ObjectId, Value};
use schema::{Class, Default, Dimension, Kind};
use text::Diagnostic;

use crate::lower::Lowering;

pub mod check;
pub mod loads;
pub mod measure;

use loads::LoadSlot;

/// A compiled function with the factors that turn its measures from SI into model units.
#[derive(Clone, Debug)]
pub struct Compiled {
    pub function: Function,
    /// Model units per SI unit, one for each measure of the function.
    pub factors: Vec<f64>,
    /// Model time units per second.
    pub time: f64,
}

/// The text of a function cell with full object names; empty if there is none.
pub fn text_of(database: &Database, object: ObjectId, cell: &str) -> String {
    match database.value(object, cell) {
        Some(Value::Function(function)) => written(database, function),
        Some(Value::Text(text)) => text.clone(),
        Some(Value::Texts(texts)) => texts.concat(),
        Some(other) => other.as_number().map_or(String::new(), |x| x.to_string()),
        None => String::new(),
    }
}

fn written(database: &Database, function: &FunctionText) -> String {
    function.write(|id| if database.get(id).is_some() { database.full_name(id) } else { "(deleted)".to_string() })
}

/// Compiles the function of an object; reports what is wrong with it.
pub fn compile(lowering: &mut Lowering<'_>, owner: ObjectId, text: &str) -> Option<Compiled> {
    let (tree, mut troubles) = syntax::function::parse(text::FileId(u32::MAX), text, 0);
    let mut names = Names { lowering };
    let compiled = functions::compile(&tree, &mut names);
    let function = match compiled {
        Ok(function) if troubles.iter().all(|d| !d.is_error()) => Some(function),
        Ok(_) => None,
        Err(more) => {
            troubles.extend(more);
            None
        }
    };
    let name = lowering.name(owner);
    for trouble in troubles {
        // The place is one in the function's text, not in a file.
        let mut described = Diagnostic::new(trouble.severity, trouble.code, format!("`{name}`: {}", trouble.message))
            .note(format!("the function is `{text}`"));
        described.notes.extend(trouble.notes);
        described.helps.extend(trouble.helps.into_iter().map(|help| text::Help { fix: None, ..help }));
        lowering.report(described);
    }
    let function = function?;
    let factors = function.measures().iter().map(|m| 1.0 / lowering.factor(measure::dimension(m))).collect();
    Some(Compiled { function, factors, time: 1.0 / lowering.factor(Dimension::TIME) })
}

/// What a name is worth where a function wants a number.
enum Worth {
    Number(f64),
    /// The value of a measure, which changes in a run.
    Measured,
}

/// Finds the objects that the functions of a model name.
#[derive(Clone, Copy)]
struct Finder<'a> {
    database: &'a Database,
    model: ObjectId,
}

impl Finder<'_> {
    /// An object by its name or number, or by the variable that holds it.
    fn find(&self, name: &str, fits: &dyn Fn(&Class) -> bool) -> Option<ObjectId> {
        self.find_itself(name, fits).or_else(|| {
            let variable = self.find_itself(name, &|class| class.is("variable"))?;
            let held = self.database.value(variable, "object_value").map(Value::objects).unwrap_or_default();
            held.into_iter().find(|id| self.database.get(*id).is_some_and(|o| fits(o.class)))
        })
    }

    /// An object by full name, by name below the model, or by number.
    fn find_itself(&self, name: &str, fits: &dyn Fn(&Class) -> bool) -> Option<ObjectId> {
        let Finder { database, model } = *self;
        if let Ok(number) = name.parse::<i64>() {
            let has_it = |id: &ObjectId| number > 0 && database.integer(*id, "adams_id") == Some(number);
            return database.subtree(model).into_iter().find(|id| fits(database.object(*id).class) && has_it(id));
        }
        let steps = model::split_name(name.strip_prefix('.').unwrap_or(name));
        self.descend(name, &steps, fits)
    }

    /// The object at the end of the steps of a name: a full one if it begins with a dot.
    fn descend(&self, name: &str, steps: &[String], fits: &dyn Fn(&Class) -> bool) -> Option<ObjectId> {
        let full = if name.starts_with('.') { self.database.descend_to(None, steps, fits) } else { None };
        full.or_else(|| self.database.descend_to(Some(self.model), steps, fits))
    }

    /// What a name is worth as a number: a design variable's value, that of a measure, or the number in a cell
    /// of an object, in model units. The error says what the name means instead.
    fn worth(&self, name: &str) -> Result<Worth, String> {
        let none = |more: &str| Err(format!("`{name}` is not a number, a constant or a function{more}"));
        if let Some(variable) = self.find_itself(name, &|class| class.is("variable")) {
            let cells = ["real_value", "integer_value"];
            return match cells.into_iter().find_map(|cell| self.database.number(variable, cell)) {
                Some(x) => Ok(Worth::Number(x)),
                None => none("; it is a variable that holds no number"),
            };
        }
        if self.find_itself(name, &|class| class.is("measure")).is_some() {
            return Ok(Worth::Measured);
        }
        if self.find_itself(name, &|class| class.id == "solver_variable").is_some() {
            return none(&format!("; VARVAL({name}) is its value"));
        }
        if self.find_itself(name, &|_| true).is_some() {
            return none(&self.instead(name));
        }
        let steps = model::split_name(name.strip_prefix('.').unwrap_or(name));
        let Some((cell, owner)) = steps.split_last() else { return none("") };
        let Some(owner) = self.descend(name, owner, &|_| true) else { return none("") };
        let class = self.database.object(owner).class;
        let word = crate::lower::word_of(self.database, owner);
        let Some(field) = class.fields().find(|field| field.name.eq_ignore_ascii_case(cell)) else {
            return none(&format!("; a {word} has no `{cell}`"));
        };
        if !matches!(field.kind, Kind::Real | Kind::Integer) {
            return none(&format!("; `{cell}` of a {word} is no number"));
        }
        match (self.database.value(owner, field.name).is_some(), field.default) {
            (true, _) => match self.database.number(owner, field.name) {
                Some(x) => Ok(Worth::Number(x)),
                None => none(&format!("; `{cell}` of that {word} is more than one number")),
            },
            (false, Default::Number(x)) => Ok(Worth::Number(x)),
            (false, _) => none(&format!("; `{cell}` of that {word} is not given")),
        }
    }

    /// What else a name means, for the complaint that it does not mean what is wanted.
    fn instead(&self, name: &str) -> String {
        let other = self.find(name, &|class| class.id != "model" && name.parse::<i64>().is_err());
        let word = |id| crate::lower::word_of(self.database, id);
        other.map_or(String::new(), |id| format!("; `{name}` is a {}", word(id)))
    }

    fn marker(&self, name: &str) -> Result<ObjectId, String> {
        let found = self.find(name, &|class| class.is("marker"));
        found.ok_or_else(|| format!("there is no marker `{name}`{}", self.instead(name)))
    }

    /// The element whose load a function asks for.
    fn element(&self, function: &str, name: &str) -> Result<ObjectId, String> {
        let wanted = schema::referred(function, 0);
        let found = wanted.iter().find_map(|statement| self.find(name, &|class| class.statement == Some(*statement)));
        match (found, self.find(name, &|class| class.is("force") || class.is("constraint"))) {
            (Some(id), _) => Ok(id),
            (None, Some(other)) => {
                let word = crate::lower::word_of(self.database, other);
                Err(format!("`{name}` is a {word}, which {function} does not ask for"))
            }
            (None, None) => Err(format!("there is no element `{name}` for {function}{}", self.instead(name))),
        }
    }
}

/// Turns names into frames and elements of a model that is lowered.
struct Names<'a, 'b> {
    lowering: &'a mut Lowering<'b>,
}

impl Names<'_, '_> {
    fn finder(&self) -> Finder<'_> {
        Finder { database: self.lowering.database, model: self.lowering.model }
    }
}

impl Resolver for Names<'_, '_> {
    fn marker(&mut self, name: &str) -> Result<u32, String> {
        let marker = self.finder().marker(name)?;
        let frame = self.lowering.frame(marker);
        frame.map(|f| f.0).ok_or_else(|| format!("marker `{name}` is on no part that is simulated"))
    }

    fn element(&mut self, function: &str, name: &str) -> Result<u32, String> {
        self.finder().element(function, name).map(|id| id.0)
    }

    fn number(&mut self, name: &str) -> Result<f64, String> {
        match self.finder().worth(name)? {
            Worth::Number(x) => Ok(x),
            Worth::Measured => Err(format!("the value of the measure `{name}` is not computed in functions yet")),
        }
    }
}

/// A function of time alone, SI: `value` SI units per unit of the function, `time` seconds per unit
/// of model time.
#[derive(Clone, Debug)]
pub struct TimeOnly {
    pub function: Function,
    pub value: f64,
    pub time: f64,
}

impl TimeFunction for TimeOnly {
    fn jet(&self, t: f64) -> [f64; 3] {
        let [f, f1, f2] = self.function.jet(t / self.time, &[]);
        [f * self.value, f1 * self.value / self.time, f2 * self.value / (self.time * self.time)]
    }
}

/// A function of time and state as an element evaluates it. Angles stay on the branch of the
/// evaluation before, so that they count whole turns.
#[derive(Debug)]
pub struct StateFunction {
    compiled: Compiled,
    /// SI units per unit of the function.
    unit: f64,
    /// Last value of each measure, SI, as bits.
    branches: Vec<AtomicU64>,
    /// For each measure the element whose load it is, if it is one.
    loads: Vec<Option<LoadSlot>>,
    /// Bodies the value depends on, without ground.
    bodies: Vec<BodyId>,
}

impl StateFunction {
    /// The function of an object, with the elements whose loads it asks for; these need not be
    /// lowered yet. Reports what depends on more than time, positions and velocities.
    pub fn new(lowering: &mut Lowering<'_>, owner: ObjectId, compiled: Compiled, unit: f64) -> Option<Self> {
        let (mut loads, mut frames, mut usable) = (Vec::new(), Vec::new(), true);
        for measure in compiled.function.measures() {
            frames.extend(measure::frames(measure));
            let slot = match measure {
                functions::Measure::Load { element, .. } => {
                    let (slot, ends) = loads::slot(lowering, owner, ObjectId(*element));
                    frames.extend(ends);
                    Some(slot)
                }
                _ => None,
            };
            usable &= slot.is_some() || measure::of_state(measure);
            loads.push(slot);
        }
        if !usable {
            let name = lowering.name(owner);
            lowering.report(
                Diagnostic::error(
                    "function/not-of-state",
                    format!("the function of `{name}` uses an acceleration, or all loads at a marker"),
                )
                .help("such functions can be recorded by a request, but not act as a force yet; name the elements whose loads are meant, as in BEAM(id, 0, 2)"),
            );
            return None;
        }
        let bodies = frames.into_iter().map(|frame| lowering.body_of_frame(frame)).filter(|b| *b != GROUND).collect();
        let branches = compiled.factors.iter().map(|_| AtomicU64::new(0f64.to_bits())).collect();
        Some(StateFunction { compiled, unit, branches, loads, bodies })
    }

    /// Bodies the value depends on, without ground.
    pub fn bodies(&self) -> &[BodyId] {
        &self.bodies
    }

    /// The value in SI.
    pub fn value(&self, state: &State) -> f64 {
        let mut values = smallvec::SmallVec::<[f64; 8]>::new();
        for (index, measure) in self.compiled.function.measures().iter().enumerate() {
            values.push(self.measured(index, measure, state, None) * self.compiled.factors[index]);
        }
        self.compiled.function.value(state.time * self.compiled.time, &values) * self.unit
    }

    /// The value in SI; its derivative replaces `gradient`.
    pub fn value_and_gradient(&self, state: &State, gradient: &mut Gradient) -> f64 {
        let measures = self.compiled.function.measures();
        let mut values = smallvec::SmallVec::<[f64; 8]>::new();
        let mut slopes = smallvec::SmallVec::<[f64; 8]>::from_elem(0.0, measures.len());
        let mut parts = smallvec::SmallVec::<[Gradient; 4]>::new();
        for (index, measure) in measures.iter().enumerate() {
            let mut part = Gradient::new();
            values.push(self.measured(index, measure, state, Some(&mut part)) * self.compiled.factors[index]);
            parts.push(part);
        }
        let time = state.time * self.compiled.time;
        let (value, _) = self.compiled.function.value_and_gradient(time, &values, &mut slopes);
        gradient.clear();
        for ((part, slope), factor) in parts.iter().zip(&slopes).zip(&self.compiled.factors) {
            gradient.add_scaled(slope * factor * self.unit, part);
        }
        value * self.unit
    }

    fn measured(
        &self,
        index: usize,
        measure: &functions::Measure,
        state: &State,
        gradient: Option<&mut Gradient>,
    ) -> f64 {
        if let Some(slot) = &self.loads[index] {
            return slot.value(measure, state, gradient);
        }
        let reference = f64::from_bits(self.branches[index].load(Relaxed));
        let value = measure::value(measure, state, reference, gradient);
        if measure::turns_over(measure) {
            self.branches[index].store(value.to_bits(), Relaxed);
        }
        value
    }
}
