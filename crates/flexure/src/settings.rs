//! What is simulated, and with which settings of the solver.

use model::{Database, ObjectId};
use solver::{IntegratorOptions, Method, StaticOptions};
use text::Diagnostic;

/// When results are recorded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outputs {
    /// That many equal steps.
    Steps(usize),
    /// Seconds between outputs.
    Interval(f64),
}

impl Outputs {
    /// Output times from `start` to `end`, both included.
    pub(crate) fn times(self, start: f64, end: f64) -> Vec<f64> {
        let steps = match self {
            Outputs::Steps(steps) => steps.max(1),
            // The last interval may be shorter; 1e-9 forgives rounding of the division.
            Outputs::Interval(interval) => (((end - start) / interval) - 1e-9).ceil().max(1.0) as usize,
        };
        let step = match self {
            Outputs::Steps(_) => (end - start) / steps as f64,
            Outputs::Interval(interval) => interval,
        };
        (0..=steps).map(|k| if k == steps { end } else { start + step * k as f64 }).collect()
    }
}

/// One analysis. Times in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Analysis {
    /// Static equilibrium at the present time.
    Static,
    Dynamic {
        end: f64,
        outputs: Outputs,
    },
    /// No degree of freedom is left.
    Kinematic {
        end: f64,
        outputs: Outputs,
    },
    /// Static equilibria over a range of time.
    QuasiStatic {
        end: f64,
        outputs: Outputs,
    },
    /// Kinematic if no degree of freedom is left, dynamic otherwise.
    Auto {
        end: f64,
        outputs: Outputs,
    },
    /// Initial conditions only.
    Assemble,
}

/// An analysis and what overrides the settings in the model.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulationOptions {
    pub analysis: Analysis,
    /// Adams name of an integrator.
    pub integrator: Option<String>,
    /// Local error tolerance.
    pub error: Option<f64>,
    /// Largest step, s.
    pub largest_step: Option<f64>,
}

impl SimulationOptions {
    pub fn new(analysis: Analysis) -> SimulationOptions {
        SimulationOptions { analysis, integrator: None, error: None, largest_step: None }
    }
}

/// Looks a setting up: first in the run's solver commands (`INTEGRATOR`, `ERROR`, ...), by unique
/// prefix of its name.
fn commanded<'a>(commands: &'a [(String, String, String)], statement: &str, argument: &str) -> Option<&'a str> {
    commands
        .iter()
        .rev()
        .find(|(s, a, _)| s.eq_ignore_ascii_case(statement) && a.eq_ignore_ascii_case(argument))
        .map(|(_, _, value)| value.as_str())
}

/// The object of a settings class below a model, if there is one.
fn settings_object(database: &Database, model: ObjectId, class: &str) -> Option<ObjectId> {
    database.below(model, class).last().copied()
}

/// Integrator settings of a run, and what the user should know about them. In order of precedence:
/// the caller's options, solver commands of the run, settings in the model, defaults.
pub(crate) fn integrator_options(
    database: &Database,
    model: ObjectId,
    options: &SimulationOptions,
    commands: &[(String, String, String)],
) -> Result<(IntegratorOptions, Vec<String>), Vec<Diagnostic>> {
    let object = settings_object(database, model, "numerical_integration_parameters");
    let real = |argument: &str, cell: &str| {
        let said = commanded(commands, "INTEGRATOR", argument).and_then(|v| v.parse().ok());
        said.or_else(|| object.and_then(|o| database.si(o, cell)))
    };
    let name = options
        .integrator
        .clone()
        .or_else(|| commanded(commands, "INTEGRATOR", "TYPE").map(ToString::to_string))
        .or_else(|| object.and_then(|o| database.text(o, "integrator_type").map(ToString::to_string)));
    let mut chosen = IntegratorOptions::default();
    let mut notes = Vec::new();
    if let Some(name) = name {
        let Some((method, note)) = Method::for_request(&name) else {
            let text = format!("`{name}` is not an integrator");
            let help = "gstiff, wstiff, si2, hastiff, hht, newmark are";
            return Err(vec![Diagnostic::error("run/unknown-integrator", text).help(help)]);
        };
        chosen.method = method;
        notes.extend(note);
    }
    if let (Method::Hht { alpha }, Some(wanted)) = (&mut chosen.method, real("ALPHA", "alpha")) {
        *alpha = wanted;
    }
    if let Method::Newmark { beta, gamma } = &mut chosen.method {
        *beta = real("BETA", "beta").unwrap_or(*beta);
        *gamma = real("GAMMA", "gamma").unwrap_or(*gamma);
    }
    chosen.error = options.error.or_else(|| real("ERROR", "error_tolerance")).unwrap_or(chosen.error);
    chosen.hmax = options.largest_step.or_else(|| real("HMAX", "hmax_time_step"));
    chosen.hmin = real("HMIN", "hmin_time_step");
    chosen.hinit = real("HINIT", "hinit_time_step");
    if let Some(most) = real("MAXIT", "maxit_corrector_iterations") {
        chosen.maxit = (most as usize).max(1);
    }
    chosen.interpolate = match commanded(commands, "INTEGRATOR", "INTERPOLATE") {
        Some(word) => word.eq_ignore_ascii_case("on"),
        None => object.and_then(|o| database.flag(o, "interpolate")).unwrap_or(false),
    };
    Ok((chosen, notes))
}

/// Settings of a static analysis: solver commands of the run before settings in the model.
pub(crate) fn static_options(
    database: &Database,
    model: ObjectId,
    commands: &[(String, String, String)],
) -> StaticOptions {
    let object = settings_object(database, model, "equilibrium_parameters");
    let real = |argument: &str, cell: &str| {
        let said = commanded(commands, "EQUILIBRIUM", argument).and_then(|v| v.parse().ok());
        said.or_else(|| object.and_then(|o| database.si(o, cell)))
    };
    let mut options = StaticOptions::default();
    if let Some(most) = real("MAXIT", "maxit") {
        options.maxit = options.maxit.max(most as usize);
    }
    // Looser tolerances than the defaults would save nothing.
    if let Some(error) = real("ERROR", "error").filter(|e| *e > 0.0) {
        options.error = options.error.min(error);
    }
    if let Some(imbalance) = real("IMBALANCE", "imbalance").filter(|i| *i > 0.0) {
        options.imbalance = options.imbalance.min(imbalance);
    }
    if let Some(stability) = real("STABILITY", "stability") {
        options.stability = stability;
    }
    options
}
