//! Measures that are kept and written back, but not computed during a run.

use model::ObjectId;
use text::Diagnostic;

use crate::lower::Lowering;

/// Says so.
pub fn lower(lowering: &mut Lowering<'_>, measure: ObjectId) {
    let name = lowering.name(measure);
    let kind = lowering.database.object(measure).class.id.trim_start_matches("measure_");
    lowering.report(
        Diagnostic::warning("measure/not-recorded", format!("measure `{name}` is not recorded"))
            .note(format!("measures of the kind `{kind}` are kept, but not computed yet"))
            .help("use a function measure or a request instead"),
    );
}
