//! Loops through numbers or objects: their variable, its values, and a pass for each.

use model::{ObjectId, Value};
use text::Diagnostic;

use crate::{Interpreter, blocks::Blocks, call::Call, interpreter::Flow, lookup, program::Program};

impl Interpreter {
    pub(crate) fn run_for(&mut self, program: &Program, blocks: &Blocks, at: usize) -> Flow {
        let end = blocks.end[at];
        let call = match self.opener(program, at) {
            Ok(call) => call,
            Err(flow) => return self.skip_block(program, at + 1, end, flow),
        };
        let mark = self.database.mark();
        let found = self.flag_argument(&call, "echo_all_loops").and_then(|echo| Ok((echo, self.loop_values(&call)?)));
        let (echo_all, (variable, values)) = match found {
            Ok((echo, found)) => (echo == Some(true), found),
            Err(errors) => {
                self.database.roll_back(mark);
                self.taken_back();
                let flow = self.opener_failed(program, at, errors);
                return self.skip_block(program, at + 1, end, flow);
            }
        };
        self.report.executed += 1;
        self.echo_now(program, call.span);
        self.report.diagnostics.extend(call.unused());
        // The loop alone makes and removes its variable: undo within the loop or behind it does neither.
        self.database.leave_out_of_history(variable);
        let flow = self.passes_of_for(program, blocks, at, &call, (variable, values, echo_all));
        self.end_loop(variable, &call);
        self.database.take_into_history(variable);
        if self.undo_blocks == 0 {
            self.database.finish_step();
        }
        flow
    }

    fn passes_of_for(
        &mut self,
        program: &Program,
        blocks: &Blocks,
        at: usize,
        call: &Call,
        (variable, values, echo_all): (ObjectId, Vec<Value>, bool),
    ) -> Flow {
        let end = blocks.end[at];
        if values.is_empty() {
            self.block_depth += 1;
            self.echo_skipped(program, at + 1, end);
            self.block_depth -= 1;
        }
        for (pass, value) in values.into_iter().enumerate() {
            let name = if matches!(value, Value::Object(_)) { "object_value" } else { "real_value" };
            if self.database.get(variable).is_none() {
                break;
            }
            self.database.set_value(variable, name, value);
            let class = self.database.object(variable).class;
            if let Some(cell) = class.cell_index(name)
                && let Err(errors) = self.recompute(&[model::CellKey::new(variable, cell)], call.span)
            {
                return self.failed(errors);
            }
            if pass > 0 && echo_all {
                self.echo_again(program, at + 1);
            }
            match self.pass(program, blocks, at, end) {
                Flow::Next | Flow::Continue | Flow::Skipped => {}
                Flow::Break => break,
                other => return other,
            }
            if end >= program.statements.len() {
                return Flow::Next;
            }
        }
        self.close(program, end, -(self.block_depth as i64) - 1);
        Flow::Next
    }

    /// Creates the loop variable and lists its values.
    fn loop_values(&mut self, call: &Call) -> Result<(ObjectId, Vec<Value>), Vec<Diagnostic>> {
        let Some(name) = call.argument("variable_name") else { return Err(vec![call.missing(&["variable_name"])]) };
        let mut number = |what: &str| -> Result<Option<f64>, Vec<Diagnostic>> {
            let (Some(argument), Some(field)) = (call.argument(what), call.field(what)) else { return Ok(None) };
            let field = *field;
            Ok(self.read_value(call, &field, argument, None)?.value.as_number())
        };
        let (start, stop) = (number("start_value")?, number("end_value")?);
        let step = number("increment_value")?.unwrap_or(1.0);
        let values = if let Some(start) = start {
            let Some(stop) = stop else { return Err(vec![call.missing(&["end_value"])]) };
            numbers_of_loop(call, start, stop, step, self.most_passes)?
        } else {
            self.objects_of_loop(call)?.into_iter().map(Value::Object).collect()
        };
        let typed = self.text_argument(call, name)?;
        let Some(class) = self.registry.class("variable") else { return Err(vec![call.missing(&["variable_name"])]) };
        let place = lookup::new_name(&self.database, &self.registry, class, &typed, name.value_span)
            .or_else(|e| {
                // Without a model the variable is at the top.
                if typed.contains('.') { Err(e) } else { Ok(lookup::NewName { parent: None, name: typed.clone() }) }
            })
            .map_err(|e| vec![e])?;
        let id = self
            .database
            .create(class, place.parent, &place.name)
            .map_err(|t| vec![lookup::taken(&self.database, class, &typed, t.0, name.value_span)])?;
        Ok((id, values))
    }

    fn objects_of_loop(&mut self, call: &Call) -> Result<Vec<ObjectId>, Vec<Diagnostic>> {
        let mut found =
            if let (Some(argument), Some(field)) = (call.argument("object_names"), call.field("object_names")) {
                let field = *field;
                match self.read_value(call, &field, argument, None) {
                    Ok(draft) => draft.value.objects(),
                    // A pattern that matches nothing makes an empty loop.
                    Err(errors) if errors.iter().all(|e| e.message.contains("matches")) => Vec::new(),
                    Err(errors) => return Err(errors),
                }
            } else if let (Some(argument), Some(field)) = (call.argument("group_name"), call.field("group_name")) {
                let field = *field;
                let groups = self.read_value(call, &field, argument, None)?.value.objects();
                groups
                    .iter()
                    .flat_map(|g| self.database.value(*g, "objects_in_group").map(Value::objects).unwrap_or_default())
                    .collect()
            } else {
                return Err(vec![call.missing(&["start_value", "object_names", "group_name"])]);
            };
        if let Some(argument) = call.argument("type_filter") {
            let wanted = self.text_argument(call, argument)?.to_ascii_lowercase();
            found.retain(|id| {
                let class = self.database.object(*id).class;
                class.is(&wanted) || class.word.eq_ignore_ascii_case(&wanted)
            });
        }
        Ok(found)
    }

    /// The loop variable goes away unless something was made to follow it.
    fn end_loop(&mut self, variable: ObjectId, call: &Call) {
        if self.database.get(variable).is_none() {
            return;
        }
        let dependents = self.dependents_of(&[variable]);
        if dependents.is_empty() {
            self.database.remove(variable);
            return;
        }
        let name = self.database.full_name(variable);
        let names: Vec<String> = dependents.iter().map(|d| self.database.full_name(*d)).collect();
        let warning = Diagnostic::warning(
            "variable/kept",
            format!("the loop variable `{name}` is kept: {}", crate::words::referring(names.len())),
        )
        .at(call.span, "they all have the value of the last pass")
        .note(format!("it is used by {}", names.join(", ")))
        .help("write `(eval(...))` inside the loop to store values instead of expressions")
        .adams(format!("The variable {name} was not deleted because "))
        .adams(format!("{} objects depend on it. Using the EVAL function when referencing", names.len()))
        .adams("the variable inside this loop eliminate these dependencies.")
        .adams(names.join(", "));
        self.complain(vec![warning]);
    }
}

fn numbers_of_loop(call: &Call, start: f64, stop: f64, step: f64, most: u64) -> Result<Vec<Value>, Vec<Diagnostic>> {
    if step == 0.0 {
        return Err(vec![
            Diagnostic::error("value/zero", "the increment of a loop must not be 0")
                .at(call.argument("increment_value").map_or(call.span, |a| a.value_span), "never arrives")
                .adams("Invalid input. Enter a real number."),
        ]);
    }
    let passes = ((stop - start) / step * (1.0 + 1e-12) + 1e-9).floor();
    if passes < 0.0 {
        return Ok(Vec::new());
    }
    // The first pass is at `start` already.
    let passes_in_all = passes + 1.0;
    if passes_in_all > most as f64 {
        return Err(vec![
            Diagnostic::error("command/endless-loop", format!("this loop would have {passes_in_all} passes"))
                .at(call.span, format!("at most {most}")),
        ]);
    }
    Ok((0..=passes as u64).map(|k| Value::Number(start + k as f64 * step)).collect())
}
