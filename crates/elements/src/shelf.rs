//! What each element can do beside being described: become equations, and check itself. One line
//! for each element that takes part in a simulation.

use model::{Database, ObjectId};
use schema::Class;

use crate::{
    bodies, forces, joints,
    lower::{Lowering, Options},
    output,
    verify::Finding,
};

/// When an element is lowered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Bodies come first: markers lie on them.
    Body,
    /// Forces and constraints between markers.
    Mechanics,
    /// What is recorded, when everything else is there.
    Output,
}

/// Adds what is doubtful about one object that is lowered with these options.
pub type Check = fn(&Database, ObjectId, &Options, &mut Vec<Finding>);

/// An element that takes part in a simulation.
pub struct Element {
    pub class: &'static Class,
    pub stage: Stage,
    pub lower: fn(&mut Lowering<'_>, ObjectId),
    pub verify: Option<Check>,
}

const fn body(class: &'static Class, lower: fn(&mut Lowering<'_>, ObjectId)) -> Element {
    Element { class, stage: Stage::Body, lower, verify: None }
}

const fn mechanics(class: &'static Class, lower: fn(&mut Lowering<'_>, ObjectId)) -> Element {
    Element { class, stage: Stage::Mechanics, lower, verify: None }
}

const fn output(class: &'static Class, lower: fn(&mut Lowering<'_>, ObjectId)) -> Element {
    Element { class, stage: Stage::Output, lower, verify: None }
}

const ELEMENTS: &[Element] = &[
    body(&bodies::part::CLASS, bodies::part::lower::lower),
    body(&bodies::ground::CLASS, bodies::ground::lower::lower),
    body(&bodies::point_mass::CLASS, bodies::point_mass::lower::lower),
    mechanics(&joints::fixed::CLASS, joints::fixed::lower::lower),
    mechanics(&joints::revolute::CLASS, joints::revolute::lower::lower),
    mechanics(&joints::spherical::CLASS, joints::spherical::lower::lower),
    mechanics(&joints::translational::CLASS, joints::translational::lower::lower),
    mechanics(&joints::cylindrical::CLASS, joints::cylindrical::lower::lower),
    mechanics(&joints::universal::CLASS, joints::universal::lower::lower),
    mechanics(&joints::hooke::CLASS, joints::hooke::lower::lower),
    mechanics(&joints::planar::CLASS, joints::planar::lower::lower),
    mechanics(&joints::jprim_at_point::CLASS, joints::jprim_at_point::lower::lower),
    mechanics(&joints::jprim_inline::CLASS, joints::jprim_inline::lower::lower),
    mechanics(&joints::jprim_inplane::CLASS, joints::jprim_inplane::lower::lower),
    mechanics(&joints::jprim_orientation::CLASS, joints::jprim_orientation::lower::lower),
    mechanics(&joints::jprim_parallel_axis::CLASS, joints::jprim_parallel_axis::lower::lower),
    mechanics(&joints::jprim_perpendicular::CLASS, joints::jprim_perpendicular::lower::lower),
    mechanics(&joints::motion::CLASS, joints::motion::lower::lower),
    Element {
        verify: Some(forces::beam::verify::verify),
        ..mechanics(&forces::beam::CLASS, forces::beam::lower::lower)
    },
    mechanics(&forces::gravity::CLASS, forces::gravity::lower::lower),
    mechanics(&forces::single_component_force::CLASS, forces::single_component_force::lower::lower),
    mechanics(&forces::bushing::CLASS, forces::bushing::lower::lower),
    mechanics(&forces::translational_spring_damper::CLASS, forces::translational_spring_damper::lower::lower),
    mechanics(&forces::rotational_spring_damper::CLASS, forces::rotational_spring_damper::lower::lower),
    output(&output::request::CLASS, output::request::lower::lower),
    output(&output::measure_pt2pt::CLASS, output::measure_pt2pt::lower::lower),
    output(&output::measure_object::CLASS, output::measure_object::lower::lower),
    output(&output::measure_function::CLASS, output::measure_function::lower::lower),
    output(&output::measure_point::CLASS, output::measure_point::lower::lower),
    output(&output::measure_angle::CLASS, output::not_recorded::lower),
    output(&output::measure_orient::CLASS, output::not_recorded::lower),
    output(&output::measure_computed::CLASS, output::not_recorded::lower),
    output(&output::measure_range::CLASS, output::not_recorded::lower),
    output(&output::measure_query::CLASS, output::not_recorded::lower),
];

/// What a class can do in a simulation.
pub fn element(class: &Class) -> Option<&'static Element> {
    ELEMENTS.iter().find(|e| e.class == class)
}

/// Whether objects of a class act on the motion, so that leaving them out changes it.
pub fn acts(class: &Class) -> bool {
    const FAMILIES: [&str; 6] = ["force", "constraint", "body", "contact", "equation", "sensor"];
    FAMILIES.iter().any(|family| class.is(family))
}
