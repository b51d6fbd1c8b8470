//! `flexure beams` and the options for beams, from outside.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

/// Runs the program in a folder; returns exit status, standard output and standard error.
fn run(folder: &TempDir, arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::cargo_bin("flexure").unwrap();
    let output = command.current_dir(folder.path()).env("NO_COLOR", "1").args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().unwrap_or(-1), text(&output.stdout), text(&output.stderr))
}

/// Standard output of a run that goes well.
fn fine(folder: &TempDir, arguments: &[&str]) -> String {
    let (status, printed, errors) = run(folder, arguments);
    assert_eq!(status, 0, "{arguments:?}\n{printed}{errors}");
    printed
}

fn report(folder: &TempDir, arguments: &[&str]) -> Value {
    let arguments = [&["beams"], arguments, &["--format", "json"]].concat();
    serde_json::from_str(&fine(folder, &arguments)).unwrap()
}

fn close(what: &str, actual: f64, expected: f64, tolerance: f64) {
    assert!((actual - expected).abs() <= tolerance, "{what}: {actual} is not {expected} within {tolerance:e}");
}

const UNITS: &str = "defaults units length=meter angle=deg force=newton mass=kg time=sec\nmodel create model_name=m\n";
/// EI = 2000 N m^2. EA = 2E7 N: stretching is 2.5E-5 of bending over 2 m, and 2E-16 m too much are 4E-9 N.
const SECTION: &str = "area_of_cross_section=1E-4 ixx=2E-8 iyy=1E-8 izz=1E-8 youngs_modulus=2E11 shear_modulus=8E10 \
                       y_shear_area_ratio=0 z_shear_area_ratio=0";

fn part(commands: &mut String, name: &str, at: &str) {
    write!(
        commands,
        "part create rigid_body name_and_position part_name=.m.{name} location={at}\n\
         marker create marker_name=.m.{name}.cm location={at}\n\
         part create rigid_body mass_properties part_name=.m.{name} mass=1 center_of_mass_marker=.m.{name}.cm \
         ixx=1 iyy=1 izz=1\n"
    )
    .unwrap();
}

fn marker(commands: &mut String, name: &str, at: &str, turned: &str) {
    writeln!(commands, "marker create marker_name=.m.{name} location={at} orientation={turned}").unwrap();
}

fn beam(commands: &mut String, name: &str, i: &str, j: &str, more: &str) {
    writeln!(
        commands,
        "force create element_like beam beam_name=.m.{name} i_marker_name=.m.{i} j_marker_name=.m.{j} {SECTION} {more}"
    )
    .unwrap();
}

/// A force along z of a ground marker on a marker, and a static solution that is as good as it gets.
fn force(commands: &mut String, on: &str, direction: &str, size: &str) {
    marker(commands, "ground.pull", "0,0,0", direction);
    write!(
        commands,
        "force create direct single_component_force single_component_force_name=.m.load type_of_freedom=translational \
         action_only=on i_marker_name=.m.{on} j_marker_name=.m.ground.pull function=\"{size}\"\n\
         executive_control set equilibrium_parameters model_name=.m error=1E-10 imbalance=1E-10 maxit=100\n"
    )
    .unwrap();
}

/// Two beams of 1 m from ground along x, a force of 3 N at their end along y.
fn cantilever(formulation: &str) -> String {
    let mut commands = UNITS.to_string();
    part(&mut commands, "a", "1,0,0");
    part(&mut commands, "b", "2,0,0");
    marker(&mut commands, "ground.root", "0,0,0", "0,0,0");
    let more = format!("length=1 damping_ratio=0.01 formulation={formulation}");
    beam(&mut commands, "beam_1", "a.cm", "ground.root", &more);
    beam(&mut commands, "beam_2", "b.cm", "a.cm", &more);
    force(&mut commands, "b.cm", "180,90,0", "3");
    commands
}

fn folder(commands: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("m.cmd"), commands).unwrap();
    folder
}

/// Memory: the digits. Truth, up to the square of rotations of 2E-3 rad: V = 3 N, M = 3 N (2 m - x), energy
/// P^2 L^3/6EI = 6 mJ, seven eighths of it in the first beam; the beams' ends turn by 3P/2EI and P/2EI; the
/// second one's N is the force times the turn of its J.
const TABLE: &str = "\
time 0 second
+---------------------------------------------------------------------------------------------------------------------------------------------+
| beam                     N          V                T        largest M   at     rotation           energy    share                   power |
|                   (newton)   (newton)   (newton-meter)   (newton-meter)         (degrees)   (newton-meter)      (%)   (newton-meter/second) |
+=============================================================================================================================================+
| .m.beam_1                0          3                0         5.999989   J     0.1289152      0.005249975    87.50                       0 |
| .m.beam_2      0.006749978   2.999992                0         2.999989   J    0.04297173      7.499962e-4    12.50                       0 |
| largest size   0.006749978          3                0         5.999989         0.1289152      0.005249975    87.50                       0 |
| total of 2                                                                                     0.005999972   100.00                       0 |
+---------------------------------------------------------------------------------------------------------------------------------------------+
the loads of each beam balance exactly
";

#[test]
fn a_cantilever_gives_the_table_of_its_closed_form() {
    let folder = folder(&cantilever("linear"));
    let printed = fine(&folder, &["beams", "m.cmd", "--static"]);
    assert_eq!(printed, TABLE);
}

/// Truth: without a load nothing goes through; a length off by rounding is none.
#[test]
fn beams_without_a_load_show_zeros() {
    let commands = cantilever("linear").replace("function=\"3\"", "function=\"0\"");
    let folder = folder(&commands.replace("location=2,0,0", "location=2.0000000000000004,0,0"));
    let printed = fine(&folder, &["beams", "m.cmd"]);
    let row: Vec<&str> = printed.lines().find(|l| l.contains("beam_2")).unwrap().split_whitespace().collect();
    assert_eq!(row[2..], ["0", "0", "0", "0", "0", "0", "-", "0", "|"], "{printed}");
    let found = report(&folder, &["m.cmd"])["beams"][1]["n"].as_f64().unwrap();
    assert!(found > 0.0, "the report itself has every digit");
}

/// Truth: fixed-base portal of height h = 2 m and width l = 3 m, equal EI, P = 10 mN on the corner: with
/// k = h/l, M = P h/2 (3k+1)/(6k+1) = 6 mN m at the feet and P h/2 3k/(6k+1) = 4 mN m at the corners; the
/// girder's shear is 2 x 4 mN m/l, so is the columns' axial force, left in tension; columns share P.
/// Stretching, EI/(EA h^2) = 2.5E-5 of bending, makes it differ by a few times that.
#[test]
fn a_portal_carries_what_its_closed_form_says() {
    let mut commands = UNITS.to_string();
    part(&mut commands, "b", "0,2,0");
    part(&mut commands, "c", "3,2,0");
    for (name, at, turned) in [
        ("ground.foot_a", "0,0,0", "90,0,0"),
        ("b.column", "0,2,0", "90,0,0"),
        ("b.girder", "0,2,0", "0,0,0"),
        ("c.girder", "3,2,0", "0,0,0"),
        ("c.column", "3,2,0", "90,0,0"),
        ("ground.foot_d", "3,0,0", "90,0,0"),
    ] {
        marker(&mut commands, name, at, turned);
    }
    beam(&mut commands, "left", "b.column", "ground.foot_a", "length=2");
    beam(&mut commands, "girder", "c.girder", "b.girder", "length=3");
    beam(&mut commands, "right", "c.column", "ground.foot_d", "length=2");
    force(&mut commands, "b.cm", "90,90,0", "0.01");
    let folder = folder(&commands);
    let report = report(&folder, &["m.cmd", "--static"]);
    let value = |beam: usize, name: &str| report["beams"][beam][name].as_f64().unwrap();
    let shear = 2.0 * 0.004 / 3.0;
    // x of the columns points up, y to the left: pushed to the right, y is negative.
    for (beam, name, expected) in [
        (0, "n", shear),
        (0, "vy", -0.005),
        (0, "mz_j", -0.006),
        (0, "mz_i", 0.004),
        (1, "n", -0.005),
        (1, "vy", shear),
        (1, "mz_j", 0.004),
        (1, "mz_i", -0.004),
        (2, "n", -shear),
        (2, "vy", -0.005),
        (2, "mz_j", -0.006),
        (2, "mz_i", 0.004),
        (1, "t_j", 0.0),
        (1, "vz", 0.0),
        (1, "my_j", 0.0),
    ] {
        close(&format!("{name} of beam {beam}"), value(beam, name), expected, 2e-4 * 0.006);
    }
    let chain: Vec<_> =
        report["chains"][0].as_array().unwrap().iter().map(|l| l["reversed"].as_bool().unwrap()).collect();
    assert_eq!(chain, [false, false, true]);
    // Truth: half of the force times its way is stored; integral of M^2/2EI over the three members.
    let stored = |a: f64, b: f64, l: f64| l * (a * a + a * b + b * b) / (6.0 * 2000.0);
    let all = 2.0 * stored(-0.006, 0.004, 2.0) + stored(-0.004, 0.004, 3.0);
    close("energy", report["total"]["energy"].as_f64().unwrap(), all, 2e-4 * all);
}

/// Truth: a beam clamped at J and propped at I, with a moment M at I: M/2 at the clamp, shear 3M/2L.
#[test]
fn a_propped_cantilever_carries_half_of_its_end_moment_to_the_clamp() {
    for formulation in ["linear", "string", "nonlinear"] {
        let mut commands = UNITS.to_string();
        part(&mut commands, "a", "2,0,0");
        marker(&mut commands, "ground.root", "0,0,0", "0,0,0");
        beam(&mut commands, "b", "a.cm", "ground.root", &format!("length=2 formulation={formulation}"));
        marker(&mut commands, "ground.along_y", "2,0,0", "180,90,0");
        commands += "constraint create primitive_joint inplane jprim_name=.m.prop i_marker_name=.m.a.cm \
                     j_marker_name=.m.ground.along_y\n";
        force(&mut commands, "a.cm", "0,0,0", "0.004");
        commands = commands.replace("type_of_freedom=translational", "type_of_freedom=rotational");
        let folder = folder(&commands);
        let report = report(&folder, &["m.cmd", "--static"]);
        let value = |name: &str| report["beams"][0][name].as_f64().unwrap();
        // Rotations are 1E-6 rad.
        close("at I", value("mz_i"), 0.004, 1e-8);
        close("at J", value("mz_j"), -0.002, 1e-8);
        close("shear", value("vy"), -1.5 * 0.004 / 2.0, 1e-8);
    }
}

#[test]
fn diagrams_are_drawn() {
    let folder = folder(&cantilever("nonlinear"));
    let printed = fine(&folder, &["beams", "m.cmd", "--static", "--draw", "d.svg"]);
    assert!(printed.ends_with("d.svg\n"), "{printed}");
    let svg = fs::read_to_string(folder.path().join("d.svg")).unwrap();
    for text in ["N (newton)", "V (newton)", "T (newton-meter)", "M (newton-meter)", "along the beams (meter)", "Mz"] {
        assert!(svg.contains(text), "{text}");
    }
    let (status, _, errors) = run(&folder, &["beams", "m.cmd", "--static", "--draw", "d.pdf"]);
    assert_eq!((status, errors.contains(".svg or .png")), (2, true), "{errors}");
    let (status, _, errors) = run(&folder, &["beams", "m.cmd", "--draw", "d.svg", "--size", "big"]);
    assert_eq!((status, errors.contains("is no size")), (2, true), "{errors}");
}

/// Chains as lists of beams' short names, `-` before one that is run through from I to J.
fn chains(report: &Value) -> Vec<Vec<String>> {
    let name = |link: &Value| {
        let sign = if link["reversed"] == true { "-" } else { "" };
        format!("{sign}{}", link["beam"].as_str().unwrap().trim_start_matches(".m."))
    };
    report["chains"].as_array().unwrap().iter().map(|c| c.as_array().unwrap().iter().map(name).collect()).collect()
}

/// Beams follow one another over parts that hold two of them; ground holds any number and ends a chain.
#[test]
fn beams_that_follow_one_another_are_chains() {
    let with = |beams: &[(&str, &str, &str)]| {
        let mut commands = UNITS.to_string();
        marker(&mut commands, "ground.cm", "0,0,0", "0,0,0");
        for (name, at) in [("a", "1,0,0"), ("b", "2,0,0"), ("c", "1,1,0")] {
            part(&mut commands, name, at);
        }
        for (name, i, j) in beams {
            beam(&mut commands, name, &format!("{i}.cm"), &format!("{j}.cm"), "length=1");
        }
        folder(&commands)
    };
    let branched = with(&[("one", "a", "ground"), ("two", "b", "a"), ("three", "c", "a"), ("four", "c", "ground")]);
    let list = |folder: &TempDir| chains(&report(folder, &["m.cmd"]));
    assert_eq!(list(&branched), [vec!["one"], vec!["two"], vec!["three", "-four"]]);
    let ring = with(&[("one", "b", "a"), ("two", "c", "b"), ("three", "c", "a")]);
    assert_eq!(list(&ring), [["one", "two", "-three"]]);
    // Each chain is a piece of its own in the diagrams: four panels with six curves, three chains.
    fine(&branched, &["beams", "m.cmd", "--draw", "d.svg"]);
    let svg = fs::read_to_string(branched.path().join("d.svg")).unwrap();
    assert_eq!(svg.matches("<polygon").count(), 6 * 3);
}

/// Twin: the same state from a results file and from a run of its own.
#[test]
fn what_a_run_recorded_is_what_a_run_of_its_own_finds() {
    let folder = folder(&cantilever("string"));
    fine(&folder, &["simulate", "m.cmd", "--end", "0.4", "--steps", "1", "--beam-loads", "--out", "r.csv"]);
    let header = fs::read_to_string(folder.path().join("r.csv")).unwrap().lines().next().unwrap().to_string();
    assert!(header.starts_with("time") && header.contains("beam_1.MZ_J") && !header.contains("a_XFORM"), "{header}");
    let recorded = report(&folder, &["m.cmd", "--result", "r.csv"]);
    let own = report(&folder, &["m.cmd", "--at", "0.4"]);
    assert_eq!(recorded["time"], 0.4);
    assert_eq!(recorded["beams"], own["beams"]);
    assert!(own["beams"][0]["power"].as_f64().unwrap() > 0.0);
    let start = report(&folder, &["m.cmd", "--result", "r.csv", "--at", "0"]);
    assert_eq!(start["beams"], report(&folder, &["m.cmd"])["beams"]);
    // At rest in the equilibrium nothing moves on.
    let still = report(&folder, &["m.cmd", "--static", "--at", "0.4"]);
    close("moment", still["beams"][0]["mz_j"].as_f64().unwrap(), 6.0, 1e-4);
}

/// Everything recorded holds it too; without, the results say what is missing.
#[test]
fn results_without_the_columns_are_refused_with_the_option_that_records_them() {
    let folder = folder(&format!(
        "{}output_control create request request_name=.m.R output_type=displacement i_marker_name=.m.b.cm \
         j_marker_name=.m.ground.root\n",
        cantilever("linear")
    ));
    let simulate = ["simulate", "m.cmd", "--static", "--out"];
    fine(&folder, &[&simulate[..], &["some.csv"]].concat());
    fine(&folder, &[&simulate[..], &["all.csv", "--all"]].concat());
    report(&folder, &["m.cmd", "--result", "all.csv"]);
    let refused = |arguments: &[&str], code: &str, help: &str| {
        let (status, _, errors) = run(&folder, &[&["beams", "m.cmd"], arguments].concat());
        assert!(status == 1 && errors.contains(&format!("error[{code}]")) && errors.contains(help), "{errors}");
    };
    refused(&["--result", "some.csv"], "beams/not-recorded", "--beam-loads");
    refused(&["--result", "all.csv", "--at", "7"], "beams/no-such-time", "they go from 0 to 0");
    fs::write(folder.path().join("empty.csv"), "time\n").unwrap();
    refused(&["--result", "empty.csv"], "beams/no-rows", "run the model again");
    let without = "force delete force_name=.m.beam_";
    let (one, two) = (format!("{without}1"), format!("{without}2"));
    refused(&["-e", &one, "-e", &two], "beams/none", "flexible_link create");
    let (status, _, errors) = run(&folder, &["beams", "m.cmd", "--result", "nothing.csv"]);
    assert!(status == 1 && errors.contains("cannot read nothing.csv"), "{errors}");
}

/// A chain of the shipped mechanisms, its tip's place along y after a static analysis.
fn tip(chain: &str, load: &str, more: &[&str]) -> f64 {
    let folder = TempDir::new().unwrap();
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../mechanisms/beams/beams.cmd");
    let model = model.to_str().unwrap().to_string();
    let arguments = ["simulate", &model, "-e", chain, "-e", load, "--static", "--out", "o.csv"];
    fine(&folder, &[&arguments[..], more].concat());
    let text = fs::read_to_string(folder.path().join("o.csv")).unwrap();
    let mut lines = text.lines();
    let column = lines.next().unwrap().split(',').position(|name| name == "TIP.Y").unwrap();
    lines.last().unwrap().split(',').nth(column).unwrap().parse().unwrap()
}

/// Truth: P L^3/3EI, and with shear P L ASY/GA more; rotations of 5E-7 change neither by a part in 1E9.
#[test]
fn nonlinear_beams_shear_where_it_is_asked_for() {
    let chain = "chain n=1 formulation=nonlinear ea=100 shear_y=1.2";
    let load = "tip force y=1E-6";
    close("without", tip(chain, load, &[]), 1e-6 / 3.0, 1e-14);
    close("with", tip(chain, load, &["--nonlinear-shear"]), 1e-6 / 3.0 + 1.2e-8, 1e-14);
}

/// Truth: I turned from J by a rotation vector without x component is not twisted by that measure; by
/// projected axes it is, by atan2(-R23, R33). T = G Ixx/L times the angle, at I.
#[test]
fn angles_of_linear_beams_are_measured_as_asked_for() {
    let (b, c) = (0.2_f64, -0.15_f64);
    let angle = b.hypot(c);
    let (one, two) = (angle.sin() / angle, (1.0 - angle.cos()) / (angle * angle));
    let r = |row: usize, column: usize| {
        let t = [0.0, b, c];
        let skew = [[0.0, -c, b], [c, 0.0, 0.0], [-b, 0.0, 0.0]];
        let unit = if row == column { angle.cos() } else { 0.0 };
        unit + one * skew[row][column] + two * t[row] * t[column]
    };
    let (psi, theta, phi) = (r(0, 2).atan2(-r(1, 2)), r(2, 2).acos(), r(2, 0).atan2(r(2, 1)));
    let mut commands = UNITS.to_string();
    part(&mut commands, "a", "2,0,0");
    marker(&mut commands, "ground.root", "0,0,0", "0,0,0");
    let turned = format!("{},{},{}", psi.to_degrees(), theta.to_degrees(), phi.to_degrees());
    marker(&mut commands, "a.turned", "2,0,0", &turned);
    beam(&mut commands, "b", "a.turned", "ground.root", "length=2");
    let folder = folder(&commands);
    let torque =
        |options: &[&str]| report(&folder, &[&["m.cmd"], options].concat())["beams"][0]["t_i"].as_f64().unwrap();
    let stiffness = 8e10 * 2e-8 / 2.0;
    let projected = stiffness * (-r(1, 2)).atan2(r(2, 2));
    assert!(projected.abs() > 1.0);
    close("projected", torque(&[]), projected, 1e-9 * stiffness);
    close("projected by name", torque(&["--beam-angles", "projected"]), projected, 1e-9 * stiffness);
    close("rotation vector", torque(&["--beam-angles", "rotvec"]), 0.0, 1e-9 * stiffness);
    let (status, _, errors) = run(&folder, &["beams", "m.cmd", "--beam-angles", "euler"]);
    assert!(status == 2 && errors.contains("projected") && errors.contains("rotvec"), "{errors}");
}

/// Truth: a beam that is only pulled has no moment but rounding, which is nothing to measure the balance
/// by: force times distance is 2E4 N m, of which rounding is 1E-16.
#[test]
fn a_beam_that_is_only_pulled_balances() {
    for degrees in [30.0_f64, 17.3, 50.0, 71.0] {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let at = |r: f64| format!("{:?},{:?},0", r * cosine, r * sine);
        let turned = format!("{degrees:?},0,0");
        let mut commands = UNITS.to_string();
        part(&mut commands, "a", "0,0,0");
        writeln!(commands, "marker modify marker_name=.m.a.cm location={}", at(1.37)).unwrap();
        marker(&mut commands, "a.i", &at(1.001), &turned);
        marker(&mut commands, "ground.root", "0,0,0", &turned);
        beam(&mut commands, "one", "a.i", "ground.root", "length=1");
        let found = report(&folder(&commands), &["m.cmd"]);
        close("N", found["beams"][0]["n"].as_f64().unwrap(), 2e4, 1e-6);
        close("balance", found["beams"][0]["residual"].as_f64().unwrap(), 0.0, 1e-12);
    }
}

/// Twin: `--at` means seconds of a run and of a results file alike, also where the model's unit is another.
#[test]
fn at_is_in_seconds_whatever_the_unit_of_the_model() {
    let folder = folder(&format!("{}defaults units time=millisecond\n", cantilever("linear")));
    fine(&folder, &["simulate", "m.cmd", "--end", "0.4", "--steps", "1", "--beam-loads", "--out", "r.csv"]);
    let recorded = report(&folder, &["m.cmd", "--result", "r.csv", "--at", "0.4"]);
    let own = report(&folder, &["m.cmd", "--at", "0.4"]);
    assert_eq!((&recorded["time"], &own["time"]), (&Value::from(400.0), &Value::from(400.0)));
    assert_eq!(recorded["beams"], own["beams"]);
    assert_eq!(report(&folder, &["m.cmd", "--result", "r.csv", "--at", "0"])["time"], 0.0);
    let (status, _, errors) = run(&folder, &["beams", "m.cmd", "--result", "r.csv", "--at", "400"]);
    assert!(status == 1 && errors.contains("they go from 0 to 400 millisecond"), "{errors}");
}
