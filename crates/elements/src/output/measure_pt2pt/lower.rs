//! A point-to-point measure becomes one column.

use model::ObjectId;

use crate::{
    lower::Lowering,
    output::vector::{self, Markers, Vector},
};

pub fn lower(lowering: &mut Lowering<'_>, measure: ObjectId) {
    let Some(i) = lowering.frame_cell(measure, "to_point", "measure/no-marker") else { return };
    let j = vector::optional_frame(lowering, measure, "from_point");
    let k = vector::optional_frame(lowering, measure, "coordinate_rframe");
    let l = vector::optional_frame(lowering, measure, "motion_rframe");
    let word = lowering.database.text(measure, "characteristic").unwrap_or("translational_displacement");
    let kind = match word.to_ascii_lowercase().as_str() {
        "translational_velocity" => Vector::Velocity,
        "translational_acceleration" => Vector::Acceleration,
        "angular_velocity" => Vector::AngularVelocity,
        "angular_acceleration" => Vector::AngularAcceleration,
        _ => Vector::Displacement,
    };
    vector::add_measure(lowering, measure, kind, Markers { i: i.0, j, k, l });
}
