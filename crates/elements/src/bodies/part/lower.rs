//! A rigid part becomes a body: mass, centre, inertia, place and start velocity.

use equations::{Body, BodyMotion};
use glam::{DMat3, DQuat, DVec3};
use model::{Database, ObjectId, Pose};
use schema::Dimension;
use text::Diagnostic;

use crate::{bodies::start, geometry, lower::Lowering};

pub fn lower(lowering: &mut Lowering<'_>, part: ObjectId) {
    if lowering.database.flag(part, "ground_part") == Some(true) {
        lowering.add_ground(part);
        return;
    }
    if lowering.database.flag(part, "planar") == Some(true) {
        let name = lowering.name(part);
        lowering.report(
            Diagnostic::warning("part/planar", format!("part `{name}` is declared planar, which is not enforced"))
                .help("add a planar joint to ground if the part must stay in its plane"),
        );
    }
    let Some(mass) = mass_of(lowering, part) else { return };
    let pose = lowering.global_pose(part);
    let exact = start::exact_coordinates(lowering.database, part);
    let v_gb_g = start::velocity(lowering, part);
    let w_gb_g = start::angular_velocity(lowering, part);
    let body = Body {
        name: lowering.name(part),
        mass: mass.mass,
        inertia_c_b: mass.inertia_c_b,
        point_mass: false,
        initial: BodyMotion {
            r_gb_g: pose.origin + pose.rotation * mass.centre,
            q_gb: DQuat::from_mat3(&pose.rotation).normalize(),
            v_gb_g,
            w_gb_b: pose.rotation.transpose() * w_gb_g,
            a_gb_g: DVec3::ZERO,
            alpha_gb_b: DVec3::ZERO,
        },
        exact,
    };
    lowering.add_body(part, body, mass.centre);
}

/// Mass properties in part axes, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    pub mass: f64,
    /// Centre of mass from the part's origin.
    pub centre: DVec3,
    /// Inertia about the centre of mass.
    pub inertia_c_b: DMat3,
}

/// Mass properties of a part, reporting what is wrong with them.
fn mass_of(lowering: &mut Lowering<'_>, part: ObjectId) -> Option<MassProperties> {
    let database = lowering.database;
    let name = lowering.name(part);
    let factor = lowering.mass_factor();
    let found = match mass_properties(database, part) {
        Ok(found) => found,
        Err(troubles) => {
            lowering.diagnostics.extend(troubles);
            return None;
        }
    };
    if !(found.mass.is_finite() && found.centre.is_finite() && found.inertia_c_b.is_finite()) {
        lowering.report(
            Diagnostic::error("part/not-a-number", format!("a mass property of part `{name}` is not a finite number"))
                .help("give `mass`, `ixx`, `iyy`, `izz` finite values"),
        );
        return None;
    }
    let inertia = [found.inertia_c_b.x_axis.x, found.inertia_c_b.y_axis.y, found.inertia_c_b.z_axis.z];
    if found.mass < 0.0 || inertia.iter().any(|&i| i < -1e-9 * (inertia[0].abs() + inertia[1].abs() + inertia[2].abs()))
    {
        lowering.report(
            Diagnostic::error("part/negative-mass", format!("part `{name}` has a negative mass or moment of inertia"))
                .note("inertias given at an inertia marker away from the centre of mass are reduced by the mass times the square of that distance")
                .help("correct `mass`, `ixx`, `iyy`, `izz` or `inertia_marker`"),
        );
        return None;
    }
    if found.mass == 0.0 {
        lowering.report(
            Diagnostic::warning("part/no-mass", format!("part `{name}` has no mass"))
                .note("a part that can move needs a mass; without it a dynamic run fails unless joints hold the part")
                .help(format!(
                    "part modify rigid_body mass_properties part_name={name} mass=... ixx=... iyy=... izz=..."
                )),
        );
    } else if database.reference(part, "center_of_mass_marker").is_none() && database.number(part, "mass").is_some() {
        lowering.report(
            Diagnostic::warning(
                "part/no-centre-of-mass",
                format!("part `{name}` has mass but no center-of-mass marker is specified"),
            )
            .note("the centre of mass is taken at the origin of the part")
            .help("name a marker with `center_of_mass_marker = ...`")
            .adams(format!("WARNING:  Part {name} has mass but no center-of-mass marker is specified.")),
        );
    }
    Some(MassProperties { mass: found.mass * factor, inertia_c_b: found.inertia_c_b * factor, ..found })
}

/// Mass properties as the cells give them, or from the shapes of the part and their density.
pub fn mass_properties(database: &Database, part: ObjectId) -> Result<MassProperties, Vec<Diagnostic>> {
    let length = database.units().factor(Dimension::LENGTH);
    let in_part = |marker: ObjectId| {
        let pose = place_in(database, marker, part);
        Pose { origin: pose.origin * length, rotation: pose.rotation }
    };
    let centre_marker = database.reference(part, "center_of_mass_marker").map(in_part);
    if let Some(shapes) = geometry::mass_properties(database, part)? {
        return Ok(MassProperties { mass: shapes.mass, centre: shapes.centre, inertia_c_b: shapes.inertia });
    }
    let centre = centre_marker.unwrap_or(Pose::GLOBAL);
    let reference = database.reference(part, "inertia_marker").map_or(centre, in_part);
    let mass = database.si(part, "mass").unwrap_or(0.0);
    let term = |name| database.si(part, name).unwrap_or(0.0);
    let (xy, yz, zx) = (term("ixy"), term("iyz"), term("izx"));
    // Products of inertia are given as the integral of xy dm: the tensor holds their negatives.
    let tensor = DMat3::from_cols(
        DVec3::new(term("ixx"), -xy, -zx),
        DVec3::new(-xy, term("iyy"), -yz),
        DVec3::new(-zx, -yz, term("izz")),
    );
    let about_reference = reference.rotation * tensor * reference.rotation.transpose();
    let arm = reference.origin - centre.origin;
    Ok(MassProperties { mass, centre: centre.origin, inertia_c_b: about_reference - parallel_axis(mass, arm) })
}

/// What a mass adds to the inertia about a point at distance `arm` from its centre.
pub fn parallel_axis(mass: f64, arm: DVec3) -> DMat3 {
    let outer = DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z);
    (DMat3::from_diagonal(DVec3::splat(arm.length_squared())) - outer) * mass
}

/// Pose of an object in the axes of a part, model units.
fn place_in(database: &Database, object: ObjectId, part: ObjectId) -> Pose {
    if database.object(object).parent == Some(part) {
        return database.local_pose(object);
    }
    database.global_pose(part).inverse().then(&database.global_pose(object))
}
