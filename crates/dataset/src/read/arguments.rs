//! Splits the text of a statement into its arguments. Commas part arguments as well as the values
//! of one; which it is depends on what the statement knows. In an expression the comma that leads a
//! line is no part of it, and a backslash ends it.

use std::{collections::HashMap, ops::Range};

use smallvec::SmallVec;
use text::{Diagnostic, FileId, Span, suggest};

use super::{
    contradictions,
    lines::Block,
    statement::{Argument, Statement, item_length},
    vocabulary::{Form, Found, Vocabulary},
};

/// Splits statements into arguments and says what it does not understand.
pub(crate) struct Splitter<'a> {
    pub file: FileId,
    pub text: &'a str,
    pub vocabulary: &'a Vocabulary,
    pub diagnostics: Vec<Diagnostic>,
}

impl Splitter<'_> {
    fn span(&self, range: &Range<usize>) -> Span {
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
                    .at(self.span(&first), "not a statement")
                    .help("a statement is written `MARKER/7, PART = 2`; a line that goes on begins with a comma");
                self.diagnostics.push(wrong);
            }
            return None;
        };
        let name = self.name(typed, &name_range, block.inactive)?;
        let number = behind.trim_start();
        let digits = number.len() - number.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let number_at = first.end - number.len();
        let id = self.id(&number[..digits], number_at..number_at + digits);
        let head_end = if digits > 0 { number_at + digits } else { first.end - behind.len() };
        let mut arguments = Arguments {
            splitter: self,
            statement: name,
            found: Vec::new(),
            seen: HashMap::new(),
            depth: 0,
            closed: false,
        };
        arguments.piece(number_at + digits..first.end, false);
        for piece in &block.pieces[1..] {
            arguments.piece(piece.clone(), true);
        }
        let arguments = arguments.found;
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
        self.diagnostics.extend(contradictions::resolve(&mut statement));
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
                .at(self.span(&at), "out of range")
                .note("numbers go from 1 to 2147483647");
            self.diagnostics.push(wrong);
        }
        id
    }
}

/// The arguments of one statement while they are found.
struct Arguments<'s, 'a> {
    splitter: &'s mut Splitter<'a>,
    statement: &'static str,
    found: Vec<Argument>,
    seen: HashMap<String, Span>,
    /// Parentheses open in the expression that is being read.
    depth: usize,
    /// A backslash has ended the last value.
    closed: bool,
}

impl Arguments<'_, '_> {
    /// Reads a line from behind its leading comma.
    fn piece(&mut self, piece: Range<usize>, continued: bool) {
        let text = self.splitter.text;
        let mut at = piece.start;
        // In the first line everything stands behind the head, and what leads it is a comma or nothing.
        let mut leads = continued || self.found.is_empty();
        while at < piece.end {
            let rest = &text[at..piece.end];
            let blank = rest.len() - rest.trim_start().len();
            let item = at + blank..piece.end;
            if item.is_empty() {
                return;
            }
            let open = self.found.last().map(|a| a.form).filter(|_| !self.closed);
            let new = self.keyword(&item);
            at = match (new, open) {
                (Some((word, behind)), _) => self.begin(word, behind, piece.end),
                (None, Some(Form::Text)) if leads => self.extend(item.start..piece.end),
                (None, Some(Form::Function)) => {
                    if leads && self.depth == 0 && self.whole_flag(&item) {
                        self.bare(item)
                    } else {
                        // The blank in front is part of the expression.
                        self.expression(at..piece.end)
                    }
                }
                (None, _) => self.bare(item),
            };
            leads = true;
            let rest = &text[at.min(piece.end)..piece.end];
            if rest.starts_with(',') {
                at += 1;
            }
        }
    }

    /// `WORD =` at a place: the word and where its value begins.
    fn keyword(&self, item: &Range<usize>) -> Option<(Range<usize>, usize)> {
        let text = &self.splitter.text[item.clone()];
        let word = text.len() - text.trim_start_matches(|c: char| c.is_ascii_alphanumeric() || c == '_').len();
        if word == 0 {
            return None;
        }
        let behind = text[word..].trim_start();
        let equals = behind.strip_prefix('=')?;
        Some((item.start..item.start + word, item.end - equals.len()))
    }

    /// Whether a word is nearly one that the statement knows.
    fn resembles_flag(&self, typed: &str) -> bool {
        let words = self.splitter.vocabulary.words(self.statement).iter();
        suggest(typed, words.filter(|(_, form)| *form == Form::Flag).map(|(word, _)| *word)).is_some()
    }

    /// Whether an item is a bare word that the statement knows.
    fn whole_flag(&self, item: &Range<usize>) -> bool {
        let text = &self.splitter.text[item.clone()];
        let word = text[..item_length(text)].trim().trim_end_matches('\\').trim_end();
        self.splitter.vocabulary.is_flag(self.statement, word)
    }

    /// An argument with a value; returns where the value ends.
    fn begin(&mut self, word: Range<usize>, behind: usize, end: usize) -> usize {
        let typed = &self.splitter.text[word.clone()];
        let (keyword, form, known) = self.resolve(typed, &word, false);
        let span = self.splitter.span(&word);
        let argument = Argument { keyword, form, known, parts: SmallVec::new(), span, keyword_span: span };
        self.repeated(&argument);
        self.found.push(argument);
        (self.depth, self.closed) = (0, false);
        match form {
            Form::Text => self.extend(behind..end),
            Form::Function => self.expression(behind..end),
            _ => self.value(behind..end),
        }
    }

    fn resolve(&mut self, typed: &str, at: &Range<usize>, bare: bool) -> (String, Form, bool) {
        match self.splitter.vocabulary.argument(self.statement, typed, bare) {
            Found::One((word, form)) => (word.to_string(), form, true),
            found => {
                self.unknown(typed, at, bare, found == Found::Many);
                (typed.to_ascii_uppercase(), if bare { Form::Flag } else { Form::Value }, false)
            }
        }
    }

    fn unknown(&mut self, typed: &str, at: &Range<usize>, bare: bool, many: bool) {
        let capitals = typed.to_ascii_uppercase();
        let span = self.splitter.span(at);
        let words = self.splitter.vocabulary.words(self.statement);
        if many {
            let begin: Vec<_> = words
                .iter()
                .filter(|(word, form)| word.starts_with(&capitals) && (*form == Form::Flag) == bare)
                .map(|(word, _)| format!("`{word}`"))
                .collect();
            let message = format!("`{capitals}` can stand for more than one argument of {}", self.statement);
            self.splitter.diagnostics.push(
                Diagnostic::error("dataset/ambiguous-argument", message)
                    .at(span, "ambiguous")
                    .note(format!("it begins {}", begin.join(", "))),
            );
            return;
        }
        let message = format!("{} has no argument `{capitals}`", self.statement);
        let mut unknown = Diagnostic::error("dataset/unknown-argument", message).at(span, "not known");
        // The same word in the other form, or one that looks like it.
        let other = words.iter().find(|(word, _)| *word == capitals);
        if let Some((word, _)) = other {
            let form = if bare { format!("`{word} = ...`") } else { format!("`{word}`, without a value") };
            unknown = unknown.help(format!("it is written {form}"));
        } else if let Some(near) = suggest(typed, words.iter().map(|(word, _)| *word)) {
            unknown = unknown.fix(format!("did you mean `{near}`?"), span, near);
        }
        self.splitter.diagnostics.push(unknown);
    }

    fn repeated(&mut self, argument: &Argument) {
        // A surface has a row of values for each value of its second axis.
        let several = self.statement == "SPLINE" && argument.keyword == "Y";
        if let Some(earlier) = self.seen.insert(argument.keyword.clone(), argument.keyword_span)
            && !several
        {
            let message = format!("`{}` is given twice", argument.keyword);
            self.splitter.diagnostics.push(
                Diagnostic::warning("dataset/repeated-argument", message)
                    .at(argument.keyword_span, "this one counts")
                    .label(earlier, "given here first")
                    .help("remove one of them"),
            );
        }
    }

    /// Adds a range to the last argument.
    fn push(&mut self, part: Range<usize>) {
        let file = self.splitter.file;
        let trimmed = self.splitter.text[part.clone()].trim_end();
        let part = part.start..part.start + trimmed.len();
        if let Some(last) = self.found.last_mut() {
            if !trimmed.trim_start().is_empty() {
                last.span = last.span.to(Span::new(file, part.start, part.end));
            }
            last.parts.push(part);
        }
    }

    /// The rest of the line is a text.
    fn extend(&mut self, part: Range<usize>) -> usize {
        let end = part.end;
        self.push(part);
        end
    }

    /// A value up to the next comma; returns where it ends.
    fn value(&mut self, part: Range<usize>) -> usize {
        let text = &self.splitter.text[part.clone()];
        let length = item_length(text);
        let value = text[..length].trim_end();
        let ended = value.ends_with('\\');
        self.push(part.start..part.start + value.trim_end_matches('\\').len());
        self.closed = ended;
        part.start + length
    }

    /// An expression up to its backslash, or to a comma that is not within it.
    fn expression(&mut self, part: Range<usize>) -> usize {
        let text = &self.splitter.text[part.clone()];
        for (at, byte) in text.bytes().enumerate() {
            match byte {
                b'(' => self.depth += 1,
                b')' => self.depth = self.depth.saturating_sub(1),
                b'\\' => {
                    self.push(part.start..part.start + at);
                    self.closed = true;
                    return part.start + at + 1;
                }
                b',' if at > 0 && self.depth == 0 => {
                    let rest = &text[at + 1..];
                    let next = part.end - rest.trim_start().len()..part.end;
                    if !next.is_empty() && (self.keyword(&next).is_some() || self.whole_flag(&next)) {
                        self.push(part.start..part.start + at);
                        self.closed = true;
                        return part.start + at;
                    }
                }
                _ => {}
            }
        }
        self.push(part.clone());
        part.end
    }

    /// Something without a keyword: a bare word, or one more value of the argument before it.
    fn bare(&mut self, item: Range<usize>) -> usize {
        let text = &self.splitter.text[item.clone()];
        let length = item_length(text);
        let whole = text[..length].trim_end();
        let typed = whole.trim_end_matches('\\').trim_end();
        let word = typed.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
            && typed.starts_with(|c: char| c.is_ascii_alphabetic());
        let flag = word && self.splitter.vocabulary.is_flag(self.statement, typed);
        let open = !self.closed && self.found.last().is_some_and(|a| a.form == Form::Value);
        let range = item.start..item.start + typed.len();
        if open && !flag && !(word && self.resembles_flag(typed)) {
            self.push(range);
            self.closed = whole.ends_with('\\');
        } else if !typed.is_empty() {
            let (keyword, form, known) = self.resolve(typed, &range, true);
            let span = self.splitter.span(&range);
            self.found.push(Argument { keyword, form, known, parts: SmallVec::new(), span, keyword_span: span });
            self.closed = true;
        }
        item.start + length.max(1)
    }
}
