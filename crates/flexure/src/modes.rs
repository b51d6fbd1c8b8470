//! Linear modes about a state, as users see them.

use equations::{Spin, System};
use glam::DVec3;
use model::{Database, ObjectId};
use schema::Dimension;
use solver::{Dae, Failure, ModeOptions, Reason, SystemState, equilibrium};
use text::Diagnostic;

use crate::run::RunObserver;
use crate::settings::static_options;
use crate::start::{evaluation, failed, prepare};

/// The state that modes are about.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ModesAbout {
    /// As modelled, or where the last analysis of the unchanged model left it.
    #[default]
    Present,
    /// The static equilibrium: a model deflected by its loads.
    Equilibrium,
    /// A steady spin of the whole model about the z axis of a marker: the bodies at rest in axes that
    /// turn with it, deflected by the centrifugal forces.
    Spin {
        /// Full name, partial path or short name of the marker.
        marker: String,
        /// rad/s, positive about +z of the marker.
        rate: f64,
    },
}

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
    about: &ModesAbout,
    lowering: elements::Options,
    observer: &mut dyn RunObserver,
) -> Result<ModesReport, Vec<Diagnostic>> {
    let mut prepared = prepare(database, model, from, lowering)?;
    prepared.messages.iter().for_each(|m| observer.message(m));
    let (system, state) = (&mut prepared.lowered.system, &mut prepared.state);
    let options = static_options(database, model, &[]);
    let found = match about {
        ModesAbout::Present => about_state(system, state)?,
        ModesAbout::Equilibrium => {
            system.set_statics(true);
            let found = equilibrium(system, state, &options, &mut Quiet);
            system.set_statics(false);
            // At rest: whatever velocities the model starts with do not belong to the equilibrium.
            state.v.fill(0.0);
            found.map_err(|f| vec![failed(&f)])?;
            about_state(system, state)?
        }
        ModesAbout::Spin { marker, rate } => {
            let mut spin = spinning(database, model, system, state, marker, *rate)?;
            state.v.fill(0.0);
            equilibrium(&mut spin, state, &options, &mut Quiet).map_err(|f| vec![failed(&f)])?;
            about_state(&mut spin, state)?
        }
    };
    let unknowns = (0..system.velocities()).map(|k| system.describe(k)).collect();
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
    Ok(ModesReport { time: state.t, modes, unknowns, diagnostics: prepared.lowered.diagnostics })
}

/// Modes about a state, with the reactions that belong to it.
fn about_state(dae: &mut dyn Dae, state: &mut SystemState) -> Result<solver::Modes, Vec<Diagnostic>> {
    at_rest(dae, state).map_err(|f| vec![failed(&f)])?;
    solver::modes(dae, state, &ModeOptions::default()).map_err(|f| vec![failed(&f)])
}

/// The accelerations and reactions that belong to a state.
pub(crate) fn at_rest(dae: &mut dyn Dae, state: &mut SystemState) -> Result<(), Failure> {
    match solver::initial::accelerations(dae, state) {
        // Parts without inertia have no acceleration of their own; without constraints nothing but
        // accelerations is missing then, and about a state of rest they are zero.
        Err(Failure { reason: Reason::Singular, .. }) if dae.constraints() == 0 => {
            state.a.fill(0.0);
            Ok(())
        }
        other => other,
    }
}

/// The system in axes that turn about a marker, if everything in it can turn along.
fn spinning<'a>(
    database: &Database,
    model: ObjectId,
    system: &'a mut System,
    state: &SystemState,
    marker: &str,
    rate: f64,
) -> Result<Spin<'a>, Vec<Diagnostic>> {
    let Some(id) = crate::attributes::resolve(database, Some(model), marker, "marker") else {
        return Err(vec![
            Diagnostic::error("modes/no-axis", format!("there is no marker `{marker}` to spin about"))
                .help("name a marker whose z axis is the axis of the spin"),
        ]);
    };
    let pose = database.global_pose(id);
    let axis = pose.rotation.z_axis;
    let gravity = system.gravity_g();
    if gravity.cross(axis).length() > 1e-9 * gravity.length() {
        return Err(vec![
            Diagnostic::error("modes/gravity-turns", "gravity is not along the axis of the spin: no motion is steady")
                .note(format!("the axis is z of `{}`", database.full_name(id)))
                .help("switch gravity off, for instance with `-e 'force attributes force_name=... active=off'`"),
        ]);
    }
    let point: DVec3 = pose.origin * database.units().factor(Dimension::LENGTH);
    let mut spin = Spin::new(system, point, axis * rate);
    let broken = spin.broken_equation(state.t, &state.q).map_err(|e| vec![evaluation(&e)])?;
    match broken {
        None => Ok(spin),
        Some((name, by)) => Err(vec![
            Diagnostic::error("modes/held", format!("`{name}` does not let the model spin at {rate} rad/s"))
                .note(format!(
                    "about z of `{}` it would be broken at a rate of {by:.4} per second",
                    database.full_name(id)
                ))
                .help("give the rate of the motion that drives the model, and the marker it turns about"),
        ]),
    }
}
