//! Whatever is read, nothing panics, hangs or takes a gibibyte: random bytes, truncated files, files
//! with something changed at random. `PROPTEST_CASES` sets how many of each.
//!
//! The tests run in a child process whose address space is limited, so that a case that wants too
//! much memory fails there and not on the machine of whoever runs them.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use flexure::{Layout, Session};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

/// Set in the child.
const CHILD: &str = "FLEXURE_LIMITED";
/// Kibibytes of address space: a gibibyte, and what a test binary of its size and the stacks of its
/// threads take without using it.
const MEMORY: &str = "1310720";
/// The slowest sound case takes a second where other tests run beside it. Twenty times as long is no busy
/// machine, but work without end, or work that grows with the square of what is read.
const LONGEST: Duration = Duration::from_secs(20);

/// Runs a test of this file in a child with little memory. True in the child itself.
fn limited(test: &str) -> bool {
    if std::env::var_os(CHILD).is_some() {
        return true;
    }
    let program = std::env::current_exe().unwrap();
    let limit = format!("ulimit -v {MEMORY} && exec \"$0\" --exact {test} --test-threads 1");
    let mut child = if cfg!(unix) {
        let mut shell = Command::new("sh");
        shell.args(["-c", &limit]).arg(program);
        shell
    } else {
        println!("memory is not limited on this system");
        let mut plain = Command::new(program);
        plain.args(["--exact", test]);
        plain
    };
    let output = child.env(CHILD, "1").env("RUST_BACKTRACE", "0").output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert!(output.status.success(), "{}\n{}", text(&output.stdout), text(&output.stderr));
    assert!(text(&output.stdout).contains("1 passed"), "the child ran no test: {}", text(&output.stdout));
    false
}

fn cases(usual: u32) -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(usual)
}

fn run<S: Strategy>(usual: u32, seed: u64, strategy: &S, test: impl Fn(S::Value)) {
    let config = Config {
        cases: cases(usual),
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: None,
        max_shrink_iters: 200,
        ..Config::default()
    };
    let outcome = TestRunner::new(config).run(strategy, |value| {
        test(value);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

/// Stops a session that goes on for too long; a loop of a mutated program may be endless by right.
fn watched<T>(session: &mut Session, work: impl FnOnce(&mut Session) -> T) -> (T, bool) {
    let stop = Arc::new(AtomicBool::new(false));
    let done = Arc::new(AtomicBool::new(false));
    session.set_interrupt(stop.clone());
    let watcher = {
        let (stop, done) = (stop.clone(), done.clone());
        std::thread::spawn(move || {
            let start = Instant::now();
            while !done.load(Ordering::Relaxed) {
                if start.elapsed() > Duration::from_millis(300) {
                    stop.store(true, Ordering::Relaxed);
                    return;
                }
                std::thread::sleep(Duration::from_millis(2));
            }
        })
    };
    let outcome = work(session);
    done.store(true, Ordering::Relaxed);
    let _ = watcher.join();
    (outcome, stop.load(Ordering::Relaxed))
}

/// Reads, checks, lays out, and checks what was laid out.
fn all_ways(bytes: &[u8]) {
    let start = Instant::now();
    let layout = Layout::of("any.cmd", bytes.to_vec());
    let again = Layout::of("any.cmd", layout.bytes());
    assert!(!again.changed(), "layout is not a fixed point");
    let check = |bytes: Vec<u8>| {
        let mut session = Session::new();
        session.touch_nothing(true);
        let (report, stopped) = watched(&mut session, |s| s.read_bytes("any.cmd", bytes));
        for format in [flexure::text::Format::Json, flexure::text::Format::Terminal { colours: false }] {
            let some = report.diagnostics.get(..20).unwrap_or(&report.diagnostics);
            let _ = flexure::text::render(session.sources(), some, format);
        }
        (report, session, stopped)
    };
    let (before, mut session, stopped) = check(bytes.to_vec());
    let (after, other, stopped_too) = check(layout.bytes());
    if !stopped && !stopped_too {
        // Layout changes nothing of what is executed.
        let codes = |report: &flexure::Report| -> Vec<&'static str> {
            let all = report.diagnostics.iter().map(|d| d.code);
            // What stands where is layout: a note about a missing mark goes, when the mark comes.
            all.filter(|code| *code != "syntax/continued-without-mark").collect()
        };
        assert_eq!((before.executed, before.failed), (after.executed, after.failed));
        assert_eq!(codes(&before), codes(&after));
        if let Ok(differences) = session.compare(&other, 0.0) {
            assert!(differences.is_empty(), "{:?}", differences.changes);
        }
        while session.undo() {}
    }
    assert!(start.elapsed() < LONGEST, "{:?}", start.elapsed());
}

fn command_files(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|e| e.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            command_files(&path, found);
        } else if path.extension().is_some_and(|e| e == "cmd" || e == "mac") {
            found.push(path);
        }
    }
}

/// Our examples, and real exports where they are at hand; pieces of them that are quickly read.
fn real_texts() -> Vec<Vec<u8>> {
    let mut found = Vec::new();
    command_files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples"), &mut found);
    match std::env::var_os("FLEXURE_SHARED") {
        Some(shared) => command_files(&Path::new(&shared).join("corpus"), &mut found),
        None => println!("without the corpus: FLEXURE_SHARED is not set"),
    }
    let texts = found.iter().map(|path| std::fs::read(path).unwrap());
    // A piece from the middle of a large file holds what its beginning does not.
    let texts = texts.flat_map(|text| {
        const PIECE: usize = 30_000;
        let middle = text.get(text.len() / 2..text.len().min(text.len() / 2 + PIECE)).map(<[u8]>::to_vec);
        let beginning = text[..text.len().min(PIECE)].to_vec();
        if text.len() > 2 * PIECE { vec![beginning, middle.unwrap_or_default()] } else { vec![beginning] }
    });
    texts.collect()
}

/// Programs with loops, conditions and macros, for what exports do not hold.
const PROGRAM: &str = "\
model create model_name = m
variable set variable_name = n integer_value = 3
for variable_name = i start_value = 1 end_value = (eval(n))
  if condition = (i == 2)
    marker create marker_name = (eval(\".m.ground.k\" // RTOI(i))) location = (i * 10), 0, 0
  elseif condition = (i > 2)
    part create rigid_body name_and_position part_name = (eval(\".m.p\" // i))
  else
    continue
  end
end
while condition = (n < 10)
  variable modify variable_name = n integer_value = (eval(n + 1))
end
macro create macro_name = .m.mac user_entered_command = \"my own\" &
  commands_to_be_executed = \"variable set variable_name = x real_value = $'v:t=real:d=2'\", \"undo begin_block\"
my own v = 3
force create element_like beam beam_name = .m.b i_marker_name = .m.ground.k2 j_marker_name = .m.p3.cm length = (x * 2)
group create group_name = .m.g objects = .m.ground.*
entity modify entity_name = .m.p3 new_entity_name = q
undo
list_info part part_name = .m.q
";

/// What is done to a text: cut, copied, exchanged, with pieces that mean something put in.
#[derive(Clone, Debug)]
enum Mutation {
    Cut(prop::sample::Index, u8),
    Insert(prop::sample::Index, &'static str),
    Copy(prop::sample::Index, prop::sample::Index, u8),
    Byte(prop::sample::Index, u8),
    End(prop::sample::Index),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    use prop::sample::Index;
    let words = prop::sample::select(vec![
        " & ",
        "&\n",
        "\n",
        "\n\n",
        "!",
        "\"",
        "'",
        "(",
        ")",
        "{",
        "}",
        "[",
        ",",
        "=",
        ".",
        "$",
        "eval(",
        "1e999",
        "-",
        "0",
        "999999999999",
        "if condition = (1)\n",
        "end\n",
        "while condition = (1)\n",
        "for variable_name = z object_names = *\n",
        "undo\n",
        "entity delete entity_name = .m\n",
        "model delete model_name = *\n",
        "break\n",
        "return\n",
        ".m.ground",
        "(none)",
        "\u{0}",
        "é",
        "copy",
        "modify",
        "delete",
        "**99999",
        "//",
        "1/0",
        "nan",
        "defaults units length = meter\n",
        "variable set variable_name = n real_value = (n + 1)\n",
        "my own v = 1\n",
        "marker modify marker_name = *\n",
        "part copy part_name = .m.p new_part_name = .m.q\n",
        "group create group_name = .m.gg objects = *\n",
    ]);
    prop_oneof![
        1 => (any::<Index>(), any::<u8>()).prop_map(|(a, n)| Mutation::Cut(a, n)),
        3 => (any::<Index>(), words).prop_map(|(a, w)| Mutation::Insert(a, w)),
        1 => (any::<Index>(), any::<Index>(), any::<u8>()).prop_map(|(a, b, n)| Mutation::Copy(a, b, n)),
        1 => (any::<Index>(), any::<u8>()).prop_map(|(a, b)| Mutation::Byte(a, b)),
        1 => any::<Index>().prop_map(Mutation::End),
    ]
}

fn mutate(text: &mut Vec<u8>, mutation: &Mutation) {
    let place = |at: &prop::sample::Index, text: &[u8]| at.index(text.len() + 1);
    match mutation {
        Mutation::Cut(at, n) => {
            let from = place(at, text);
            text.drain(from..text.len().min(from + usize::from(*n)));
        }
        Mutation::Insert(at, word) => {
            let at = place(at, text);
            text.splice(at..at, word.bytes());
        }
        Mutation::Copy(from, to, n) => {
            let from = place(from, text);
            let piece = text[from..text.len().min(from + usize::from(*n))].to_vec();
            let to = place(to, text);
            text.splice(to..to, piece);
        }
        Mutation::Byte(at, byte) => {
            let at = place(at, text);
            if let Some(b) = text.get_mut(at) {
                *b = *byte;
            }
        }
        Mutation::End(at) => text.truncate(place(at, text)),
    }
}

#[test]
fn random_bytes_are_harmless() {
    if limited("random_bytes_are_harmless") {
        run(60, 21, &prop::collection::vec(any::<u8>(), 0..600), |bytes| all_ways(&bytes));
    }
}

#[test]
fn mutated_real_files_are_harmless() {
    if limited("mutated_real_files_are_harmless") {
        let texts = real_texts();
        let strategy = (any::<prop::sample::Index>(), prop::collection::vec(mutation(), 1..8));
        run(40, 22, &strategy, |(which, mutations)| {
            let mut text = which.get(&texts).clone();
            mutations.iter().for_each(|m| mutate(&mut text, m));
            all_ways(&text);
        });
    }
}

#[test]
fn mutated_programs_are_harmless() {
    if limited("mutated_programs_are_harmless") {
        run(150, 23, &prop::collection::vec(mutation(), 1..6), |mutations| {
            let mut text = PROGRAM.as_bytes().to_vec();
            mutations.iter().for_each(|m| mutate(&mut text, m));
            all_ways(&text);
        });
    }
}

/// Half-written files: every line end and places between.
#[test]
fn truncated_files_are_harmless() {
    if limited("truncated_files_are_harmless") {
        for end in (0..PROGRAM.len()).step_by(7) {
            all_ways(&PROGRAM.as_bytes()[..end]);
        }
    }
}

/// Small texts that ask for much: each is refused or done with little.
#[test]
fn greedy_texts_are_harmless() {
    if limited("greedy_texts_are_harmless") {
        let nested =
            |n: usize| format!("variable set variable_name = x real_value = ({}1{})\n", "(".repeat(n), ")".repeat(n));
        let lists = "1,".repeat(200_000);
        let texts = [
            nested(100_000),
            "if condition = (1)\n".repeat(3_000),
            "end\n".repeat(20_000),
            "a".repeat(500_000),
            format!("data_element create matrix full matrix_name = .m.t values = {lists}1\n"),
            "macro create macro_name = .mac user_entered_command = \"go on\" commands_to_be_executed = \"go on\", \"go on\"\ngo on\n".into(),
            "variable set variable_name = s string_value = \"xxxxxxxxxxxxxxxx\"\nfor variable_name = i start_value = 1 end_value = 40\n  \
             variable set variable_name = s string_value = (eval(s // s))\nend\n".into(),
            "variable set variable_name = a real_value = (SERIES(1, 1, 1000000000))\n".into(),
            "variable set variable_name = a real_value = (eval(RAND(1000000, 1000000)))\n".into(),
            "for variable_name = i start_value = 1 end_value = 1e18\nend\n".into(),
            "while condition = (1)\nend\n".into(),
            "(".repeat(300_000),
            "{".repeat(300_000),
            format!("variable set variable_name = x real_value = (1{})\n", " + 1".repeat(100_000)),
            format!("variable set variable_name = x real_value = ({}1)\n", "-".repeat(100_000)),
        ];
        for text in texts {
            all_ways(text.as_bytes());
        }
    }
}

#[test]
fn what_asks_for_too_much_is_named() {
    let codes = |text: &str| -> Vec<&'static str> {
        let mut session = Session::new();
        session.execute(text).diagnostics.iter().filter(|d| d.is_error()).map(|d| d.code).collect()
    };
    let doubling = "variable set variable_name = s string_value = \"xxxxxxxxxxxxxxxx\"\n\
                    for variable_name = i start_value = 1 end_value = 24\n  \
                    variable set variable_name = s string_value = (eval(s // s))\nend\n";
    assert!(codes(doubling).contains(&"expression/text-too-long"));
    let deep = "if condition = (1)\n".repeat(300) + &"end\n".repeat(300);
    assert_eq!(codes(&deep), ["command/too-deep"]);
}
