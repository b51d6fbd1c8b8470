//! The reference cases of single beams and chains, each built by commands from its data and compared
//! by its own tolerances. They lie in the shared folder that `FLEXURE_SHARED` names.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use flexure::{Analysis, Mode, ModesAbout, ModesReport, Outputs, Run, Session, SimulationOptions};
use glam::{DMat3, DVec3};
use serde_json::Value;

/// Expected values that no chain has, and why they are not compared.
const LIMITS: &[(&str, &str)] = &[
    ("u_over_L", "inextensible continuum to 1e-9; chains of this EA are 1e-6 off it"),
    ("v_over_L", "as u_over_L"),
    ("theta", "as u_over_L"),
    ("tip_continuous", "the continuum; a finite chain is not on it"),
    ("P_cr_continuous", "the continuum"),
    ("v_tip_continuous", "the continuum"),
    ("theta_tip_continuous", "the continuum"),
];

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(all) => all.iter().filter_map(Value::as_f64).collect(),
        other => other.as_f64().into_iter().collect(),
    }
}

fn vector(value: &Value) -> DVec3 {
    DVec3::from_slice(&numbers(value))
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or(0.0)
}

fn beams() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../mechanisms/beams/beams.cmd")
}

fn session(text: &str) -> Session {
    let mut session = Session::new();
    let read = session.read(&beams());
    assert_eq!(read.failed, 0);
    let report = session.execute(text);
    assert_eq!(report.failed, 0, "{}\n{text}", session.render(&report.diagnostics, false));
    session
}

fn run(text: &str, analysis: Analysis) -> Run {
    let mut session = session(text);
    session.simulate(&SimulationOptions::new(analysis)).unwrap_or_else(|d| panic!("{}", session.render(&d, false)))
}

fn modes(text: &str, about: &ModesAbout) -> ModesReport {
    let mut session = session(text);
    session.modes(about).unwrap_or_else(|d| panic!("{}", session.render(&d, false)))
}

fn last(run: &Run, name: &str) -> f64 {
    *run.table.get(name).unwrap_or_else(|| panic!("no series {name}")).values.last().unwrap()
}

// ---- chains ----

/// The `chain` command for a case.
fn chain(model: &Value, n: usize, more: &str) -> String {
    let b = &model["beam"];
    let (e, area) = (number(b, "E"), number(b, "AREA"));
    let (iyy, izz) = (number(b, "IYY"), number(b, "IZZ"));
    let (length, density) = (number(model, "L"), number(model, "density"));
    let (mass, rho_l) = (if density > 0.0 { density * area * length } else { 1.0 }, density * length);
    let mut text = format!(
        "chain n={n} length={length:?} ea={:?} ei_y={:?} ei_z={:?} gj={:?} ratio={:?} mass={mass:?}",
        e * area,
        e * iyy,
        e * izz,
        number(b, "G") * number(b, "IXX"),
        number(b, "CRATIO")
    );
    if density > 0.0 {
        let (about_y, about_z) = (rho_l * iyy, rho_l * izz);
        write!(text, " polar={:?} rotary_y={about_y:?} rotary_z={about_z:?}", about_y + about_z).unwrap();
    }
    writeln!(text, " {more}").unwrap();
    text
}

/// Position of the tip and its rotation about z, the turn nearest to `near`.
fn planar_tip(run: &Run, near: f64) -> [f64; 3] {
    let turned = (last(run, "TIP.R1") + last(run, "TIP.R3")).to_radians();
    let turns = ((near - turned) / TAU).round();
    [last(run, "TIP.X"), last(run, "TIP.Y"), turned + turns * TAU]
}

fn deflections(id: &str, case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    let model = &case["model"];
    let length = number(model, "L");
    let load = match (numbers(&model["tip_force"]).as_slice(), numbers(&model["tip_torque"]).as_slice()) {
        ([x, y, z], _) => format!("tip force x={x:?} y={y:?} z={z:?}"),
        (_, [_, _, z]) => format!("tip moment size={z:?}"),
        other => panic!("{id}: {other:?}"),
    };
    let expected = case["expected"].as_object().unwrap();
    for (name, wanted) in expected {
        let wanted = numbers(&wanted["value"]);
        let Some(n) = name.split('N').nth(1).and_then(|t| t.split('_').next()).and_then(|t| t.parse().ok()) else {
            continue;
        };
        let all = ["linear", "string", "nonlinear"];
        for formulation in if name.contains("any_formulation") { &all[..] } else { &all[..1] } {
            let text = chain(model, n, &format!("formulation={formulation}")) + &load;
            let near = *wanted.last().unwrap();
            let [x, y, turned] = planar_tip(&run(&text, Analysis::Static), near);
            let values = match id.split('_').nth(1).unwrap() {
                "elastica" => vec![1.0 - x / length, y / length, turned],
                "rollup" => vec![x / length, y / length, turned],
                _ => vec![y, turned],
            };
            found.push((name.clone(), values));
        }
    }
}

/// The load at which the lowest mode about the compressed column has frequency zero.
fn buckling(case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    for (name, wanted) in case["expected"].as_object().unwrap() {
        let Some(n) = name.strip_prefix("P_cr_chain_N").and_then(|t| t.strip_suffix("_linear")) else { continue };
        let square = |load: f64| {
            let text = chain(&case["model"], n.parse().unwrap(), "") + &format!("tip force x=\"-{load:?}\"");
            let lowest = modes(&text, &ModesAbout::Equilibrium).modes[0].clone();
            lowest.imaginary * lowest.imaginary - lowest.real * lowest.real
        };
        let guess = numbers(&wanted["value"])[0];
        let (mut a, mut b) = (0.9 * guess, 0.99 * guess);
        let (mut at_a, mut at_b) = (square(a), square(b));
        while (b - a).abs() > 1e-6 * b {
            let next = b - at_b * (b - a) / (at_b - at_a);
            (a, at_a, b, at_b) = (b, at_b, next, square(next));
        }
        found.push((name.clone(), vec![b]));
    }
}

// ---- modes ----

/// What moves most in a mode: `bending_y`, `bending_z`, `torsion` or `axial`.
fn kind(report: &ModesReport, mode: &Mode) -> &'static str {
    let mut sizes = [0.0; 4];
    for (name, (re, im)) in report.unknowns.iter().zip(&mode.shape) {
        let axis = name.chars().last().unwrap();
        let index = match (name.contains("rotation"), axis) {
            (false, 'y') | (true, 'z') => 0,
            (false, 'z') | (true, 'y') => 1,
            (true, _) => 2,
            (false, _) => 3,
        };
        sizes[index] += re * re + im * im;
    }
    let best = (0..4).max_by(|a, b| sizes[*a].total_cmp(&sizes[*b])).unwrap();
    ["bending_y", "bending_z", "torsion", "axial"][best]
}

fn of_kind<'a>(report: &'a ModesReport, wanted: &str) -> Vec<&'a Mode> {
    report.modes.iter().filter(|m| kind(report, m) == wanted).collect()
}

fn frequencies(case: &Value, found: &mut Vec<(String, Vec<f64>)>, n: usize) {
    let report = modes(&chain(&case["model"], n, ""), &ModesAbout::Present);
    for (name, wanted) in case["expected"].as_object().unwrap() {
        let count = numbers(&wanted["value"]).len();
        let kind = ["bending_y", "bending_z", "torsion", "axial"].into_iter().find(|k| name.ends_with(k)).unwrap();
        let mut modes = of_kind(&report, kind);
        if name.starts_with("real_roots") {
            let mut roots: Vec<f64> = modes.iter().map(|m| m.real).collect();
            roots.sort_by(f64::total_cmp);
            found.push((name.clone(), roots));
            continue;
        }
        let overdamped = name == "zeta_torsion";
        if overdamped {
            // Two real roots a and b stand for w^2 = a b and 2 zeta w = a + b.
            let (a, b) = (-modes[0].real, -modes[1].real);
            found.push((name.clone(), vec![0.5 * (a + b) / (a * b).sqrt()]));
            continue;
        }
        modes.truncate(count);
        let value = |m: &&Mode| match name.split("_bending").next().unwrap() {
            "zeta" => m.damping_ratio,
            "eigenvalue_imag" => m.imaginary,
            "eigenvalue_real" => m.real,
            _ => m.frequency_hz * TAU,
        };
        found.push((name.clone(), modes.iter().map(value).collect()));
    }
}

fn spinning(model: &Value, n: usize, rate: f64, formulation: &str) -> ModesReport {
    let text = chain(model, n, &format!("formulation={formulation} turn=\"{rate:?}*time\""));
    modes(&text, &ModesAbout::Spin { marker: ".chain.ground.node_0".into(), rate })
}

fn rotating(case: &Value, found: &mut Vec<(String, Vec<f64>)>, n: usize) {
    let model = &case["model"];
    let scale = number(model, "scale_Omega");
    for (name, wanted) in case["expected"].as_object().unwrap() {
        let (what, eta) = name.split_once("_eta").unwrap();
        let report = spinning(model, n, eta.parse::<f64>().unwrap() * scale, "linear");
        let count = numbers(&wanted["value"]).len();
        let kind = if what == "flap" { "bending_z" } else { "bending_y" };
        // At rest both planes are equal and their modes mix: one of each pair.
        let modes = if eta == "0" {
            let bending = report.modes.iter().filter(|m| self::kind(&report, m).starts_with("bending"));
            bending.step_by(2).collect()
        } else {
            of_kind(&report, kind)
        };
        let values = if what == "lag_growth" {
            vec![modes.iter().map(|m| m.real).fold(0.0, f64::max) / scale]
        } else {
            modes.iter().take(count).map(|m| m.frequency_hz * TAU / scale).collect()
        };
        found.push((name.clone(), values));
    }
}

/// Frequencies of the continuous beam from chains: the polynomial in (1/N)^2 through four of them at 1/N = 0,
/// each without stretching by the straight line through two of them at 1/EA = 0, and without rotary inertia,
/// as the table is. (Chains that hardly stretch need no line, but lose as many digits in their low modes.)
fn rotating_table(case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    let beams = [8_usize, 12, 16, 24];
    let stretches = [1e-6, 5e-7];
    let names = ["lag1", "flap1", "lag2", "flap2"];
    let mut rows: [Vec<f64>; 4] = Default::default();
    for eta in numbers(&case["model"]["values_of_eta"]) {
        let lowest = |n: usize, stretch: f64| -> Vec<f64> {
            let text = format!(
                "chain n={n} formulation=nonlinear ea={:?} rotary_y=1e-10 rotary_z=1e-10 polar=1e-10 turn=\"{eta:?}*time\"",
                1.0 / stretch
            );
            let about = ModesAbout::Spin { marker: ".chain.ground.node_0".into(), rate: eta };
            // Bending in turn; turning and stretching are far above.
            modes(&text, &about).modes.iter().take(4).map(|mode| mode.frequency_hz * TAU).collect()
        };
        let mut sets: [Vec<f64>; 4] = Default::default();
        for n in beams {
            let [more, less] = stretches.map(|stretch| lowest(n, stretch));
            for (set, (more, less)) in sets.iter_mut().zip(more.iter().zip(less)) {
                set.push(at_zero(&stretches, vec![*more, less]));
            }
        }
        let steps = beams.map(|n| 1.0 / (n * n) as f64);
        for (row, set) in rows.iter_mut().zip(sets) {
            row.push(at_zero(&steps, set));
        }
    }
    found.extend(names.iter().zip(rows).map(|(name, row)| ((*name).to_string(), row)));
}

/// Neville's scheme: the polynomial through the points, at zero.
fn at_zero(x: &[f64], mut y: Vec<f64>) -> f64 {
    for level in 1..x.len() {
        for i in 0..x.len() - level {
            y[i] = (x[i + level] * y[i] - x[i] * y[i + 1]) / (x[i + level] - x[i]);
        }
    }
    y[0]
}

/// Slope of the squared frequency over the squared rate, from 16 NONLINEAR beams at rest and slowly
/// turning.
fn southwell(found: &mut Vec<(String, Vec<f64>)>) {
    let text = |rate: f64| {
        format!("chain n=16 formulation=nonlinear ea=1e8 rotary_y=1e-8 rotary_z=1e-8 polar=1e-8 turn=\"{rate:?}*time\"")
    };
    let rate = 0.5;
    let about = |rate: f64| ModesAbout::Spin { marker: ".chain.ground.node_0".into(), rate };
    let squares = |rate: f64| -> Vec<f64> {
        let report = modes(&text(rate), &about(rate));
        report.modes.iter().take(4).map(|m| (m.frequency_hz * TAU).powi(2)).collect()
    };
    let (rest, turning) = (squares(0.0), squares(rate));
    // At rest both planes are equal; turning, lag lies below flap.
    for (k, name) in ["S_lag_mode1", "S_flap_mode1", "S_lag_mode2", "S_flap_mode2"].iter().enumerate() {
        found.push(((*name).to_string(), vec![(turning[k] - rest[k]) / (rate * rate)]));
    }
}

// ---- spin-up ----

fn spin_up(case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    let model = &case["model"];
    let samples = numbers(&model["sample_times"]);
    let psi = "IF(time-15: 6/15*(time**2/2+(15/(2*pi))**2*(cos(2*pi*time/15)-1)), 45, 45+6*(time-15))";
    let mut kept: BTreeMap<usize, [Vec<f64>; 2]> = BTreeMap::new();
    let mut extremes = BTreeMap::new();
    for n in [4, 8, 16, 32] {
        let set = "executive_control set numerical_integration_parameters model_name=.chain integrator_type=hht \
                   error_tolerance=1.0E-9 hmax_time_step=0.01\n";
        let text = chain(model, n, &format!("turn=\"{psi}\"")) + set;
        let run = run(&text, Analysis::Dynamic { end: 20.0, outputs: Outputs::Steps(400) });
        let series = |name: &str| &run.table.get(name).unwrap().values;
        let (x, y, times) = (series("TIP.X"), series("TIP.Y"), &run.table.series[0].values);
        let at = |values: &[f64], offset: f64| -> Vec<f64> {
            samples.iter().map(|t| values[(t / 0.05).round() as usize] - offset).collect()
        };
        let row = (0..y.len()).min_by(|a, b| y[*a].total_cmp(&y[*b])).unwrap();
        extremes.insert(n, y[row]);
        if n < 32 {
            found.push((format!("u2_extreme_N{n}"), vec![y[row], times[row]]));
        }
        kept.insert(n, [at(x, number(model, "L")), at(y, 0.0)]);
        if n < 32 {
            found.push((format!("u1_N{n}"), kept[&n][0].clone()));
            found.push((format!("u2_N{n}"), kept[&n][1].clone()));
        } else {
            let after: Vec<f64> =
                times.iter().zip(x).filter(|(t, _)| **t >= 15.0).map(|(_, x)| x - number(model, "L")).collect();
            found.push(("steady_extension".into(), vec![after.iter().sum::<f64>() / after.len() as f64]));
        }
    }
    // Second order in 1/N: the limit from 16 and 32 beams.
    let limit = |coarse: f64, fine: f64| (4.0 * fine - coarse) / 3.0;
    let converged = kept[&16][1].iter().zip(&kept[&32][1]).map(|(a, b)| limit(*a, *b)).collect();
    found.push(("u2_converged".into(), converged));
    found.push(("u2_extreme_converged".into(), vec![limit(extremes[&16], extremes[&32])]));
}

// ---- one beam ----

/// A beam between markers `.m.i.end` and `J`, with what it does recorded.
fn one_beam(data: &Value, j: &str) -> String {
    let mut text = String::from("force create element_like beam beam_name=.m.beam i_marker_name=.m.i.end ");
    let keys = [
        ("E", "youngs_modulus"),
        ("G", "shear_modulus"),
        ("AREA", "area_of_cross_section"),
        ("IXX", "ixx"),
        ("IYY", "iyy"),
        ("IZZ", "izz"),
        ("LENGTH", "length"),
        ("ASY", "y_shear_area_ratio"),
        ("ASZ", "z_shear_area_ratio"),
        ("CRATIO", "damping_ratio"),
    ];
    write!(text, "j_marker_name={j}").unwrap();
    for (key, name) in keys.iter().filter(|(key, _)| data[*key].is_number()) {
        write!(text, " {name}={:?}", number(data, key)).unwrap();
    }
    let terms = numbers(&data["CMATRIX_r1_to_r21"]);
    if !terms.is_empty() {
        write!(
            text,
            " matrix_of_damping_terms={}",
            terms.iter().map(|c| format!("{c:?}")).collect::<Vec<_>>().join(",")
        )
        .unwrap();
    }
    text.push('\n');
    let mut request = |name: &str, functions: Vec<String>| {
        write!(text, "output_control create request request_name=.m.{name}").unwrap();
        for (k, function) in functions.iter().enumerate() {
            write!(text, " f{}=\"{function}\"", k + 1).unwrap();
        }
        text.push('\n');
    };
    for (name, flag, rm) in [("on_i", 0, "0"), ("on_j", 1, "0"), ("in_j", 0, j)] {
        request(name, [2, 3, 4, 6, 7, 8].iter().map(|c| format!("BEAM(.m.beam, {flag}, {c}, {rm})")).collect());
    }
    let of = |f: &str| format!("{f}(.m.i.end, {j}, 0)");
    request("arm", ["DX", "DY", "DZ"].iter().map(|f| of(f)).collect());
    request("angles", ["AX", "AY", "AZ"].iter().map(|f| format!("{f}(.m.i.end, {j})")).collect());
    request("place", ["DX", "DY", "DZ"].iter().map(|f| format!("{f}(.m.i.end, 0, 0)")).collect());
    request("place_j", ["DX", "DY", "DZ"].iter().map(|f| format!("{f}({j}, 0, 0)")).collect());
    text
}

const HEAD: &str = "\
defaults units length=meter mass=kg force=newton time=second angle=rad
model create model_name=m
executive_control set equilibrium_parameters model_name=.m error=1.0E-12 imbalance=1.0E-9 maxit=100
";

/// Euler angles of the sequence 3-1-3, rad.
fn euler(axes: DMat3) -> [f64; 3] {
    let (x, y, z) = (axes.x_axis, axes.y_axis, axes.z_axis);
    let sine = z.x.hypot(z.y);
    if sine < 1e-12 {
        return [x.y.atan2(x.x), if z.z > 0.0 { 0.0 } else { TAU / 2.0 }, 0.0];
    }
    [z.x.atan2(-z.y), sine.atan2(z.z), x.z.atan2(y.z)]
}

/// A body with a marker `end` at a place.
fn body(name: &str, at: DVec3, axes: DMat3, velocity: DVec3, spin: DVec3, inertia: [f64; 4]) -> String {
    let ([a, b, c], [mass, ixx, iyy, izz]) = (euler(axes), inertia);
    format!(
        "part create rigid_body name_and_position part_name=.m.{name} location={:?},{:?},{:?} orientation={a:?},{b:?},{c:?}\n\
         marker create marker_name=.m.{name}.end location=0,0,0 orientation=0,0,0 relative_to=.m.{name}\n\
         part create rigid_body mass_properties part_name=.m.{name} mass={mass:?} center_of_mass_marker=.m.{name}.end \
         ixx={ixx:?} iyy={iyy:?} izz={izz:?}\n\
         part create rigid_body initial_velocity part_name=.m.{name} vx={:?} vy={:?} vz={:?} wx={:?} wy={:?} wz={:?}\n",
        at.x, at.y, at.z, velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z
    )
}

fn three(run: &Run, request: &str, from: usize) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|k| last(run, &format!("{request}.F{}", from + k))))
}

/// Loads at both ends by their names in the cases.
fn loads(run: &Run, names: [&str; 4], found: &mut Vec<(String, Vec<f64>)>) {
    for (name, (request, from)) in names.iter().zip([("on_i", 1), ("on_i", 4), ("on_j", 1), ("on_j", 4)]) {
        found.push(((*name).to_string(), three(run, request, from).to_array().to_vec()));
    }
}

const GROUND: &str = "marker create marker_name=.m.ground.root location=0,0,0 orientation=0,0,0\n";

fn clamped(case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    let data = &case["model"]["beam"];
    let load = &case["model"]["load_on_part_of_I_at_I"];
    let length = number(data, "LENGTH");
    let mut text = HEAD.to_string() + GROUND;
    let at = DVec3::new(length, 0.0, 0.0);
    text += &body("i", at, DMat3::IDENTITY, DVec3::ZERO, DVec3::ZERO, [1.0; 4]);
    text += &one_beam(data, ".m.ground.root");
    let quarter = TAU / 4.0;
    for (axis, [a, b]) in [[quarter, quarter], [2.0 * quarter, quarter], [0.0, 0.0]].iter().enumerate() {
        writeln!(text, "marker create marker_name=.m.ground.a{axis} location=0,0,0 orientation={a:?},{b:?},0").unwrap();
        for (kind, size) in [("translational", &load["force"]), ("rotational", &load["torque"])] {
            writeln!(
                text,
                "force create direct single_component_force single_component_force_name=.m.{kind}_{axis} \
                 type_of_freedom={kind} action_only=on i_marker_name=.m.i.end j_marker_name=.m.ground.a{axis} \
                 function=\"{:?}\"",
                numbers(size)[axis]
            )
            .unwrap();
        }
    }
    let run = run(&text, Analysis::Static);
    found.push(("displacement_of_I".into(), (three(&run, "place", 1) - at).to_array().to_vec()));
    found.push(("rotation_of_I".into(), three(&run, "angles", 1).to_array().to_vec()));
    loads(&run, ["beam_force_on_I", "beam_torque_on_I", "beam_force_on_J", "beam_torque_on_J"], found);
}

fn damping_matrix(case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    let model = &case["model"];
    let (data, b) = (&model["beam"], &model["body"]);
    let inertia = vector(&b["inertia"]);
    let at = DVec3::new(number(data, "LENGTH"), 0.0, 0.0);
    let text = |velocity: DVec3, spin: DVec3| {
        let inertia = [number(b, "mass"), inertia.x, inertia.y, inertia.z];
        let part = body("i", at, DMat3::IDENTITY, velocity, spin, inertia);
        HEAD.to_string() + GROUND + &part + &one_beam(data, ".m.ground.root")
    };
    let moving = text(vector(&model["initial_velocity"]), vector(&model["initial_angular_velocity"]));
    loads(&run(&moving, Analysis::Assemble), ["force_on_I", "torque_on_I", "force_on_J", "torque_on_J"], found);
    let mut report = modes(&text(DVec3::ZERO, DVec3::ZERO), &ModesAbout::Present).modes;
    report.sort_by(|a, b| a.imaginary.total_cmp(&b.imaginary));
    found.push(("eigenvalues_imag".into(), report.iter().map(|m| m.imaginary).collect()));
    found.push(("eigenvalues_real".into(), report.iter().map(|m| m.real).collect()));
}

fn free_pair(case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    let model = &case["model"];
    let part = |name: &str| {
        let end = &model[name.to_uppercase()];
        let rows = [0, 1, 2].map(|k| vector(&end["axes_columns"][k]));
        let axes = DMat3::from_cols(rows[0], rows[1], rows[2]).transpose();
        let [at, v, w] = ["position", "velocity", "angular_velocity"].map(|key| vector(&end[key]));
        body(name, at, axes, v, w, [1.0; 4])
    };
    let text = HEAD.to_string() + &part("i") + &part("j") + &one_beam(&model["beam"], ".m.j.end");
    let run = run(&text, Analysis::Assemble);
    loads(&run, ["force_on_I", "torque_on_I", "force_on_J", "torque_on_J"], found);
    found.push(("force_on_I_in_J_axes".into(), three(&run, "in_j", 1).to_array().to_vec()));
    found.push(("torque_on_I_in_J_axes".into(), three(&run, "in_j", 4).to_array().to_vec()));
    let [f_i, t_i, f_j, t_j] = [("on_i", 1), ("on_i", 4), ("on_j", 1), ("on_j", 4)].map(|(r, k)| three(&run, r, k));
    let balance = t_i + t_j + three(&run, "place", 1).cross(f_i) + three(&run, "place_j", 1).cross(f_j);
    found.push(("moment_balance".into(), balance.to_array().to_vec()));
}

/// A fixed part, a beam and a hanging part with a load off its centre.
fn static_frame(case: &Value, found: &mut Vec<(String, Vec<f64>)>) {
    let model = &case["model"];
    let (a, b) = (&model["part_A"], &model["part_B"]);
    let rows = [0, 1, 2].map(|k| vector(&a["J_marker"]["axes_columns"][k]));
    let axes = DMat3::from_cols(rows[0], rows[1], rows[2]).transpose();
    let place = |v: DVec3| format!("{:?},{:?},{:?}", v.x, v.y, v.z);
    let [at_j, at_i] = [&a["J_marker"], &b["undeformed_I_marker"]].map(|m| vector(&m["position"]));
    let mut text = HEAD.to_string() + GROUND;
    for (name, at, part) in [("j", at_j, a), ("i", at_i, b)] {
        text += &body(name, at, axes, DVec3::ZERO, DVec3::ZERO, [number(part, "mass"), 1.0, 1.0, 1.0]);
    }
    let fixed = place(vector(&a["fixed_to_ground_at"]));
    let turned = vector(&a["fixed_joint_marker_REULER_deg"]) * (TAU / 360.0);
    let centre = [place(vector(&a["centre_of_mass"])), place(vector(&b["centre_of_mass_from_I_in_I_axes"]))];
    let gravity = vector(&model["gravity"]);
    write!(
        text,
        "marker create marker_name=.m.j.cm location={} relative_to=.m.ground\n\
         marker create marker_name=.m.i.cm location={} relative_to=.m.i\n\
         part modify rigid_body mass_properties part_name=.m.j center_of_mass_marker=.m.j.cm\n\
         part modify rigid_body mass_properties part_name=.m.i center_of_mass_marker=.m.i.cm\n\
         marker create marker_name=.m.i.load location={} relative_to=.m.i\n\
         marker create marker_name=.m.j.fix location={fixed} orientation={angles} relative_to=.m.ground\n\
         marker create marker_name=.m.ground.fix location={fixed} orientation={angles} relative_to=.m.ground\n\
         constraint create joint fixed joint_name=.m.fix i_marker_name=.m.j.fix j_marker_name=.m.ground.fix\n\
         force create body gravitational gravity_field_name=.m.g x_component_gravity={:?} y_component_gravity={:?} \
         z_component_gravity={:?}\n",
        centre[0],
        centre[1],
        place(vector(&b["load_point_from_I_in_I_axes"])),
        gravity.x,
        gravity.y,
        gravity.z,
        angles = place(turned),
    )
    .unwrap();
    let quarter = TAU / 4.0;
    for (axis, [p, q]) in [[quarter, quarter], [2.0 * quarter, quarter], [0.0, 0.0]].iter().enumerate() {
        write!(
            text,
            "marker create marker_name=.m.ground.a{axis} location=0,0,0 orientation={p:?},{q:?},0 relative_to=.m.ground\n\
             force create direct single_component_force single_component_force_name=.m.load_{axis} \
             type_of_freedom=translational action_only=on i_marker_name=.m.i.load j_marker_name=.m.ground.a{axis} \
             function=\"{:?}\"\n",
            numbers(&b["load"])[axis]
        )
        .unwrap();
    }
    text += &one_beam(&model["beam"], ".m.j.end");
    for (name, rm) in [("fix_global", "0"), ("fix_axes", ".m.ground.fix")] {
        write!(text, "output_control create request request_name=.m.{name}").unwrap();
        for (k, c) in [2, 3, 4, 6, 7, 8].iter().enumerate() {
            write!(text, " f{}=\"JOINT(.m.fix, 1, {c}, {rm})\"", k + 1).unwrap();
        }
        text.push('\n');
    }
    let run = run(&text, Analysis::Static);
    loads(&run, ["force_on_I", "torque_on_I", "force_on_J", "torque_on_J"], found);
    let relative = axes.transpose() * three(&run, "arm", 1) - DVec3::X * number(&model["beam"], "LENGTH");
    for (name, value) in [
        ("I_position", three(&run, "place", 1)),
        ("relative_displacement", relative),
        ("relative_rotation", three(&run, "angles", 1)),
        ("fixed_joint_force_on_ground", three(&run, "fix_global", 1)),
        ("fixed_joint_torque_on_ground", three(&run, "fix_global", 4)),
        ("fixed_joint_force_in_marker_axes", three(&run, "fix_axes", 1)),
        ("fixed_joint_torque_in_marker_axes", three(&run, "fix_axes", 4)),
    ] {
        found.push((name.to_string(), value.to_array().to_vec()));
    }
}

/// Everything found for a case; a name can stand there more than once.
fn compute(id: &str, case: &Value) -> Vec<(String, Vec<f64>)> {
    let mut found = Vec::new();
    let count = || id.rsplit('N').next().and_then(|n| n.parse().ok()).expect("a number of beams");
    match id {
        "C_euler_cantilever" => buckling(case, &mut found),
        "E_cmatrix_a" => damping_matrix(case, &mut found),
        "G_southwell" => southwell(&mut found),
        "F7_static_frame" => static_frame(case, &mut found),
        "G_rotating_cantilever_table" => rotating_table(case, &mut found),
        "H_spinup_kane" => spin_up(case, &mut found),
        _ if id.starts_with('A') => clamped(case, &mut found),
        _ if id.starts_with('B') || id.starts_with('C') => deflections(id, case, &mut found),
        _ if id.starts_with('D') => frequencies(case, &mut found, count()),
        _ if id.starts_with('F') => free_pair(case, &mut found),
        _ if id.starts_with('G') => rotating(case, &mut found, count()),
        other => panic!("{other} is a new case"),
    }
    found
}

#[test]
fn beams_meet_the_reference_cases() {
    let Some(shared) = std::env::var_os("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return;
    };
    let text = std::fs::read_to_string(Path::new(&shared).join("reference/beams/cases.json")).unwrap();
    let file: Value = serde_json::from_str(&text).unwrap();
    let mut wrong = Vec::new();
    for (id, case) in file["cases"].as_object().unwrap() {
        let found = compute(id, case);
        let expected = case["expected"].as_object().unwrap();
        let (mut met, mut worst): (usize, f64) = (0, 0.0);
        for (name, values) in &found {
            let wanted = numbers(&expected[name]["value"]);
            let largest = wanted.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let allowed = number(&expected[name], "atol") + number(&expected[name], "rtol") * largest;
            let off = wanted.iter().zip(values).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            met += 1;
            worst = worst.max(off / allowed);
            let within = off <= allowed;
            if wanted.len() != values.len() || !within {
                wrong.push(format!("{id} {name}: {values:?}, not {wanted:?} ({off:.1e} > {allowed:.1e})"));
            }
        }
        let left: Vec<&String> = expected.keys().filter(|k| !found.iter().any(|(name, _)| name == *k)).collect();
        for name in &left {
            if !LIMITS.iter().any(|(known, _)| known == name) {
                wrong.push(format!("{id} {name} was not computed"));
            }
        }
        println!("{id:32} {met:3} compared, worst {worst:.1e} of its tolerance, {} limits left out", left.len());
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}
