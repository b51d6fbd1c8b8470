//! Run-time functions of a database looked at without lowering a model: whether each can be read, and
//! whether what it names exists. What is not computed yet is no mistake of the function.

use functions::Resolver;
use model::{Database, ObjectId, Value};
use text::Diagnostic;

use super::{Finder, Worth, text_of};

/// Codes of what concerns Flexure, not the function.
const NOT_WRONG: &[&str] = &["function/not-supported", "function/not-finite"];

/// Cells whose expression is over results of a run, not over the state in one.
const OF_RESULTS: &[&str] = &["text_of_expression"];

/// A function that cannot be used: whose, in which cell, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct BadFunction {
    pub object: ObjectId,
    pub cell: &'static str,
    pub diagnostics: Vec<Diagnostic>,
}

/// The functions of all objects that cannot be used, in order of creation.
pub fn bad_functions(database: &Database) -> Vec<BadFunction> {
    let mut found = Vec::new();
    for id in database.ids() {
        let object = database.object(id);
        for (index, cell) in object.cells.iter() {
            let Value::Function(_) = &cell.value else { continue };
            let Some(model) = database.model_of(id).filter(|_| object.class.statement.is_some()) else { continue };
            let name = object.class.field(index).name;
            let text = text_of(database, id, name);
            if text.trim().is_empty() {
                continue;
            }
            let mut names = Names { finder: Finder { database, model }, of_results: OF_RESULTS.contains(&name) };
            let diagnostics = troubles(&mut names, &text);
            if !diagnostics.is_empty() {
                found.push(BadFunction { object: id, cell: name, diagnostics });
            }
        }
    }
    found
}

fn troubles(names: &mut Names<'_>, text: &str) -> Vec<Diagnostic> {
    let (tree, mut troubles) = syntax::function::parse(text::FileId(u32::MAX), text, 0);
    troubles.retain(Diagnostic::is_error);
    if troubles.is_empty() {
        troubles.extend(functions::compile(&tree, names).err().into_iter().flatten());
    }
    troubles.retain(|d| !NOT_WRONG.contains(&d.code));
    troubles
}

/// Knows which objects there are, and no state.
struct Names<'a> {
    finder: Finder<'a>,
    /// Whether names may be those of results.
    of_results: bool,
}

impl Resolver for Names<'_> {
    fn marker(&mut self, name: &str) -> Result<u32, String> {
        self.finder.marker(name).map(|id| id.0)
    }

    fn element(&mut self, function: &str, name: &str) -> Result<u32, String> {
        self.finder.element(function, name).map(|id| id.0)
    }

    /// A measure stands for its value in the modeller.
    fn number(&mut self, name: &str) -> Result<f64, String> {
        match self.finder.worth(name) {
            Ok(Worth::Number(x)) => Ok(x),
            Ok(Worth::Measured) => Ok(1.0),
            // `.model.analysis.object.component`, which no model holds before it is run.
            Err(_) if self.of_results && name.matches('.').count() > 3 => Ok(1.0),
            Err(reason) => Err(reason),
        }
    }
}
