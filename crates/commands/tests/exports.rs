//! What holds for every model: an export reads back to the same export, and undo restores it.

use std::path::{Path, PathBuf};

use flexure_commands::{Interpreter, Journal, OnError, Report};
use proptest::prelude::*;

fn command_files(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            command_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "cmd") {
            found.push(path);
        }
    }
}

fn session() -> Interpreter {
    let mut interpreter = Interpreter::new(elements::registry());
    interpreter.on_error = OnError::IgnoreCommand;
    interpreter
}

fn export(interpreter: &Interpreter) -> String {
    interpreter.database.current("model").map(|m| interpreter.write_model(m)).unwrap_or_default()
}

/// Skipped commands.
fn missing(report: &Report) -> usize {
    let named = |code: &str| matches!(code, "command/not-supported" | "command/skipped-too");
    report.diagnostics.iter().filter(|d| named(d.code)).count()
}

#[test]
fn an_export_reads_back_to_the_same_export() {
    let mut found = Vec::new();
    command_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples"), &mut found);
    assert!(found.len() >= 5, "{found:?}");
    match std::env::var_os("FLEXURE_SHARED") {
        Some(shared) => command_files(&Path::new(&shared).join("corpus"), &mut found),
        None => println!("without the corpus: FLEXURE_SHARED is not set"),
    }
    let mut whole = 0;
    for path in found {
        let mut first = session();
        if missing(&first.run_file(&path)) > 0 || first.database.current("model").is_none() {
            continue;
        }
        let written = export(&first);
        let mut second = session();
        let report = second.run_text("export", &written);
        assert!(!report.has_errors(), "{}: {:#?}", path.display(), report.diagnostics);
        let again = export(&second);
        for (number, (a, b)) in written.lines().zip(again.lines()).enumerate() {
            assert_eq!(a, b, "line {} of the export of {}", number + 1, path.display());
        }
        assert_eq!(written, again, "{}", path.display());
        println!("same: {}", path.display());
        whole += 1;
    }
    assert!(whole >= 4, "only {whole} models were read in full");
}

const FIXTURE: &str = "
model create model_name = m
part create rigid_body name_and_position part_name = .m.p location = 100,0,0 orientation = 90,0,0
marker create marker_name = .m.p.a location = 0,0,0
marker create marker_name = .m.ground.b location = 0,0,0
variable create variable_name = .m.v real_value = 3
force create element_like beam beam_name = .m.beam i_marker_name = .m.p.a j_marker_name = .m.ground.b &
   ixx=1 iyy=1 izz=1 youngs_modulus=(.m.v) shear_modulus=1 length=100 area_of_cross_section=1
";

/// Commands on few names, so that they meet: many succeed, some are refused.
fn command() -> impl Strategy<Value = String> {
    let name = prop::sample::select(vec!["a", "b", "c", "d"]);
    let part = prop::sample::select(vec!["p", "q", "ground"]);
    (0..40_usize, name, part, -50..50_i32).prop_map(|(kind, name, part, x)| match kind {
        0 => format!("marker create marker_name = .m.{part}.{name} location = {x}, 1, 2"),
        1 => format!("marker modify marker_name = .m.{part}.{name} location = (.m.v), {x}, 0 adams_id = {}", x.abs()),
        2 => format!("marker delete marker_name = .m.{part}.{name}"),
        3 => format!("entity modify entity_name = .m.{part}.{name} new_entity_name = n{x}"),
        4 => format!("part create rigid_body name_and_position part_name = .m.{part} location = {x}, 0, 0"),
        5 => format!("part copy part_name = .m.p new_part_name = {part}"),
        6 => format!("variable modify variable_name = .m.v real_value = {x}"),
        7 => format!("variable set variable_name = .m.{name} real_value = (.m.v + {x})"),
        8 => format!("force modify element_like beam beam_name = .m.beam length = {x} j_marker_name = .m.{part}.{name}"),
        9 => format!("defaults units length = {}", if x < 0 { "meter" } else { "mm" }),
        10 => format!("group create group_name = .m.g objects_in_group = .m.{part}.{name}"),
        11 => format!("part modify rigid_body name_and_position part_name = .m.{part} orientation = {x}, 5, 0"),
        12 => format!("for variable_name = i start_value = 1 end_value = 3\nmarker create marker_name = (eval(\".m.{part}.l\" // RTOI(i))) location = {x}, 0, 0\nend"),
        13 => format!("undo begin_block\nmarker create marker_name = .m.{part}.{name}\nvariable delete variable_name = .m.{name}\nundo end_block"),
        14 => format!("part create rigid_body mass_properties part_name = .m.{part} mass = {x} center_of_mass_marker = .m.{part}.{name}"),
        15 => format!("move object part_name = .m.{part} c1 = {x} c2 = 0 c3 = 1"),
        16 => format!("move rotation part_name = .m.{part} a1 = {x} a2 = 0 a3 = 0"),
        17 => format!("group objects add group_name = .m.g objects_in_group = .m.{part}, .m.v"),
        18 => format!("group objects remove group_name = .m.g objects_in_group = .m.{part}.{name}"),
        19 => "group objects delete group_name = .m.g".to_string(),
        20 => format!("force copy force_name = .m.beam new_force_name = .m.{name}"),
        21 => format!("force delete force_name = .m.{name}"),
        22 => format!("force attributes force_name = .m.beam color = RED active = {}", if x < 0 { "off" } else { "on" }),
        23 => format!("constraint create joint revolute joint_name = .m.j{name} i_marker_name = .m.p.a j_marker_name = .m.ground.b"),
        24 => format!("constraint delete constraint_name = .m.j{name}"),
        25 => format!("geometry create shape block block_name = .m.{part}.box corner_marker = .m.{part}.{name} diag_corner_coords = 1, 2, {x}"),
        26 => format!("entity delete entity_name = .m.{part}.{name}"),
        27 => format!("entity copy entity_name = .m.{part}.{name} new_entity_name = .m.{part}.c{x}"),
        28 => format!("macro create macro_name = .m.make_{name} user_entered_command = \"make {name}\" commands_to_be_executed = \"marker create marker_name = .m.{part}.made location = $x:t=real, 0, 0\""),
        29 => format!("make {name} x = {x}"),
        30 => format!("data_element create spline spline_name = .m.s{name} x = 0, 1, 2, 3 y = 0, {x}, 2, 3"),
        31 => format!("data_element modify spline spline_name = .m.s{name} y = 1, 2, 3, {x}"),
        32 => format!("force create element_like bushing bushing_name = .m.u{name} i_marker_name = .m.p.a j_marker_name = .m.ground.b stiffness = {x}, 1, (.m.v)"),
        33 => "model copy model_name = .m new_model_name = .copied".to_string(),
        34 => format!("part merge rigid_body part_name = .m.{part} into_part_name = .m.p"),
        35 => format!("variable create variable_name = .m.{name} real_value = 1, 2, {x}"),
        36 => format!("variable modify variable_name = .m.{name} index = 2 real_value = {x}"),
        37 => format!("defaults name_generation marker marker_prefix = {name}\nmarker create location = {x}, 0, 0"),
        38 => format!("if condition = (.m.v > {x})\nmarker create marker_name = .m.{part}.if_{name}\nend"),
        _ => format!("marker modify marker_name = .m.{part}.{name} orientation = (ORI_RELATIVE_TO({{{x}, 0, 0}}, .m.p)) relative_to = .m.{part}"),
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, rng_seed: proptest::test_runner::RngSeed::Fixed(7), ..ProptestConfig::default() })]

    #[test]
    fn undo_restores_and_redo_repeats_any_sequence(commands in prop::collection::vec(command(), 1..25)) {
        let mut i = session();
        prop_assert!(!i.run_text("fixture", FIXTURE).has_errors());
        i.execute("undo flush");
        let before = export(&i);
        for text in &commands {
            i.execute(text);
        }
        let after = export(&i);
        while i.database.undo() {}
        prop_assert_eq!(export(&i), before);
        while i.database.redo() {}
        prop_assert_eq!(export(&i), after.clone());
        // And what came out can be read again.
        let mut second = session();
        let report = second.run_text("export", &after);
        prop_assert!(!report.has_errors(), "{:#?}\n{}", report.diagnostics, after);
    }

    /// The journal of any sequence, with its refused commands and undo in between, builds the same model.
    #[test]
    fn the_journal_of_any_sequence_builds_the_same_model(
        commands in prop::collection::vec(prop_oneof![8 => command(), 1 => Just("undo backward".to_string()), 1 => Just("undo forward".to_string())], 1..25)
    ) {
        let mut first = session();
        first.journal = Some(Journal::default());
        first.execute(FIXTURE);
        for text in &commands {
            first.execute(text);
        }
        let journal = first.journal.as_ref().map(Journal::text).unwrap_or_default();
        let mut second = session();
        second.run_text("journal", &journal);
        prop_assert_eq!(export(&second), export(&first), "{}", journal);
    }
}
