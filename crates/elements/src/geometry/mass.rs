//! What a part weighs by its shapes and its density.

use glam::{DMat3, DVec3};
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{
    geometry::{not_drawn, shape},
    place::{Cells, global_pose},
};

/// Mass, centre and inertia of a body, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// kg
    pub mass: f64,
    /// Centre of mass in part axes, from the part's origin, m.
    pub centre: DVec3,
    /// About the centre of mass, in part axes, kg m^2.
    pub inertia: DMat3,
}

impl MassProperties {
    /// The inertia about the centre in other axes; the columns of `axes` are theirs, in part axes.
    pub fn inertia_along(&self, axes: &DMat3) -> DMat3 {
        axes.transpose() * self.inertia * *axes
    }
}

/// Mass properties of a part that has shapes and a density, or a material; `None` if the part has a
/// mass of its own, no density, or no solid shape. Shapes that overlap count twice.
///
/// # Errors
/// What is wrong with the density or with single shapes.
pub fn mass_properties(database: &Database, part: ObjectId) -> Result<Option<MassProperties>, Vec<Diagnostic>> {
    if database.cell(part, "mass").is_some() {
        return Ok(None);
    }
    let Some(density) = density(database, part).map_err(|d| vec![d])? else { return Ok(None) };
    let (mut solids, mut troubles) = (Vec::new(), Vec::new());
    for id in database.below(part, "geometry") {
        match shape(database, id) {
            Some(Ok(placed)) => {
                if let Some(volume) = placed.shape.volume() {
                    // A shape may hang on a marker of another body; it is part of what it is below.
                    let pose = if placed.on.body == part {
                        placed.on.pose
                    } else {
                        global_pose(database, part)
                            .inverse()
                            .then(&global_pose(database, placed.on.body))
                            .then(&placed.on.pose)
                    };
                    solids.push((pose.origin + pose.rotation * volume.centre, pose.rotation, volume));
                }
            }
            Some(Err(trouble)) => troubles.push(trouble),
            None => troubles.extend(not_drawn(database, id).filter(|_| database.object(id).class.is("shape"))),
        }
    }
    if !troubles.is_empty() {
        return Err(troubles);
    }
    let volume: f64 = solids.iter().map(|s| s.2.volume).sum();
    if volume == 0.0 {
        return Ok(None);
    }
    let centre = solids.iter().map(|(centre, _, v)| *centre * v.volume).sum::<DVec3>() / volume;
    let inertia = solids.iter().fold(DMat3::ZERO, |sum, (own, rotation, v)| {
        let arm = *own - centre;
        let outer = DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z);
        let away = DMat3::from_diagonal(DVec3::splat(arm.length_squared())) - outer;
        sum + *rotation * v.inertia * rotation.transpose() + away * v.volume
    });
    Ok(Some(MassProperties { mass: density * volume, centre, inertia: inertia * density }))
}

/// Density of a part, kg/m^3: its own, or that of its material.
fn density(database: &Database, part: ObjectId) -> Result<Option<f64>, Diagnostic> {
    let (id, found) = match database.reference(part, "material_type") {
        Some(material) => (material, database.si(material, "density")),
        None => (part, database.si(part, "density")),
    };
    match found {
        Some(density) if density.is_finite() && density >= 0.0 => Ok(Some(density)),
        None if id == part => Ok(None),
        _ => Err(Cells { database, id }
            .trouble("material/density", "needs a finite `density` of at least zero")
            .help("give the density in units of mass per volume, as in `7801.0(kg/meter**3)`")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{place::local_pose, testing::Build};
    use model::Value;

    fn printed(database: &Database, part: ObjectId, cm: ObjectId) -> (f64, DVec3, DMat3) {
        let found = mass_properties(database, part).unwrap().unwrap();
        let axes = local_pose(database, cm).rotation;
        let units = database.units();
        let inertia = found.inertia_along(&axes) / units.factor(schema::Dimension::INERTIA);
        (found.mass / units.mass.si, found.centre / units.length.si, inertia)
    }

    /// Truth: a View export of a model with two steel links 6 and sqrt(180) inch long, 0.5 wide and 0.25
    /// deep, and the dataset written from it: MASS, CM and IP of PART/2 and PART/3, the latter in axes
    /// turned 26.6 degrees. Tolerance: half of the last printed digit, except for inertias about the
    /// turned marker, whose angles are printed with 1E-10 degrees.
    #[test]
    fn links_weigh_what_a_view_export_says() {
        let mut b = Build::new();
        let model = b.make("model", None, "model", &[]);
        let steel = b.make("material", Some(model), "steel", &[("density", Value::Number(0.2818290049))]);
        let ends = [
            (
                "PART_2",
                ([0.0, 0.0, 0.0], [0.0, 6.0, 0.0], [90.0, 0.0, 0.0]),
                ([0.0, 3.0, 0.0], [180.0, 90.0, 90.0]),
                0.2249795587,
                [0.7699990204, 0.7665580576, 0.0057844999],
            ),
            (
                "PART_3",
                ([0.0, 6.0, 0.0], [12.0, 0.0, 0.0], [333.4349488229, 0.0, 0.0]),
                ([6.0, 3.0, 0.0], [243.4349488229, 90.0000000239, 90.0000004979]),
                0.4862494147,
                [7.731451846, 7.723928542, 0.0125884023],
            ),
        ];
        for (name, (i, j, turned), (centre, cm_turned), mass, ip) in ends {
            let part = b.make("part", Some(model), name, &[("material_type", Value::Object(steel))]);
            let (i, j) = (b.marker(part, "I", i, turned), b.marker(part, "J", j, turned));
            let cm = b.marker(part, "cm", centre, cm_turned);
            let size = |x| Value::Number(x);
            b.make(
                "link",
                Some(part),
                "LINK",
                &[
                    ("i_marker", Value::Object(i)),
                    ("j_marker", Value::Object(j)),
                    ("width", size(0.5)),
                    ("depth", size(0.25)),
                ],
            );
            let found = printed(&b.database, part, cm);
            assert!((found.0 - mass).abs() < 0.5e-10, "{} is not {mass}", found.0);
            assert!(found.1.abs_diff_eq(DVec3::from_array(centre), 1e-12));
            for (k, printed) in ip.iter().enumerate() {
                let own = found.2.col(k)[k];
                assert!((own / printed - 1.0).abs() < 1e-8, "{own} is not {printed}");
            }
        }
    }
}
