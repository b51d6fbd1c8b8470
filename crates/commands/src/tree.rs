//! The tree of command keywords: which words may follow which, and what a complete path does.

use std::borrow::Cow;
use std::sync::{Arc, OnceLock};

use indexmap::IndexMap;
use model::ObjectId;
use rustc_hash::FxBuildHasher;
use schema::{Class, Field, Group, Registry};
use smallvec::SmallVec;

use crate::{
    known,
    parameters::{is_attributes, parameters_of},
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

/// A command of the tree. What it looks like in full is put together when it is first asked for: a
/// process meets a few dozen of the many hundred commands, and building all costs more than reading a
/// small model.
#[derive(Debug)]
struct Entry {
    action: Action,
    /// Of a macro; of other commands the tables say which parameters they have.
    own: Option<Arc<[Parameter]>>,
    command: OnceLock<Command>,
}

/// Words that may follow, in order of registration.
#[derive(Debug, Default)]
struct Children {
    words: Vec<(Cow<'static, str>, usize)>,
    /// Places in `words`, sorted by word; made when a word is first looked up.
    sorted: OnceLock<Box<[usize]>>,
}

impl Children {
    fn words(&self) -> impl ExactSizeIterator<Item = &str> + Clone {
        self.words.iter().map(|(word, _)| word.as_ref())
    }

    /// The place of a word that is spelled out.
    fn place(&self, word: &str) -> Option<usize> {
        let sorted = self.sorted.get_or_init(|| {
            let mut places: Box<[usize]> = (0..self.words.len()).collect();
            places.sort_unstable_by_key(|i| &self.words[*i].0);
            places
        });
        sorted.binary_search_by_key(&word, |i| self.words[*i].0.as_ref()).ok().map(|found| sorted[found])
    }

    fn add(&mut self, word: Cow<'static, str>, node: usize) {
        self.words.push((word, node));
        self.sorted.take();
    }
}

#[derive(Debug, Default)]
struct Node {
    children: Children,
    entry: Option<Entry>,
    /// Known from the list of keywords only.
    known_only: bool,
}

/// All commands of a session.
#[derive(Debug)]
pub struct CommandTree {
    nodes: Vec<Node>,
    /// Groups whose fields `entity attributes` takes.
    attributes: Vec<&'static Group>,
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
        let groups = || registry.classes.iter().flat_map(|c| c.groups.iter().map(move |g| (*c, g)));
        let attributes = groups().map(|(_, g)| g).filter(|g| is_attributes(g.command)).collect();
        let mut tree = CommandTree { nodes: vec![Node::default()], attributes };
        for (path, words) in known::KEYWORDS {
            let node = tree.reach(path.split_whitespace());
            for word in words.split_whitespace() {
                let child = tree.child(node, word.into());
                tree.nodes[child].known_only = true;
            }
        }
        let mut setters: IndexMap<usize, Vec<ClassGroup>, FxBuildHasher> = IndexMap::default();
        for (class, group) in groups() {
            let creates = group.command.split(' ').any(|word| word == "create");
            if !group.creates && creates {
                let node = tree.reach(group.command.split(' '));
                setters.entry(node).or_default().push((class, group));
            }
            if !group.creates || creates {
                let modify = group.command.split(' ').map(|word| if word == "create" { "modify" } else { word });
                let node = tree.reach(modify);
                setters.entry(node).or_default().push((class, group));
            }
        }
        for (node, groups) in setters {
            tree.set(node, Action::Set(groups.into()), None);
        }
        for (class, group) in groups().filter(|(_, group)| group.creates) {
            let node = tree.reach(group.command.split(' '));
            let settings = group.object.is_empty();
            tree.set(node, if settings { Action::Settings(class, group) } else { Action::Create(class, group) }, None);
        }
        for entry in verbs::ALL {
            let node = tree.reach(entry.verb.path.split_whitespace());
            tree.set(node, Action::Verb(entry), None);
        }
        tree
    }

    /// Adds the command that runs a macro; a path that has a command already gets the new one.
    pub fn add_macro(&mut self, path: &str, id: ObjectId, parameters: Vec<Parameter>) {
        let node = path.split_whitespace().fold(0, |node, word| self.child(node, word.to_ascii_lowercase().into()));
        self.set(node, Action::Macro(id), Some(parameters.into()));
    }

    /// Takes a command away again.
    pub fn remove(&mut self, path: &str) {
        let mut node = 0;
        for word in path.split_whitespace() {
            let Some(place) = self.nodes[node].children.place(&word.to_ascii_lowercase()) else { return };
            node = self.nodes[node].children.words[place].1;
        }
        self.nodes[node].entry = None;
    }

    fn set(&mut self, node: usize, action: Action, own: Option<Arc<[Parameter]>>) {
        self.nodes[node].entry = Some(Entry { action, own, command: OnceLock::new() });
    }

    /// The node at the end of words of our tables, which are in lower case.
    fn reach(&mut self, words: impl Iterator<Item = &'static str>) -> usize {
        words.fold(0, |node, word| self.child(node, word.into()))
    }

    /// The node behind a word in lower case, which is made if missing.
    fn child(&mut self, node: usize, word: Cow<'static, str>) -> usize {
        if let Some((_, child)) = self.nodes[node].children.words.iter().find(|(known, _)| *known == word) {
            return *child;
        }
        let child = self.nodes.len();
        self.nodes.push(Node::default());
        self.nodes[node].children.add(word, child);
        child
    }

    /// The command at a node, whose keywords are `path`.
    fn command(&self, node: usize, path: &[&str]) -> Option<&Command> {
        let Entry { action, own, command } = self.nodes[node].entry.as_ref()?;
        Some(command.get_or_init(|| {
            let path = path.join(" ");
            let parameters = own.clone().unwrap_or_else(|| parameters_of(action, &path, &self.attributes).into());
            Command { path: path.into(), action: action.clone(), parameters }
        }))
    }

    /// A node that leads to a command, or that the list of keywords names.
    fn alive(&self, node: usize) -> bool {
        let n = &self.nodes[node];
        n.entry.is_some() || n.known_only || n.children.words.iter().any(|(_, c)| self.alive(*c))
    }

    fn following(&self, node: usize) -> Vec<String> {
        let words = self.nodes[node].children.words.iter();
        words.filter(|(_, child)| self.alive(*child)).map(|(word, _)| word.to_string()).collect()
    }

    /// Follows the keywords of a command.
    pub fn find(&self, words: &[&str]) -> Path {
        let (mut node, mut path) = (0, SmallVec::<[&str; 8]>::new());
        for (at, word) in words.iter().enumerate() {
            let children = &self.nodes[node].children;
            let spelled_out = children.place(word).map(Match::One);
            match spelled_out.unwrap_or_else(|| match_word(children.words(), word)) {
                Match::Many(found) => return Path::Ambiguous { at, candidates: self.names(node, &found) },
                Match::One(i) => {
                    if let Some((name, child)) = children.words.get(i) {
                        path.push(name);
                        node = *child;
                    }
                }
                Match::None if self.nodes[node].entry.is_some() => return Path::Surplus { at },
                // Below a command that is only known by name nothing is known.
                Match::None
                    if self.nodes[node].known_only
                        && (self.nodes[node].children.words.is_empty()
                            || known::OPEN.contains(&path.join(" ").as_str())) =>
                {
                    return Path::Found(unsupported(&path.join(" "), &words[at..]));
                }
                Match::None => return Path::Unknown { at, near: self.following(node) },
            }
        }
        match self.command(node, &path) {
            Some(command) => Path::Found(command.clone()),
            None if self.nodes[node].known_only && self.nodes[node].children.words.is_empty() => {
                Path::Found(unsupported(&path.join(" "), &[]))
            }
            None if path.len() > 1 && known::OPEN.contains(&path.join(" ").as_str()) => {
                Path::Found(unsupported(&path.join(" "), &[]))
            }
            None => Path::Incomplete { next: self.following(node) },
        }
    }

    fn names(&self, node: usize, indices: &[usize]) -> Vec<String> {
        let words = &self.nodes[node].children.words;
        indices.iter().filter_map(|i| words.get(*i)).map(|(word, _)| word.to_string()).collect()
    }

    /// The words that may follow keywords, for help and completion.
    pub fn next_words(&self, words: &[&str]) -> Vec<String> {
        let mut node = 0;
        for word in words {
            let children = &self.nodes[node].children;
            match match_word(children.words(), word) {
                Match::One(i) => node = children.words[i].1,
                _ => return Vec::new(),
            }
        }
        self.following(node)
    }

    /// Every path with what it does, in order of registration: for `flexure support`.
    pub fn commands(&self) -> Vec<Command> {
        let mut found = Vec::new();
        let mut stack = vec![(0usize, Vec::<&str>::new())];
        while let Some((node, path)) = stack.pop() {
            let n = &self.nodes[node];
            if let Some(command) = self.command(node, &path) {
                found.push(command.clone());
            } else if n.known_only && n.children.words.is_empty() {
                found.push(unsupported(&path.join(" "), &[]));
            }
            for (word, child) in n.children.words.iter().rev() {
                stack.push((*child, path.iter().copied().chain([word.as_ref()]).collect()));
            }
        }
        found
    }
}

fn unsupported(path: &str, rest: &[&str]) -> Command {
    let path: Vec<&str> = path.split(' ').chain(rest.iter().copied()).collect();
    Command { path: path.join(" ").into(), action: Action::Unsupported, parameters: Arc::new([]) }
}
