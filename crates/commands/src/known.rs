//! The keywords of the Adams command tree as far as they are known: so that abbreviations resolve
//! as they do there, and so that a command Flexure does not execute is told apart from a misspelled
//! one and reported together with what its absence means.

/// Keywords that may follow a path; the path is empty for the first word of a command.
pub const KEYWORDS: &[(&str, &str)] = &[
    ("executive_control", "set create modify delete attributes copy"),
    ("executive_control copy", "sensor"),
    ("executive_control attributes", "sensor"),
    ("model", "create modify copy delete display merge verify generate_ids attributes assemble"),
    ("floating_marker", "create modify delete copy"),
    ("point", "create modify delete copy attributes"),
    ("geometry", "create modify delete copy attributes"),
    ("data_element", "create modify delete copy attributes"),
    ("measure", "create modify delete copy attributes"),
    ("material", "create modify delete copy"),
    ("function", "create modify delete"),
    ("library", "create modify delete copy"),
    ("output_control", "set create modify delete copy attributes"),
    ("output_control copy", "request femdata mrequest"),
    ("output_control attributes", "request femdata mrequest"),
    ("output_control create", "request femdata mrequest"),
    ("output_control modify", "request femdata mrequest"),
    ("output_control delete", "request femdata mrequest"),
    (
        "simulation multi_run",
        "design_study optimization doe preview_doe read_results plot_measure save set summarize tsf_sweep update",
    ),
    ("file binary", "read write"),
    ("file analysis", "read write"),
    ("file parasolid", "read write"),
    ("file request", "read write"),
    ("file results", "read write"),
    ("file graphics", "read write"),
    ("file text", "open write close"),
    (
        "numeric_results create",
        "absolute_value addition definite_integral differentiation division dynamic_polyline empty fft filter \
         interpolation linear_equation multiplication percent_difference scale spline sqrt_sum_of_squares \
         subtraction values zero",
    ),
    ("executive_control create", "sensor"),
    ("executive_control modify", "sensor"),
    (
        "",
        "model part marker floating_marker point geometry constraint force data_element measure \
         measure_display animation ude assembly clearance section callback executive_control output_control \
         submit optimize simulation check_messages graphic_results numeric_results plot3d xy_plots ptemplate \
         report contour_plot hotspots analysis multi_run_analysis plotcurve3d file view move defaults \
         display_attributes material contact hardcopy notes interface runtime_function panel highlight colors \
         macro variable function group entity library if elseif else end while for break continue return \
         info_window pause abort system stereo time language plugin list_info help undo exit \
         symmetry_relation quit stop debug",
    ),
    ("force", "create modify delete copy attributes"),
    ("force create", "direct body element_like"),
    ("force create element_like", "beam bushing field translational_spring_damper rotational_spring_damper friction"),
    ("force modify element_like", "beam bushing field translational_spring_damper rotational_spring_damper friction"),
    (
        "force create direct",
        "single_component_force force_vector torque_vector general_force multi_point_force modal_force \
         fe_load",
    ),
    ("constraint", "create modify delete copy attributes"),
    (
        "constraint create",
        "joint complex_joint primitive_joint higher_pair_contact motion_generator general_constraint \
         user_defined",
    ),
    (
        "constraint create joint",
        "rigid translational revolute cylindrical universal spherical planar rackpin screw convel fixed hooke",
    ),
    (
        "constraint create primitive_joint",
        "at_point inline inplane orientation parallel_axis perpendicular point_point",
    ),
    ("part", "create modify merge delete copy display attributes"),
    (
        "part create",
        "rigid_body fe_part flexible_body external_system point_mass equation new_ground stress_body particle \
         fly_wheel elastic_body",
    ),
    ("part create rigid_body", "name_and_position mass_properties initial_velocity"),
    ("marker", "create modify delete copy attributes delete_unused"),
    ("geometry create", "point curve shape feature"),
    (
        "geometry create shape",
        "block cylinder ellipsoid frustum revolution extrusion torus link csg plate shell nurb_surf plane \
         face solid solid_shell spring_damper force picture gcontact",
    ),
    ("geometry create curve", "outline arc circle ellipse bspline chain polyline nurb_curve point_trace curve_trace"),
    ("data_element create", "curve spline variable array matrix plant string"),
    ("data_element create array", "x_state_array u_input_array y_output_array ic_array general_array"),
    ("data_element create matrix", "full sparse file"),
    ("measure create", "angle pt2pt point range query orient object function computed"),
    ("simulation", "single_run multi_run script set configuration"),
    (
        "simulation single_run",
        "eigensolution statematrix mkb vibration assemble equilibrium transient scripted reset save set \
         replay rerun subroutine debugger nastran_export",
    ),
    ("simulation script", "create modify copy read_acf write_acf delete"),
    (
        "executive_control set",
        "easy_dynamics dynamics_parameters numerical_integration_parameters integrator_parameters \
         equilibrium_parameters kinematics_parameters solver_parameters preferences \
         initial_conditions_parameters advanced",
    ),
    ("output_control set", "debug madata output results"),
    ("variable", "create set modify delete save restore"),
    ("macro", "create modify delete read write begin_record end_record debug"),
    ("group", "create modify delete copy empty objects attributes"),
    ("group objects", "add remove delete copy rename attributes"),
    ("entity", "modify delete copy attributes"),
    (
        "defaults",
        "analysis model plot page view container expert_fields prompting_level command_file units \
         coordinate_system name_generation orient_axis_and_plane attributes animation_settings \
         note_attributes plt_attributes page_attributes plotting plot_builder report hardcopy force_graphics \
         vector_plots adams_output geometry graphics lights function_references results contact \
         sprintf_precision solver stereo file_cache_purge interface nlfe_nastran_files icon_naming",
    ),
    ("defaults name_generation", "layout model part marker geometry constraint force data_element postprocessing"),
    (
        "file",
        "adams_data_set binary cache command python enhanced_data_set wavefront analysis request geometry \
         graphics results iges stereo_lithography render testdata spread_sheet table shell log_file fea_loads \
         notebook text parasolid vrml postprocessing dac rpc csv html mnfxform romax temporary_settings",
    ),
    ("file adams_data_set", "read merge write"),
    ("undo", "forward backward begin_block end_block flush set"),
    (
        "list_info",
        "model part marker geometry constraint force data_element executive_control output_control analysis \
         plots curves sub_plots results eigen_values linear_mode_shapes files binary views defaults notes \
         macro variable group entity name_generation measure aggregate_mass topology names statistics undo \
         triglue system_configuration memory_usage",
    ),
    ("numeric_results", "create modify transform read_from_file write delete component list_info"),
    ("move", "control_panel object translation rotation mirror"),
    ("analysis", "create modify reload_files collate_contacts delete"),
    ("contact", "create modify delete copy"),
    ("force modify", "direct body element_like"),
    (
        "force modify direct",
        "single_component_force force_vector torque_vector general_force multi_point_force modal_force \
         fe_load",
    ),
    (
        "constraint modify",
        "joint complex_joint primitive_joint higher_pair_contact motion_generator general_constraint \
         user_defined",
    ),
    (
        "constraint modify joint",
        "rigid translational revolute cylindrical universal spherical planar rackpin screw convel fixed hooke",
    ),
    (
        "constraint modify primitive_joint",
        "at_point inline inplane orientation parallel_axis perpendicular point_point",
    ),
    (
        "part modify",
        "rigid_body fe_part flexible_body external_system point_mass equation new_ground stress_body particle \
         fly_wheel elastic_body",
    ),
    ("part modify rigid_body", "name_and_position mass_properties initial_velocity"),
    ("geometry modify", "point curve shape feature"),
    (
        "geometry modify shape",
        "block cylinder ellipsoid frustum revolution extrusion torus link csg plate shell nurb_surf plane \
         face solid solid_shell spring_damper force picture gcontact",
    ),
    ("geometry modify curve", "outline arc circle ellipse bspline chain polyline nurb_curve point_trace curve_trace"),
    ("data_element modify", "curve spline variable array matrix plant string"),
    ("data_element modify array", "x_state_array u_input_array y_output_array ic_array general_array"),
    ("data_element modify matrix", "full sparse file"),
    ("measure modify", "angle pt2pt point range query orient object function computed"),
];

/// Commands of Adams that are not known in full, and below which Flexure has some of its own: what is not
/// one of these is skipped like any command that is known by name alone.
pub const OPEN: &[&str] = &["section", "section create", "section modify", "view"];

/// What it means that a command is not executed, by the longest path that fits.
pub const MEANINGS: &[(&str, &str)] = &[
    ("view", "only the display in Adams View is concerned"),
    ("interface", "only dialogs and menus of Adams View are concerned"),
    ("panel", "only dialogs and menus of Adams View are concerned"),
    ("callback", "only dialogs and menus of Adams View are concerned"),
    ("xy_plots", "no curve is drawn; results are unaffected"),
    ("plot3d", "no curve is drawn; results are unaffected"),
    ("plotcurve3d", "no curve is drawn; results are unaffected"),
    ("contour_plot", "nothing is drawn; results are unaffected"),
    ("animation", "only the display in Adams View is concerned"),
    ("colors", "only the display in Adams View is concerned"),
    ("highlight", "only the display in Adams View is concerned"),
    ("display_attributes", "only the display in Adams View is concerned"),
    ("hardcopy", "nothing is printed"),
    ("report", "no report is written"),
    ("notes", "the note is missing from the model"),
    ("measure_display", "only the display in Adams View is concerned"),
    ("geometry", "the shape is not drawn; masses taken from geometry may be missing"),
    ("contact", "the contact exerts no force: a simulation of this model differs from Adams"),
    ("force", "the force does not act: a simulation of this model differs from Adams"),
    ("constraint", "the constraint does not act: a simulation of this model differs from Adams"),
    ("part", "the part is missing: a simulation of this model differs from Adams"),
    ("floating_marker", "what refers to this marker cannot be created"),
    ("data_element", "what refers to this data element cannot be evaluated"),
    ("ude", "the user-defined element is missing: a simulation of this model may differ from Adams"),
    ("section", "the section is not made; `section create rectangle` and its like make cross sections of beams"),
    ("clearance", "no clearance is computed"),
    ("optimize", "nothing is optimised"),
    ("simulation", "nothing is simulated by this command"),
    ("simulation set", "the solver of Flexure is used as it is"),
    ("executive_control", "the solver uses its own setting"),
    ("executive_control create sensor", "the sensor does not act: a simulation of this model may differ from Adams"),
    ("executive_control modify sensor", "the sensor does not act: a simulation of this model may differ from Adams"),
    ("output_control", "the output is not written"),
    ("numeric_results", "the result is not computed"),
    ("graphic_results", "only the display in Adams View is concerned"),
    ("file", "nothing is read or written by this command"),
    ("defaults", "the setting has no effect in Flexure"),
    ("plugin", "what the plug-in provides is not available"),
    ("library", "what the library would own has no place"),
    ("group", "the group is unchanged"),
    ("list_info", "nothing is listed"),
    ("move", "nothing is moved: the model differs from Adams"),
    ("system", "no program is started"),
    ("function", "the function is not defined"),
    ("help", "see the manual of Flexure"),
    ("measure", "the measure is not recorded"),
    ("language", "only messages of Adams View are concerned"),
    ("ptemplate", "no curve is drawn; results are unaffected"),
    ("hotspots", "nothing is drawn; results are unaffected"),
    ("info_window", "only the display in Adams View is concerned"),
    ("stereo", "only the display in Adams View is concerned"),
    ("check_messages", "only messages of Adams View are concerned"),
    ("time", "only the display in Adams View is concerned"),
    ("debug", "only the search for faults in Adams View is concerned"),
    ("assembly", "what the assembly would hold is missing: a simulation of this model differs from Adams"),
    ("symmetry_relation", "the objects are not tied to each other: changing one leaves the other as it is"),
    ("runtime_function", "the function is not defined"),
    ("submit", "no job is started"),
    ("multi_run_analysis", "no set of runs is made"),
    ("analysis", "results belong to the files a run writes, not to objects of the session"),
    ("pause", "the run goes on at once"),
    ("executive_control set", "the solver uses its own setting"),
    ("move control_panel", "only dialogs and menus of Adams View are concerned"),
    ("file log_file", "the log goes on as it was begun"),
    ("file binary", "binary databases of Adams cannot be read or written; `file command write` writes a model"),
    ("file analysis", "result files are not read into the session"),
    ("file request", "result files are not read into the session"),
    ("file results", "result files are not read into the session"),
    ("file graphics", "result files are not read into the session"),
    ("file parasolid", "the solids are missing; masses taken from geometry may be missing"),
    ("defaults adams_output", "datasets are written in one layout"),
    ("defaults solver", "`model verify` always says what the solver does not support"),
    ("simulation single_run set", "runs are not shown while they go on"),
    ("simulation single_run save", "every run keeps its results under the name of its analysis"),
    ("simulation single_run statematrix", "the matrices are not computed; `eigensolution` gives the modes"),
    ("simulation multi_run", "no run is made; a loop of `variable modify` and `simulation` commands does the same"),
    ("numeric_results write", "no numbers are written; a run writes all of them to its result files"),
    ("numeric_results read_from_file", "the numbers are missing; a spline may hold them for a simulation"),
    ("function", "expressions that call the function fail"),
];

/// What the absence of a command means, from the longest path that fits.
pub fn meaning(path: &str) -> &'static str {
    MEANINGS
        .iter()
        .filter(|(known, _)| path == *known || path.strip_prefix(known).is_some_and(|rest| rest.starts_with(' ')))
        .max_by_key(|(known, _)| known.len())
        .map_or("the command changes nothing", |(_, note)| note)
}

/// Families of commands that only concern what Adams View shows, or files and results that Flexure
/// does not have: skipping one means the same as skipping another, so they are named together.
const ALIKE: &[&str] = &[
    "view",
    "interface",
    "panel",
    "callback",
    "xy_plots",
    "plot3d",
    "plotcurve3d",
    "ptemplate",
    "contour_plot",
    "hotspots",
    "animation",
    "colors",
    "highlight",
    "display_attributes",
    "hardcopy",
    "report",
    "measure_display",
    "graphic_results",
    "info_window",
    "stereo",
    "language",
    "plugin",
    "debug",
    "time",
    "check_messages",
    "defaults",
];

/// The kind under which a skipped command is reported: its family where all of it is alike,
/// otherwise the command itself.
pub fn kind(path: &str) -> &str {
    let family = path.split(' ').next().unwrap_or(path);
    // Assignments to settings of the display (`.sim_preferences.alert = ...`) by their object.
    if let Some(name) = path.strip_prefix('.') {
        let end = name.find(['.', ' ']).map_or(path.len(), |at| at + 1);
        return &path[..end];
    }
    if ALIKE.contains(&family) { family } else { path }
}
