//! Measures how fast a command file is parsed, expressions included:
//! `cargo run --release -p flexure-syntax --example parse_speed FILE`.

use std::time::Instant;

use flexure_syntax::command::Parser;
use text::FileId;

fn main() {
    let Some(path) = std::env::args().nth(1) else {
        eprintln!("usage: parse_speed FILE");
        std::process::exit(2);
    };
    let bytes = match std::fs::read(&path) {
        Ok(bytes) => bytes,
        Err(error) => {
            eprintln!("{path}: {error}");
            std::process::exit(1);
        }
    };
    let text = String::from_utf8_lossy(&bytes);
    // Small files are read often enough that the clock's own noise does not matter.
    let rounds = (100_000_000 / text.len().max(1)).clamp(1, 2000);
    let (mut statements, mut troubles) = (0, 0);
    let start = Instant::now();
    for _ in 0..rounds {
        let mut parser = Parser::new(FileId(0), &text);
        while let Some((statement, diagnostics)) = parser.next_statement() {
            statements += 1;
            troubles += diagnostics.len();
            std::hint::black_box(statement);
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    let megabytes = (text.len() * rounds) as f64 / 1e6;
    println!(
        "{:.0} MB/s: {} statements, {} diagnostics, {} bytes, {rounds} rounds in {seconds:.3} s",
        megabytes / seconds,
        statements / rounds,
        troubles / rounds,
        text.len()
    );
}
