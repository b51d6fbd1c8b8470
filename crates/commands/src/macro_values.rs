//! What a call gives to the parameters of a macro: held against their types, and as the text that
//! takes their places.

use expressions::glob;
use model::{ObjectId, Value, quoted};
use schema::{Class, Registry};
use syntax::command::{Argument, Expression, ExpressionKind, Item, ItemKind, quote};
use text::{Diagnostic, Span};

use crate::{
    Interpreter,
    call::Call,
    evaluation, lookup,
    macro_text::{Bound, Formal},
    values::text_of,
    words::{Match, is_pattern, match_word},
};

type Outcome<T> = Result<T, Vec<Diagnostic>>;

/// What a type of a parameter asks for.
pub(crate) enum Wanted<'a> {
    /// No type is given, or one of things that Flexure does not have: anything goes.
    Anything,
    Integer,
    /// Also each number of a location or an orientation.
    Real,
    /// A text or a file, put in without quotes.
    Text,
    /// A run-time function, put in as typed.
    Function,
    Word(Vec<&'a str>),
    /// An object that exists, and a pattern for its name.
    Object(&'a str, Option<&'a str>),
    New(&'static Class),
    /// A word that is no type.
    Unknown,
}

/// Types that are no classes of objects. Some classes bear the same names; in a macro they mean these.
pub(crate) const PLAIN_TYPES: [&str; 8] =
    ["real", "integer", "string", "function", "location", "orientation", "list(...)", "file(...)"];

impl<'a> Wanted<'a> {
    /// The meaning of what is written behind `t=`, in lower case.
    pub(crate) fn of(kind: &'a str, registry: &Registry) -> Wanted<'a> {
        let (word, inner) = match kind.split_once('(') {
            Some((word, inner)) => (word.trim(), Some(inner.strip_suffix(')').unwrap_or(inner))),
            None => (kind, None),
        };
        let is_class = |name: &str| registry.classes.iter().any(|c| c.is(name));
        match (word, inner) {
            ("", _) => Wanted::Anything,
            ("integer", _) => Wanted::Integer,
            ("real" | "location" | "orientation", _) => Wanted::Real,
            ("string" | "file", _) => Wanted::Text,
            ("function", _) => Wanted::Function,
            ("list", Some(words)) => Wanted::Word(words.split(',').map(str::trim).collect()),
            ("any" | "entity" | "object", pattern) => Wanted::Object("any", pattern),
            (class, pattern) if is_class(class) => Wanted::Object(class, pattern),
            (class, _) => match class.strip_prefix("new_") {
                Some(new) if registry.class(new).is_some() => registry.class(new).map_or(Wanted::Unknown, Wanted::New),
                Some("any" | "entity" | "object") => Wanted::Anything,
                Some(family) if is_class(family) => Wanted::Anything,
                _ => Wanted::Unknown,
            },
        }
    }
}

/// One value of an argument: the text for it, and how many values it counts for.
type Actual = (String, usize);

impl Interpreter {
    /// The text that stands for a parameter.
    pub(crate) fn actual(&mut self, formal: &Formal, call: &Call, argument: &Argument) -> Outcome<String> {
        let wanted = Wanted::of(&formal.kind, &self.registry);
        let (mut texts, mut count, mut errors) = (Vec::new(), 0, Vec::new());
        for item in &argument.values {
            match self.actual_item(formal, &wanted, call, item) {
                Ok((text, values)) => {
                    texts.push(text);
                    count += values;
                }
                Err(mut more) => errors.append(&mut more),
            }
        }
        if !errors.is_empty() {
            return Err(errors);
        }
        check_count(formal, argument, count)?;
        Ok(texts.join(", "))
    }

    fn actual_item(&mut self, formal: &Formal, wanted: &Wanted, call: &Call, item: &Item) -> Outcome<Actual> {
        let typed = call.program.word(item.span);
        if let ItemKind::Expression(expression) = &item.kind {
            return self.actual_expression(formal, wanted, expression, typed, item.span);
        }
        // A quoted name that is not plain keeps its quotes, so that dots in it are no path.
        let name = match &item.kind {
            ItemKind::Text(text) if !text.contains('.') && !is_pattern(text) => quoted(text),
            ItemKind::Text(text) => text.clone(),
            _ => typed.to_string(),
        };
        match (wanted, &item.kind) {
            (Wanted::Integer | Wanted::Real, ItemKind::Number { value, unit }) => {
                if matches!(wanted, Wanted::Integer) && unit.is_some() {
                    return Err(vec![not_whole(formal, item.span, typed)]);
                }
                check_number(formal, wanted, *value, item.span)?;
                Ok((typed.to_string(), 1))
            }
            (Wanted::Integer | Wanted::Real, kind) => Err(vec![self.no_number(formal, kind, typed, item.span)]),
            (Wanted::Word(words), ItemKind::Text(text)) => Ok((choice(formal, words, text, item.span)?, 1)),
            (Wanted::Word(words), _) => Ok((choice(formal, words, typed, item.span)?, 1)),
            (Wanted::Object(class, pattern), _) => {
                let found = self.objects_given(formal, (class, *pattern), &name, item.span)?;
                Ok((self.names_of(&found), found.len()))
            }
            (Wanted::New(class), _) => Ok((self.name_given(class, &name, item.span)?, 1)),
            // Quotes of a text that is used inside quotes would end them.
            (Wanted::Text, ItemKind::Text(text)) => Ok((text.clone(), 1)),
            (Wanted::Anything, ItemKind::Number { value, .. }) => {
                check_number(formal, wanted, *value, item.span)?;
                Ok((typed.to_string(), 1))
            }
            _ => Ok((typed.to_string(), 1)),
        }
    }

    /// An expression is put in as typed, to be kept where it fills a cell; it is evaluated for the
    /// check alone. EVAL is different: it asks for the value of now, and every other command takes it
    /// so while it is read. The text of a macro is read later, after commands of the macro may have
    /// changed what EVAL reads, and once for each place of the parameter. So the value goes into the
    /// text: of the whole, or of the parts in EVAL. (What Adams says of macros is that values are
    /// passed as they are entered and never changed; a value that is another at each use would be.)
    fn actual_expression(
        &mut self,
        formal: &Formal,
        wanted: &Wanted,
        expression: &Expression,
        typed: &str,
        span: Span,
    ) -> Outcome<Actual> {
        let folds = has_eval(expression);
        if !folds && matches!(wanted, Wanted::Anything | Wanted::Text | Wanted::Function | Wanted::Unknown) {
            return Ok((typed.to_string(), 1));
        }
        let outcome = evaluation::evaluate(expression, &self.database, &self.sources, &self.world, None)?;
        // Without an expression to keep, the value is what is given.
        let kept = outcome.kept.as_ref().map(|bound| {
            if folds { format!("({})", evaluation::print(bound, &self.database)) } else { typed.to_string() }
        });
        let value = &outcome.value;
        let plain = || text_of(value, &self.database);
        match wanted {
            Wanted::Integer | Wanted::Real => {
                // A text in the place of a number is read as an expression where it is used.
                if let Value::Text(text) = value {
                    return Ok((kept.unwrap_or_else(|| format!("({text})")), 1));
                }
                let Some(numbers) = value.as_numbers() else {
                    return Err(vec![not_a_number(formal, span, &format!("`{}`", plain()))]);
                };
                numbers.iter().try_for_each(|x| check_number(formal, wanted, *x, span))?;
                let whole = |x: &f64| format!("{x:.0}");
                let values = || match wanted {
                    Wanted::Integer => numbers.iter().map(whole).collect::<Vec<_>>().join(", "),
                    _ => plain(),
                };
                Ok((kept.unwrap_or_else(values), numbers.len()))
            }
            Wanted::Word(words) => {
                let word = choice(formal, words, &plain(), span)?;
                Ok((kept.unwrap_or(word), 1))
            }
            Wanted::Object(class, pattern) => {
                let names = match value {
                    Value::Nothing => return Ok((kept.unwrap_or_else(plain), 1)),
                    Value::Text(name) => vec![name.clone()],
                    Value::Texts(names) => names.clone(),
                    other => other.objects().iter().map(|id| self.database.full_name(*id)).collect(),
                };
                let mut found = Vec::new();
                for name in names {
                    found.extend(self.objects_given(formal, (class, *pattern), &name, span)?);
                }
                Ok((kept.unwrap_or_else(|| self.names_of(&found)), found.len()))
            }
            Wanted::New(class) => {
                let name = plain();
                let name = self.name_given(class, &name, span)?;
                Ok((kept.unwrap_or(name), 1))
            }
            Wanted::Text => Ok((kept.unwrap_or_else(plain), 1)),
            Wanted::Anything | Wanted::Function | Wanted::Unknown => {
                let value = || if let Value::Text(text) = value { quote(text) } else { plain() };
                Ok((kept.unwrap_or_else(value), 1))
            }
        }
    }

    fn names_of(&self, found: &[ObjectId]) -> String {
        found.iter().map(|id| self.database.full_name(*id)).collect::<Vec<_>>().join(", ")
    }

    /// The objects that a name means, or a pattern where the parameter takes several.
    fn objects_given(
        &mut self,
        formal: &Formal,
        (class, pattern): (&str, Option<&str>),
        name: &str,
        span: Span,
    ) -> Outcome<Vec<ObjectId>> {
        let (database, registry) = (&self.database, &self.registry);
        let many = formal.most > 1 && is_pattern(name);
        let mut found = if many {
            lookup::find_all(database, registry, name, class, span).map_err(|e| vec![e])?
        } else {
            vec![lookup::find(database, registry, name, class, span).map_err(|e| vec![e])?]
        };
        if let Some(pattern) = pattern {
            found.retain(|id| glob(pattern, &database.object(*id).name));
        }
        if let (true, Some(pattern)) = (found.is_empty(), pattern) {
            return Err(vec![
                Diagnostic::error("name/not-found", format!("`{name}` does not match `{pattern}`"))
                    .at(span, "not allowed here")
                    .adams(format!("No {} named '{name}' was found.", lookup::word_of(registry, class))),
            ]);
        }
        if many && found.len() > 1 {
            let said = lookup::several(database, registry, name, class, &found).at(span, "");
            self.report.diagnostics.push(said);
        }
        Ok(found)
    }

    /// The full name of an object to be made, which must not be there.
    fn name_given(&self, class: &'static Class, name: &str, span: Span) -> Outcome<String> {
        let place = lookup::new_name(&self.database, &self.registry, class, name, span).map_err(|e| vec![e])?;
        if let Some(other) = self.database.child_of_kind(place.parent, &place.name, class) {
            return Err(vec![lookup::taken(&self.database, class, name, other, span)]);
        }
        let parent = place.parent.map(|p| self.database.full_name(p)).unwrap_or_default();
        Ok(format!("{parent}.{}", quoted(&place.name)))
    }

    fn no_number(&self, formal: &Formal, kind: &ItemKind, typed: &str, span: Span) -> Diagnostic {
        match kind {
            ItemKind::Text(text) => {
                let error = not_a_number(formal, span, &format!("the text \"{text}\""));
                let number = text.trim().parse::<f64>().is_ok();
                if number { error.fix("a number has no quotes", span, text.trim()) } else { error }
            }
            _ if lookup::search_one(&self.database, typed, "variable").is_some() => {
                let error = not_a_number(formal, span, &format!("the word `{typed}`"));
                error.fix("a variable is referred to in parentheses", span, format!("({typed})"))
            }
            _ => not_a_number(formal, span, &format!("the word `{typed}`")),
        }
    }
}

/// Whether a part of an expression is in EVAL.
fn has_eval(expression: &Expression) -> bool {
    let any = |parts: &[Expression]| parts.iter().any(has_eval);
    match &expression.kind {
        ExpressionKind::Call { function, arguments, .. } => function.eq_ignore_ascii_case("eval") || any(arguments),
        ExpressionKind::Array(items) | ExpressionKind::Tuple(items) | ExpressionKind::Row(items) => any(items),
        ExpressionKind::Index(inner, indices) => has_eval(inner) || any(indices),
        ExpressionKind::Attribute(inner, _) | ExpressionKind::Unary(_, inner) => has_eval(inner),
        ExpressionKind::Binary(_, a, b) => has_eval(a) || has_eval(b),
        ExpressionKind::Conditional(a, b, c) => has_eval(a) || has_eval(b) || has_eval(c),
        ExpressionKind::Number { .. } | ExpressionKind::Text(_) | ExpressionKind::Name(_) | ExpressionKind::Broken => {
            false
        }
    }
}

fn check_count(formal: &Formal, argument: &Argument, count: usize) -> Outcome<()> {
    if count >= formal.least.max(1) && count <= formal.most {
        return Ok(());
    }
    let wanted = match (formal.least, formal.most) {
        (a, b) if a == b => a.to_string(),
        (a, usize::MAX) => format!("at least {}", a.max(1)),
        (a, b) => format!("{a} to {b}"),
    };
    let values = if wanted == "1" { "value" } else { "values" };
    Err(vec![
        Diagnostic::error("command/wrong-count", format!("`{}` wants {wanted} {values}, not {count}", formal.name))
            .at(argument.value_span, format!("{count} given"))
            .adams(format!("{wanted} values are required for '{}'.", formal.name)),
    ])
}

fn choice(formal: &Formal, words: &[&str], typed: &str, span: Span) -> Outcome<String> {
    match match_word(words.iter().copied(), typed) {
        Match::One(i) => Ok(words[i].to_string()),
        _ => Err(vec![
            Diagnostic::error("command/unknown-word", format!("`{typed}` is not a choice for `{}`", formal.name))
                .at(span, format!("wants {}", words.join(", ")))
                .adams(format!("'{typed}' is not a valid choice for '{}'.", formal.name)),
        ]),
    }
}

fn not_a_number(formal: &Formal, span: Span, found: &str) -> Diagnostic {
    Diagnostic::error("value/not-a-number", format!("`{}` wants a number, not {found}", formal.name))
        .at(span, "not a number")
        .adams("Invalid input. Enter a real number.")
}

fn not_whole(formal: &Formal, span: Span, found: &str) -> Diagnostic {
    Diagnostic::error("value/not-integer", format!("`{}` wants a whole number", formal.name))
        .at(span, format!("this is {found}"))
        .adams("Invalid input. Enter an integer.")
}

/// Holds one number against the type and the bounds of a parameter.
fn check_number(formal: &Formal, wanted: &Wanted, value: f64, span: Span) -> Outcome<()> {
    if matches!(wanted, Wanted::Integer) && (value.fract() != 0.0 || !value.is_finite()) {
        return Err(vec![not_whole(formal, span, &value.to_string())]);
    }
    for (bound, limit) in &formal.bounds {
        let (holds, sign) = match bound {
            Bound::Above => (value > *limit, ">"),
            Bound::AtLeast => (value >= *limit, ">="),
            Bound::Below => (value < *limit, "<"),
            Bound::AtMost => (value <= *limit, "<="),
        };
        if !holds {
            return Err(vec![
                Diagnostic::error("value/out-of-range", format!("`{}` must be {sign} {limit}", formal.name))
                    .at(span, format!("this is {value}"))
                    .adams(format!("The value of '{}' must be {sign} {limit}.", formal.name)),
            ]);
        }
    }
    Ok(())
}
