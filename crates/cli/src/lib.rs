//! `flexure`: the command line. Arguments in, one call of the facade, reports out.
//!
//! Exit status: 0 fine, 1 findings or a failed run, 2 wrong usage, 3 our fault, 130 interrupted.

mod arguments;
mod commands;
mod interrupt;
mod output;
mod progress;
mod shell;
mod shell_line;

use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

use clap::Parser;

pub use arguments::Arguments;

/// How a command ended, as exit status.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Fine,
    Findings,
    Usage,
    Interrupted,
}

impl Outcome {
    fn status(self) -> u8 {
        match self {
            Outcome::Fine => 0,
            Outcome::Findings => 1,
            Outcome::Usage => 2,
            Outcome::Interrupted => 130,
        }
    }
}

/// Runs the command line and returns its exit status.
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    ExitCode::from(status(arguments))
}

/// Runs the command line; returns its exit status as a number.
pub fn status(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version are no errors; clap knows which stream and status each deserves.
            if let Err(trouble) = error.print()
                && !error.use_stderr()
            {
                return cannot_write(&trouble.to_string());
            }
            return u8::try_from(error.exit_code()).unwrap_or(2);
        }
    };
    std::panic::set_hook(Box::new(|panic| {
        let said = panic.to_string();
        // The macros of the language have no other way to say that a stream takes nothing more.
        if said.contains("failed printing to stderr") {
            std::process::exit(1);
        }
        if let Some((_, trouble)) = said.split_once("failed printing to stdout: ") {
            std::process::exit(i32::from(cannot_write(trouble)));
        }
        eprintln!("flexure: internal error: {panic}");
        eprintln!("This is a fault of flexure, not of your model. Please report it with the files and the command.");
    }));
    let status = std::panic::catch_unwind(|| commands::execute(&arguments)).map_or(3, Outcome::status);
    match std::io::stdout().flush() {
        Err(trouble) => cannot_write(&trouble.to_string()),
        Ok(()) => status,
    }
}

/// Says that nobody will read what was asked for; returns the exit status.
fn cannot_write(trouble: &str) -> u8 {
    // Whoever read our output has read enough (`flexure verify ... | head`).
    if trouble.contains("Broken pipe") {
        return 141;
    }
    commands::complain(format_args!("cannot write standard output: {}", trouble.trim_end()));
    1
}
