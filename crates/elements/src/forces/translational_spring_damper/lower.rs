//! The cells of a translational spring and damper become its constants.

use model::ObjectId;

use super::physics::Line;
use crate::{forces::elastic, lower::Lowering};

pub fn lower(lowering: &mut Lowering<'_>, spring: ObjectId) {
    let cells = ["stiffness", "damping", "displacement_at_preload", "preload"];
    let law = match cells.map(|cell| elastic::numbers::<1>(lowering, spring, cell)) {
        [Some([stiffness]), Some([damping]), Some([length]), Some([preload])] => {
            Some(Line { stiffness, damping, length, preload })
        }
        _ => None,
    };
    elastic::add(lowering, spring, law);
}
