//! A statement while its object is made: which of its arguments have been read.

use model::ObjectId;
use schema::Class;

use super::statement::{Argument, Statement};
use super::vocabulary::Form;

pub(crate) struct Entry<'a> {
    pub statement: &'a Statement,
    pub id: ObjectId,
    pub class: &'static Class,
    read: Vec<bool>,
}

impl<'a> Entry<'a> {
    pub fn new(statement: &'a Statement, id: ObjectId, class: &'static Class) -> Entry<'a> {
        // What is not known was reported when the statement was split.
        Entry { statement, id, class, read: statement.arguments.iter().map(|a| !a.known).collect() }
    }

    /// An argument with a value that nobody has read yet; it counts as read from now on.
    pub fn take(&mut self, keyword: &str) -> Option<&'a Argument> {
        let mut found = None;
        for (argument, read) in self.statement.arguments.iter().zip(&mut self.read) {
            if argument.form != Form::Flag && argument.keyword == keyword && !*read {
                *read = true;
                found = Some(argument);
            }
        }
        found
    }

    /// All arguments of a keyword.
    pub fn take_all(&mut self, keyword: &str) -> Vec<&'a Argument> {
        self.take(keyword);
        self.statement.arguments.iter().filter(|a| a.form != Form::Flag && a.keyword == keyword).collect()
    }

    /// Whether a bare word is given, which counts as read from now on.
    pub fn flag(&mut self, word: &str) -> bool {
        let mut found = false;
        for (argument, read) in self.statement.arguments.iter().zip(&mut self.read) {
            if argument.form == Form::Flag && argument.keyword == word {
                *read = true;
                found = true;
            }
        }
        found
    }

    /// The first of some bare words that is given.
    pub fn one_of(&mut self, words: &[&'static str]) -> Option<&'static str> {
        words.iter().copied().find(|word| self.flag(word))
    }

    /// What nobody has read.
    pub fn left(&self) -> impl Iterator<Item = &'a Argument> + use<'_, 'a> {
        self.statement.arguments.iter().zip(&self.read).filter(|(_, read)| !**read).map(|(argument, _)| argument)
    }

    /// `MARKER/7`.
    pub fn name(&self) -> String {
        name(self.statement)
    }
}

/// `MARKER/7`, or `ACCGRAV/`.
pub(crate) fn name(statement: &Statement) -> String {
    statement.id.map_or_else(|| format!("{}/", statement.name), |id| format!("{}/{id}", statement.name))
}
