//! A function measure becomes one column.

use model::ObjectId;
use text::Diagnostic;

use crate::{
    lower::Lowering,
    output::{outputs::Column, vector},
    runtime,
};

pub fn lower(lowering: &mut Lowering<'_>, measure: ObjectId) {
    let name = lowering.name(measure);
    let text = runtime::text_of(lowering.database, measure, "function");
    if text.trim().is_empty() {
        lowering.report(
            Diagnostic::warning("measure/no-function", format!("measure `{name}` has no function and is not recorded"))
                .help(format!("measure modify function measure_name={name} function=\"...\"")),
        );
        return;
    }
    let Some(compiled) = runtime::compile(lowering, measure, &text) else { return };
    let unit = lowering.database.text(measure, "units").map_or(String::new(), |word| vector::label_of(lowering, word));
    let column = format!("{}.Q", lowering.database.object(measure).name);
    lowering.columns.push(Column::of_function(column, unit, compiled));
}
