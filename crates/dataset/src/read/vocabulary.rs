//! The words of statements: their names, and the arguments each knows. The arguments come from the
//! fields of the classes and from what the irregular statements add; any beginning of a word that
//! fits one only stands for it.

use std::collections::HashMap;

use schema::{Kind, Registry};

use crate::statements::{self, Choice};

/// How an argument is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// A bare word.
    Flag,
    /// Numbers, words or texts behind `=`.
    Value,
    /// An expression behind `=`.
    Function,
    /// The rest of the line behind `=`.
    Text,
}

/// An argument a statement knows.
pub(crate) type Word = (&'static str, Form);

/// Statements of the solver that no class stands for yet.
const UNREAD: &[&str] = &[
    "ADAMS_ID",
    "CURSUB",
    "CVSF",
    "DEBUG",
    "ENVIRONMENT",
    "FE_LOAD",
    "FE_NODE",
    "FE_PART",
    "FLEX_BODY",
    "IC",
    "LSOLVER",
    "MATERIAL",
    "MREQUEST",
    "PINPUT",
    "POUTPUT",
    "PSTATE",
    "PTSF",
    "SECTION",
    "SURFACE",
    "TIRE",
];

/// What an abbreviation means where several words begin with it.
const PREFERRED: &[(&str, &str, &str)] = &[
    ("", "ACC", "ACCGRAV"),
    ("REQUEST", "A", "ACCELERATION"),
    ("REQUEST", "C", "COMMENT"),
    ("REQUEST", "D", "DISPLACEMENT"),
    ("REQUEST", "F", "FORCE"),
    ("REQUEST", "V", "VELOCITY"),
    ("PREFERENCES", "NT", "NTHREADS"),
];

/// What a word stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Found<T> {
    One(T),
    /// Several words begin like that.
    Many,
    None,
}

pub(crate) struct Vocabulary {
    statements: Vec<&'static str>,
    words: HashMap<&'static str, Vec<Word>>,
    choices: HashMap<&'static str, Vec<Choice>>,
}

impl Vocabulary {
    pub fn new(registry: &Registry) -> Vocabulary {
        let mut words: HashMap<&'static str, Vec<Word>> = HashMap::new();
        for class in &registry.classes {
            let Some(statement) = class.statement else { continue };
            let known = words.entry(statement).or_default();
            for field in class.fields() {
                let Some(keyword) = field.keyword else { continue };
                let form = match field.kind {
                    Kind::Function => Form::Function,
                    Kind::Boolean(..) => Form::Flag,
                    Kind::Text if keyword == "COMMENT" || keyword == "STRING" => Form::Text,
                    _ => Form::Value,
                };
                known.push((keyword, form));
            }
        }
        words.entry("UNITS").or_default();
        let mut statements: Vec<_> = words.keys().copied().chain(UNREAD.iter().copied()).collect();
        statements.sort_unstable();
        for (statement, known) in &mut words {
            known.extend(statements::words(statement));
            known.extend(statements::setting_words(statement));
            known.sort_by_key(|(word, form)| (*word, *form == Form::Flag));
            known.dedup();
        }
        let choices = words.keys().map(|statement| (*statement, statements::choices(statement))).collect();
        Vocabulary { statements, words, choices }
    }

    /// The arguments of a statement that exclude each other.
    pub fn choices(&self, statement: &str) -> &[Choice] {
        self.choices.get(statement).map_or(&[], Vec::as_slice)
    }

    /// Names of all statements.
    pub fn statements(&self) -> &[&'static str] {
        &self.statements
    }

    /// Whether statements of that name are read.
    pub fn reads(&self, statement: &str) -> bool {
        self.words.contains_key(statement)
    }

    /// A statement by its name or a beginning of it.
    pub fn statement(&self, typed: &str) -> Found<&'static str> {
        find(self.statements.iter().copied(), "", typed)
    }

    /// The arguments of a statement.
    pub fn words(&self, statement: &str) -> &[Word] {
        self.words.get(statement).map_or(&[], Vec::as_slice)
    }

    /// An argument by its word or a beginning of it: with or without a value behind it.
    pub fn argument(&self, statement: &str, typed: &str, bare: bool) -> Found<Word> {
        let words = self.words(statement);
        let fitting = words.iter().filter(|(_, form)| (*form == Form::Flag) == bare);
        match find(fitting.clone().map(|(word, _)| *word), statement, typed) {
            Found::One(word) => {
                fitting.clone().find(|(known, _)| *known == word).map_or(Found::None, |word| Found::One(*word))
            }
            Found::Many => Found::Many,
            Found::None => Found::None,
        }
    }

    /// Whether a bare word is, or begins, a word of the statement that takes no value.
    pub fn is_flag(&self, statement: &str, typed: &str) -> bool {
        matches!(self.argument(statement, typed, true), Found::One(_))
    }
}

fn find(words: impl Iterator<Item = &'static str> + Clone, statement: &str, typed: &str) -> Found<&'static str> {
    if typed.is_empty() {
        return Found::None;
    }
    if let Some(word) = words.clone().find(|word| word.eq_ignore_ascii_case(typed)) {
        return Found::One(word);
    }
    let preferred = PREFERRED.iter().find(|(s, short, _)| *s == statement && short.eq_ignore_ascii_case(typed));
    if let Some((_, _, word)) = preferred
        && words.clone().any(|known| known == *word)
    {
        return Found::One(word);
    }
    let begins = |word: &&str| word.get(..typed.len()).is_some_and(|head| head.eq_ignore_ascii_case(typed));
    let mut fitting = words.filter(begins);
    match (fitting.next(), fitting.next()) {
        (Some(word), None) => Found::One(word),
        (Some(_), Some(_)) => Found::Many,
        (None, _) => Found::None,
    }
}
