//! Columns for the whole model: every part's motion and every load.

use text::Diagnostic;

use super::{
    member,
    outputs::{Column, Quantity, Unit},
    vector,
};
use crate::lower::{LoadId, Lowering};

/// Puts time first; adds every part and load where that is asked for or nothing else is recorded, and
/// what goes through members where they are recorded or that alone is asked for.
pub(crate) fn complete(lowering: &mut Lowering<'_>) {
    let options = lowering.options;
    let nothing_asked = lowering.columns.is_empty() && !options.record_beams && !lowering.only_looks;
    if nothing_asked && !options.record_all {
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
    let everything = nothing_asked || options.record_all;
    if everything {
        for (part, body) in lowering.body_list() {
            let set = format!("{}_XFORM", lowering.database.object(part).name);
            let frame = lowering.origin_frame(part, body);
            vector::add_motion(lowering, &set, frame);
        }
    }
    for (element, load) in lowering.loads.clone() {
        if everything {
            let set = lowering.database.object(element).name.clone();
            vector::add_load(lowering, &set, element);
        }
        let LoadId::Force(force) = load else { continue };
        if (everything || options.record_beams) && lowering.forces[force].member().is_some() {
            member::add(lowering, element, force);
        }
    }
    let time = Column::new("time".into(), Quantity::Time, &Unit(lowering.units(), schema::Dimension::TIME));
    lowering.columns.insert(0, time);
}
