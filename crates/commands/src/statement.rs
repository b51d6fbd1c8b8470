//! One statement: from its words to what it does, with everything taken back if it fails.

use model::{CellKey, ObjectId};
use smallvec::SmallVec;
use syntax::command::{Argument, Item, StatementKind};
use text::{Diagnostic, Span};

use crate::{
    Interpreter, OnError,
    blocks::Control,
    call::Call,
    evaluation,
    interpreter::Flow,
    known, lookup,
    program::Program,
    tree::{Action, Command, Path},
    verbs::warn_outside,
    words::did_you_mean,
};

type Errors = Vec<Diagnostic>;

impl Interpreter {
    /// Runs a statement that opens no block. A failed one leaves the database as it was.
    pub(crate) fn run_statement(&mut self, program: &Program, index: usize, control: Control) -> Flow {
        if self.was_an_answer(program, index) {
            return Flow::Next;
        }
        let mark = self.database.mark();
        let before = self.report.diagnostics.len();
        let mut outcome = self.try_statement(program, index, control);
        if let Err(errors) = &mut outcome
            && let Some(answered) = self.ask(program, index, mark, errors)
        {
            outcome = answered;
        }
        let outcome = outcome.and_then(|flow| self.settle(mark).map(|()| flow));
        self.unit_refused = outcome.is_err() && self.block_depth == 0;
        self.echo_pending(program, index, outcome.as_ref().err());
        match outcome {
            Ok(flow) => {
                let flow = if flow == Flow::Skipped {
                    self.keep(program, index);
                    Flow::Next
                } else {
                    self.report.executed += usize::from(!self.depth.is_unwinding());
                    flow
                };
                self.trace_warnings(before);
                let flow = if flow == Flow::Next { self.run_asked_for().unwrap_or(flow) } else { flow };
                if self.undo_blocks == 0 {
                    self.database.finish_step();
                }
                self.unwound(flow)
            }
            Err(errors) => {
                self.world.take_commands();
                self.database.roll_back(mark);
                self.taken_back();
                self.trace_warnings(before);
                if let Some(path) = self.consequence(program, index, &errors) {
                    self.report.skipped += 1;
                    self.keep(program, index);
                    if let Some((_, arguments)) = program.command(index) {
                        self.remember_unmade(program, &path, arguments);
                    }
                    self.complain(vec![skipped_too(&path, errors)]);
                    return Flow::Next;
                }
                let flow = self.failed(errors);
                self.unwound(flow)
            }
        }
    }

    /// What follows a command that changed the model: expressions that ask which objects there are
    /// are evaluated again. What expressions printed is reported.
    fn settle(&mut self, mark: model::Mark) -> Result<(), Errors> {
        for line in self.world.take_printed() {
            self.report.diagnostics.push(Diagnostic::new(text::Severity::Note, "expression/printed", line));
        }
        if self.database.changed_since(mark) {
            let warnings = evaluation::restructure(&mut self.database).map_err(|e| vec![e])?;
            self.report.diagnostics.extend(warnings);
        }
        Ok(())
    }

    /// Runs the commands that expressions of the last one asked for.
    fn run_asked_for(&mut self) -> Option<Flow> {
        let commands = self.world.take_commands();
        for command in commands {
            let file = self.sources.add("<command of an expression>", command);
            if self.run_source(file) == Flow::Abort {
                return Some(Flow::Abort);
            }
        }
        None
    }

    /// The command that failed, if only because it names what a skipped command would have made.
    fn consequence(&self, program: &Program, index: usize, errors: &[Diagnostic]) -> Option<String> {
        if self.unmade.is_empty() && self.unmade_solids.is_empty() {
            return None;
        }
        let (keywords, arguments) = program.command(index)?;
        let span = program.statements[index].statement.span;
        let path = self.find_command(program, span, keywords, arguments).ok()?.path.to_string();
        // The names of solids read from another program's file stand in that file only.
        let about_shapes = ["geometry attributes", "geometry modify ", "contact create", "contact modify"];
        let may_be_solid = about_shapes.iter().any(|start| path.starts_with(start));
        let follows = errors.iter().all(|e| {
            let Some(name) = e.primary.as_ref().map(|l| program.word(l.span).to_ascii_lowercase()) else {
                return false;
            };
            let below = |owner: &String| name.strip_prefix(owner.as_str()).is_some_and(|rest| rest.starts_with('.'));
            e.code == "name/not-found"
                && (self.was_not_made(&name) || may_be_solid && self.unmade_solids.iter().any(below))
        });
        follows.then_some(path)
    }

    /// Whether a skipped command would have made an object, or what it belongs to.
    fn was_not_made(&self, name: &str) -> bool {
        let parents = name.match_indices('.').map(|(at, _)| &name[..at]);
        self.unmade.contains(name) || parents.into_iter().any(|p| !p.is_empty() && self.unmade.contains(p))
    }

    /// Counts a failed command and decides whether its file goes on.
    pub(crate) fn failed(&mut self, errors: Errors) -> Flow {
        self.report.failed += 1;
        self.complain(errors);
        if self.on_error == OnError::AbortFile { Flow::Abort } else { Flow::Next }
    }

    /// Adds the call trace to diagnostics that were filed without one while a command ran.
    pub(crate) fn trace_warnings(&mut self, from: usize) {
        if self.trace.is_empty() {
            return;
        }
        for diagnostic in self.report.diagnostics.iter_mut().skip(from) {
            crate::depth::add_calls(diagnostic, &self.trace);
        }
    }

    pub(crate) fn try_statement(&mut self, program: &Program, index: usize, control: Control) -> Result<Flow, Errors> {
        let parsed = &program.statements[index];
        let (mut errors, mut warnings): (Errors, Errors) =
            parsed.diagnostics.iter().cloned().partition(Diagnostic::is_error);
        self.report.diagnostics.append(&mut warnings);
        let span = parsed.statement.span;
        let flow = match &parsed.statement.kind {
            StatementKind::Broken => {
                if errors.is_empty() {
                    errors.push(Diagnostic::error("command/not-understood", "this line is no command").at(span, ""));
                }
                return Err(errors);
            }
            StatementKind::Assignment { target, values } => {
                if !errors.is_empty() {
                    return Err(errors);
                }
                return self.assign(program, *target, values);
            }
            StatementKind::Command { keywords, arguments } => match control {
                Control::Break => Flow::Break,
                Control::Continue => Flow::Continue,
                Control::Return => Flow::Return,
                _ => return self.command(program, span, keywords, arguments, errors),
            },
        };
        if errors.is_empty() { Ok(flow) } else { Err(errors) }
    }

    /// Finds what a command's keywords mean.
    pub(crate) fn find_command(
        &self,
        program: &Program,
        span: Span,
        keywords: &[Span],
        arguments: &[Argument],
    ) -> Result<Command, Errors> {
        let words: SmallVec<[&str; 8]> = keywords.iter().map(|k| program.word(*k)).collect();
        let at_word = |at: usize| keywords.get(at).copied().unwrap_or(span);
        match self.tree.find(&words, &self.database) {
            Path::Found(command) => Ok(command),
            Path::Unknown { at, near } => Err(vec![unknown_keyword(words[at], at_word(at), &words[..at], &near)]),
            Path::Ambiguous { at, candidates } => Err(vec![
                Diagnostic::error(
                    "command/ambiguous-abbreviation",
                    format!("`{}` may stand for {}", words[at], candidates.join(", ")),
                )
                .at(at_word(at), "ambiguous")
                .help("write more letters of the one that is meant")
                .adams(format!("'{}' is an ambiguous keyword.", words[at])),
            ]),
            Path::Surplus { at } => {
                let error = Diagnostic::error(
                    "command/unknown-argument",
                    format!("`{}` takes no word `{}`", words[..at].join(" "), words[at]),
                )
                .at(at_word(at), "unexpected")
                .adams(format!("'{}' is not a valid parameter.", words[at]));
                let loop_or_force = at == 1 && words[0].eq_ignore_ascii_case("for");
                let help = "`for` begins a loop; the shortest word for forces is `forc`";
                Err(vec![if loop_or_force { error.fix(help, at_word(0), "forc") } else { error }])
            }
            Path::Incomplete { next } => match arguments.first() {
                Some(argument) => Err(vec![unknown_keyword(program.word(argument.name), argument.name, &words, &next)]),
                None => Err(vec![
                    Diagnostic::error("command/incomplete", format!("`{}` is not complete", words.join(" ")))
                        .at(span, "a keyword is missing")
                        .help(format!("it is followed by {}", next.join(", ")))
                        .adams("Invalid input. Enter an object, qualifier, or action."),
                ]),
            },
        }
    }

    /// Matches the arguments of a command. `Err` where something does not fit.
    pub(crate) fn bind<'p>(
        &mut self,
        program: &'p Program,
        span: Span,
        keywords: &[Span],
        command: &Command,
        arguments: &'p [Argument],
        mut errors: Errors,
    ) -> Result<Call<'p>, Errors> {
        let keyword_span = match (keywords.first(), keywords.last()) {
            (Some(first), Some(last)) => first.to(*last),
            _ => span,
        };
        let (rules, creating): (&[schema::Rule], bool) = match &command.action {
            Action::Create(_, group) => (group.rules, true),
            Action::Set(groups) if groups.len() == 1 => (groups[0].1.rules, false),
            Action::Verb(entry) => (entry.verb.rules, true),
            _ => (&[], false),
        };
        let (call, mut binding) = Call::bind(program, command, keyword_span, span, arguments, rules, creating);
        if !errors.is_empty() {
            // What the parser could not read may be an argument whose kind says more.
            if !self.explain_broken(&call, &mut errors) {
                errors.append(&mut binding);
            }
            return Err(errors);
        }
        if binding.is_empty() {
            return Ok(call);
        }
        if self.on_error == OnError::ContinueCommand {
            self.report.failed += 1;
            self.complain(binding);
            return Ok(call);
        }
        Err(binding)
    }

    /// Says how many values are wanted where a list of numbers could not be read; what else is wrong
    /// from there on follows from it. False where that is not what is wrong.
    fn explain_broken(&mut self, call: &Call, errors: &mut Errors) -> bool {
        let mut explained = false;
        for given in &call.given {
            let field = call.parameters[given.parameter].field;
            if field.count.least > 1
                && let Err(more) = self.read_value(call, &field, given.argument, None)
                && let Some(count) = more.into_iter().find(|e| e.code == "command/wrong-count")
            {
                let from = given.argument.value_span.start;
                errors.retain(|e| e.primary.as_ref().is_some_and(|l| l.span.start < from));
                errors.insert(0, count);
                explained = true;
            }
        }
        explained
    }

    fn command(
        &mut self,
        program: &Program,
        span: Span,
        keywords: &[Span],
        arguments: &[Argument],
        errors: Errors,
    ) -> Result<Flow, Errors> {
        let command = match self.find_command(program, span, keywords, arguments) {
            Ok(command) => command,
            Err(mut more) => {
                more.extend(errors);
                return Err(more);
            }
        };
        if matches!(command.action, Action::Unsupported) {
            if !errors.is_empty() {
                return Err(errors);
            }
            self.not_supported(&command.path, span);
            if command.path.starts_with("file parasolid read") {
                self.solids_not_read(program, arguments);
            }
            self.remember_unmade(program, &command.path, arguments);
            return Ok(Flow::Skipped);
        }
        let call = self.bind(program, span, keywords, &command, arguments, errors)?;
        match &command.action {
            Action::Create(class, group) => self.create_object(class, group, &call).map(|_| Flow::Next),
            Action::Set(groups) => self.modify_objects(groups, &call).map(|()| Flow::Next),
            Action::Settings(class, _) => self.change_settings_object(class, &call).map(|()| Flow::Next),
            Action::Verb(entry) => {
                self.echo_now(program, span);
                let outcome = (entry.run)(self, &call);
                let warnings = self.host.take_warnings();
                if let Some(journal) = &mut self.journal {
                    warnings.iter().for_each(|warning| journal.messages(warning));
                }
                let flow = outcome?;
                self.report.diagnostics.extend(call.unused());
                Ok(flow)
            }
            Action::Macro(id) => {
                self.echo_now(program, span);
                self.call_macro(*id, &call)
            }
            Action::Unsupported => Ok(Flow::Next),
        }
    }

    /// Remembers what a skipped command would have made: it is missing for the commands that follow.
    fn remember_unmade(&mut self, program: &Program, path: &str, arguments: &[Argument]) {
        if path.contains("create") {
            let names = arguments.iter().filter(|a| program.word(a.name).contains("name"));
            self.unmade.extend(names.take(1).map(|a| program.word(a.value_span).to_ascii_lowercase()));
        }
    }

    /// Remembers below which part or model the solids of a file would have been.
    fn solids_not_read(&mut self, program: &Program, arguments: &[Argument]) {
        let owner = arguments.iter().find(|a| {
            let name = program.word(a.name).to_ascii_lowercase();
            ["model_name", "part_name"].iter().any(|full| name.len() >= 3 && full.starts_with(&name))
        });
        let owner = match owner.map(|a| program.word(a.value_span)) {
            Some(typed) => lookup::search_one(&self.database, typed, "any").map(|id| self.database.full_name(id)),
            None => self.database.current("model").map(|id| self.database.full_name(id)),
        };
        self.unmade_solids.extend(owner.map(|name| name.to_ascii_lowercase()));
    }

    /// A command that is known but not executed is named, with what that means: once in a run for
    /// each kind; how many there were of a kind is added when the run is over.
    pub(crate) fn not_supported(&mut self, path: &str, span: Span) {
        self.report.skipped += 1;
        let kind = known::kind(path);
        if let Some((_, count)) = self.skipped_kinds.get_mut(kind) {
            *count += 1;
            return;
        }
        self.skipped_kinds.insert(kind.to_string(), (self.report.diagnostics.len(), 1));
        self.report.diagnostics.push(
            Diagnostic::warning("command/not-supported", format!("`{path}` is not executed by Flexure"))
                .at(span, "skipped")
                .note(known::meaning(path)),
        );
    }

    /// `.object.field = value`.
    fn assign(&mut self, program: &Program, target: Span, values: &[Item]) -> Result<Flow, Errors> {
        let typed = program.word(target);
        let steps = model::split_name(typed.strip_prefix('.').unwrap_or(typed));
        let place = self.assigned_cell(&steps);
        let Some((id, cell)) = place else {
            if steps.first().is_some_and(|s| self.database.children_named(None, s).is_empty()) {
                self.not_supported(&format!("{typed} = ..."), target);
                return Ok(Flow::Skipped);
            }
            return Err(vec![
                Diagnostic::error("name/not-found", format!("`{typed}` is no value of an object"))
                    .at(target, "nothing to assign to")
                    .adams("Invalid input. Enter an object, qualifier, or action."),
            ]);
        };
        let value_span = match (values.first(), values.last()) {
            (Some(a), Some(b)) => a.span.to(b.span),
            _ => target,
        };
        let argument = Argument { name: target, values: values.into(), value_span };
        let call = Call {
            program,
            keywords: target,
            span: target.to(value_span),
            path: typed.into(),
            parameters: std::sync::Arc::new([]),
            given: Vec::new(),
        };
        let field = *self.database.object(id).class.field(cell);
        let draft = self.read_value(&call, &field, &argument, Some(id))?;
        if field.name == "adams_id" {
            self.check_id(id, &draft.value, value_span)?;
        }
        let key = CellKey::new(id, cell);
        self.store(key, draft);
        self.recompute(&[key], target)?;
        match self.database.object(id).class.id {
            "variable" => warn_outside(self, id, target.to(value_span)),
            "macro" => self.register_macro(id),
            _ => {}
        }
        Ok(Flow::Next)
    }

    fn assigned_cell(&self, steps: &[String]) -> Option<(ObjectId, usize)> {
        if let Some(id) = self.database.descend(None, steps, "variable") {
            let class = self.database.object(id).class;
            let held = ["real_value", "integer_value", "string_value", "object_value"];
            let name = held.iter().find(|n| self.database.cell(id, n).is_some())?;
            return Some((id, class.cell_index(name)?));
        }
        let (field, path) = steps.split_last()?;
        let id = self.database.descend(None, path, "any")?;
        let class = self.database.object(id).class;
        let names: Vec<&str> = class.fields().map(|f| f.name).collect();
        match crate::words::match_word(names, field) {
            crate::words::Match::One(i) => Some((id, i)),
            _ => None,
        }
    }
}

/// The warning about a command that needs what a skipped command would have made.
fn skipped_too(path: &str, errors: Errors) -> Diagnostic {
    let reasons: Vec<&str> = errors.iter().map(|e| e.message.as_str()).collect();
    let mut warning =
        Diagnostic::warning("command/skipped-too", format!("`{path}` is skipped: {}", reasons.join("; ")));
    for label in errors.into_iter().filter_map(|e| e.primary) {
        warning = match warning.primary {
            None => warning.at(label.span, "not made, because the command for it is not executed"),
            Some(_) => warning.label(label.span, "not made either"),
        };
    }
    warning.note(known::meaning(path))
}

fn unknown_keyword(word: &str, span: Span, before: &[&str], near: &[String]) -> Diagnostic {
    let message = if before.is_empty() {
        format!("there is no command `{word}`")
    } else {
        format!("`{word}` does not follow `{}`", before.join(" "))
    };
    let error = Diagnostic::error("command/unknown-keyword", message)
        .at(span, "unknown keyword")
        .adams(format!("'{word}' is not a valid keyword. You may have misspelled"))
        .adams("the keyword or you may be missing a continuation character(&)")
        .adams("on the previous line.");
    match did_you_mean(error, near.iter().map(String::as_str), word, span, str::to_string) {
        Err(error) if !before.is_empty() && near.len() <= 30 => {
            error.note(format!("what may follow is {}", near.join(", ")))
        }
        Ok(error) | Err(error) => error,
    }
}
