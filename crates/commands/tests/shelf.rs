//! Every class of parts, constraints, forces, contacts and equations: its objects are created,
//! modified, renamed, written and read back, and take part in the commands of their families.

use flexure_commands::{Interpreter, OnError, Report};

const FIXTURE: &str = "
model create model_name = m
part create rigid_body name_and_position part_name = .m.p location = 100,0,0
part create rigid_body name_and_position part_name = .m.q location = 200,0,0
marker create marker_name = .m.p.a location = 0,0,0
marker create marker_name = .m.p.b location = 10,0,0
marker create marker_name = .m.q.c location = 0,0,0
floating_marker create floating_marker_name = .m.q.f
geometry create shape block block_name = .m.p.box corner_marker = .m.p.a diag_corner_coords = 1,2,3
geometry create shape block block_name = .m.q.box corner_marker = .m.q.c diag_corner_coords = 1,2,3
constraint create joint revolute joint_name = .m.j1 i_marker_name = .m.p.a j_marker_name = .m.q.c
constraint create joint revolute joint_name = .m.j2 i_marker_name = .m.p.b j_marker_name = .m.q.c
";

/// A class: the command that makes one object without its name, what is then changed, and a line of
/// the export that shows the change.
struct Case {
    command: &'static str,
    object: &'static str,
    given: &'static str,
    change: &'static str,
    shown: &'static str,
}

const fn case(
    command: &'static str,
    object: &'static str,
    given: &'static str,
    change: &'static str,
    shown: &'static str,
) -> Case {
    Case { command, object, given, change, shown }
}

const ENDS: &str = "i_marker_name = .m.p.a j_marker_name = .m.q.c";

const CASES: &[Case] = &[
    case("floating_marker create", "floating_marker_name", "", "adams_id = 17", "adams_id = 17"),
    case("constraint create joint convel", "joint_name", ENDS, "i_marker_name = .m.p.b", "i_marker_name = .m.p.b"),
    case(
        "constraint create joint rackpin",
        "joint_name",
        "i_marker_name = .m.p.a j_marker_name = .m.q.c diameter_of_pitch = 20",
        "diameter_of_pitch = -30",
        "diameter_of_pitch = -30.0",
    ),
    case(
        "constraint create joint screw",
        "joint_name",
        "i_marker_name = .m.p.a j_marker_name = .m.q.c pitch = 2",
        "pitch = (3mm)",
        "pitch = (3mm)",
    ),
    case("constraint create primitive_joint point_point", "jprim_name", ENDS, "offset = 4", "offset = 4.0"),
    case(
        "constraint create complex_joint coupler",
        "coupler_name",
        "joint_name = .m.j1, .m.j2 type_of_freedom = rot_rot motion_multipliers = 1, 18",
        "motion_multipliers = 1, 20",
        "motion_multipliers = 1.0, 20.0",
    ),
    case(
        "constraint create complex_joint gear",
        "gear_name",
        "joint_name = .m.j1, .m.j2 common_velocity_marker = .m.q.c",
        "common_velocity_marker = .m.p.b",
        "common_velocity_marker = .m.p.b",
    ),
    case(
        "constraint create general_constraint",
        "general_constraint_name",
        "",
        "function = \"DM(.m.p.a)-2\"",
        "DM(.m.p.a)-2",
    ),
    case(
        "constraint create user_defined",
        "user_constraint_name",
        "user_function = 1, 2",
        "routine = \"lib::entry\"",
        "routine = \"lib::entry\"",
    ),
    case("force create element_like bushing", "bushing_name", ENDS, "stiffness = 1, 2, 3", "stiffness = 1.0, 2.0, 3.0"),
    case("force create element_like field", "field_name", ENDS, "formulation = nonlinear", "formulation = nonlinear"),
    case(
        "force create element_like translational_spring_damper",
        "spring_damper_name",
        ENDS,
        "preload = 5",
        "preload = 5.0",
    ),
    case(
        "force create element_like rotational_spring_damper",
        "spring_damper_name",
        ENDS,
        "displacement_at_preload = 30",
        "displacement_at_preload = 30.0d",
    ),
    case(
        "force create element_like friction",
        "friction_name",
        "joint_name = .m.j1 mu_static = 0.5 mu_dynamic = 0.3",
        "effect = sliding",
        "effect = sliding",
    ),
    case(
        "force create direct force_vector",
        "force_vector_name",
        "i_marker_name = .m.p.a j_floating_marker_name = .m.q.f ref_marker_name = .m.q.c \
         x_force_function = \"1\" y_force_function = \"2\" z_force_function = \"3\"",
        "z_force_function = \"-DZ(.m.p.a, .m.q.c)\"",
        "z_force_function = \"-DZ(.m.p.a, .m.q.c)\"",
    ),
    case(
        "force create direct torque_vector",
        "torque_vector_name",
        "i_marker_name = .m.p.a j_floating_marker_name = .m.q.f x_torque_function = \"1\"",
        "ref_marker_name = .m.q.c",
        "ref_marker_name = .m.q.c",
    ),
    case(
        "force create direct general_force",
        "general_force_name",
        "i_marker_name = .m.p.a j_floating_marker_name = .m.q.f user_function = 1, 2",
        "routine = \"lib::entry\"",
        "routine = \"lib::entry\"",
    ),
    case(
        "force create direct modal_force",
        "modal_force_name",
        "flex_body = .m.p case_index = 3",
        "scale = \"2*TIME\"",
        "scale = \"2*TIME\"",
    ),
    case(
        "contact create",
        "contact_name",
        "type = solid_to_solid i_geometry_name = .m.p.box j_geometry_name = .m.q.box stiffness = 1e5 damping = 10",
        "coulomb_friction = on mu_static = 0.3",
        "mu_static = 0.3",
    ),
    case(
        "part create equation differential_equation",
        "differential_equation_name",
        "initial_condition = 1 function = \"-TIME\"",
        "static_hold = on",
        "static_hold = on",
    ),
];

fn session() -> Interpreter {
    let mut interpreter = Interpreter::new(elements::registry());
    interpreter.on_error = OnError::IgnoreCommand;
    no_errors(&interpreter.run_text("fixture", FIXTURE));
    interpreter
}

fn no_errors(report: &Report) {
    assert!(!report.has_errors(), "{:#?}", report.diagnostics);
}

fn export(interpreter: &Interpreter) -> String {
    interpreter.database.current("model").map(|m| interpreter.write_model(m)).unwrap_or_default()
}

impl Case {
    /// Where the object goes: floating markers are on a body.
    fn name(&self, leaf: &str) -> String {
        if self.command.starts_with("floating") { format!(".m.q.{leaf}") } else { format!(".m.{leaf}") }
    }

    fn create(&self, leaf: &str) -> String {
        format!("{} {} = {} {}", self.command, self.object, self.name(leaf), self.given)
    }
}

#[test]
fn objects_are_created_modified_renamed_and_read_back() {
    for case in CASES {
        let mut first = session();
        no_errors(&first.execute(&case.create("x")));
        let modify = case.command.replace("create", "modify");
        no_errors(&first.execute(&format!(
            "{modify} {} = {} new_{} = {} {}",
            case.object,
            case.name("x"),
            case.object,
            case.name("renamed"),
            case.change
        )));
        assert!(first.database.find(&case.name("x"), "any").is_none(), "{}", case.command);
        let written = export(&first);
        let head = format!("{}  &\n   {} = {}", case.command, case.object, case.name("renamed"));
        assert!(written.contains(&head), "{}\n{written}", case.command);
        assert!(written.contains(case.shown), "{}: no {}\n{written}", case.command, case.shown);
        let mut second = Interpreter::new(elements::registry());
        second.on_error = OnError::IgnoreCommand;
        let report = second.run_text("export", &written);
        no_errors(&report);
        assert_eq!(export(&second), written, "{}", case.command);
        // And all of it is undone.
        while first.database.undo() {}
        assert!(first.database.find(&case.name("x"), "any").is_none());
    }
}

/// Truth: the families of the commands: `force delete`, `force attributes`, `constraint copy` and so
/// on take objects of every class of force and constraint; exports set attributes of contacts as of
/// forces.
#[test]
fn the_commands_of_a_family_take_the_objects_of_its_classes() {
    for case in CASES {
        let family = match case.command.split(' ').next() {
            Some("contact") => "force",
            Some("part" | "floating_marker") | None => continue,
            Some(first) => first,
        };
        let mut i = session();
        no_errors(&i.execute(&case.create("x")));
        no_errors(&i.execute(&format!("{family} attributes {family}_name = .m.x active = off color = RED")));
        let id = i.database.find(".m.x", family).unwrap();
        assert_eq!(i.database.text(id, "active"), Some("off"), "{}", case.command);
        no_errors(&i.execute(&format!("{family} copy {family}_name = .m.x new_{family}_name = .m.y")));
        let copy = i.database.find(".m.y", family).unwrap();
        assert_eq!(i.database.object(copy).class, i.database.object(id).class, "{}", case.command);
        no_errors(&i.execute(&format!("{family} delete {family}_name = .m.x, .m.y")));
        assert!(i.database.find(".m.x", "any").is_none() && i.database.find(".m.y", "any").is_none());
    }
}

/// Truth: the defaults of a bushing, three numbers each.
#[test]
fn defaults_of_lists_fill_the_list() {
    let mut i = session();
    no_errors(&i.execute(&format!("force create element_like bushing bushing_name = .m.x {ENDS}")));
    let bushing = i.database.find(".m.x", "bushing").unwrap();
    assert_eq!(i.database.numbers(bushing, "stiffness"), Some(vec![1.0; 3]));
    assert_eq!(i.database.numbers(bushing, "torque_preload"), Some(vec![0.0; 3]));
}

/// Truth: what Adams View answers to a general force with a body: the floating marker FMARKER_n on it, here
/// the second of the model.
#[test]
fn a_body_at_a_floating_end_gets_a_floating_marker() {
    let mut i = session();
    let report = i.execute(
        "force create direct general_force general_force_name = .m.x i_marker_name = .m.p.a j_part_name = .m.q \
         j_marker_id = 12 ref_marker_name = .m.q.c x_force_function = \"1\"",
    );
    no_errors(&report);
    let said: Vec<&String> = report.diagnostics.iter().flat_map(|d| &d.adams_text).collect();
    assert_eq!(said, ["The floating marker FMARKER_2 has been created on part .m.q."]);
    assert_eq!(report.diagnostics[0].code, "marker/floating-made");
    let force = i.database.find(".m.x", "general_force").unwrap();
    let made = i.database.find(".m.q.FMARKER_2", "floating_marker").unwrap();
    assert_eq!(i.database.reference(force, "j_floating_marker_name"), Some(made));
    assert_eq!(i.database.integer(made, "adams_id"), Some(12));
    // The body is no value of the force, and a number of a marker is not given twice.
    assert!(i.database.reference(force, "j_part_name").is_none());
    let report = i.execute(
        "force create direct general_force general_force_name = .m.y i_marker_name = .m.p.a j_part_name = .m.q \
         j_marker_id = 12 ref_marker_name = .m.q.c x_force_function = \"1\"",
    );
    assert_eq!(report.diagnostics[0].code, "name/id-taken");
    assert_eq!(i.database.below(i.database.find(".m", "model").unwrap(), "floating_marker").len(), 2);
    no_errors(&i.execute("force modify direct general_force general_force_name = .m.x j_part_name = .m.p"));
    let other = i.database.reference(force, "j_floating_marker_name").unwrap();
    let (body, name) = (i.database.find(".m.p", "part"), i.database.full_name(other));
    assert_eq!(i.database.object(other).parent, body, "{name}");
}
