//! Parameters that several measures share.

use schema::Field;

pub const COMPONENT: Field = Field::choice(
    "component",
    &[
        "x_component",
        "y_component",
        "z_component",
        "mag_component",
        "r_component",
        "rho_component",
        "theta_component",
        "phi_component",
    ],
)
.required()
.doc("component recorded");
pub const MOTION_RFRAME: Field =
    Field::object("motion_rframe", "marker").doc("frame in which time derivatives are taken");
pub const COORDINATE_RFRAME: Field =
    Field::object("coordinate_rframe", "marker").doc("marker along whose axes components are given");
pub const DISPLAY: Field =
    Field::yes_no("create_measure_display").default_word("yes").on_create().doc("open a strip chart");
pub const LEGEND: Field = Field::text("legend").doc("text of the legend");
