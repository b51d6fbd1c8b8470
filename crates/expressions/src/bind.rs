//! From the tree of what was typed to an expression that holds its objects by reference.

use std::ops::Range;

use model::{BinaryOperator, Expression, Node, UnaryOperator, Value};
use syntax::command::{self, ExpressionKind};
use text::{Diagnostic, Span};

use crate::{
    Evaluated, Scope, attributes, evaluate,
    functions::{self, Function},
    names::{Reached, Steps, Unknown, nearest, reach},
    print::{normalised, number_text},
    scope::{Outcome, problem},
};

/// What an expression became.
#[derive(Clone, Debug, PartialEq)]
pub enum Bound {
    /// To be kept and evaluated again when what it reads changes.
    Expression(Expression),
    /// The whole was `EVAL(...)` or a function of the moment: only its value is kept.
    Value(Evaluated),
}

/// Binds an expression: names become objects, parts in EVAL become literals. The list of errors is
/// empty if the text was not understood, which the parser has reported already.
pub fn bind(expression: &command::Expression, scope: &Scope) -> Result<Bound, Vec<Diagnostic>> {
    let mut binder = Binder { scope: *scope, whole: expression.span, errors: Vec::new() };
    if let ExpressionKind::Call { function, arguments, .. } = &expression.kind {
        let momentary = functions::find(function).is_some_and(|f| f.momentary);
        let eval = function.eq_ignore_ascii_case("eval") && arguments.len() == 1;
        if eval || momentary {
            let value = binder.evaluated(expression);
            return match value {
                Some(value) => Ok(Bound::Value(value)),
                None => Err(binder.errors),
            };
        }
    }
    match binder.node(expression) {
        Some(root) if binder.errors.is_empty() => Ok(Bound::Expression(Expression { root })),
        _ => Err(binder.errors),
    }
}

struct Binder<'a> {
    scope: Scope<'a>,
    whole: Span,
    errors: Vec<Diagnostic>,
}

impl Binder<'_> {
    /// Binds one node; `None` when it or something below it is wrong. Errors are collected, so that
    /// all of them are reported.
    fn node(&mut self, expression: &command::Expression) -> Option<Node> {
        let span = expression.span;
        Some(match &expression.kind {
            ExpressionKind::Number { value, unit } => self.number(*value, unit.as_deref(), span)?,
            ExpressionKind::Text(text) => Node::Text(text.clone()),
            ExpressionKind::Name(name) => self.name(name, span)?,
            ExpressionKind::Call { function, function_span, arguments } => {
                return self.call(function, *function_span, arguments, expression);
            }
            ExpressionKind::Index(inner, indices) => {
                let inner = self.node(inner);
                let indices = self.nodes(indices);
                Node::Index(Box::new(inner?), indices?)
            }
            ExpressionKind::Attribute(inner, names) => {
                let inner = self.node(inner)?;
                // `f(x).a.b` arrives as one name.
                model::split_name(names)
                    .into_iter()
                    .fold(inner, |node, name| Node::Attribute(Box::new(node), name.to_ascii_lowercase()))
            }
            ExpressionKind::Unary(operator, inner) => Node::Unary(unary(*operator), Box::new(self.node(inner)?)),
            ExpressionKind::Binary(operator, a, b) => {
                let (a, b) = (self.node(a), self.node(b));
                Node::Binary(binary(*operator), Box::new(a?), Box::new(b?))
            }
            ExpressionKind::Conditional(condition, yes, no) => {
                let (condition, yes, no) = (self.node(condition), self.node(yes), self.node(no));
                Node::Conditional(Box::new(condition?), Box::new(yes?), Box::new(no?))
            }
            ExpressionKind::Array(items) | ExpressionKind::Tuple(items) => Node::Array(self.nodes(items)?),
            ExpressionKind::Row(items) => Node::Row(self.nodes(items)?),
            ExpressionKind::Broken => return None,
        })
    }

    fn nodes(&mut self, items: &[command::Expression]) -> Option<Vec<Node>> {
        let bound: Vec<Option<Node>> = items.iter().map(|i| self.node(i)).collect();
        bound.into_iter().collect()
    }

    fn number(&mut self, value: f64, unit: Option<&str>, span: Span) -> Option<Node> {
        let typed = self.slice(span);
        let digits = typed.map(|t| &t[..number_length(t)]).filter(|d| d.parse::<f64>() == Ok(value));
        let text = digits.map_or_else(|| literal_text(value), normalised);
        let Some(unit) = unit else { return Some(Node::Number { value, text: text.into(), unit: None }) };
        let bare: String = unit.chars().filter(|c| !c.is_whitespace()).collect();
        if schema::parse_unit_expression(&bare).is_none() {
            let place = Span { start: span.end.saturating_sub(unit.len() as u32).max(span.start), ..span };
            self.errors.push(evaluate::unknown_unit(&bare).or_at(place, "not a unit"));
            return None;
        }
        let word = bare.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
        let unit = match bare.as_str() {
            "D" => "d".to_string(),
            _ if word => bare,
            _ => format!("({bare})"),
        };
        Some(Node::Number { value, text: text.into(), unit: Some(unit.into()) })
    }

    fn name(&mut self, name: &str, span: Span) -> Option<Node> {
        for constant in ["PI", "DTOR", "RTOD", "TIME"] {
            if name.eq_ignore_ascii_case(constant) {
                return Some(Node::Constant(constant));
            }
        }
        if name.eq_ignore_ascii_case("none") {
            return Some(Node::Nothing);
        }
        let steps = Steps::of(name);
        let database = self.scope.database;
        match reach(database, &steps) {
            Ok(reached) => self.attributes(reached, &steps, span),
            Err(Unknown::Nothing) if functions::is_defaults(name) => Some(Node::Unbound(name.to_ascii_lowercase())),
            Err(Unknown::Nothing) => {
                self.unknown_name(&steps, span);
                None
            }
            Err(Unknown::Ambiguous(objects)) => {
                let names: Vec<String> =
                    objects.iter().take(8).map(|o| format!("`{}`", database.full_name(*o))).collect();
                self.errors.push(
                    Diagnostic::error("expression/ambiguous-name", format!("`{name}` can mean more than one object"))
                        .at(span, "a short name that is not unique")
                        .note(format!("it is the name of {}", names.join(", ")))
                        .help("write the full name"),
                );
                None
            }
        }
    }

    /// Attributes behind the deepest object a name reaches.
    fn attributes(&mut self, reached: Reached, steps: &Steps, span: Span) -> Option<Node> {
        let database = self.scope.database;
        let mut node = Node::Object(reached.object);
        let Some(first) = steps.names.get(reached.steps) else { return Some(node) };
        // A variable may hold the object whose attribute is meant.
        let held =
            || match evaluate::evaluate(&Expression { root: Node::Object(reached.object) }, &self.scope).ok()?.value {
                Value::Text(ref text) => crate::find_object(database, text),
                ref other => other.as_object(),
            };
        let full = attributes::full_name(database, reached.object, first).or_else(|| {
            let variable = database.object(reached.object).class.id == "variable";
            let held = if variable { held() } else { None };
            held.and_then(|o| attributes::full_name(database, o, first))
        });
        let Some(full) = full else {
            let place = Self::step_span(span, steps, reached.steps);
            let diagnostic = *attributes::unknown_attribute(database, reached.object, first);
            let line = self.bracketed(place);
            self.errors.push(with_line(diagnostic, line).at(place, "neither a child nor an attribute"));
            return None;
        };
        node = Node::Attribute(Box::new(node), full);
        for later in &steps.names[reached.steps + 1..] {
            node = Node::Attribute(Box::new(node), later.to_ascii_lowercase());
        }
        Some(node)
    }

    fn unknown_name(&mut self, steps: &Steps, span: Span) {
        let database = self.scope.database;
        let first = steps.names.first().map_or("", String::as_str);
        let place = Self::step_span(span, steps, 0);
        let mut diagnostic = Diagnostic::error(
            "expression/unknown-name",
            format!("`{first}` is not a known constant, function or variable"),
        )
        .adams(format!("\"{first}\" is not a known constant, function or variable"));
        let candidates: Vec<&str> = if steps.absolute {
            database.roots().iter().filter_map(|r| database.get(*r)).map(|o| o.name.as_str()).collect()
        } else {
            let model = database.current("model").and_then(|m| database.get(m));
            let children = model.map_or(&[][..], |m| m.children.as_slice());
            children.iter().filter_map(|c| database.get(*c)).map(|o| o.name.as_str()).chain(["PI"]).collect()
        };
        if let Some(near) = nearest(first, candidates.into_iter()) {
            diagnostic = diagnostic.help(format!("did you mean `{near}`?"));
        }
        let line = self.bracketed(place);
        self.errors.push(with_line(diagnostic, line).at(place, "not known here"));
    }

    fn call(
        &mut self,
        function: &str,
        function_span: Span,
        arguments: &[command::Expression],
        whole: &command::Expression,
    ) -> Option<Node> {
        if function.eq_ignore_ascii_case("eval") {
            if arguments.len() != 1 {
                self.wrong_count(&functions::EVAL, arguments.len(), whole.span);
                return None;
            }
            let value = self.evaluated(whole)?.value;
            return self.literal(&value, whole.span);
        }
        if function == command::RANGE {
            let arguments = self.nodes(arguments)?;
            return Some(Node::Call { function: command::RANGE.into(), arguments });
        }
        let Some(known) = functions::find(function) else {
            let bound = self.nodes(arguments);
            let line = self.bracketed(function_span);
            let diagnostic = *functions::not_a_function(function);
            let label = if functions::is_unsupported(function) { "not supported yet" } else { "not a function" };
            self.errors.push(with_line(diagnostic, line).at(function_span, label));
            drop(bound);
            return None;
        };
        if !(known.least..=known.most).contains(&arguments.len()) {
            self.wrong_count(known, arguments.len(), whole.span);
            return None;
        }
        if known.momentary {
            let value = self.evaluated(whole)?.value;
            return self.literal(&value, whole.span);
        }
        let arguments = self.nodes(arguments)?;
        Some(Node::Call { function: known.name.into(), arguments })
    }

    /// The value of `EVAL(x)`, or of a function whose value belongs to the moment.
    fn evaluated(&mut self, call: &command::Expression) -> Option<Evaluated> {
        let ExpressionKind::Call { function, arguments, .. } = &call.kind else { return None };
        let root = if function.eq_ignore_ascii_case("eval") {
            self.node(arguments.first()?)?
        } else {
            let known = functions::find(function)?;
            if !(known.least..=known.most).contains(&arguments.len()) {
                self.wrong_count(known, arguments.len(), call.span);
                return None;
            }
            Node::Call { function: known.name.into(), arguments: self.nodes(arguments)? }
        };
        if !self.errors.is_empty() {
            return None;
        }
        match evaluate::evaluate(&Expression { root }, &self.scope) {
            Ok(evaluated) => Some(evaluated),
            Err(error) => {
                self.errors.push(error.or_at(call.span, "evaluated here"));
                None
            }
        }
    }

    /// A value as the literal that stands in its place.
    fn literal(&mut self, value: &Value, span: Span) -> Option<Node> {
        match literal(value) {
            Ok(node) => Some(node),
            Err(error) => {
                self.errors.push(error.or_at(span, "evaluated here"));
                None
            }
        }
    }

    fn wrong_count(&mut self, function: &Function, found: usize, call: Span) {
        let closing = Span { start: call.end.saturating_sub(1).max(call.start), ..call };
        let line = self.bracketed(closing);
        let diagnostic = with_line(*functions::wrong_count(function, found), line);
        self.errors.push(diagnostic.at(call, "wrong number of arguments"));
    }

    fn slice(&self, span: Span) -> Option<&str> {
        self.scope.sources.text(span.file).get(span.range())
    }

    /// Place of one step of a name.
    fn step_span(name: Span, steps: &Steps, step: usize) -> Span {
        let Range { start, end } = steps.ranges.get(step).cloned().unwrap_or(0..0);
        let length = (name.end - name.start) as usize;
        if end > length || start >= end {
            return name;
        }
        Span::new(name.file, name.start as usize + start, name.start as usize + end)
    }

    /// The whole expression with `<<` and `>>` round a token, as Adams shows where it stopped.
    fn bracketed(&self, token: Span) -> Option<String> {
        let (whole, token) = (self.whole.range(), token.range());
        let text = self.scope.sources.text(self.whole.file);
        if token.start < whole.start || token.end > whole.end {
            return None;
        }
        Some(format!(
            "({}<<{}>>{})",
            text.get(whole.start..token.start)?,
            text.get(token.clone())?,
            text.get(token.end..whole.end)?
        ))
    }
}

fn with_line(diagnostic: Diagnostic, line: Option<String>) -> Diagnostic {
    match line {
        Some(line) => diagnostic.adams(line),
        None => diagnostic,
    }
}

/// Length of the number at the start of a text, without its unit.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |mut i: usize| {
        while bytes.get(i).is_some_and(u8::is_ascii_digit) {
            i += 1;
        }
        i
    };
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let after = digits(end + 1 + sign);
        if after > end + 1 + sign {
            end = after;
        }
    }
    end
}

/// Text of a number without a source: whole numbers as integers.
fn literal_text(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < 1e15 { format!("{value:.0}") } else { number_text(value) }
}

/// A value as a node. Negative numbers become a sign and a number, as they are read.
pub(crate) fn literal(value: &Value) -> Outcome<Node> {
    let real = |x: f64| {
        let number = Node::Number { value: x.abs(), text: number_text(x.abs()).into(), unit: None };
        if x < 0.0 { Node::Unary(UnaryOperator::Negate, Box::new(number)) } else { number }
    };
    Ok(match value {
        Value::Nothing => Node::Nothing,
        Value::Number(x) => real(*x),
        Value::Integer(i) => {
            let size = i.unsigned_abs();
            let number = Node::Number { value: size as f64, text: size.to_string().into(), unit: None };
            if *i < 0 { Node::Unary(UnaryOperator::Negate, Box::new(number)) } else { number }
        }
        Value::Flag(flag) => literal(&Value::Integer(i64::from(*flag)))?,
        Value::Text(text) => Node::Text(text.clone()),
        Value::Object(id) => Node::Object(*id),
        Value::Array(a) if a.columns <= 1 => Node::Array(a.values.iter().map(|x| real(*x)).collect()),
        Value::Array(a) => Node::Array(
            (0..a.rows).map(|r| Node::Row((0..a.columns).map(|c| real(a.values[c * a.rows + r])).collect())).collect(),
        ),
        Value::Texts(list) => Node::Array(list.iter().cloned().map(Node::Text).collect()),
        Value::Objects(list) => Node::Array(list.iter().copied().map(Node::Object).collect()),
        Value::Function(_) => {
            return Err(problem("expression/not-a-value", "a run-time function cannot stand inside an expression"));
        }
    })
}

fn unary(operator: command::UnaryOperator) -> UnaryOperator {
    match operator {
        command::UnaryOperator::Negate => UnaryOperator::Negate,
        command::UnaryOperator::Plus => UnaryOperator::Plus,
        command::UnaryOperator::Not => UnaryOperator::Not,
    }
}

fn binary(operator: command::BinaryOperator) -> BinaryOperator {
    use command::BinaryOperator as From;
    match operator {
        From::Power => BinaryOperator::Power,
        From::Multiply => BinaryOperator::Multiply,
        From::Divide => BinaryOperator::Divide,
        From::Add => BinaryOperator::Add,
        From::Subtract => BinaryOperator::Subtract,
        From::Concatenate => BinaryOperator::Concatenate,
        From::Less => BinaryOperator::Less,
        From::LessEqual => BinaryOperator::LessEqual,
        From::Greater => BinaryOperator::Greater,
        From::GreaterEqual => BinaryOperator::GreaterEqual,
        From::Equal => BinaryOperator::Equal,
        From::NotEqual => BinaryOperator::NotEqual,
        From::And => BinaryOperator::And,
        From::Or => BinaryOperator::Or,
    }
}
