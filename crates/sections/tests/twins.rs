//! Torsion and shear once more, by numbers: Prandtl's stress function on a grid, and Jourawski's
//! energy by summing over cuts.

use std::f64::consts::PI;

use sections::{Axis, Shape, Theory};

fn shape(kind: &str, dimensions: &[f64]) -> Shape {
    Shape::new(kind, dimensions).unwrap()
}

fn assert_close(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found} is not {expected}");
}

#[derive(Clone, Copy, PartialEq)]
enum Cell {
    Outside,
    Material,
    Hole,
}

/// Solves ∇²φ = -2 with φ = 0 outside and one constant in a hole, on the nodes of a grid of square
/// cells; gives 2 ∫ φ dA, the torsion constant. `c` says what the middle of a cell is.
fn torsion_on_a_grid(size: (f64, f64), cells: (usize, usize), c: impl Fn(f64, f64) -> Cell) -> f64 {
    let (nx, ny) = cells;
    let dx = size.0 / nx as f64;
    assert!((dx - size.1 / ny as f64).abs() < 1e-12 * dx, "cells are squares");
    let cell = |i: usize, j: usize| c((i as f64 - 0.5) * dx - size.0 / 2.0, (j as f64 - 0.5) * dx - size.1 / 2.0);
    let stride = nx + 1;
    let mut kind = vec![Cell::Outside; stride * (ny + 1)];
    for j in 1..ny {
        for i in 1..nx {
            let round = [cell(i, j), cell(i + 1, j), cell(i, j + 1), cell(i + 1, j + 1)];
            kind[j * stride + i] = if round.contains(&Cell::Outside) {
                Cell::Outside
            } else if round.contains(&Cell::Hole) {
                Cell::Hole
            } else {
                Cell::Material
            };
        }
    }
    let mut phi = vec![0.0_f64; stride * (ny + 1)];
    let source = 2.0 * dx * dx;
    let over = 2.0 / (1.0 + PI / nx.max(ny) as f64);
    for sweep in 0.. {
        assert!(sweep < 20_000, "the grid does not settle");
        let (mut change, mut largest) = (0.0_f64, 0.0_f64);
        // The hole is one node: what flows into it balances the source over its area.
        let (mut nodes, mut edges, mut flow, mut level) = (0.0, 0.0, 0.0, 0.0);
        for at in (0..phi.len()).filter(|at| kind[*at] == Cell::Hole) {
            nodes += 1.0;
            level = phi[at];
            for next in [at - 1, at + 1, at - stride, at + stride].into_iter().filter(|n| kind[*n] != Cell::Hole) {
                edges += 1.0;
                flow += phi[next];
            }
        }
        if nodes > 0.0 {
            let new = (flow + source * nodes) / edges;
            change = (new - level).abs();
            (0..phi.len()).filter(|at| kind[*at] == Cell::Hole).for_each(|at| phi[at] = new);
        }
        for at in (0..phi.len()).filter(|at| kind[*at] == Cell::Material) {
            let round = phi[at - 1] + phi[at + 1] + phi[at - stride] + phi[at + stride];
            let step = over * ((round + source) / 4.0 - phi[at]);
            phi[at] += step;
            change = change.max(step.abs());
            largest = largest.max(phi[at].abs());
        }
        if change < 1e-9 * largest {
            break;
        }
    }
    2.0 * phi.iter().sum::<f64>() * dx * dx
}

/// Twin: Prandtl's function on two grids, extrapolated (the error goes with the square of the step).
#[test]
fn rectangles_twist_as_on_a_grid() {
    for (w, h) in [(1.0, 1.0), (1.0, 2.0), (3.0, 1.0)] {
        let solve = |n: f64| torsion_on_a_grid((w, h), ((n * w) as usize, (n * h) as usize), |_, _| Cell::Material);
        let (coarse, fine) = (solve(32.0), solve(64.0));
        let extrapolated = fine + (fine - coarse) / 3.0;
        // Because the next term of the error goes nearly with the fourth power: the corners leave 1e-5.
        assert_close(shape("rectangle", &[w, h]).torsion(), extrapolated, 2e-5);
    }
}

/// Twin: as above; re-entrant corners make the grid's error go with the step. Bredt with strips is a
/// thin-wall theory: with walls of a tenth of the width it stays 3 per cent below, because sharp outer
/// corners have more material than their centre lines.
#[test]
fn a_box_twists_nearly_as_on_a_grid() {
    let hole = |y: f64, z: f64| if y.abs() < 0.4 && z.abs() < 0.9 { Cell::Hole } else { Cell::Material };
    let solve = |n: usize| torsion_on_a_grid((1.0, 2.0), (n, 2 * n), hole);
    let (coarse, fine) = (solve(20), solve(40));
    let extrapolated = fine + (fine - coarse);
    let ours = shape("box", &[1.0, 2.0, 0.1]).torsion();
    assert_close(ours, extrapolated, 0.035);
    assert!(ours < fine, "{ours} {fine}");
}

/// Twin: as above; the corrections of Roark's table are a fit of about 2 per cent.
#[test]
fn an_i_twists_nearly_as_on_a_grid() {
    // 10 wide, 10 high, web and flanges 1.
    let inside = |y: f64, z: f64| if z.abs() > 4.0 || y.abs() < 0.5 { Cell::Material } else { Cell::Outside };
    let solve = |n: usize| torsion_on_a_grid((10.0, 10.0), (n, n), inside);
    let (coarse, fine) = (solve(80), solve(160));
    let extrapolated = fine + (fine - coarse) / 2.0;
    let ours = shape("i", &[10.0, 10.0, 1.0, 1.0]).torsion();
    assert_close(ours, extrapolated, 0.03);
}

/// Σ S²/b over cuts, by the midpoint rule, of a width b(s) that is given as a function.
fn energy_of_cuts(half: f64, width: impl Fn(f64) -> f64) -> f64 {
    let n = 400_000;
    let ds = half / f64::from(n);
    let (mut first, mut area, mut second, mut sum) = (0.0, 0.0, 0.0, 0.0);
    for k in (0..n).rev() {
        let s = (f64::from(k) + 0.5) * ds;
        let b = width(s);
        let at_middle = first + b * s * ds / 2.0;
        sum += at_middle * at_middle / b * ds;
        first += b * s * ds;
        area += 2.0 * b * ds;
        second += 2.0 * b * s * s * ds;
    }
    2.0 * area * sum / (second * second)
}

/// Twin: Jourawski's energy summed over 400 000 cuts; the midpoint rule is good to 1e-9 and the ends of
/// a circle to 1e-6.
#[test]
fn straight_cuts_have_the_energy_of_many_cuts() {
    let energy = |kind: &str, sizes: &[f64], axis| shape(kind, sizes).shear(axis, Theory::Energy, 0.0);
    assert_close(energy("rectangle", &[2.0, 3.0], Axis::Z), energy_of_cuts(1.5, |_| 2.0), 1e-8);
    assert_close(energy("circle", &[2.0], Axis::Z), energy_of_cuts(1.0, |s| 2.0 * (1.0 - s * s).sqrt()), 1e-5);
    assert_close(
        energy("ellipse", &[6.0, 2.0], Axis::Y),
        energy_of_cuts(3.0, |s| 2.0 * (1.0 - s * s / 9.0).sqrt()),
        1e-5,
    );
    let i = [4.0, 6.0, 0.5, 0.8];
    let across = energy_of_cuts(2.0, |s| if s < 0.25 { 6.0 } else { 1.6 });
    assert_close(energy("i", &i, Axis::Y), across, 1e-5);
    // Along the web the flow in the flanges comes on top: the stress V s d / I in each of four halves.
    let along = energy_of_cuts(3.0, |s| if s < 2.2 { 0.5 } else { 4.0 });
    let section = shape("i", &i);
    let flow: f64 =
        (0..10_000).map(|k| (f64::from(k) + 0.5) * 1.75e-4).map(|s| (s * 2.6).powi(2) * 0.8 * 1.75e-4).sum();
    let flanges = 4.0 * flow * section.area() / section.second_moment(Axis::Y).powi(2);
    assert_close(energy("i", &i, Axis::Z), along + flanges, 1e-5);
}

/// Twin: the exact stresses of a bent tube without Poisson's ratio. With the warping f(r) cos a the
/// equilibrium f'' + f'/r - f/r² = -r and free walls give f = -r³/8 + a r + b/r, and the energy is
/// A/I² π ∫ f r² dr, here by the midpoint rule.
#[test]
fn tubes_shear_as_the_exact_stresses_do() {
    for inner in [1e-6, 0.3, 0.7, 0.99] {
        let a = 3.0 * (1.0 + inner * inner) / 8.0;
        let b = 3.0 * inner * inner / 8.0;
        let (n, dr) = (20_000, (1.0 - inner) / 20_000.0);
        let sum: f64 = (0..n)
            .map(|k| inner + (f64::from(k) + 0.5) * dr)
            .map(|r| (-r.powi(3) / 8.0 + a * r + b / r) * r * r * dr)
            .sum();
        let (area, second) = (PI * (1.0 - inner * inner), PI / 4.0 * (1.0 - inner.powi(4)));
        let expected = area / (second * second) * PI * sum;
        let found = shape("tube", &[2.0, 1.0 - inner]).shear(Axis::Y, Theory::Energy, 0.3);
        assert_close(found, expected, 1e-7);
    }
}

/// Twin: Cowper's ellipse without Poisson's ratio is the exact energy too. With the warping
/// χ = s (c1 + c2 s² + c3 t²) of a force along s, ∇²χ = -s and no flow through the edge, the energy is
/// A/I² ∫ χ s dA; the constants follow from c2 and c3 in closed form and the moments of an ellipse.
#[test]
fn ellipses_of_cowper_shear_as_the_exact_stresses_do() {
    for (a, b) in [(1.0_f64, 1.0_f64), (3.0, 1.0), (1.0, 2.5)] {
        // 6 c2 + 2 c3 = -1 within; on the edge t² = b² (1 - s²/a²) the normal is (s/a², t/b²):
        // s/a² (c1 + 3 c2 s² + c3 t²) + 2 c3 s t²/b² = 0 for all s.
        // Constant: (c1 + c3 b²)/a² + 2 c3 = 0; s²: (3 c2 - c3 b²/a²)/a² - 2 c3/a² = 0.
        let ratio = b * b / (a * a);
        let c3 = -1.0 / (2.0 * (2.0 + ratio) + 2.0);
        let c2 = c3 * (2.0 + ratio) / 3.0;
        let c1 = -c3 * b * b - 2.0 * c3 * a * a;
        // Moments of an ellipse: ∫s² = π a³ b/4, ∫s⁴ = π a⁵ b/8, ∫s²t² = π a³ b³/24.
        let energy = c1 * PI * a.powi(3) * b / 4.0 + c2 * PI * a.powi(5) * b / 8.0 + c3 * PI * (a * b).powi(3) / 24.0;
        let second = PI * a.powi(3) * b / 4.0;
        let expected = PI * a * b * energy / (second * second);
        let found = shape("ellipse", &[2.0 * a, 2.0 * b]).shear(Axis::Y, Theory::Cowper, 0.0);
        assert_close(found, expected, 1e-12);
    }
}
