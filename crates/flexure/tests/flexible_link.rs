//! Discrete flexible links: what they weigh, how they bend, and how they approach the continuous beam.

use std::sync::{Arc, Mutex};

use flexure::{Analysis, ModesAbout, RunObserver, Session, SimulationOptions};

/// A steel bar of 20 x 10 mm and 1 m between two markers of ground, askew in space.
const HEAD: &str = "\
defaults units length=mm angle=deg force=newton mass=kg time=sec
model create model_name=m
material create material_name=.m.steel density=7.8e-6 youngs_modulus=2e5 poissons_ratio=0.3
section create rectangle section_name=.m.s width=20 height=10 shear_theory=none
marker create marker_name=.m.ground.a location=100,0,0 orientation=0,0,0
marker create marker_name=.m.ground.b location=700,640,480 orientation=0,0,0
";

fn session(commands: &str) -> Session {
    let mut session = Session::new();
    let report = session.execute(&format!("{HEAD}{commands}"));
    assert!(report.diagnostics.is_empty(), "{}", session.render(&report.diagnostics, false));
    session
}

fn link(segments: usize, ends: [&str; 2]) -> String {
    format!(
        "flexible_link create link_name=arm marker_1=.m.ground.a marker_2=.m.ground.b segments={segments} \
         material_name=.m.steel section_name=.m.s attachment_1={} attachment_2={}\n",
        ends[0], ends[1]
    )
}

fn number(session: &Session, object: &str, cell: &str) -> f64 {
    let id = session.database().ids().find(|id| session.database().full_name(*id) == object).unwrap();
    session.database().number(id, cell).unwrap()
}

fn assert_close(found: f64, expected: f64, relative: f64, what: &str) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{what}: {found} is not {expected}");
}

/// Truth: density times volume; the inertia of a slab; lengths of the beams add up to the chord without
/// the rigid halves. All follow a change of the section.
#[test]
fn a_link_has_the_mass_and_the_length_of_its_bar() {
    for (ends, beams, flexible) in
        [(["flexible", "free"], 4, 3.5), (["rigid", "rigid"], 3, 3.0), (["flexible"; 2], 5, 4.0)]
    {
        let mut session = session(&link(4, ends));
        let parts: Vec<String> = (1..=4).map(|k| format!(".m.arm_{k}")).collect();
        let mass: f64 = parts.iter().map(|p| number(&session, p, "mass")).sum();
        assert_close(mass, 7.8e-6 * 200.0 * 1000.0, 1e-14, "mass");
        let slab = mass / 4.0 * (250.0_f64.powi(2) + 100.0) / 12.0;
        assert_close(number(&session, ".m.arm_2", "iyy"), slab, 1e-14, "inertia");
        let lengths: Vec<f64> = (1..=beams).map(|k| number(&session, &format!(".m.arm_BEAM_{k}"), "length")).collect();
        assert_close(lengths.iter().sum(), 250.0 * flexible, 1e-14, "length");
        assert_close(number(&session, ".m.arm_BEAM_1", "shear_modulus"), 2e5 / 2.6, 1e-14, "shear modulus");
        session.execute("section modify rectangle section_name=.m.s height=20");
        assert_close(number(&session, ".m.arm_1", "mass"), 7.8e-6 * 400.0 * 250.0, 1e-14, "mass after a change");
        assert_close(number(&session, ".m.arm_BEAM_1", "iyy"), 20.0_f64.powi(4) / 12.0, 1e-14, "iyy after a change");
    }
}

#[test]
fn a_link_is_one_step_of_undo() {
    let mut session = session(&link(3, ["rigid", "flexible"]));
    assert_eq!(session.objects("beam").len(), 3);
    assert_eq!(session.objects("joint").len(), 1);
    assert!(session.undo());
    assert_eq!((session.objects("beam").len(), session.objects("part").len()), (0, 1), "the ground is left");
    assert!(session.redo());
    assert_eq!(session.objects("beam").len(), 3);
}

/// Tip of a cantilever link in its own y under a force along y at the free end, mm.
fn tip(segments: usize, root: &str) -> f64 {
    let mut session = session(&link(segments, [root, "free"]));
    let setup = format!(
        "marker create marker_name=.m.ground.still location=(EVAL(LOC_RELATIVE_TO({{0,0,0}}, .m.arm_{segments}.arm_MARKER_2))) \
         orientation=(EVAL(ORI_RELATIVE_TO({{0,0,0}}, .m.arm_{segments}.arm_MARKER_2)))\n\
         marker create marker_name=.m.ground.up location=(EVAL(LOC_RELATIVE_TO({{0,0,0}}, .m.arm_{segments}.arm_MARKER_2))) \
         orientation=(EVAL(ORI_RELATIVE_TO({{0,-90,0}}, .m.arm_{segments}.arm_MARKER_2)))\n\
         force create direct single_component_force single_component_force_name=.m.f type_of_freedom=translational \
         i_marker_name=.m.arm_{segments}.arm_MARKER_2 j_marker_name=.m.ground.up action_only=on function=\"0.01\"\n\
         measure create function measure_name=.m.tip function=\"DY(.m.arm_{segments}.arm_MARKER_2, .m.ground.still, .m.ground.still)\" \
         units=length\n"
    );
    let report = session.execute(&setup);
    assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
    let run = session.simulate(&SimulationOptions::new(Analysis::Static)).unwrap();
    let series = run.table.series.iter().find(|s| s.name.to_ascii_lowercase().contains("tip")).unwrap();
    *series.values.last().unwrap()
}

/// Truth: Euler and Bernoulli with the rigid halves left out of the integral of the curvature. Of a root
/// that bends the error is 1 - 1/(8 n³); a rigid root takes 1 - (1 - 1/2n)³ more.
#[test]
fn a_cantilever_link_bends_as_its_elastic_parts_do() {
    let exact = 0.01 * 1000.0_f64.powi(3) / (3.0 * 2e5 * 10.0 * 20.0_f64.powi(3) / 12.0);
    for n in [1, 2, 5, 10] {
        let half = 0.5 / f64::from(n);
        // Deflections of 2.5e-3 mm in 1 m: large displacements matter to 1e-9.
        assert_close(tip(n as usize, "flexible"), exact * (1.0 - half.powi(3)), 1e-6, "flexible root");
        if n > 1 {
            assert_close(tip(n as usize, "rigid"), exact * ((1.0 - half).powi(3) - half.powi(3)), 1e-6, "rigid root");
        }
    }
}

/// Truth: 1.87510407² sqrt(E I / rho A L⁴); the error of lumped masses falls by 4 when the number of
/// segments doubles. The bar is 1 mm thin here, so that its rotary inertia, of which the formula knows
/// nothing, matters to 2e-7 only.
#[test]
fn frequencies_approach_those_of_the_beam_with_the_square_of_the_segment() {
    // 2e5 N/mm² are 2e8 kg/(mm s²).
    let stiffness = (2e8_f64 * 20.0 / 12.0 / (7.8e-6 * 20.0)).sqrt();
    let exact = 1.875_104_068_711_961_f64.powi(2) * stiffness / 1e6 / std::f64::consts::TAU;
    let lowest = |n: usize| {
        let mut session = session(&link(n, ["flexible", "free"]));
        session.execute("section modify rectangle section_name=.m.s height=1");
        session.modes(&ModesAbout::Present).unwrap().modes[0].frequency_hz
    };
    let errors = [5, 10, 20].map(|n| lowest(n) / exact - 1.0);
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((3.7..4.3).contains(&ratio), "{errors:?}");
    }
    assert!(errors[2].abs() < 2e-3, "{errors:?}");
}

#[derive(Default, Clone)]
struct Lines(Arc<Mutex<Vec<String>>>);

impl RunObserver for Lines {
    fn message(&mut self, line: &str) {
        self.0.lock().unwrap().push(line.to_string());
    }
}

#[test]
fn a_report_lists_theory_and_three_links() {
    let mut session = session("");
    let lines = Lines::default();
    session.set_observer(Box::new(lines.clone()));
    let report = session.execute(
        "flexible_link report material_name=.m.steel section_name=.m.s length=5000 segments=5 \
         attachment_1=flexible attachment_2=free",
    );
    assert!(report.diagnostics.is_empty(), "{}", session.render(&report.diagnostics, false));
    let lines = lines.0.lock().unwrap().clone();
    let first = lines.iter().find(|l| l.starts_with("bending about y, 1")).unwrap_or_else(|| panic!("{lines:#?}"));
    let numbers: Vec<f64> = first.split_whitespace().filter_map(|w| w.parse().ok()).collect();
    // Truth: 1.875² sqrt(EI / rho A) / (2 pi L²) with EI = 333.3 N m², rho A = 1.56 kg/m, L = 5 m: slender, so
    // that rotary inertia does not blur the ratio. Six decimals are shown.
    let exact = 1.875_104_068_711_961_f64.powi(2) * (2e11 * 20e-3 * 1e-6 / 12.0 / 1.56_f64).sqrt()
        / std::f64::consts::TAU
        / 25.0;
    assert!(numbers.iter().any(|f| (f / exact - 1.0).abs() < 3e-6), "{first}");
    let ratio = numbers.last().unwrap();
    assert!((3.7..4.3).contains(ratio), "{first}");
}

#[test]
fn what_makes_no_link_leaves_nothing() {
    let mut base = session(
        "marker create marker_name=.m.ground.c location=100,0,0\n\
         material create material_name=.m.oil density=1e-6\n",
    );
    let refused = |session: &mut Session, change: (&str, &str), code: &str| {
        let command = link(3, ["rigid", "free"]).replace(change.0, change.1);
        let report = session.execute(&command);
        let codes: Vec<&str> = report.diagnostics.iter().map(|d| d.code).collect();
        assert!(codes.contains(&code), "{code} is not in {codes:?}");
        assert_eq!(session.objects("part").len(), 1, "the ground is left");
    };
    refused(&mut base, ("marker_2=.m.ground.b", "marker_2=.m.ground.c"), "flexible_link/no-length");
    refused(&mut base, ("segments=3", "segments=0"), "flexible_link/segments");
    refused(&mut base, (".m.steel", ".m.oil"), "flexible_link/material");
    // A name that is taken: parts that are made before it are taken back.
    base.execute(
        "force create element_like beam beam_name=.m.arm_BEAM_2 i_marker_name=.m.ground.a j_marker_name=.m.ground.b",
    );
    refused(&mut base, ("", ""), "flexible_link/not-made");
}

/// Truth: the volume of the section times its length; of an ellipse of 24 corners 24/2 sin(15 degrees) / pi of
/// it, of a cylinder with 20 sides 20/2 sin(18 degrees) / pi. The solids lie along the segments, follow a
/// change of the section, and weigh nothing.
#[test]
fn segments_look_like_their_section() {
    let corners = |n: f64| n / 2.0 * (std::f64::consts::TAU / n).sin() / std::f64::consts::PI;
    for (section, create, area) in [
        ("s", "", 200.0),
        ("c", "section create circle section_name=.m.c diameter=20", corners(20.0) * std::f64::consts::PI * 100.0),
        (
            "t",
            "section create tube section_name=.m.t diameter=20 thickness=2",
            corners(20.0) * std::f64::consts::PI * 100.0,
        ),
        ("b", "section create box section_name=.m.b width=20 height=10 thickness=1", 200.0),
        (
            "e",
            "section create ellipse section_name=.m.e width=20 height=10",
            corners(24.0) * std::f64::consts::PI * 50.0,
        ),
        (
            "i",
            "section create i section_name=.m.i width=20 height=30 web_thickness=2 flange_thickness=3",
            2.0 * 60.0 + 48.0,
        ),
        (
            "p",
            "section create properties section_name=.m.p area_of_cross_section=200 iyy=(20*10**3/12) izz=(10*20**3/12) ixx=4574",
            200.0,
        ),
    ] {
        let make = link(4, ["flexible", "free"]).replace(".m.s ", &format!(".m.{section} "));
        let mut session = session(&format!("{create}\n{make}"));
        let shapes = session.objects("shape");
        assert_eq!(shapes.len(), 4, "{section}: {shapes:?}");
        let volume = |session: &Session| -> f64 {
            let database = session.database();
            let solids = shapes.iter().map(|name| {
                let id = database.ids().find(|id| database.full_name(*id) == *name).unwrap();
                let placed = elements::geometry::shape(database, id).unwrap().unwrap();
                // Metres.
                placed.shape.volume().unwrap().volume * 1e9
            });
            solids.sum()
        };
        assert_close(volume(&session), 1000.0 * area, 1e-9, section);
        // The solids lie between the ends of the link, and no further from its line than the section.
        let (start, along) = (glam::DVec3::new(0.1, 0.0, 0.0), glam::DVec3::new(0.6, 0.64, 0.48));
        let database = session.database();
        let mut reach = [f64::MAX, f64::MIN];
        for name in &shapes {
            let id = database.ids().find(|id| database.full_name(*id) == *name).unwrap();
            let placed = elements::geometry::shape(database, id).unwrap().unwrap();
            let pose = elements::place::global_pose(database, placed.on.body).then(&placed.on.pose);
            for point in placed.shape.lines().concat() {
                let from = pose.origin + pose.rotation * point - start;
                let x = from.dot(along);
                reach = [reach[0].min(x), reach[1].max(x)];
                assert!((from - along * x).length() < 0.019, "{section}: {point}");
            }
        }
        assert!(reach[0].abs() < 1e-9 && (reach[1] - 1.0).abs() < 1e-9, "{section}: {reach:?}");
        if section == "s" {
            session.execute("section modify rectangle section_name=.m.s height=30");
            assert_close(volume(&session), 600e3, 1e-9, "after a change");
            assert_close(number(&session, ".m.arm_1", "mass"), 7.8e-6 * 600.0 * 250.0, 1e-14, "mass");
        }
    }
}

/// The dialog's help: the name of the link stands before that of each object; of `LINK` the first body is
/// `LINK_1` and the first marker `LINK_MARKER_1`.
#[test]
fn objects_are_named_as_the_dialog_names_them() {
    let session = session(&link(2, ["rigid", "flexible"]));
    assert_eq!(session.objects("beam"), [".m.arm_BEAM_1", ".m.arm_BEAM_2"]);
    assert_eq!(session.objects("joint"), [".m.arm_JOINT_1"]);
    assert_eq!(session.objects("part"), [".m.ground", ".m.arm_1", ".m.arm_2"]);
    let markers = session.objects("marker");
    for name in [".m.arm_1.arm_MARKER_1", ".m.arm_2.arm_MARKER_2", ".m.ground.arm_MARKER_3", ".m.ground.arm_MARKER_4"] {
        assert!(markers.contains(&name.to_string()), "{name} is not in {markers:?}");
    }
    assert_eq!(session.objects("shape"), [".m.arm_1.arm_BOX_1", ".m.arm_2.arm_BOX_2"]);
}
