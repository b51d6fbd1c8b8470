//! Chains of beams built directly among the equations, against closed forms, elliptic integrals and
//! the exact equilibria of discrete chains. Newton's method and the eigenvalue sweep are the
//! test's own, so that nothing of the solver is believed here.

use equations::{
    Body, BodyId, BodyMotion, Force, Frame, FrameId, FrameLoad, GROUND, Loads, Side, State, System, Tangent,
};
use flexure_elements::forces::beam::{
    Angles, Beam, Formulation, Law, Section,
    physics::{proportional_damping, stiffness},
};
use glam::{DMat3, DQuat, DVec3};
use solver::{Dae, Evaluation, JacobianPoint};

/// A force of fixed direction and a torque about a fixed axis at a frame.
struct Dead {
    frame: FrameId,
    body: BodyId,
    f_g: DVec3,
    t_g: DVec3,
}

impl Force for Dead {
    fn name(&self) -> &'static str {
        "load"
    }
    fn bodies(&self) -> Vec<BodyId> {
        vec![self.body]
    }
    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation> {
        loads.at_frame(state, self.frame, FrameLoad { f_g: self.f_g, t_g: self.t_g });
        Ok(())
    }
    /// The force acts at the centre of mass; a torque about a fixed axis turns in body axes.
    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation> {
        let torque_b = state.rotation(self.body).transpose() * self.t_g;
        let by_turn = equations::skew(torque_b) * tangent.stiffness();
        let mut block = [[0.0; 6]; 6];
        for row in 0..3 {
            for column in 0..3 {
                block[3 + row][3 + column] = by_turn.col(column)[row];
            }
        }
        tangent.add(self.body, self.body, &block);
        Ok(())
    }
    fn load_at(&self, _: &State, _: Side) -> FrameLoad {
        FrameLoad { f_g: self.f_g, t_g: self.t_g }
    }
    fn frame(&self, _: Side) -> Option<FrameId> {
        Some(self.frame)
    }
}

#[derive(Clone, Copy)]
struct Chain {
    beams: usize,
    /// Section of the whole cantilever; each beam gets its share of the length.
    section: Section,
    formulation: Formulation,
    /// Whether J is the marker nearer to the root.
    j_at_root: bool,
    f_g: DVec3,
    t_g: DVec3,
    /// Mass and inertias of each body, and the free length of the first beam as a share of the others.
    mass: f64,
    inertia: f64,
    root: f64,
    damping: f64,
}

/// EI = L = 1, EA = 1e6 unless changed.
fn unit_chain(beams: usize) -> Chain {
    let section = Section { length: 1.0, area: 1e6, ixx: 1.0, iyy: 1.0, izz: 1.0, e: 1.0, g: 1.0, asy: 0.0, asz: 0.0 };
    Chain {
        beams,
        section,
        formulation: Formulation::Linear,
        j_at_root: true,
        f_g: DVec3::ZERO,
        t_g: DVec3::ZERO,
        mass: 1.0,
        inertia: 1.0,
        root: 1.0,
        damping: 0.0,
    }
}

fn build(c: &Chain) -> System {
    let h = c.section.length / c.beams as f64;
    let turn = if c.j_at_root { DMat3::IDENTITY } else { DMat3::from_rotation_z(std::f64::consts::PI) };
    let mut frames = vec![Frame { name: "root".into(), body: GROUND, r_bi_b: DVec3::ZERO, rot_bi: turn }];
    let (mut bodies, mut forces) = (Vec::new(), Vec::<Box<dyn Force>>::new());
    let mut x = 0.0;
    for n in 0..c.beams {
        let length = if n == 0 { h * c.root } else { h };
        x += length;
        bodies.push(Body {
            name: format!("body {n}"),
            mass: c.mass,
            inertia_c_b: DMat3::from_diagonal(DVec3::splat(c.inertia)),
            point_mass: false,
            initial: BodyMotion {
                r_gb_g: DVec3::X * x,
                q_gb: DQuat::IDENTITY,
                v_gb_g: DVec3::ZERO,
                w_gb_b: DVec3::ZERO,
                a_gb_g: DVec3::ZERO,
                alpha_gb_b: DVec3::ZERO,
            },
            exact: [false; 6],
        });
        let body = BodyId(n as u32);
        frames.push(Frame { name: format!("node {n}"), body, r_bi_b: DVec3::ZERO, rot_bi: turn });
        let (near, far) = (FrameId(n as u32), FrameId(n as u32 + 1));
        let (i, j) = if c.j_at_root { (far, near) } else { (near, far) };
        let near_body = if n == 0 { GROUND } else { BodyId(n as u32 - 1) };
        let section = Section { length, ..c.section };
        let k = stiffness(&section);
        let law = Law {
            length,
            stiffness: k,
            damping: proportional_damping(&k, c.damping),
            formulation: c.formulation,
            angles: Angles::Projected,
        };
        let ends = if c.j_at_root { [body, near_body] } else { [near_body, body] };
        let bodies = ends.into_iter().filter(|b| *b != GROUND).collect::<Vec<_>>();
        let ends = [bodies[0], bodies.get(1).copied().unwrap_or(GROUND)];
        forces.push(Box::new(Beam { name: format!("beam {n}"), i, j, bodies: ends, law }));
    }
    let last = c.beams as u32;
    forces.push(Box::new(Dead { frame: FrameId(last), body: BodyId(last - 1), f_g: c.f_g, t_g: c.t_g }));
    System::new(bodies, frames, forces, Vec::new(), DVec3::ZERO).unwrap()
}

/// Dense matrix `mass M + stiffness K`, column by column.
fn matrix(system: &mut System, q: &[f64], mass: f64, damping: f64, stiffness: f64) -> Vec<Vec<f64>> {
    let n = system.velocities();
    let zero = vec![0.0; n];
    let sizes = system.pattern().sizes;
    let starts: Vec<usize> = sizes.iter().scan(0, |at, size| Some(std::mem::replace(at, *at + size))).collect();
    let mut m = vec![vec![0.0; n]; n];
    let at = JacobianPoint { t: 0.0, q, v: &zero, a: &zero, lambda: &[], mass, damping, stiffness };
    system
        .jacobian(at, &mut |row, column, values| {
            for (k, value) in values.iter().enumerate() {
                m[starts[row] + k % sizes[row]][starts[column] + k / sizes[row]] += value;
            }
        })
        .unwrap();
    m
}

/// Gauss elimination with row exchange.
fn solve(mut m: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&x, &y| m[x][k].abs().total_cmp(&m[y][k].abs())).unwrap();
        m.swap(k, pivot);
        b.swap(k, pivot);
        for row in k + 1..n {
            let factor = m[row][k] / m[k][k];
            if factor != 0.0 {
                let (above, below) = m.split_at_mut(row);
                for (x, y) in below[0][k..].iter_mut().zip(&above[k][k..]) {
                    *x -= factor * y;
                }
                b[row] -= factor * b[k];
            }
        }
    }
    for k in (0..n).rev() {
        b[k] = (b[k] - (k + 1..n).map(|c| m[k][c] * b[c]).sum::<f64>()) / m[k][k];
    }
    b
}

/// Equilibrium by Newton's method in equal load steps; positions.
fn equilibrium(c: &Chain, steps: usize) -> (System, Vec<f64>) {
    let mut system = build(c);
    let (mut q, v) = system.initial_state();
    let zero = vec![0.0; v.len()];
    for step in 1..=steps {
        system.set_load_factor(1.0);
        let share = step as f64 / steps as f64;
        let mut loaded = build(&Chain { f_g: c.f_g * share, t_g: c.t_g * share, ..*c });
        for iteration in 0.. {
            assert!(iteration < 50, "no equilibrium");
            let mut r = vec![0.0; v.len()];
            loaded.residual(0.0, &q, &v, &zero, &[], &mut r).unwrap();
            let m = matrix(&mut loaded, &q, 0.0, 0.0, 1.0);
            let increment = solve(m, r.iter().map(|x| -x).collect());
            let mut next = q.clone();
            loaded.retract(&q, &increment, &mut next);
            q = next;
            if increment.iter().all(|x| x.abs() < 1e-12) {
                break;
            }
        }
        system = loaded;
    }
    (system, q)
}

/// Shortening, deflection and slope of the tip.
fn tip(c: &Chain, steps: usize) -> [f64; 3] {
    let (mut system, q) = equilibrium(c, steps);
    let v = vec![0.0; system.velocities()];
    let state = system.state(0.0, &q, &v, None);
    let last = state.bodies.last().unwrap();
    let x = state.rotations.last().unwrap().x_axis;
    [c.section.length - last.r_gb_g.x, last.r_gb_g.y, x.y.atan2(x.x)]
}

fn assert_near(actual: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((actual - expected).abs() <= tolerance, "{what}: {actual} is not {expected} within {tolerance}");
}

/// Truth: Timoshenko cantilever, y = P L^3/3EI + ASY P L/GA, slope P L^2/2EI; any number of beams
/// gives it exactly. At P = 1e-6 the neglected terms are of order P^3 relative to 1: rounding of the
/// equilibrium (1e-12 absolute on 1e-7) decides.
#[test]
fn small_tip_forces_bend_like_a_timoshenko_cantilever() {
    for beams in [1, 2, 8, 32] {
        let mut c = unit_chain(beams);
        c.section = Section { area: 50.0, g: 0.4, asy: 1.2, ..c.section };
        let p = 1e-6;
        c.f_g = DVec3::Y * p;
        let [_, y, slope] = tip(&c, 1);
        let shear = 1.2 * p / (0.4 * 50.0);
        assert_near(y, p / 3.0 + shear, 1e-11, "deflection");
        assert_near(slope, p / 2.0, 1e-11, "slope");
        c.f_g = DVec3::ZERO;
        c.t_g = DVec3::Z * p;
        let [_, y, slope] = tip(&c, 1);
        assert_near(y, p / 2.0, 1e-11, "deflection under a moment");
        assert_near(slope, p, 1e-11, "slope under a moment");
        c.t_g = DVec3::X * p;
        let (mut system, q) = equilibrium(&c, 1);
        let v = vec![0.0; system.velocities()];
        let turned = system.state(0.0, &q, &v, None).rotations.last().unwrap().y_axis;
        assert_near(turned.z, p / 0.4, 1e-11, "twist T L / (G Ixx)");
    }
}

/// Truth for the limit: elastica with P L^2/EI = 1, u = 0.05643324, v = 0.30172077 (Bisshopp and
/// Drucker 1945, elliptic integrals). Twin for each number of beams: equilibrium of the discrete
/// chain with EA = 1e6, computed apart by an independent program, five printed digits.
#[test]
fn elastica_of_linear_and_string_chains() {
    let linear_root = [(1, 0.0, 0.33333), (2, 0.04431, 0.30810), (8, 0.05580, 0.30217), (32, 0.05640, 0.30175)];
    let linear_tip = [(1, 0.03950, 0.33833), (2, 0.04985, 0.31112), (8, 0.05589, 0.30223), (32, 0.05640, 0.30175)];
    let string = [(1, 0.05719, 0.33333), (2, 0.05500, 0.30627), (8, 0.05630, 0.30187), (32, 0.05642, 0.30173)];
    for (formulation, j_at_root, rows) in [
        (Formulation::Linear, true, linear_root),
        (Formulation::Linear, false, linear_tip),
        (Formulation::String, true, string),
    ] {
        for (beams, u, v) in rows {
            let c = Chain { formulation, j_at_root, f_g: DVec3::Y, ..unit_chain(beams) };
            let found = tip(&c, 5);
            let what = format!("{formulation:?}, J at root {j_at_root}, {beams} beams");
            assert_near(found[0], u, 5.1e-6, &what); // half of the last printed digit
            assert_near(found[1], v, 5.1e-6, &what);
        }
    }
}

/// Truth: an end moment of 2 pi EI/L closes a chain of any beams to a regular polygon: the tip
/// returns to the root. The tolerance is that of Newton's method.
#[test]
fn an_end_moment_rolls_the_chain_up() {
    let c = Chain { t_g: DVec3::Z * std::f64::consts::TAU, ..unit_chain(8) };
    let [u, v, _] = tip(&c, 25);
    assert_near(u, 1.0, 1e-9, "x of the tip");
    assert_near(v, 0.0, 1e-9, "y of the tip");
}

/// Eigenvalues of a symmetric matrix by Jacobi's rotations, ascending.
fn eigenvalues(mut a: Vec<Vec<f64>>) -> Vec<f64> {
    let n = a.len();
    for _ in 0..60 {
        let mut off = 0.0_f64;
        for p in 0..n {
            for q in p + 1..n {
                let x = a[p][q];
                off = off.max(x.abs() / (a[p][p].abs() * a[q][q].abs()).sqrt().max(1e-300));
                if x == 0.0 {
                    continue;
                }
                let theta = (a[q][q] - a[p][p]) / (2.0 * x);
                let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for row in &mut a {
                    let (x, y) = (row[p], row[q]);
                    (row[p], row[q]) = (c * x - s * y, s * x + c * y);
                }
                let (upper, lower) = a.split_at_mut(q);
                for (x, y) in upper[p].iter_mut().zip(&mut lower[0]) {
                    (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                }
            }
        }
        if off < 1e-15 {
            break;
        }
    }
    let mut values: Vec<f64> = (0..n).map(|k| a[k][k]).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Truth for the limit: cantilever, (beta L)^2 = 3.516015, 22.034492, 61.697214. Twin: ratios of
/// N rigid segments of mass m/N and inertia m h^2/12N with beams between their centres (h/2 at the
/// root), eigenvalues computed apart, six printed digits. Torsion and the other plane are made stiff
/// so that the three lowest modes are those of one plane.
#[test]
fn frequencies_of_segment_chains() {
    let exact = [3.516_015_269, 22.034_491_56, 61.697_214_41];
    for (beams, ratios) in [(4, [1.002172, 0.965648, 0.889964]), (8, [1.000555, 0.991359, 0.970766])] {
        let n = beams as f64;
        let h = 1.0 / n;
        let mut c = unit_chain(beams);
        c.section = Section { ixx: 1e6, iyy: 1e6, ..c.section };
        (c.mass, c.inertia, c.root) = (h, h * h * h / 12.0, 0.5);
        let mut system = build(&c);
        let (q, _) = system.initial_state();
        let k = matrix(&mut system, &q, 0.0, 0.0, 1.0);
        let m = matrix(&mut system, &q, 1.0, 0.0, 0.0);
        let scaled = |r: usize, col: usize| k[r][col] / (m[r][r] * m[col][col]).sqrt();
        let a: Vec<Vec<f64>> = (0..k.len()).map(|r| (0..k.len()).map(|col| scaled(r, col)).collect()).collect();
        for r in 0..a.len() {
            for col in 0..r {
                let size = (a[r][r] * a[col][col]).sqrt();
                assert_near(a[r][col], a[col][r], 1e-12 * size, "symmetry of the undeformed stiffness");
            }
        }
        let found = eigenvalues(a);
        for ((value, exact), ratio) in found.iter().zip(exact).zip(ratios) {
            assert_near(value.sqrt() / exact, ratio, 6e-7, &format!("{beams} segments"));
        }
    }
}

/// Truth: C = ratio K at the same state.
#[test]
fn damping_is_the_ratio_times_the_stiffness() {
    let c = Chain { damping: 0.02, ..unit_chain(3) };
    let mut system = build(&c);
    let (q, _) = system.initial_state();
    let k = matrix(&mut system, &q, 0.0, 0.0, 1.0);
    let d = matrix(&mut system, &q, 0.0, 1.0, 0.0);
    for (row, damping) in k.iter().zip(&d) {
        for (x, y) in row.iter().zip(damping) {
            assert_near(*y, 0.02 * x, 1e-10 * x.abs().max(1.0), "damping");
        }
    }
}
