//! The registry: one line for each element.

use schema::{Class, Registry};

use crate::{bodies, data, forces, geometry, joints, output};

/// Every class, in the order of the manual.
const CLASSES: &[&Class] = &[
    &bodies::model::CLASS,
    &bodies::part::CLASS,
    &bodies::ground::CLASS,
    &bodies::point_mass::CLASS,
    &bodies::marker::CLASS,
    &bodies::point::CLASS,
    &joints::fixed::CLASS,
    &joints::revolute::CLASS,
    &joints::spherical::CLASS,
    &joints::translational::CLASS,
    &joints::cylindrical::CLASS,
    &joints::universal::CLASS,
    &joints::hooke::CLASS,
    &joints::planar::CLASS,
    &joints::jprim_at_point::CLASS,
    &joints::jprim_inline::CLASS,
    &joints::jprim_inplane::CLASS,
    &joints::jprim_orientation::CLASS,
    &joints::jprim_parallel_axis::CLASS,
    &joints::jprim_perpendicular::CLASS,
    &joints::motion::CLASS,
    &forces::beam::CLASS,
    &forces::gravity::CLASS,
    &forces::single_component_force::CLASS,
    &data::material::CLASS,
    &data::variable::CLASS,
    &data::group::CLASS,
    &geometry::link::CLASS,
    &geometry::cylinder::CLASS,
    &geometry::frustum::CLASS,
    &geometry::block::CLASS,
    &geometry::ellipsoid::CLASS,
    &geometry::torus::CLASS,
    &geometry::plate::CLASS,
    &geometry::arc::CLASS,
    &geometry::circle::CLASS,
    &geometry::polyline::CLASS,
    &geometry::force_graphic::CLASS,
    &geometry::spring_damper_graphic::CLASS,
    &output::request::CLASS,
    &output::measure_pt2pt::CLASS,
    &output::measure_object::CLASS,
    &output::measure_function::CLASS,
    &output::script::CLASS,
    &output::numerical_integration_parameters::CLASS,
    &output::equilibrium_parameters::CLASS,
    &output::kinematics_parameters::CLASS,
    &output::preferences::CLASS,
    &output::output_settings::CLASS,
    &output::results_settings::CLASS,
];

/// The classes of all elements. Verbs are added by whoever runs commands.
pub fn registry() -> Registry {
    Registry { classes: CLASSES.to_vec(), verbs: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_keep_their_rules() {
        assert_eq!(registry().check(), Vec::<String>::new());
    }
}
