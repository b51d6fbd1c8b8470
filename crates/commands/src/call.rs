//! One command with its arguments matched to parameters, not yet executed.

use std::{cell::Cell, sync::Arc};

use schema::{Field, Kind, Rule};
use syntax::command::{Argument, ItemKind};
use text::{Diagnostic, Span};

use crate::{
    known,
    program::Program,
    tree::{Command, Parameter, Role},
    words::{Match, did_you_mean, match_word},
};

/// An argument with the parameter it is for.
#[derive(Clone, Debug)]
pub struct Given<'p> {
    pub parameter: usize,
    pub argument: &'p Argument,
    /// Whether anything has asked for it: what nothing asks for has no effect, and that is said.
    used: Cell<bool>,
}

/// A command ready to be executed.
#[derive(Debug)]
pub struct Call<'p> {
    pub program: &'p Program,
    /// The keywords.
    pub keywords: Span,
    /// The whole statement.
    pub span: Span,
    pub path: Arc<str>,
    pub parameters: Arc<[Parameter]>,
    pub given: Vec<Given<'p>>,
}

impl<'p> Call<'p> {
    /// Matches arguments to the parameters of a command. What does not fit is reported and left out.
    pub fn bind(
        program: &'p Program,
        command: &Command,
        keywords: Span,
        span: Span,
        arguments: &'p [Argument],
        rules: &[Rule],
        creating: bool,
    ) -> (Call<'p>, Vec<Diagnostic>) {
        let mut errors = Vec::new();
        let mut given: Vec<Given<'p>> = Vec::with_capacity(arguments.len());
        for argument in arguments {
            let typed = program.word(argument.name);
            match match_parameter(&command.parameters, typed) {
                Match::One(parameter) => {
                    if let Some(first) = given.iter().find(|g| g.parameter == parameter) {
                        let name = &command.parameters[parameter].name;
                        errors.push(
                            Diagnostic::error("command/repeated-argument", format!("`{name}` is given twice"))
                                .at(argument.name, "given again here")
                                .label(first.argument.name, "given here first")
                                .help("keep one of the two")
                                .adams(format!("'{typed}' is not a valid parameter.")),
                        );
                    } else {
                        given.push(Given { parameter, argument, used: Cell::new(false) });
                    }
                }
                Match::Many(found) => {
                    let names: Vec<&str> = found.iter().map(|i| &*command.parameters[*i].name).collect();
                    errors.push(
                        Diagnostic::error(
                            "command/ambiguous-abbreviation",
                            format!("`{typed}` may stand for {}", names.join(", ")),
                        )
                        .at(argument.name, "ambiguous")
                        .help("write more letters of the one that is meant")
                        .adams(format!("'{typed}' is an ambiguous parameter.")),
                    );
                }
                Match::None => errors.push(unknown_argument(&command.path, &command.parameters, typed, argument.name)),
            }
        }
        let call =
            Call { program, keywords, span, path: command.path.clone(), parameters: command.parameters.clone(), given };
        for rule in rules {
            call.check_rule(rule, creating, &mut errors);
        }
        (call, errors)
    }

    fn check_rule(&self, rule: &Rule, creating: bool, errors: &mut Vec<Diagnostic>) {
        match rule {
            Rule::AtMostOne(names) => {
                let found: Vec<&Given> = names.iter().filter_map(|n| self.argument_of(n)).collect();
                if let [first, second, ..] = found.as_slice() {
                    errors.push(self.conflict(first, second));
                }
            }
            Rule::AtLeastOne(names) => {
                if creating && !names.iter().any(|n| self.argument_of(n).is_some() || !self.takes(n)) {
                    errors.push(self.missing(names));
                }
            }
            Rule::OneOf(sets) => {
                let started: Vec<&&[&str]> =
                    sets.iter().filter(|s| s.iter().any(|n| self.argument_of(n).is_some())).collect();
                if let [a, b, ..] = started.as_slice() {
                    let first = a.iter().find_map(|n| self.argument_of(n));
                    let second = b.iter().find_map(|n| self.argument_of(n));
                    if let (Some(first), Some(second)) = (first, second) {
                        errors.push(self.conflict(first, second));
                    }
                } else if creating {
                    let wanted = started.first().map_or(sets.first(), |s| Some(s));
                    let Some(wanted) = wanted else { return };
                    for name in wanted.iter().filter(|n| self.argument_of(n).is_none()) {
                        errors.push(self.missing(&[name]));
                    }
                }
            }
        }
    }

    fn conflict(&self, first: &Given, second: &Given) -> Diagnostic {
        let name = |g: &Given| self.parameters[g.parameter].name.clone();
        let (a, b) = (name(first), name(second));
        Diagnostic::error("command/conflicting-arguments", format!("`{a}` and `{b}` cannot be given together"))
            .at(second.argument.name, format!("excludes `{a}`"))
            .label(first.argument.name, "already given here")
            .help(format!("remove `{a}` or `{b}`"))
            .adams(format!("'{}' is not a valid parameter.", self.program.word(second.argument.name)))
    }

    /// The complaint that none of these parameters is given.
    pub fn missing(&self, names: &[&str]) -> Diagnostic {
        let list = names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>().join(" or ");
        let mut error = Diagnostic::error("command/missing-argument", format!("`{}` needs {list}", self.path))
            .at(self.keywords, "not complete")
            .adams(format!("Enter {} (required)", names[0]));
        if let Some(parameter) = self.parameters.iter().find(|p| &*p.name == names[0]) {
            if let Kind::Object(..) = parameter.field.kind {
                error = error.adams("Invalid input. Enter '.' or an entity name.");
            }
            if !parameter.field.doc.is_empty() {
                error = error.note(format!("`{}`: {}", parameter.name, parameter.field.doc));
            }
        }
        error
    }

    fn takes(&self, name: &str) -> bool {
        self.parameters.iter().any(|p| &*p.name == name)
    }

    fn argument_of(&self, name: &str) -> Option<&Given<'p>> {
        self.given.iter().find(|g| &*self.parameters[g.parameter].name == name)
    }

    /// The argument of a parameter, by the parameter's full name.
    pub fn argument(&self, name: &str) -> Option<&'p Argument> {
        let given = self.argument_of(name)?;
        given.used.set(true);
        Some(given.argument)
    }

    /// Every argument with its parameter, for commands that go through all of them.
    pub fn all(&self) -> impl Iterator<Item = (&Parameter, &'p Argument)> {
        self.given.iter().map(|g| {
            g.used.set(true);
            (&self.parameters[g.parameter], g.argument)
        })
    }

    /// The arguments that name objects.
    pub fn objects(&self) -> impl Iterator<Item = (&Parameter, &'p Argument)> {
        let given = self.given.iter().filter(|g| matches!(self.parameters[g.parameter].field.kind, Kind::Object(..)));
        given.map(|g| {
            g.used.set(true);
            (&self.parameters[g.parameter], g.argument)
        })
    }

    /// A warning for each argument that nothing has asked for.
    pub fn unused(&self) -> Vec<Diagnostic> {
        let unused = self.given.iter().filter(|g| !g.used.get());
        let warning = |g: &Given| {
            let name = &self.parameters[g.parameter].name;
            Diagnostic::warning("command/no-effect", format!("`{name}` of `{}` has no effect in Flexure", self.path))
                .at(g.argument.name, "not used")
                .note(known::meaning(&self.path))
        };
        unused.map(warning).collect()
    }

    /// The argument that names the object, if given, with its parameter.
    pub fn object_argument(&self) -> Option<(&Parameter, &'p Argument)> {
        self.with_role(Role::Object)
    }

    pub fn with_role(&self, role: Role) -> Option<(&Parameter, &'p Argument)> {
        self.given
            .iter()
            .find(|g| self.parameters[g.parameter].role == role)
            .map(|g| (&self.parameters[g.parameter], g.argument))
    }

    /// The field of a parameter.
    pub fn field(&self, name: &str) -> Option<&Field> {
        self.parameters.iter().find(|p| &*p.name == name).map(|p| &p.field)
    }

    /// The single word or text of an argument as typed, quotes resolved.
    pub fn plain_text(&self, argument: &Argument) -> Option<String> {
        let [item] = argument.values.as_slice() else { return None };
        match &item.kind {
            ItemKind::Text(text) => Some(text.clone()),
            ItemKind::Word | ItemKind::Number { .. } => Some(self.program.word(item.span).to_string()),
            ItemKind::Expression(_) => None,
        }
    }
}

/// Finds a parameter by an abbreviation.
pub fn match_parameter(parameters: &[Parameter], typed: &str) -> Match {
    match match_word(parameters.iter().map(|p| &*p.name), typed) {
        // The one abbreviation Adams accepts although it is not unique.
        Match::Many(found) if typed.eq_ignore_ascii_case("entity") => found
            .iter()
            .copied()
            .find(|i| &*parameters[*i].name == "entity_name")
            .map_or(Match::Many(found), Match::One),
        other => other,
    }
}

fn unknown_argument(path: &str, parameters: &[Parameter], typed: &str, span: Span) -> Diagnostic {
    let error = Diagnostic::error("command/unknown-argument", format!("`{path}` has no parameter `{typed}`"))
        .at(span, "unknown parameter")
        .adams(format!("'{typed}' is not a valid parameter."));
    match did_you_mean(error, parameters.iter().map(|p| &*p.name), typed, span, str::to_string) {
        Err(error) if parameters.len() <= 30 && !parameters.is_empty() => {
            let names: Vec<&str> = parameters.iter().map(|p| &*p.name).collect();
            error.note(format!("its parameters are {}", names.join(", ")))
        }
        Ok(error) | Err(error) => error,
    }
}
