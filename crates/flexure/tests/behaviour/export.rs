//! Written models, verification, macros.

use crate::scene::Scene;

// Case 113, observed.
#[test]
fn functions_and_expressions_are_written_when_everything_is_there() {
    let mut s = Scene::beam();
    s.accept(
        "force create direct single_component_force single_component_force_name = .m.f &\n\
           i_marker_name = .m.p1.marker_1 j_marker_name = .m.ground.marker_2 function = \"3*TIME\"\n\
         force modify element_like beam beam_name = .m.beam1 ixx = (2 * 3)",
    );
    let export = s.export();
    let at = |text: &str| export.find(text).unwrap_or_else(|| panic!("no {text} in\n{export}"));
    let order = [
        at("model create"),
        at("part create rigid_body name_and_position"),
        at("force create"),
        at("function = \"\""),
        at("Function definitions"),
        at("function = \"3*TIME\""),
        at("Expression definitions"),
        at("ixx = (2 * 3)"),
        at("model display"),
    ];
    let mut sorted = order;
    sorted.sort_unstable();
    assert_eq!(order[3..], sorted[3..], "{export}");
    assert!(order[0] < order[1] && order[1] < order[2], "{export}");
}

// Case 114, observed.
#[test]
fn angles_carry_their_unit_and_ten_decimals() {
    let mut s = Scene::beam();
    s.accept("part modify rigid_body name_and_position part_name = .m.p1 orientation = 333.4349488229d, 0, 0");
    assert!(s.export().contains("orientation = 333.4349488229d, 0.0d, 0.0d"), "{}", s.export());
    let data_set = s.data_set();
    assert!(data_set.contains("333.4349488D"), "{data_set}");
}

/// One part on two hinges of one line, both of them driven.
const TWICE_DRIVEN: &str = "model create model_name=model_1
part create rigid_body name_and_position part_name=.model_1.PART_2 location=0,0,0
marker create marker_name=.model_1.PART_2.cm location=0,0,0
marker create marker_name=.model_1.PART_2.a location=0,0,0
marker create marker_name=.model_1.PART_2.b location=0,0,100
marker create marker_name=.model_1.ground.a location=0,0,0
marker create marker_name=.model_1.ground.b location=0,0,100
part modify rigid_body mass_properties part_name=.model_1.PART_2 mass=1 center_of_mass_marker=.model_1.PART_2.cm &
   ixx=1 iyy=1 izz=1
constraint create joint revolute joint_name=.model_1.JOINT_1 i_marker_name=.model_1.PART_2.a &
   j_marker_name=.model_1.ground.a
constraint create joint revolute joint_name=.model_1.JOINT_2 i_marker_name=.model_1.PART_2.b &
   j_marker_name=.model_1.ground.b
constraint create motion_generator motion_name=.model_1.MOTION_1 type_of_freedom=rotational &
   joint_name=.model_1.JOINT_1 function=\"TIME\"
constraint create motion_generator motion_name=.model_1.MOTION_2 type_of_freedom=rotational &
   joint_name=.model_1.JOINT_2 function=\"TIME\"
";

// Case 115, observed.
#[test]
fn verification_counts_as_adams_does() {
    let mut s = Scene::empty();
    s.accept(TWICE_DRIVEN);
    s.window();
    s.accept("model verify model_name = .model_1");
    let window = s.window();
    let squeezed: Vec<String> = window.iter().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    let wanted = [
        "VERIFY MODEL: .model_1",
        "-6 Gruebler Count (approximate degrees of freedom)",
        "1 Moving Parts (not including ground)",
        "2 Revolute Joints",
        "2 Motions",
        "0 Degrees of Freedom for .model_1",
        "There are 6 redundant constraint equations.",
        "Model verified successfully",
    ];
    let mut rest = squeezed.iter();
    for line in wanted {
        assert!(rest.any(|l| l == line), "{line} is missing or not in its place:\n{}", window.join("\n"));
    }
}

// Case 116, documented.
#[test]
fn a_macro_puts_its_parameter_into_its_text() {
    let mut s = Scene::beam();
    s.accept(
        "macro create macro_name = icon_size user_entered_command = \"icon_size\" &\n\
         commands_to_be_executed = \"force attributes force_name=.* size_of_icons = $size\"",
    );
    let report = s.read("call.cmd", "icon_size size=1.5\n");
    assert_eq!(report.failed, 0, "{}", s.told(&report));
    assert_eq!(s.number(".m.beam1", "size_of_icons"), 1.5);
    let line = "! >> force attributes force_name=.* size_of_icons = 1.5";
    assert!(s.journal().contains(&line.to_string()), "{:#?}", s.journal());
}

// Case 117, documented.
#[test]
fn a_macro_gets_names_in_full() {
    let mut s = Scene::beam();
    s.accept(
        "macro create macro_name = who user_entered_command = \"who is\" &\n\
         commands_to_be_executed = \"variable set variable_name = .who string_value = \\\"$m:t=marker\\\"\"",
    );
    s.accept("who is m = marker_1");
    assert_eq!(s.text(".who", "string_value"), ".m.p1.marker_1");
}
