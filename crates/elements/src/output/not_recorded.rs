//! Measures that are kept and written back, but not computed during a run.

use model::ObjectId;
use text::Diagnostic;

use crate::lower::Lowering;

/// Says so.
pub fn lower(lowering: &mut Lowering<'_>, measure: ObjectId) {
    let kind = lowering.database.object(measure).class.id.trim_start_matches("measure_");
    say(lowering, measure, format!("measures of the kind `{kind}` are kept, but not computed yet"));
}

/// Names a measure that is not recorded, and why.
pub fn say(lowering: &mut Lowering<'_>, measure: ObjectId, why: String) {
    let name = lowering.name(measure);
    lowering.report(
        Diagnostic::warning("measure/not-recorded", format!("measure `{name}` is not recorded"))
            .note(why)
            .help("use a function measure or a request instead"),
    );
}
