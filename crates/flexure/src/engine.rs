//! What stands between commands and solver: it keeps the observer, the runs made, and where the
//! last analysis left a model.

use std::path::{Path, PathBuf};

use commands::{OutputTimes, SimulationKind, SimulationRequest};
use dataset::Digits;
use model::{Database, ObjectId};
use solver::SystemState;
use text::Diagnostic;

use crate::beams::BeamsAt;
use crate::files;
use crate::modes::{self, ModesAbout, ModesReport};
use crate::run::{Run, RunObserver, Silent};
use crate::session::cannot_write;
use crate::settings::{Analysis, Outputs, SimulationOptions};
use crate::simulate::{self, Simulation};

/// Where the last analysis left a model.
#[derive(Clone)]
pub(crate) struct Left {
    pub model: ObjectId,
    /// Revision of the database it belongs to; a changed model starts anew.
    pub revision: u64,
    pub state: SystemState,
}

pub(crate) struct Engine {
    pub observer: Box<dyn RunObserver>,
    pub runs: Vec<Run>,
    /// Simulations that commands ask for are left out.
    pub idle: bool,
    /// Commands write no file.
    pub read_only: bool,
    /// What runs record, and how beams are taken.
    pub lowering: elements::Options,
    /// Folder of the file being read; relative paths are tried there too.
    pub folder: Option<PathBuf>,
    /// What the runs that commands asked for began with: joints that are apart, odd inertias.
    pub warnings: Vec<Diagnostic>,
    /// Runs begun so far.
    count: usize,
    left: Option<Left>,
}

impl Default for Engine {
    fn default() -> Self {
        let observer = Box::new(Silent);
        Engine {
            observer,
            runs: Vec::new(),
            idle: false,
            read_only: false,
            lowering: elements::Options::default(),
            folder: None,
            warnings: Vec::new(),
            count: 0,
            left: None,
        }
    }
}

impl Engine {
    /// Does what a simulation command asks for.
    pub fn obey(&mut self, database: &Database, request: &SimulationRequest) -> Result<(), Vec<Diagnostic>> {
        if self.idle {
            return Ok(());
        }
        let now = self.left_state(database, request.model).map_or(0.0, |left| left.state.t);
        let outputs = match request.output {
            OutputTimes::Steps(steps) => Outputs::Steps(usize::try_from(steps).unwrap_or(usize::MAX)),
            OutputTimes::Every(interval) => Outputs::Interval(interval),
        };
        let end = request.end.or(request.duration.map(|d| now + d)).unwrap_or(now + 1.0);
        let analysis = match request.kind {
            SimulationKind::Reset => {
                self.left = None;
                return Ok(());
            }
            SimulationKind::Eigen => {
                let report = self.modes(database, request.model, &ModesAbout::Present)?;
                report.lines().iter().for_each(|line| self.observer.message(line));
                return Ok(());
            }
            SimulationKind::Equilibrium => Analysis::Static,
            SimulationKind::Assemble => Analysis::Assemble,
            SimulationKind::Static => Analysis::QuasiStatic { end, outputs },
            SimulationKind::Kinematic => Analysis::Kinematic { end, outputs },
            SimulationKind::Dynamic => Analysis::Dynamic { end, outputs },
            SimulationKind::Auto => Analysis::Auto { end, outputs },
        };
        if request.initial_static && analysis != Analysis::Static {
            self.run(database, request.model, &SimulationOptions::new(Analysis::Static), &request.settings)?;
        }
        self.run(database, request.model, &SimulationOptions::new(analysis), &request.settings)?;
        Ok(())
    }

    pub fn simulate(
        &mut self,
        database: &Database,
        model: ObjectId,
        options: &SimulationOptions,
    ) -> Result<Run, Vec<Diagnostic>> {
        self.run(database, model, options, &[])?;
        // No command asked for this run; its messages say the same.
        self.warnings.clear();
        self.runs.last().cloned().ok_or_else(Vec::new)
    }

    /// Makes one run, keeps it, and keeps where it left the model.
    fn run(
        &mut self,
        database: &Database,
        model: ObjectId,
        options: &SimulationOptions,
        settings: &[(String, String, String)],
    ) -> Result<(), Vec<Diagnostic>> {
        self.count += 1;
        if self.left.as_ref().is_some_and(|left| left.model == model && left.revision != database.revision()) {
            self.observer
                .message("The model has changed since the last analysis: this one starts from the model as it is.");
            self.left = None;
        }
        let from = self.left_state(database, model).map(|left| left.state.clone());
        let simulation =
            Simulation { database, model, number: self.count, lowering: self.lowering, options, settings, from };
        let (run, state, warnings) = simulate::run(&simulation, self.observer.as_mut())?;
        self.warnings = warnings;
        self.left = Some(Left { model, revision: database.revision(), state });
        self.runs.push(run);
        Ok(())
    }

    /// A run to one state that records what goes through beams. Neither it nor where it leaves the model is
    /// kept.
    pub fn beams_run(&mut self, database: &Database, model: ObjectId, at: &BeamsAt) -> Result<Run, Vec<Diagnostic>> {
        let (lowering, left, count) = (self.lowering, self.left.clone(), self.count);
        self.lowering = elements::Options { record_all: false, record_beams: true, ..lowering };
        let analyses = match *at {
            BeamsAt::Present | BeamsAt::Table { .. } => vec![Analysis::Assemble],
            BeamsAt::Equilibrium => vec![Analysis::Static],
            BeamsAt::Time { end, statics } => {
                let dynamic = Analysis::Dynamic { end, outputs: Outputs::Steps(1) };
                if statics { vec![Analysis::Static, dynamic] } else { vec![dynamic] }
            }
        };
        let mut last = Err(Vec::new());
        for analysis in analyses {
            last = self.simulate(database, model, &SimulationOptions::new(analysis));
            if last.is_err() {
                break;
            }
            self.runs.pop();
        }
        (self.lowering, self.left, self.count) = (lowering, left, count);
        last
    }

    pub fn modes(
        &mut self,
        database: &Database,
        model: ObjectId,
        about: &ModesAbout,
    ) -> Result<ModesReport, Vec<Diagnostic>> {
        let from = self.left_state(database, model).map(|left| left.state.clone());
        let lowering = elements::Options { record_all: false, record_beams: false, ..self.lowering };
        modes::find(database, model, from, about, lowering, self.observer.as_mut())
    }

    fn left_state(&self, database: &Database, model: ObjectId) -> Option<&Left> {
        self.left.as_ref().filter(|left| left.model == model && left.revision == database.revision())
    }

    /// A path as a command gives it: as it is, or beside the file being read if it is only there.
    pub fn resolve(&self, path: &str) -> PathBuf {
        let given = PathBuf::from(path);
        match &self.folder {
            Some(folder) if given.is_relative() && !given.exists() && folder.join(&given).exists() => {
                folder.join(given)
            }
            _ => given,
        }
    }
}

/// Writes a model as a solver dataset; returns what of the model is not in it. The command of Adams
/// writes ten digits; what is to be read again as it was takes all of them.
pub(crate) fn write_data_set(
    database: &mut Database,
    model: ObjectId,
    path: &Path,
    digits: Digits,
) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let written = dataset_of(database, model, digits)?;
    files::write(path, written.text).map_err(|e| vec![cannot_write(path, &e)])?;
    Ok(written.warnings)
}

/// What of a model would not be in its solver dataset, which is not written.
pub(crate) fn data_set(database: &mut Database, model: ObjectId) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    Ok(dataset_of(database, model, Digits::View)?.warnings)
}

/// A model as a solver dataset; parts without mass of their own get that of their geometry.
fn dataset_of(database: &mut Database, model: ObjectId, digits: Digits) -> Result<dataset::Written, Vec<Diagnostic>> {
    let mass = |database: &Database, part: ObjectId| geometric_mass(database, part);
    let options = dataset::Options { mass: Some(&mass), digits };
    dataset::write(database, model, options)
}

/// Mass properties that a part gets from its shapes, in model units, about its centre-of-mass marker
/// and in that marker's axes.
fn geometric_mass(database: &Database, part: ObjectId) -> Option<dataset::Mass> {
    let properties = elements::geometry::mass_properties(database, part).ok().flatten()?;
    let centre =
        database.reference(part, "center_of_mass_marker").or_else(|| database.child(Some(part), "cm", "marker"));
    let axes = centre.map_or(glam::DMat3::IDENTITY, |marker| database.local_pose(marker).rotation);
    let inertia = properties.inertia_along(&axes);
    let units = database.units();
    let per_unit = 1.0 / units.factor(schema::Dimension::INERTIA);
    let entry = |row: usize, column: usize| inertia.col(column)[row] * per_unit;
    Some(dataset::Mass {
        mass: properties.mass / units.mass.si,
        center: centre,
        inertia_marker: None,
        // The product of inertia counts with the sign Adams gives it: the integral of xy dm.
        inertia: [entry(0, 0), entry(1, 1), entry(2, 2), -entry(0, 1), -entry(0, 2), -entry(1, 2)],
    })
}
