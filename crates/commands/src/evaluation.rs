//! The one place where this room asks `expressions` for something.

use expressions::{Bound, Scope, World};
use model::{Database, Expression, Node, ObjectId, Value};
use schema::Dimension;
use syntax::command::{self, ExpressionKind};
use text::{Diagnostic, Sources};

/// What an expression in a command came to.
#[derive(Clone, Debug)]
pub struct Outcome {
    pub value: Value,
    pub dimension: Option<Dimension>,
    /// The expression to keep; none where EVAL asked for the value alone.
    pub kept: Option<Expression>,
    pub reads: Vec<model::CellKey>,
}

/// Binds and evaluates an expression. `owner` is the object whose cell it fills.
pub fn evaluate(
    expression: &command::Expression,
    database: &Database,
    sources: &Sources,
    world: &World,
    owner: Option<ObjectId>,
) -> Result<Outcome, Vec<Diagnostic>> {
    let scope = Scope { owner, ..Scope::new(database, sources).in_world(world) };
    in_scope(expression, &scope).map_err(|errors| name_what_was_read(expression, database, errors))
}

fn in_scope(expression: &command::Expression, scope: &Scope) -> Result<Outcome, Vec<Diagnostic>> {
    match expressions::bind(expression, scope)? {
        Bound::Value(e) => Ok(Outcome { value: e.value, dimension: e.dimension, kept: None, reads: Vec::new() }),
        Bound::Expression(bound) => {
            let e = expressions::evaluate(&bound, scope)
                .map_err(|e| vec![e.or_at(expression.span, "in this expression")])?;
            Ok(Outcome { value: e.value, dimension: e.dimension, kept: Some(bound), reads: e.reads })
        }
    }
}

/// Binds and evaluates an expression that Flexure itself has written for a cell of `owner`.
pub fn written(text: &str, database: &Database, world: &World, owner: ObjectId) -> Result<Outcome, Vec<Diagnostic>> {
    let mut sources = Sources::default();
    let file = sources.add("<formula>", text);
    let (tree, mut errors) = command::parse_expression(file, text, 0);
    if errors.is_empty() {
        let scope = Scope { owner: Some(owner), ..Scope::new(database, &sources).in_world(world) };
        match in_scope(&tree, &scope) {
            Ok(outcome) => return Ok(outcome),
            Err(found) => errors = found,
        }
    }
    // The text is in no file of the session, so that no place in it can be shown.
    for error in &mut errors {
        error.primary = None;
        error.secondary.clear();
    }
    Err(errors)
}

/// Where an object was wanted, the beginning of an attribute may have been meant as the name of one.
fn name_what_was_read(
    expression: &command::Expression,
    database: &Database,
    mut errors: Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    for error in errors.iter_mut().filter(|e| e.code == "expression/not-an-object") {
        let mut names = Vec::new();
        collect_names(expression, &mut names);
        for (object, typed, full) in names.iter().filter_map(|n| expressions::read_as_attribute(database, n)) {
            let owner = database.full_name(object);
            let note = format!("`{owner}` has no child `{typed}`: that was read as its attribute `{full}`");
            error.notes.push(note);
        }
    }
    errors
}

fn collect_names<'e>(expression: &'e command::Expression, names: &mut Vec<&'e str>) {
    let mut all = |parts: &'e [command::Expression]| parts.iter().for_each(|p| collect_names(p, names));
    match &expression.kind {
        ExpressionKind::Name(name) => names.push(name),
        ExpressionKind::Call { arguments, .. } => all(arguments),
        ExpressionKind::Array(items) | ExpressionKind::Tuple(items) | ExpressionKind::Row(items) => all(items),
        ExpressionKind::Index(inner, indices) => {
            all(indices);
            collect_names(inner, names);
        }
        ExpressionKind::Attribute(inner, _) | ExpressionKind::Unary(_, inner) => collect_names(inner, names),
        ExpressionKind::Binary(_, a, b) => [a, b].into_iter().for_each(|p| collect_names(p, names)),
        ExpressionKind::Conditional(a, b, c) => [a, b, c].into_iter().for_each(|p| collect_names(p, names)),
        ExpressionKind::Number { .. } | ExpressionKind::Text(_) | ExpressionKind::Broken => {}
    }
}

/// Re-evaluates everything that depends on changed cells.
pub fn recompute(database: &mut Database, changed: &[model::CellKey]) -> Result<(), Diagnostic> {
    if changed.iter().all(|c| database.dependents(*c).is_empty()) {
        return Ok(());
    }
    expressions::recompute(database, changed)
}

/// Re-evaluates what follows from which objects there are; gives warnings of what no longer can be.
pub fn restructure(database: &mut Database) -> Result<Vec<Diagnostic>, Diagnostic> {
    if database.dependents(expressions::STRUCTURE).is_empty() {
        return Ok(Vec::new());
    }
    expressions::restructure(database)
}

/// What the value of an expression is multiplied with for a field in radians per unit of time.
pub fn radians_per_time(expression: &Expression, field: &schema::Field, database: &Database) -> f64 {
    expressions::radians_per_time(&expression.root, field.dimension, database)
}

/// The text of an expression as exports write it, without the outer parentheses.
pub fn print(expression: &Expression, database: &Database) -> String {
    expressions::print(expression, database)
}

/// Whether an orientation given by this expression is in body 3-1-3 whatever the session's
/// sequence is: all design-time ORI functions are.
pub fn yields_body_313(expression: &command::Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Call { function, arguments, .. } if function.eq_ignore_ascii_case("eval") => {
            arguments.first().is_some_and(yields_body_313)
        }
        ExpressionKind::Call { function, .. } => function.to_ascii_lowercase().starts_with("ori_"),
        ExpressionKind::Name(name) => name.to_ascii_lowercase().ends_with(".orientation"),
        _ => false,
    }
}

/// Whether the expression is one number with a unit, where a wrong unit is certainly a mistake.
pub fn is_plain_quantity(expression: &Expression) -> bool {
    matches!(expression.root, Node::Number { .. })
}
