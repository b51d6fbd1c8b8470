//! A command and its parameters as data, for manuals and other programs. The sentences are those of
//! `help` and `?`, because all of them are read off the same tables.

use schema::{Count, Default, Field, Kind, Limit, Rule};

use crate::{
    Interpreter,
    call::match_parameter,
    help,
    tree::{Action, Command, Parameter, Path, Role},
    words::Match,
};

/// A command with all that its table says.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandReference {
    /// All its keywords.
    pub command: String,
    pub doc: String,
    pub parameters: Vec<ParameterReference>,
    /// Conditions over several parameters of this command.
    pub rules: Vec<Rule>,
}

/// One parameter of a command.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterReference {
    pub name: String,
    pub role: Role,
    /// `real`, `existing marker`, `linear | string | nonlinear`.
    pub kind: String,
    /// The words it may be, where it is one of several.
    pub words: Vec<&'static str>,
    pub count: Count,
    /// Name of the physical dimension.
    pub dimension: Option<&'static str>,
    /// Its unit in the units in force.
    pub unit: String,
    /// What holds if it is not given: a value as it would be typed, or where one comes from.
    pub default: Option<String>,
    /// What a number must be.
    pub limit: Option<String>,
    pub required: bool,
    /// Name of the argument of the solver statement.
    pub keyword: Option<&'static str>,
    /// The shortest beginning of the name that stands for it.
    pub shortest: String,
    pub doc: &'static str,
}

impl Interpreter {
    /// What the table of a command says; `None` where there is no such command.
    pub fn reference(&self, words: &[&str]) -> Option<CommandReference> {
        let Path::Found(command) = self.commands().find(words, &self.database) else { return None };
        Some(CommandReference {
            command: command.path.to_string(),
            doc: help::doc_of(&command, &self.database),
            parameters: command.parameters.iter().map(|p| self.parameter_reference(&command, p)).collect(),
            rules: rules_of(&command),
        })
    }

    fn parameter_reference(&self, command: &Command, parameter: &Parameter) -> ParameterReference {
        let field = &parameter.field;
        ParameterReference {
            name: parameter.name.to_string(),
            role: parameter.role,
            kind: help::what_of(field),
            words: match field.kind {
                Kind::Choice(words) => words.to_vec(),
                Kind::Boolean(yes, no) => vec![yes, no],
                _ => Vec::new(),
            },
            count: field.count,
            dimension: field.dimension.name().filter(|_| field.dimension != schema::Dimension::NONE),
            unit: self.database.units().label(field.dimension),
            default: default_of(command, parameter),
            limit: (field.limit != Limit::None).then(|| field.limit.to_string()),
            required: self.is_required(command, parameter),
            keyword: field.keyword,
            shortest: shortest(&command.parameters, &parameter.name),
            doc: help::doc_of_parameter(command, parameter),
        }
    }
}

/// The default without regard to the objects of the session; values hold only where something is made.
fn default_of(command: &Command, parameter: &Parameter) -> Option<String> {
    let field: &Field = &parameter.field;
    let creating = matches!(command.action, Action::Create(..) | Action::Verb(_));
    match (field.default, parameter.role) {
        (_, Role::Object) if creating => Some("generated".into()),
        (_, Role::Object) | (Default::Current, _) => Some("the current one".into()),
        (Default::CoordinateSystem, _) => Some("the default coordinate system".into()),
        (Default::Generated, _) => Some("generated".into()),
        (Default::Formula(_), _) if creating => Some("computed from the others".into()),
        _ if creating => help::default_text(field),
        _ => None,
    }
}

/// Conditions that can hold between the parameters of this command: those that ask for something
/// hold where an object is made.
fn rules_of(command: &Command) -> Vec<Rule> {
    let (rules, creating) = match &command.action {
        Action::Create(_, group) => (group.rules, true),
        Action::Verb(entry) => (entry.verb.rules, true),
        Action::Settings(_, group) => (group.rules, false),
        Action::Set(groups) => (groups.first().map_or(&[][..], |(_, group)| group.rules), false),
        Action::Macro(_) | Action::Unsupported => (&[][..], false),
    };
    let known = |name: &str| command.parameters.iter().any(|p| &*p.name == name);
    let holds = |rule: &&Rule| match rule {
        Rule::AtMostOne(names) => names.iter().filter(|n| known(n)).count() > 1,
        Rule::OneOf(_) | Rule::AtLeastOne(_) => creating,
    };
    rules.iter().filter(holds).copied().collect()
}

fn shortest(parameters: &[Parameter], name: &str) -> String {
    let stands_for_it = |typed: &str| match match_parameter(parameters, typed) {
        Match::One(index) => parameters.get(index).is_some_and(|p| &*p.name == name),
        _ => false,
    };
    let ends = name.char_indices().map(|(at, c)| at + c.len_utf8());
    ends.map(|end| &name[..end]).find(|typed| stands_for_it(typed)).unwrap_or(name).to_string()
}
