//! A point mass becomes a body with three translations.

use equations::{Body, BodyMotion};
use glam::{DMat3, DQuat, DVec3};
use model::ObjectId;
use schema::Dimension;
use text::Diagnostic;

use crate::{bodies::start, lower::Lowering};

pub fn lower(lowering: &mut Lowering<'_>, point_mass: ObjectId) {
    let database = lowering.database;
    let name = lowering.name(point_mass);
    let mass = database.si(point_mass, "mass").unwrap_or(0.0) * lowering.mass_factor();
    if !(mass.is_finite() && mass > 0.0) {
        lowering.report(
            Diagnostic::error("point-mass/no-mass", format!("point mass `{name}` has no positive mass"))
                .help(format!("part modify point_mass mass_properties point_mass_name={name} mass=...")),
        );
        return;
    }
    let pose = lowering.global_pose(point_mass);
    let centre = database
        .reference(point_mass, "center_of_mass_marker")
        .filter(|m| database.object(*m).parent == Some(point_mass))
        .map_or(DVec3::ZERO, |m| database.local_pose(m).origin * lowering.factor(Dimension::LENGTH));
    let body = Body {
        name,
        mass,
        inertia_c_b: DMat3::ZERO,
        point_mass: true,
        initial: BodyMotion {
            r_gb_g: pose.origin + pose.rotation * centre,
            q_gb: DQuat::from_mat3(&pose.rotation).normalize(),
            v_gb_g: start::velocity(lowering, point_mass),
            w_gb_b: DVec3::ZERO,
            a_gb_g: DVec3::ZERO,
            alpha_gb_b: DVec3::ZERO,
        },
        exact: start::exact_coordinates(database, point_mass),
    };
    lowering.add_body(point_mass, body, centre);
}
