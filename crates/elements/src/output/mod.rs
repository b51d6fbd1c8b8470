//! What is recorded, and how a run is made.

pub mod analysis;
pub mod equilibrium_parameters;
pub(crate) mod everything;
pub mod kinematics_parameters;
pub mod measure_angle;
pub mod measure_computed;
pub mod measure_function;
pub mod measure_object;
pub mod measure_orient;
pub mod measure_point;
pub mod measure_pt2pt;
pub mod measure_query;
pub mod measure_range;
pub(crate) mod measured;
pub mod member;
pub(crate) mod not_recorded;
pub mod numerical_integration_parameters;
pub mod output_settings;
pub(crate) mod outputs;
pub mod preferences;
pub mod request;
pub mod results_settings;
pub mod script;
pub mod sensor;
pub(crate) mod vector;

pub use outputs::Outputs;
