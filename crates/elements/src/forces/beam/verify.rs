//! The well-known traps of beams, found before anything is solved.

use model::{Database, ObjectId};

use crate::verify::Finding;

pub fn verify(database: &Database, beam: ObjectId, findings: &mut Vec<Finding>) {
    let _ = (database, beam, findings);
}
