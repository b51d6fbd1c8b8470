//! Typed access to the arguments of verbs.

use model::{ObjectId, Value};
use text::Diagnostic;

use crate::{Interpreter, call::Call};

type Outcome<T> = Result<T, Vec<Diagnostic>>;

impl Interpreter {
    fn argument_value(&mut self, call: &Call, name: &str) -> Outcome<Option<Value>> {
        let (Some(argument), Some(field)) = (call.argument(name), call.field(name).copied()) else { return Ok(None) };
        Ok(Some(self.read_value(call, &field, argument, None)?.value))
    }

    /// A word or text.
    pub(crate) fn word_of(&mut self, call: &Call, name: &str) -> Outcome<Option<String>> {
        let value = self.argument_value(call, name)?;
        Ok(value.map(|v| crate::values::text_of(&v, &self.database)))
    }

    pub(crate) fn number_argument(&mut self, call: &Call, name: &str) -> Outcome<Option<f64>> {
        Ok(self.argument_value(call, name)?.and_then(|v| v.as_number()))
    }

    pub(crate) fn flag_argument(&mut self, call: &Call, name: &str) -> Outcome<Option<bool>> {
        Ok(self.argument_value(call, name)?.and_then(|v| v.as_number()).map(|x| x != 0.0))
    }

    pub(crate) fn object_argument(&mut self, call: &Call, name: &str) -> Outcome<Option<ObjectId>> {
        Ok(self.argument_value(call, name)?.and_then(|v| v.as_object()))
    }

    pub(crate) fn objects_argument(&mut self, call: &Call, name: &str) -> Outcome<Vec<ObjectId>> {
        Ok(self.argument_value(call, name)?.map(|v| v.objects()).unwrap_or_default())
    }

    /// `model_name`, or the current model.
    pub(crate) fn model_argument(&mut self, call: &Call) -> Outcome<ObjectId> {
        match self.object_argument(call, "model_name")?.or_else(|| self.database.current("model")) {
            Some(model) => Ok(model),
            None => Err(vec![call.missing(&["model_name"])]),
        }
    }

    /// A text as it is meant, without the quoting of names.
    pub(crate) fn text_argument_plain(&mut self, call: &Call, argument: &syntax::command::Argument) -> Outcome<String> {
        match call.plain_text(argument) {
            Some(text) => Ok(text),
            None => self.text_argument(call, argument),
        }
    }

    /// Lines for the information window: to the host and to the journal.
    pub(crate) fn show(&mut self, lines: &[String]) {
        self.host.show(lines);
        if let Some(journal) = &mut self.journal {
            journal.information(lines);
        }
    }

    /// Writes lines to the file an argument names, if given.
    pub(crate) fn write_lines(&mut self, call: &Call, name: &str, lines: &[String]) -> Outcome<()> {
        let Some(argument) = call.argument(name) else { return Ok(()) };
        let path = self.text_argument_plain(call, argument)?;
        let path = self.host.resolve(&path);
        let mut text = lines.join("\n");
        text.push('\n');
        self.host.write_file(&path, &text).map_err(|e| {
            vec![
                Diagnostic::error("file/cannot-write", format!("cannot write `{}`: {e}", path.display()))
                    .at(argument.value_span, "this file"),
            ]
        })
    }
}
