//! Diagnostics as text for people and for machines. One function; the format is an argument.

mod machine;
mod terminal;

use crate::{Diagnostic, LineColumn, Sources, Span};

/// How diagnostics are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// The source line with the place underlined, notes and helps below it.
    Terminal {
        colours: bool,
    },
    /// `file:line:column: error[code]: message`.
    OneLine,
    Json,
    /// Annotations of a GitHub workflow.
    Github,
    /// SARIF 2.1.0.
    Sarif,
    /// JUnit XML: every finding is a test case, an error a failed one.
    Junit,
}

/// Writes diagnostics in the given order. Every format but the first two is one whole document.
pub fn render(sources: &Sources, diagnostics: &[Diagnostic], format: Format) -> String {
    match format {
        Format::Terminal { colours } => {
            diagnostics.iter().map(|d| terminal::block(sources, d, colours)).collect::<Vec<_>>().join("\n")
        }
        Format::OneLine => diagnostics.iter().map(|d| one_line(sources, d) + "\n").collect(),
        Format::Json => machine::json(sources, diagnostics),
        Format::Github => machine::github(sources, diagnostics),
        Format::Sarif => machine::sarif(sources, diagnostics),
        Format::Junit => machine::junit(sources, diagnostics),
    }
}

/// Whether to colour what is written to a terminal: not if `NO_COLOR` is set to anything.
pub fn use_colours(is_terminal: bool) -> bool {
    is_terminal && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

/// The whole trouble on one line.
pub fn one_line(sources: &Sources, diagnostic: &Diagnostic) -> String {
    let place = match &diagnostic.primary {
        Some(label) => {
            let (start, _) = range(sources, label.span);
            format!("{}:{}:{}: ", sources.name(label.span.file), start.line, start.column)
        }
        None => String::new(),
    };
    let message = printable(&diagnostic.message);
    format!("{place}{}[{}]: {message}", diagnostic.severity.word(), diagnostic.code)
}

fn range(sources: &Sources, span: Span) -> (LineColumn, LineColumn) {
    (sources.line_column(span.file, span.start), sources.line_column(span.file, span.end))
}

/// Text of a user's file can carry control characters, which no terminal should act on.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}
