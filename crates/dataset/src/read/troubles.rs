//! What is wrong with the arguments of a statement, said alike of all statements.

use std::ops::Range;

use text::{Diagnostic, suggest};

use super::{
    Builder, Entry, entry,
    statement::{Argument, Statement},
};

impl<'a> Builder<'a> {
    /// Reports a word that is none of those accepted.
    pub fn unknown_word(&mut self, argument: &Argument, (typed, at): (&str, Range<usize>), accepted: &[&str]) {
        let at = self.span(&at);
        let message = format!("`{}` cannot be `{typed}`", argument.keyword);
        let mut wrong = Diagnostic::error("dataset/unknown-word", message).at(at, "not known");
        match suggest(typed, accepted.iter().copied()) {
            Some(near) => wrong = wrong.fix(format!("did you mean `{near}`?"), at, near),
            None => wrong = wrong.help(format!("it is one of {}", accepted.join(", "))),
        }
        self.report(wrong);
    }

    /// The word of an argument that takes one.
    pub fn only<'s>(&mut self, argument: &'s Argument) -> Option<(&'s str, Range<usize>)>
    where
        'a: 's,
    {
        let mut words = argument.words(self.text);
        if words.len() != 1 {
            self.count(argument, words.len(), "1");
        }
        words.pop().filter(|_| words.is_empty())
    }

    /// Reports an argument that is understood, but that the model has no place for.
    pub fn not_read(&mut self, entry: &Entry<'_>, argument: &Argument) {
        let message = format!("`{}` of {} is not read: the model has no place for it", argument.keyword, entry.name());
        self.report(Diagnostic::warning("dataset/argument-not-read", message).at(argument.span, "left out"));
    }

    /// Reports an argument without which the statement means nothing.
    pub fn missing(&mut self, entry: &Entry<'_>, keyword: &str) {
        let message = format!("{} has no `{keyword}`", entry.name());
        let missing = Diagnostic::error("dataset/missing-argument", message);
        self.report(missing.at(entry.statement.head, format!("`{keyword}` is missing")));
    }

    /// Reports an argument that is not given, and that the statement needs.
    pub fn needs(&mut self, entry: &Entry<'_>, keyword: &str) {
        if entry.statement.argument(keyword).is_none() {
            self.missing(entry, keyword);
        }
    }

    /// Reports a number of values that cannot be.
    pub fn count(&mut self, argument: &Argument, given: usize, wanted: &str) {
        let values = if wanted == "1" || wanted == "at least 1" { "value" } else { "values" };
        let message = format!("`{}` takes {wanted} {values}, not {given}", argument.keyword);
        let label = if given == 0 { "nothing is given".to_string() } else { format!("{given} given") };
        self.report(Diagnostic::error("dataset/count", message).at(argument.span, label));
    }

    /// Says what of a statement nobody has read.
    pub fn finish(&mut self, entry: &Entry<'_>) {
        for argument in entry.left().collect::<Vec<_>>() {
            self.not_read(entry, argument);
        }
    }

    /// The number of a statement, which an object needs.
    pub fn number_of(&mut self, statement: &Statement) -> Option<i64> {
        // What is no such number has been named as that.
        let given = !self.text[statement.head.range()].trim_end().ends_with('/');
        if statement.id.is_none() && !given {
            let message = format!("{} has no number", entry::name(statement));
            let missing = Diagnostic::error("dataset/no-id", message);
            self.report(
                missing.at(statement.head, "a number was expected").help(format!("write `{}/1`", statement.name)),
            );
        }
        statement.id
    }
}
