//! What is doubtful about a model: what elements find, and the trap that only the whole model shows. The
//! program and the command `model verify` both ask here.

use elements::Options;
use model::{Database, ObjectId};

use crate::overdamped;
use crate::session::Verification;

/// Verifies a model whose beams are taken as runs take them.
pub(crate) fn verify(database: &Database, model: ObjectId, lowering: Options) -> Verification {
    let mut verified = elements::verify(database, model, lowering);
    // A model with errors has no modes.
    if let Some(lowered) = verified.lowered.take() {
        verified.findings.extend(overdamped::find(database, model, lowered));
    }
    Verification { report: verified.report(), findings: verified.findings }
}
