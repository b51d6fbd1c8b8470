//! Every class of shapes, data, measures and the like: made, changed, renamed, copied, written, read
//! back and deleted by commands.

use flexure_commands::{Interpreter, OnError, Report};
use model::ObjectId;

const SETUP: &str = "model create model_name = m
part create rigid_body name_and_position part_name = .m.p location = 100,0,0
marker create marker_name = .m.p.a location = 0,0,0 relative_to = .m.p
marker create marker_name = .m.p.b location = 10,0,0 relative_to = .m.p
marker create marker_name = .m.p.c location = 0,10,0 relative_to = .m.p
marker create marker_name = .m.ground.o location = 0,0,0 relative_to = .m.ground
geometry create curve circle circle_name = .m.p.RING center_marker = .m.p.a radius = 2
force create direct single_component_force single_component_force_name = .m.push i_marker_name = .m.p.a &
   j_marker_name = .m.ground.o action_only = off type_of_freedom = translational function = \"0\"
data_element create matrix full matrix_name = .m.points row_count = 2 column_count = 3 values = 1,2,3,4,5,6
data_element create variable variable_name = .m.signal function = \"time\"
measure create function measure_name = .m.watched function = \"2*time\" create_measure_display = no
defaults coordinate_system default_coordinate_system = .m.p
";

/// Class, the words behind `create`, the parameter that names it and where it is made, what it is
/// made with, what is changed, and lines that must stand in the export then.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

const SHAPES: &[Case] = &[
    (
        "link",
        "geometry create shape link",
        "link_name = .m.p.",
        "i_marker=.m.p.a j_marker=.m.p.b width=2 depth=1",
        "width=3",
        &["width = 3.0", "depth = 1.0"],
    ),
    (
        "cylinder",
        "geometry create shape cylinder",
        "cylinder_name = .m.p.",
        "center_marker=.m.p.a length=5 radius=2",
        "radius=3",
        &["radius = 3.0", "length = 5.0"],
    ),
    (
        "frustum",
        "geometry create shape frustum",
        "frustum_name = .m.p.",
        "center_marker=.m.p.a length=5 top_radius=2",
        "bottom_radius=4",
        &["top_radius = 2.0", "bottom_radius = 4.0"],
    ),
    (
        "block",
        "geometry create shape block",
        "block_name = .m.p.",
        "corner_marker=.m.p.a diag_corner_coords=1,2,3",
        "diag=3,2,1",
        &["diag_corner_coords = 3.0, 2.0, 1.0"],
    ),
    (
        "ellipsoid",
        "geometry create shape ellipsoid",
        "ellipsoid_name = .m.p.",
        "center_marker=.m.p.a x_scale_factor=2",
        "z_sc=5",
        &["z_scale_factor = 5.0"],
    ),
    (
        "torus",
        "geometry create shape torus",
        "torus_name = .m.p.",
        "center_marker=.m.p.a major_radius=4",
        "minor=0.5",
        &["major_radius = 4.0", "minor_radius = 0.5"],
    ),
    (
        "plate",
        "geometry create shape plate",
        "plate_name = .m.p.",
        "marker_name=.m.p.a,.m.p.b,.m.p.c width=1 radius=2",
        "width=3",
        &["marker_name = .m.p.a, .m.p.b, .m.p.c", "width = 3.0"],
    ),
    (
        "arc",
        "geometry create curve arc",
        "arc_name = .m.p.",
        "center_marker=.m.p.a radius=4 close=chord",
        "angle_extent=30",
        &["angle_extent = 30.0d", "close = chord"],
    ),
    (
        "circle",
        "geometry create curve circle",
        "circle_name = .m.p.",
        "center_marker=.m.p.a radius=4",
        "segment_count=30",
        &["segment_count = 30"],
    ),
    (
        "polyline",
        "geometry create curve polyline",
        "polyline_name = .m.p.",
        "location=1,2,3,4,5,6,7,8,9",
        "close=yes path_curve=.m.p.RING",
        &["location = 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0", "close = yes", "path_curve = .m.p.RING"],
    ),
    (
        "force_graphic",
        "geometry create shape force",
        "force_name = .m.p.",
        "applied_at_marker_name=.m.p.a",
        "force_element_name=.m.push",
        &["force_element_name = .m.push"],
    ),
    (
        "spring_damper_graphic",
        "geometry create shape spring_damper",
        "spring_damper_name = .m.p.",
        "i_marker_name=.m.p.a j_marker_name=.m.ground.o",
        "coil_count=7",
        &["coil_count = 7"],
    ),
    (
        "extrusion",
        "geometry create shape extrusion",
        "extrusion_name = .m.p.",
        "reference_marker=.m.p.b points_for_profile=0,0,0,2,0,0,2,1,0,0,0,0 length_along_z_axis=3 relative_to=.m.p",
        "analytical=yes",
        &[
            "analytical = yes",
            "points_for_profile = -10.0, 0.0, 0.0, -8.0, 0.0, 0.0, -8.0, 1.0, 0.0, -10.0, 0.0, 0.0",
            "length_along_z_axis = 3.0",
        ],
    ),
    (
        "revolution",
        "geometry create shape revolution",
        "revolution_name = .m.p.",
        "reference_marker=.m.p.a points_for_profile=1,0,0,2,0,0,2,0,3,1,0,0 angle_extent=180",
        "number_of_sides=7",
        &["angle_extent = 180.0d", "number_of_sides = 7"],
    ),
    (
        "plane",
        "geometry create shape plane",
        "plane_name = .m.p.",
        "ref_marker_name=.m.p.a x_minimum=0 x_maximum=1 y_minimum=0 y_maximum=2",
        "x_min=-1",
        &["x_minimum = -1.0", "y_maximum = 2.0"],
    ),
    (
        "shell",
        "geometry create shape shell",
        "shell_name = .m.p.",
        "file_name=\"bucket.shl\"",
        "reference_marker=.m.p.a",
        &["reference_marker = .m.p.a", "file_name = \"bucket.shl\"", "wireframe_only = no"],
    ),
    (
        "ellipse",
        "geometry create curve ellipse",
        "ellipse_name = .m.p.",
        "center_marker=.m.p.a major_radius=4 end_angle=90",
        "minor_radius=2",
        &["major_radius = 4.0", "minor_radius = 2.0", "end_angle = 90.0d"],
    ),
    (
        "bspline",
        "geometry create curve bspline",
        "bspline_name = .m.p.",
        "ref_profile_name=.m.p.RING ref_marker_name=.m.p.a",
        "num=12 closed=yes",
        &["ref_profile_name = .m.p.RING", "closed = yes", "num_new_pts = 12"],
    ),
    (
        "outline",
        "geometry create curve outline",
        "outline_name = .m.p.",
        "marker_name=.m.p.a,.m.p.b,.m.p.c close=yes",
        "visibility_between_markers=on,off,on",
        &["marker_name = .m.p.a, .m.p.b, .m.p.c", "visibility_between_markers = on, off, on"],
    ),
    (
        "geometry_point",
        "geometry create point",
        "point_name = .m.p.",
        "ref_marker_name=.m.p.a",
        "ref_marker_name=.m.p.b",
        &["ref_marker_name = .m.p.b"],
    ),
];

const DATA: &[Case] = &[
    (
        "spline",
        "data_element create spline",
        "spline_name = .m.",
        "x=1,2,3,4 y=0,1,4,9 linear_extrapolate=yes",
        "y=1,1,1,1",
        &["x = 1.0, 2.0, 3.0, 4.0", "y = 1.0, 1.0, 1.0, 1.0", "linear_extrapolate = yes"],
    ),
    (
        "curve_element",
        "data_element create curve",
        "curve_name = .m.",
        "matrix_name=.m.points tension=0.05 interpolation_order=4",
        "fit_type=control_points",
        &["matrix_name = .m.points", "fit_type = control_points", "closed = no"],
    ),
    (
        "array_general",
        "data_element create array general_array",
        "array_name = .m.",
        "numbers=1,2",
        "numbers=1,2,3 size=3",
        &["size = 3", "numbers = 1.0, 2.0, 3.0"],
    ),
    (
        "array_ic",
        "data_element create array ic_array",
        "array_name = .m.",
        "numbers=0,0 size=2",
        "numbers=0,1",
        &["numbers = 0.0, 1.0"],
    ),
    ("array_x", "data_element create array x_state_array", "array_name = .m.", "size=2", "size=4", &["size = 4"]),
    ("array_y", "data_element create array y_output_array", "array_name = .m.", "size=2", "size=4", &["size = 4"]),
    (
        "array_u",
        "data_element create array u_input_array",
        "array_name = .m.",
        "variable_name=.m.signal",
        "size=1",
        &["size = 1", "variable_name = .m.signal"],
    ),
    (
        "matrix_full",
        "data_element create matrix full",
        "matrix_name = .m.",
        "values=1,2,3,4 row_count=2 column_count=2",
        "input_order=by_row",
        &["input_order = by_row", "values = 1.0, 2.0, 3.0, 4.0"],
    ),
    (
        "matrix_sparse",
        "data_element create matrix sparse",
        "matrix_name = .m.",
        "row_index=1,2 column_index=1,2 values=5,6",
        "values=7,8",
        &["row_index = 1, 2", "values = 7.0, 8.0"],
    ),
    (
        "matrix_file",
        "data_element create matrix file",
        "matrix_name = .m.",
        "file_name=\"m.mat\" name_of_matrix_in_file=\"A\"",
        "units=\"length\"",
        &["file_name = \"m.mat\"", "name_of_matrix_in_file = \"A\"", "units = \"length\""],
    ),
    (
        "string",
        "data_element create string",
        "string_name = .m.",
        "string=\"one\"",
        "string=\"two\"",
        &["string = \"two\""],
    ),
    (
        "solver_variable",
        "data_element create variable",
        "variable_name = .m.",
        "function=\"DX(.m.p.a)\"",
        "initial_condition=3",
        &["initial_condition = 3.0", "function = \"DX(.m.p.a)\""],
    ),
];

const OTHERS: &[Case] = &[
    (
        "request",
        "output_control create request",
        "request_name = .m.",
        "f2=\"time\" results_name=\"set\"",
        "comment=\"all\" variable_name=.m.signal",
        &["f2 = \"time\"", "comment = \"all\"", "variable_name = .m.signal"],
    ),
    (
        "measure_pt2pt",
        "measure create pt2pt",
        "measure_name = .m.",
        "from_point=.m.p.a to_point=.m.p.b characteristic=translational_velocity component=x_component",
        "component=mag_component",
        &["component = mag_component"],
    ),
    (
        "measure_object",
        "measure create object",
        "measure_name = .m.",
        "object=.m.p characteristic=cm_position component=x_component",
        "from_first=yes",
        &["object = .m.p", "from_first = yes"],
    ),
    (
        "measure_function",
        "measure create function",
        "measure_name = .m.",
        "function=\"DX(.m.p.a)\"",
        "units=\"length\"",
        &["function = \"DX(.m.p.a)\"", "units = \"length\""],
    ),
    (
        "measure_point",
        "measure create point",
        "measure_name = .m.",
        "point=.m.p.a characteristic=translational_velocity component=x_component",
        "legend=\"v\"",
        &["point = .m.p.a", "legend = \"v\""],
    ),
    (
        "measure_angle",
        "measure create angle",
        "measure_name = .m.",
        "first_point=.m.p.b middle_point=.m.p.a last_point=.m.p.c",
        "last_point=.m.ground.o",
        &["middle_point = .m.p.a", "last_point = .m.ground.o"],
    ),
    (
        "measure_orient",
        "measure create orient",
        "measure_name = .m.",
        "to_frame=.m.p.a characteristic=euler_angles component=angle_1_component",
        "characteristic=body_3_1_2 from_frame=.m.ground",
        &["characteristic = body_3_1_2", "from_frame = .m.ground"],
    ),
    (
        "measure_computed",
        "measure create computed",
        "measure_name = .m.",
        "text_of_expression=\"2 * .m.watched\"",
        "units=\"length\"",
        &["text_of_expression = \"2 * .m.watched\"", "units = \"length\""],
    ),
    (
        "measure_range",
        "measure create range",
        "measure_name = .m.",
        "type=average of_measure_name=.m.watched",
        "type=maximum",
        &["type = maximum", "of_measure_name = .m.watched"],
    ),
    (
        "measure_query",
        "measure create query",
        "measure_name = .m.",
        "gui_driver_name=.dialog.slider",
        "delay_time=2",
        &["gui_driver_name = \".dialog.slider\"", "delay_time = 2.0"],
    ),
    (
        "script",
        "simulation script create",
        "sim_script_name = .m.",
        "solver_commands=\"! one\",\"simulate/transient\"",
        "comments=\"what\"",
        &["solver_commands = \"! one\", \"simulate/transient\"", "comments = \"what\""],
    ),
    (
        "sensor",
        "executive_control create sensor",
        "sensor_name = .m.",
        "compare=ge value=5 codgen=off function=\"DM(.m.p.a)\"",
        "evaluate=\"time\" halt=off",
        &[
            "compare = ge",
            "value = 5.0",
            "codgen = off",
            "halt = off",
            "evaluate = \"time\"",
            "function = \"DM(.m.p.a)\"",
        ],
    ),
    (
        "function",
        "function create",
        "function_name = .m.",
        "text_of_expression=\"x * 2\" argument_names=\"x\" category=math",
        "type=integer",
        &["text_of_expression = \"x * 2\"", "argument_names = \"x\"", "type = integer", "category = math"],
    ),
];

fn session() -> Interpreter {
    let mut interpreter = Interpreter::new(elements::registry());
    interpreter.on_error = OnError::IgnoreCommand;
    quiet(&interpreter.run_text("setup", SETUP));
    interpreter
}

#[track_caller]
fn quiet(report: &Report) {
    assert!(report.diagnostics.is_empty(), "{:#?}", report.diagnostics);
}

fn find(interpreter: &Interpreter, name: &str, class: &str) -> Option<ObjectId> {
    interpreter.database.find(name, class)
}

fn export(interpreter: &Interpreter) -> String {
    interpreter.write_model(interpreter.database.find(".m", "model").unwrap())
}

/// Makes, changes, renames, copies, writes, reads and deletes; gives the lines that are not written.
fn lives(case: &Case) -> Vec<String> {
    let mut missing = Vec::new();
    let (class, create, names, made, changed, lines) = *case;
    let (parameter, place) = names.split_once(" = ").unwrap();
    let full = |name: &str| format!("{place}{name}");
    let mut i = session();
    let before = export(&i);
    quiet(&i.execute(&format!("{create} {parameter} = {place}ONE {made}")));
    assert!(find(&i, &full("ONE"), class).is_some(), "{class} is not made");
    let modify = create.replace(" create", " modify");
    quiet(&i.execute(&format!("{modify} {parameter} = {place}ONE {changed}")));
    quiet(&i.execute(&format!("{modify} {parameter} = {place}ONE new_{parameter} = {place}TWO")));
    assert!(find(&i, &full("ONE"), class).is_none() && find(&i, &full("TWO"), class).is_some(), "{class}");

    let family = ["geometry", "data_element"].into_iter().find(|f| create.starts_with(f)).unwrap_or("entity");
    quiet(&i.execute(&format!("{family} copy {family}_name = {place}TWO new_{family}_name = {place}THREE")));
    assert!(find(&i, &full("THREE"), class).is_some(), "{class} is not copied");
    if class != "script" && class != "function" && class != "sensor" && class != "request" {
        quiet(&i.execute(&format!("entity attributes entity_name = {place}TWO color = RED active = off")));
    }

    let written = export(&i);
    for line in lines {
        // The object and its copy, beside what was there before.
        let lines_of = |text: &str| text.lines().filter(|l| l.trim_end_matches(['&', ' ']).trim() == *line).count();
        if lines_of(&written) != lines_of(&before) + 2 {
            let near: Vec<&str> =
                written.lines().filter(|l| l.contains(line.split(' ').next().unwrap_or(line))).collect();
            missing.push(format!("{class}: no two `{line}` but {near:#?}"));
        }
    }
    let mut second = Interpreter::new(elements::registry());
    let read = second.run_text("export", &written);
    let said: Vec<&String> = read.diagnostics.iter().map(|d| &d.message).collect();
    assert!(!read.has_errors() && read.skipped <= 1, "{class}: {said:#?}\n{written}");
    assert_eq!(export(&second), written, "{class}");

    let family = if create.starts_with("measure") { "measure" } else { family };
    quiet(&i.execute(&format!("{family} delete {family}_name = {place}TWO, {place}THREE")));
    assert_eq!(export(&i), before, "{class} leaves something behind");
    missing
}

#[track_caller]
fn all_live(cases: &[Case]) {
    let missing: Vec<String> = cases.iter().flat_map(lives).collect();
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// Truth: what a command gives is what is written; an export reads back to the same export.
#[test]
fn shapes_live_as_objects() {
    all_live(SHAPES);
}

#[test]
fn data_elements_live_as_objects() {
    all_live(DATA);
}

#[test]
fn measures_sensors_and_functions_live_as_objects() {
    all_live(OTHERS);
}

#[test]
fn no_class_of_these_families_is_left_out() {
    let covered: Vec<&str> = [SHAPES, DATA, OTHERS].concat().iter().map(|c| c.0).collect();
    for class in elements::registry().classes {
        if class.is("geometry") || class.is("data_element") {
            assert!(covered.contains(&class.id), "{} has no line in the table", class.id);
        }
    }
}

#[test]
fn an_analysis_is_made_renamed_and_deleted() {
    let mut i = session();
    quiet(&i.execute("analysis create analysis_name = .m.run"));
    quiet(&i.execute("analysis modify analysis_name = .m.run new_analysis_name = .m.first"));
    let written = export(&i);
    let mut second = Interpreter::new(elements::registry());
    assert!(!second.run_text("export", &written).has_errors());
    assert_eq!(export(&second), written);
    quiet(&i.execute("analysis delete analysis_name = .m.first"));
    assert!(find(&i, ".m.first", "analysis").is_none());
}

/// What a command names stands before it in an export, whatever the order of creation was.
#[test]
fn data_is_written_in_an_order_that_reads_back() {
    let mut i = session();
    quiet(&i.run_text(
        "order",
        "data_element create array u_input_array array_name = .m.inputs variable_name = .m.signal
data_element create variable variable_name = .m.later function = \"1\"
data_element modify array u_input_array array_name = .m.inputs variable_name = .m.later, .m.signal
data_element create matrix full matrix_name = .m.recorded result_set_component_names = .m.watched
geometry create curve polyline polyline_name = .m.p.FIRST location = 0,0,0,1,0,0
geometry create curve circle circle_name = .m.p.LAST center_marker = .m.p.a radius = 1
geometry modify curve polyline polyline_name = .m.p.FIRST path_curve = .m.p.LAST
",
    ));
    let written = export(&i);
    let mut second = Interpreter::new(elements::registry());
    let read = second.run_text("export", &written);
    assert!(!read.has_errors() && read.skipped <= 1, "{:#?}\n{written}", read.diagnostics);
    assert_eq!(export(&second), written);
    let at = |text: &str| written.find(text).unwrap_or_else(|| panic!("no `{text}` in\n{written}"));
    assert!(at("variable_name = .m.later") < at("array_name = .m.inputs"));
    assert!(at("measure_name = .m.watched") < at("matrix_name = .m.recorded"));
    assert!(at("array_name = .m.inputs") < at(" Rigid Parts "));
}

/// A function that reads data follows when the data is renamed, and is refused by a run, by name.
#[test]
fn functions_follow_the_data_they_read() {
    let mut i = session();
    quiet(&i.execute("force modify direct single_component_force single_component_force_name = .m.push function = \"VARVAL(.m.signal)\""));
    quiet(&i.execute("data_element modify variable variable_name = .m.signal new_variable_name = .m.command"));
    assert!(export(&i).contains("function = \"VARVAL(.m.command)\""));
    assert_eq!(i.execute("data_element delete data_element_name = .m.command").failed, 1);
}
