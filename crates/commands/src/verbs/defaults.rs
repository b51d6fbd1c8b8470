//! `defaults ...`: units, frames, current objects and other settings of the session.

use model::{CoordinateSystem, Sequence, Value};
use schema::{Count, Dimension, Field, UnitName, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry, name_generation,
    shared::{self, ANGLES, FORCES, LENGTHS, MASSES, TIMES},
};
use crate::{Interpreter, OnError, call::Call, interpreter::Flow, known, tree::Role};

type Outcome = Result<Flow, Vec<Diagnostic>>;

const SEQUENCES: &[&str] = &[
    "body123", "body231", "body312", "body132", "body213", "body321", "body121", "body131", "body212", "body232",
    "body313", "body323", "space123", "space231", "space312", "space132", "space213", "space321", "space121",
    "space131", "space212", "space232", "space313", "space323",
];

pub const UNITS: VerbEntry = entry(
    Verb {
        path: "defaults units",
        fields: &[
            Field::choice("length", LENGTHS).doc("unit of length"),
            Field::choice("angle", ANGLES).doc("unit of angles"),
            Field::choice("force", FORCES).doc("unit of force"),
            Field::choice("mass", MASSES).doc("unit of mass"),
            Field::choice("time", TIMES).doc("unit of time"),
            Field::choice("frequency", &["hz", "radians_sec"]).doc("unit of frequency"),
            Field::choice("system_of_units", &["mks", "mmks", "cgs", "ips"]).doc("several units at once"),
            Field::choice("coordinate_system_type", &["cartesian", "cylindrical", "spherical"])
                .doc("what three coordinates mean"),
            Field::choice("orientation_type", SEQUENCES).doc("what three angles mean"),
            Field::real("units_consistency_factor", Dimension::NONE)
                .doc("factor between force and mass times acceleration"),
            Field::text("axis_labels").doc("whether axes are named in full"),
        ],
        rules: &[],
        doc: "units and forms in which values are given and shown",
    },
    units,
);

fn units(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let mut units = *interpreter.database.units();
    if let Some(system) = interpreter.word_of(call, "system_of_units")? {
        let words = match system.as_str() {
            "mks" => ["meter", "kg", "newton"],
            "cgs" => ["cm", "gram", "dyne"],
            "ips" => ["inch", "pound_mass", "pound_force"],
            _ => ["mm", "kg", "newton"],
        };
        for (slot, word) in [&mut units.length, &mut units.mass, &mut units.force].into_iter().zip(words) {
            *slot = UnitName::find(word).unwrap_or(*slot);
        }
        units.consistency_factor = None;
    }
    for (name, slot) in [
        ("length", &mut units.length),
        ("angle", &mut units.angle),
        ("force", &mut units.force),
        ("mass", &mut units.mass),
        ("time", &mut units.time),
        ("frequency", &mut units.frequency),
    ] {
        if let Some(word) = interpreter.word_of(call, name)? {
            *slot = UnitName::find(&word).unwrap_or(*slot);
        }
    }
    if let Some(factor) = interpreter.number_argument(call, "units_consistency_factor")? {
        units.consistency_factor = Some(factor);
    }
    let before = interpreter.database.settings().clone();
    interpreter.database.set_units(units);
    if let Some(word) = interpreter.word_of(call, "coordinate_system_type")? {
        let system = match word.as_str() {
            "cylindrical" => CoordinateSystem::Cylindrical,
            "spherical" => CoordinateSystem::Spherical,
            _ => CoordinateSystem::Cartesian,
        };
        interpreter.database.change_settings(|s| s.coordinate_system = system);
    }
    if let Some(sequence) = interpreter.word_of(call, "orientation_type")?.and_then(|w| Sequence::named(&w)) {
        interpreter.database.change_settings(|s| s.sequence = sequence);
    }
    if *interpreter.database.settings() != before {
        warn_of_bare_numbers(interpreter, call);
    }
    Ok(Flow::Next)
}

/// Says which expressions mean something else from now on; they keep their values until they are
/// evaluated again.
fn warn_of_bare_numbers(interpreter: &mut Interpreter, call: &Call) {
    const NAMED: usize = 5;
    let found = expressions::with_another_meaning(&interpreter.database);
    if found.is_empty() {
        return;
    }
    let names: Vec<String> = found.iter().take(NAMED).map(|name| format!("`{name}`")).collect();
    let others = if found.len() > NAMED { format!(" and {} more", found.len() - NAMED) } else { String::new() };
    let (them, mean) = if found.len() == 1 { ("the expression", "means") } else { ("the expressions", "mean") };
    let warning = Diagnostic::warning(
        "expression/bare-numbers",
        format!("{them} of {}{others} {mean} something else in these units", names.join(", ")),
    )
    .at(call.span, "their numbers have no units")
    .note("values stay as they are until something that they depend on changes, or the model is written and read")
    .help("write units behind the numbers (`500mm`), or store values in place of expressions with `EVAL(...)`");
    interpreter.complain(vec![warning]);
}

pub const MODEL: VerbEntry = entry(
    Verb {
        path: "defaults model",
        fields: &[
            Field::object("model_name", "model").doc("current model"),
            Field::object("part_name", "body").doc("current part"),
            Field::object("point_mass_name", "point_mass").doc("current point mass"),
            Field::object("flexible_body_name", "flexible_body").doc("current flexible body"),
            Field::object("marker_name", "marker").doc("current marker"),
            Field::object("joint_name", "constraint").doc("current joint"),
            Field::object("geometry_name", "geometry").doc("current shape"),
        ],
        rules: &[],
        doc: "objects that stand in where a name is not given or not full",
    },
    current_objects,
);

fn current_objects(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    for (parameter, argument) in call.all() {
        let field = parameter.field;
        let draft = interpreter.read_value(call, &field, argument, None)?;
        if let Some(id) = draft.value.as_object() {
            interpreter.database.make_current(id);
        }
    }
    Ok(Flow::Next)
}

pub const COORDINATE_SYSTEM: VerbEntry = entry(
    Verb {
        path: "defaults coordinate_system",
        fields: &[Field::object("default_coordinate_system", "frame").doc("frame in which locations are read")],
        rules: &[],
        doc: "frame in which locations and orientations are read",
    },
    coordinate_system,
);

fn coordinate_system(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let Some(id) = interpreter.object_argument(call, "default_coordinate_system")? else {
        return Err(vec![call.missing(&["default_coordinate_system"])]);
    };
    interpreter.database.set_default_frame(Some(id));
    Ok(Flow::Next)
}

const PLANES: &[&str] = &[
    "x_axis_xy_plane",
    "x_axis_xz_plane",
    "y_axis_yz_plane",
    "y_axis_xy_plane",
    "z_axis_xz_plane",
    "z_axis_yz_plane",
    "y_axis_yx_plane",
    "x_axis_zx_plane",
    "z_axis_zx_plane",
    "z_axis_zy_plane",
];

pub const ORIENT_AXIS_AND_PLANE: VerbEntry = entry(
    Verb {
        path: "defaults orient_axis_and_plane",
        fields: &[Field::choice("axis_and_plane_setting", PLANES).doc("axis that is aimed, and plane")],
        rules: &[],
        doc: "which axis aiming parameters aim",
    },
    keep_words,
);

const SWITCH: &[&str] = &["on", "off", "no_opinion", "toggle"];

pub const ATTRIBUTES: VerbEntry = entry(
    Verb {
        path: "defaults attributes",
        fields: &[
            Field::choice("inheritance", &["top_down", "bottom_up"]).doc("whose attribute counts"),
            Field::choice("icon_visibility", SWITCH).doc("whether icons are drawn"),
            Field::choice("grid_visibility", SWITCH).doc("whether the grid is drawn"),
            Field::real("size_of_icons", Dimension::LENGTH).doc("size of icons"),
            Field::real("spacing_for_grid", Dimension::LENGTH).doc("distance of grid lines"),
            Field::choice("endcap_visibility", SWITCH).doc("whether ends of shapes are closed"),
            Field::new("screen_font", schema::Kind::File).doc("font on the screen"),
            Field::choice(
                "postscript_font",
                &[
                    "times_roman",
                    "helvetica",
                    "courier",
                    "times_bold",
                    "times_italic",
                    "times_bolditalic",
                    "helvetica_bold",
                    "helvetica_oblique",
                    "helvetica_boldoblique",
                    "courier_bold",
                    "courier_oblique",
                    "courier_boldoblique",
                ],
            )
            .doc("font on paper"),
            Field::real("dimming_factor", Dimension::NONE).doc("how much objects that are not meant fade"),
        ],
        rules: &[],
        doc: "how objects look unless they say otherwise",
    },
    keep_words,
);

pub const COMMAND_FILE: VerbEntry = entry(
    Verb {
        path: "defaults command_file",
        fields: &[
            Field::choice("on_error", &["continue_command", "ignore_command", "abort_file"])
                .doc("what happens after a command that failed"),
            Field::on_off("echo_commands").doc("write commands to the log"),
            Field::on_off("update_screen").doc("draw while a file is read"),
        ],
        rules: &[],
        doc: "how command files are read",
    },
    command_file,
);

fn command_file(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    match interpreter.word_of(call, "on_error")?.as_deref() {
        Some("continue_command") => interpreter.on_error = OnError::ContinueCommand,
        Some("ignore_command") => interpreter.on_error = OnError::IgnoreCommand,
        Some(_) => interpreter.on_error = OnError::AbortFile,
        None => {}
    }
    keep_words(interpreter, call)
}

pub const SOLVER: VerbEntry = entry(
    Verb {
        path: "defaults solver",
        fields: &[Field::on_off("compatibility_checking").doc("check what the solver supports before a run")],
        rules: &[],
        doc: "how models are checked for the solver",
    },
    noted,
);

pub const ADAMS_OUTPUT: VerbEntry = entry(
    Verb {
        path: "defaults adams_output",
        fields: &[
            Field::choice(
                "statement_order",
                &[
                    "markers_with_parts",
                    "markers_where_used",
                    "submodels_and_adamsid",
                    "submodels_and_objname",
                    "as_found_in_file",
                ],
            )
            .doc("order of statements in datasets"),
            Field::choice("arguments_per_line", &["single", "multiple"]).doc("one or more arguments a line"),
            Field::choice("text_case", &["upper", "lower", "mixed"]).doc("case of words"),
            Field::integer("indent_spaces").doc("spaces before continued lines"),
            Field::on_off("write_default_values").doc("also write arguments that have their default"),
            Field::integer("scientific_notation")
                .count(Count::exactly(2))
                .doc("powers of ten outside of which an exponent is written"),
            Field::on_off("trailing_zeros").doc("keep zeros at the end of decimals"),
            Field::integer("decimal_places").doc("decimals"),
            Field::real("zero_threshold", Dimension::NONE).doc("smaller numbers are written as 0"),
            Field::on_off("round_off").doc("round the last digit"),
            Field::integer("significant_figures").doc("digits"),
            Field::on_off("active_only").doc("leave inactive objects out"),
            Field::on_off("export_all_graphics").doc("write shapes the solver does not need"),
        ],
        rules: &[],
        doc: "how datasets are laid out",
    },
    noted,
);

/// Keeps settings that change nothing in Flexure, and says so.
fn noted(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let flow = keep_words(interpreter, call)?;
    shared::without_effect(interpreter, call, known::meaning(&call.path));
    Ok(flow)
}

/// Keeps settings as they were given, by parameter.
pub fn keep_words(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    for (parameter, argument) in call.all() {
        debug_assert_eq!(parameter.role, Role::Field);
        let field = parameter.field;
        let draft = interpreter.read_value(call, &field, argument, None)?;
        let text = match &draft.value {
            Value::Flag(flag) => match field.kind {
                schema::Kind::Boolean(yes, no) => (if *flag { yes } else { no }).to_string(),
                _ => flag.to_string(),
            },
            // Lengths are kept in metres, so that a change of units does not change them.
            Value::Number(x) => format!("{:?}", x * interpreter.database.units().factor(field.dimension)),
            other => crate::values::text_of(other, &interpreter.database),
        };
        interpreter.database.change_settings(|s| {
            s.words.insert(name_generation::key(&call.path, field.name), text);
        });
    }
    Ok(Flow::Next)
}
