//! Loads with components in a third frame's axes: apply and derivative.

extern crate flexure_equations as equations;

mod common;

use common::{FLOOR, Random, assert_all_close, body, dense, frame, slope};
use equations::{
    Axis, BodyId, Force, Frame, FrameId, FrameLoad, GROUND, Gradient, Loads, Side, State, System, Tangent,
    apply_following, measures, tangent_following, tangent_gradient,
};
use glam::DVec3;
use solver::{Dae, Evaluation, JacobianPoint};

/// A general force: six components in the axes of K, the second a function of the state.
struct General {
    j: Option<FrameId>,
    axes: Option<FrameId>,
    load: [f64; 6],
}

const I: FrameId = FrameId(0);
const L: FrameId = FrameId(3);

impl General {
    fn value(&self, state: &State, gradient: Option<&mut Gradient>) -> f64 {
        measures::velocity(state, Axis::X, I, Some(L), self.axes, None, gradient)
    }

    fn load(&self, state: &State) -> [f64; 6] {
        let mut load = self.load;
        load[1] = self.value(state, None);
        load
    }
}

impl Force for General {
    fn name(&self) -> &'static str {
        ".m.general"
    }

    fn bodies(&self) -> Vec<BodyId> {
        vec![BodyId(0), BodyId(1), BodyId(2), BodyId(3)]
    }

    fn add_loads(&self, state: &State, loads: &mut dyn Loads) -> Result<(), Evaluation> {
        apply_following(state, I, self.j, self.axes, &self.load(state), loads);
        Ok(())
    }

    fn add_tangent(&self, state: &State, tangent: &mut dyn Tangent) -> Result<(), Evaluation> {
        tangent_following(state, I, self.j, self.axes, &self.load(state), tangent);
        let mut gradient = Gradient::new();
        self.value(state, Some(&mut gradient));
        let unit = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        tangent_gradient(state, I, self.j, self.axes, &unit, &gradient, tangent);
        Ok(())
    }

    fn load_at(&self, _state: &State, _side: Side) -> FrameLoad {
        FrameLoad::default()
    }

    fn frame(&self, _side: Side) -> Option<FrameId> {
        None
    }
}

/// Twin: differences of the residual, for every combination of reaction and axes.
#[test]
fn derivative_of_a_load_in_other_axes() {
    let (j, k, fixed) = (FrameId(1), FrameId(2), FrameId(4));
    let cases = [
        (Some(j), Some(k)),
        (Some(j), Some(j)),
        (Some(j), None),
        (None, Some(k)),
        (None, Some(I)),
        (Some(fixed), Some(I)),
        (Some(j), Some(fixed)),
        (None, None),
    ];
    for (seed, (j, axes)) in (1..).zip(cases) {
        let mut random = Random(seed);
        let bodies: Vec<_> = (0..4).map(|at| body(".m.b", &mut random, at == 3)).collect();
        let mut frames: Vec<Frame> = (0..4).map(|at| frame(".m.f", BodyId(at), &mut random)).collect();
        frames.push(frame(".m.ground", GROUND, &mut random));
        let load = std::array::from_fn(|_| random.number());
        let force = General { j, axes, load };
        let mut system = System::new(bodies, frames, vec![Box::new(force)], Vec::new(), DVec3::ZERO).unwrap();
        let (q, v) = system.initial_state();
        let a = vec![0.0; v.len()];
        for (damping, stiffness) in [(0.0, 1.0), (1.0, 0.0)] {
            let at = JacobianPoint { t: 0.0, q: &q, v: &v, a: &a, lambda: &[], mass: 0.0, damping, stiffness };
            let matrix = dense(&mut system, at);
            for column in 0..v.len() {
                let wanted = slope(|h| {
                    let (mut q_h, mut v_h, mut step, mut r) = (q.clone(), v.clone(), a.clone(), a.clone());
                    step[column] = h * stiffness;
                    v_h[column] += h * damping;
                    system.retract(&q, &step, &mut q_h);
                    system.residual(0.0, &q_h, &v_h, &a, &[], &mut r).unwrap();
                    r
                });
                let got: Vec<f64> = matrix.iter().map(|row| row[column]).collect();
                assert_all_close(&got, &wanted, FLOOR, &format!("case {seed}, damping {damping}, column {column}"));
            }
        }
    }
}
