//! `flexure check`: reads and binds; simulates nothing and writes nothing but, with `--fix`, the
//! files it was given.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use flexure::text::Format;
use flexure::{Report, Session, apply_fixes};

use crate::Outcome;
use crate::arguments::{Check, ReportFormat};
use crate::commands::{Tally, complain, print, read, session, unified};
use crate::output::extension;

/// A mended command may show the next trouble; so often at most.
const MOST_ROUNDS: usize = 20;

pub(super) fn execute(check: &Check) -> Outcome {
    let mut session = session();
    session.touch_nothing(true);
    let mut diagnostics = Vec::new();
    let mut written = true;
    if check.fix {
        let (mut inputs, others) = inputs(&check.files);
        written = mend(check, &mut inputs);
        for input in inputs {
            diagnostics.extend(input.execute(&mut session).diagnostics);
        }
        for path in others {
            diagnostics.extend(read(&mut session, path).diagnostics);
        }
    } else {
        for path in &check.files {
            diagnostics.extend(read(&mut session, path).diagnostics);
        }
    }
    // What was said of a name when the function was read is said again, with more to it.
    let functions = session.check_functions();
    let places: Vec<_> = functions.iter().filter_map(|d| d.primary.as_ref().map(|label| label.span)).collect();
    let again = |d: &flexure::text::Diagnostic| {
        d.code == "name/not-found" && !d.is_error() && d.primary.as_ref().is_some_and(|l| places.contains(&l.span))
    };
    diagnostics.retain(|d| !again(d));
    diagnostics.extend(functions);
    let found = Tally::of(&diagnostics);
    match check.format {
        ReportFormat::Text => {
            print(&session, &diagnostics);
            eprintln!("{found}");
        }
        machine => {
            let report = flexure::text::render(session.sources(), &diagnostics, form(machine));
            // Standard output holds the mended text of standard input, or the difference.
            if check.diff || check.fix && check.files.iter().any(|path| path == Path::new("-")) {
                eprint!("{report}");
            } else {
                print!("{report}");
            }
        }
    }
    if found.errors > 0 || !written { Outcome::Findings } else { Outcome::Fine }
}

/// A file to be checked.
struct Input {
    path: PathBuf,
    bytes: Vec<u8>,
    /// As it was read.
    original: Vec<u8>,
}

/// The files that can be mended, and those that cannot be read or hold no text.
fn inputs(paths: &[PathBuf]) -> (Vec<Input>, Vec<&Path>) {
    let (mut inputs, mut others) = (Vec::new(), Vec::new());
    for path in paths {
        let mut bytes = Vec::new();
        let read = match (path == Path::new("-"), extension(path).as_str()) {
            (true, _) => std::io::stdin().read_to_end(&mut bytes).is_ok(),
            (false, "cmd" | "mac" | "adm") => std::fs::read(path).map(|read| bytes = read).is_ok(),
            _ => false,
        };
        if read {
            inputs.push(Input { path: path.clone(), original: bytes.clone(), bytes });
        } else {
            others.push(path.as_path());
        }
    }
    (inputs, others)
}

impl Input {
    fn is_stdin(&self) -> bool {
        self.path == Path::new("-")
    }

    fn name(&self) -> String {
        if self.is_stdin() { "<standard input>".into() } else { self.path.display().to_string() }
    }

    fn execute(&self, session: &mut Session) -> Report {
        if self.is_stdin() {
            session.read_bytes(&self.name(), self.bytes.clone())
        } else {
            session.read_bytes_as(&self.path, self.bytes.clone())
        }
    }
}

/// Applies fixes until none is left; false if a file could not be written.
fn mend(check: &Check, inputs: &mut [Input]) -> bool {
    let mut left = Vec::new();
    for _ in 0..MOST_ROUNDS {
        let mut session = session();
        session.touch_nothing(true);
        let mut diagnostics = Vec::new();
        for input in inputs.iter() {
            diagnostics.extend(input.execute(&mut session).diagnostics);
        }
        let mut applied = 0;
        left.clear();
        for input in inputs.iter_mut() {
            let Some(file) = session.sources().find(&input.name()) else { continue };
            let fixed = apply_fixes(session.sources(), file, &diagnostics);
            left.extend(fixed.left);
            if fixed.applied.is_empty() {
                continue;
            }
            let Some(bytes) = encoded(&input.bytes, &fixed.text) else {
                left.push(format!("{}: a fix cannot be written in the encoding of the file", input.name()));
                continue;
            };
            input.bytes = bytes;
            applied += fixed.applied.len();
            fixed.applied.iter().for_each(|line| eprintln!("fixed: {line}"));
        }
        if applied == 0 {
            break;
        }
    }
    left.iter().for_each(|line| eprintln!("not fixed, for another fix wants the same place: {line}"));
    let mut written = true;
    for input in inputs.iter() {
        let changed = input.bytes != input.original;
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let outcome = if check.diff {
            print!("{}", unified(&input.name(), &text(&input.original), &text(&input.bytes)));
            Ok(())
        } else if input.is_stdin() {
            std::io::stdout().write_all(&input.bytes)
        } else if changed {
            flexure::files::write(&input.path, &input.bytes)
        } else {
            Ok(())
        };
        if let Err(error) = outcome {
            let name = if input.is_stdin() { "standard output".into() } else { input.name() };
            complain(format_args!("cannot write {name}: {error}"));
            written = false;
        }
    }
    written
}

/// A text in the encoding of the bytes it was made from; none if it does not fit.
fn encoded(original: &[u8], text: &str) -> Option<Vec<u8>> {
    if std::str::from_utf8(original).is_ok() {
        return Some(text.as_bytes().to_vec());
    }
    flexure::text::to_windows_1252(text)
}

fn form(format: ReportFormat) -> Format {
    match format {
        ReportFormat::Text => Format::OneLine,
        ReportFormat::Json => Format::Json,
        ReportFormat::Github => Format::Github,
        ReportFormat::Sarif => Format::Sarif,
        ReportFormat::Junit => Format::Junit,
    }
}
