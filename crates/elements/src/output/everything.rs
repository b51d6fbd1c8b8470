//! Columns for the whole model: every part's motion and every load.

use text::Diagnostic;

use super::{
    outputs::{Column, Quantity, Unit},
    vector,
};
use crate::lower::Lowering;

/// Puts time first; adds every part and load where that is asked for or nothing else is recorded.
pub(crate) fn complete(lowering: &mut Lowering<'_>) {
    let nothing_asked = lowering.columns.is_empty();
    if nothing_asked && !lowering.options.record_all {
        let model = lowering.name(lowering.model);
        lowering.report(
            Diagnostic::new(
                text::Severity::Note,
                "output/everything",
                format!("model `{model}` has no request and no measure: every part, joint and force is recorded"),
            )
            .help("create a request or a measure to record less"),
        );
    }
    if nothing_asked || lowering.options.record_all {
        for (part, body) in lowering.body_list() {
            let set = format!("{}_XFORM", lowering.database.object(part).name);
            let frame = lowering.origin_frame(part, body);
            vector::add_motion(lowering, &set, frame);
        }
        for element in lowering.loads.keys().copied().collect::<Vec<_>>() {
            let set = lowering.database.object(element).name.clone();
            vector::add_load(lowering, &set, element);
        }
    }
    let time = Column::new("time".into(), Quantity::Time, &Unit(lowering.units(), schema::Dimension::TIME));
    lowering.columns.insert(0, time);
}
