//! Splits the text of a statement into its arguments. Commas part arguments as well as the values
//! of one; which it is depends on what the statement knows. In an expression the comma that leads a
//! line is no part of it, and a backslash ends it.

use std::{collections::HashMap, ops::Range};

use smallvec::SmallVec;
use text::{Diagnostic, Span, suggest};

use super::{
    splitter::Splitter,
    statement::{Argument, item_length},
    vocabulary::{Form, Found},
};

/// The arguments of a statement from its lines, the first of them from behind its head.
pub(super) fn split(splitter: &mut Splitter<'_>, statement: &'static str, lines: &[Range<usize>]) -> Vec<Argument> {
    let mut arguments =
        Arguments { splitter, statement, found: Vec::new(), seen: HashMap::new(), depth: 0, closed: false };
    for (index, line) in lines.iter().enumerate() {
        arguments.piece(line.clone(), index > 0);
    }
    arguments.found
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

    /// Where in a value the next argument begins, although no comma stands before it; that is reported.
    fn run_on(&mut self, part: &Range<usize>) -> Option<usize> {
        let text = &self.splitter.text[part.clone()];
        let before = text[..text.find('=')?].trim_end();
        let begin = before.trim_end_matches(|c: char| c.is_ascii_alphanumeric() || c == '_').len();
        let (value, word) = before.split_at(begin);
        let alone = value.ends_with(char::is_whitespace) && !value.trim().is_empty();
        let found = self.splitter.vocabulary.argument(self.statement, word, false);
        if !alone || value.contains('"') || value.trim_end().ends_with([',', '\\']) || !matches!(found, Found::One(_)) {
            return None;
        }
        let at = self.splitter.span(&(part.start + begin..part.start + before.len()));
        let missing = Diagnostic::error("dataset/missing-comma", format!("there is no comma before `{word}`"));
        let written = format!(", {word}");
        let missing = missing.at(at, "an argument begins here").fix(format!("write `{written}`"), at, written);
        self.splitter.diagnostics.push(missing);
        Some(begin)
    }

    /// Where a backslash ends a value before another argument of the same line. Other backslashes are
    /// those of paths.
    fn behind_backslash(&self, text: &str) -> Option<usize> {
        let (at, _) = text.match_indices('\\').find(|(at, _)| {
            let behind = text[at + 1..].trim_start();
            let word = behind.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(behind.len());
            let found = self.splitter.vocabulary.argument(self.statement, &behind[..word], false);
            behind[word..].trim_start().starts_with('=') && matches!(found, Found::One(_))
        })?;
        Some(at)
    }

    /// A value up to the next comma; returns where it ends.
    fn value(&mut self, part: Range<usize>) -> usize {
        let text = &self.splitter.text[part.clone()];
        let length = item_length(text);
        if text[..length].matches('"').count() % 2 == 1 {
            let begin = part.start + length - text[..length].trim_start().len();
            let at = self.splitter.span(&(begin..part.start + text[..length].trim_end().len()));
            let open = Diagnostic::error("dataset/open-quote", "a quote is opened and not closed");
            self.splitter.diagnostics.push(open.at(at, "taken to the end of the line").help("close it with `\"`"));
        }
        if let Some(cut) = self.behind_backslash(&text[..length]) {
            self.push(part.start..part.start + text[..cut].trim_end().len());
            self.closed = true;
            return part.start + cut + 1;
        }
        if let Some(cut) = self.run_on(&(part.start..part.start + length)) {
            self.push(part.start..part.start + cut);
            self.closed = true;
            return part.start + cut;
        }
        let value = text[..length].trim_end();
        let ended = value.ends_with('\\');
        self.push(part.start..part.start + value.trim_end_matches('\\').len());
        self.closed = ended;
        part.start + length
    }

    /// An expression up to its backslash, or to a comma that is not within it.
    fn expression(&mut self, mut part: Range<usize>) -> usize {
        let run_on = self.run_on(&part);
        part.end = run_on.map_or(part.end, |cut| part.start + cut);
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
        self.closed |= run_on.is_some();
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
