//! Cells from words, texts and expressions, and any argument by the table of its class.

use model::{Array, CellKey, Value};
use schema::{Default, Field, Kind};
use text::Diagnostic;

use super::{Builder, Entry, functions, statement::Argument, values};

impl<'a> Builder<'a> {
    /// Stores a word that the field accepts, in full or as a beginning.
    pub fn set_word(&mut self, entry: &Entry<'_>, field: &Field, argument: &Argument) {
        let Kind::Choice(words) = field.kind else { return };
        let mut chosen = Vec::new();
        for (word, at) in argument.words(self.text) {
            let typed = word.to_ascii_lowercase();
            let exact = words.iter().find(|known| **known == typed);
            let mut begins = words.iter().filter(|known| !word.is_empty() && known.starts_with(typed.as_str()));
            let only = match (begins.next(), begins.next()) {
                (Some(one), None) => Some(one),
                _ => None,
            };
            let Some(known) = exact.or(only) else {
                let capitals: Vec<_> = words.iter().map(|w| w.to_ascii_uppercase()).collect();
                let capitals: Vec<_> = capitals.iter().map(String::as_str).collect();
                return self.unknown_word(argument, (word, at), &capitals);
            };
            chosen.push((*known).to_string());
        }
        if chosen.is_empty() || chosen.len() > field.count.most {
            return self.count(argument, chosen.len(), &super::build::wanted(field.count));
        }
        let value = match chosen.as_slice() {
            [one] if field.count.most == 1 => Value::Text(one.clone()),
            _ => Value::Texts(chosen),
        };
        self.store(entry.id, field.name, value);
    }

    /// Stores a text, or texts between commas.
    pub fn set_text(&mut self, entry: &Entry<'_>, field: &Field, argument: &Argument) {
        let value = if field.count.most > 1 {
            let items = argument.items(self.text);
            Value::Texts(items.into_iter().map(|(item, _)| values::unquoted(item).to_string()).collect())
        } else {
            Value::Text(values::unquoted(&argument.value(self.text)).to_string())
        };
        self.store(entry.id, field.name, value);
    }

    /// Stores an expression, or the constants of a subroutine.
    pub fn set_function(&mut self, entry: &Entry<'_>, name: &str, argument: &Argument) {
        let text = argument.value(self.text);
        if text.is_empty() {
            return self.count(argument, 0, "1");
        }
        if let Some(constants) = user_call(&text)
            && entry.class.cell_index("user_function").is_some()
        {
            let mut values = Vec::new();
            for item in constants.split(',').map(str::trim).filter(|_| !constants.trim().is_empty()) {
                match values::parse(item) {
                    Some(n) => values.push(if n.degrees { n.value.to_radians() } else { n.value }),
                    None => return self.report(values::no_number(item, "USER", argument.span)),
                }
            }
            return self.store(entry.id, "user_function", Value::Array(Array::column(values)));
        }
        if entry.class.cell_index(name).is_none() {
            let message = format!("`{}` of {} is not `USER(...)`", argument.keyword, entry.name());
            return self.report(
                Diagnostic::error("dataset/function", message)
                    .at(argument.span, "a subroutine was expected")
                    .help("give components by their own functions"),
            );
        }
        let numbers = &self.numbers;
        let (function, missing) =
            functions::bind(&text, |statement, number| numbers.get(&(statement, number)).copied());
        for one in missing {
            let at = argument.source_of(self.text, one.at.start);
            let at = self.span(&(at..at + one.at.len()));
            let (statement, number) = (one.statement, one.number);
            if self.left_out.contains(&(statement, number)) {
                let message =
                    format!("a function of {} refers to {statement}/{number}, which is not read", entry.name());
                let unread = Diagnostic::warning("dataset/refers-to-unread", message);
                self.report(unread.at(at, "stays a number"));
                continue;
            }
            let message = format!("a function of {} refers to {statement}/{number}, which is not there", entry.name());
            let unknown = Diagnostic::error("dataset/unknown-id", message);
            self.report(unknown.at(at, format!("there is no {statement}/{number}")));
        }
        if let Some(cell) = entry.class.cell_index(name) {
            self.functions.push((CellKey::new(entry.id, cell), argument.value_span(self.file)));
        }
        self.store(entry.id, name, Value::Function(function));
    }

    /// Reads an argument by the table of the class.
    pub fn regular(&mut self, entry: &mut Entry<'a>, field: &'static Field) {
        let Some(keyword) = field.keyword else { return };
        if let Kind::Boolean(..) = field.kind {
            let given = entry.flag(keyword);
            if given || field.default != Default::None {
                self.store(entry.id, field.name, Value::Flag(given));
            }
            return;
        }
        let Some(argument) = entry.take(keyword) else { return };
        match field.kind {
            Kind::Function => self.set_function(entry, field.name, argument),
            Kind::Object(..) => self.set_objects(entry, field, argument),
            Kind::Choice(_) => self.set_word(entry, field, argument),
            Kind::Text | Kind::File => self.set_text(entry, field, argument),
            _ => self.set_numbers(entry, field.name, argument),
        }
    }
}

/// What stands in `USER(...)`, if that is all.
fn user_call(text: &str) -> Option<&str> {
    let head = text.get(..4)?;
    if !head.eq_ignore_ascii_case("USER") {
        return None;
    }
    let inner = text[4..].trim_start().strip_prefix('(')?.trim_end().strip_suffix(')')?;
    (!inner.contains(['(', ')'])).then_some(inner)
}
