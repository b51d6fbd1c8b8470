//! Named problems with known answers, and the tests that every integrator must pass on them.

mod elastica;
pub mod oscillator;
pub mod pendulum;

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
