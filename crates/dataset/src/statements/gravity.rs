//! ACCGRAV: one for the model, without number or name; components that are zero are left out.

use model::{ObjectId, Value};

use crate::{
    layout::Lines,
    number::number,
    read::{Builder, Entry},
    write::Writer,
};

/// What gravity is called unless told otherwise.
pub(crate) const NAME: &str = "gravity";

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

/// What is left out is zero; the components that are given follow by their keywords.
pub(super) fn read<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for field in e.class.fields() {
        if field.keyword.is_some() {
            b.store(e.id, field.name, Value::Number(0.0));
        }
    }
}
