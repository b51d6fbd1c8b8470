//! Commands of rigid parts, which also apply to the ground.

use schema::{Dimension, Field, Group, Rule};

use crate::common;

pub const NAME_AND_POSITION: Group = Group {
    command: "part create rigid_body name_and_position",
    creates: true,
    object: "part_name",
    fields: &[
        common::ADAMS_ID,
        common::COMMENTS,
        common::LOCATION.keyword("QG"),
        common::ORIENTATION.keyword("REULER"),
        Field::yes_no("ground_part").default_word("no").doc("the part is the ground"),
        Field::texts("view_name").doc("views that show the object"),
        Field::text("image_name").doc("picture tied to the part"),
        Field::yes_no("planar").default_word("no").doc("the part moves in a plane only"),
        Field::choice("planar_axes", &["xy", "yz", "zx"]).doc("plane in which a planar part moves"),
        common::ALONG_AXIS_ORIENTATION,
        common::IN_PLANE_ORIENTATION,
        common::RELATIVE_TO,
        Field::choice("exact_coordinates", &["x", "y", "z", "psi", "theta", "phi", "none", "all"])
            .many()
            .keyword("EXACT")
            .doc("start coordinates that the assembly leaves as they are"),
    ],
    rules: &[common::ONE_ORIENTATION],
    doc: "a rigid part and where it is",
};
pub const MASS_PROPERTIES: Group = Group {
    command: "part create rigid_body mass_properties",
    creates: false,
    object: "part_name",
    fields: &[
        Field::real("density", Dimension::DENSITY).doc("mass per volume of the shapes of the part"),
        Field::object("material_type", "material").doc("material whose density the shapes of the part have"),
        Field::real("mass", Dimension::MASS).keyword("MASS").doc("mass"),
        Field::object("center_of_mass_marker", "marker").keyword("CM").doc("marker at the centre of mass"),
        Field::object("inertia_marker", "marker")
            .keyword("IM")
            .doc("marker whose axes and origin the inertias refer to; the centre of mass marker if not given"),
        Field::real("ixx", Dimension::INERTIA).doc("moment of inertia about x"),
        Field::real("iyy", Dimension::INERTIA).doc("moment of inertia about y"),
        Field::real("izz", Dimension::INERTIA).doc("moment of inertia about z"),
        Field::real("ixy", Dimension::INERTIA).doc("product of inertia xy"),
        Field::real("izx", Dimension::INERTIA).doc("product of inertia zx"),
        Field::real("iyz", Dimension::INERTIA).doc("product of inertia yz"),
    ],
    rules: &[Rule::AtMostOne(&["center_of_mass_marker", "material_type"])],
    doc: "how heavy a rigid part is",
};
pub const INITIAL_VELOCITY: Group = Group {
    command: "part create rigid_body initial_velocity",
    creates: false,
    object: "part_name",
    fields: &[
        Field::real("vx", Dimension::VELOCITY).keyword("VX").doc("start velocity along x"),
        Field::real("vy", Dimension::VELOCITY).keyword("VY").doc("start velocity along y"),
        Field::real("vz", Dimension::VELOCITY).keyword("VZ").doc("start velocity along z"),
        Field::real("wx", Dimension::PER_TIME)
            .keyword("WX")
            .doc("start angular velocity about x; a plain number is in radians per unit of time"),
        Field::real("wy", Dimension::PER_TIME)
            .keyword("WY")
            .doc("start angular velocity about y; a plain number is in radians per unit of time"),
        Field::real("wz", Dimension::PER_TIME)
            .keyword("WZ")
            .doc("start angular velocity about z; a plain number is in radians per unit of time"),
        Field::object("vm", "marker")
            .keyword("VM")
            .doc("marker along whose axes vx, vy, vz are measured; global axes if not given"),
        Field::object("wm", "marker")
            .keyword("WM")
            .doc("marker along whose axes wx, wy, wz are measured; global axes if not given"),
        Field::true_false("no_vx").doc("forget the start velocity along x"),
        Field::true_false("no_vy").doc("forget the start velocity along y"),
        Field::true_false("no_vz").doc("forget the start velocity along z"),
        Field::true_false("no_wx").doc("forget the start angular velocity about x"),
        Field::true_false("no_wy").doc("forget the start angular velocity about y"),
        Field::true_false("no_wz").doc("forget the start angular velocity about z"),
    ],
    rules: &[],
    doc: "how fast a rigid part moves at the start",
};

/// The same commands for the ground: they set its cells and never make it.
pub const fn of_ground(mut group: Group) -> Group {
    group.creates = false;
    group
}
