//! From the model to equations: cells become numbers in SI, objects become bodies, frames, forces
//! and constraints. This file holds the common part; each element lowers itself in its folder.

use std::collections::{BTreeMap, HashMap};

use equations::{Body, BodyId, Constraint, Force, Frame, FrameId, GROUND, System};
use glam::{DMat3, DVec3};
use model::{Database, ObjectId, Pose};
use schema::{Dimension, UnitSystem};
use text::Diagnostic;

use crate::{
    forces::beam::Angles,
    output::{
        Outputs, everything,
        outputs::{Column, ends_of},
    },
    runtime::{self, loads::Wanted},
    shelf::{self, Stage},
};

/// What a run asks of lowering.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Record every part, joint, motion and force beside requests and measures.
    pub record_all: bool,
    /// Record what goes through every beam, its energy and power, beside requests and measures.
    pub record_beams: bool,
    /// How LINEAR and STRING beams measure the rotation of I from J.
    pub beam_angles: Angles,
    /// Let NONLINEAR beams shear by their shear ratios; without, they do not (Euler and Bernoulli).
    pub nonlinear_shear: bool,
}

/// A model ready to be solved.
pub struct Lowered {
    pub system: System,
    pub outputs: Outputs,
    /// Warnings and notes; errors are returned instead of a `Lowered`.
    pub diagnostics: Vec<Diagnostic>,
    /// Which object became which body.
    pub bodies: BTreeMap<ObjectId, BodyId>,
    /// Which object became which force or constraint.
    pub loads: BTreeMap<ObjectId, LoadId>,
}

/// Where a force or constraint of the model stands in the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadId {
    /// Index into the forces of the system.
    Force(usize),
    /// Index into the constraints of the system.
    Constraint(usize),
}

/// Turns a model into equations. All errors found are returned, not the first one.
pub fn lower(database: &Database, model: ObjectId, options: Options) -> Result<Lowered, Vec<Diagnostic>> {
    Lowering::new(database, model, options).run()
}

/// The same for a model that is looked at: nothing is recorded but what requests and measures ask for.
pub fn lower_to_look(database: &Database, model: ObjectId, options: Options) -> Result<Lowered, Vec<Diagnostic>> {
    let options = Options { record_all: false, record_beams: false, ..options };
    Lowering { only_looks: true, ..Lowering::new(database, model, options) }.run()
}

/// The work in progress: what elements see when they lower themselves.
pub struct Lowering<'a> {
    pub database: &'a Database,
    pub model: ObjectId,
    pub options: Options,
    /// Nothing is recorded beside what requests and measures ask for.
    pub(crate) only_looks: bool,
    pub diagnostics: Vec<Diagnostic>,
    pub gravity: DVec3,
    /// Active objects of the model in order of creation.
    objects: Vec<ObjectId>,
    pub(crate) bodies: Vec<Body>,
    body_of: BTreeMap<ObjectId, BodyId>,
    /// Position of the centre of mass in the axes and from the origin of the part, m.
    centres: Vec<DVec3>,
    pub(crate) frames: Vec<Frame>,
    frame_of: HashMap<ObjectId, FrameId>,
    pub(crate) forces: Vec<Box<dyn Force>>,
    pub(crate) constraints: Vec<Box<dyn Constraint>>,
    pub(crate) loads: BTreeMap<ObjectId, LoadId>,
    pub(crate) columns: Vec<Column>,
    /// Functions that act and ask for the load of an element.
    pub(crate) wanted: Vec<Wanted>,
}

impl<'a> Lowering<'a> {
    fn new(database: &'a Database, model: ObjectId, options: Options) -> Self {
        Lowering {
            database,
            model,
            options,
            only_looks: false,
            diagnostics: Vec::new(),
            gravity: DVec3::ZERO,
            objects: active_objects(database, model),
            bodies: Vec::new(),
            body_of: BTreeMap::new(),
            centres: Vec::new(),
            frames: Vec::new(),
            frame_of: HashMap::new(),
            forces: Vec::new(),
            constraints: Vec::new(),
            loads: BTreeMap::new(),
            columns: Vec::new(),
            wanted: Vec::new(),
        }
    }

    fn run(mut self) -> Result<Lowered, Vec<Diagnostic>> {
        self.check_units();
        for stage in [Stage::Body, Stage::Mechanics, Stage::Output] {
            self.lower_stage(stage);
        }
        self.report_the_rest();
        self.finish()
    }

    // ---- what elements use ----

    /// Full name of an object.
    pub fn name(&self, object: ObjectId) -> String {
        self.database.full_name(object)
    }

    pub fn units(&self) -> &'a UnitSystem {
        self.database.units()
    }

    /// Size of one model unit of a dimension in SI.
    pub fn factor(&self, dimension: Dimension) -> f64 {
        self.units().factor(dimension)
    }

    pub fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Factor on masses that makes `m a = F` hold in SI where the user set a units consistency
    /// factor that does not follow from the units.
    pub fn mass_factor(&self) -> f64 {
        mass_factor(self.units())
    }

    /// Pose of an object in the global frame, m.
    pub fn global_pose(&self, object: ObjectId) -> Pose {
        let pose = self.database.global_pose(object);
        Pose { origin: pose.origin * self.factor(Dimension::LENGTH), rotation: pose.rotation }
    }

    /// Adds a body. `centre` is its centre of mass in the axes of the part, m.
    pub fn add_body(&mut self, part: ObjectId, body: Body, centre: DVec3) {
        let id = BodyId(self.bodies.len() as u32);
        self.bodies.push(body);
        self.centres.push(centre);
        self.body_of.insert(part, id);
    }

    /// Makes a part the ground body.
    pub fn add_ground(&mut self, part: ObjectId) {
        self.body_of.insert(part, GROUND);
    }

    /// The body an object belongs to.
    pub fn body(&self, object: ObjectId) -> Option<BodyId> {
        let mut next = Some(object);
        while let Some(id) = next {
            if let Some(body) = self.body_of.get(&id) {
                return Some(*body);
            }
            next = self.database.get(id)?.parent;
        }
        None
    }

    /// The frame of a marker; reports and gives none where the marker is on no body.
    pub fn frame(&mut self, marker: ObjectId) -> Option<FrameId> {
        if let Some(frame) = self.frame_of.get(&marker) {
            return Some(*frame);
        }
        let Some(body) = self.body(marker) else {
            let name = self.name(marker);
            self.report(
                Diagnostic::error("marker/no-part", format!("marker `{name}` belongs to no part that is simulated"))
                    .help("attach the marker to an active part or to ground"),
            );
            return None;
        };
        let (r_bi_b, rot_bi) = self.place_on_body(marker, body);
        let frame = self.add_frame(Frame { name: self.name(marker), body, r_bi_b, rot_bi });
        self.frame_of.insert(marker, frame);
        Some(frame)
    }

    /// The frame that a cell of an element names; reports a missing one under `code`.
    pub fn frame_cell(&mut self, object: ObjectId, cell: &str, code: &'static str) -> Option<FrameId> {
        if let Some(marker) = self.database.reference(object, cell) {
            return self.frame(marker);
        }
        let (name, word) = (self.name(object), word_of(self.database, object));
        self.report(
            Diagnostic::error(code, format!("{word} `{name}` has no `{cell}`"))
                .help(format!("name a marker with `{cell} = ...`")),
        );
        None
    }

    pub fn body_of_frame(&self, frame: FrameId) -> BodyId {
        self.frames[frame.0 as usize].body
    }

    /// All moving bodies in order of creation, with the object each was made from.
    pub(crate) fn body_list(&self) -> Vec<(ObjectId, BodyId)> {
        self.body_of.iter().filter(|(_, body)| **body != GROUND).map(|(part, body)| (*part, *body)).collect()
    }

    /// A frame at the origin and along the axes of a part.
    pub(crate) fn origin_frame(&mut self, part: ObjectId, body: BodyId) -> FrameId {
        let r_bi_b = self.centres.get(body.0 as usize).map_or(DVec3::ZERO, |centre| -*centre);
        self.add_frame(Frame { name: self.name(part), body, r_bi_b, rot_bi: DMat3::IDENTITY })
    }

    /// A frame at the centre of mass and along the axes of a part.
    pub(crate) fn centre_frame(&mut self, part: ObjectId) -> Option<FrameId> {
        let body = self.body(part)?;
        Some(self.add_frame(Frame { name: self.name(part), body, r_bi_b: DVec3::ZERO, rot_bi: DMat3::IDENTITY }))
    }

    fn add_frame(&mut self, frame: Frame) -> FrameId {
        let id = FrameId(self.frames.len() as u32);
        self.frames.push(frame);
        id
    }

    pub fn add_force(&mut self, object: ObjectId, force: Box<dyn Force>) {
        self.loads.insert(object, LoadId::Force(self.forces.len()));
        self.forces.push(force);
    }

    pub fn add_constraint(&mut self, object: ObjectId, constraint: Box<dyn Constraint>) {
        self.loads.insert(object, LoadId::Constraint(self.constraints.len()));
        self.constraints.push(constraint);
    }

    // ---- the steps ----

    fn check_units(&mut self) {
        let (units, factor) = (self.units(), self.mass_factor());
        if let Some(set) = units.consistency_factor
            && (factor - 1.0).abs() > 1e-6
        {
            self.report(
                Diagnostic::warning(
                    "units/consistency-factor",
                    format!("the units consistency factor is set to {set}, which does not follow from the units"),
                )
                .note(format!("masses and inertias act as {factor} times what is given"))
                .help("remove `units_consistency_factor` to let it follow from the units"),
            );
        }
    }

    fn lower_stage(&mut self, stage: Stage) {
        for object in self.objects.clone() {
            let class = self.database.object(object).class;
            if let Some(element) = shelf::element(class).filter(|e| e.stage == stage) {
                (element.lower)(self, object);
            }
        }
    }

    /// Refuses, by name, what acts in the model but cannot be simulated: a run without it would look
    /// right and be wrong.
    fn report_the_rest(&mut self) {
        for object in self.objects.clone() {
            let class = self.database.object(object).class;
            if shelf::element(class).is_none() && shelf::acts(class) {
                let (name, word) = (self.name(object), word_of(self.database, object));
                self.report(
                    Diagnostic::error("element/not-simulated", format!("{word} `{name}` cannot be simulated yet"))
                        .note("it acts on the motion, so that a run without it would be another model's")
                        .help(format!(
                            "deactivate it if the run is meant to go without it: `entity attributes entity_name = {name} active = off`"
                        )),
                );
            }
        }
    }

    fn finish(mut self) -> Result<Lowered, Vec<Diagnostic>> {
        runtime::loads::connect(&mut self);
        everything::complete(&mut self);
        let ends = ends_of(&self.forces, &self.constraints);
        let outputs = Outputs::new(self.columns, &self.loads, &ends);
        if self.diagnostics.iter().any(Diagnostic::is_error) {
            return Err(self.diagnostics);
        }
        let length_unit = self.database.units().factor(Dimension::LENGTH);
        match System::new(self.bodies, self.frames, self.forces, self.constraints, self.gravity) {
            Ok(mut system) => {
                system.set_length_unit(length_unit);
                let diagnostics = self.diagnostics;
                Ok(Lowered { system, outputs, diagnostics, bodies: self.body_of, loads: self.loads })
            }
            Err(trouble) => {
                self.diagnostics.push(Diagnostic::error("model/inconsistent", trouble.message));
                Err(self.diagnostics)
            }
        }
    }

    fn place_on_body(&self, marker: ObjectId, body: BodyId) -> (DVec3, DMat3) {
        if body == GROUND {
            let pose = self.global_pose(marker);
            return (pose.origin, pose.rotation);
        }
        let mut pose = Pose::GLOBAL;
        let mut next = Some(marker);
        while let Some(id) = next.filter(|id| !self.body_of.contains_key(id)) {
            pose = self.database.local_pose(id).then(&pose);
            next = self.database.object(id).parent;
        }
        let centre = self.centres[body.0 as usize];
        (pose.origin * self.factor(Dimension::LENGTH) - centre, pose.rotation)
    }
}

/// Factor on masses for a units consistency factor set by the user: `F * UCF = m * a` in model
/// units, where the factor that follows from the units makes it the law of nature.
pub fn mass_factor(units: &UnitSystem) -> f64 {
    let natural = UnitSystem { consistency_factor: None, ..*units }.consistency_factor();
    units.consistency_factor.map_or(1.0, |set| if set > 0.0 { natural / set } else { 1.0 })
}

/// The word messages use for an object, in lower case: `beam`, `revolute joint`.
pub fn word_of(database: &Database, object: ObjectId) -> String {
    database.object(object).class.word.to_ascii_lowercase().replace('_', " ")
}

/// Objects of a model that take part in a simulation: those not deactivated and below none that is.
pub fn active_objects(database: &Database, model: ObjectId) -> Vec<ObjectId> {
    let mut found = Vec::new();
    let mut pending = vec![model];
    while let Some(id) = pending.pop() {
        if is_active(database, id) {
            found.push(id);
            pending.extend(database.object(id).children.iter());
        }
    }
    found.sort_unstable();
    found
}

/// Whether an object itself is switched on.
pub fn is_active(database: &Database, object: ObjectId) -> bool {
    match database.value(object, "active") {
        Some(model::Value::Text(word)) => !word.eq_ignore_ascii_case("off"),
        Some(model::Value::Flag(flag)) => *flag,
        _ => true,
    }
}

/// Bodies without ground and without duplicates, in the order given.
pub fn distinct_bodies(bodies: &[BodyId]) -> Vec<BodyId> {
    let mut found: Vec<BodyId> = Vec::new();
    for body in bodies {
        if *body != GROUND && !found.contains(body) {
            found.push(*body);
        }
    }
    found
}
