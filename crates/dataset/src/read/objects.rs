//! Objects from statements: first all of them with their names and numbers, for a statement may
//! refer to one that comes later, then what is in them.

use model::{ObjectId, Value};
use schema::Class;
use text::Diagnostic;

use super::{Builder, Entry, entry, statement::Statement};
use crate::statements::{self, Chosen};

/// What is made before what: a marker needs its body, a shape its marker.
const ORDER: [&[&str]; 2] = [&["PART", "POINT_MASS"], &["MARKER"]];

impl<'a> Builder<'a> {
    /// Makes all objects. Comments of statements that make none go to the model.
    pub(super) fn objects(&mut self, all: &'a [Statement], comments: &mut Vec<String>) {
        let mut entries = Vec::with_capacity(all.len());
        self.ground(all, &mut entries);
        let rank = |s: &Statement| ORDER.iter().position(|names| names.contains(&s.name)).unwrap_or(2);
        for pass in 0..=2 {
            for statement in all.iter().filter(|s| rank(s) == pass && !is_ground(s)) {
                entries.extend(self.object_of(statement));
            }
            if pass == 2 {
                // A shape may show a force that comes after it.
                for statement in all.iter().filter(|s| s.name == "GRAPHICS") {
                    entries.extend(self.shape_of(statement));
                }
            }
        }
        for mut entry in entries {
            self.fill(&mut entry);
        }
        for statement in all {
            let setting = statements::is_setting(statement.name);
            if setting && !statement.inactive {
                self.setting(statement);
            }
            // Objects that are switched off have been told from remarks when they were made.
            let no_object = setting || statement.name == "UNITS" || is_ground(statement);
            if no_object && statement.inactive {
                self.report(not_understood(statement));
            }
            if setting || no_object && statement.inactive {
                comments.extend(statement.comments.iter().cloned());
            }
        }
    }

    /// The ground part: every model has one.
    fn ground(&mut self, all: &'a [Statement], entries: &mut Vec<Entry<'a>>) {
        let mut grounds = all.iter().filter(|s| is_ground(s) && !s.inactive);
        let first = grounds.next();
        let Some(class) = self.registry.class("ground") else { return };
        let Ok(ground) = self.database.create(class, Some(self.model), "ground") else { return };
        self.enter(ground);
        if let Some(statement) = first {
            if let Some(name) = &statement.view_name
                && name != "ground"
            {
                let message = format!("the ground part is called `ground`, not `{name}`");
                let note = Diagnostic::new(text::Severity::Note, "dataset/ground-name", message);
                self.report(note.at(statement.head, format!("here it is `{name}`")));
            }
            if let Some(number) = self.number_of(statement) {
                self.register(statement, number, ground);
            }
            entries.push(Entry::new(statement, ground, class));
        } else {
            let missing = Diagnostic::warning("dataset/no-ground", "the dataset has no ground part");
            self.report(missing.help("add `PART/1, GROUND`"));
        }
        for again in grounds {
            let message = format!("{} is a second ground part", entry::name(again));
            self.report(
                Diagnostic::error("dataset/second-ground", message)
                    .at(again.head, "left out")
                    .help("a model has one ground; put its markers on that"),
            );
        }
    }

    /// What names refer to while and after the model is read.
    fn enter(&mut self, ground: ObjectId) {
        self.database.change_settings(|settings| {
            for name in ["part", "body", "marker", "rigid_body"] {
                settings.current.shift_remove(name);
            }
            settings.default_frame = None;
        });
        self.database.make_current(ground);
    }

    fn object_of(&mut self, statement: &'a Statement) -> Option<Entry<'a>> {
        if statement.name == "GRAPHICS" || statement.name == "UNITS" || statements::is_setting(statement.name) {
            return None;
        }
        let class = self.class_of(statement)?;
        let parent = if statement.name == "MARKER" { self.body_of(statement)? } else { self.model };
        self.create(statement, class, parent)
    }

    fn class_of(&mut self, statement: &Statement) -> Option<&'static Class> {
        match statements::class_of(statement) {
            Chosen::Class(id) => {
                let class = self.registry.class(id);
                let fallback = || self.registry.classes.iter().copied().find(|c| c.statement == Some(statement.name));
                class.or_else(fallback)
            }
            // A word that is not known was meant to be the kind; that has been said.
            Chosen::OneOf(_) if statement.arguments.iter().any(|a| !a.known) => {
                self.leave_out(statement);
                None
            }
            Chosen::OneOf(kinds) => {
                self.leave_out(statement);
                let message = format!("{} does not say what kind it is", entry::name(statement));
                let unknown = Diagnostic::error("dataset/no-kind", message).at(statement.head, "left out");
                self.report(unknown.help(format!("it is one of {}", kinds.join(", "))));
                None
            }
            Chosen::Unread(word) => {
                let message = format!("{} is not read: the model has no shape `{word}`", entry::name(statement));
                self.report(Diagnostic::warning("dataset/shape-not-read", message).at(statement.head, "left out"));
                self.leave_out(statement);
                None
            }
        }
    }

    /// The body a marker is on.
    fn body_of(&mut self, statement: &'a Statement) -> Option<ObjectId> {
        for keyword in ["PART", "POINT_MASS"] {
            let Some(argument) = statement.argument(keyword) else { continue };
            let entry = Entry::new(statement, self.model, self.database.object(self.model).class);
            let item = self.only(argument)?;
            return self.object(&entry, argument, item, &[keyword], "body");
        }
        let flexible = ["FLEX_BODY", "FE_PART"].iter().find_map(|keyword| statement.argument(keyword));
        if let Some(argument) = flexible {
            let message = format!("{} is not read: its body is flexible", entry::name(statement));
            let unread = Diagnostic::warning("dataset/statement-not-read", message);
            self.report(unread.at(argument.span, "not read").help("what refers to it is left out too"));
            self.leave_out(statement);
        } else {
            let message = format!("{} belongs to no part", entry::name(statement));
            let missing = Diagnostic::error("dataset/missing-argument", message);
            self.report(missing.at(statement.head, "`PART` is missing").help("add `PART = ` and the number of a part"));
        }
        None
    }

    /// A shape belongs to the body of its marker.
    fn shape_of(&mut self, statement: &'a Statement) -> Option<Entry<'a>> {
        let class = self.class_of(statement)?;
        let argument = ["CM", "CORNER", "EMARKER", "RM", "I"].iter().find_map(|keyword| statement.argument(keyword));
        let Some(argument) = argument else {
            let message = format!("{} has no marker", entry::name(statement));
            let missing = Diagnostic::error("dataset/missing-argument", message);
            self.report(missing.at(statement.head, "the marker it is drawn at is missing"));
            return None;
        };
        let entry = Entry::new(statement, self.model, class);
        let item = self.only(argument)?;
        let Some(marker) = self.object(&entry, argument, item, &["MARKER"], "any") else {
            self.leave_out(statement);
            return None;
        };
        let parent = self.database.object(marker).parent.unwrap_or(self.model);
        self.create(statement, class, parent)
    }

    fn create(&mut self, statement: &'a Statement, class: &'static Class, parent: ObjectId) -> Option<Entry<'a>> {
        if statement.inactive && class.cell_index("active").is_none() {
            self.report(
                not_understood(statement).note(format!("a {} cannot be switched off", class.word.to_lowercase())),
            );
            return None;
        }
        let numbered = class.cell_index("adams_id").is_some();
        let number = if numbered { Some(self.number_of(statement)?) } else { None };
        if let Some(number) = number
            && let Some(other) = self.numbers.get(&(statement.name, number)).copied()
        {
            let name = self.database.full_name(other);
            let message = format!("there are two {}", entry::name(statement));
            let twice = Diagnostic::error("dataset/duplicate-id", message).at(statement.head, "left out");
            self.report(twice.note(format!("the first one is `{name}`")).help("give one of them another number"));
            return None;
        }
        let (parent, name) = self.place(statement, class, parent);
        let id = self.named(statement, class, parent, &name)?;
        if let Some(number) = number {
            self.register(statement, number, id);
        }
        Some(Entry::new(statement, id, class))
    }

    /// What refers to a statement that is not read has been told why.
    fn leave_out(&mut self, statement: &Statement) {
        self.left_out.extend(statement.id.map(|id| (statement.name, id)));
    }

    fn register(&mut self, statement: &Statement, number: i64, id: ObjectId) {
        self.numbers.insert((statement.name, number), id);
        self.store(id, "adams_id", Value::Integer(number));
    }

    /// Parent and name: `group.force` is a child of `group` if there is one, else a name with a dot.
    fn place(&self, statement: &Statement, class: &Class, parent: ObjectId) -> (ObjectId, String) {
        let Some(name) = &statement.view_name else {
            let number = statement.id.map(|n| n.to_string()).unwrap_or_default();
            let prefix = if class.prefix.is_empty() { format!("{}_", class.id) } else { class.prefix.to_string() };
            let name =
                if class.id == "gravity" { statements::GRAVITY.to_string() } else { format!("{prefix}{number}") };
            return (parent, name);
        };
        let name = name.replace('"', "_");
        if let Some((above, last)) = name.rsplit_once('.')
            && !last.is_empty()
            && let Some(above) = self.database.child(Some(parent), above, "any")
        {
            return (above, last.to_string());
        }
        (parent, name)
    }

    /// Creates an object; a name that is taken gets a number.
    fn named(
        &mut self,
        statement: &Statement,
        class: &'static Class,
        parent: ObjectId,
        name: &str,
    ) -> Option<ObjectId> {
        if let Ok(id) = self.database.create(class, Some(parent), name) {
            return Some(id);
        }
        let key = (parent, name.to_ascii_lowercase());
        for _ in 0..1000 {
            let count = self.taken.entry(key.clone()).or_insert(1);
            *count += 1;
            let other = format!("{name}_{count}");
            if let Ok(id) = self.database.create(class, Some(parent), &other) {
                let message = format!("`{name}` names two objects: {} is `{other}` here", entry::name(statement));
                let twice = Diagnostic::warning("dataset/name-taken", message);
                self.report(twice.at(statement.head, "renamed").help("give one of them another name"));
                return Some(id);
            }
        }
        let message = format!("no free name for {}", entry::name(statement));
        self.report(Diagnostic::error("dataset/name-taken", message).at(statement.head, "left out"));
        None
    }

    /// Reads the arguments of an object. One that is switched off stands only if it is in order: it may
    /// be a remark that looks like a statement.
    fn fill(&mut self, entry: &mut Entry<'a>) {
        let before = self.diagnostics.len();
        self.fill_cells(entry);
        if entry.statement.inactive && self.diagnostics[before..].iter().any(Diagnostic::is_error) {
            self.diagnostics.truncate(before);
            self.report(not_understood(entry.statement));
            if let Some(number) = entry.statement.id {
                self.numbers.remove(&(entry.statement.name, number));
            }
            self.database.remove(entry.id);
        }
    }

    fn fill_cells(&mut self, entry: &mut Entry<'a>) {
        statements::read(self, entry);
        let mut done: Vec<&str> = Vec::new();
        for field in entry.class.fields().filter(|f| f.keyword.is_some()) {
            if !done.contains(&field.name) {
                done.push(field.name);
                self.regular(entry, field);
            }
        }
        self.defaults(entry);
        for keyword in statements::REQUIRED.iter().filter(|(s, _)| *s == entry.statement.name).flat_map(|(_, k)| *k) {
            self.needs(entry, keyword);
        }
        let statement = entry.statement;
        if !statement.comments.is_empty() {
            self.store(entry.id, "comments", Value::Texts(statement.comments.clone()));
        }
        if let Some(units) = &statement.view_units {
            self.store(entry.id, "units", Value::Text(units.clone()));
        }
        if statement.inactive {
            self.store(entry.id, "active", Value::Text("off".to_string()));
        }
        self.finish(entry);
    }

    /// Reads a statement of settings; the object is made where there is something to keep.
    fn setting(&mut self, statement: &'a Statement) {
        let Some(class) = self.registry.classes.iter().copied().find(|c| c.statement == Some(statement.name)) else {
            return;
        };
        let mut entry = Entry::new(statement, self.model, class);
        statements::read_setting(self, &mut entry);
        self.finish(&entry);
    }

    /// The object of the settings of a class, made by the first use.
    pub fn settings_object(&mut self, class: &'static Class) -> Option<ObjectId> {
        if let Some(id) = self.database.child(Some(self.model), class.id, class.id) {
            return Some(id);
        }
        let id = self.database.create(class, Some(self.model), class.id).ok()?;
        let model = self.model;
        self.store(id, "model_name", Value::Object(model));
        Some(id)
    }
}

/// A statement behind comment marks that cannot be an object that is switched off.
pub(super) fn not_understood(statement: &Statement) -> Diagnostic {
    let message = format!("{} behind comment marks is not read", entry::name(statement));
    Diagnostic::warning("dataset/inactive-not-read", message).at(statement.head, "left out")
}

fn is_ground(statement: &Statement) -> bool {
    statement.name == "PART" && statement.has("GROUND")
}
