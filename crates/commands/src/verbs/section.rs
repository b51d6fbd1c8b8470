//! `section apply`: beams take their properties from a section.

use schema::{Field, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry, shared::Outcome};
use crate::{Interpreter, call::Call, interpreter::Flow};

/// What a beam takes from a section; both have the same names for it.
pub const TAKEN: [&str; 6] = ["area_of_cross_section", "ixx", "iyy", "izz", "y_shear_area_ratio", "z_shear_area_ratio"];

pub const APPLY: VerbEntry = entry(
    Verb {
        path: "section apply",
        fields: &[
            Field::object("section_name", "section").current().doc("section whose properties are taken"),
            Field::objects("beam_name", "beam").doc("beams that take them; patterns are allowed"),
            Field::yes_no("parametric")
                .default_word("yes")
                .doc("beams follow later changes of the section; otherwise they take the numbers it has now"),
        ],
        rules: &[],
        doc: "gives beams the properties of a section (an extension of Flexure)",
    },
    apply,
);

fn apply(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let given = interpreter.object_argument(call, "section_name")?;
    let Some(section) = given.or_else(|| interpreter.database.current("section")) else {
        return Err(vec![call.missing(&["section_name"])]);
    };
    let beams = interpreter.objects_argument(call, "beam_name")?;
    if beams.is_empty() {
        return Err(vec![call.missing(&["beam_name"])]);
    }
    let follow = interpreter.flag_argument(call, "parametric")? != Some(false);
    let name = interpreter.database.full_name(section);
    let mut changed = Vec::new();
    for cell in TAKEN {
        if interpreter.database.value(section, cell).is_none() {
            return Err(vec![
                Diagnostic::error("section/no-value", format!("`{name}` has no `{cell}`"))
                    .at(call.span, "no beam is changed")
                    .help(format!("give it one with `section modify ... section_name={name} {cell}=...`")),
            ]);
        }
        let text = if follow { format!("{name}.{cell}") } else { format!("EVAL({name}.{cell})") };
        for &beam in &beams {
            changed.push(interpreter.store_written(beam, cell, &text, call.span)?);
        }
    }
    interpreter.recompute(&changed, call.span)?;
    Ok(Flow::Next)
}
