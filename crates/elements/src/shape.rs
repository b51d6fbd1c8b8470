//! Neutral shapes: what geometry looks like, in its own axes, without names or units of the model.
//! Views draw them; mass properties follow from them. Lengths in metre, angles in radians.

use std::f64::consts::TAU;

use glam::{DMat3, DVec2, DVec3};

use crate::mesh::Mesh;

/// A shape in its own axes.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Open or closed lines; a closed one repeats its first point.
    Lines(Vec<Vec<DVec3>>),
    /// Prism or cut pyramid along z from 0 to `length`, its polygons inscribed in circles: what a
    /// cylinder or a frustum is made of. `angle` is swept from x towards y.
    Frustum { bottom: f64, top: f64, length: f64, angle: f64, sides: usize },
    /// From the origin to a corner.
    Block { corner: DVec3 },
    /// Half axes.
    Ellipsoid { half: DVec3 },
    /// A tube around a circle about z.
    Torus { major: f64, minor: f64, angle: f64 },
    /// A closed outline in the xy plane, thickness along z to both sides.
    Plate { outline: Vec<DVec2>, thickness: f64 },
    /// A closed surface with the lines it is drawn with and what it weighs.
    Solid { mesh: Mesh, lines: Vec<Vec<DVec3>>, volume: Volume },
}

/// What a shape of density one weighs: metre to the third and fifth power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volume {
    pub volume: f64,
    pub centre: DVec3,
    /// About the centre, in the axes of the shape.
    pub inertia: DMat3,
}

impl Shape {
    /// Volume, centre and inertia; `None` for lines.
    ///
    /// Polygons count as drawn: a cylinder with 20 sides weighs as much as the prism. Ellipsoid and
    /// torus are exact.
    pub fn volume(&self) -> Option<Volume> {
        match *self {
            Shape::Lines(_) => None,
            Shape::Ellipsoid { half } => {
                let volume = 2.0 / 3.0 * TAU * half.x * half.y * half.z;
                Some(Volume { volume, centre: DVec3::ZERO, inertia: inertia_of(half * half * (volume / 5.0)) })
            }
            Shape::Torus { major, minor, angle } => Some(torus(major, minor, angle)),
            Shape::Solid { volume, .. } => Some(volume),
            _ => self.mesh().map(|m| m.volume()),
        }
    }

    /// The surface as triangles; `None` for lines. Round shapes are approximated.
    pub fn mesh(&self) -> Option<Mesh> {
        match *self {
            Shape::Lines(_) => None,
            Shape::Solid { ref mesh, .. } => Some(mesh.clone()),
            Shape::Frustum { bottom, top, length, angle, sides } => {
                Some(Mesh::frustum(bottom, top, length, angle, sides))
            }
            Shape::Block { corner } => {
                let outline = [DVec2::ZERO, DVec2::new(corner.x, 0.0), corner.truncate(), DVec2::new(0.0, corner.y)];
                Some(Mesh::prism(&outline, 0.0, corner.z))
            }
            Shape::Plate { ref outline, thickness } => Some(Mesh::prism(outline, -thickness / 2.0, thickness / 2.0)),
            Shape::Ellipsoid { half } => Some(Mesh::grid(24, 12, |u, v| {
                let (a, b) = (u * TAU, (v - 0.5) * TAU / 2.0);
                half * DVec3::new(b.cos() * a.cos(), b.cos() * a.sin(), b.sin())
            })),
            Shape::Torus { major, minor, angle } => {
                Some(Mesh::grid(24, 16, |u, v| on_torus(major, minor, u * angle, v * TAU)))
            }
        }
    }

    /// The lines of a wire picture.
    pub fn lines(&self) -> Vec<Vec<DVec3>> {
        match *self {
            Shape::Lines(ref lines) | Shape::Solid { ref lines, .. } => lines.clone(),
            Shape::Frustum { bottom, top, length, angle, sides } => frustum_lines(bottom, top, length, angle, sides),
            Shape::Block { corner } => {
                let outline = [DVec2::ZERO, DVec2::new(corner.x, 0.0), corner.truncate(), DVec2::new(0.0, corner.y)];
                prism_lines(&outline, 0.0, corner.z, 1)
            }
            Shape::Plate { ref outline, thickness } => {
                prism_lines(outline, -thickness / 2.0, thickness / 2.0, (outline.len() / 4).max(1))
            }
            Shape::Ellipsoid { half } => {
                let ring = |f: fn(f64, f64) -> DVec3| {
                    (0..=36)
                        .map(|k| half * f((f64::from(k) / 36.0 * TAU).cos(), (f64::from(k) / 36.0 * TAU).sin()))
                        .collect()
                };
                vec![
                    ring(|c, s| DVec3::new(c, s, 0.0)),
                    ring(|c, s| DVec3::new(c, 0.0, s)),
                    ring(|c, s| DVec3::new(0.0, c, s)),
                ]
            }
            Shape::Torus { major, minor, angle } => {
                let along = |v: f64| (0..=36).map(|k| on_torus(major, minor, f64::from(k) / 36.0 * angle, v)).collect();
                let around = |u: f64| (0..=24).map(|k| on_torus(major, minor, u, f64::from(k) / 24.0 * TAU)).collect();
                let rings = (0..4).map(|k| along(f64::from(k) / 4.0 * TAU));
                rings.chain((0..=8).map(|k| around(f64::from(k) / 8.0 * angle))).collect()
            }
        }
    }
}

/// Inertia of the second moments of volume about three axes of symmetry.
fn inertia_of(moments: DVec3) -> DMat3 {
    DMat3::from_diagonal(DVec3::new(moments.y + moments.z, moments.z + moments.x, moments.x + moments.y))
}

fn on_torus(major: f64, minor: f64, u: f64, v: f64) -> DVec3 {
    let radius = major + minor * v.cos();
    DVec3::new(radius * u.cos(), radius * u.sin(), minor * v.sin())
}

/// Integrals over a plane section: of r dA, r^2 dA, r^3 dA, r z dA, r z^2 dA and r^2 z dA, where r is
/// the distance from the axis and z the height.
struct Section {
    r: f64,
    r2: f64,
    r3: f64,
    rz: f64,
    rz2: f64,
    r2z: f64,
}

impl Section {
    /// What the section sweeps over when it turns about z, from x towards y: Pappus' rule, and the
    /// same integrals for the second moments.
    fn turned(&self, angle: f64) -> Volume {
        let (angle, sign) = (angle.abs(), angle.signum());
        let volume = angle * self.r;
        let (sine, cosine) = angle.sin_cos();
        let centre = DVec3::new(self.r2 * sine, sign * self.r2 * (1.0 - cosine), angle * self.rz) / volume;
        let xx = self.r3 * (angle / 2.0 + sine * cosine / 2.0);
        let yy = self.r3 * (angle / 2.0 - sine * cosine / 2.0);
        let zz = angle * self.rz2;
        let (xy, xz) = (sign * self.r3 * sine * sine / 2.0, self.r2z * sine);
        let yz = sign * self.r2z * (1.0 - cosine);
        let moments = DMat3::from_cols(DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz));
        let own = DMat3::from_cols(centre * centre.x, centre * centre.y, centre * centre.z) * volume;
        let about = moments - own;
        let trace = about.x_axis.x + about.y_axis.y + about.z_axis.z;
        Volume { volume, centre, inertia: DMat3::from_diagonal(DVec3::splat(trace)) - about }
    }
}

/// A part of a torus, swept from x towards y.
fn torus(major: f64, minor: f64, angle: f64) -> Volume {
    let disc = TAU / 2.0 * minor * minor;
    // Over the disc: r -> R, r^2 -> R^2 + a^2/4, r^3 -> R^3 + 3/4 R a^2, and r z^2 -> R a^2/4.
    let section = Section {
        r: disc * major,
        r2: disc * (major * major + minor * minor / 4.0),
        r3: disc * major * (major * major + 0.75 * minor * minor),
        rz: 0.0,
        rz2: disc * major * minor * minor / 4.0,
        r2z: 0.0,
    };
    section.turned(angle)
}

/// What a polygon of distances from z and heights sweeps over when it turns about z.
pub(crate) fn revolved(corners: &[DVec2], angle: f64) -> Volume {
    // Four points and their weights integrate polynomials of the third degree over a triangle.
    const RULE: [([f64; 3], f64); 4] = [
        ([1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0], -27.0 / 48.0),
        ([0.6, 0.2, 0.2], 25.0 / 48.0),
        ([0.2, 0.6, 0.2], 25.0 / 48.0),
        ([0.2, 0.2, 0.6], 25.0 / 48.0),
    ];
    let mut sums = [0.0; 6];
    for pair in corners.windows(2).skip(1) {
        let (a, b, c) = (corners[0], pair[0], pair[1]);
        let area = (b - a).perp_dot(c - a) / 2.0;
        for (share, weight) in RULE {
            let p = a * share[0] + b * share[1] + c * share[2];
            let w = area * weight;
            let (r, z) = (p.x, p.y);
            for (sum, value) in sums.iter_mut().zip([r, r * r, r * r * r, r * z, r * z * z, r * r * z]) {
                *sum += w * value;
            }
        }
    }
    // The outline may go around either way.
    let [r, r2, r3, rz, rz2, r2z] = if sums[0] < 0.0 { sums.map(|x| -x) } else { sums };
    if r == 0.0 {
        return Volume { volume: 0.0, centre: DVec3::ZERO, inertia: DMat3::ZERO };
    }
    Section { r, r2, r3, rz, rz2, r2z }.turned(angle)
}

fn prism_lines(outline: &[DVec2], low: f64, high: f64, every: usize) -> Vec<Vec<DVec3>> {
    let ring = |z: f64| outline.iter().chain(outline.first()).map(|p| p.extend(z)).collect::<Vec<_>>();
    let upright = outline.iter().step_by(every).map(|p| vec![p.extend(low), p.extend(high)]);
    [ring(low), ring(high)].into_iter().chain(upright).collect()
}

fn frustum_lines(bottom: f64, top: f64, length: f64, angle: f64, sides: usize) -> Vec<Vec<DVec3>> {
    let at = |k: usize, radius: f64, z: f64| {
        let turn = angle * k as f64 / sides as f64;
        DVec3::new(radius * turn.cos(), radius * turn.sin(), z)
    };
    let whole = angle.abs() >= TAU * (1.0 - 1e-9);
    let ring = |radius: f64, z: f64| {
        let mut points: Vec<_> = (0..=sides).map(|k| at(k, radius, z)).collect();
        if !whole {
            points.push(DVec3::new(0.0, 0.0, z));
            points.push(at(0, radius, z));
        }
        points
    };
    let upright = (0..=sides).step_by((sides / 4).max(1)).map(|k| vec![at(k, bottom, 0.0), at(k, top, length)]);
    [ring(bottom, 0.0), ring(top, length)].into_iter().chain(upright).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: DMat3, b: DMat3, tolerance: f64) {
        assert!(a.abs_diff_eq(b, tolerance), "{a:?} is not {b:?}");
    }

    /// Truth: a x b x c block, m/12 (b^2 + c^2) about x. Tolerance: rounding of sums of 1e-1.
    #[test]
    fn a_block_has_the_inertia_of_the_formula() {
        for corner in [DVec3::new(2.0, 3.0, 4.0), DVec3::new(-2.0, 3.0, -4.0)] {
            let v = Shape::Block { corner }.volume().unwrap();
            assert!((v.volume - 24.0).abs() < 1e-12);
            assert!(v.centre.abs_diff_eq(corner / 2.0, 1e-12));
            close(v.inertia, DMat3::from_diagonal(DVec3::new(50.0, 40.0, 26.0)), 1e-11);
        }
    }

    /// Truth: solid cylinder r, L: m r^2/2 about the axis, m (3 r^2 + L^2)/12 across. With 5000 sides
    /// the polygon is within 3e-7 of the circle.
    #[test]
    fn a_cylinder_of_many_sides_is_round() {
        let (r, l) = (0.3, 2.0);
        let v = Shape::Frustum { bottom: r, top: r, length: l, angle: TAU, sides: 5000 }.volume().unwrap();
        let m = TAU / 2.0 * r * r * l;
        assert!((v.volume / m - 1.0).abs() < 1e-6);
        assert!(v.centre.abs_diff_eq(DVec3::new(0.0, 0.0, 1.0), 1e-12));
        let across = m * (3.0 * r * r + l * l) / 12.0;
        close(v.inertia, DMat3::from_diagonal(DVec3::new(across, across, m * r * r / 2.0)), 1e-6);
    }

    /// Truth: cone of height h: volume pi r^2 h/3, centre at h/4, 3/10 m r^2 about the axis and
    /// 3/20 m r^2 + 3/80 m h^2 across, about the centre. Half a turn has half the mass and its
    /// centre at r/pi from the axis.
    #[test]
    fn a_cone_and_its_half_agree_with_the_formulas() {
        let (r, h) = (0.5, 1.2);
        let cone = Shape::Frustum { bottom: r, top: 0.0, length: h, angle: TAU, sides: 5000 }.volume().unwrap();
        let m = TAU / 6.0 * r * r * h;
        assert!((cone.volume / m - 1.0).abs() < 1e-6);
        assert!(cone.centre.abs_diff_eq(DVec3::new(0.0, 0.0, h / 4.0), 1e-12));
        let across = 0.15 * m * r * r + 3.0 / 80.0 * m * h * h;
        close(cone.inertia, DMat3::from_diagonal(DVec3::new(across, across, 0.3 * m * r * r)), 1e-6);
        let half = Shape::Frustum { bottom: r, top: 0.0, length: h, angle: TAU / 2.0, sides: 5000 }.volume().unwrap();
        assert!((half.volume / m - 0.5).abs() < 1e-6);
        assert!(half.centre.abs_diff_eq(DVec3::new(0.0, 2.0 * r / TAU, h / 4.0), 1e-6));
    }

    /// Truth: a View export of a cylinder with 4 sides, length 0.6, radius 0.07 and density 0.1 gives
    /// MASS = 5.88E-04 and IP = 1.81202E-05, 1.81202E-05, 9.604E-07: the square prism, not the
    /// cylinder. Tolerance: the printed digits.
    #[test]
    fn a_cylinder_weighs_as_much_as_its_facets() {
        let v = Shape::Frustum { bottom: 0.07, top: 0.07, length: 0.6, angle: TAU, sides: 4 }.volume().unwrap();
        assert!((0.1 * v.volume - 5.88e-4).abs() < 1e-15);
        let printed = DMat3::from_diagonal(DVec3::new(1.81202e-5, 1.81202e-5, 9.604e-7));
        close(0.1 * v.inertia, printed, 1e-15);
    }

    /// Truth: a View export of an ellipsoid of three diameters 1 and density 4.38E-07 gives
    /// MASS = 2.293362637E-07 and three IP of 2.293362637E-08: the exact sphere.
    #[test]
    fn an_ellipsoid_is_exact() {
        let v = Shape::Ellipsoid { half: DVec3::splat(0.5) }.volume().unwrap();
        assert!((4.38e-7 * v.volume - 2.293362637e-7).abs() < 5e-17);
        close(4.38e-7 * v.inertia, DMat3::from_diagonal(DVec3::splat(2.293362637e-8)), 5e-18);
        // Truth: m/5 (b^2 + c^2) with half axes 1, 2, 3.
        let v = Shape::Ellipsoid { half: DVec3::new(1.0, 2.0, 3.0) }.volume().unwrap();
        close(v.inertia / v.volume, DMat3::from_diagonal(DVec3::new(13.0, 10.0, 5.0) / 5.0), 1e-14);
    }

    /// Truth: ring torus, volume 2 pi^2 R a^2, m (R^2 + 3/4 a^2) about the axis and
    /// m (R^2/2 + 5/8 a^2) across. A quarter is compared with a fine mesh.
    #[test]
    fn a_torus_agrees_with_the_formulas_and_with_a_mesh() {
        let (major, minor) = (2.0, 0.5);
        let v = Shape::Torus { major, minor, angle: TAU }.volume().unwrap();
        let m = TAU * TAU / 2.0 * major * minor * minor;
        assert!((v.volume - m).abs() < 1e-12);
        let across = m * (major * major / 2.0 + 0.625 * minor * minor);
        let along = m * (major * major + 0.75 * minor * minor);
        close(v.inertia, DMat3::from_diagonal(DVec3::new(across, across, along)), 1e-10);
        for angle in [TAU / 4.0, -TAU / 4.0] {
            let part = Shape::Torus { major, minor, angle }.volume().unwrap();
            let mesh = Mesh::grid(400, 400, |u, v| on_torus(major, minor, u * angle, v * TAU)).capped().volume();
            assert!((part.volume / mesh.volume - 1.0).abs() < 1e-4);
            assert!(part.centre.abs_diff_eq(mesh.centre, 1e-3), "{part:?} {mesh:?}");
            close(part.inertia / part.volume, mesh.inertia / mesh.volume, 2e-3);
        }
    }
}
