//! Names, types, units and defaults of a sensor.

use schema::{Class, Count, Dimension, Field, Group, Rule};

use crate::{common, data::fields};

const CONSTANTS: Count = Count::between(1, 30);

pub const CLASS: Class = Class {
    id: "sensor",
    word: "Sensor",
    families: &[],
    parents: &["model"],
    prefix: "SENSOR_",
    statement: Some("SENSOR"),
    groups: &[Group {
        command: "executive_control create sensor",
        creates: true,
        object: "sensor_name",
        fields: &[
            common::ADAMS_ID,
            common::COMMENTS,
            Field::choice("compare", &["ge", "eq", "le"]).default_word("eq").doc("how value and limit are compared"),
            Field::real("value", Dimension::NONE).keyword("VALUE").doc("limit at which it fires"),
            Field::real("error", Dimension::NONE)
                .default(0.001)
                .keyword("ERROR")
                .doc("distance from the limit that counts as reached"),
            Field::real("angular_value", Dimension::ANGLE).doc("limit of a function that is an angle"),
            Field::real("angular_error", Dimension::ANGLE)
                .doc("distance from an angular limit that counts as reached; 0.001 radian if not given"),
            Field::real("dt", Dimension::TIME).keyword("DT").doc("output step from then on"),
            Field::real("stepsize", Dimension::NONE).keyword("STEPSIZE").doc("integration step from then on"),
            Field::on_off("bisection").doc("close in on the moment by halving steps"),
            Field::real("time_error", Dimension::TIME).doc("how closely the moment is found"),
            Field::on_off("codgen").default_word("on").keyword("CODGEN").doc("order the equations anew"),
            Field::on_off("halt").default_word("on").keyword("HALT").doc("end the run"),
            Field::on_off("print").default_word("on").keyword("PRINT").doc("record an output there"),
            Field::on_off("restart").default_word("on").keyword("RESTART").doc("begin the integration anew"),
            Field::on_off("return").default_word("on").keyword("RETURN").doc("end this simulation and take commands"),
            Field::on_off("yydump").default_word("on").keyword("YYDUMP").doc("write the state of the solver"),
            Field::function("function").keyword("FUNCTION").doc("what is watched"),
            fields::USER_FUNCTION,
            fields::ROUTINE,
            Field::function("evaluate").keyword("EVALUATE").doc("value that is kept when it fires"),
            Field::real("user_evaluate", Dimension::NONE)
                .count(CONSTANTS)
                .doc("constants handed to the subroutine that gives the kept value"),
            Field::text("evaluate_routine").doc("library and entry of that subroutine"),
        ],
        rules: &[Rule::AtMostOne(&["function", "user_function"]), Rule::AtLeastOne(&["function", "user_function"])],
        doc: "watches a function during a run and acts when it reaches a limit",
    }],
};
