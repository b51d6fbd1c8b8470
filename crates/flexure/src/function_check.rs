//! Run-time functions that cannot be used, where they were given: what `flexure check` says of them
//! before anything is simulated.

use text::Diagnostic;

use crate::session::Session;

impl Session {
    /// Errors for functions of all models that cannot be read, or name what does not exist; at the
    /// argument that gave the function, where a command did.
    pub fn check_functions(&self) -> Vec<Diagnostic> {
        let database = self.database();
        let mut found = Vec::new();
        for bad in elements::runtime::check::bad_functions(database) {
            let name = database.full_name(bad.object);
            let text = elements::runtime::text_of(database, bad.object, bad.cell);
            for trouble in bad.diagnostics {
                let message = format!("`{}` of `{name}`: {}", bad.cell, trouble.message);
                let mut error = Diagnostic::error(trouble.code, message).note(format!("the function is `{text}`"));
                let label = trouble.primary.map(|label| label.text).unwrap_or_default();
                if let Some(place) = self.interpreter.function_place(bad.object, bad.cell) {
                    error = error.at(place, label);
                }
                error.notes.extend(trouble.notes);
                error.helps.extend(trouble.helps.into_iter().map(|help| text::Help { fix: None, ..help }));
                found.push(error);
            }
        }
        found
    }
}
