//! Text of a dataset to a model. [`lines`] finds the statements and their comments, [`arguments`]
//! splits them, [`build`] makes objects of them; what an argument means is told by the table of its
//! class, or stands beside the writer of its statement under `statements/`.

mod arguments;
mod build;
mod cells;
mod entry;
mod functions;
mod lines;
mod objects;
mod statement;
mod units;
mod values;
mod vocabulary;

use model::{Database, ObjectId};
use schema::Registry;
use text::{Diagnostic, FileId};

pub(crate) use build::Builder;
pub(crate) use entry::Entry;
pub(crate) use lines::{END_OF_MODEL_COMMENTS, NOT_WRITTEN};
pub use statement::{Argument, Statement};
pub(crate) use values::unquoted;
pub(crate) use vocabulary::{Form, Word};

use arguments::Splitter;
use vocabulary::Vocabulary;

/// How the title line of a dataset names the model.
pub(crate) const TITLE: &str = "Adams View model name: ";

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
    let statements = found.list.into_iter().filter_map(|block| splitter.statement(block)).collect();
    in_order(&mut splitter.diagnostics);
    Statements {
        title: found.title,
        model_comments: found.model_comments,
        statements,
        trailing_comments: found.trailing,
        diagnostics: splitter.diagnostics,
    }
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
    pub diagnostics: Vec<Diagnostic>,
}

/// Makes a model of a dataset. What is not understood is reported and left out; the rest stands. The
/// units of the dataset, with degrees, are in force afterwards; without any, those in force hold.
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
