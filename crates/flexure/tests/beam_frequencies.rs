//! Natural frequencies of a cantilever made of LINEAR beams, through commands: ratios to the exact
//! continuum, `w = beta^2 sqrt(EI / (rho A L^4))` with beta L = 1.87510407, 4.69409113, 7.85475744.

use std::fmt::Write;

use flexure::{ModesAbout, Session};

/// Exact circular frequencies for EI = rho A = L = 1.
const EXACT: [f64; 3] = [3.516_015_268_5, 22.034_491_564_7, 61.697_214_412_5];

const HEAD: &str = "\
defaults units length=meter angle=rad force=newton mass=kg time=second
model create model_name=m
marker create marker_name=.m.ground.root location=0,0,0 relative_to=.m.ground
";

/// EI = 1, EA = 1e6, G J = 1e3 (E = 1e6, A = 1, I = 1e-6).
const SECTION: &str = "area_of_cross_section=1 youngs_modulus=1e6 shear_modulus=1e6 ixx=1e-3 iyy=1e-6 izz=1e-6";

fn part(text: &mut String, index: usize, x: f64, mass: f64, transverse: f64) {
    writeln!(
        text,
        "part create rigid_body name_and_position part_name=.m.p{index} location={x:?},0,0\n\
         marker create marker_name=.m.p{index}.cm location=0,0,0 relative_to=.m.p{index}\n\
         part create rigid_body mass_properties part_name=.m.p{index} mass={mass:?} \
         center_of_mass_marker=.m.p{index}.cm ixx={transverse:?} iyy={transverse:?} izz={transverse:?}"
    )
    .unwrap();
}

fn beam(text: &mut String, index: usize, length: f64) {
    let behind = if index == 1 { ".m.ground.root".to_string() } else { format!(".m.p{}.cm", index - 1) };
    writeln!(
        text,
        "force create element_like beam beam_name=.m.b{index} i_marker_name=.m.p{index}.cm j_marker_name={behind} \
         length={length:?} {SECTION}"
    )
    .unwrap();
}

/// Nodes with mass 1/N, half of it at the tip, without rotary inertia.
fn lumped(n: usize) -> String {
    let (mut text, h) = (HEAD.to_string(), 1.0 / n as f64);
    for i in 1..=n {
        part(&mut text, i, i as f64 * h, if i == n { h / 2.0 } else { h }, 0.0);
        beam(&mut text, i, h);
    }
    text
}

/// Rigid segments as View's flexible link makes them: mass at mid-segment, beams between the middles,
/// a root beam of half the length.
fn segments(n: usize) -> String {
    let (mut text, h) = (HEAD.to_string(), 1.0 / n as f64);
    for i in 1..=n {
        part(&mut text, i, (i as f64 - 0.5) * h, h, h * h * h / 12.0);
        beam(&mut text, i, if i == 1 { h / 2.0 } else { h });
    }
    text
}

/// Ratios of the first three bending frequencies to the exact ones. Both bending planes are equal,
/// so frequencies come in pairs.
fn ratios(model: &str) -> [f64; 3] {
    let mut session = Session::new();
    let report = session.execute(model);
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    let found = session.modes(&ModesAbout::Present).unwrap_or_else(|d| panic!("{}", session.render(&d, false)));
    let list: Vec<f64> = found.modes.iter().map(|m| m.frequency_hz * std::f64::consts::TAU).collect();
    for pair in list[..6].chunks(2) {
        assert!((pair[0] / pair[1] - 1.0).abs() < 1e-6, "{list:?}");
    }
    [0, 1, 2].map(|k| list[2 * k] / EXACT[k])
}

/// Half a unit of the last printed digit, and the solver's rounding.
const PRINTED: f64 = 0.6e-6;

fn agrees(model: &str, n: usize, printed: [f64; 3]) {
    let found = ratios(model);
    for (ratio, expected) in found.iter().zip(printed) {
        assert!((ratio - expected).abs() < PRINTED, "N = {n}: {found:?}, not {printed:?}");
    }
}

/// Twin: printed ratios of the same discretisation, computed outside the program as the eigenvalues
/// of the assembled element matrices.
#[test]
fn lumped_nodes_have_the_frequencies_of_their_matrices() {
    agrees(&lumped(4), 4, [0.972134, 0.911768, 0.862304]);
    agrees(&lumped(8), 8, [0.992882, 0.975815, 0.960804]);
    agrees(&lumped(16), 16, [0.998211, 0.993819, 0.989875]);
    agrees(&lumped(32), 32, [0.999552, 0.998446, 0.997451]);
}

/// Twin: as above, for rigid segments.
#[test]
fn rigid_segments_have_the_frequencies_of_their_matrices() {
    agrees(&segments(4), 4, [1.002172, 0.965648, 0.889964]);
    agrees(&segments(8), 8, [1.000555, 0.991359, 0.970766]);
    agrees(&segments(16), 16, [1.000140, 0.997837, 0.992570]);
    agrees(&segments(32), 32, [1.000035, 0.999459, 0.998135]);
}

/// Truth: damping proportional to stiffness gives `zeta = CRATIO w / 2` in every mode.
#[test]
fn a_damping_ratio_damps_each_mode_in_proportion_to_its_frequency() {
    let ratio = 2.0e-3;
    let model = segments(4).replace("izz=1e-6", &format!("izz=1e-6 damping_ratio={ratio:?}"));
    let mut session = Session::new();
    assert_eq!(session.execute(&model).failed, 0);
    for mode in session.modes(&ModesAbout::Present).unwrap().modes.iter().take(6) {
        let expected = ratio * mode.frequency_hz * std::f64::consts::TAU / 2.0;
        // The eigenvalues are good to about 1e-9 of the largest (axial) frequency.
        assert!((mode.damping_ratio / expected - 1.0).abs() < 1e-6, "{} {expected}", mode.damping_ratio);
    }
}

/// Truth: C = ratio K damps a mode of w critically at ratio = 2 / w; the lowest has w = 3.516 (1.0006 times
/// that for eight segments), so 0.5685 s is critical for it and all others are beyond.
#[test]
fn a_damping_ratio_that_stops_every_swing_is_found() {
    for (ratio, wanted) in [(0.56, false), (0.575, true)] {
        let mut session = Session::new();
        assert_eq!(session.execute(&segments(8)).failed, 0);
        for index in 1..=8 {
            let text = format!("force modify element_like beam beam_name=.m.b{index} damping_ratio={ratio}");
            assert_eq!(session.execute(&text).failed, 0);
        }
        let found = session.verify().findings;
        let found = found.iter().find(|f| f.diagnostic.code == "beam/overdamped");
        assert_eq!(found.is_some(), wanted, "{ratio}: {found:?}");
    }
}
