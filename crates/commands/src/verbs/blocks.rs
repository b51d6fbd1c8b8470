//! The words that open, part and close blocks. The interpreter runs them itself; what is here
//! answers those that stand where they cannot.

use schema::{Field, Kind, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow};

const CONDITION: Field = Field::new("condition", Kind::Any).required().doc("number; 0 is false");
const ECHO: Field = Field::yes_no("echo_all_loops").doc("echo every pass, not only the first");

const fn verb(path: &'static str, fields: &'static [Field], doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, stray)
}

pub const IF: VerbEntry = verb("if", &[CONDITION], "runs a block if a condition holds");
pub const ELSEIF: VerbEntry = verb("elseif", &[CONDITION], "runs a block if none before ran and a condition holds");
pub const ELSE: VerbEntry = verb("else", &[], "runs a block if none before ran");
pub const END: VerbEntry = verb("end", &[], "closes a block");
pub const BREAK: VerbEntry = verb("break", &[], "leaves the innermost loop");
pub const CONTINUE: VerbEntry = verb("continue", &[], "goes to the next pass of the innermost loop");
pub const RETURN: VerbEntry = verb("return", &[], "leaves the macro or file");
pub const WHILE: VerbEntry = verb("while", &[CONDITION, ECHO], "repeats a block as long as a condition holds");
pub const FOR: VerbEntry = verb(
    "for",
    &[
        Field::text("variable_name").required().doc("variable that takes each value"),
        Field::objects("object_names", "any").doc("objects to go through"),
        Field::text("type_filter").doc("take only objects of this type"),
        Field::real("start_value", schema::Dimension::NONE).doc("first value"),
        Field::real("end_value", schema::Dimension::NONE).doc("last value"),
        Field::real("increment_value", schema::Dimension::NONE).doc("step, 1 if not given"),
        Field::objects("group_name", "group").doc("groups whose members to go through"),
        ECHO,
    ],
    "repeats a block for numbers or objects",
);

fn stray(_: &mut Interpreter, call: &Call) -> Result<Flow, Vec<Diagnostic>> {
    let (block, label) = match &*call.path {
        "break" | "continue" => ("any loop of its file or macro", "no loop is open here"),
        _ => ("a block it could belong to", "no block is open here"),
    };
    Err(vec![
        Diagnostic::error("command/stray-block-word", format!("`{}` stands outside of {block}", call.path))
            .at(call.keywords, label)
            .adams("Invalid input. Enter an object, qualifier, or action."),
    ])
}
