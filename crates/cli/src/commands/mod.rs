//! One file for each subcommand.

mod beams;
mod check;
mod convert;
mod diff;
mod fmt;
mod modes;
mod plot;
mod run;
mod section;
mod simulate;
mod support;
mod verify;

use std::io::{IsTerminal, Read};
use std::mem::ManuallyDrop;
use std::path::Path;

use flexure::results::Format;
use flexure::{BeamAngles, Report, Session};
use text::{Diagnostic, Severity};

use crate::arguments::{Angles, Arguments, Beams, Command, Edits, Recording};
use crate::output::extension;
use crate::{Outcome, interrupt};

pub(crate) fn execute(arguments: &Arguments) -> Outcome {
    match &arguments.command {
        Command::Run(run) => run::execute(run),
        Command::Simulate(simulate) => simulate::execute(simulate),
        Command::Modes(modes) => modes::execute(modes),
        Command::Beams(beams) => beams::execute(beams),
        Command::Check(check) => check::execute(check),
        Command::Verify(verify) => verify::execute(verify),
        Command::Convert(convert) => convert::execute(convert),
        Command::Plot(plot) => plot::execute(plot),
        Command::Section(section) => section::execute(section),
        Command::Diff(diff) => diff::execute(diff),
        Command::Shell(shell) => crate::shell::execute(shell),
        Command::Fmt(fmt) => fmt::execute(fmt),
        Command::Support(request) => support::execute(request),
    }
}

/// A session that stops when the user presses Ctrl-C. It is never taken apart: the process ends with
/// it, and freeing a large model piece by piece takes a tenth of the time that reading it took.
pub(crate) fn session() -> ManuallyDrop<Session> {
    let mut session = Session::new();
    session.set_interrupt(interrupt::flag());
    ManuallyDrop::new(session)
}

/// How the session takes beams from now on.
pub(crate) fn set_beams(session: &mut Session, beams: &Beams) {
    session.measure_beam_angles(match beams.beam_angles {
        Angles::Projected => BeamAngles::Projected,
        Angles::Rotvec => BeamAngles::RotationVector,
    });
    session.shear_nonlinear_beams(beams.nonlinear_shear);
}

/// What the session's runs record from now on.
pub(crate) fn set_recording(session: &mut Session, record: Recording) {
    session.record_everything(record.all);
    session.record_beams(record.beam_loads);
}

/// Diagnostics printed of one report; a file that is no command file has thousands.
const MOST_PRINTED: usize = 200;

/// Prints what was said when a model was read to standard error.
pub(crate) fn print(session: &Session, diagnostics: &[Diagnostic]) {
    print_some(session, diagnostics, "; `flexure check --format json` lists them all");
}

/// Prints what was found in a model to standard error.
fn print_found(session: &Session, diagnostics: &[Diagnostic]) {
    // Nothing lists what only a run says.
    let listed = diagnostics.iter().skip(MOST_PRINTED).all(|d| !d.code.starts_with("run/"));
    print_some(session, diagnostics, if listed { "; `flexure verify --json` lists them all" } else { "" });
}

/// Prints so many as one reads, and says where the others are.
fn print_some(session: &Session, diagnostics: &[Diagnostic], others: &str) {
    if diagnostics.is_empty() {
        return;
    }
    let colour = text::use_colours(std::io::stderr().is_terminal());
    let (shown, left) = diagnostics.split_at(diagnostics.len().min(MOST_PRINTED));
    eprint!("{}", session.render(shown, colour));
    if !left.is_empty() {
        eprintln!("... and {} more{others}", left.len());
    }
}

/// Six digits, without zeros behind them.
fn shown(x: f64) -> String {
    if x != 0.0 && !(1e-3..1e7).contains(&x.abs()) {
        return format!("{x:.6e}");
    }
    let decimals = (6 - x.abs().max(1e-3).log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{x:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}

/// The format of a picture by the name of its file; complains about others.
fn picture_format(path: &Path) -> Option<Format> {
    match extension(path).as_str() {
        "svg" => Some(Format::Svg),
        "png" => Some(Format::Png),
        other => {
            complain(format_args!("a picture ends in .svg or .png, not in `.{other}`"));
            None
        }
    }
}

/// Width and height from `1000x600`; complains about others.
fn picture_size(text: &str) -> Option<(u32, u32)> {
    let sides = text.split_once('x').and_then(|(w, h)| Some((w.trim().parse().ok()?, h.trim().parse().ok()?)));
    let fits = 100..=10_000;
    let size = sides.filter(|(width, height)| fits.contains(width) && fits.contains(height));
    if size.is_none() {
        complain(format_args!("`{text}` is no size; write it as 1000x600, at most 10000x10000"));
    }
    size
}

/// Writes what was drawn into a file; `named` says so on standard output.
fn save_picture(path: &Path, drawn: Result<Vec<u8>, impl std::fmt::Display>, named: bool) -> Outcome {
    let written = drawn.map_err(|sentence| sentence.to_string()).and_then(|bytes| {
        flexure::files::write(path, bytes).map_err(|e| format!("cannot write {}: {e}", path.display()))
    });
    match written {
        Ok(()) => {
            if named {
                println!("{}", path.display());
            }
            Outcome::Fine
        }
        Err(sentence) => {
            complain(sentence);
            Outcome::Findings
        }
    }
}

/// A sentence on standard error, as every refusal of a subcommand.
pub(crate) fn complain(sentence: impl std::fmt::Display) {
    eprintln!("flexure: {sentence}");
}

/// Reads one input: a file, or standard input for `-`.
fn read(session: &mut Session, path: &Path) -> Report {
    if path == Path::new("-") {
        let mut bytes = Vec::new();
        return match std::io::stdin().read_to_end(&mut bytes) {
            Ok(_) => session.read_bytes("<standard input>", bytes),
            Err(error) => session.unreadable(path, &error),
        };
    }
    session.read(path)
}

/// Reads a model and executes the `-e` commands; prints what is to be said. False after an error.
pub(crate) fn open(session: &mut Session, path: &Path, edits: &Edits) -> bool {
    let report = read(session, path);
    print(session, &report.diagnostics);
    let mut sound = !report.has_errors();
    for command in &edits.commands {
        let report = session.execute(command);
        print(session, &report.diagnostics);
        sound &= !report.has_errors();
    }
    if session.model().is_none() && sound {
        complain(format_args!("{} creates no model", path.display()));
        return false;
    }
    sound
}

/// Says which models of a file are left aside, for one is the current one.
fn mention_other_models(session: &Session, done: &str) {
    let others = session.other_models();
    if let (Some(name), false) = (session.model_name(), others.is_empty()) {
        eprintln!("warning: only `.{name}`, the current model, is {done}, not {}", others.join(", "));
    }
}

/// Two texts as a unified diff.
fn unified(name: &str, before: &str, after: &str) -> String {
    let diff = similar::TextDiff::configure().timeout(std::time::Duration::from_secs(2)).diff_lines(before, after);
    diff.unified_diff().context_radius(3).header(name, name).to_string()
}

/// Findings by their severity.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    errors: usize,
    warnings: usize,
    notes: usize,
}

impl Tally {
    fn of<'a>(diagnostics: impl IntoIterator<Item = &'a Diagnostic>) -> Tally {
        let mut tally = Tally::default();
        for diagnostic in diagnostics {
            match diagnostic.severity {
                Severity::Error => tally.errors += 1,
                Severity::Warning => tally.warnings += 1,
                Severity::Note => tally.notes += 1,
            }
        }
        tally
    }

    fn add(&mut self, other: Tally) {
        self.errors += other.errors;
        self.warnings += other.warnings;
        self.notes += other.notes;
    }
}

impl std::fmt::Display for Tally {
    /// `0 errors, 2 warnings, 1 note`; notes ask for nothing and are named only if there are any.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}, {}", count(self.errors, "error"), count(self.warnings, "warning"))?;
        if self.notes > 0 {
            write!(f, ", {}", count(self.notes, "note"))?;
        }
        Ok(())
    }
}

/// `1 error`, `3 warnings`.
fn count(number: usize, word: &str) -> String {
    if number == 1 { format!("{number} {word}") } else { format!("{number} {word}s") }
}
