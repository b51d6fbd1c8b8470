//! `flexure check`: reads and binds; simulates nothing and writes nothing.

use flexure::text::Format;

use crate::Outcome;
use crate::arguments::{Check, ReportFormat};
use crate::commands::{count, print, read, session};

pub(super) fn execute(check: &Check) -> Outcome {
    let mut session = session();
    session.simulate_nothing(true);
    let mut diagnostics = Vec::new();
    for file in &check.files {
        diagnostics.extend(read(&mut session, file).diagnostics);
    }
    let errors = diagnostics.iter().filter(|d| d.is_error()).count();
    match check.format {
        ReportFormat::Text => {
            print(&session, &diagnostics);
            eprintln!("{}, {}", count(errors, "error"), count(diagnostics.len() - errors, "warning"));
        }
        machine => print!("{}", flexure::text::render(session.sources(), &diagnostics, form(machine))),
    }
    if errors > 0 { Outcome::Findings } else { Outcome::Fine }
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
