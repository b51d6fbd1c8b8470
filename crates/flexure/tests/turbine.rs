//! The wind turbine of the public demo model against another program with the same force law.
//! Runs where the environment variable FLEXURE_SHARED names the folder of reference material.

use std::path::PathBuf;

use flexure::Session;

fn shared() -> Option<PathBuf> {
    let folder = std::env::var_os("FLEXURE_SHARED").map(PathBuf::from);
    if folder.is_none() {
        eprintln!("skipped: FLEXURE_SHARED is not set");
    }
    folder
}

fn turbine(shared: &std::path::Path) -> Session {
    let mut session = Session::new();
    let report = session.read(&shared.join("corpus/bthornton191__adams_vscode/agent_demo/wind_turbine.cmd"));
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    session
}

#[test]
fn all_21_beams_are_named_and_mended_by_swapping_their_markers() {
    let Some(shared) = shared() else { return };
    let mut session = turbine(&shared);
    let found = session.verify();
    let swapped: Vec<_> = found.findings.iter().filter(|f| f.diagnostic.code == "beam/ends-swapped").collect();
    assert_eq!(swapped.len(), 21);
    for finding in swapped {
        assert!(finding.diagnostic.message.contains("x = -5000 mm"), "{}", finding.diagnostic.message);
        assert!(finding.fix.as_deref().unwrap().starts_with("force modify element_like beam"));
    }
    let mended = session.fix(&found);
    assert_eq!((mended.executed, mended.failed), (21, 0));
    assert!(session.verify().findings.is_empty());
}

/// Twin: the reference trajectory was computed by another multibody program with the same force
/// law at a step of 1 ms; the two differ by how relative rotations are measured and by the step.
#[test]
fn blade_tips_follow_the_other_program() {
    let Some(shared) = shared() else { return };
    let mut session = turbine(&shared);
    let found = session.verify();
    session.fix(&found);
    for blade in 1..=3 {
        let part = format!(".wind_turbine.blade_{blade}_seg_8");
        session.execute(&format!("marker create marker_name={part}.tip location=0,0,2500 relative_to={part}"));
        let report = session.execute(&format!(
            "output_control create request request_name=.wind_turbine.TIP{blade} output_type=displacement \
             i_marker_name={part}.tip j_marker_name=.wind_turbine.ground.tower_base_mkr"
        ));
        assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    }
    let report = session.execute("simulation single_run scripted sim_script_name=.wind_turbine.run");
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    let run = session.take_runs().pop().unwrap();
    assert_eq!(run.table.rows(), 1001);
    let reference = std::fs::File::open(shared.join("bench/reference/w3_turbine.csv")).unwrap();
    let reference = flexure::results::csv::read(reference).unwrap();
    let distance = |row: usize| {
        (1..=3)
            .map(|blade| {
                let squares = ["x", "y", "z"].map(|axis| {
                    let ours = run.table.get(&format!("TIP{blade}.{axis}")).unwrap().values[row] / 1000.0;
                    (ours - reference.get(&format!("{axis}{blade}")).unwrap().values[row]).powi(2)
                });
                squares.iter().sum::<f64>().sqrt()
            })
            .fold(0.0, f64::max)
    };
    let farthest = |from: usize, to: usize| (from..=to).map(distance).fold(0.0, f64::max);
    let (first, second) = (farthest(0, 100), farthest(0, 200));
    println!("largest distance of a blade tip: {first:.2e} m up to 1 s, {second:.2e} m up to 2 s");
    assert!(first < 0.03 && second < 0.2);
    let warning = run.diagnostics.iter().find(|d| d.code == "run/beyond-validity").expect("a warning about angles");
    assert!(warning.notes.iter().any(|n| n.contains("beam_b1_s1_2") && n.contains("degrees")), "{warning:?}");
}

#[test]
fn the_equilibrium_under_gravity_is_found() {
    let Some(shared) = shared() else { return };
    let mut session = turbine(&shared);
    let found = session.verify();
    session.fix(&found);
    let report = session.execute("simulation single_run equilibrium model_name=.wind_turbine");
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    let run = session.take_runs().pop().unwrap();
    let tips = [2, 3].map(|blade| run.table.get(&format!("blade_{blade}_seg_8_XFORM.Z")).unwrap().values[0]);
    // The drooping blades are mirror images and hang metres below where they are unbent (60.25 m).
    assert!((tips[0] - tips[1]).abs() < 1e-3 * tips[0], "{tips:?}");
    assert!(tips[0] < 58.0e3, "{tips:?}");
}
