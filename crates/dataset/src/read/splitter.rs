//! Splits a dataset into its statements: name and number, and what is wrong with them.

use std::ops::Range;

use text::{Diagnostic, FileId, Span, suggest};

use super::{
    arguments, contradictions,
    lines::Block,
    statement::Statement,
    vocabulary::{Found, Vocabulary},
};
use crate::statements;

/// Splits statements into arguments and says what it does not understand.
pub(crate) struct Splitter<'a> {
    pub file: FileId,
    pub text: &'a str,
    pub vocabulary: &'a Vocabulary,
    pub diagnostics: Vec<Diagnostic>,
}

impl Splitter<'_> {
    pub fn span(&self, range: &Range<usize>) -> Span {
        Span::new(self.file, range.start, range.end)
    }

    /// A statement; `None` if it is none, or none that is read.
    pub fn statement(&mut self, block: Block) -> Option<Statement> {
        let first = block.pieces.first()?.clone();
        let before = self.diagnostics.len();
        let head = &self.text[first.clone()];
        let word = head.len() - head.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_').len();
        let (typed, rest) = head.split_at(word);
        let name_range = first.start..first.start + word;
        let slash = rest.trim_start();
        let Some(behind) = slash.strip_prefix('/').filter(|_| word > 0) else {
            if !block.inactive {
                let wrong = Diagnostic::error("dataset/not-a-statement", "a statement begins with a name and a slash")
                    .at(self.span(&first), "not a statement");
                let numbered = slash.starts_with(|c: char| c.is_ascii_digit()) && word > 2;
                let named = matches!(self.vocabulary.statement(typed), Found::One(_));
                let wrong = if named && numbered {
                    let at = self.span(&(first.start..first.end - slash.len()));
                    wrong.fix(format!("write `{typed}/`"), at, format!("{typed}/"))
                } else {
                    wrong.help("a statement is written `MARKER/7, PART = 2`; a line that goes on begins with a comma")
                };
                self.diagnostics.push(wrong);
            }
            return None;
        };
        let name = self.name(typed, &name_range, block.inactive)?;
        let number = behind.trim_start();
        // What begins like a number is meant as the number of the object, whatever it goes on with.
        let begins = number.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.'));
        let length = number.find(|c: char| c == ',' || c.is_whitespace()).unwrap_or(number.len());
        let digits = if begins { length } else { 0 };
        let number_at = first.end - number.len();
        let id = self.id(&number[..digits], number_at..number_at + digits).filter(|id| {
            let numbered = statements::has_number(name);
            if !numbered {
                let message = format!("{name} has no number: a model has one");
                let at = self.span(&(number_at..number_at + digits));
                let unread = Diagnostic::warning("dataset/number-not-read", message).at(at, "left out");
                self.diagnostics.push(unread.help(format!("write `{name}/` without `{id}`")));
            }
            numbered
        });
        let head_end = if digits > 0 { number_at + digits } else { first.end - behind.len() };
        let mut lines = block.pieces.clone();
        if let Some(behind_head) = lines.first_mut() {
            behind_head.start = number_at + digits;
        }
        let arguments = arguments::split(self, name, &lines);
        let end = block.pieces.last().map_or(first.end, |piece| piece.end);
        let mut statement = Statement {
            name,
            id,
            arguments,
            comments: block.comments,
            view_name: block.view_name,
            view_units: block.view_units,
            inactive: block.inactive,
            span: self.span(&(first.start..end)),
            head: self.span(&(first.start..head_end)),
        };
        self.diagnostics.extend(contradictions::resolve(&mut statement, self.vocabulary.choices(name)));
        if statement.inactive && self.diagnostics[before..].iter().any(Diagnostic::is_error) {
            self.diagnostics.truncate(before);
            let message = format!("{name} behind comment marks is not read");
            let unread = Diagnostic::warning("dataset/inactive-not-read", message);
            self.diagnostics.push(unread.at(self.span(&first), "left out"));
            return None;
        }
        Some(statement)
    }

    fn name(&mut self, typed: &str, at: &Range<usize>, inactive: bool) -> Option<&'static str> {
        let capitals = typed.to_ascii_uppercase();
        match self.vocabulary.statement(typed) {
            Found::One(name) if self.vocabulary.reads(name) => return Some(name),
            Found::One(name) => {
                let message = format!("{name} is not read: the model holds nothing of that kind");
                let unread = Diagnostic::warning("dataset/statement-not-read", message);
                self.diagnostics.push(unread.at(self.span(at), "left out").help("what refers to it is left out too"));
            }
            Found::Many => {
                let begin: Vec<_> = self.beginning(typed).into_iter().map(|name| format!("`{name}`")).collect();
                let message = format!("`{capitals}` can stand for more than one statement");
                self.diagnostics.push(
                    Diagnostic::error("dataset/ambiguous-statement", message)
                        .at(self.span(at), "ambiguous")
                        .note(format!("it begins {}", begin.join(", "))),
                );
            }
            // A remark that looks like a statement is a remark.
            Found::None if inactive => {}
            Found::None => {
                let mut unknown =
                    Diagnostic::error("dataset/unknown-statement", format!("there is no statement `{capitals}`"))
                        .at(self.span(at), "the name of a statement was expected");
                if let Some(near) = suggest(typed, self.vocabulary.statements().iter().copied()) {
                    unknown = unknown.fix(format!("did you mean `{near}`?"), self.span(at), near);
                }
                self.diagnostics.push(unknown);
            }
        }
        None
    }

    fn beginning(&self, typed: &str) -> Vec<&'static str> {
        let capitals = typed.to_ascii_uppercase();
        self.vocabulary.statements().iter().copied().filter(|name| name.starts_with(&capitals)).collect()
    }

    fn id(&mut self, digits: &str, at: Range<usize>) -> Option<i64> {
        if digits.is_empty() {
            return None;
        }
        let id = digits.parse::<i64>().ok().filter(|id| (1..=i64::from(i32::MAX)).contains(id));
        if id.is_none() {
            let wrong = Diagnostic::error("dataset/id", format!("`{digits}` is no number of an object"))
                .at(self.span(&at), "a whole number was expected")
                .note("numbers go from 1 to 2147483647");
            self.diagnostics.push(wrong);
        }
        id
    }
}
