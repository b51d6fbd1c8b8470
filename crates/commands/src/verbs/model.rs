//! `model display`, `model verify`, `model generate_ids`.

use schema::{Field, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry, shared::MODEL};
use crate::{Interpreter, call::Call, interpreter::Flow};

type Outcome = Result<Flow, Vec<Diagnostic>>;

pub const DISPLAY: VerbEntry = entry(
    Verb {
        path: "model display",
        fields: &[
            MODEL,
            Field::texts("view_name").doc("views that show the model"),
            Field::yes_no("fit_to_view").default_word("yes").doc("zoom so that the model fills the view"),
        ],
        rules: &[],
        doc: "makes a model the current one and shows it",
    },
    display,
);

fn display(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let model = interpreter.model_argument(call)?;
    interpreter.database.make_current(model);
    Ok(Flow::Next)
}

pub const VERIFY: VerbEntry = entry(
    Verb {
        path: "model verify",
        fields: &[
            MODEL,
            Field::yes_no("check_solver_compatibility").default_word("no").doc("also check what the solver supports"),
            Field::on_off("write_to_terminal").default_word("on").doc("show the report"),
            Field::text("file_name").doc("file for the report"),
        ],
        rules: &[],
        doc: "counts degrees of freedom and looks for mistakes in a model",
    },
    verify,
);

fn verify(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let model = interpreter.model_argument(call)?;
    let (lines, findings) = interpreter.host.verify(&interpreter.database, model);
    if interpreter.flag_argument(call, "write_to_terminal")? != Some(false) {
        interpreter.show(&lines);
    }
    interpreter.write_lines(call, "file_name", &lines)?;
    let (errors, others): (Vec<_>, Vec<_>) = findings.into_iter().partition(Diagnostic::is_error);
    interpreter.report.diagnostics.extend(others);
    if errors.is_empty() { Ok(Flow::Next) } else { Err(errors) }
}

pub const GENERATE_IDS: VerbEntry = entry(
    Verb {
        path: "model generate_ids",
        fields: &[
            Field::objects("model_names", "model").current().doc("models"),
            Field::yes_no("zero_ids").default_word("no").doc("set numbers to 0 instead"),
        ],
        rules: &[],
        doc: "gives every object without a number one",
    },
    generate_ids,
);

fn generate_ids(interpreter: &mut Interpreter, call: &Call) -> Outcome {
    let mut models = interpreter.objects_argument(call, "model_names")?;
    if models.is_empty() {
        models.extend(interpreter.database.current("model"));
    }
    let zero = interpreter.flag_argument(call, "zero_ids")? == Some(true);
    for model in models {
        if zero {
            for id in interpreter.database.subtree(model) {
                if interpreter.database.cell(id, "adams_id").is_some() {
                    interpreter.database.set_value(id, "adams_id", ::model::Value::Integer(0));
                }
            }
        } else {
            interpreter.host.generate_ids(&mut interpreter.database, model)?;
        }
    }
    interpreter.names.forget();
    Ok(Flow::Next)
}
