//! AGGREGATE_MASS: several bodies taken as one.

use glam::{DMat3, DVec3};
use model::{ObjectId, Value, angles_of};

use super::{Arguments, Function, column, function, real};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[function(
    "AGGREGATE_MASS",
    "objects, frame, what",
    "mass, cm_pos, im_ang, inertias or all of several bodies",
    aggregate,
)];

/// One body in global axes.
struct Body {
    mass: f64,
    center: DVec3,
    /// About the centre of mass.
    inertia: DMat3,
}

/// Inertias are about the common centre of mass, along the axes of the frame; the angles of those
/// axes in the frame are therefore zero.
fn aggregate(a: &mut Arguments) -> Outcome<Value> {
    let (objects, frame, what) = (a.objects(0)?, a.frame(1)?, a.text(2)?.trim().to_ascii_lowercase());
    let mut bodies = Vec::new();
    for object in objects {
        let inside = match a.database().object(object).class.id {
            "model" => a.database().below(object, "body"),
            _ => vec![object],
        };
        for id in inside {
            bodies.extend(body(a, id)?);
        }
    }
    let mass: f64 = bodies.iter().map(|b| b.mass).sum();
    let center = if mass == 0.0 { DVec3::ZERO } else { bodies.iter().map(|b| b.mass * b.center).sum::<DVec3>() / mass };
    let inertia: DMat3 =
        bodies.iter().map(|b| b.inertia + steiner(b.mass, b.center - center)).fold(DMat3::ZERO, |sum, i| sum + i);
    let place = frame.rotation.transpose() * (center - frame.origin);
    let turned = frame.rotation.transpose() * inertia * frame.rotation;
    // Products of inertia are the integrals of xy, zx and yz; the tensor holds their negatives.
    let products = [-turned.y_axis.x, -turned.x_axis.z, -turned.z_axis.y];
    let inertias = [turned.x_axis.x, turned.y_axis.y, turned.z_axis.z].into_iter().chain(products.map(|x| x + 0.0));
    let angles = angles_of(&DMat3::IDENTITY);
    match what.as_str() {
        "mass" => real(mass),
        "cm_pos" => column(place.to_array().to_vec()),
        "im_ang" => column(angles.to_vec()),
        "inertias" => column(inertias.collect()),
        "all" => column(std::iter::once(mass).chain(place.to_array()).chain(angles).chain(inertias).collect()),
        other => Err(a.error(format!("mass, cm_pos, im_ang, inertias or all can be asked for, not \"{other}\""))),
    }
}

/// Inertia of a point mass at a place, about the origin.
fn steiner(mass: f64, r: DVec3) -> DMat3 {
    let outer = DMat3::from_cols(r * r.x, r * r.y, r * r.z);
    mass * (DMat3::IDENTITY * r.length_squared() - outer)
}

/// Nothing for ground.
fn body(a: &mut Arguments, id: ObjectId) -> Outcome<Option<Body>> {
    let class = a.database().object(id).class;
    if class.id == "ground" || a.database().object(id).name.eq_ignore_ascii_case("ground") {
        return Ok(None);
    }
    let name = a.database().full_name(id);
    if class.cell_index("mass").is_none() {
        return Err(a.error(format!("`{name}` is not a body with a mass")));
    }
    let number = |a: &mut Arguments, field: &str, needed: bool| -> Outcome<f64> {
        let set = a.database().cell(id, field).is_some();
        if !set && !needed {
            return Ok(0.0);
        }
        let value =
            a.evaluator.attribute(id, field).map_err(|_| a.error(format!("`{name}` has no {field} of its own")))?;
        value.as_number().ok_or_else(|| a.error(format!("{field} of `{name}` is not a number")))
    };
    let mass = number(a, "mass", true)?;
    let [ixx, iyy, izz, ixy, izx, iyz] = {
        let mut all = [0.0; 6];
        for (value, field) in all.iter_mut().zip(["ixx", "iyy", "izz", "ixy", "izx", "iyz"]) {
            *value = number(a, field, false)?;
        }
        all
    };
    let marker = |a: &mut Arguments, field: &str| {
        a.database().cell(id, field)?;
        a.evaluator.attribute(id, field).ok()?.as_object()
    };
    let cm = marker(a, "center_of_mass_marker");
    let im = marker(a, "inertia_marker").or(cm);
    let center = a.evaluator.pose(Some(cm.unwrap_or(id)));
    let axes = a.evaluator.pose(Some(im.unwrap_or(id)));
    let own = DMat3::from_cols_array(&[ixx, -ixy, -izx, -ixy, iyy, -iyz, -izx, -iyz, izz]);
    let about_marker = axes.rotation * own * axes.rotation.transpose();
    let inertia = about_marker - steiner(mass, center.origin - axes.origin);
    Ok(Some(Body { mass, center: center.origin, inertia }))
}
