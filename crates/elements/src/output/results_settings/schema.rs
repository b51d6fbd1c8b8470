//! Names, types, units and defaults of the settings of the results file.

use schema::{Class, Count, Dimension, Field, Group};

pub const CLASS: Class = Class {
    id: "results_settings",
    word: "Settings",
    families: &["settings"],
    parents: &["model"],
    prefix: "RESULTS_SETTINGS_",
    statement: Some("RESULTS"),
    groups: &[Group {
        command: "output_control set results",
        creates: true,
        object: "",
        fields: &[
            Field::object("model_name", "model").current().doc("model the setting belongs to"),
            Field::on_off("create_results_file").doc("write the results file"),
            Field::on_off("formatted").doc("write it as text"),
            Field::on_off("accelerations").doc("include accelerations"),
            Field::on_off("applied_forces").doc("include applied forces"),
            Field::on_off("displacements").doc("include displacements"),
            Field::on_off("reaction_forces").doc("include reactions"),
            Field::on_off("velocities").doc("include velocities"),
            Field::on_off("data_structures").doc("include variables, arrays and the like"),
            Field::on_off("system_elements").doc("include equations"),
            Field::on_off("linear").doc("include linear results"),
            Field::on_off("floating_markers").doc("include floating markers"),
            Field::on_off("tire").doc("include tires"),
            Field::on_off("request").doc("include requests"),
            Field::on_off("friction_summary").doc("include a summary of friction"),
            Field::text("comment").doc("text kept in the results file"),
            Field::on_off("xrf").doc("write it as XML"),
            Field::integer("decimal_places").doc("decimals"),
            Field::on_off("round_off").doc("round numbers"),
            Field::integer("scientific_notation")
                .count(Count::exactly(2))
                .doc("powers of ten beyond which an exponent is written"),
            Field::integer("significant_figures").doc("significant digits"),
            Field::on_off("trailing_zeros").doc("keep zeros at the end"),
            Field::real("zero_threshold", Dimension::NONE).doc("numbers below are written as zero"),
            Field::integer("shift_width").doc("columns by which text is indented"),
            Field::object("resset_filter", "function").doc("function that picks the result sets"),
            Field::integer("flush_frequency").doc("outputs between two writes to disk"),
            Field::on_off("contact_incidents").doc("include contact incidents"),
            Field::on_off("node_incidents").doc("include node incidents"),
        ],
        rules: &[],
        doc: "what the results file holds; one set for each model, made by the first use",
    }],
};
