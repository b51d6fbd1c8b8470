//! How long completion takes in a long session: `cargo run --release -p flexure-commands --example
//! complete [LINES]` prints the median and the longest time for several places, in milliseconds.

use std::fmt::Write;
use std::time::Instant;

use flexure_commands::Interpreter;

/// What is half typed.
const PLACES: [&str; 8] = [
    "",
    "force create element_like be",
    "force create element_like beam ",
    "force create element_like beam i_marker_name = ",
    "force create element_like beam i_marker_name = k99",
    "force create element_like beam i_marker_name = .m.p",
    "marker create marker_name = ",
    "variable set variable_name = x real_value = (DX(.m.p1.k10",
];

fn main() {
    let lines: usize = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(12_000);
    let mut text = String::from("model create model_name = m\n");
    for part in 0..lines / 120 {
        let _ = writeln!(text, "part create rigid_body name_and_position part_name = .m.p{part}");
        for marker in 0..119 {
            let number = part * 119 + marker;
            let _ = writeln!(text, "marker create marker_name = .m.p{part}.k{number} location = {marker}, 0, 0");
        }
    }
    let mut interpreter = Interpreter::new(elements::registry());
    let report = interpreter.run_text("session", &text);
    println!("{} commands, {} objects", report.executed, interpreter.database.ids().count());
    for place in PLACES {
        let mut times: Vec<f64> = Vec::new();
        let mut found = 0;
        for _ in 0..21 {
            let begin = Instant::now();
            found = interpreter.complete(place).candidates.len();
            times.push(begin.elapsed().as_secs_f64() * 1e3);
        }
        times.sort_by(f64::total_cmp);
        println!("{:8.3} {:8.3}  {found:6} for `{place}`", times[10], times[20]);
    }
}
