//! What kind of text a file holds that is not what its name says.

use text::{Diagnostic, FileId, Span};

use super::lines::begins_statement;
use crate::write::known;

/// Whether a text, or the beginning of one, is that of a dataset: a statement of the solver stands first,
/// or behind one line of title.
pub fn looks_like_dataset(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('!'));
    lines.by_ref().take(2).any(|line| {
        let Some((name, behind)) = line.split_once('/') else { return false };
        let name = name.trim_end().to_ascii_uppercase();
        let ends = behind.is_empty() || behind.contains(['=', ',']) || behind.starts_with(|c: char| c.is_ascii_digit());
        begins_statement(line) && ends && (name == "UNITS" || known(&name))
    })
}

/// Second or third words of most commands.
const VERBS: &[&str] = &["create", "modify", "set", "copy", "delete", "read", "write", "attributes", "units"];

/// Whether a text holds commands.
pub(super) fn looks_like_commands(text: &str) -> bool {
    text.lines().filter(|line| !line.trim_start().starts_with('!')).any(|line| {
        let verb = |word: &str| VERBS.iter().any(|verb| word.eq_ignore_ascii_case(verb));
        line.split_whitespace().skip(1).take(2).any(verb)
    })
}

/// Instead of an error for each line of it.
pub(super) fn command_file(file: FileId) -> Diagnostic {
    Diagnostic::error("dataset/command-file", "this looks like a command file, not like a solver dataset")
        .at(Span::new(file, 0, 0), "commands")
        .help("give it the ending `.cmd`, or read it with `file command read file_name = ...`")
}
