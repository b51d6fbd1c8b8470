//! Conditions, and loops with a condition.

use model::{ObjectId, Value};
use syntax::command::StatementKind;
use text::Diagnostic;

use crate::{
    Interpreter,
    blocks::{Blocks, Control},
    call::Call,
    interpreter::Flow,
    program::Program,
    tree::Action,
};

impl Interpreter {
    /// Binds the command of a block opener; reports what is wrong with it.
    pub(crate) fn opener<'p>(&mut self, program: &'p Program, index: usize) -> Result<Call<'p>, Flow> {
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

    pub(crate) fn opener_failed(&mut self, program: &Program, index: usize, errors: Vec<Diagnostic>) -> Flow {
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
    pub(crate) fn skip_block(&mut self, program: &Program, from: usize, end: usize, flow: Flow) -> Flow {
        if flow == Flow::Next {
            self.block_depth += 1;
            self.echo_skipped(program, from, (end + 1).min(program.statements.len()));
            self.block_depth -= 1;
        }
        flow
    }

    pub(crate) fn close(&mut self, program: &Program, end: usize, depth: i64) {
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

    pub(crate) fn pass(&mut self, program: &Program, blocks: &Blocks, at: usize, end: usize) -> Flow {
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
