//! Commands of a model that are understood but not executed: their text is kept, so that a model
//! that is read and written again still holds them.

use model::{ObjectId, UnitsId};

use crate::{Interpreter, export, program::Program};

/// The text of a command that was skipped, with what its numbers and names depend on.
#[derive(Clone, Debug)]
pub(crate) struct Kept {
    pub model: ObjectId,
    /// As typed, on as many lines.
    pub text: String,
    pub units: UnitsId,
    /// The frame that locations without one are in.
    pub frame: Option<ObjectId>,
}

/// First words of commands that build a model; others concern the display, dialogs or runs.
const OF_A_MODEL: &[&str] = &[
    "model",
    "part",
    "marker",
    "floating_marker",
    "point",
    "geometry",
    "constraint",
    "force",
    "data_element",
    "measure",
    "ude",
    "assembly",
    "clearance",
    "section",
    "contact",
    "material",
    "group",
    "entity",
    "variable",
    "macro",
    "library",
    "function",
    "notes",
    "executive_control",
    "output_control",
    "symmetry_relation",
    "runtime_function",
];

/// Later words that say that a command makes or changes something that stays.
const LASTING: &[&str] = &["create", "modify", "set", "attributes", "add", "copy", "merge"];

/// Whether a skipped command is a piece of a model.
fn belongs_to_a_model(path: &str) -> bool {
    let mut words = path.split(' ');
    let first = words.next().unwrap_or("");
    // Solids of other programs are geometry, and later commands name them.
    path.starts_with("file parasolid read") || OF_A_MODEL.contains(&first) && words.any(|word| LASTING.contains(&word))
}

impl Interpreter {
    /// The commands that build a model, and those that were skipped when it was read.
    #[must_use]
    pub fn write_model(&self, model: ObjectId) -> String {
        let kept: Vec<&Kept> = self.kept.iter().filter(|k| k.model == model).collect();
        export::write(&self.database, model, &kept)
    }

    /// The commands of a model that were skipped when it was read, as typed.
    #[must_use]
    pub fn kept_commands(&self, model: ObjectId) -> Vec<String> {
        self.kept.iter().filter(|k| k.model == model).map(|k| k.text.clone()).collect()
    }

    /// Keeps the text of a statement that has been skipped, if it is a piece of the current model.
    pub(crate) fn keep(&mut self, program: &Program, index: usize) {
        let Some(model) = self.database.current("model") else { return };
        let Some((keywords, arguments)) = program.command(index) else { return };
        let span = program.statements[index].statement.span;
        let Ok(command) = self.find_command(program, span, keywords, arguments) else { return };
        if !belongs_to_a_model(&command.path) {
            return;
        }
        let text = program.word(span).trim_end().replace("\r\n", "\n");
        let settings = self.database.settings();
        self.kept.push(Kept { model, text, units: settings.units, frame: settings.default_frame });
    }
}
