//! Conditions and loops.

use model::{ObjectId, Value};
use syntax::command::StatementKind;
use text::Diagnostic;

use crate::{
    Interpreter,
    blocks::{Blocks, Control},
    call::Call,
    interpreter::Flow,
    lookup,
    program::Program,
    tree::Action,
};

impl Interpreter {
    /// Binds the command of a block opener; reports what is wrong with it.
    fn opener<'p>(&mut self, program: &'p Program, index: usize) -> Result<Call<'p>, Flow> {
        let parsed = &program.statements[index];
        let StatementKind::Command { keywords, arguments } = &parsed.statement.kind else { return Err(Flow::Next) };
        let span = parsed.statement.span;
        let errors: Vec<Diagnostic> = parsed.diagnostics.iter().filter(|d| d.is_error()).cloned().collect();
        let outcome = self.find_command(program, span, keywords, arguments).and_then(|command| {
            debug_assert!(matches!(command.action, Action::Verb(_)), "blocks are opened by verbs");
            self.bind(program, span, keywords, &command, arguments, errors)
        });
        match outcome {
            Ok(call) => Ok(call),
            Err(errors) => Err(self.opener_failed(program, index, errors)),
        }
    }

    fn opener_failed(&mut self, program: &Program, index: usize, errors: Vec<Diagnostic>) -> Flow {
        self.unit_refused = self.block_depth == 0;
        self.echo_pending(program, index, Some(&errors));
        self.failed(errors)
    }

    /// Whether a condition holds. It is echoed at a depth: that of the arm before, for `elseif`.
    fn condition(&mut self, program: &Program, index: usize, call: &Call, depth: i64) -> Result<bool, Flow> {
        let outcome = match (call.argument("condition"), call.field("condition")) {
            (Some(argument), Some(field)) => {
                let field = *field;
                self.read_value(call, &field, argument, None).and_then(|draft| match &draft.value {
                    Value::Object(_) => Ok(true),
                    Value::Nothing => Ok(false),
                    value => value.as_numbers().and_then(|n| n.first().copied()).map(|x| x != 0.0).ok_or_else(|| {
                        vec![
                            Diagnostic::error("value/not-a-number", "a condition wants a number")
                                .at(argument.value_span, "neither true nor false")
                                .adams("Invalid input. Enter an integer."),
                        ]
                    }),
                })
            }
            _ => Err(vec![call.missing(&["condition"])]),
        };
        match outcome {
            Ok(holds) => {
                self.report.executed += 1;
                self.echo_at(program, call.span, depth);
                Ok(holds)
            }
            Err(errors) => Err(self.opener_failed(program, index, errors)),
        }
    }

    pub(crate) fn run_if(&mut self, program: &Program, blocks: &Blocks, at: usize) -> Flow {
        let end = blocks.end[at];
        let call = match self.opener(program, at) {
            Ok(call) => call,
            Err(flow) => return self.skip_block(program, at + 1, end, flow),
        };
        let mut taken = match self.condition(program, at, &call, self.block_depth as i64) {
            Ok(holds) => holds,
            Err(flow) => return self.skip_block(program, at + 1, end, flow),
        };
        let inside = self.block_depth as i64 + 1;
        let mut from = at + 1;
        let mut done = false;
        let mut last_arm = None;
        for arm in blocks.arms(at).chain([end]) {
            let here = if taken && !done { inside } else { -inside };
            if taken && !done {
                done = true;
                self.block_depth += 1;
                let flow = self.run_range(program, blocks, from, arm);
                self.block_depth -= 1;
                if flow != Flow::Next {
                    return flow;
                }
            } else {
                self.block_depth += 1;
                self.echo_skipped(program, from, arm);
                self.block_depth -= 1;
            }
            if arm == end {
                self.close(program, end, here);
                break;
            }
            if let Some(other) = last_arm {
                let error = behind_else(program, arm, other);
                self.echo_pending(program, arm, Some(&vec![error.clone()]));
                let flow = self.failed(vec![error]);
                if flow != Flow::Next {
                    return flow;
                }
                (from, taken) = (arm + 1, false);
                continue;
            }
            if blocks.control[arm] == Control::Else {
                last_arm = Some(arm);
            }
            if blocks.control[arm] == Control::Else || done {
                self.echo_at(program, program.statements[arm].statement.span, here);
            }
            from = arm + 1;
            taken = match blocks.control[arm] {
                Control::Else => {
                    self.report.executed += 1;
                    true
                }
                _ if done => false,
                _ => match self.opener(program, arm).and_then(|call| self.condition(program, arm, &call, here)) {
                    Ok(holds) => holds,
                    Err(flow) => return self.skip_block(program, from, end, flow),
                },
            };
        }
        Flow::Next
    }

    /// A block whose opener failed is skipped to its end.
    fn skip_block(&mut self, program: &Program, from: usize, end: usize, flow: Flow) -> Flow {
        if flow == Flow::Next {
            self.block_depth += 1;
            self.echo_skipped(program, from, (end + 1).min(program.statements.len()));
            self.block_depth -= 1;
        }
        flow
    }

    fn close(&mut self, program: &Program, end: usize, depth: i64) {
        if let Some(parsed) = program.statements.get(end) {
            self.report.executed += 1;
            self.echo_at(program, parsed.statement.span, depth);
        }
        if self.undo_blocks == 0 {
            self.database.finish_step();
        }
    }

    pub(crate) fn run_while(&mut self, program: &Program, blocks: &Blocks, at: usize) -> Flow {
        let end = blocks.end[at];
        let call = match self.opener(program, at) {
            Ok(call) => call,
            Err(flow) => return self.skip_block(program, at + 1, end, flow),
        };
        let echo_all = match self.flag_argument(&call, "echo_all_loops") {
            Ok(flag) => flag == Some(true),
            Err(errors) => {
                let flow = self.opener_failed(program, at, errors);
                return self.skip_block(program, at + 1, end, flow);
            }
        };
        let mut passes = 0u64;
        loop {
            match self.condition(program, at, &call, self.block_depth as i64) {
                Ok(true) => {}
                Ok(false) => {
                    self.block_depth += 1;
                    self.echo_skipped(program, at + 1, end);
                    self.block_depth -= 1;
                    break;
                }
                Err(flow) => {
                    // What the passes before did is kept, and so is what was typed.
                    self.unit_refused &= passes == 0;
                    return self.skip_block(program, at + 1, end, flow);
                }
            }
            if passes > 0 && echo_all {
                self.echo_again(program, at + 1);
            }
            match self.pass(program, blocks, at, end) {
                Flow::Next | Flow::Continue | Flow::Skipped => {}
                Flow::Break => break,
                other => return other,
            }
            passes += 1;
            // Without an end the body is read once.
            if end >= program.statements.len() {
                return Flow::Next;
            }
            if passes >= self.most_passes {
                let error = Diagnostic::error("command/endless-loop", "this loop does not end")
                    .at(call.span, format!("stopped after {passes} passes"))
                    .help("change something in the loop that its condition depends on");
                return self.failed(vec![error]);
            }
        }
        self.close(program, end, -(self.block_depth as i64) - 1);
        Flow::Next
    }

    fn pass(&mut self, program: &Program, blocks: &Blocks, at: usize, end: usize) -> Flow {
        self.block_depth += 1;
        let flow = self.run_range(program, blocks, at + 1, end);
        match flow {
            Flow::Abort | Flow::Return => {}
            Flow::Break | Flow::Continue => self.echo_skipped(program, at + 1, end + 1),
            _ => {
                if let Some(parsed) = program.statements.get(end) {
                    self.echo_now(program, parsed.statement.span);
                }
            }
        }
        self.block_depth -= 1;
        flow
    }

    pub(crate) fn run_for(&mut self, program: &Program, blocks: &Blocks, at: usize) -> Flow {
        let end = blocks.end[at];
        let call = match self.opener(program, at) {
            Ok(call) => call,
            Err(flow) => return self.skip_block(program, at + 1, end, flow),
        };
        let mark = self.database.mark();
        // The loop alone makes and removes its variable: undo within the loop or behind it does neither.
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

    /// Objects outside of `gone` that refer to any of `gone`, in order of creation.
    pub(crate) fn dependents_of(&self, gone: &[ObjectId]) -> Vec<ObjectId> {
        let gone: std::collections::HashSet<ObjectId> = gone.iter().copied().collect();
        let mut found = Vec::new();
        for id in self.database.ids() {
            if gone.contains(&id) {
                continue;
            }
            let refers = self.database.object(id).cells.values().any(|cell| {
                cell.value.objects().iter().any(|o| gone.contains(o))
                    || cell.expressions().iter().any(|e| e.objects().iter().any(|o| gone.contains(o)))
            });
            if refers {
                found.push(id);
            }
        }
        found
    }
}

/// The complaint about an arm of an `if` behind its `else`.
fn behind_else(program: &Program, arm: usize, other: usize) -> Diagnostic {
    let place = |at: usize| match program.command(at) {
        Some(([first, ..], _)) => *first,
        _ => program.statements[at].statement.span,
    };
    let word = program.word(place(arm));
    Diagnostic::error("command/stray-block-word", format!("`{word}` stands behind the `else` of its `if`"))
        .at(place(arm), "never run")
        .label(place(other), "everything that is left is for this arm")
        .help("put the `else` last")
        .adams("Invalid input. Enter an object, qualifier, or action.")
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
