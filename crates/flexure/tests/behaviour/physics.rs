//! What a beam does in a run: each number is a closed form of Euler, Bernoulli and Timoshenko.

use flexure::{Analysis, Outputs, SimulationOptions};

use crate::scene::{Scene, close};

const L: f64 = 2.0;
const E: f64 = 2.0e5;
const G: f64 = 8.0e4;
const IZZ: f64 = 3.0;
const AREA: f64 = 5.0;

/// The beam as a cantilever along x with a body at its tip that `load` acts on. Millimetres and
/// newtons.
fn cantilever(load: &str, more: &str) -> Scene {
    let mut s = Scene::beam();
    s.accept(&format!(
        "force modify element_like beam beam_name = .m.beam1 youngs_modulus = {E} shear_modulus = {G} length = {L} \
         area_of_cross_section = {AREA} ixx = 4 iyy = 3 izz = {IZZ} {more}"
    ));
    s.accept(
        "marker create marker_name = .m.p1.cm location = 2,0,0\n\
         part modify rigid_body mass_properties part_name = .m.p1 mass = 1 center_of_mass_marker = .m.p1.cm &\n\
            ixx = 1000 iyy = 1000 izz = 1000\n\
         output_control create request request_name = .m.tip output_type = displacement &\n\
            i_marker_name = .m.p1.marker_1 j_marker_name = .m.ground.marker_2\n\
         output_control create request request_name = .m.bar output_type = force &\n\
            i_marker_name = .m.p1.marker_1 j_marker_name = .m.ground.marker_2",
    );
    s.accept(load);
    s
}

/// A force along global y on the tip.
fn across(newtons: f64) -> String {
    format!(
        "marker create marker_name = .m.ground.up location = 0,0,0 orientation = 0,-90,0\n\
         force create direct single_component_force single_component_force_name = .m.load action_only = on &\n\
            type_of_freedom = translational i_marker_name = .m.p1.marker_1 j_marker_name = .m.ground.up &\n\
            function = \"{newtons}\""
    )
}

/// A force along global x on the tip.
fn lengthwise(newtons: f64) -> String {
    across(newtons).replace("0,-90,0", "90,90,0")
}

fn options(analysis: Analysis) -> SimulationOptions {
    SimulationOptions::new(analysis)
}

/// The value of a column after static equilibrium.
fn at_rest(s: &mut Scene, column: &str) -> f64 {
    let run = match s.session.simulate(&options(Analysis::Static)) {
        Ok(run) => run,
        Err(errors) => panic!("{errors:?}"),
    };
    let names: Vec<&str> = run.table.series.iter().map(|x| x.name.as_str()).collect();
    let series = run.table.get(column).unwrap_or_else(|| panic!("{names:?}"));
    *series.values.last().unwrap()
}

// Case 40, documented; that nothing acts is inferred.
#[test]
fn a_beam_that_is_switched_off_exerts_no_force() {
    let fall = |active: &str| {
        let mut s = cantilever(&across(1.0), "");
        s.accept(&format!("force attributes force_name = .m.beam1 active = {active}"));
        let run = s.session.simulate(&options(Analysis::Dynamic { end: 0.01, outputs: Outputs::Steps(1) })).unwrap();
        let y = run.table.get("tip.Y").unwrap();
        *y.values.last().unwrap()
    };
    // Truth: a free body of 1 kg under 1 N: 1000 mm/s² * t²/2.
    close(fall("off"), 1000.0 * 0.01 * 0.01 / 2.0, 1e-6); // the integrator's error
    assert!(fall("on").abs() < 1e-3);
}

// Case 41, computed: a cantilever bends by F L³ / 3 E I.
#[test]
fn a_tip_force_bends_the_cantilever() {
    let mut s = cantilever(&across(10.0), "");
    let wanted = 10.0 * L.powi(3) / (3.0 * E * IZZ);
    close(at_rest(&mut s, "tip.Y"), wanted, wanted * 1e-6); // the tolerance of the static solver
}

// Case 42, documented: a bar under 10 N is longer by F L / E A; J pulls I back with 10 N.
#[test]
fn a_request_shows_what_j_exerts_on_i() {
    let mut s = cantilever(&lengthwise(10.0), "");
    let d = at_rest(&mut s, "tip.X") - L;
    close(d, 10.0 * L / (E * AREA), 1e-10);
    close(at_rest(&mut s, "bar.X"), -E * AREA * d / L, 1e-4); // the residual of the static solver
}

// Case 43, documented: K22 = 12 E I / (L³ (1 + P)), P = 12 E I a / (G A L²). Truth for the tip: the
// matrix [[K22, -6 E I/(L² (1+P))], [.., (4+P) E I/(L (1+P))]] inverted is F L³ (4 + P) / 12 E I.
#[test]
fn shear_makes_a_beam_softer() {
    let ratio = 1.2;
    let mut s = cantilever(&across(10.0), &format!("y_shear_area_ratio = {ratio}"));
    let p = 12.0 * E * IZZ * ratio / (G * AREA * L * L);
    let wanted = 10.0 * L.powi(3) * (4.0 + p) / (12.0 * E * IZZ);
    close(at_rest(&mut s, "tip.Y"), wanted, wanted * 1e-6);
}

// Case 44, documented: the force of damping is the ratio times stiffness times speed; a time of
// 0.01 s is shown as 10 ms.
#[test]
fn the_damping_ratio_is_a_time() {
    let mut s = cantilever(&lengthwise(0.0), "damping_ratio = 0.01");
    s.accept("part modify rigid_body initial_velocity part_name = .m.p1 vx = 3");
    let run = s.session.simulate(&options(Analysis::Dynamic { end: 1e-4, outputs: Outputs::Steps(1) })).unwrap();
    let force = run.table.get("bar.X").unwrap().values[0];
    let wanted = -0.01 * (E * AREA / L) * 3.0;
    close(force, wanted, wanted.abs() * 1e-9); // at the first instant nothing is integrated yet
    s.accept("defaults units time = millisecond");
    close(s.number(".m.beam1", "damping_ratio"), 10.0, 1e-12);
}
