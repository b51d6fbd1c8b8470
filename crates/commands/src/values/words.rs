//! Values that are words: choices, switches, texts, functions.

use std::borrow::Cow;

use model::{Source, Value};
use schema::Field;
use syntax::command::{Argument, Item, ItemKind};
use text::Diagnostic;

use super::{Draft, Errors, Reader, text_of};
use crate::{
    evaluation, function_text,
    words::{Match, did_you_mean, match_word},
};

impl Reader<'_> {
    pub(super) fn plain<'i>(&'i self, item: &'i Item) -> Result<Cow<'i, str>, Errors> {
        match &item.kind {
            ItemKind::Text(text) => Ok(Cow::Borrowed(text)),
            ItemKind::Word | ItemKind::Number { .. } => Ok(Cow::Borrowed(self.word(item.span))),
            ItemKind::Expression(e) => {
                let outcome = evaluation::evaluate(e, self.database, self.sources, self.world, self.owner)?;
                Ok(Cow::Owned(text_of(&outcome.value, self.database)))
            }
        }
    }

    pub(super) fn boolean(&mut self, field: &Field, argument: &Argument, yes: &str, no: &str) -> Result<Draft, Errors> {
        let [item] = argument.values.as_slice() else {
            return Err(vec![Self::count_error(field, argument, argument.values.len())]);
        };
        let typed = self.plain(item)?;
        let flag = match match_word([yes, no], &typed) {
            Match::One(i) => Some(i == 0),
            _ => match typed.to_ascii_lowercase().as_str() {
                "yes" | "on" | "true" | "1" => Some(true),
                "no" | "off" | "false" | "0" => Some(false),
                _ => None,
            },
        };
        flag.map(|f| Draft::literal(Value::Flag(f))).ok_or_else(|| {
            vec![
                Diagnostic::error("command/unknown-word", format!("`{}` is `{yes}` or `{no}`", field.name))
                    .at(item.span, format!("`{typed}` is neither"))
                    .adams(format!("'{typed}' is not a valid choice for '{}'.", field.name)),
            ]
        })
    }

    pub(super) fn choices(
        &mut self,
        field: &Field,
        argument: &Argument,
        words: &[&'static str],
    ) -> Result<Draft, Errors> {
        let mut chosen = Vec::new();
        for item in &argument.values {
            let typed = self.plain(item)?;
            match match_word(words.iter().copied(), &typed) {
                Match::One(i) => chosen.push(words[i].to_string()),
                Match::Many(found) => {
                    let names: Vec<&str> = found.iter().map(|i| words[*i]).collect();
                    return Err(vec![
                        Diagnostic::error(
                            "command/ambiguous-abbreviation",
                            format!("`{typed}` may stand for {}", names.join(", ")),
                        )
                        .at(item.span, "ambiguous")
                        .adams(format!("'{typed}' is ambiguous.")),
                    ]);
                }
                Match::None => {
                    let error = Diagnostic::error(
                        "command/unknown-word",
                        format!("`{typed}` is not a choice for `{}`", field.name),
                    )
                    .at(item.span, format!("wants {}", words.join(", ")))
                    .adams(format!("'{typed}' is not a valid choice for '{}'.", field.name));
                    let words = words.iter().copied();
                    let guessed = did_you_mean(error, words, &typed, item.span, str::to_string);
                    return Err(vec![guessed.unwrap_or_else(|error| error)]);
                }
            }
        }
        Self::text_value(field, argument, chosen)
    }

    fn text_value(field: &Field, argument: &Argument, mut texts: Vec<String>) -> Result<Draft, Errors> {
        if texts.len() > field.count.most || texts.len() < field.count.least {
            return Err(vec![Self::count_error(field, argument, texts.len())]);
        }
        let value =
            if field.count.most == 1 { Value::Text(texts.pop().unwrap_or_default()) } else { Value::Texts(texts) };
        Ok(Draft::literal(value))
    }

    pub(super) fn texts(&mut self, field: &Field, argument: &Argument) -> Result<Draft, Errors> {
        let mut texts = Vec::new();
        let mut kept = None;
        let mut reads = Vec::new();
        for item in &argument.values {
            if let Some(outcome) = self.evaluate(item)? {
                match &outcome.value {
                    Value::Texts(list) => texts.extend(list.iter().cloned()),
                    other => texts.push(text_of(other, self.database)),
                }
                if argument.values.len() == 1 && !outcome.reads.is_empty() {
                    kept = outcome.kept;
                    reads = outcome.reads;
                }
            } else {
                texts.push(self.plain(item)?.into_owned());
            }
        }
        let mut draft = Self::text_value(field, argument, texts)?;
        if let Some(expression) = kept {
            draft.source = Source::Expression(Box::new(expression));
            draft.reads = reads;
        }
        Ok(draft)
    }

    pub(super) fn function(&mut self, _field: &Field, argument: &Argument) -> Result<Draft, Errors> {
        let mut text = String::new();
        for item in &argument.values {
            match self.evaluate(item)? {
                Some(outcome) => text.push_str(&text_of(&outcome.value, self.database)),
                None => text.push_str(&self.plain(item)?),
            }
        }
        let (bound, unknown) = function_text::bind(self.database, &text);
        for trouble in unknown {
            self.warnings.push(
                trouble
                    .at(argument.value_span, "kept as text")
                    .note("it must exist when the model is simulated, and does not follow a renaming"),
            );
        }
        Ok(Draft::literal(Value::Function(bound)))
    }
}
