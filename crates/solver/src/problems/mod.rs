//! Named problems with known answers, and the tests that every integrator must pass on them.

mod elastica;
mod free_body;
pub mod oscillator;
pub mod pendulum;
mod slider_crank;

use crate::{Control, Dae, Observer, SystemState};

/// Keeps every output.
#[derive(Default)]
pub struct Recorder {
    pub states: Vec<SystemState>,
}

impl Observer for Recorder {
    fn output(&mut self, _dae: &mut dyn Dae, state: &SystemState) -> Control {
        self.states.push(state.clone());
        Control::Continue
    }
}
