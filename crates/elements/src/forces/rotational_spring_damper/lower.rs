//! The cells of a rotational spring and damper become its constants.

use model::ObjectId;

use super::physics::Twist;
use crate::{forces::elastic, lower::Lowering};

pub fn lower(lowering: &mut Lowering<'_>, spring: ObjectId) {
    let cells = ["stiffness", "damping", "displacement_at_preload", "preload"];
    let law = match cells.map(|cell| elastic::numbers::<1>(lowering, spring, cell)) {
        [Some([stiffness]), Some([damping]), Some([angle]), Some([preload])] => {
            Some(Twist { stiffness, damping, angle, preload, ..Twist::default() })
        }
        _ => None,
    };
    elastic::add(lowering, spring, law);
}
