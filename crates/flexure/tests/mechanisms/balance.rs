//! Action and reaction of every beam of a run: forces, and moments with the lever arm.

use std::fmt::Write;

use flexure::{AttributeValue, Run, Session};

/// Part of the largest load that may be left over.
const ROUNDING: f64 = 1e-12;

/// Adds requests for the loads at both ends of every beam, and for where I is from J.
pub fn watch(session: &mut Session) {
    let model = session.model_name().expect("a model");
    let mut commands = String::new();
    for (index, beam) in session.objects("beam").iter().enumerate() {
        let marker = |cell: &str| match session.attribute(beam, cell).map(|a| a.value) {
            Some(AttributeValue::Text(name)) => name,
            other => panic!("{beam} {cell}: {other:?}"),
        };
        let (i, j) = (marker("i_marker_name"), marker("j_marker_name"));
        let load = |flag: usize, c: usize| format!("BEAM({beam}, {flag}, {c}, 0)");
        let at = |d: &str| format!("{d}({i}, {j}, 0)");
        let halves = [
            (0..8)
                .map(|k| {
                    if k < 3 {
                        load(0, k + 2)
                    } else if k < 6 {
                        load(0, k + 3)
                    } else {
                        load(1, k - 4)
                    }
                })
                .collect(),
            vec![load(1, 4), load(1, 6), load(1, 7), load(1, 8), at("DX"), at("DY"), at("DZ")],
        ];
        for (half, functions) in halves.iter().enumerate() {
            write!(commands, "output_control create request request_name=.{model}.balance_{index}_{half}").unwrap();
            for (f, function) in functions.iter().enumerate() {
                write!(commands, " f{}=\"{function}\"", f + 1).unwrap();
            }
            commands.push('\n');
        }
    }
    let report = session.execute(&commands);
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
}

/// The worst imbalance of a run as part of its largest load, if it is more than rounding.
pub fn trouble(run: &Run) -> Option<String> {
    let series = |index: usize, n: usize| {
        let (half, f) = (n / 8, n % 8 + 1);
        run.table.get(&format!("balance_{index}_{half}.F{f}")).map(|s| s.values.as_slice())
    };
    let (mut largest, mut worst): (f64, f64) = (0.0, 0.0);
    for index in 0.. {
        let all: Option<Vec<&[f64]>> = (0..15).map(|n| series(index, n)).collect();
        let Some(all) = all else { break };
        let [first, ..] = all.as_slice() else { break };
        for (row, _) in first.iter().enumerate() {
            let v = |n: usize| [all[n][row], all[n + 1][row], all[n + 2][row]];
            let (force_i, torque_i, force_j, torque_j, arm) = (v(0), v(3), v(6), v(9), v(12));
            for k in 0..3 {
                let (a, b) = ((k + 1) % 3, (k + 2) % 3);
                let moment = arm[a] * force_i[b] - arm[b] * force_i[a];
                worst = worst.max((force_i[k] + force_j[k]).abs());
                worst = worst.max((torque_i[k] + torque_j[k] + moment).abs());
                largest = largest.max(force_i[k].abs()).max(torque_i[k].abs()).max(torque_j[k].abs());
            }
        }
    }
    (worst > ROUNDING * largest).then(|| format!("beams are out of balance by {worst:e} of {largest:e}"))
}
