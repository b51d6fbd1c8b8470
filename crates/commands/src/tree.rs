//! The tree of command keywords: which words may follow which, and what a complete path does.

use std::borrow::Cow;
use std::hash::Hasher;
use std::sync::{Arc, OnceLock};

use hashbrown::HashTable;
use model::{Database, ObjectId};
use rustc_hash::FxHasher;
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
    command: OnceLock<Box<Command>>,
    /// What the same words stand for where this is a macro that does not exist (any more).
    hides: Option<u32>,
}

/// A word of the tree. The words that may follow it are a chain, in order of registration.
#[derive(Debug)]
struct Node {
    /// In lower case.
    word: Cow<'static, str>,
    parent: u32,
    first_child: u32,
    last_child: u32,
    /// What may stand in its place.
    next: u32,
    /// Place in the list of entries.
    entry: Option<u32>,
    /// Known from the list of keywords only.
    known_only: bool,
}

impl Node {
    fn new(word: Cow<'static, str>, parent: u32) -> Node {
        Node { word, parent, first_child: ROOT, last_child: ROOT, next: ROOT, entry: None, known_only: false }
    }
}

/// Where every command begins. It follows no word, so as a link it says that there is none.
const ROOT: u32 = 0;

/// Room that is made at once, more than the tables need: growing step by step would write all three
/// times over, in every process.
const ROOM: usize = 1024;

/// All commands of a session.
#[derive(Debug)]
pub struct CommandTree {
    nodes: Vec<Node>,
    entries: Vec<Entry>,
    /// Nodes by their parent and word.
    by_word: HashTable<u32>,
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
        let mut nodes = Vec::with_capacity(ROOM);
        nodes.push(Node::new("".into(), ROOT));
        let mut tree = CommandTree {
            nodes,
            entries: Vec::with_capacity(ROOM / 2),
            by_word: HashTable::with_capacity(ROOM),
            attributes: groups().map(|(_, g)| g).filter(|g| is_attributes(g.command)).collect(),
        };
        for (path, words) in known::KEYWORDS {
            let node = tree.reach(path.split_whitespace());
            for word in words.split_whitespace() {
                let child = tree.child(node, word.into());
                tree.nodes[child as usize].known_only = true;
            }
        }
        let mut setters: Vec<(u32, ClassGroup)> = Vec::with_capacity(ROOM);
        for (class, group) in groups() {
            let creates = group.command.split(' ').any(|word| word == "create");
            if !group.creates && creates {
                let node = tree.reach(group.command.split(' '));
                setters.push((node, (class, group)));
            }
            if !group.creates || creates {
                let modify = group.command.split(' ').map(|word| if word == "create" { "modify" } else { word });
                let node = tree.reach(modify);
                setters.push((node, (class, group)));
            }
        }
        setters.sort_by_key(|(node, _)| *node);
        for same in setters.chunk_by(|(a, _), (b, _)| a == b) {
            tree.set(same[0].0, Action::Set(same.iter().map(|(_, group)| *group).collect()));
        }
        for (class, group) in groups().filter(|(_, group)| group.creates) {
            let node = tree.reach(group.command.split(' '));
            let settings = group.object.is_empty();
            tree.set(node, if settings { Action::Settings(class, group) } else { Action::Create(class, group) });
        }
        for entry in verbs::ALL {
            let node = tree.reach(entry.verb.path.split_whitespace());
            tree.set(node, Action::Verb(entry));
        }
        tree
    }

    /// Adds the command that runs a macro, in front of what its words stood for. It is there as long
    /// as the macro is.
    pub fn add_macro(&mut self, path: &str, id: ObjectId, parameters: Vec<Parameter>) {
        let node = path.split_whitespace().fold(ROOT, |node, word| self.child(node, word.to_ascii_lowercase().into()));
        self.unlink(node, id);
        let action = Action::Macro(id);
        let command = Command { path: self.path(node).into(), action: action.clone(), parameters: parameters.into() };
        self.set(node, action).command = OnceLock::from(Box::new(command));
    }

    /// Takes the command of a macro away again.
    pub fn remove_macro(&mut self, path: &str, id: ObjectId) {
        let lower = path.to_ascii_lowercase();
        if let Some(node) = lower.split_whitespace().try_fold(ROOT, |node, word| self.spelled_out(node, word)) {
            self.unlink(node, id);
        }
    }

    fn unlink(&mut self, node: u32, id: ObjectId) {
        let is_macro = |action: &Action| matches!(action, Action::Macro(known) if *known == id);
        let Some(place) = self.entries_at(node).find(|place| is_macro(&self.entries[*place as usize].action)) else {
            return;
        };
        let hidden = self.entries[place as usize].hides;
        let above = self.entries_at(node).find(|above| self.entries[*above as usize].hides == Some(place));
        match above {
            Some(above) => self.entries[above as usize].hides = hidden,
            None => self.nodes[node as usize].entry = hidden,
        }
    }

    /// Places of what the words of a node stand for, the last that was added first.
    fn entries_at(&self, node: u32) -> impl Iterator<Item = u32> {
        std::iter::successors(self.node(node).entry, |place| self.entries[*place as usize].hides)
    }

    /// What the words of a node stand for; macros that do not exist (any more) stand for nothing.
    fn entry(&self, node: u32, database: &Database) -> Option<&Entry> {
        self.entries_at(node).map(|place| &self.entries[place as usize]).find(|entry| match entry.action {
            Action::Macro(id) => database.get(id).is_some(),
            _ => true,
        })
    }

    fn set(&mut self, node: u32, action: Action) -> &mut Entry {
        let place = self.entries.len();
        let hides = self.nodes[node as usize].entry.replace(place as u32);
        self.entries.push(Entry { action, command: OnceLock::new(), hides });
        &mut self.entries[place]
    }

    /// The node at the end of words of our tables, which are in lower case.
    fn reach(&mut self, words: impl Iterator<Item = &'static str>) -> u32 {
        words.fold(ROOT, |node, word| self.child(node, word.into()))
    }

    /// The node behind a word in lower case, which is made if missing.
    fn child(&mut self, parent: u32, word: Cow<'static, str>) -> u32 {
        if let Some(child) = self.spelled_out(parent, &word) {
            return child;
        }
        let child = self.nodes.len() as u32;
        let hash = |n: &Node| hash(n.parent, &n.word);
        let node = Node::new(word, parent);
        self.by_word.insert_unique(hash(&node), child, |other| hash(&self.nodes[*other as usize]));
        self.nodes.push(node);
        let last = std::mem::replace(&mut self.nodes[parent as usize].last_child, child);
        if last == ROOT {
            self.nodes[parent as usize].first_child = child;
        } else {
            self.nodes[last as usize].next = child;
        }
        child
    }

    fn node(&self, node: u32) -> &Node {
        &self.nodes[node as usize]
    }

    /// The node behind a word that is spelled out.
    fn spelled_out(&self, parent: u32, word: &str) -> Option<u32> {
        let is = |node: &u32| {
            let node = self.node(*node);
            node.parent == parent && node.word == word
        };
        self.by_word.find(hash(parent, word), is).copied()
    }

    /// The nodes behind the words that may follow, in order of registration.
    fn children(&self, node: u32) -> impl Iterator<Item = u32> + Clone {
        let link = |node: u32| (node != ROOT).then_some(node);
        std::iter::successors(link(self.node(node).first_child), move |child| link(self.node(*child).next))
    }

    /// The words that lead to a node.
    fn path(&self, node: u32) -> String {
        let mut words: SmallVec<[&str; 8]> = SmallVec::new();
        let mut node = self.node(node);
        while !node.word.is_empty() {
            words.push(&node.word);
            node = self.node(node.parent);
        }
        words.reverse();
        words.join(" ")
    }

    /// The command at a node.
    fn command(&self, node: u32, database: &Database) -> Option<&Command> {
        let Entry { action, command, .. } = self.entry(node, database)?;
        Some(command.get_or_init(|| {
            let path = self.path(node);
            let parameters = parameters_of(action, &path, &self.attributes).into();
            Box::new(Command { path: path.into(), action: action.clone(), parameters })
        }))
    }

    /// Nothing is known of what may follow.
    fn is_end(&self, node: u32) -> bool {
        self.node(node).first_child == ROOT
    }

    /// A node that leads to a command, or that the list of keywords names.
    fn alive(&self, node: u32, database: &Database) -> bool {
        self.node(node).known_only
            || self.entry(node, database).is_some()
            || self.children(node).any(|child| self.alive(child, database))
    }

    /// What may follow, in order of registration.
    fn living(&self, node: u32, database: &Database) -> impl Iterator<Item = u32> + Clone {
        self.children(node).filter(|child| self.alive(*child, database))
    }

    fn following(&self, node: u32, database: &Database) -> Vec<String> {
        self.words(self.living(node, database))
    }

    fn words(&self, nodes: impl Iterator<Item = u32>) -> Vec<String> {
        nodes.map(|node| self.node(node).word.to_string()).collect()
    }

    /// What a word that may be abbreviated stands for, by position among what may follow.
    fn matching(&self, node: u32, word: &str, database: &Database) -> Match {
        match_word(self.living(node, database).map(|child| self.node(child).word.as_ref()), word)
    }

    /// Follows the keywords of a command.
    pub fn find(&self, words: &[&str], database: &Database) -> Path {
        let mut node = ROOT;
        for (at, word) in words.iter().enumerate() {
            if let Some(child) = self.spelled_out(node, word).filter(|child| self.alive(*child, database)) {
                node = child;
                continue;
            }
            match self.matching(node, word, database) {
                Match::Many(found) => {
                    let children: Vec<u32> = self.living(node, database).collect();
                    return Path::Ambiguous { at, candidates: self.words(found.iter().map(|i| children[*i])) };
                }
                Match::One(i) => node = self.living(node, database).nth(i).unwrap_or(node),
                Match::None if self.entry(node, database).is_some() => return Path::Surplus { at },
                // Below a command that is only known by name nothing is known.
                Match::None
                    if self.node(node).known_only
                        && (self.is_end(node) || known::OPEN.contains(&self.path(node).as_str())) =>
                {
                    return Path::Found(unsupported(&self.path(node), &words[at..]));
                }
                Match::None => return Path::Unknown { at, near: self.following(node, database) },
            }
        }
        match self.command(node, database) {
            Some(command) => Path::Found(command.clone()),
            None if self.node(node).known_only && self.is_end(node) => Path::Found(unsupported(&self.path(node), &[])),
            None if words.len() > 1 && known::OPEN.contains(&self.path(node).as_str()) => {
                Path::Found(unsupported(&self.path(node), &[]))
            }
            None => Path::Incomplete { next: self.following(node, database) },
        }
    }

    /// The words that may follow keywords, for help and completion.
    pub fn next_words(&self, words: &[&str], database: &Database) -> Vec<String> {
        let step = |node, word: &&str| match self.matching(node, word, database) {
            Match::One(i) => self.living(node, database).nth(i),
            _ => None,
        };
        words.iter().try_fold(ROOT, step).map_or_else(Vec::new, |node| self.following(node, database))
    }

    /// Every path with what it does, in order of registration: for `flexure support`.
    pub fn commands(&self, database: &Database) -> Vec<Command> {
        let mut found = Vec::new();
        let mut stack = vec![ROOT];
        while let Some(node) = stack.pop() {
            if let Some(command) = self.command(node, database) {
                found.push(command.clone());
            } else if self.node(node).known_only && self.is_end(node) {
                found.push(unsupported(&self.path(node), &[]));
            }
            let children: Vec<u32> = self.children(node).collect();
            stack.extend(children.iter().rev());
        }
        found
    }
}

/// Of a word that follows another.
fn hash(parent: u32, word: &str) -> u64 {
    let mut hasher = FxHasher::default();
    hasher.write_u32(parent);
    hasher.write(word.as_bytes());
    hasher.finish()
}

fn unsupported(path: &str, rest: &[&str]) -> Command {
    let path: Vec<&str> = path.split(' ').chain(rest.iter().copied()).collect();
    Command { path: path.join(" ").into(), action: Action::Unsupported, parameters: Arc::new([]) }
}
