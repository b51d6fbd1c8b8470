//! Cells of an extrusion to its shape.

use glam::DVec3;
use model::{Database, ObjectId};
use text::Diagnostic;

use crate::{
    geometry::{Placed, profile},
    mesh::Mesh,
    place::Cells,
    shape::Shape,
};

/// The outline pushed along z of the reference marker, or along a straight path.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = cells.frame("reference_marker")?;
    let outline = profile::corners(&cells, "points_for_profile")?;
    let along = direction(&cells)?;
    let pushed = |points: &[DVec3]| points.iter().map(|p| *p + along).collect::<Vec<_>>();
    let Some(corners) = profile::closed(&outline) else {
        // A skin: it is drawn, and encloses nothing.
        let upright = outline.iter().map(|p| vec![*p, *p + along]);
        let lines = [outline.clone(), pushed(&outline)].into_iter().chain(upright).collect();
        return Ok(Placed { on, shape: Shape::Lines(lines) });
    };
    let every = (corners.len() / 8).max(1);
    let upright = corners.iter().step_by(every).map(|p| vec![*p, *p + along]);
    let lines = [outline.clone(), pushed(&outline)].into_iter().chain(upright).collect();
    let mesh = Mesh::pushed(corners, along);
    let volume = mesh.volume();
    Ok(Placed { on, shape: Shape::Solid { mesh, lines, volume } })
}

/// From the outline to its copy at the far end.
fn direction(cells: &Cells<'_>) -> Result<DVec3, Diagnostic> {
    if cells.database.value(cells.id, "path_points").is_none() {
        let unknown = ["path_curve", "profiles_loft", "centerline_loft"];
        if let Some(name) = unknown.iter().find(|name| cells.database.value(cells.id, name).is_some()) {
            return Err(profile::not_evaluated(cells, name));
        }
        return Ok(DVec3::Z * cells.not_zero("length_along_z_axis")?);
    }
    let path = profile::corners(cells, "path_points")?;
    let (first, last) = (path[0], path[path.len() - 1]);
    let along = last - first;
    let straight = path.iter().all(|p| (*p - first).cross(along).length() <= 1e-9 * along.length_squared());
    if along.length() > 0.0 && straight { Ok(along) } else { Err(profile::not_evaluated(cells, "path_points")) }
}

#[cfg(test)]
mod tests {
    use glam::DMat3;
    use model::{Array, Value};

    use crate::{geometry, testing::Build};

    fn built(cells: &[(&str, Value)], points: &[f64]) -> (Build, model::ObjectId) {
        let mut b = Build::new();
        let model = b.make("model", None, "m", &[]);
        let part = b.make("part", Some(model), "p", &[("density", Value::Number(2.0))]);
        let marker = b.marker(part, "k", [10.0, 0.0, 0.0], [0.0; 3]);
        let outline = Value::Array(Array::column(points.to_vec()));
        let mut all = vec![("reference_marker", Value::Object(marker)), ("points_for_profile", outline)];
        all.extend_from_slice(cells);
        b.make("extrusion", Some(part), "EX", &all);
        (b, part)
    }

    /// An L of area 3 with an inner corner, inch.
    const L: [f64; 21] =
        [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 2.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0];

    /// Truth: prism over an L made of two blocks 2 x 1 and 1 x 1: volume 3 L, centre at the mean of the
    /// two, inertia by the parallel axes; and the same pushed the other way. Tolerance: rounding.
    #[test]
    fn an_l_weighs_as_its_two_blocks() {
        for length in [0.5_f64, -0.5] {
            let (b, part) = built(&[("length_along_z_axis", Value::Number(length))], &L);
            let found = geometry::mass_properties(&b.database, part).unwrap().unwrap();
            let units = b.database.units();
            let (pound, inch) = (units.mass.si, units.length.si);
            let (big, small) = (2.0 * 2.0 * 0.5 * pound, 2.0 * 1.0 * 0.5 * pound);
            assert!((found.mass / (big + small) - 1.0).abs() < 1e-12);
            let centre = glam::DVec3::new(10.0 + (2.0 * 1.0 + 0.5) / 3.0, (2.0 * 0.5 + 1.5) / 3.0, length / 2.0) * inch;
            assert!(found.centre.abs_diff_eq(centre, 1e-12), "{:?}", found.centre);
            // About z: m (a^2 + b^2) / 12 of each, and the square of its distance from the centre.
            let arm = |x: f64, y: f64| (glam::DVec2::new(10.0 + x, y) * inch - centre.truncate()).length_squared();
            let zz =
                big * (5.0 / 12.0 * inch * inch + arm(1.0, 0.5)) + small * (2.0 / 12.0 * inch * inch + arm(0.5, 1.5));
            assert!((found.inertia.z_axis.z / zz - 1.0).abs() < 1e-12);
        }
    }

    /// Twin: a block with the same corner.
    #[test]
    fn a_square_outline_is_a_block_and_a_straight_path_is_a_length() {
        let square = [0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 2.0, 3.0, 0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0];
        let path = Value::Array(Array::column(vec![1.0, 1.0, 0.0, 1.0, 1.0, 2.0, 1.0, 1.0, 4.0]));
        let (b, part) = built(&[("path_points", path)], &square);
        let found = geometry::mass_properties(&b.database, part).unwrap().unwrap();
        let (mut c, other) = built(&[("length_along_z_axis", Value::Number(1.0))], &square[..9]);
        let marker = c.database.find(".m.p.k", "marker").unwrap();
        let corner = Value::Array(Array::column(vec![2.0, 3.0, 4.0]));
        c.make("block", Some(other), "B", &[("corner_marker", Value::Object(marker)), ("diag_corner_coords", corner)]);
        // The open outline beside the block weighs nothing.
        let block = geometry::mass_properties(&c.database, other).unwrap().unwrap();
        assert!((found.mass / block.mass - 1.0).abs() < 1e-12);
        assert!(found.centre.abs_diff_eq(block.centre, 1e-12));
        let scale = block.inertia.x_axis.x;
        assert!((found.inertia * (1.0 / scale)).abs_diff_eq(block.inertia * (1.0 / scale), 1e-12));
        assert_ne!(found.inertia, DMat3::ZERO);
    }

    #[test]
    fn a_path_with_a_bend_makes_the_mass_doubtful_by_name() {
        let path = Value::Array(Array::column(vec![0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 1.0, 4.0]));
        let (b, part) = built(&[("path_points", path)], &L);
        let troubles = geometry::mass_properties(&b.database, part).unwrap_err();
        assert_eq!(troubles[0].code, "geometry/not-evaluated");
        assert!(troubles[0].message.contains("`.m.p.EX`"), "{}", troubles[0].message);
    }
}
