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
            let _ = error.print();
            return u8::try_from(error.exit_code()).unwrap_or(2);
        }
    };
    std::panic::set_hook(Box::new(|panic| {
        // Whoever read our output has read enough (`flexure verify ... | head`).
        if panic.to_string().contains("Broken pipe") {
            std::process::exit(141);
        }
        eprintln!("flexure: internal error: {panic}");
        eprintln!("This is a fault of flexure, not of your model. Please report it with the files and the command.");
    }));
    std::panic::catch_unwind(|| commands::execute(&arguments)).map_or(3, Outcome::status)
}
