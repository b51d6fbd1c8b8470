//! A measure of the motion of a point becomes one column.

use model::ObjectId;

use crate::{
    lower::Lowering,
    output::{
        not_recorded,
        vector::{self, Markers, Vector},
    },
};

pub fn lower(lowering: &mut Lowering<'_>, measure: ObjectId) {
    let word = lowering.database.text(measure, "characteristic").unwrap_or("").to_ascii_lowercase();
    let kind = match word.as_str() {
        "translational_displacement" => Vector::Displacement,
        "translational_velocity" => Vector::Velocity,
        "translational_acceleration" => Vector::Acceleration,
        "angular_velocity" => Vector::AngularVelocity,
        "angular_acceleration" => Vector::AngularAcceleration,
        _ => {
            not_recorded::say(lowering, measure, format!("`{word}` of a point is not computed yet"));
            return;
        }
    };
    let Some(i) = lowering.frame_cell(measure, "point", "measure/no-marker") else { return };
    let k = vector::optional_frame(lowering, measure, "coordinate_rframe");
    let l = vector::optional_frame(lowering, measure, "motion_rframe");
    vector::add_measure(lowering, measure, kind, Markers { i: i.0, j: None, k, l });
}
