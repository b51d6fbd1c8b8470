//! The one place where this room asks `expressions` for something.

use expressions::{Bound, Scope};
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
    owner: Option<ObjectId>,
) -> Result<Outcome, Vec<Diagnostic>> {
    let scope = Scope { owner, ..Scope::new(database, sources) };
    match expressions::bind(expression, &scope)? {
        Bound::Value(e) => Ok(Outcome { value: e.value, dimension: e.dimension, kept: None, reads: Vec::new() }),
        Bound::Expression(bound) => {
            let e = expressions::evaluate(&bound, &scope)
                .map_err(|e| vec![e.or_at(expression.span, "in this expression")])?;
            Ok(Outcome { value: e.value, dimension: e.dimension, kept: Some(bound), reads: e.reads })
        }
    }
}

/// Re-evaluates everything that depends on changed cells.
pub fn recompute(database: &mut Database, changed: &[model::CellKey]) -> Result<(), Diagnostic> {
    if changed.iter().all(|c| database.dependents(*c).is_empty()) {
        return Ok(());
    }
    expressions::recompute(database, changed)
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
