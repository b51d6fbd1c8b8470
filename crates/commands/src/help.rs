//! Help on commands and parameters, from the tables alone: for the command `help`, for `?` and for
//! completion.

use model::Database;
use schema::{Count, Default, Field, Kind, Names};

use crate::{
    Interpreter, known,
    tree::{Action, Command, Parameter, Path, Role},
    words::nearest,
};

/// How the explanation of a command begins that has no effect here.
pub(crate) const NOT_EXECUTED: &str = "not executed";

impl Interpreter {
    /// The lines of `help` with the words behind it: all commands that are executed, or what a
    /// command does and takes.
    pub fn help_lines(&self, words: &[&str]) -> Vec<String> {
        if words.is_empty() {
            let mut lines = vec![
                "Commands are keywords followed by parameters, each with a value: `marker create marker_name = .m.p.k`."
                    .to_string(),
                "Keywords and parameters may be cut short. `?` at any place lists what may follow there, and so".into(),
                "does Tab; `help` and the words of a command explain it; `undo` and `redo` go back and forth;".into(),
                "`quit` leaves.".into(),
            ];
            let first = self.tree.next_words(&[], &self.database);
            let notes: Vec<String> = first.iter().map(|w| self.note_of_path(w)).collect();
            lines.extend(table(first.iter().map(String::as_str).zip(notes.iter().map(String::as_str))));
            return lines;
        }
        match self.tree.find(words, &self.database) {
            Path::Found(command) => self.help_on_command(&command),
            Path::Incomplete { next } => {
                let path = words.join(" ");
                let notes: Vec<String> = next.iter().map(|w| self.note_of_path(&format!("{path} {w}"))).collect();
                let mut lines = vec![format!("{path} is followed by")];
                lines.extend(table(next.iter().map(String::as_str).zip(notes.iter().map(String::as_str))));
                lines
            }
            Path::Ambiguous { at, candidates } => {
                vec![format!("`{}` may stand for {}", words[at], candidates.join(", "))]
            }
            Path::Surplus { at } => self.help_lines(&words[..at]),
            Path::Unknown { at, near } => {
                let mut line = format!("there is no command `{}`", words[..=at].join(" "));
                if let Some(guess) = nearest(near.iter().map(String::as_str), words[at]) {
                    line = format!("{line}; did you mean `{guess}`?");
                }
                vec![line]
            }
        }
    }

    fn help_on_command(&self, command: &Command) -> Vec<String> {
        let mut lines = vec![format!("{}: {}", command.path, doc_of(command, &self.database))];
        let parameters = &command.parameters;
        let notes: Vec<String> = parameters.iter().map(|p| self.describe(command, p)).collect();
        lines.extend(table(parameters.iter().map(|p| &*p.name).zip(notes.iter().map(String::as_str))));
        let words: Vec<&str> = command.path.split(' ').collect();
        let next = self.tree.next_words(&words, &self.database);
        if !next.is_empty() {
            lines.push(format!("followed by a keyword: {}", next.join(", ")));
        }
        lines
    }
}

/// Two columns.
pub(crate) fn table<'a>(rows: impl Iterator<Item = (&'a str, &'a str)> + Clone) -> Vec<String> {
    let width = rows.clone().map(|(name, _)| name.chars().count()).max().unwrap_or(0).min(40);
    rows.map(|(name, note)| format!("  {name:<width$}  {note}").trim_end().to_string()).collect()
}

/// What a command does, in a line.
pub(crate) fn doc_of(command: &Command, database: &Database) -> String {
    match &command.action {
        Action::Create(_, group) | Action::Settings(_, group) => group.doc.to_string(),
        Action::Set(groups) => match groups.first() {
            Some((_, group)) if groups.len() == 1 => format!("changes {}", group.doc),
            _ => "changes objects of several kinds".to_string(),
        },
        Action::Verb(entry) => entry.verb.doc.to_string(),
        Action::Macro(id) => {
            let living = database.get(*id).is_some();
            let own = if living { database.text(*id, "help_string").filter(|t| !t.is_empty()) } else { None };
            own.map_or_else(|| "a macro".to_string(), ToString::to_string)
        }
        Action::Unsupported => format!("{NOT_EXECUTED}: {}", known::meaning(&command.path)),
    }
}

/// What a parameter is for.
pub(crate) fn doc_of_parameter(command: &Command, parameter: &Parameter) -> &'static str {
    match parameter.role {
        Role::NewName => "new name of the object",
        Role::Object if parameter.field.doc.is_empty() => match command.action {
            Action::Create(..) => "name of the new object",
            _ => "object to change",
        },
        _ => parameter.field.doc,
    }
}

/// The type of a value, without unit and number.
pub(crate) fn what_of(field: &Field) -> String {
    match field.kind {
        Kind::Object(Names::Old, wanted) => format!("existing {}", spaced(wanted)),
        Kind::Object(Names::New, wanted) => format!("new {}", spaced(wanted)),
        Kind::Object(Names::OldOrNew, wanted) => format!("new or existing {}", spaced(wanted)),
        Kind::Integer => "integer".into(),
        Kind::Real => "real".into(),
        Kind::Boolean(yes, no) => format!("{yes} or {no}"),
        Kind::Choice(words) => words.join(" | "),
        Kind::Text => "text".into(),
        Kind::Function => "function".into(),
        Kind::Location => "location".into(),
        Kind::Orientation => "orientation".into(),
        Kind::File => "file".into(),
        Kind::Any => "value".into(),
    }
}

/// The type of a value, with its unit in the units in force.
pub(crate) fn kind_of(field: &Field, database: &Database) -> String {
    let what = what_of(field);
    let unit = database.units().label(field.dimension);
    let unit = if unit.is_empty() { unit } else { format!(", {unit}") };
    let count = match field.count {
        Count { least: 1, most: 1 } => String::new(),
        Count { least, most } if least == most => format!(", {least} values"),
        Count { least: 0 | 1, most: usize::MAX } => ", one or more".into(),
        Count { least, most: usize::MAX } => format!(", {least} or more"),
        Count { least, most } => format!(", {least} to {most} values"),
    };
    format!("{what}{unit}{count}")
}

fn spaced(class: &str) -> String {
    if class == "any" { "object".into() } else { class.replace('_', " ") }
}

/// The default as it would be typed.
pub(crate) fn default_text(field: &Field) -> Option<String> {
    match field.default {
        Default::Number(x) if field.kind == Kind::Integer => Some(format!("{x}")),
        Default::Number(x) => Some(crate::number::real(x)),
        Default::Word(word) if !word.is_empty() => Some(word.to_string()),
        _ => None,
    }
}

/// What holds if a parameter is not given; values hold only where something is made.
pub(crate) fn default_of(field: &Field, creating: bool, database: &Database) -> Option<String> {
    match (field.default, field.kind) {
        (Default::Current, Kind::Object(_, wanted)) => Some(match database.current(wanted) {
            Some(id) => format!("default {}", database.full_name(id)),
            None => "default the current one".into(),
        }),
        (Default::CoordinateSystem, _) => {
            let frame = database.settings().default_frame.filter(|f| database.get(*f).is_some());
            Some(frame.map_or_else(|| "default global".into(), |f| format!("default {}", database.full_name(f))))
        }
        (Default::Generated, _) => Some("default generated".into()),
        (Default::Formula(_), _) if creating => Some("default computed from the others".into()),
        _ if creating => default_text(field).map(|text| format!("default {text}")),
        _ => None,
    }
}
