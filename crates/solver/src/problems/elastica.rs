//! A plane bar of rigid sections joined by linear beams, clamped at one end: soft in bending, a
//! million times stiffer in tension, and bent through large angles.

use crate::{Dae, Evaluation, JacobianPoint, Pattern, Scales};

/// Sections `0..n` with unknowns `x y angle`; beam `i` joins section `i` to the one before it,
/// the first to ground. Each beam acts in the axes of the section before it.
#[derive(Clone, Debug)]
pub struct PlaneBar {
    pub sections: usize,
    pub length: f64,
    /// Stiffness in tension, N, and in bending, N m^2, of the whole bar's section.
    pub ea: f64,
    pub ei: f64,
    /// Damping as a multiple of the stiffness, s.
    pub damping: f64,
    /// Mass of the bar, kg.
    pub mass: f64,
    pub gravity: [f64; 2],
    /// Force on the last section, N.
    pub tip: [f64; 2],
}

impl PlaneBar {
    pub fn straight(&self) -> Vec<f64> {
        let l = self.length / self.sections as f64;
        (0..self.sections).flat_map(|i| [(i + 1) as f64 * l, 0.0, 0.0]).collect()
    }

    fn inertia(&self) -> (f64, f64) {
        let (n, l) = (self.sections as f64, self.length / self.sections as f64);
        let m = self.mass / n;
        (m, m * l * l / 12.0)
    }

    fn beam(&self, i: usize, q: &[f64], v: &[f64]) -> Beam {
        let l = self.length / self.sections as f64;
        let (zero, at) = ([0.0; 3], 3 * i);
        let (qj, vj) = if i == 0 { (&zero[..], &zero[..]) } else { (&q[at - 3..at], &v[at - 3..at]) };
        let (qi, vi) = (&q[at..at + 3], &v[at..at + 3]);
        let (sin, cos) = qj[2].sin_cos();
        let (dx, dy) = (qi[0] - qj[0], qi[1] - qj[1]);
        let arm = [cos * dx + sin * dy, -sin * dx + cos * dy];
        let (wx, wy) = (vi[0] - vj[0], vi[1] - vj[1]);
        let strain = [arm[0] - l, arm[1], qi[2] - qj[2]];
        let rate = [cos * wx + sin * wy + vj[2] * arm[1], -sin * wx + cos * wy - vj[2] * arm[0], vi[2] - vj[2]];
        let k = [
            [self.ea / l, 0.0, 0.0],
            [0.0, 12.0 * self.ei / (l * l * l), -6.0 * self.ei / (l * l)],
            [0.0, -6.0 * self.ei / (l * l), 4.0 * self.ei / l],
        ];
        let mut load = [0.0; 3];
        for (row, f) in k.iter().zip(&mut load) {
            for c in 0..3 {
                *f -= row[c] * (strain[c] + self.damping * rate[c]);
            }
        }
        Beam { sin, cos, arm, k, load }
    }
}

struct Beam {
    sin: f64,
    cos: f64,
    arm: [f64; 2],
    k: [[f64; 3]; 3],
    /// On the outer section, in the axes of the inner one.
    load: [f64; 3],
}

impl Beam {
    /// Loads on the outer and the inner section.
    fn loads(&self) -> ([f64; 3], [f64; 3]) {
        let [fx, fy, t] = self.load;
        let f = [self.cos * fx - self.sin * fy, self.sin * fx + self.cos * fy];
        ([f[0], f[1], t], [-f[0], -f[1], -(t + self.arm[0] * fy - self.arm[1] * fx)])
    }

    /// Derivative of `-loads` by the increments of the outer (columns 0..3) and inner (3..6)
    /// section, without the geometric part of damping.
    fn tangent(&self, stiffness: f64, viscous: f64) -> ([[f64; 6]; 3], [[f64; 6]; 3]) {
        let (s, c, [rx, ry], [fx, fy, _]) = (self.sin, self.cos, self.arm, self.load);
        let de = [[c, s, 0.0, -c, -s, ry], [-s, c, 0.0, s, -c, -rx], [0.0, 0.0, 1.0, 0.0, 0.0, -1.0]];
        let mut df = [[0.0; 6]; 3];
        for (row, k) in df.iter_mut().zip(&self.k) {
            for (col, value) in row.iter_mut().enumerate() {
                *value = -(0..3).map(|i| k[i] * de[i][col]).sum::<f64>();
            }
        }
        let both = stiffness + viscous;
        let (mut outer, mut inner) = ([[0.0; 6]; 3], [[0.0; 6]; 3]);
        for col in 0..6 {
            let turn = if col == 5 { stiffness } else { 0.0 };
            outer[0][col] = -(both * (c * df[0][col] - s * df[1][col]) + turn * (-s * fx - c * fy));
            outer[1][col] = -(both * (s * df[0][col] + c * df[1][col]) + turn * (c * fx - s * fy));
            outer[2][col] = -both * df[2][col];
            inner[0][col] = -outer[0][col];
            inner[1][col] = -outer[1][col];
            inner[2][col] = both * (df[2][col] + rx * df[1][col] - ry * df[0][col])
                + stiffness * (de[0][col] * fy - de[1][col] * fx);
        }
        (outer, inner)
    }
}

impl Dae for PlaneBar {
    fn positions(&self) -> usize {
        3 * self.sections
    }
    fn velocities(&self) -> usize {
        3 * self.sections
    }
    fn constraints(&self) -> usize {
        0
    }
    fn pattern(&self) -> Pattern {
        let n = self.sections;
        let pairs = (1..n).flat_map(|i| [(i - 1, i), (i, i - 1)]).collect();
        Pattern { sizes: vec![3; n], velocity_blocks: n, pairs }
    }
    fn scales(&self) -> Scales {
        Scales { increments: vec![1.0; 3 * self.sections] }
    }
    fn is_rotation(&self, velocity: usize) -> bool {
        velocity % 3 == 2
    }
    fn retract(&self, q: &[f64], increment: &[f64], out: &mut [f64]) {
        for i in 0..q.len() {
            out[i] = q[i] + increment[i];
        }
    }
    fn difference(&self, q0: &[f64], q1: &[f64], out: &mut [f64]) {
        for i in 0..q0.len() {
            out[i] = q1[i] - q0[i];
        }
    }
    fn residual(
        &mut self,
        _t: f64,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        _: &[f64],
        r: &mut [f64],
    ) -> Result<(), Evaluation> {
        let (m, inertia) = self.inertia();
        for i in 0..self.sections {
            let at = 3 * i;
            r[at] = m * (a[at] - self.gravity[0]);
            r[at + 1] = m * (a[at + 1] - self.gravity[1]);
            r[at + 2] = inertia * a[at + 2];
            let (outer, inner) = self.beam(i, q, v).loads();
            for k in 0..3 {
                r[at + k] -= outer[k];
                if i > 0 {
                    r[at - 3 + k] -= inner[k];
                }
            }
        }
        let last = 3 * (self.sections - 1);
        r[last] -= self.tip[0];
        r[last + 1] -= self.tip[1];
        Ok(())
    }
    fn constraint_residual(&mut self, _: f64, _: &[f64], _: &mut [f64]) -> Result<(), Evaluation> {
        Ok(())
    }
    fn constraint_velocity(&mut self, _: f64, _: &[f64], _: &mut [f64]) -> Result<(), Evaluation> {
        Ok(())
    }
    fn constraint_acceleration(&mut self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) -> Result<(), Evaluation> {
        Ok(())
    }
    fn jacobian(&mut self, at: JacobianPoint<'_>, add: &mut dyn FnMut(usize, usize, &[f64])) -> Result<(), Evaluation> {
        let (m, inertia) = self.inertia();
        let (m, inertia) = (at.mass * m, at.mass * inertia);
        for i in 0..self.sections {
            add(i, i, &[m, 0.0, 0.0, 0.0, m, 0.0, 0.0, 0.0, inertia]);
            if at.stiffness == 0.0 && at.damping == 0.0 {
                continue;
            }
            let (outer, inner) = self.beam(i, at.q, at.v).tangent(at.stiffness, at.damping * self.damping);
            let block = |rows: &[[f64; 6]; 3], first: usize| -> [f64; 9] {
                std::array::from_fn(|k| rows[k % 3][first + k / 3])
            };
            add(i, i, &block(&outer, 0));
            if i > 0 {
                add(i, i - 1, &block(&outer, 3));
                add(i - 1, i, &block(&inner, 0));
                add(i - 1, i - 1, &block(&inner, 3));
            }
        }
        Ok(())
    }
    fn describe(&self, unknown: usize) -> String {
        format!("section {} {}", unknown / 3 + 1, ["x", "y", "angle"][unknown % 3])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{IntegratorOptions, Silent, StaticMethod, StaticOptions, StaticReport, SystemState};
    use crate::{equilibrium, integrate, output_times};

    fn bar(sections: usize, load: f64) -> PlaneBar {
        PlaneBar {
            sections,
            length: 1.0,
            ea: 1e6,
            ei: 1.0,
            damping: 0.0,
            mass: 1.0,
            gravity: [0.0, 0.0],
            tip: [0.0, -load],
        }
    }

    fn tip(bar: &mut PlaneBar, options: &StaticOptions) -> (f64, f64, StaticReport) {
        let mut state = SystemState::at_rest(bar, 0.0, bar.straight());
        let report = equilibrium(bar, &mut state, options, &mut Silent).unwrap();
        let last = state.q.len() - 3;
        (state.q[last], state.q[last + 1], report)
    }

    fn exact() -> StaticOptions {
        StaticOptions { error: 1e-9, imbalance: 1e-7, ..Default::default() }
    }

    /// Tip of the inextensible elastica under a dead load `p` (in E I / L^2), by shooting: an
    /// independent computation, Runge-Kutta of the fourth order on theta'' = -p cos theta.
    fn elastica(p: f64) -> (f64, f64) {
        let shoot = |slope: f64| {
            let n = 4000;
            let h = 1.0 / f64::from(n);
            let mut y = [0.0, slope, 0.0, 0.0]; // angle, curvature, x, y
            let f = |y: [f64; 4]| [y[1], -p * y[0].cos(), y[0].cos(), y[0].sin()];
            let step = |y: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
            for _ in 0..n {
                let k1 = f(y);
                let k2 = f(step(y, k1, h / 2.0));
                let k3 = f(step(y, k2, h / 2.0));
                let k4 = f(step(y, k3, h));
                y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
            }
            y
        };
        // Curvature at the root between that of no load and of a lever of full length.
        let (mut low, mut high) = (0.0, p);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if shoot(middle)[1] < 0.0 { low = middle } else { high = middle }
        }
        let end = shoot(low);
        (end[2], end[3])
    }

    /// Truth: Mattiasson 1981, P L^2 / E I = 3: w/L = 0.60325, u/L = 0.25442.
    #[test]
    fn the_shooting_solution_is_that_of_mattiasson() {
        let (x, y) = elastica(3.0);
        assert!((y - 0.60325).abs() < 6e-6 && (1.0 - x - 0.25442).abs() < 6e-6, "{x} {y}");
    }

    /// Twin: shooting. The chain's error falls with the square of the number of beams.
    #[test]
    fn a_soft_bar_bends_like_the_elastica() {
        for load in [3.0, 10.0] {
            let (x, y) = elastica(load);
            let error = |n| {
                let (tx, ty, _) = tip(&mut PlaneBar { ea: 1e9, ..bar(n, load) }, &exact());
                (tx - x).hypot(ty + y)
            };
            let (coarse, fine) = (error(32), error(64));
            assert!(coarse < 2e-2, "{load}: {coarse}");
            assert!((coarse / fine).log2() > 1.6, "{load}: {coarse} {fine}");
        }
    }

    /// Both ways find the same equilibrium, whatever the stiffness in tension and the length.
    #[test]
    fn newton_and_relaxation_agree() {
        for n in [8, 32, 200] {
            let (x, y, report) = tip(&mut bar(n, 10.0), &exact());
            assert!(report.imbalance < 1e-6, "{report:?}");
            let relaxed = StaticOptions { maxit: 0, loading: 0, ..exact() };
            let (rx, ry, slow) = tip(&mut bar(n, 10.0), &relaxed);
            assert_eq!(slow.method, StaticMethod::Relaxation);
            assert!((x - rx).hypot(y - ry) < 1e-7, "{n}: {x} {y} {rx} {ry} {report:?} {slow:?}");
            println!("{n}: {} {:?}, {} {:?}", report.iterations, report.method, slow.iterations, slow.method);
        }
    }

    /// A blade ten times too soft for its own weight hangs down nearly straight: the tip is close
    /// to one length below the root, and no higher.
    #[test]
    fn a_bar_much_too_soft_hangs_down() {
        for weight in [10.0, 100.0, 1000.0] {
            let mut soft = PlaneBar { gravity: [0.0, -weight], ..bar(40, 0.0) };
            let (x, y, report) = tip(&mut soft, &StaticOptions::default());
            println!("{weight}: {x} {y} {report:?}");
            assert!(x > 0.0 && x < 0.8 && y < -0.5 && y > -1.01, "{weight}: {x} {y}");
        }
    }

    /// Steel bar of 10 m, 40 x 80 mm, dropped from its unloaded shape.
    fn dropped(sections: usize, error: f64) -> ([f64; 2], crate::Statistics) {
        let mut bar = PlaneBar {
            sections,
            length: 10.0,
            ea: 2.1e11 * 0.0032,
            ei: 2.1e11 * 0.04 * 0.08f64.powi(3) / 12.0,
            damping: 1e-3,
            mass: 7850.0 * 0.0032 * 10.0,
            gravity: [0.0, -9.81],
            tip: [0.0, 0.0],
        };
        let mut state = SystemState::at_rest(&bar, 0.0, bar.straight());
        let options = IntegratorOptions { error, ..Default::default() };
        let statistics =
            integrate(&mut bar, &mut state, 1.0, &output_times(0.0, 1.0, 500), &options, &mut Silent).unwrap();
        let last = 3 * (sections - 1);
        ([state.q[last], state.q[last + 1]], statistics)
    }

    /// The work in steps and iterations does not depend on the length of a chain, so the cost of a
    /// run is linear in it. The rounding of a long stiff chain must not keep the corrector busy:
    /// that is where criteria on the residual fail.
    #[test]
    fn a_long_chain_needs_no_more_iterations_than_a_short_one() {
        let (_, short) = dropped(30, 1e-5);
        let (_, long) = dropped(1000, 1e-5);
        println!("{short:?}\n{long:?}");
        assert!(long.steps < short.steps + 20 && long.failures == 0, "{long:?}");
        assert!(long.iterations < short.iterations * 5 / 4, "{short:?} {long:?}");
        assert!(long.factorisations < 40, "{long:?}");
    }

    /// Twin: the same chain with a thousand times smaller error. The tip swings through 1.3 m.
    #[test]
    fn the_swing_of_a_chain_converges() {
        let (exact, _) = dropped(30, 1e-8);
        for (error, allowed) in [(1e-5, 1e-3), (1e-6, 3e-4)] {
            let (tip, _) = dropped(30, error);
            let distance = (tip[0] - exact[0]).hypot(tip[1] - exact[1]);
            assert!(distance < allowed, "{error}: {distance}");
        }
    }
}
