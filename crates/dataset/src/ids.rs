//! The numbers objects have in the solver's files.

use std::collections::{HashMap, HashSet};

use model::{Database, ObjectId, Value};
use text::Diagnostic;

/// Gives every object of a model whose `adams_id` is 0 the smallest number that is free for its
/// statement, in order of creation, and stores it: later datasets use the same number. Nothing
/// changes if two objects claim the same number.
pub fn number_objects(database: &mut Database, model: ObjectId) -> Result<(), Vec<Diagnostic>> {
    let mut used: HashMap<&str, HashMap<i64, ObjectId>> = HashMap::new();
    let mut waiting = Vec::new();
    let mut troubles = Vec::new();
    let mut objects = database.subtree(model);
    // The ground part comes first: exports number it 1.
    objects.sort_by_key(|&id| (database.object(id).class.id != "ground", id));
    for id in objects {
        let class = database.object(id).class;
        let Some(statement) = class.statement else { continue };
        if class.cell_index("adams_id").is_none() {
            continue;
        }
        match database.integer(id, "adams_id").unwrap_or(0) {
            0 => waiting.push((id, statement)),
            given if given < 0 => {
                let message = format!("`{}` has the negative adams_id {given}", database.full_name(id));
                troubles.push(Diagnostic::error("dataset/negative-id", message));
            }
            given => {
                if let Some(other) = used.entry(statement).or_default().insert(given, id) {
                    let names = [other, id].map(|o| database.full_name(o));
                    let message = format!("`{}` and `{}` are both {statement}/{given}", names[0], names[1]);
                    let help = "give one of them another adams_id, or 0 to have it numbered";
                    troubles.push(Diagnostic::error("dataset/duplicate-id", message).help(help));
                }
            }
        }
    }
    if !troubles.is_empty() {
        return Err(troubles);
    }
    let mut taken: HashMap<&str, HashSet<i64>> =
        used.into_iter().map(|(statement, ids)| (statement, ids.into_keys().collect())).collect();
    let mut next: HashMap<&str, i64> = HashMap::new();
    for (id, statement) in waiting {
        let (taken, next) = (taken.entry(statement).or_default(), next.entry(statement).or_insert(1));
        while !taken.insert(*next) {
            *next += 1;
        }
        database.set_value(id, "adams_id", Value::Integer(*next));
    }
    Ok(())
}
