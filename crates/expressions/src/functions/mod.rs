//! The design-time functions: one table a group, one file a group.

// All functions of the tables have one signature, those that cannot fail too.
#![allow(clippy::unnecessary_wraps)]

use std::{collections::HashMap, sync::LazyLock};

use glam::{DMat3, DVec3};
use model::{Array, Database, ObjectId, Pose, Sequence, Value, angles_of, rotation_of};
use text::Diagnostic;

use crate::{
    arithmetic,
    evaluate::{Evaluator, describe},
    names::{nearest, object_or_problem},
    scope::{Outcome, problem},
};

mod complex;
mod curves;
mod database;
mod dependents;
mod fields;
mod files;
mod interpolation;
mod linear;
mod location;
mod mass;
mod math;
mod matrix;
mod modelling;
mod orientation;
mod print_format;
mod sections;
mod strings;
mod surfaces;
mod system;
mod units;
mod unsupported;

pub(crate) use database::short_name;
pub use print_format::sprintf;

/// One function of the expression language.
pub(crate) struct Function {
    pub name: &'static str,
    /// Names of the arguments; those in brackets may be left out. The counts follow from it.
    pub arguments: &'static str,
    pub doc: &'static str,
    pub least: usize,
    pub most: usize,
    /// The value belongs to the moment (a file, the clock, a free name): it is never kept as an
    /// expression.
    pub momentary: bool,
    /// The value follows from which objects there are, not only from the cells read.
    pub searches: bool,
    pub run: Run,
}

type Run = fn(&mut Arguments) -> Outcome<Value>;

const fn function(name: &'static str, arguments: &'static str, doc: &'static str, run: Run) -> Function {
    let (least, most) = counts(arguments);
    Function { name, arguments, doc, least, most, momentary: false, searches: false, run }
}

const fn momentary(name: &'static str, arguments: &'static str, doc: &'static str, run: Run) -> Function {
    Function { momentary: true, ..function(name, arguments, doc, run) }
}

const fn searching(name: &'static str, arguments: &'static str, doc: &'static str, run: Run) -> Function {
    Function { searches: true, ..function(name, arguments, doc, run) }
}

/// Least and largest number of arguments of a list such as `x, y, [method]`.
const fn counts(arguments: &str) -> (usize, usize) {
    let bytes = arguments.as_bytes();
    if bytes.is_empty() {
        return (0, 0);
    }
    let (mut i, mut all, mut optional) = (0, 1, 0);
    while i < bytes.len() {
        match bytes[i] {
            b',' => all += 1,
            b'[' => optional += 1,
            _ => {}
        }
        i += 1;
    }
    (all - optional, all)
}

/// EVAL is resolved when an expression is bound; inside a kept tree it is its argument.
pub(crate) const EVAL: Function =
    function("EVAL", "expression", "the present value; nothing is kept of the expression", |a| Ok(a.values[0].clone()));

const GROUPS: &[(&str, &[Function])] = &[
    ("location", location::TABLE),
    ("orientation", orientation::TABLE),
    ("modelling", modelling::TABLE),
    ("modelling", mass::TABLE),
    ("section", sections::TABLE),
    ("math", math::TABLE),
    ("matrix", matrix::TABLE),
    ("matrix", linear::TABLE),
    ("interpolation", interpolation::TABLE),
    ("interpolation", curves::TABLE),
    ("interpolation", surfaces::TABLE),
    ("string", strings::TABLE),
    ("database", database::TABLE),
    ("database", dependents::TABLE),
    ("database", fields::TABLE),
    ("units", units::TABLE),
    ("file", files::TABLE),
    ("system", system::TABLE),
];

/// What one design-time function is called and takes, for completion, help and the manual.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionInfo {
    /// In capitals, as exports write it.
    pub name: &'static str,
    /// `location`, `math`, `string`, ...
    pub group: &'static str,
    /// Names of the arguments: `x, y, [method]`; those in brackets may be left out.
    pub arguments: &'static str,
    /// Least number of arguments.
    pub least: usize,
    /// Largest number of arguments.
    pub most: usize,
    /// What it gives, in one line.
    pub doc: &'static str,
    /// The value belongs to the moment; such a call is never kept as an expression.
    pub momentary: bool,
}

/// All design-time functions, group by group.
pub fn functions() -> impl Iterator<Item = FunctionInfo> {
    GROUPS.iter().flat_map(|(group, table)| {
        table.iter().map(|f| {
            let Function { name, arguments, doc, least, most, momentary, .. } = *f;
            FunctionInfo { name, group, arguments, least, most, doc, momentary }
        })
    })
}

/// Names of Adams' functions that are known and refused by name.
pub fn refused_functions() -> &'static [&'static str] {
    unsupported::NAMES
}

static BY_NAME: LazyLock<HashMap<&str, &Function>> =
    LazyLock::new(|| GROUPS.iter().flat_map(|(_, table)| *table).map(|f| (f.name, f)).collect());

/// The function of a name, ignoring case.
pub(crate) fn find(name: &str) -> Option<&'static Function> {
    BY_NAME.get(name.to_ascii_uppercase().as_str()).copied()
}

/// Whether Adams has a function of this name that Flexure does not.
pub(crate) fn is_unsupported(name: &str) -> bool {
    unsupported::NAMES.iter().any(|n| n.eq_ignore_ascii_case(name))
}

/// Whether a name means the object that holds the session's defaults.
pub(crate) fn is_defaults(name: &str) -> bool {
    let name = name.strip_prefix('.').unwrap_or(name);
    name.eq_ignore_ascii_case("system_defaults") || name.eq_ignore_ascii_case("system.defaults")
}

pub(crate) fn not_a_function(name: &str) -> Box<Diagnostic> {
    let upper = name.to_ascii_uppercase();
    if is_unsupported(name) {
        return Box::new(
            Diagnostic::error(
                "expression/function-not-supported",
                format!("the function {upper} is not supported yet"),
            )
            .note("the value that depends on it is not set"),
        );
    }
    let mut diagnostic = Diagnostic::error(
        "expression/unknown-function",
        format!("`{name}` is not a known constant, function or variable"),
    )
    .adams(format!("\"{name}\" is not a known constant, function or variable"));
    let mut names: Vec<&str> = BY_NAME.keys().copied().collect();
    names.sort_unstable();
    if let Some(near) = nearest(&upper, names.into_iter()) {
        diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
    }
    Box::new(diagnostic)
}

pub(crate) fn wrong_count(function: &Function, found: usize) -> Box<Diagnostic> {
    let Function { name, least, most, .. } = *function;
    let wanted = if found < least { least } else { most };
    let range = match (least, most) {
        _ if least == most => format!("{least} argument{}", if least == 1 { "" } else { "s" }),
        (_, usize::MAX) => format!("{least} or more arguments"),
        _ => format!("{least} to {most} arguments"),
    };
    Box::new(
        Diagnostic::error("expression/wrong-argument-count", format!("{name} expects {range}, found {found}"))
            .adams(format!("The function {name} expects {wanted} arguments, found {found}")),
    )
}

/// The arguments of one call. The count has been checked.
pub(crate) struct Arguments<'c, 'e> {
    pub name: &'static str,
    pub values: &'c [Value],
    pub evaluator: &'c mut Evaluator<'e>,
}

impl Arguments<'_, '_> {
    pub fn database(&self) -> &Database {
        self.evaluator.scope.database
    }

    /// Size of the current angle unit in radians.
    pub fn angle_unit(&self) -> f64 {
        self.database().units().angle.si
    }

    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Names the argument in an error.
    fn wrong(&self, i: usize, wanted: &str) -> Box<Diagnostic> {
        let found = self.values.get(i).map_or_else(|| "nothing".to_string(), describe);
        problem(
            "expression/wrong-argument",
            format!("argument {} of {} must be {wanted}, not {found}", i + 1, self.name),
        )
    }

    /// An error about these arguments.
    pub fn error(&self, text: impl std::fmt::Display) -> Box<Diagnostic> {
        problem("expression/wrong-argument", format!("{}: {text}", self.name))
    }

    fn value(&self, i: usize) -> Outcome<&Value> {
        self.values.get(i).ok_or_else(|| self.wrong(i, "given"))
    }

    pub fn number(&self, i: usize) -> Outcome<f64> {
        self.value(i)?.as_number().ok_or_else(|| self.wrong(i, "a number"))
    }

    pub fn integer(&self, i: usize) -> Outcome<i64> {
        let x = self.number(i)?;
        if x.fract() == 0.0 && x.abs() < 9.0e15 { Ok(x as i64) } else { Err(self.wrong(i, "an integer")) }
    }

    /// A count that memory can hold.
    pub fn count(&self, i: usize) -> Outcome<usize> {
        let n = self.integer(i)?;
        if (0..=10_000_000).contains(&n) { Ok(n as usize) } else { Err(self.wrong(i, "a count from 0 to 10000000")) }
    }

    pub fn text(&self, i: usize) -> Outcome<String> {
        match self.value(i)? {
            Value::Array(_) | Value::Nothing => Err(self.wrong(i, "a text")),
            other => arithmetic::text_of(other, &self.evaluator.scope).map_err(|_| self.wrong(i, "a text")),
        }
    }

    pub fn texts(&self, i: usize) -> Outcome<Vec<String>> {
        match self.value(i)? {
            Value::Texts(list) => Ok(list.clone()),
            Value::Array(a) => Ok(a.values.iter().map(|x| crate::print::number_text(*x)).collect()),
            Value::Objects(list) => Ok(list.iter().map(|o| self.database().full_name(*o)).collect()),
            _ => Ok(vec![self.text(i)?]),
        }
    }

    pub fn array(&self, i: usize) -> Outcome<Array> {
        match self.value(i)? {
            Value::Array(array) => Ok(array.clone()),
            other => other.as_number().map(|x| Array::column(vec![x])).ok_or_else(|| self.wrong(i, "an array")),
        }
    }

    pub fn numbers(&self, i: usize) -> Outcome<Vec<f64>> {
        Ok(self.array(i)?.values)
    }

    /// Three numbers.
    pub fn vector(&self, i: usize) -> Outcome<DVec3> {
        match self.numbers(i)?.as_slice() {
            [x, y, z] => Ok(DVec3::new(*x, *y, *z)),
            _ => Err(self.wrong(i, "three numbers")),
        }
    }

    /// Points in the columns of a matrix of three rows.
    pub fn points<const N: usize>(&self, i: usize) -> Outcome<[DVec3; N]> {
        let array = self.array(i)?;
        if array.rows != 3 || array.columns != N {
            return Err(self.wrong(i, &format!("a 3 x {N} matrix, one point a column")));
        }
        let points: Vec<DVec3> = array.values.chunks_exact(3).map(DVec3::from_slice).collect();
        points.try_into().map_err(|_| self.wrong(i, "points"))
    }

    /// Rotation of three body 3-1-3 angles in the current angle unit.
    pub fn rotation(&self, i: usize) -> Outcome<DMat3> {
        let angles = self.vector(i).map_err(|_| self.wrong(i, "three angles"))?;
        Ok(rotation_of(Sequence::BODY_313, (angles * self.angle_unit()).to_array()))
    }

    pub fn object(&self, i: usize) -> Outcome<ObjectId> {
        object_or_problem(self.value(i)?, &self.evaluator.scope)
    }

    pub fn objects(&self, i: usize) -> Outcome<Vec<ObjectId>> {
        match self.value(i)? {
            Value::Objects(list) => Ok(list.clone()),
            Value::Nothing => Ok(Vec::new()),
            Value::Array(a) if a.values.is_empty() => Ok(Vec::new()),
            Value::Texts(list) => {
                list.iter().map(|t| object_or_problem(&Value::Text(t.clone()), &self.evaluator.scope)).collect()
            }
            _ => Ok(vec![self.object(i)?]),
        }
    }

    /// Global pose of a frame; 0 and (none) mean the global frame itself.
    pub fn frame(&mut self, i: usize) -> Outcome<Pose> {
        let frame = self.frame_object(i)?;
        Ok(self.evaluator.pose(frame))
    }

    /// Global origin of a frame, for functions that do not care how it is turned.
    pub fn origin(&mut self, i: usize) -> Outcome<DVec3> {
        let frame = self.frame_object(i)?;
        Ok(self.evaluator.origin(frame))
    }

    /// Global rotation of a frame, for functions that do not care where it is.
    pub fn turn(&mut self, i: usize) -> Outcome<DMat3> {
        let frame = self.frame_object(i)?;
        Ok(self.evaluator.turn(frame))
    }

    fn frame_object(&self, i: usize) -> Outcome<Option<ObjectId>> {
        let value = self.value(i)?;
        if *value == Value::Nothing || value.as_number() == Some(0.0) {
            return Ok(None);
        }
        self.object(i).map(Some)
    }

    /// Global pose of the frame in which the expression's owner is stored.
    pub fn owner_frame(&mut self) -> Pose {
        let frame = self.evaluator.scope.owner_frame();
        self.evaluator.pose(frame)
    }

    /// How the frame is turned in which the expression's owner is stored.
    pub fn owner_turn(&mut self) -> DMat3 {
        let frame = self.evaluator.scope.owner_frame();
        self.evaluator.turn(frame)
    }

    /// One of the axes x, y, z as 0, 1, 2.
    pub fn axis(&self, i: usize) -> Outcome<usize> {
        let text = self.text(i)?;
        axis_of(text.trim()).ok_or_else(|| self.wrong(i, "\"x\", \"y\" or \"z\""))
    }

    /// Two different axes: `xy`, `zx`, ...
    pub fn two_axes(&self, i: usize) -> Outcome<(usize, usize)> {
        let text = self.text(i)?;
        let mut letters = text.trim().chars().map(|c| axis_of(c.encode_utf8(&mut [0; 4])));
        match (letters.next(), letters.next(), letters.next()) {
            (Some(Some(a)), Some(Some(b)), None) if a != b => Ok((a, b)),
            _ => Err(self.wrong(i, "one of \"xy\", \"yz\", \"zx\", \"yx\", \"zy\", \"xz\"")),
        }
    }
}

fn axis_of(letter: &str) -> Option<usize> {
    match letter {
        "x" | "X" => Some(0),
        "y" | "Y" => Some(1),
        "z" | "Z" => Some(2),
        _ => None,
    }
}

/// A location as a value.
fn location(point: DVec3) -> Outcome<Value> {
    Ok(Value::Array(Array::column(point.to_array().to_vec())))
}

/// A rotation as body 3-1-3 angles in the current angle unit.
fn orientation(rotation: &DMat3, arguments: &Arguments) -> Outcome<Value> {
    let unit = arguments.angle_unit();
    Ok(Value::Array(Array::column(angles_of(rotation).iter().map(|a| a / unit).collect())))
}

fn real(x: f64) -> Outcome<Value> {
    Ok(Value::Number(x))
}

fn column(values: Vec<f64>) -> Outcome<Value> {
    Ok(Value::Array(Array::column(values)))
}
