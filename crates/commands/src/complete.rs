//! What may follow a half-typed command: keywords, parameters, words, objects, functions, files. All
//! of it is read from the tables of commands and from the database; nothing here names an element.

use indexmap::IndexMap;
use model::{Database, ObjectId, Value, quoted};
use rustc_hash::FxBuildHasher;
use schema::{Field, Kind, Names, Rule};

use crate::{
    Interpreter,
    call::match_parameter,
    complete_situation::{Place, Situation, given_values, situation},
    help,
    tree::{Action, Command, Parameter, Path, Role},
    words::{Match, match_word},
};

/// What a word at the cursor may become.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completion {
    /// Where the half-typed word begins; it is replaced up to the cursor.
    pub start: usize,
    /// What stands over the list: the command, or the parameter with its type, unit and default.
    pub title: String,
    pub candidates: Vec<Candidate>,
}

/// One thing that may stand at the cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Candidate {
    /// What is typed for it, with what surely follows (` = ` behind a parameter).
    pub text: String,
    /// Type, unit, default and a line of explanation.
    pub note: String,
}

/// Names shown of one kind before they are shown by their first steps.
const MANY: usize = 200;

impl Interpreter {
    /// What may stand at the end of a text, which holds everything typed since the last command that
    /// was executed.
    pub fn complete(&self, text: &str) -> Completion {
        match situation(text) {
            Situation::Nowhere => Completion { start: text.len(), ..Completion::default() },
            Situation::Word(place) => self.complete_word(text, &place),
            Situation::Value { place, parameter, quoted } => self.complete_value(text, &place, &parameter, quoted),
            Situation::Expression(place) => {
                let prefix = typed(text, place.start).to_string();
                Completion {
                    start: place.start,
                    title: "inside an expression: functions, and objects".into(),
                    candidates: self.in_expression(&prefix),
                }
            }
        }
    }

    /// Whether `?` at the end of a text asks what may follow; elsewhere it is a character like others.
    pub fn asks_for_help(&self, text: &str) -> bool {
        match situation(text) {
            Situation::Word(_) => true,
            Situation::Value { quoted: true, .. } | Situation::Nowhere | Situation::Expression(_) => false,
            Situation::Value { place, parameter, .. } => {
                place.start == text.len() || !self.may_hold_a_question_mark(&place, &parameter)
            }
        }
    }

    /// Whether `?` can be part of a value that is begun: of a text, or of a pattern that stands for
    /// several objects.
    fn may_hold_a_question_mark(&self, place: &Place, parameter: &str) -> bool {
        let words: Vec<&str> = place.keywords.iter().map(String::as_str).collect();
        let Path::Found(command) = self.tree.find(&words, &self.database) else { return true };
        let Match::One(index) = match_parameter(&command.parameters, parameter) else { return true };
        let field = &command.parameters[index].field;
        match field.kind {
            Kind::Object(Names::Old, _) => field.count.most > 1,
            Kind::Boolean(..) | Kind::Choice(_) | Kind::Real | Kind::Integer => {
                matches!(command.action, Action::Macro(_))
            }
            _ => true,
        }
    }

    /// The lines that `?` shows at the end of a text.
    pub fn question(&self, text: &str) -> Vec<String> {
        let found = self.complete(text);
        let mut lines = vec![found.title];
        if found.candidates.is_empty() {
            lines.push("  nothing to choose from".into());
        }
        let (known, executed): (Vec<&Candidate>, Vec<&Candidate>) =
            found.candidates.iter().partition(|c| c.note.starts_with(help::NOT_EXECUTED));
        let word = |c: &'_ Candidate| c.text.trim_end_matches([' ', '=']).to_string();
        let rows: Vec<(String, &str)> = executed.iter().take(MANY).map(|c| (word(c), c.note.as_str())).collect();
        lines.extend(help::table(rows.iter().map(|(text, note)| (text.as_str(), *note))));
        if executed.len() > MANY {
            lines.push(format!("  ... and {} more", executed.len() - MANY));
        }
        if !known.is_empty() {
            let words: Vec<String> = known.into_iter().map(word).collect();
            lines.push(format!("  understood, not executed: {}", words.join(", ")));
        }
        lines
    }

    fn complete_word(&self, text: &str, place: &Place) -> Completion {
        let prefix = typed(text, place.start);
        let words: Vec<&str> = place.keywords.iter().map(String::as_str).collect();
        let mut candidates = Vec::new();
        if prefix.starts_with('.') && words.is_empty() && place.given.is_empty() {
            candidates = objects(&self.database, "any", prefix);
            return Completion { start: place.start, title: "a value to assign to".into(), candidates };
        }
        let mut path = String::new();
        if place.given.is_empty() {
            path = self.full_path(&words);
            for word in self.tree.next_words(&words, &self.database).into_iter().filter(|w| begins(w, prefix)) {
                let note = self.note_of_path(&format!("{path} {word}"));
                candidates.push(Candidate { text: format!("{word} "), note });
            }
            // What is executed comes first.
            candidates.sort_by_key(|c| c.note.starts_with(help::NOT_EXECUTED));
        }
        let mut title = if words.is_empty() { "commands".to_string() } else { format!("behind `{path}`") };
        if let Path::Found(command) = self.tree.find(&words, &self.database)
            && !words.is_empty()
        {
            title = format!("{}: {}", command.path, help::doc_of(&command, &self.database));
            candidates.extend(self.parameters_left(&command, place, prefix));
        }
        Completion { start: place.start, title, candidates }
    }

    /// Keywords spelled out.
    fn full_path(&self, words: &[&str]) -> String {
        let mut full: Vec<String> = Vec::new();
        for word in words {
            let before: Vec<&str> = full.iter().map(String::as_str).collect();
            let next = self.tree.next_words(&before, &self.database);
            match match_word(next.iter().map(String::as_str), word) {
                Match::One(i) => full.push(next[i].clone()),
                _ => full.push((*word).to_string()),
            }
        }
        full.join(" ")
    }

    /// What a path leads to, in a line.
    pub(crate) fn note_of_path(&self, path: &str) -> String {
        let words: Vec<&str> = path.split_whitespace().collect();
        match self.tree.find(&words, &self.database) {
            Path::Found(command) => help::doc_of(&command, &self.database),
            Path::Incomplete { next } => {
                let more = if next.len() > 5 { ", ..." } else { "" };
                format!("{}{more}", next[..next.len().min(5)].join(", "))
            }
            _ => String::new(),
        }
    }

    /// Parameters that may still be given.
    fn parameters_left(&self, command: &Command, place: &Place, prefix: &str) -> Vec<Candidate> {
        let parameters = &command.parameters;
        let given: Vec<&str> = place
            .given
            .iter()
            .filter_map(|typed| match match_parameter(parameters, typed) {
                Match::One(i) => Some(&*parameters[i].name),
                _ => None,
            })
            .collect();
        let excluded = excluded(command, &given);
        let left = parameters
            .iter()
            .filter(|p| begins(&p.name, prefix) && !given.contains(&&*p.name) && !excluded.contains(&&*p.name));
        let mut left: Vec<&Parameter> = left.collect();
        // What must be given comes first.
        left.sort_by_key(|p| !self.is_required(command, p));
        left.iter().map(|p| Candidate { text: format!("{} = ", p.name), note: self.describe(command, p) }).collect()
    }

    pub(crate) fn is_required(&self, command: &Command, parameter: &Parameter) -> bool {
        match command.action {
            Action::Create(..) | Action::Verb(_) => parameter.field.required,
            Action::Macro(id) => self.macros.parameter(id, &parameter.name).is_some_and(|p| p.required),
            _ => false,
        }
    }

    /// Type, unit, default, whether it is required, and what it is.
    pub(crate) fn describe(&self, command: &Command, parameter: &Parameter) -> String {
        let mut parts = Vec::new();
        if let Action::Macro(id) = command.action
            && let Some(formal) = self.macros.parameter(id, &parameter.name)
        {
            parts.push(formal.kind.to_string());
            parts.extend(formal.default.map(|d| format!("default {d}")));
        } else {
            parts.push(help::kind_of(&parameter.field, &self.database));
            let creating = matches!(command.action, Action::Create(..) | Action::Verb(_));
            let default = help::default_of(&parameter.field, creating, &self.database);
            let changing = matches!(command.action, Action::Set(_)) && parameter.role != Role::Object;
            let unchanged = changing.then(|| "unchanged if not given".to_string());
            parts.extend(default.or(unchanged));
        }
        if self.is_required(command, parameter) {
            parts.push("required".into());
        }
        let doc = help::doc_of_parameter(command, parameter);
        if doc.is_empty() { parts.join(", ") } else { format!("{}: {doc}", parts.join(", ")) }
    }

    // ---- values ----

    fn complete_value(&self, text: &str, place: &Place, parameter: &str, in_text: bool) -> Completion {
        let nothing = Completion { start: place.start, ..Completion::default() };
        let words: Vec<&str> = place.keywords.iter().map(String::as_str).collect();
        let Path::Found(command) = self.tree.find(&words, &self.database) else { return nothing };
        let Match::One(index) = match_parameter(&command.parameters, parameter) else {
            return Completion { title: format!("`{}` has no parameter `{parameter}`", command.path), ..nothing };
        };
        let found = &command.parameters[index];
        let prefix = typed(text, place.start);
        let candidates = match command.action {
            Action::Macro(id) => self.macro_values(id, &found.name, prefix, in_text),
            Action::Set(_) => {
                let present = self.present(&command, text, found);
                let title = format!("{}: {}", found.name, self.describe(&command, found));
                let now = present.as_ref().map_or(String::new(), |value| format!(" (now {value})"));
                let candidates = self.values_of(&found.field, prefix, in_text, (present, "as it is"));
                return Completion { start: place.start, title: format!("{title}{now}"), candidates };
            }
            _ => self.values_of(&found.field, prefix, in_text, (help::default_text(&found.field), "default")),
        };
        let title = format!("{}: {}", found.name, self.describe(&command, found));
        Completion { start: place.start, title, candidates }
    }

    /// The present value of a parameter of the object that a command changes, as it would be typed.
    fn present(&self, command: &Command, text: &str, parameter: &Parameter) -> Option<String> {
        let object = command.parameters.iter().find(|p| p.role == Role::Object)?;
        let Kind::Object(_, wanted) = object.field.kind else { return None };
        let given = given_values(text).into_iter().find(|(typed, _)| {
            matches!(match_parameter(&command.parameters, typed), Match::One(i) if command.parameters[i].name == object.name)
        });
        let database = &self.database;
        let id = match given {
            Some((_, name)) => crate::lookup::search_one(database, &name, wanted)?,
            None => database.current(wanted)?,
        };
        let field = &parameter.field;
        match database.value(id, field.name)? {
            Value::Number(_) | Value::Array(_) if matches!(field.kind, Kind::Real) => {
                let numbers = database.numbers(id, field.name)?;
                let shown = |x: &f64| crate::number::real(crate::number::ten_decimals(*x));
                Some(numbers.iter().map(shown).collect::<Vec<_>>().join(", "))
            }
            Value::Integer(i) => Some(i.to_string()),
            Value::Text(word) if matches!(field.kind, Kind::Choice(_)) => Some(word.clone()),
            Value::Flag(flag) => match field.kind {
                Kind::Boolean(yes, no) => Some(if *flag { yes } else { no }.to_string()),
                _ => None,
            },
            Value::Object(other) if database.get(*other).is_some() => Some(database.full_name(*other)),
            _ => None,
        }
    }

    /// Values that may be typed; `usual` is one that is there already or would be taken, with the word
    /// for it.
    fn values_of(
        &self,
        field: &Field,
        prefix: &str,
        in_text: bool,
        (usual, word): (Option<String>, &str),
    ) -> Vec<Candidate> {
        match field.kind {
            Kind::File => self.files(prefix, in_text),
            _ if in_text => Vec::new(),
            Kind::Object(Names::Old, wanted) => objects(&self.database, wanted, prefix),
            Kind::Object(Names::OldOrNew, wanted) => {
                let mut found = self.new_names(wanted, prefix);
                found.extend(objects(&self.database, wanted, prefix));
                found
            }
            Kind::Object(Names::New, wanted) => self.new_names(wanted, prefix),
            Kind::Boolean(yes, no) => words([yes, no], prefix, (usual.as_deref(), word)),
            Kind::Choice(choices) => words(choices.iter().copied(), prefix, (usual.as_deref(), word)),
            _ => {
                let usual = usual.filter(|d| begins(d, prefix));
                usual.map(|text| Candidate { text, note: word.into() }).into_iter().collect()
            }
        }
    }

    fn macro_values(&self, id: ObjectId, name: &str, prefix: &str, in_text: bool) -> Vec<Candidate> {
        let Some(formal) = self.macros.parameter(id, name) else { return Vec::new() };
        let (class, inner) = match formal.kind.split_once('(') {
            Some((class, inner)) => (class, inner.trim_end_matches(')')),
            None => (formal.kind, ""),
        };
        if class == "file" {
            return self.files(prefix, in_text);
        }
        if in_text {
            return Vec::new();
        }
        let mut found = match (class, class.strip_prefix("new_")) {
            ("list", _) => words(inner.split(',').map(str::trim), prefix, (None, "")),
            (_, Some(new)) => self.new_names(new, prefix),
            _ if self.registry.classes.iter().any(|c| c.is(class)) => objects(&self.database, class, prefix),
            _ => Vec::new(),
        };
        if let Some(default) = formal.default.filter(|d| !d.is_empty() && begins(d, prefix))
            && !found.iter().any(|c| c.text == default)
        {
            found.insert(0, Candidate { text: default.to_string(), note: "default".into() });
        }
        found
    }

    /// The name that would be generated, and the objects a new one may be put below.
    fn new_names(&self, wanted: &str, prefix: &str) -> Vec<Candidate> {
        let Some(class) = self.registry.class(wanted) else { return Vec::new() };
        let database = &self.database;
        let mut found = Vec::new();
        if let Some(parent) = crate::lookup::default_parent(database, class) {
            let name = self.next_name(class, Some(parent));
            let full = format!("{}.{name}", database.full_name(parent));
            if begins(&full, prefix) {
                found.push(Candidate { text: full, note: "the next free name".into() });
            }
        }
        if prefix.starts_with('.') {
            for wanted in class.parents {
                let below = objects(database, wanted, prefix).into_iter();
                found.extend(below.map(|c| Candidate { text: format!("{}.", c.text.trim_end_matches('.')), ..c }));
            }
        }
        found
    }

    fn files(&self, prefix: &str, in_text: bool) -> Vec<Candidate> {
        let (folder, name) = match prefix.rfind(['/', '\\']) {
            Some(at) => prefix.split_at(at + 1),
            None => ("", prefix),
        };
        let place = self.host.resolve(if folder.is_empty() { "." } else { folder });
        let Ok(entries) = std::fs::read_dir(place) else { return Vec::new() };
        let mut found: Vec<Candidate> = Vec::new();
        for entry in entries.flatten() {
            let Ok(entry_name) = entry.file_name().into_string() else { continue };
            if !entry_name.starts_with(name) || entry_name.starts_with('.') && !name.starts_with('.') {
                continue;
            }
            let is_folder = entry.path().is_dir();
            let open = if in_text { "" } else { "\"" };
            let close = if is_folder { "/" } else { "\"" };
            let note = if is_folder { "folder" } else { "file" };
            found.push(Candidate { text: format!("{open}{folder}{entry_name}{close}"), note: note.into() });
        }
        found.sort_by(|a, b| a.text.cmp(&b.text));
        found
    }

    fn in_expression(&self, prefix: &str) -> Vec<Candidate> {
        let mut found = Vec::new();
        if !prefix.starts_with('.') {
            for function in expressions::functions().filter(|f| begins(f.name, prefix)) {
                let note = format!("{}({}): {}", function.name, function.arguments, function.doc);
                found.push(Candidate { text: format!("{}(", function.name), note });
            }
            found.sort_by(|a, b| a.text.cmp(&b.text));
        }
        let wanted = if prefix.is_empty() { "variable" } else { "any" };
        found.extend(objects(&self.database, wanted, prefix));
        found
    }
}

fn typed(text: &str, start: usize) -> &str {
    text.get(start..).unwrap_or("")
}

fn begins(word: &str, prefix: &str) -> bool {
    word.len() >= prefix.len() && word.as_bytes()[..prefix.len()].eq_ignore_ascii_case(prefix.as_bytes())
}

fn words<'a>(
    choices: impl IntoIterator<Item = &'a str>,
    prefix: &str,
    (usual, said): (Option<&str>, &str),
) -> Vec<Candidate> {
    let note = |word: &str| if usual == Some(word) { said.to_string() } else { String::new() };
    let fitting = choices.into_iter().filter(|w| begins(w, prefix));
    fitting.map(|w| Candidate { text: w.to_string(), note: note(w) }).collect()
}

/// Parameters that those given leave no room for.
fn excluded<'c>(command: &'c Command, given: &[&str]) -> Vec<&'c str> {
    let rules: &[Rule] = match &command.action {
        Action::Create(_, group) => group.rules,
        Action::Set(groups) if groups.len() == 1 => groups[0].1.rules,
        Action::Verb(entry) => entry.verb.rules,
        _ => &[],
    };
    let mut found = Vec::new();
    for rule in rules {
        match rule {
            Rule::AtMostOne(names) if names.iter().any(|n| given.contains(n)) => found.extend(*names),
            Rule::OneOf(sets) => {
                let fits = |set: &&&[&str]| set.iter().any(|n| given.contains(n));
                let open: Vec<&str> = sets.iter().filter(fits).flat_map(|s| s.iter().copied()).collect();
                if !open.is_empty() {
                    found.extend(sets.iter().flat_map(|s| s.iter().copied()).filter(|n| !open.contains(n)));
                }
            }
            _ => {}
        }
    }
    found
}

/// Objects of a class or family by names that begin as typed: the current one first, then in order of
/// creation; short where a short name is enough, in full where the typed name is.
fn objects(database: &Database, wanted: &str, prefix: &str) -> Vec<Candidate> {
    let model = database.current("model");
    let current = database.current(wanted);
    let fitting = || database.ids().filter(|id| database.object(*id).class.is(wanted));
    let note = |id: ObjectId| {
        let word = database.object(id).class.word;
        if current == Some(id) { format!("{word}, the current one") } else { word.to_string() }
    };
    let mut found: Vec<(ObjectId, String)> = Vec::new();
    if prefix.is_empty() || !prefix.contains('.') {
        let fits = |id: &&ObjectId| database.object(**id).class.is(wanted);
        for id in fitting().filter(|id| begins(&database.object(*id).name, prefix)) {
            let object = database.object(id);
            let unique = database.named(&object.name).iter().filter(fits).nth(1).is_none();
            let own = model.is_some() && database.model_of(id) == model && object.class.id != "model";
            found.push((id, if unique && own { quoted(&object.name) } else { database.full_name(id) }));
        }
    } else {
        // A path that does not begin at the root is searched below the current model.
        let root = if prefix.starts_with('.') {
            String::new()
        } else {
            model.map_or(String::new(), |m| format!("{}.", database.full_name(m)))
        };
        let whole = format!("{root}{prefix}");
        let named = fitting().map(|id| (id, database.full_name(id))).filter(|(_, name)| begins(name, &whole));
        found.extend(named.map(|(id, name)| (id, name[root.len()..].to_string())));
    }
    if let Some(at) = found.iter().position(|(id, _)| current == Some(*id)) {
        let first = found.remove(at);
        found.insert(0, first);
    }
    if found.len() > MANY && prefix.starts_with('.') {
        return first_steps(database, &found, prefix.len());
    }
    found.into_iter().map(|(id, text)| Candidate { text, note: note(id) }).collect()
}

/// The next step of very many names, each once, with a dot where names go on.
fn first_steps(database: &Database, found: &[(ObjectId, String)], typed: usize) -> Vec<Candidate> {
    let mut steps: IndexMap<&str, (ObjectId, usize), FxBuildHasher> = IndexMap::default();
    for (id, name) in found {
        let step = name[typed..].find('.').map_or(name.as_str(), |dot| &name[..=typed + dot]);
        steps.entry(step).or_insert((*id, 0)).1 += 1;
    }
    let note = |id: ObjectId, count: usize| {
        if count > 1 { format!("{count} objects") } else { database.object(id).class.word.to_string() }
    };
    steps.into_iter().map(|(text, (id, count))| Candidate { text: text.to_string(), note: note(id, count) }).collect()
}
