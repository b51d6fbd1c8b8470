//! The ground part becomes the body that does not move.

use model::ObjectId;

use crate::lower::Lowering;

pub fn lower(lowering: &mut Lowering<'_>, part: ObjectId) {
    lowering.add_ground(part);
}
