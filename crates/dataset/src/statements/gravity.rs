//! ACCGRAV: one for the model, without number or name; components that are zero are left out.

use model::ObjectId;

use crate::{layout::Lines, number::number, write::Writer};

pub(crate) fn gravity(w: &Writer<'_>, id: ObjectId) -> Lines {
    let mut lines = Lines::new("ACCGRAV", None);
    for field in w.database.object(id).class.fields() {
        if let (Some(keyword), Some(x)) = (field.keyword, w.database.number(id, field.name))
            && x != 0.0
        {
            lines.argument(keyword, &number(x, w.options.digits));
        }
    }
    lines
}
