//! `group objects ...`: who belongs to a group.

use model::{ObjectId, Value};
use schema::{Field, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry};
use crate::{Interpreter, call::Call, interpreter::Flow};

type Outcome<T> = Result<T, Vec<Diagnostic>>;

const GROUP: Field = Field::object("group_name", "group").current().doc("group");
const MEMBERS: Field = Field::objects("objects_in_group", "any").doc("members");
const FILTER: Field = Field::text("type_filter").doc("take only objects of this type");
const EXPAND: Field = Field::yes_no("expand_groups").doc("take the members of groups in place of the groups");

const fn verb(path: &'static str, fields: &'static [Field], run: super::Run, doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, run)
}

pub const ADD: VerbEntry =
    verb("group objects add", &[GROUP, MEMBERS, EXPAND, FILTER], add, "puts objects into a group");
pub const REMOVE: VerbEntry =
    verb("group objects remove", &[GROUP, MEMBERS, FILTER], remove, "takes objects out of a group");
pub const EMPTY: VerbEntry = verb("group empty", &[GROUP], empty, "takes all objects out of a group");

fn group_and_members(interpreter: &mut Interpreter, call: &Call) -> Outcome<(ObjectId, Vec<ObjectId>)> {
    let Some(group) =
        interpreter.object_argument(call, "group_name")?.or_else(|| interpreter.database.current("group"))
    else {
        return Err(vec![call.missing(&["group_name"])]);
    };
    interpreter.database.make_current(group);
    let members = interpreter.database.value(group, "objects_in_group").map(Value::objects).unwrap_or_default();
    Ok((group, members))
}

fn chosen(interpreter: &mut Interpreter, call: &Call) -> Outcome<Vec<ObjectId>> {
    if call.argument("objects_in_group").is_none() {
        return Err(vec![call.missing(&["objects_in_group"])]);
    }
    let mut found = interpreter.objects_argument(call, "objects_in_group")?;
    if interpreter.flag_argument(call, "expand_groups")? == Some(true) {
        let database = &interpreter.database;
        found = found
            .into_iter()
            .flat_map(|id| {
                if database.object(id).class.id == "group" {
                    database.value(id, "objects_in_group").map(Value::objects).unwrap_or_default()
                } else {
                    vec![id]
                }
            })
            .collect();
    }
    if let Some(wanted) = interpreter.word_of(call, "type_filter")? {
        let wanted = wanted.to_ascii_lowercase();
        found.retain(|id| {
            let class = interpreter.database.object(*id).class;
            class.is(&wanted) || class.word.eq_ignore_ascii_case(&wanted)
        });
    }
    Ok(found)
}

fn add(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, mut members) = group_and_members(interpreter, call)?;
    for id in chosen(interpreter, call)? {
        if !members.contains(&id) {
            members.push(id);
        }
    }
    interpreter.database.set_value(group, "objects_in_group", Value::Objects(members));
    Ok(Flow::Next)
}

fn remove(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, mut members) = group_and_members(interpreter, call)?;
    let gone = chosen(interpreter, call)?;
    members.retain(|m| !gone.contains(m));
    interpreter.database.set_value(group, "objects_in_group", Value::Objects(members));
    Ok(Flow::Next)
}

fn empty(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, _) = group_and_members(interpreter, call)?;
    interpreter.database.set_value(group, "objects_in_group", Value::Objects(Vec::new()));
    Ok(Flow::Next)
}
