//! The cells of a bushing become its rates.

use model::ObjectId;

use super::physics::Rates;
use crate::{forces::elastic, lower::Lowering};

pub fn lower(lowering: &mut Lowering<'_>, bushing: ObjectId) {
    let mut both = |along: &str, about: &str| {
        let [along, about] = [along, about].map(|cell| elastic::numbers::<3>(lowering, bushing, cell));
        let ([x, y, z], [a, b, c]) = (along?, about?);
        Some([x, y, z, a, b, c])
    };
    let stiffness = both("stiffness", "tstiffness");
    let damping = both("damping", "tdamping");
    let preload = both("force_preload", "torque_preload");
    let rates = match (stiffness, damping, preload) {
        (Some(stiffness), Some(damping), Some(preload)) => {
            Some(Rates { stiffness, damping, preload, ..Rates::default() })
        }
        _ => None,
    };
    elastic::add(lowering, bushing, rates);
}
