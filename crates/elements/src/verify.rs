//! What is doubtful about a model before it is solved: findings of each element, and the report of
//! degrees of freedom in the words of Adams.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Display;

use equations::System;
use model::{Database, ObjectId};
use solver::Dae;
use text::Diagnostic;

use crate::{
    forces::beam::lower::SHEAR_IGNORED,
    lower::{Lowered, Options, active_objects, lower_to_look},
    shelf,
};

/// Something doubtful, with the command that mends it where that is certain.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    pub diagnostic: Diagnostic,
    /// Commands of the command language.
    pub fix: Option<String>,
    /// What it is about.
    pub object: Option<ObjectId>,
}

impl Finding {
    pub fn new(diagnostic: Diagnostic) -> Finding {
        Finding { diagnostic, fix: None, object: None }
    }

    #[must_use]
    pub fn fixed_by(mut self, command: impl Into<String>) -> Finding {
        self.fix = Some(command.into());
        self
    }
}

/// What verifying a model found.
pub struct Verified {
    pub findings: Vec<Finding>,
    /// The model as equations, unless it has errors.
    pub lowered: Option<Lowered>,
    /// What the report says before its verdict.
    lines: Vec<String>,
    /// Errors that the verdict names at least.
    errors: usize,
}

/// Everything doubtful about a model that is lowered with these options: what elements find in their data,
/// what lowering reports, and parts that can move without mass.
pub fn verify(database: &Database, model: ObjectId, options: Options) -> Verified {
    let mut findings = Vec::new();
    for object in active_objects(database, model) {
        if let Some(check) = shelf::element(database.object(object).class).and_then(|e| e.verify) {
            let first = findings.len();
            check(database, object, &options, &mut findings);
            findings[first..].iter_mut().for_each(|finding| finding.object = Some(object));
        }
    }
    let (lowered, reported, lines) = match lower_to_look(database, model, options) {
        Ok(mut lowered) => {
            let counts = Counts::of(&mut lowered);
            let massless = massless(&lowered, &counts);
            let lines = counts.lines(&database.full_name(model), &massless);
            let reported = lowered.diagnostics.iter().cloned().chain(massless).collect();
            (Some(lowered), reported, lines)
        }
        Err(diagnostics) => {
            let errors = diagnostics.iter().filter(|d| d.is_error());
            let lines = errors.map(|d| format!("ERROR:  {}", d.message)).collect();
            (None, diagnostics, lines)
        }
    };
    let mut known: BTreeSet<String> = findings.iter().map(|f| f.diagnostic.message.clone()).collect();
    let told = |d: &Diagnostic| d.severity != text::Severity::Note || d.code == SHEAR_IGNORED;
    let new = reported.into_iter().filter(|d| told(d) && known.insert(d.message.clone()));
    findings.extend(new.map(Finding::new));
    let mut report = vec![format!("VERIFY MODEL: {}", database.full_name(model)), String::new()];
    report.extend(lines);
    Verified { findings, errors: usize::from(lowered.is_none()), lowered, lines: report }
}

impl Verified {
    /// The report of `model verify` in Adams' words. Models that cannot be lowered give the errors, and only
    /// one whose findings hold no error is called verified.
    pub fn report(&self) -> Vec<String> {
        let mut lines = self.lines.clone();
        lines.extend([String::new(), verdict(&self.findings, self.errors)]);
        lines
    }
}

/// The command that gives cells of an object other values, in the words of its class.
pub fn modify(database: &Database, object: ObjectId, values: impl Display) -> String {
    let making = database.object(object).class.groups.iter().find(|group| group.creates);
    let (command, parameter) = making.map_or(("", ""), |group| (group.command, group.object));
    format!("{} {parameter}={} {values}", command.replacen(" create ", " modify ", 1), database.full_name(object))
}

/// Parts without mass that the constraints leave free to move.
fn massless(lowered: &Lowered, counts: &Counts) -> Vec<Diagnostic> {
    if counts.degrees_of_freedom <= 0 {
        return Vec::new();
    }
    let without = lowered.system.bodies().iter().filter(|body| body.mass == 0.0);
    without
        .map(|body| {
            let name = &body.name;
            Diagnostic::warning("part/no-mass-but-free", format!("the model can move and part `{name}` has no mass"))
                .help(format!(
                    "part modify rigid_body mass_properties part_name={name} mass=... ixx=... iyy=... izz=..."
                ))
                .adams("This model has one or more degree of freedom and there are")
                .adams("parts without mass properties. Check the following parts")
                .adams(name.clone())
        })
        .collect()
}

/// Numbers of the report.
struct Counts {
    parts: usize,
    point_masses: usize,
    /// Number of constraints of each kind.
    kinds: BTreeMap<String, usize>,
    gruebler: i64,
    degrees_of_freedom: i64,
    /// Redundant equations: constraint name, kind, words.
    redundant: Vec<(String, &'static str, String)>,
}

impl Counts {
    fn of(lowered: &mut Lowered) -> Counts {
        let system = &mut lowered.system;
        let point_masses = system.bodies().iter().filter(|b| b.point_mass).count();
        let mut kinds = BTreeMap::new();
        let mut equations = 0;
        for constraint in system.constraint_list() {
            *kinds.entry(constraint.kind().to_string()).or_insert(0) += 1;
            equations += constraint.equations() as i64;
        }
        let gruebler = system.velocities() as i64 - equations;
        let redundant = redundant(system);
        Counts {
            parts: system.bodies().len() - point_masses,
            point_masses,
            kinds,
            gruebler,
            degrees_of_freedom: gruebler + redundant.len() as i64,
            redundant,
        }
    }

    /// What the report says of a model, in Adams' words.
    fn lines(&self, name: &str, massless: &[Diagnostic]) -> Vec<String> {
        let mut lines = vec![format!("{} Gruebler Count (approximate degrees of freedom)", self.gruebler)];
        lines.push(plural(self.parts, "Moving Part", " (not including ground)"));
        if self.point_masses > 0 {
            lines.push(plural(self.point_masses, "Point Mass", ""));
        }
        // Joints first, then what drives them.
        let (motions, joints): (Vec<_>, Vec<_>) = self.kinds.iter().partition(|(kind, _)| kind.as_str() == "Motion");
        lines.extend(joints.into_iter().chain(motions).map(|(kind, count)| plural(*count, kind, "")));
        lines.push(String::new());
        lines.extend(massless.iter().flat_map(|diagnostic| diagnostic.adams_text.iter().cloned()));
        lines.push(format!("{} Degrees of Freedom for {name}", self.degrees_of_freedom));
        lines.push(String::new());
        match self.redundant.len() {
            0 => lines.push("There are no redundant constraint equations.".into()),
            1 => lines.push("There is 1 redundant constraint equation.".into()),
            n => lines.push(format!("There are {n} redundant constraint equations.")),
        }
        if !self.redundant.is_empty() {
            lines.push(String::new());
            let titles = self.redundant.iter().map(|(name, kind, words)| (format!("{name} ({kind})"), words.clone()));
            let mut table = vec![("This constraint:".to_string(), "unnecessarily removes this DOF:".to_string())];
            table.extend(titles);
            let width = table.iter().map(|(left, _)| left.chars().count()).max().unwrap_or(0) + 4;
            lines.extend(table.into_iter().map(|(left, right)| format!("{left:width$}{right}")));
        }
        lines
    }
}

/// Constraint equations that say what others say already: rows of the constraint Jacobian that are
/// combinations of rows before them, by elimination. Lengths weigh in the model's unit.
fn redundant(system: &mut System) -> Vec<(String, &'static str, String)> {
    let (q, _) = system.initial_state();
    let units = system.units().increments;
    let Ok(rows) = system.constraint_rows(0.0, &q) else { return Vec::new() };
    let mut reduced = Reduced::default();
    let mut found = Vec::new();
    for row in rows {
        let mut rest: BTreeMap<usize, f64> =
            row.entries.iter().map(|&(unknown, value)| (unknown, value * units[unknown])).collect();
        let size = rest.values().fold(0.0_f64, |m, x| m.max(x.abs()));
        reduced.take_from(&mut rest, size);
        let pivot =
            rest.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map(|(unknown, value)| (*unknown, *value));
        match pivot {
            Some((unknown, value)) if value.abs() > 1e-8 * size => {
                for x in rest.values_mut() {
                    *x /= value;
                }
                reduced.add(unknown, rest);
            }
            _ => {
                let constraint = &system.constraint_list()[row.constraint];
                let (_, words) = constraint.equation_name(row.equation);
                found.push((constraint.name().to_string(), constraint.kind(), words));
            }
        }
    }
    found
}

/// Rows already reduced, each 1 at a pivot of its own and 0 at the pivots before it.
#[derive(Default)]
struct Reduced {
    rows: Vec<BTreeMap<usize, f64>>,
    /// Which row has its pivot at an unknown.
    of_pivot: BTreeMap<usize, usize>,
}

impl Reduced {
    /// Takes multiples of the rows away until none of their pivots is left. In the order of the
    /// rows, because a row may have entries at later pivots only.
    fn take_from(&self, rest: &mut BTreeMap<usize, f64>, size: f64) {
        let next = |rest: &BTreeMap<usize, f64>| {
            rest.iter().filter_map(|(u, x)| self.of_pivot.get(u).map(|row| (*row, *u, *x))).min_by_key(|found| found.0)
        };
        while let Some((row, unknown, factor)) = next(rest) {
            for (column, value) in &self.rows[row] {
                *rest.entry(*column).or_insert(0.0) -= factor * value;
            }
            rest.remove(&unknown);
            rest.retain(|_, x| x.abs() > 1e-14 * size);
        }
    }

    fn add(&mut self, pivot: usize, row: BTreeMap<usize, f64>) {
        self.of_pivot.insert(pivot, self.rows.len());
        self.rows.push(row);
    }
}

/// The last line: Adams' own words, which knows no traps, only for a model without errors.
fn verdict(findings: &[Finding], least: usize) -> String {
    match findings.iter().filter(|f| f.diagnostic.is_error()).count().max(least) {
        0 => "Model verified successfully".into(),
        1 => "Model not verified: 1 error".into(),
        n => format!("Model not verified: {n} errors"),
    }
}

/// `1 Moving Parts`, as Adams counts; words that end in `s` get `es`.
fn plural(count: usize, word: &str, after: &str) -> String {
    let ending = if word.ends_with('s') { "es" } else { "s" };
    format!("{count} {word}{ending}{after}")
}

/// A number for a message: six significant digits, no trailing zeros.
pub fn number(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".into() } else { x.to_string() };
    }
    let magnitude = x.abs().log10().floor();
    if !(-4.0..9.0).contains(&magnitude) {
        return format!("{x:.5e}");
    }
    let digits = (5.0 - magnitude).max(0.0) as usize;
    let text = format!("{x:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}
