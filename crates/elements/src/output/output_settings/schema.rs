//! Names, types, units and defaults of the settings of printed output.

use schema::{Class, Count, Dimension, Field, Group};

pub const CLASS: Class = Class {
    id: "output_settings",
    word: "Settings",
    families: &["settings"],
    parents: &["model"],
    prefix: "OUTPUT_SETTINGS_",
    statement: Some("OUTPUT"),
    groups: &[Group {
        command: "output_control set output",
        creates: true,
        object: "",
        fields: &[
            Field::object("model_name", "model").current().doc("model the setting belongs to"),
            Field::on_off("chart").doc("charts in the printed output"),
            Field::on_off("reqsave").doc("write the request file"),
            Field::on_off("dacsave").doc("write DAC files"),
            Field::on_off("rpcsave").doc("write RPC files"),
            Field::on_off("matsave").doc("write matrix files"),
            Field::on_off("print").doc("print the request tables"),
            Field::on_off("fixed").doc("fixed-point numbers"),
            Field::on_off("osformat").doc("old format of the request file"),
            Field::on_off("ypr").doc("angles as yaw, pitch, roll"),
            Field::on_off("separator").doc("separators between tables"),
            Field::on_off("icsave").doc("save the initial conditions"),
            Field::on_off("teletype").doc("narrow tables"),
            Field::text("grsave").doc("write the graphics file"),
            Field::real("dscale", Dimension::NONE).count(Count::exactly(2)).doc("scale of displacements and angles"),
            Field::real("dzero", Dimension::NONE).doc("displacements below count as zero"),
            Field::real("vscale", Dimension::NONE).count(Count::exactly(2)).doc("scale of velocities"),
            Field::real("vzero", Dimension::NONE).doc("velocities below count as zero"),
            Field::real("ascale", Dimension::NONE).count(Count::exactly(2)).doc("scale of accelerations"),
            Field::real("azero", Dimension::NONE).doc("accelerations below count as zero"),
            Field::real("fscale", Dimension::NONE).count(Count::exactly(2)).doc("scale of forces"),
            Field::real("fzero", Dimension::NONE).doc("forces below count as zero"),
            Field::choice("loads", &["none", "dac", "nastran", "rpc", "ansys", "abaqus", "marc"])
                .doc("format of flexible body loads"),
            Field::choice(
                "modal_deformation",
                &["none", "generic", "nastran", "dac", "punch", "rpc", "ansys", "femfat"],
            )
            .doc("format of modal deformations"),
            Field::choice("nodal_deformation", &["none", "generic", "nastran", "ansys"])
                .doc("format of nodal deformations"),
            Field::choice("stress", &["none", "dac", "generic", "rpc"]).doc("format of stresses"),
            Field::choice("strain", &["none", "dac", "generic", "rpc"]).doc("format of strains"),
            Field::choice("monitor_points", &["none", "generic", "rpc", "csv"]).doc("format of monitor points"),
        ],
        rules: &[],
        doc: "what is printed and saved during a run; one set for each model, made by the first use",
    }],
};
