//! A measure of one object becomes one column.

use functions::{Component, Measure};
use model::ObjectId;
use schema::Dimension;
use text::Diagnostic;

use crate::{
    lower::Lowering,
    output::{
        outputs::Quantity,
        vector::{self, Markers, Vector},
    },
};

pub fn lower(lowering: &mut Lowering<'_>, measure: ObjectId) {
    let database = lowering.database;
    let word = database.text(measure, "characteristic").unwrap_or("").to_ascii_lowercase();
    let Some(object) = database.reference(measure, "object") else {
        let name = lowering.name(measure);
        lowering.report(
            Diagnostic::error("measure/no-object", format!("measure `{name}` has no object"))
                .help("name a part, joint or force with `object = ...`"),
        );
        return;
    };
    let known = if database.object(object).class.is("body") {
        of_body(lowering, measure, object, &word)
    } else {
        of_load(lowering, measure, object, &word)
    };
    if !known {
        let (name, of) = (lowering.name(measure), lowering.name(object));
        lowering.report(
            Diagnostic::warning("measure/characteristic", format!("measure `{name}` is not recorded"))
                .note(format!("`{word}` of `{of}` is not available yet"))
                .help("use a function measure or a request instead"),
        );
    }
}

fn of_body(lowering: &mut Lowering<'_>, measure: ObjectId, part: ObjectId, word: &str) -> bool {
    let Some(frame) = lowering.centre_frame(part) else { return false };
    let k = vector::optional_frame(lowering, measure, "coordinate_rframe");
    let l = vector::optional_frame(lowering, measure, "motion_rframe");
    let markers = Markers { i: frame.0, j: None, k, l };
    let kind = match word {
        "cm_position" => Vector::Displacement,
        "cm_velocity" => Vector::Velocity,
        "cm_acceleration" => Vector::Acceleration,
        "cm_angular_velocity" => Vector::AngularVelocity,
        "cm_angular_acceleration" => Vector::AngularAcceleration,
        "kinetic_energy" | "translational_kinetic_energy" | "angular_kinetic_energy" => {
            let Some(body) = lowering.body(part).filter(|b| *b != equations::GROUND) else { return false };
            let quantity = Quantity::KineticEnergy {
                body: body.0 as usize,
                translation: word != "angular_kinetic_energy",
                rotation: word != "translational_kinetic_energy",
            };
            let name = format!("{}.Q", lowering.database.object(measure).name);
            vector::add(lowering, name, quantity, Dimension::ENERGY);
            return true;
        }
        _ => return false,
    };
    vector::add_measure(lowering, measure, kind, markers);
    true
}

/// Force or torque of a joint, motion, beam or force, on its J marker if measured from the first,
/// else on I.
fn of_load(lowering: &mut Lowering<'_>, measure: ObjectId, element: ObjectId, word: &str) -> bool {
    let torque = match word {
        "element_force" => false,
        "element_torque" => true,
        _ => return false,
    };
    if !lowering.loads.contains_key(&element) {
        return false;
    }
    let database = lowering.database;
    let rm = vector::optional_frame(lowering, measure, "coordinate_rframe");
    let component = match database.text(measure, "component").unwrap_or("mag_component").to_ascii_lowercase().as_str() {
        "x_component" => Component::X,
        "y_component" => Component::Y,
        "z_component" => Component::Z,
        "mag_component" => Component::Magnitude,
        _ => return false,
    };
    let number = match component {
        Component::Magnitude => 1,
        Component::X => 2,
        Component::Y => 3,
        Component::Z => 4,
    };
    let j_flag = database.flag(measure, "from_first") == Some(true);
    let load = Measure::Load { element: element.0, j_flag, component: number + if torque { 4 } else { 0 }, rm };
    let dimension = if torque { Dimension::TORQUE } else { Dimension::FORCE };
    let name = format!("{}.Q", database.object(measure).name);
    vector::add(lowering, name, Quantity::Measure(load), dimension);
    true
}
