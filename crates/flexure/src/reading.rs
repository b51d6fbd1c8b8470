//! Reading files into a session: what their names and their beginnings say that they hold.

use std::io::{self, Read};
use std::path::Path;

use text::{Diagnostic, Sources};

use crate::session::{Report, Session, refused};

/// Files of Adams that are known by their extension and not read.
const NOT_READ: [(&str, &str); 5] = [
    ("acf", "a solver command file"),
    ("res", "a results file"),
    ("req", "a request file"),
    ("gra", "a graphics file"),
    ("bin", "a binary database"),
];

impl Session {
    /// Executes a command file (`.cmd`, `.mac`), or reads a solver dataset (`.adm`) or a model (`.fx`).
    pub fn read(&mut self, path: &Path) -> Report {
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
        if let Some((_, what)) = NOT_READ.iter().find(|(known, _)| *known == extension) {
            let text = format!("{} is {what}; Flexure does not read that yet", path.display());
            let refusal = Diagnostic::error("file/not-read-yet", text)
                .help("command files (.cmd, .mac), solver datasets (.adm) and models of Flexure (.fx) are read");
            return refused(refusal);
        }
        self.engine().folder = path.parent().map(Path::to_path_buf);
        if extension == "fx" {
            return self.read_store(path);
        }
        if extension == "adm" {
            // The command is what the journal replays and what one step takes back.
            return self.execute(&format!("file adams_data_set read file_name = {}", quoted(path)));
        }
        if let Some(refusal) = std::fs::File::open(path).ok().and_then(|file| {
            let mut head = Vec::new();
            file.take(HEAD as u64).read_to_end(&mut head).ok()?;
            refuse_dataset(&path.display().to_string(), &head)
        }) {
            return refused(refusal);
        }
        let command = format!("file command read file_name = {}", quoted(path));
        self.journalled(&command, |interpreter| interpreter.run_file(path))
    }

    /// Executes bytes as the text of a command file.
    pub fn read_bytes(&mut self, name: &str, bytes: Vec<u8>) -> Report {
        if let Some(refusal) = refuse_dataset(name, &bytes) {
            return refused(refusal);
        }
        let mut sources = Sources::default();
        let file = sources.add_bytes(name, bytes);
        let text = sources.text(file).to_string();
        self.journalled(&text, |interpreter| interpreter.run_text(name, &text))
    }

    /// Executes bytes as if a command file held them, or reads them as a solver dataset: what the
    /// extension says.
    pub fn read_bytes_as(&mut self, path: &Path, bytes: Vec<u8>) -> Report {
        self.engine().folder = path.parent().map(Path::to_path_buf);
        if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("adm")) {
            let name = path.display().to_string();
            let command = format!("file adams_data_set read file_name = {}", quoted(path));
            return self.journalled(&command, |interpreter| interpreter.read_data_set(&name, bytes));
        }
        self.read_bytes(&path.display().to_string(), bytes)
    }

    /// The report of a file that cannot be read.
    pub fn unreadable(&self, path: &Path, error: &io::Error) -> Report {
        let message = format!("cannot read {}: {error}", path.display());
        refused(Diagnostic::error("file/unreadable", message))
    }
}

/// How much of a file tells what it holds.
const HEAD: usize = 8_192;

/// A path as the text of a command.
fn quoted(path: &Path) -> String {
    syntax::command::quote(&path.display().to_string())
}

/// Instead of an error for each line of a dataset that is read as commands.
pub(crate) fn refuse_dataset(name: &str, bytes: &[u8]) -> Option<Diagnostic> {
    let head = bytes.get(..HEAD).unwrap_or(bytes);
    if !dataset::looks_like_dataset(&String::from_utf8_lossy(head)) {
        return None;
    }
    let message = format!("{name} looks like a solver dataset, not like a command file");
    let refusal = Diagnostic::error("file/dataset", message);
    Some(refusal.help("give it the ending `.adm`, or read it with `file adams_data_set read file_name = ...`"))
}
