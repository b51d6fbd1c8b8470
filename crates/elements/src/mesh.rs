//! Closed surfaces of triangles, and what they enclose.

use std::f64::consts::TAU;

use glam::{DMat3, DVec2, DVec3};

use crate::shape::Volume;

/// Triangles over points, all turning the same way seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    pub points: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// A polygon in the xy plane pushed from `low` to `high` along z.
    pub fn prism(outline: &[DVec2], low: f64, high: f64) -> Mesh {
        let n = outline.len();
        let mut mesh = Mesh::default();
        for z in [low, high] {
            mesh.points.extend(outline.iter().map(|p| p.extend(z)));
        }
        for k in 1..n.saturating_sub(1) {
            mesh.triangle(0, k + 1, k);
            mesh.triangle(n, n + k, n + k + 1);
        }
        for k in 0..n {
            mesh.quad(k, (k + 1) % n, n + (k + 1) % n, n + k);
        }
        mesh
    }

    /// Polygons of `sides` sides inscribed in circles at z = 0 and z = `length`, joined.
    pub fn frustum(bottom: f64, top: f64, length: f64, angle: f64, sides: usize) -> Mesh {
        let mut mesh = Mesh::default();
        let row = sides + 1;
        for (radius, z) in [(bottom, 0.0), (top, length)] {
            mesh.points.extend((0..row).map(|k| {
                let turn = angle * k as f64 / sides as f64;
                DVec3::new(radius * turn.cos(), radius * turn.sin(), z)
            }));
        }
        let (low, high) = (2 * row, 2 * row + 1);
        mesh.points.extend([DVec3::ZERO, DVec3::new(0.0, 0.0, length)]);
        for k in 0..sides {
            mesh.quad(k, k + 1, row + k + 1, row + k);
            mesh.triangle(low, k + 1, k);
            mesh.triangle(high, row + k, row + k + 1);
        }
        if angle.abs() < TAU * (1.0 - 1e-9) {
            mesh.quad(low, 0, row, high);
            mesh.quad(high, row + sides, sides, low);
        }
        mesh
    }

    /// A flat polygon pushed along a vector that is not in its plane.
    pub fn pushed(corners: &[DVec3], along: DVec3) -> Mesh {
        let n = corners.len();
        let mut mesh = Mesh { points: corners.to_vec(), triangles: Vec::new() };
        mesh.points.extend(corners.iter().map(|p| *p + along));
        for k in 1..n.saturating_sub(1) {
            mesh.triangle(0, k + 1, k);
            mesh.triangle(n, n + k, n + k + 1);
        }
        for k in 0..n {
            mesh.quad(k, (k + 1) % n, n + (k + 1) % n, n + k);
        }
        mesh
    }

    /// A polygon of distances and heights turned around z in `sides` steps.
    pub fn turned(corners: &[DVec2], angle: f64, sides: usize) -> Mesh {
        let n = corners.len();
        let mut mesh = Mesh::default();
        for side in 0..=sides {
            let (sine, cosine) = (angle * side as f64 / sides as f64).sin_cos();
            mesh.points.extend(corners.iter().map(|p| DVec3::new(p.x * cosine, p.x * sine, p.y)));
        }
        for row in 0..sides {
            for k in 0..n {
                let (here, next) = (row * n + k, row * n + (k + 1) % n);
                mesh.quad(here, here + n, next + n, next);
            }
        }
        if angle.abs() < TAU * (1.0 - 1e-9) {
            let last = sides * n;
            for k in 1..n.saturating_sub(1) {
                mesh.triangle(0, k, k + 1);
                mesh.triangle(last, last + k + 1, last + k);
            }
        }
        mesh
    }

    /// A surface over a grid of `nu` x `nv` cells with parameters from 0 to 1.
    pub fn grid(nu: usize, nv: usize, at: impl Fn(f64, f64) -> DVec3) -> Mesh {
        let mut mesh = Mesh::default();
        for i in 0..=nu {
            mesh.points.extend((0..=nv).map(|j| at(i as f64 / nu as f64, j as f64 / nv as f64)));
        }
        let index = |i: usize, j: usize| i * (nv + 1) + j;
        for i in 0..nu {
            for j in 0..nv {
                mesh.quad(index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
            }
        }
        mesh
    }

    fn triangle(&mut self, a: usize, b: usize, c: usize) {
        self.triangles.push([a as u32, b as u32, c as u32]);
    }

    fn quad(&mut self, a: usize, b: usize, c: usize, d: usize) {
        self.triangle(a, b, c);
        self.triangle(a, c, d);
    }

    /// Volume, centre and inertia about the centre, summed over the tetrahedra between the triangles
    /// and one of the points. A surface that is inside out encloses the same.
    pub fn volume(&self) -> Volume {
        let Some(&from) = self.points.first() else {
            return Volume { volume: 0.0, centre: DVec3::ZERO, inertia: DMat3::ZERO };
        };
        let (mut volume, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|k| self.points[k as usize] - from);
            let v = a.dot(b.cross(c)) / 6.0;
            let sum = a + b + c;
            volume += v;
            first += sum * (v / 4.0);
            second += (outer(sum) + outer(a) + outer(b) + outer(c)) * (v / 20.0);
        }
        let sign = if volume < 0.0 { -1.0 } else { 1.0 };
        let (volume, first, second) = (volume * sign, first * sign, second * sign);
        let arm = if volume > 0.0 { first / volume } else { DVec3::ZERO };
        let about = second - outer(arm) * volume;
        let trace = about.x_axis.x + about.y_axis.y + about.z_axis.z;
        Volume { volume, centre: from + arm, inertia: DMat3::from_diagonal(DVec3::splat(trace)) - about }
    }
}

fn outer(v: DVec3) -> DMat3 {
    DMat3::from_cols(v * v.x, v * v.y, v * v.z)
}

#[cfg(test)]
impl Mesh {
    /// Closes the first and the last row of a grid whose rows are rings.
    pub(crate) fn capped(mut self) -> Mesh {
        let rows = (self.points.len() as f64).sqrt() as usize;
        let last = self.points.len() - rows;
        for k in 1..rows - 1 {
            self.triangle(0, k, k + 1);
            self.triangle(last, last + k + 1, last + k);
        }
        self
    }
}
