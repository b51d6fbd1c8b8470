//! `undo ...`: steps taken back and taken again, and blocks that count as one step.

use model::{Database, ObjectId};
use schema::{Field, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow};

/// Objects of a step that are named; of more the number is said.
const NAMED: usize = 3;

type Outcome = Result<Flow, Vec<Diagnostic>>;

const fn verb(path: &'static str, fields: &'static [Field], run: super::Run, doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, run)
}

pub const BACKWARD: VerbEntry = verb("undo backward", &[], backward, "takes the last step back");
pub const FORWARD: VerbEntry = verb("undo forward", &[], forward, "does the step taken back last again");
pub const BEGIN_BLOCK: VerbEntry = verb(
    "undo begin_block",
    &[Field::yes_no("suppress").doc("forget how to take the block back")],
    begin_block,
    "begins commands that are one step",
);
pub const END_BLOCK: VerbEntry = verb("undo end_block", &[], end_block, "ends commands that are one step");
pub const FLUSH: VerbEntry = verb("undo flush", &[], flush, "forgets all steps");
pub const SET: VerbEntry =
    verb("undo set", &[Field::integer("steps_stored").doc("steps kept")], set, "how many steps are kept");

impl Interpreter {
    /// Takes the last step back; false if there is none.
    pub fn undo(&mut self) -> bool {
        let gone = self.database.undo();
        self.fewest_steps = self.fewest_steps.min(self.database.history_depth().0);
        self.taken_back();
        gone
    }

    /// Does the step taken back last again; false if there is none.
    pub fn redo(&mut self) -> bool {
        let done = self.database.redo();
        self.taken_back();
        done
    }

    /// Puts what is remembered of the database right after changes were taken back.
    pub(crate) fn taken_back(&mut self) {
        self.names.forget();
        self.refresh_macros();
    }
}

fn backward(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    step(interpreter, call, true)
}

fn forward(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    step(interpreter, call, false)
}

/// Goes one step back or forward and says what it changes.
fn step(interpreter: &mut Interpreter, call: &Call, back: bool) -> Outcome {
    interpreter.database.finish_step();
    let effect = if back { interpreter.database.next_undo() } else { interpreter.database.next_redo() };
    let mut said = Vec::new();
    said.extend(listed(&interpreter.database, &effect.goes, "is gone", "are gone"));
    if !(if back { interpreter.undo() } else { interpreter.redo() }) {
        let what = if back { "take back" } else { "do again" };
        let error = Diagnostic::error("undo/nothing", format!("there is no step to {what}"));
        return Err(vec![error.at(call.span, "nothing changed")]);
    }
    said.extend(listed(&interpreter.database, &effect.comes, "is there", "are there"));
    said.extend(listed(&interpreter.database, &effect.changes, "is changed", "are changed"));
    if said.is_empty() {
        said.push("settings are changed".into());
    }
    let done = if back { "taken back" } else { "done again" };
    interpreter.host.show(&[format!("{done}: {}", said.join("; "))]);
    Ok(Flow::Next)
}

/// Objects with what becomes of them; many are counted.
fn listed(database: &Database, objects: &[ObjectId], one: &str, many: &str) -> Option<String> {
    let name = |id: &ObjectId| database.get(*id).map(|_| format!("`{}`", database.full_name(*id)));
    let names: Vec<String> = objects.iter().take(NAMED).filter_map(name).collect();
    let left = objects.len().saturating_sub(NAMED);
    match (names.len(), left) {
        (0, _) => None,
        (1, 0) => Some(format!("{} {one}", names[0])),
        (_, 0) => Some(format!("{} {many}", names.join(", "))),
        _ => Some(format!("{} and {left} more {many}", names.join(", "))),
    }
}

fn begin_block(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    if interpreter.undo_blocks == 0 {
        interpreter.database.finish_step();
        interpreter.suppress_undo = interpreter.flag_argument(call, "suppress")? == Some(true);
    }
    interpreter.undo_blocks += 1;
    Ok(Flow::Next)
}

fn end_block(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    if interpreter.undo_blocks == 0 {
        return Err(vec![
            Diagnostic::error("undo/no-block", "no undo block is open").at(call.span, "`undo begin_block` opens one"),
        ]);
    }
    interpreter.undo_blocks -= 1;
    if interpreter.undo_blocks == 0 && std::mem::take(&mut interpreter.suppress_undo) {
        interpreter.database.forget_open_step();
    }
    Ok(Flow::Next)
}

#[allow(clippy::unnecessary_wraps)] // the signature of all verbs
fn flush(interpreter: &mut Interpreter, _: &Call) -> Outcome {
    interpreter.database.flush_history();
    Ok(Flow::Next)
}

fn set(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    if let Some(steps) = interpreter.number_argument(call, "steps_stored")? {
        interpreter.database.limit_history(steps.max(0.0) as usize);
    }
    Ok(Flow::Next)
}
