//! One file for each subcommand.

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

use flexure::{BeamAngles, Report, Session};
use text::Diagnostic;

use crate::arguments::{Angles, Arguments, Beams, Command, Edits};
use crate::{Outcome, interrupt};

pub(crate) fn execute(arguments: &Arguments) -> Outcome {
    match &arguments.command {
        Command::Run(run) => run::execute(run),
        Command::Simulate(simulate) => simulate::execute(simulate),
        Command::Modes(modes) => modes::execute(modes),
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

/// Diagnostics printed of one report; a file that is no command file has thousands.
const MOST_PRINTED: usize = 200;

/// Prints diagnostics to standard error.
pub(crate) fn print(session: &Session, diagnostics: &[Diagnostic]) {
    if diagnostics.is_empty() {
        return;
    }
    let colour = text::use_colours(std::io::stderr().is_terminal());
    let (shown, left) = diagnostics.split_at(diagnostics.len().min(MOST_PRINTED));
    eprint!("{}", session.render(shown, colour));
    if !left.is_empty() {
        eprintln!("... and {} more; `flexure check --format json` lists them all", left.len());
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

/// Two texts as a unified diff.
fn unified(name: &str, before: &str, after: &str) -> String {
    let diff = similar::TextDiff::configure().timeout(std::time::Duration::from_secs(2)).diff_lines(before, after);
    diff.unified_diff().context_radius(3).header(name, name).to_string()
}

/// `1 error`, `3 warnings`.
fn count(number: usize, word: &str) -> String {
    if number == 1 { format!("{number} {word}") } else { format!("{number} {word}s") }
}
