//! Text of a dataset to a model. [`lines`] finds the statements and their comments, [`arguments`]
//! splits them, [`build`] makes objects of them; what an argument means is told by the table of its
//! class, or stands beside the writer of its statement under `statements/`.

mod arguments;
mod build;
mod cells;
mod contradictions;
mod entry;
mod functions;
mod guess;
mod lines;
mod objects;
mod splitter;
mod statement;
mod troubles;
mod units;
mod values;
mod vocabulary;

use std::ops::Range;

use model::{CellKey, Database, ObjectId};
use schema::Registry;
use text::{Diagnostic, FileId, Span};

pub(crate) use build::Builder;
pub(crate) use entry::Entry;
pub use guess::looks_like_dataset;
pub(crate) use lines::{END_OF_MODEL_COMMENTS, NOT_WRITTEN};
pub use statement::{Argument, Statement};
pub(crate) use values::{parse, unquoted};
pub(crate) use vocabulary::{Form, Word};

use lines::Block;
use splitter::Splitter;
use vocabulary::{Found, Vocabulary};

/// How the title line of a dataset names the model.
pub(crate) const TITLE: &str = "Adams View model name: ";
/// How old versions wrote that.
const OLD_TITLE: &str = "ADAMS/View model name: ";

/// A dataset split into statements.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Statements {
    /// The first line, whatever it says.
    pub title: String,
    /// Comments behind the title, up to the one that ends them.
    pub model_comments: Vec<String>,
    pub statements: Vec<Statement>,
    /// Comments behind the last statement.
    pub trailing_comments: Vec<String>,
    pub diagnostics: Vec<Diagnostic>,
}

impl Statements {
    /// How many statements of a name there are, without those behind comment marks.
    pub fn count(&self, name: &str) -> usize {
        self.statements.iter().filter(|s| !s.inactive && s.name.eq_ignore_ascii_case(name)).count()
    }
}

/// Splits the text of a dataset up to `END`; the registry tells which statements and arguments
/// there are.
pub fn read_statements(registry: &Registry, file: FileId, text: &str) -> Statements {
    let vocabulary = Vocabulary::new(registry);
    let found = lines::blocks(file, text);
    let mut splitter = Splitter { file, text, vocabulary: &vocabulary, diagnostics: found.diagnostics };
    let mut statements = Vec::new();
    let mut remarks = Remarks::default();
    for block in found.list {
        let remark = block.inactive.then(|| block.clone());
        let said = splitter.diagnostics.len();
        match splitter.statement(block) {
            Some(mut statement) => {
                remarks.join(&mut statement.comments, &mut statement.view_name);
                statements.push(statement);
            }
            None => remarks.extend(remark.filter(|_| splitter.diagnostics.len() == said), text),
        }
    }
    let mut trailing_comments = found.trailing;
    remarks.join(&mut trailing_comments, &mut Some(String::new()));
    splitter.diagnostics.extend(statement_as_title(file, &found.title, &vocabulary));
    splitter.diagnostics.extend(behind_end(file, text, &vocabulary, &found.behind_end));
    in_order(&mut splitter.diagnostics);
    Statements {
        title: found.title,
        model_comments: found.model_comments,
        statements,
        trailing_comments,
        diagnostics: splitter.diagnostics,
    }
}

/// Comments that looked like statements that are switched off, until the statement they belong to.
#[derive(Default)]
struct Remarks {
    comments: Vec<String>,
    view_name: Option<String>,
}

impl Remarks {
    fn extend(&mut self, block: Option<Block>, text: &str) {
        let Some(block) = block else { return };
        self.comments.extend(block.comments);
        let lines = block.pieces.iter().filter_map(|piece| text.get(piece.clone())).enumerate();
        self.comments.extend(lines.map(|(line, text)| format!("{}{text}", if line == 0 { "" } else { "," })));
        self.view_name = block.view_name.or(self.view_name.take());
    }

    /// Puts them before comments; the name that stood with them is that of the object if it has none.
    fn join(&mut self, comments: &mut Vec<String>, view_name: &mut Option<String>) {
        let mut remarks = std::mem::take(&mut self.comments);
        match self.view_name.take() {
            Some(name) if view_name.is_none() => *view_name = Some(name),
            Some(name) => remarks.insert(0, format!("adams_view_name='{name}'")),
            None => {}
        }
        comments.splice(0..0, remarks);
    }
}

/// Says of a first line that looks like a statement that it is none.
fn statement_as_title(file: FileId, title: &str, vocabulary: &Vocabulary) -> Option<Diagnostic> {
    let (word, behind) = title.split_once('/').filter(|_| lines::begins_statement(title))?;
    let argued = behind.trim_start().starts_with(|c: char| c.is_ascii_digit()) || behind.contains('=');
    let known = matches!(vocabulary.statement(word.trim()), Found::One(_));
    let message = "the first line is the title, whatever it says: it is read as no statement";
    let at = Span::new(file, 0, title.len());
    let left_out = Diagnostic::warning("dataset/statement-as-title", message).at(at, "left out");
    (argued && known).then(|| left_out.help("put a line with a title before it"))
}

/// Says of statements behind END that nobody reads them.
fn behind_end(file: FileId, text: &str, vocabulary: &Vocabulary, lines: &[Range<usize>]) -> Option<Diagnostic> {
    let known = |line: &&Range<usize>| {
        let line = text.get((*line).clone()).unwrap_or_default();
        let word = line.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).next().unwrap_or_default();
        // A line of prose may begin with a letter or two and a slash.
        matches!(vocabulary.statement(word), Found::One(name) if word.len() > 2 || name.len() == word.len())
    };
    let mut lines = lines.iter().filter(known);
    let first = lines.next()?;
    let message = match 1 + lines.count() {
        1 => "a statement behind END is not read".to_string(),
        count => format!("{count} statements behind END are not read"),
    };
    let left_out = Diagnostic::warning("dataset/behind-end", message);
    let at = Span::new(file, first.start, first.end);
    Some(left_out.at(at, "left out").help("if they belong to the model, move END behind them"))
}

/// What a dataset is read as.
#[derive(Clone, Copy, Debug, Default)]
pub struct Naming<'a> {
    /// Name of the model, whatever the dataset says.
    pub model: Option<&'a str>,
    /// Its name if the title of the dataset has none: that of the file.
    pub otherwise: &'a str,
}

/// A model that was read, and what was wrong with its dataset.
#[derive(Clone, Debug)]
pub struct Loaded {
    pub model: ObjectId,
    /// Where the functions of its objects stand in the text.
    pub functions: Vec<(CellKey, Span)>,
    pub diagnostics: Vec<Diagnostic>,
}

/// Makes a model of a dataset. What is not understood is reported and left out; the rest stands. The
/// units of the dataset, with degrees, are in force afterwards; what it does not tell of them is taken
/// from those in force.
///
/// # Errors
/// If there is no statement at all, or the model's name is taken: then nothing has changed.
pub fn read(
    database: &mut Database,
    registry: &Registry,
    file: FileId,
    text: &str,
    naming: Naming<'_>,
) -> Result<Loaded, Vec<Diagnostic>> {
    let found = read_statements(registry, file, text);
    build::build(database, registry, (file, text), found, naming)
}

/// By their places in the file.
fn in_order(diagnostics: &mut [Diagnostic]) {
    diagnostics.sort_by_key(|d| d.primary.as_ref().map_or(0, |label| label.span.start));
}
