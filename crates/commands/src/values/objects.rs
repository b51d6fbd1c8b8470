//! Values that name objects.

use model::{ObjectId, Source, Value};
use schema::Field;
use smallvec::{SmallVec, smallvec};
use syntax::command::{Argument, ItemKind};
use text::{Diagnostic, Span};

use super::{Draft, Errors, Reader};
use crate::{lookup, words::is_pattern};

/// The objects a name means, and what is to be said of them.
type Named = (SmallVec<[ObjectId; 1]>, Option<Diagnostic>);

impl Reader<'_> {
    pub(super) fn objects(&mut self, field: &Field, argument: &Argument, wanted: &str) -> Result<Draft, Errors> {
        let mut found: SmallVec<[ObjectId; 1]> = SmallVec::new();
        let mut kept = None;
        let mut reads = Vec::new();
        let many = field.count.most > 1;
        for item in &argument.values {
            if let Some(outcome) = self.evaluate(item)? {
                match &outcome.value {
                    Value::Nothing => {}
                    Value::Text(name) => {
                        let (ids, said) = self.named(name, wanted, many, item.span)?;
                        self.warnings.extend(said);
                        found.extend(ids);
                    }
                    Value::Texts(names) => {
                        for name in names {
                            let (ids, said) = self.named(name, wanted, many, item.span)?;
                            self.warnings.extend(said);
                            found.extend(ids);
                        }
                    }
                    other => {
                        let objects = other.objects();
                        if objects.is_empty() {
                            return Err(vec![self.not_an_object(field, wanted, item.span)]);
                        }
                        for object in objects {
                            found.push(self.as_wanted(object, wanted, item.span)?);
                        }
                    }
                }
                if argument.values.len() == 1 {
                    kept = outcome.kept;
                    reads = outcome.reads;
                }
            } else if let ItemKind::Number { .. } = item.kind {
                return Err(vec![self.not_an_object(field, wanted, item.span)]);
            } else {
                let name = self.plain(item)?;
                if name.eq_ignore_ascii_case("none") && found.is_empty() && argument.values.len() == 1 {
                    return Ok(Draft::literal(Value::Nothing));
                }
                let (ids, said) = self.named(&name, wanted, many, item.span)?;
                self.warnings.extend(said);
                found.extend(ids);
            }
        }
        if found.len() > field.count.most {
            return Err(vec![Self::count_error(field, argument, found.len())]);
        }
        self.of_own_model(field, argument, &found)?;
        let value = match (many, found.as_slice()) {
            (false, [one]) => Value::Object(*one),
            (false, _) => Value::Nothing,
            (true, _) => Value::Objects(found.into_vec()),
        };
        let source = kept.map_or(Source::Literal, |e| Source::Expression(Box::new(e)));
        Ok(Draft { value, source, reads })
    }

    /// The objects a name means, and what is said of a pattern that means several.
    fn named(&self, name: &str, wanted: &str, many: bool, span: Span) -> Result<Named, Errors> {
        let mut said = None;
        let outcome = if many && is_pattern(name) {
            let found = lookup::find_all(self.database, self.registry, name, wanted, span);
            if let Ok(found) = &found
                && found.len() > 1
            {
                said = Some(lookup::several(self.database, self.registry, name, wanted, found).at(span, ""));
            }
            found.map(SmallVec::from_vec)
        } else {
            lookup::find(self.database, self.registry, name, wanted, span).map(|id| smallvec![id])
        };
        outcome.map(|found| (found, said)).map_err(|e| vec![e])
    }

    /// Forces and constraints act within their model.
    fn of_own_model(&self, field: &Field, argument: &Argument, found: &[ObjectId]) -> Result<(), Errors> {
        let acts = |class: &schema::Class| class.is("force") || class.is("constraint");
        let Some(owner) = self.owner.filter(|o| self.database.get(*o).is_some_and(|o| acts(o.class))) else {
            return Ok(());
        };
        let Some(own) = self.database.model_of(owner) else { return Ok(()) };
        for id in found {
            let Some(other) = self.database.model_of(*id).filter(|other| *other != own) else { continue };
            let name = |id| self.database.full_name(id);
            let word = self.database.object(owner).class.word.to_lowercase();
            return Err(vec![
                Diagnostic::error(
                    "name/other-model",
                    format!("`{}` belongs to the model `{}`, the {word} to `{}`", name(*id), name(other), name(own)),
                )
                .at(argument.value_span, "of another model")
                .help(format!("choose a `{}` of `{}`", field.name, name(own)))
                .adams("Invalid input. Enter '.' or an entity name."),
            ]);
        }
        Ok(())
    }

    fn as_wanted(&self, id: ObjectId, wanted: &str, span: Span) -> Result<ObjectId, Errors> {
        let class = self.database.object(id).class;
        if class.is(wanted) {
            return Ok(id);
        }
        let word = lookup::word_of(self.registry, wanted);
        let name = self.database.full_name(id);
        Err(vec![
            Diagnostic::error(
                "name/wrong-kind",
                format!("`{name}` is a {}, not a {}", class.word.to_lowercase(), word.to_lowercase()),
            )
            .at(span, format!("a {} is wanted", word.to_lowercase()))
            .adams(format!("No {word} named '{name}' was found.")),
        ])
    }

    fn not_an_object(&self, field: &Field, wanted: &str, span: Span) -> Diagnostic {
        let word = lookup::word_of(self.registry, wanted).to_lowercase();
        Diagnostic::error("value/not-an-object", format!("`{}` wants the name of a {word}", field.name))
            .at(span, "names nothing")
            .adams("Invalid input. Enter '.' or an entity name.")
    }
}
