//! Linear modes about a state, as users see them.

use model::{Database, ObjectId};
use solver::{Dae, Failure, ModeOptions, Reason, SystemState, equilibrium};
use text::Diagnostic;

use crate::run::RunObserver;
use crate::settings::static_options;
use crate::simulate::{failed, prepare};

/// One mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// Undamped natural frequency, Hz.
    pub frequency_hz: f64,
    pub damping_ratio: f64,
    /// Parts of the eigenvalue, 1/s and rad/s.
    pub real: f64,
    pub imaginary: f64,
    /// Real and imaginary part for every unknown.
    pub shape: Vec<(f64, f64)>,
}

/// Modes, lowest frequency first.
#[derive(Clone, Debug, Default)]
pub struct ModesReport {
    /// Time of the state, s.
    pub time: f64,
    pub modes: Vec<Mode>,
    /// Names of the unknowns of the shapes.
    pub unknowns: Vec<String>,
    pub diagnostics: Vec<Diagnostic>,
}

impl ModesReport {
    /// A table in the manner of the product's: number, real and imaginary part in cycles per second.
    pub fn lines(&self) -> Vec<String> {
        let cycles = |x: f64| x / std::f64::consts::TAU;
        let mut lines = vec![
            format!("E I G E N V A L U E S  at time = {:.5E}", self.time),
            format!("{:>8} {:>20} {:>20}", "Number", "Real(cycles/second)", "Imag.(cycles/second)"),
        ];
        lines.extend(
            self.modes
                .iter()
                .enumerate()
                .map(|(index, m)| format!("{:>8} {:>20.9E} {:>20.9E}", index + 1, cycles(m.real), cycles(m.imaginary))),
        );
        lines
    }
}

struct Quiet;

impl solver::Observer for Quiet {
    fn output(&mut self, _: &mut dyn Dae, _: &SystemState) -> solver::Control {
        solver::Control::Continue
    }
}

pub(crate) fn find(
    database: &Database,
    model: ObjectId,
    from: Option<SystemState>,
    statics: bool,
    observer: &mut dyn RunObserver,
) -> Result<ModesReport, Vec<Diagnostic>> {
    let mut prepared = prepare(database, model, from, false)?;
    prepared.messages.iter().for_each(|m| observer.message(m));
    let (system, state) = (&mut prepared.lowered.system, &mut prepared.state);
    if statics {
        let options = static_options(database, model, &[]);
        system.set_statics(true);
        let found = equilibrium(system, state, &options, &mut Quiet);
        system.set_statics(false);
        // At rest: whatever velocities the model starts with do not belong to the equilibrium.
        state.v.fill(0.0);
        found.map_err(|f| vec![failed(&f)])?;
    }
    match solver::initial::accelerations(system, state) {
        // Parts without inertia have no acceleration of their own; without constraints nothing but
        // accelerations is missing then, and about a state of rest they are zero.
        Err(Failure { reason: Reason::Singular, .. }) if system.constraints() == 0 => state.a.fill(0.0),
        other => other.map_err(|f| vec![failed(&f)])?,
    }
    let found = solver::modes(system, state, &ModeOptions::default()).map_err(|f| vec![failed(&f)])?;
    let modes = found
        .modes
        .into_iter()
        .map(|m| Mode {
            frequency_hz: m.undamped_frequency(),
            damping_ratio: m.damping_ratio(),
            real: m.eigenvalue[0],
            imaginary: m.eigenvalue[1],
            shape: m.shape.into_iter().map(|[re, im]| (re, im)).collect(),
        })
        .collect();
    let unknowns = (0..system.velocities()).map(|k| system.describe(k)).collect();
    Ok(ModesReport { time: state.t, modes, unknowns, diagnostics: prepared.lowered.diagnostics })
}
