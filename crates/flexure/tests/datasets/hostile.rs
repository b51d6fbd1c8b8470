//! Whatever a dataset holds, reading it neither panics nor takes long: random bytes, truncated and
//! mutated files, small files that ask for much.

use std::time::{Duration, Instant};

use flexure::Session;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

use super::{Desk, corpus, files, quiet, read, root};

/// The slowest sound case takes a second where other tests run beside it. Twenty times as long is no busy
/// machine, but work without end, or work that grows with the square of what is read.
const LONGEST: Duration = Duration::from_secs(20);

/// Reads, writes what was read in every format, reads that, and takes it all back.
fn all_ways(bytes: &[u8]) {
    let start = Instant::now();
    let desk = Desk::new();
    let path = desk.path("any.adm");
    std::fs::write(&path, bytes).unwrap();
    let mut session = quiet();
    let report = session.read(&path);
    let some = report.diagnostics.get(..20).unwrap_or(&report.diagnostics);
    for format in [text::Format::Json, text::Format::Terminal { colours: false }] {
        let _ = text::render(session.sources(), some, format);
    }
    if session.model().is_some() {
        let _ = session.verify();
        for name in ["again.adm", "again.cmd"] {
            if session.write(&desk.path(name)).is_ok() {
                let _ = Session::new().read(&desk.path(name));
            }
        }
    }
    while session.undo() {}
    assert_eq!(session.model(), None);
    assert!(start.elapsed() < LONGEST, "{:?}", start.elapsed());
}

fn run<S: Strategy>(usual: u32, seed: u64, strategy: &S, test: impl Fn(S::Value)) {
    let cases = std::env::var("PROPTEST_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(usual);
    let config = Config { cases, rng_seed: RngSeed::Fixed(seed), failure_persistence: None, ..Config::default() };
    let outcome = TestRunner::new(config).run(strategy, |value| {
        test(value);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

/// Datasets of our examples, and pieces of public ones where they are at hand.
fn texts() -> Vec<Vec<u8>> {
    let desk = Desk::new();
    let mut texts = vec![super::BY_HAND.as_bytes().to_vec()];
    for path in files(&root().join("examples"), "cmd") {
        let mut session = read(&path);
        texts.push(desk.written(&mut session, "example.adm").into_bytes());
    }
    for path in corpus().map(|corpus| files(&corpus, "adm")).unwrap_or_default() {
        let text = std::fs::read(path).unwrap();
        let piece = 20_000.min(text.len());
        texts.push(text[..piece].to_vec());
        texts.push(text[text.len() - piece..].to_vec());
    }
    texts
}

const WORDS: &[&str] = &[
    "\n",
    ",",
    ", ",
    "\n, ",
    "=",
    "/",
    "/1",
    "!",
    "\n!",
    "\"",
    "'",
    "(",
    ")",
    "\\",
    ";",
    "END",
    "\nEND\n",
    "D",
    "1D3",
    "1E999",
    "-",
    "nan",
    "99999999999999999999",
    "0",
    "é",
    "\u{0}",
    "\t",
    "\r",
    "USER(",
    "FUNCTION = ",
    "PART/1, GROUND\n",
    "MARKER/7, PART = 2\n",
    "adams_view_name='",
    "!  adams_view_name='x.y'\n",
    "! END OF MODEL COMMENTS\n",
    "GROUND",
    "FLOATING",
    "UNITS/LENGTH=METER",
    "BEAM/1",
    "QP = ",
    "REULER = 1,2,3",
    "ZP = 0,0,0",
    "DX(1,2)",
    "VARVAL(1)",
    "\n!BEAM/3",
    "\n!, I = 3",
    "ARRAY/1, X",
    "MATRIX/1, FULL=RORDER, VALUES=1",
    "SPLINE/1, Y=1, Y=2,3",
    "COUPLER/1, JOINTS=1,1, SCALES=1",
];

type Change = (prop::sample::Index, u8, usize);

fn mutate(text: &mut Vec<u8>, (at, kind, word): &Change) {
    let at = at.index(text.len() + 1);
    match kind % 5 {
        0 => drop(text.drain(at..text.len().min(at + usize::from(*kind)))),
        1 => {
            let piece = text[at..text.len().min(at + usize::from(*kind))].to_vec();
            text.extend(piece);
        }
        2 => text.iter_mut().skip(at).take(1).for_each(|b| *b = *kind),
        _ => drop(text.splice(at..at, WORDS[word % WORDS.len()].bytes())),
    }
}

#[test]
fn random_bytes_are_harmless() {
    run(60, 31, &prop::collection::vec(any::<u8>(), 0..600), |bytes| all_ways(&bytes));
}

#[test]
fn words_in_any_order_are_harmless() {
    run(150, 32, &prop::collection::vec(0..WORDS.len(), 0..60), |words| {
        let text: String = words.iter().map(|w| WORDS[*w]).collect();
        all_ways(format!("title\n{text}").as_bytes());
    });
}

#[test]
fn mutated_datasets_are_harmless() {
    let texts = texts();
    let change = (any::<prop::sample::Index>(), any::<u8>(), any::<usize>());
    run(60, 33, &(any::<prop::sample::Index>(), prop::collection::vec(change, 1..12)), |(which, changes)| {
        let mut text = which.get(&texts).clone();
        changes.iter().for_each(|change| mutate(&mut text, change));
        all_ways(&text);
    });
}

#[test]
fn truncated_datasets_are_harmless() {
    let text = super::BY_HAND.as_bytes();
    (0..text.len()).step_by(5).for_each(|end| all_ways(&text[..end]));
}

/// Statements one behind another.
fn many(count: usize, statement: impl Fn(usize) -> String) -> String {
    (1..count).map(statement).collect::<Vec<_>>().concat()
}

/// Small texts that ask for much.
#[test]
fn greedy_datasets_are_harmless() {
    let head = "t\nUNITS/\nPART/1,GROUND\n";
    for body in [
        format!("MARKER/1, PART=1{}\n", ", QP=1,2,3".repeat(30_000)),
        format!("MARKER/1, PART=1{}\n", ", X=1".repeat(30_000)),
        format!("VARIABLE/1, FUNCTION={}1{}\n", "(".repeat(30_000), ")".repeat(30_000)),
        format!("VARIABLE/1, FUNCTION={}\n", "DX(1,".repeat(30_000)),
        format!("VARIABLE/1, FUNCTION=1{}\n", "\n,+1".repeat(30_000)),
        format!("VARIABLE/1, FUNCTION=1{}\n", ", IC".repeat(30_000)),
        format!("ARRAY/1, NUMBERS={}1\n", "1,".repeat(100_000)),
        "!  adams_view_name='x'\nMARKER/1,PART=1\n".repeat(10_000),
        many(10_000, |i| format!("!  adams_view_name='x'\nMARKER/{i},PART=1\n")),
        many(5_000, |i| format!("!  adams_view_name='x_{i}'\n!JOINT/{i},FIXED,I=1,J=2\n")),
        "!\n".repeat(100_000) + &"! c\n".repeat(20_000),
        ",\n".repeat(50_000),
        "a/1;".repeat(20_000),
        "\"".repeat(100_000),
    ] {
        all_ways(format!("{head}{body}END\n").as_bytes());
    }
}
