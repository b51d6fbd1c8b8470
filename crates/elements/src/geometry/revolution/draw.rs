//! Cells of a revolution to its shape.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{
    geometry::{Placed, profile},
    mesh::Mesh,
    place::Cells,
    shape::{Shape, revolved},
};

/// The outline turned around z of the reference marker.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = cells.frame("reference_marker")?;
    let points = profile::corners(&cells, "points_for_profile")?;
    let angle = cells.angle("angle_extent", TAU)?;
    let sides = cells.sides("number_of_sides")?;
    // Distance from the axis and height.
    let outline: Vec<DVec3> = points.iter().map(|p| DVec3::new(p.x.hypot(p.y), p.z, 0.0)).collect();
    let turned = |p: &DVec3, turn: f64| DVec3::new(p.x * turn.cos(), p.x * turn.sin(), p.y);
    let copies = (0..=4).map(|k| {
        let turn = angle * f64::from(k) / 4.0;
        outline.iter().map(|p| turned(p, turn)).collect::<Vec<_>>()
    });
    let every = (outline.len() / 8).max(1);
    let rings = outline
        .iter()
        .step_by(every)
        .map(|p| (0..=sides).map(|k| turned(p, angle * k as f64 / sides as f64)).collect::<Vec<_>>());
    let lines = copies.chain(rings).collect();
    let Some(corners) = solid(&outline) else { return Ok(Placed { on, shape: Shape::Lines(lines) }) };
    let corners: Vec<DVec2> = corners.iter().map(|p| p.truncate()).collect();
    let mesh = Mesh::turned(&corners, angle, sides);
    let volume = if database.flag(id, "analytical") == Some(true) { revolved(&corners, angle) } else { mesh.volume() };
    Ok(Placed { on, shape: Shape::Solid { mesh, lines, volume } })
}

/// The corners of an outline that encloses something: it ends where it begins, or on the axis at
/// both ends.
fn solid(outline: &[DVec3]) -> Option<&[DVec3]> {
    if let Some(corners) = profile::closed(outline) {
        return Some(corners);
    }
    let size = outline.iter().map(|p| p.x).fold(0.0, f64::max);
    let on_axis = |p: Option<&DVec3>| p.is_some_and(|p| p.x <= 1e-9 * size);
    (size > 0.0 && on_axis(outline.first()) && on_axis(outline.last())).then_some(outline)
}

#[cfg(test)]
mod tests {
    use model::{Array, ObjectId, Value};

    use crate::{
        geometry::{self, MassProperties},
        testing::Build,
    };

    fn weighed(class: &str, cells: &[(&str, Value)]) -> Option<MassProperties> {
        let mut b = Build::new();
        let model = b.make("model", None, "m", &[]);
        let part: ObjectId = b.make("part", Some(model), "p", &[("density", Value::Number(2.0))]);
        let marker = b.marker(part, "k", [10.0, 0.0, 0.0], [0.0, 90.0, 0.0]);
        let centre = if class == "revolution" { "reference_marker" } else { "center_marker" };
        let mut all = vec![(centre, Value::Object(marker))];
        all.extend_from_slice(cells);
        b.make(class, Some(part), "S", &all);
        geometry::mass_properties(&b.database, part).unwrap()
    }

    fn revolution(points: &[f64], more: &[(&str, Value)]) -> Option<MassProperties> {
        let mut cells = vec![("points_for_profile", Value::Array(Array::column(points.to_vec())))];
        cells.extend_from_slice(more);
        weighed("revolution", &cells)
    }

    fn alike(a: &MassProperties, b: &MassProperties, tolerance: f64) {
        assert!((a.mass / b.mass - 1.0).abs() < tolerance, "{} is not {}", a.mass, b.mass);
        assert!(a.centre.abs_diff_eq(b.centre, tolerance * b.centre.length()));
        let size = b.inertia.x_axis.x + b.inertia.y_axis.y + b.inertia.z_axis.z;
        assert!((a.inertia * (1.0 / size)).abs_diff_eq(b.inertia * (1.0 / size), tolerance), "{a:?} is not {b:?}");
    }

    const RECTANGLE: [f64; 15] = [0.0, 0.0, 1.0, 2.0, 0.0, 1.0, 2.0, 0.0, 4.0, 0.0, 0.0, 4.0, 0.0, 0.0, 1.0];

    /// Twin: the frustum with the same sides, shifted by the height at which the outline begins.
    #[test]
    fn a_turned_rectangle_is_a_cylinder_with_as_many_sides() {
        for angle in [360.0, 120.0] {
            let angle = ("angle_extent", Value::Number(angle));
            let found = revolution(&RECTANGLE, std::slice::from_ref(&angle)).unwrap();
            let number = |x| Value::Number(x);
            let sizes = [("length", number(3.0)), ("top_radius", number(2.0)), ("bottom_radius", number(2.0)), angle];
            let mut twin = weighed("frustum", &sizes).unwrap();
            // z of the marker is -y of the part; the outline begins at a height of one inch.
            twin.centre.y -= 0.0254;
            alike(&found, &twin, 1e-12);
        }
    }

    /// Truth: a solid ring of rectangular section, 1 to 3 inch from the axis and 2 high: volume
    /// pi (9 - 1) 2, m (9 + 1)/2 about the axis, m (3 (9 + 1) + 4)/12 across. Tolerance: rounding.
    #[test]
    fn an_exact_ring_agrees_with_the_formula() {
        let ring = [1.0, 0.0, 0.0, 3.0, 0.0, 0.0, 3.0, 0.0, 2.0, 1.0, 0.0, 2.0, 1.0, 0.0, 0.0];
        let found = revolution(&ring, &[("analytical", Value::Flag(true))]).unwrap();
        let pound = 0.45359237;
        let mass = 2.0 * std::f64::consts::PI * 16.0 * pound;
        assert!((found.mass / mass - 1.0).abs() < 1e-9);
        let inch = 0.0254_f64;
        let (along, across) = (mass * 5.0 * inch * inch, mass * 34.0 / 12.0 * inch * inch);
        assert!((found.inertia.y_axis.y / along - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.inertia.x_axis.x / across - 1.0).abs() < 1e-9);
        assert!(found.centre.abs_diff_eq(glam::DVec3::new(10.0, -1.0, 0.0) * inch, 1e-12));
    }

    /// Truth: the exact solid is the limit of many sides, also for a part of a turn; with 5000 sides
    /// the polygon is within 3e-7 of the circle.
    #[test]
    fn many_sides_approach_the_exact_solid() {
        for angle in [360.0, 70.0, -200.0] {
            let angle = ("angle_extent", Value::Number(angle));
            let exact = revolution(&RECTANGLE, &[("analytical", Value::Flag(true)), angle.clone()]).unwrap();
            let faceted = revolution(&RECTANGLE, &[("number_of_sides", Value::Integer(5000)), angle]).unwrap();
            alike(&faceted, &exact, 1e-6);
        }
    }

    #[test]
    fn an_open_outline_weighs_nothing_unless_the_axis_closes_it() {
        let open = [1.0, 0.0, 0.0, 3.0, 0.0, 0.0, 3.0, 0.0, 2.0];
        assert_eq!(revolution(&open, &[]), None);
        let to_the_axis = &RECTANGLE[..12];
        alike(&revolution(to_the_axis, &[]).unwrap(), &revolution(&RECTANGLE, &[]).unwrap(), 1e-12);
    }
}
