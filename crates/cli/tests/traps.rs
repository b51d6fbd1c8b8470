//! Traps and findings of beams at the command line: what is printed, what is mended, what is not drawn.

use std::fmt::Write;
use std::fs;

use assert_cmd::Command;
use tempfile::TempDir;

fn run(folder: &TempDir, arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("flexure").unwrap();
    let output = command.current_dir(folder.path()).env("NO_COLOR", "1").args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

/// A bar of 200 mm whose ends are exchanged, whose length is 1 mm wrong, which is sheared by the inverse of
/// the factor and has its polar moment for the torsion constant.
const TRAPS: &str = "\
defaults units length=mm angle=deg force=newton mass=kg time=sec
model create model_name=m
part create rigid_body name_and_position part_name=.m.p location=200,0,0
marker create marker_name=.m.p.i location=0,0,0 orientation=0,0,0 relative_to=.m.p
part create rigid_body mass_properties part_name=.m.p mass=2 center_of_mass_marker=.m.p.i ixx=100 iyy=100 izz=100
marker create marker_name=.m.ground.j location=0,0,0 orientation=0,0,0
force create element_like beam beam_name=.m.bar i_marker_name=.m.ground.j j_marker_name=.m.p.i length=201 &
   area_of_cross_section=200 ixx=(20000/3+5000/3) iyy=(20000/3) izz=(5000/3) youngs_modulus=2.07E5 &
   shear_modulus=8.0E4 y_shear_area_ratio=0.8333
";

#[test]
fn verify_mends_a_model_until_it_is_clean() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("bar.cmd"), TRAPS).unwrap();
    let (status, _, errors) = run(&folder, &["verify", "bar.cmd", "--fix"]);
    assert_eq!(status, 1, "the model as given had findings: {errors}");
    for code in ["error[beam/ends-swapped]", "warning[beam/shear-ratio]", "warning[beam/polar-moment]"] {
        assert!(errors.contains(code), "{code}\n{errors}");
    }
    // The wrong length cannot be seen behind the exchanged ends; it is mended in the same call.
    assert!(!errors.contains("not everything could be mended"), "{errors}");
    assert!(errors.contains("4 findings mended; written to bar_fixed.cmd"), "{errors}");
    let (status, shown, errors) = run(&folder, &["verify", "bar_fixed.cmd"]);
    assert_eq!(status, 0, "{shown}\n{errors}");
    assert!(fs::read_to_string(folder.path().join("bar_fixed.cmd")).unwrap().contains("length = 200"));
    let (_, json, _) = run(&folder, &["verify", "bar.cmd", "--json"]);
    assert!(json.contains("\"fix\": \"force modify element_like beam beam_name=.m.bar i_marker_name=.m.p.i"), "{json}");
}

/// Truth: EI/L^2 = 2.07e5 * 1666.67 / 4e4 = 8625 N; a tip moment of M turns the end by M L / EI, so that
/// 1.0E6 N mm gives 0.5797 rad or 33.2 degrees: four beams see at most 10 degrees each.
#[test]
fn a_run_says_how_many_beams_an_angle_needs() {
    let folder = TempDir::new().unwrap();
    let clean = sound_bar();
    let moment = "force create direct single_component_force single_component_force_name=.m.t type_of_freedom=rotational \
                  i_marker_name=.m.p.i j_marker_name=.m.ground.j action_only=on function=\"1.0E6\"\n";
    fs::write(
        folder.path().join("bar.cmd"),
        format!("{clean}{moment}simulation single_run equilibrium model_name=.m\n"),
    )
    .unwrap();
    let (_, shown, errors) = run(&folder, &["run", "bar.cmd"]);
    assert!(errors.contains("warning[run/beyond-validity]"), "{shown}\n{errors}");
    assert!(errors.contains(".m.bar: 33.2 degrees at t = 0.0000 s; 4 in its place would do"), "{errors}");
}

/// What has no picture yet is named, and the rest is drawn.
#[test]
fn a_b_spline_is_named_as_not_drawn() {
    let folder = TempDir::new().unwrap();
    let curve = "data_element create curve curve_name=.m.c\n\
                 geometry create curve bspline bspline_name=.m.p.spline ref_curve_name=.m.c ref_marker_name=.m.p.i\n";
    fs::write(folder.path().join("curve.cmd"), format!("{TRAPS}{curve}")).unwrap();
    let (status, shown, errors) = run(&folder, &["plot", "curve.cmd", "-o", "curve.svg"]);
    assert!(errors.contains("geometry/not-drawn"), "{status} {shown}\n{errors}");
    assert!(errors.contains("`.m.p.spline`") && errors.contains("B-spline curves are not evaluated yet"), "{errors}");
}

/// What was changed is said, with an expression named as such; a fix that does not help is tried once and
/// not counted; only what is asked for is mended; the file goes beside the original.
#[test]
fn mending_says_what_it_changes_and_does_no_more() {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("sub")).unwrap();
    let model = TRAPS.replace("y_shear_area_ratio=0.8333", "y_shear_area_ratio=(0.5+0.3)");
    fs::write(folder.path().join("sub/bar.cmd"), &model).unwrap();
    let (status, shown, errors) = run(&folder, &["verify", "sub/bar.cmd", "--fix"]);
    assert_eq!(status, 1, "{errors}");
    assert!(shown.contains("Model not verified: 1 error") && !shown.contains("verified successfully"), "{shown}");
    for line in [
        "mended: beam/length: length of `.m.bar` 201 -> 200",
        "mended: beam/shear-ratio: y_shear_area_ratio of `.m.bar` 0.8, which was the expression (0.5 + 0.3), -> 1.25",
        "i_marker_name of `.m.bar` .m.ground.j -> .m.p.i, j_marker_name of `.m.bar` .m.p.i -> .m.ground.j",
    ] {
        assert!(errors.contains(line), "{line}\n{errors}");
    }
    let beside = std::path::Path::new("sub").join("bar_fixed.cmd");
    assert!(errors.contains(&format!("written to {}", beside.display())), "{errors}");
    assert!(folder.path().join(&beside).exists() && !folder.path().join("bar_fixed.cmd").exists());

    let only = ["verify", "sub/bar.cmd", "--fix", "--only", "beam/shear-ratio", "--out", "some.cmd"];
    let (_, _, errors) = run(&folder, &only);
    assert!(errors.contains("1 finding mended; written to some.cmd"), "{errors}");
    let (_, _, errors) = run(&folder, &["verify", "some.cmd"]);
    assert!(errors.contains("beam/ends-swapped") && !errors.contains("beam/shear-ratio"), "{errors}");
}

/// TRAPS without traps, so that a test sets its own: the bar's ends in order, true length, shear factor and
/// torsion constant.
fn sound_bar() -> String {
    TRAPS
        .replace(
            "i_marker_name=.m.ground.j j_marker_name=.m.p.i length=201",
            "i_marker_name=.m.p.i j_marker_name=.m.ground.j length=200",
        )
        .replace("0.8333", "1.2")
        .replace("ixx=(20000/3+5000/3)", "ixx=4577.5")
}

/// A marker that moves away as its beam is made longer, so that every fix of the length brings the next.
/// Truth: I lies 200 mm and the length behind J; with 200 mm it is 400 mm away, and with the 400 mm of the
/// one fix that is made, 600 mm.
#[test]
fn mending_ends_where_a_fix_does_not_help() {
    let folder = TempDir::new().unwrap();
    let model =
        format!("{}marker modify marker_name=.m.p.i location=(.m.bar.length),0,0 relative_to=.m.p\n", sound_bar());
    fs::write(folder.path().join("bar.cmd"), model).unwrap();
    let (status, _, errors) = run(&folder, &["verify", "bar.cmd", "--fix"]);
    assert_eq!(status, 1, "{errors}");
    assert!(errors.contains("`length` of beam `.m.bar` is 200 mm, but its markers are 400 mm apart"), "{errors}");
    let said = "not mended, though the fix was made: beam/length: length of `.m.bar` 200 -> 400\n";
    assert!(errors.contains(said), "{errors}");
    assert!(!errors.contains("\nmended: "), "{errors}");
    assert!(errors.contains("0 findings mended; written to bar_fixed.cmd"), "{errors}");
    assert!(errors.contains("not everything could be mended"), "{errors}");
    let (_, _, errors) = run(&folder, &["verify", "bar_fixed.cmd"]);
    assert!(errors.contains("`length` of beam `.m.bar` is 400 mm, but its markers are 600 mm apart"), "{errors}");
}

/// A damper of 1.0E5 beside a beam with a ratio of 1.0E-5 s: the ratio is not to blame, and nothing is changed.
#[test]
fn nothing_is_mended_where_the_beam_is_not_to_blame() {
    let folder = TempDir::new().unwrap();
    let clean = sound_bar().replace("y_shear_area_ratio=1.2", "y_shear_area_ratio=1.2 damping_ratio=1.0E-5");
    let damper = "marker create marker_name=.m.ground.k location=200,0,0 orientation=0,0,0\n\
                  force create element_like bushing bushing_name=.m.bush i_marker_name=.m.p.i j_marker_name=.m.ground.k \
                  stiffness=0,0,0 tstiffness=0,0,0 damping=1E5,1E5,1E5 tdamping=1E9,1E9,1E9\n";
    fs::write(folder.path().join("bar.cmd"), format!("{clean}{damper}")).unwrap();
    let (status, _, errors) = run(&folder, &["verify", "bar.cmd", "--fix"]);
    assert_eq!(status, 0, "{errors}");
    assert!(errors.contains("0 findings mended"), "{errors}");
    let mended = fs::read_to_string(folder.path().join("bar_fixed.cmd")).unwrap();
    assert!(mended.contains("damping_ratio = 1.0E-05"), "{mended}");
}

/// What `--fix` does is not advised while it is done.
#[test]
fn mending_is_advised_where_nothing_is_mended() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("bar.cmd"), TRAPS).unwrap();
    let (_, _, errors) = run(&folder, &["verify", "bar.cmd"]);
    assert!(errors.contains("3 findings, 3 of them can be mended with --fix\n"), "{errors}");
    let (_, _, errors) = run(&folder, &["verify", "bar.cmd", "--fix"]);
    assert!(errors.contains("3 findings\n") && !errors.contains("can be mended with --fix"), "{errors}");
}

/// The inverse of so small a ratio is no number: nothing is offered that would fail.
#[test]
fn a_ratio_without_an_inverse_is_not_mended() {
    let folder = TempDir::new().unwrap();
    let tiny = sound_bar().replace("y_shear_area_ratio=1.2", "y_shear_area_ratio=1.0E-310");
    fs::write(folder.path().join("bar.cmd"), tiny).unwrap();
    let (status, _, errors) = run(&folder, &["verify", "bar.cmd", "--fix"]);
    assert_eq!(status, 1, "{errors}");
    assert!(errors.contains("no fix is offered: the inverse of the ratio is no number"), "{errors}");
    assert!(errors.contains("0 findings mended") && !errors.contains("though the fix was made"), "{errors}");
}

/// The command in a file finds what the program called on that file finds, and both take beams as they are
/// told to.
#[test]
fn the_command_and_the_program_find_the_same() {
    let folder = TempDir::new().unwrap();
    let damped = sound_bar().replace("y_shear_area_ratio=1.2", "y_shear_area_ratio=1.2 damping_ratio=0.02");
    let nonlinear = sound_bar().replace("y_shear_area_ratio=1.2", "y_shear_area_ratio=1.2 formulation=nonlinear");
    for (model, options, code, found) in [
        (&damped, &[][..], "beam/overdamped", true),
        (&nonlinear, &[], "beam/shear-ignored", true),
        (&nonlinear, &["--nonlinear-shear"], "beam/shear-ignored", false),
    ] {
        fs::write(folder.path().join("model.cmd"), model).unwrap();
        fs::write(folder.path().join("command.cmd"), format!("{model}model verify model_name=.m\n")).unwrap();
        let (_, _, program) = run(&folder, &[&["verify", "model.cmd"], options].concat());
        let (_, _, command) = run(&folder, &[&["run", "command.cmd"], options].concat());
        for (door, errors) in [("program", program), ("command", command)] {
            assert_eq!(errors.contains(&format!("[{code}]")), found, "{door} {options:?} {code}: {errors}");
        }
    }
}

/// Truth: I is turned from J by p = 30 degrees about z and q = 40 degrees about the new x. Its z axis is
/// (sin p sin q, -cos p sin q, cos q), so that the angle projected on x is atan2(cos p sin q, cos q). The
/// rotation vector has the length acos((trace - 1)/2) and the x component (R32 - R23)/(2 sin) of it. The torque
/// is -G Ixx/L times the angle; six digits are printed.
#[test]
fn angles_are_measured_as_asked_for_where_a_model_is_verified() {
    let folder = TempDir::new().unwrap();
    let marker = "marker create marker_name=.m.p.i location=0,0,0 orientation=";
    let turned = sound_bar().replace(&format!("{marker}0,0,0"), &format!("{marker}30,40,0"));
    fs::write(folder.path().join("bar.cmd"), &turned).unwrap();
    fs::write(folder.path().join("command.cmd"), format!("{turned}model verify model_name=.m\n")).unwrap();
    let (p, q) = (30_f64.to_radians(), 40_f64.to_radians());
    let projected = (p.cos() * q.sin()).atan2(q.cos());
    let angle = (0.5 * (p.cos() + p.cos() * q.cos() + q.cos() - 1.0)).acos();
    let vector = angle * (q.sin() + p.cos() * q.sin()) / (2.0 * angle.sin());
    for (option, expected) in [("projected", projected), ("rotvec", vector)] {
        for arguments in [["verify", "bar.cmd"], ["run", "command.cmd"]] {
            let (_, _, errors) = run(&folder, &[&arguments[..], &["--beam-angles", option]].concat());
            let torque = errors.split("torque ").nth(1).and_then(|rest| rest.split(',').next());
            let torque: f64 = torque.and_then(|x| x.parse().ok()).unwrap_or_else(|| panic!("{errors}"));
            let expected = -8.0e4 * 4577.5 / 200.0 * expected;
            assert!((torque / expected - 1.0).abs() < 1e-5, "{arguments:?} {option}: {torque} {expected}");
        }
    }
}

/// Notes are called notes and do not fail; a trouble is printed once; a model that was read in part is not
/// called verified, and nothing is computed from it.
#[test]
fn findings_are_called_what_they_are() {
    let folder = TempDir::new().unwrap();
    let clean = sound_bar().replace("y_shear_area_ratio=1.2", "y_shear_area_ratio=1.2 formulation=nonlinear");
    fs::write(folder.path().join("note.cmd"), &clean).unwrap();
    let (status, shown, errors) = run(&folder, &["verify", "note.cmd", "--json"]);
    assert_eq!(status, 0, "{errors}");
    let json: serde_json::Value = serde_json::from_str(&shown).unwrap();
    assert_eq!(json["findings"][0]["code"], "beam/shear-ignored");
    assert_eq!(json["findings"][0]["severity"], "note");

    fs::write(folder.path().join("wrong.cmd"), clean.replace("2.07E5", "-2.07E5")).unwrap();
    let (status, shown, errors) = run(&folder, &["verify", "wrong.cmd"]);
    assert_eq!(status, 1);
    let sentence = "`youngs_modulus` of beam `.m.bar` is -207000";
    assert_eq!(format!("{shown}{errors}").matches(sentence).count(), 1, "{shown}\n{errors}");

    fs::write(folder.path().join("part.cmd"), format!("{clean}marker create nonsense=1\n")).unwrap();
    let (status, shown, _) = run(&folder, &["verify", "part.cmd"]);
    assert!(status == 1 && !shown.contains("verified successfully"), "{shown}");
    for command in ["beams", "modes"] {
        let (status, _, errors) = run(&folder, &[command, "part.cmd"]);
        assert!(status == 1 && errors.contains("the model has errors; nothing was computed"), "{errors}");
    }
}

/// More findings than are printed: the command that is named lists them all.
#[test]
fn the_command_that_lists_all_findings_does() {
    let folder = TempDir::new().unwrap();
    let mut model = TRAPS.to_string();
    for k in 0..250 {
        let _ = writeln!(
            model,
            "force create element_like beam beam_name=.m.b{k} i_marker_name=.m.p.i j_marker_name=.m.ground.j length=200 \
             area_of_cross_section=200 ixx=4577.5 iyy=(20000/3) izz=(5000/3) youngs_modulus=2.07E5 shear_modulus=8.0E4 \
             y_shear_area_ratio=0.8"
        );
    }
    fs::write(folder.path().join("many.cmd"), model).unwrap();
    let (_, _, errors) = run(&folder, &["verify", "many.cmd"]);
    assert!(errors.contains("more; `flexure verify --json` lists them all"), "{errors}");
    let (_, shown, _) = run(&folder, &["verify", "many.cmd", "--json"]);
    assert_eq!(shown.matches("\"code\": \"beam/shear-ratio\"").count(), 251);
}
