//! The tree of command keywords: which words may follow which, and what a complete path does.

use std::sync::Arc;

use indexmap::IndexMap;
use model::ObjectId;
use rustc_hash::FxBuildHasher;
use schema::{Class, Field, Group, Kind, Names, Registry, Use};
use smallvec::SmallVec;

use crate::{
    known,
    verbs::{self, VerbEntry},
    words::{Match, match_word},
};

/// What a parameter of a command stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Names the object that is created or modified.
    Object,
    /// New name of an existing object.
    NewName,
    /// A cell of the object, or a parameter of a verb or macro, by name.
    Field,
}

/// One parameter a command accepts.
#[derive(Clone, Debug)]
pub struct Parameter {
    pub name: Arc<str>,
    pub role: Role,
    pub field: Field,
}

/// A class and one of its groups.
pub type ClassGroup = (&'static Class, &'static Group);

/// What a complete command path does.
#[derive(Clone, Debug)]
pub enum Action {
    Create(&'static Class, &'static Group),
    /// Sets cells of an object that exists; its class decides which of these groups holds.
    Set(Arc<[ClassGroup]>),
    /// Sets cells of the one object of a class that each model has, which is made if missing.
    Settings(&'static Class, &'static Group),
    Verb(&'static VerbEntry),
    Macro(ObjectId),
    /// Known to Adams, not executed here.
    Unsupported,
}

/// A complete command.
#[derive(Clone, Debug)]
pub struct Command {
    pub path: Arc<str>,
    pub action: Action,
    pub parameters: Arc<[Parameter]>,
}

impl Command {
    /// What the command does, in one sentence.
    pub fn doc(&self) -> &'static str {
        match &self.action {
            Action::Create(_, group) | Action::Settings(_, group) => group.doc,
            Action::Set(groups) => groups.first().map_or("", |(_, group)| group.doc),
            Action::Verb(entry) => entry.verb.doc,
            Action::Macro(_) | Action::Unsupported => "",
        }
    }

    /// Whether the command is understood with its parameters, but named and skipped when it is met.
    pub fn is_refused(&self) -> bool {
        match &self.action {
            Action::Verb(entry) => entry.is_refused(),
            Action::Unsupported => true,
            _ => false,
        }
    }
}

#[derive(Debug, Default)]
struct Node {
    children: IndexMap<Box<str>, usize, FxBuildHasher>,
    command: Option<Command>,
    /// Known from the list of keywords only.
    known_only: bool,
}

/// All commands of a session.
#[derive(Debug)]
pub struct CommandTree {
    nodes: Vec<Node>,
}

/// How far the keywords of a statement lead.
#[derive(Clone, Debug)]
pub enum Path {
    Found(Command),
    /// Word number `at` is unknown there; `near` is what may follow.
    Unknown {
        at: usize,
        near: Vec<String>,
    },
    Ambiguous {
        at: usize,
        candidates: Vec<String>,
    },
    /// A complete command is followed by a further word.
    Surplus {
        at: usize,
    },
    /// More keywords are needed behind the last one.
    Incomplete {
        next: Vec<String>,
    },
}

impl CommandTree {
    pub fn new(registry: &Registry) -> CommandTree {
        let mut tree = CommandTree { nodes: vec![Node::default()] };
        for (path, words) in known::KEYWORDS {
            let node = tree.reach(path.split_whitespace());
            for word in words.split_whitespace() {
                let child = tree.child(node, word);
                tree.nodes[child].known_only = true;
            }
        }
        let mut setters: IndexMap<String, Vec<ClassGroup>> = IndexMap::new();
        let mut makers: Vec<(String, ClassGroup)> = Vec::new();
        for class in &registry.classes {
            for group in class.groups {
                let modify = group.command.split(' ').map(|w| if w == "create" { "modify" } else { w });
                let modify = modify.collect::<Vec<_>>().join(" ");
                if group.creates {
                    makers.push((group.command.to_string(), (class, group)));
                } else if modify != group.command {
                    setters.entry(group.command.to_string()).or_default().push((class, group));
                }
                if modify != group.command || !group.creates {
                    setters.entry(modify).or_default().push((class, group));
                }
            }
        }
        for (path, groups) in setters {
            tree.add(&path, Action::Set(groups.clone().into()), set_parameters(&path, &groups));
        }
        for (path, (class, group)) in makers {
            if group.object.is_empty() {
                tree.add(&path, Action::Settings(class, group), field_parameters(group, Use::Modify));
            } else {
                let object = Field::new(group.object, Kind::Object(Names::New, class.id));
                let mut list = vec![Parameter { name: group.object.into(), role: Role::Object, field: object }];
                list.extend(field_parameters(group, Use::Modify));
                tree.add(&path, Action::Create(class, group), list);
            }
        }
        let attributes = all_attributes(registry);
        for entry in verbs::ALL {
            let plain = |f: &Field| Parameter { name: f.name.into(), role: Role::Field, field: *f };
            let mut parameters: Vec<Parameter> = entry.verb.fields.iter().map(plain).collect();
            if entry.verb.path == "entity attributes" {
                for parameter in attributes.iter().map(plain) {
                    if !parameters.iter().any(|p| p.name == parameter.name) {
                        parameters.push(parameter);
                    }
                }
            }
            tree.add(entry.verb.path, Action::Verb(entry), parameters);
        }
        tree
    }

    /// Adds a command; a path that has one already gets the new one.
    pub fn add(&mut self, path: &str, action: Action, parameters: Vec<Parameter>) {
        let node = self.reach(path.split_whitespace());
        self.nodes[node].command = Some(Command { path: path.into(), action, parameters: parameters.into() });
    }

    /// Takes a command away again.
    pub fn remove(&mut self, path: &str) {
        let node = self.reach(path.split_whitespace());
        self.nodes[node].command = None;
    }

    fn reach<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> usize {
        words.fold(0, |node, word| self.child(node, word))
    }

    /// The node behind a word, which is made if missing.
    fn child(&mut self, node: usize, word: &str) -> usize {
        // Tables are in lower case.
        if let Some(&child) = self.nodes[node].children.get(word) {
            return child;
        }
        let new = self.nodes.len();
        let child = *self.nodes[node].children.entry(word.to_ascii_lowercase().into()).or_insert(new);
        if child == new {
            self.nodes.push(Node::default());
        }
        child
    }

    /// A node that leads to a command, or that the list of keywords names.
    fn alive(&self, node: usize) -> bool {
        let n = &self.nodes[node];
        n.command.is_some() || n.known_only || n.children.values().any(|c| self.alive(*c))
    }

    fn following(&self, node: usize) -> Vec<String> {
        self.nodes[node].children.iter().filter(|(_, c)| self.alive(**c)).map(|(w, _)| w.to_string()).collect()
    }

    /// Follows the keywords of a command.
    pub fn find(&self, words: &[&str]) -> Path {
        let (mut node, mut path) = (0, SmallVec::<[&str; 8]>::new());
        for (at, word) in words.iter().enumerate() {
            let children = &self.nodes[node].children;
            let spelled_out = children.get_index_of(*word).map(Match::One);
            let matched = match spelled_out.unwrap_or_else(|| match_word(children.keys().map(AsRef::as_ref), word)) {
                // Forms the list of keywords alone knows give way where abbreviations tie.
                Match::Many(found) => return Path::Ambiguous { at, candidates: self.names(node, &found) },
                other => other,
            };
            match matched {
                Match::One(i) => {
                    if let Some((name, &child)) = children.get_index(i) {
                        path.push(name);
                        node = child;
                    }
                }
                _ if self.nodes[node].command.is_some() => return Path::Surplus { at },
                // Below a command that is only known by name nothing is known.
                _ if self.nodes[node].known_only
                    && (self.nodes[node].children.is_empty() || known::OPEN.contains(&path.join(" ").as_str())) =>
                {
                    return Path::Found(unsupported(&path.join(" "), &words[at..]));
                }
                _ => return Path::Unknown { at, near: self.following(node) },
            }
        }
        match &self.nodes[node].command {
            Some(command) => Path::Found(command.clone()),
            None if self.nodes[node].known_only && self.nodes[node].children.is_empty() && node != 0 => {
                Path::Found(unsupported(&path.join(" "), &[]))
            }
            None if path.len() > 1 && known::OPEN.contains(&path.join(" ").as_str()) => {
                Path::Found(unsupported(&path.join(" "), &[]))
            }
            None => Path::Incomplete { next: self.following(node) },
        }
    }

    fn names(&self, node: usize, indices: &[usize]) -> Vec<String> {
        indices.iter().filter_map(|i| self.nodes[node].children.get_index(*i)).map(|(w, _)| w.to_string()).collect()
    }

    /// The words that may follow keywords, for help and completion.
    pub fn next_words(&self, words: &[&str]) -> Vec<String> {
        let mut node = 0;
        for word in words {
            let children = &self.nodes[node].children;
            match match_word(children.keys().map(AsRef::as_ref), word) {
                Match::One(i) => match children.get_index(i) {
                    Some((_, &child)) => node = child,
                    None => return Vec::new(),
                },
                _ => return Vec::new(),
            }
        }
        self.following(node)
    }

    /// Every path with what it does, in order of registration: for `flexure support`.
    pub fn commands(&self) -> Vec<Command> {
        let mut found = Vec::new();
        let mut stack = vec![(0usize, String::new())];
        while let Some((node, path)) = stack.pop() {
            let n = &self.nodes[node];
            if let Some(command) = &n.command {
                found.push(command.clone());
            } else if n.known_only && n.children.is_empty() {
                found.push(unsupported(&path, &[]));
            }
            for (word, child) in n.children.iter().rev() {
                let path = if path.is_empty() { word.to_string() } else { format!("{path} {word}") };
                stack.push((*child, path));
            }
        }
        found
    }
}

/// The parameters of a group but for those of the other form.
fn field_parameters(group: &'static Group, excluded: Use) -> Vec<Parameter> {
    let used = group.fields.iter().filter(|f| f.usage != excluded);
    used.map(|f| Parameter { name: f.name.into(), role: Role::Field, field: *f }).collect()
}

/// The parameters of a command that sets cells of objects of several classes.
fn set_parameters(path: &str, groups: &[ClassGroup]) -> Vec<Parameter> {
    let many = path.ends_with(" attributes");
    let mut list: Vec<Parameter> = Vec::new();
    let known = |list: &[Parameter], name: &str| list.iter().any(|p| &*p.name == name);
    for (_, group) in groups {
        if known(&list, group.object) {
            continue;
        }
        let classes: Vec<&Class> = groups.iter().filter(|(_, g)| g.object == group.object).map(|(c, _)| *c).collect();
        let mut field = Field::new(group.object, Kind::Object(Names::Old, common_family(&classes))).current();
        if many {
            field = field.many();
        }
        list.push(Parameter { name: group.object.into(), role: Role::Object, field });
        if groups.iter().any(|(_, g)| g.creates && g.object == group.object) {
            let field = Field::new(group.object, Kind::Object(Names::New, classes[0].id));
            list.push(Parameter { name: format!("new_{}", group.object).into(), role: Role::NewName, field });
        }
    }
    for (_, group) in groups {
        for parameter in field_parameters(group, Use::Create) {
            if !known(&list, &parameter.name) {
                list.push(parameter);
            }
        }
    }
    list
}

/// What an object must be to belong to one of these classes.
fn common_family(classes: &[&Class]) -> &'static str {
    let Some(first) = classes.first() else { return "any" };
    if classes.iter().all(|c| c.id == first.id) {
        return first.id;
    }
    first.families.iter().copied().find(|f| classes.iter().all(|c| c.is(f))).unwrap_or("any")
}

/// Every attribute that any class has, for `entity attributes`.
fn all_attributes(registry: &Registry) -> Vec<Field> {
    let mut found: Vec<Field> = Vec::new();
    let groups = registry.classes.iter().flat_map(|c| c.groups).filter(|g| g.command.ends_with(" attributes"));
    for field in groups.flat_map(|g| g.fields) {
        if !found.iter().any(|f| f.name == field.name) {
            found.push(*field);
        }
    }
    found
}

fn unsupported(path: &str, rest: &[&str]) -> Command {
    let path: Vec<&str> = path.split(' ').chain(rest.iter().copied()).collect();
    Command { path: path.join(" ").into(), action: Action::Unsupported, parameters: Arc::new([]) }
}
