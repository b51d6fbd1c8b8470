//! The cells of a universal joint become a constraint between two frames.

use equations::constraints::Pair;
use model::ObjectId;

use crate::{joints::between, lower::Lowering};

pub fn lower(lowering: &mut Lowering<'_>, joint: ObjectId) {
    between::lower(lowering, joint, Pair::universal);
}
