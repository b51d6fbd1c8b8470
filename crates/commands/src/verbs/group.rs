//! `group ...`: who belongs to a group, and what is done to all members at once.

use model::{ObjectId, Value};
use schema::{Count, Dimension, Field, Kind, Names, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry,
    shared::{self, Outcome},
    twins::Twins,
};
use crate::{
    Interpreter,
    call::Call,
    interpreter::Flow,
    lookup::{self, NewName},
};

const GROUP: Field = Field::object("group_name", "group").current().doc("group");
const MEMBERS: Field = Field::objects("objects_in_group", "any").doc("members");
const FILTER: Field = shared::TYPE_FILTER;
const EXPAND: Field = shared::EXPAND_GROUPS;

const fn verb(path: &'static str, fields: &'static [Field], run: super::Run, doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, run)
}

pub const CREATE: VerbEntry = verb(
    "group create",
    &[
        Field::new("group_name", Kind::Object(Names::New, "group")).doc("group; its name is generated if not given"),
        shared::COMMENTS,
        MEMBERS,
        FILTER,
        EXPAND,
        Field::integer("expr_active").doc("number or expression that switches the members on"),
    ],
    create,
    "makes a group of objects",
);
pub const MODIFY: VerbEntry = verb(
    "group modify",
    &[
        GROUP,
        Field::new("new_group_name", Kind::Object(Names::New, "group")).doc("new name"),
        shared::COMMENTS,
        MEMBERS,
        FILTER,
        EXPAND,
        Field::integer("expr_active").doc("number or expression that switches the members on"),
    ],
    modify,
    "changes a group; members given replace those it has",
);
pub const ADD: VerbEntry =
    verb("group objects add", &[GROUP, MEMBERS, EXPAND, FILTER], add, "puts objects into a group");
pub const REMOVE: VerbEntry =
    verb("group objects remove", &[GROUP, MEMBERS, FILTER], remove, "takes objects out of a group");
pub const EMPTY: VerbEntry = verb("group empty", &[GROUP], empty, "takes all objects out of a group");
pub const DELETE_OBJECTS: VerbEntry = verb(
    "group objects delete",
    &[
        GROUP,
        Field::yes_no("remove_unused_references")
            .default_word("no")
            .doc("also delete markers that nothing uses any more"),
        EXPAND,
        FILTER,
    ],
    delete_objects,
    "deletes the members of a group; the group stays",
);
pub const COPY_OBJECTS: VerbEntry = verb(
    "group objects copy",
    &[
        GROUP,
        Field::new("new_group_name", Kind::Object(Names::OldOrNew, "group"))
            .doc("group that receives the copies; made if it does not exist"),
        FILTER,
        Field::text("search_for_string").doc("piece of the names that is replaced in those of the copies"),
        Field::text("replace_string").doc("what stands in its place"),
    ],
    copy_objects,
    "copies the members of a group; copies refer to each other",
);
pub const RENAME_OBJECTS: VerbEntry = verb(
    "group objects rename",
    &[
        GROUP,
        Field::text("prefix_string").doc("put before each name"),
        Field::text("suffix_string").doc("put behind each name"),
        FILTER,
    ],
    rename_objects,
    "gives the members of a group longer names",
);
const SWITCH: &[&str] = &["on", "off", "no_opinion", "toggle"];
/// What a member may be told about its looks and its part in simulations.
pub const ATTRIBUTES: VerbEntry = verb(
    "group objects attributes",
    &[
        GROUP,
        FILTER,
        Field::real("scale_of_icons", Dimension::NONE).doc("size of icons as a factor"),
        Field::real("size_of_icons", Dimension::LENGTH).doc("size of icons as a length"),
        Field::choice("visibility", SWITCH).doc("whether members are drawn"),
        Field::choice("name_visibility", SWITCH).doc("whether their names are drawn"),
        Field::integer("transparency").doc("how much shines through, 0 to 100"),
        Field::integer("lod").doc("level of detail, 0 to 100"),
        Field::text("color").doc("name of their colour"),
        Field::choice("entity_scope", &["fill_color", "edge_color", "outline_color", "text_color", "all_color"])
            .doc("what the colour is for"),
        Field::real("line_thickness", Dimension::NONE).doc("width of lines"),
        Field::choice("line_type", &["solid", "dash", "dotdash", "dot", "none"]).doc("pattern of lines"),
        Field::choice("active", SWITCH).doc("whether members take part in simulations"),
        Field::choice("dependents_active", SWITCH).doc("whether what depends on them takes part"),
    ],
    attributes,
    "how the members of a group look and whether they take part",
);
/// The same by the name of the group alone: in Adams a group passes its attributes on.
pub const GROUP_ATTRIBUTES: VerbEntry = verb(
    "group attributes",
    &[
        Field::objects("group_name", "group").current().count(Count::MANY).doc("groups"),
        Field::real("scale_of_icons", Dimension::NONE).doc("size of icons as a factor"),
        Field::real("size_of_icons", Dimension::LENGTH).doc("size of icons as a length"),
        Field::choice("visibility", SWITCH).doc("whether members are drawn"),
        Field::choice("name_visibility", SWITCH).doc("whether their names are drawn"),
        Field::text("color").doc("name of their colour"),
        Field::real("line_thickness", Dimension::NONE).doc("width of lines"),
        Field::choice("line_type", &["solid", "dash", "dotdash", "dot", "none"]).doc("pattern of lines"),
        Field::choice("entity_scope", &["fill_color", "edge_color", "outline_color", "text_color", "all_color"])
            .doc("what the colour is for"),
        Field::choice("active", SWITCH).doc("whether members take part in simulations"),
        Field::choice("dependents_active", SWITCH).doc("whether what depends on them takes part"),
    ],
    attributes,
    "sets attributes of all members of groups",
);

fn group_and_members(interpreter: &mut Interpreter, call: &Call) -> Outcome<(ObjectId, Vec<ObjectId>)> {
    let Some(group) =
        interpreter.object_argument(call, "group_name")?.or_else(|| interpreter.database.current("group"))
    else {
        return Err(vec![call.missing(&["group_name"])]);
    };
    interpreter.database.make_current(group);
    let members = shared::members(&interpreter.database, group);
    Ok((group, members))
}

fn chosen(interpreter: &mut Interpreter, call: &Call) -> Outcome<Vec<ObjectId>> {
    let mut found = interpreter.objects_argument(call, "objects_in_group")?;
    if interpreter.flag_argument(call, "expand_groups")? == Some(true) {
        found = shared::expanded(&interpreter.database, &found);
    }
    let before = found.len();
    shared::filter_by_type(interpreter, call, &mut found)?;
    if before > 0 && found.is_empty() {
        let warning = Diagnostic::warning("group/empty", format!("none of the {before} objects is of this type"))
            .at(call.argument("type_filter").map_or(call.span, |a| a.value_span), "leaves nothing")
            .help(
                "`expand_groups = yes` takes the members of groups; `.model.*` means children alone, `.*` everything",
            );
        interpreter.complain(vec![warning]);
    }
    let mut once = indexmap::IndexSet::new();
    found.retain(|id| once.insert(*id));
    Ok(found)
}

fn chosen_or_missing(interpreter: &mut Interpreter, call: &Call) -> Outcome<Vec<ObjectId>> {
    if call.argument("objects_in_group").is_none() {
        return Err(vec![call.missing(&["objects_in_group"])]);
    }
    chosen(interpreter, call)
}

/// A group is no member of itself, though a pattern may mean it too.
fn set_members(interpreter: &mut Interpreter, group: ObjectId, mut members: Vec<ObjectId>) {
    members.retain(|member| *member != group);
    interpreter.database.set_value(group, "objects_in_group", Value::Objects(members));
}

fn create(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let model = interpreter.database.current("model");
    let members = chosen(interpreter, call)?;
    let group = if let Some(argument) = call.argument("group_name") {
        let typed = interpreter.text_argument(call, argument)?;
        interpreter.new_group(&typed, model, argument.value_span)?
    } else {
        let Some(class) = interpreter.registry.class("group") else { return Err(vec![call.missing(&["group_name"])]) };
        let name = interpreter.generate_name(class, model);
        interpreter.new_group(&name, model, call.keywords)?
    };
    if call.argument("objects_in_group").is_some() {
        set_members(interpreter, group, members);
    }
    interpreter.set_own(group, call, &["comments", "expr_active"])?;
    interpreter.database.make_current(group);
    Ok(Flow::Next)
}

fn modify(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, _) = group_and_members(interpreter, call)?;
    if call.argument("objects_in_group").is_some() {
        let members = chosen(interpreter, call)?;
        set_members(interpreter, group, members);
    }
    interpreter.set_own(group, call, &["comments", "expr_active"])?;
    if let Some(argument) = call.argument("new_group_name") {
        let typed = interpreter.text_argument(call, argument)?;
        interpreter.rename(group, &typed, argument.value_span)?;
    }
    Ok(Flow::Next)
}

impl Interpreter {
    /// Stores given values of these names in cells of an object; what its class has no cell for is
    /// left to the caller.
    pub(crate) fn set_own(&mut self, id: ObjectId, call: &Call, names: &[&str]) -> Outcome<()> {
        let class = self.database.object(id).class;
        for name in names {
            let (Some(argument), Some(field)) = (call.argument(name), call.field(name).copied()) else { continue };
            let Some(cell) = class.cell_index(name) else { continue };
            let draft = self.read_value(call, &field, argument, Some(id))?;
            let key = model::CellKey::new(id, cell);
            self.store(key, draft);
            self.recompute(&[key], call.span)?;
        }
        Ok(())
    }
}

fn add(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, mut members) = group_and_members(interpreter, call)?;
    for id in chosen_or_missing(interpreter, call)? {
        if !members.contains(&id) {
            members.push(id);
        }
    }
    set_members(interpreter, group, members);
    Ok(Flow::Next)
}

fn remove(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, mut members) = group_and_members(interpreter, call)?;
    let gone = chosen_or_missing(interpreter, call)?;
    members.retain(|m| !gone.contains(m));
    set_members(interpreter, group, members);
    Ok(Flow::Next)
}

fn empty(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, _) = group_and_members(interpreter, call)?;
    set_members(interpreter, group, Vec::new());
    Ok(Flow::Next)
}

/// The members that a command on all of them is for.
fn meant(interpreter: &mut Interpreter, call: &Call) -> Outcome<(ObjectId, Vec<ObjectId>)> {
    let (group, mut members) = group_and_members(interpreter, call)?;
    if call.field("expand_groups").is_some() && interpreter.flag_argument(call, "expand_groups")? == Some(true) {
        members = shared::expanded(&interpreter.database, &members);
    }
    shared::filter_by_type(interpreter, call, &mut members)?;
    Ok((group, members))
}

fn delete_objects(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (_, mut gone) = meant(interpreter, call)?;
    if interpreter.flag_argument(call, "remove_unused_references")? == Some(true) {
        let database = &interpreter.database;
        let referred: indexmap::IndexSet<ObjectId> = gone
            .iter()
            .flat_map(|id| database.object(*id).cells.values().flat_map(|c| c.value.objects()))
            .filter(|r| database.get(*r).is_some_and(|o| o.class.is("marker")) && !gone.contains(r))
            .collect();
        let mut all = gone.clone();
        all.extend(&referred);
        // A marker stays where anything that stays refers to it.
        let kept: Vec<ObjectId> = referred
            .iter()
            .copied()
            .filter(|marker| {
                interpreter
                    .dependents_of(&[*marker])
                    .iter()
                    .any(|d| !all.contains(d) && interpreter.database.object(*d).class.id != "group")
            })
            .collect();
        gone.extend(referred.into_iter().filter(|m| !kept.contains(m)));
    }
    interpreter.delete_objects(&gone, call)?;
    Ok(Flow::Next)
}

fn copy_objects(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (group, members) = meant(interpreter, call)?;
    let search = interpreter.word_of(call, "search_for_string")?.unwrap_or_default();
    let replace = interpreter.word_of(call, "replace_string")?.unwrap_or_default();
    // What is below another member is copied with that.
    let below = |interpreter: &Interpreter, id: ObjectId| {
        let mut parent = interpreter.database.object(id).parent;
        while let Some(p) = parent {
            if members.contains(&p) {
                return true;
            }
            parent = interpreter.database.object(p).parent;
        }
        false
    };
    let mut originals: Vec<(ObjectId, NewName)> = Vec::new();
    for &id in members.iter().filter(|id| !below(interpreter, **id)) {
        let object = interpreter.database.object(id);
        let wanted = if search.is_empty() { object.name.clone() } else { object.name.replace(&search, &replace) };
        let parent = object.parent;
        let mut name = interpreter.free_name(parent, &wanted);
        let mut number = 2;
        while originals.iter().any(|(_, n)| n.parent == parent && n.name.eq_ignore_ascii_case(&name)) {
            name = interpreter.free_name(parent, &format!("{wanted}_{number}"));
            number += 1;
        }
        originals.push((id, NewName { parent, name }));
    }
    let twins = interpreter.make_twins(&originals, Twins::new(), "", call.span)?;
    if let Some(argument) = call.argument("new_group_name") {
        let typed = interpreter.text_argument(call, argument)?;
        let model = interpreter.database.object(group).parent.or_else(|| interpreter.database.current("model"));
        let into = match lookup::search_one(&interpreter.database, &typed, "group") {
            Some(known) => known,
            None => interpreter.new_group(&typed, model, argument.value_span)?,
        };
        let mut all = shared::members(&interpreter.database, into);
        all.extend(members.iter().filter_map(|m| twins.get(m)));
        set_members(interpreter, into, all);
    }
    Ok(Flow::Next)
}

fn rename_objects(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (_, members) = meant(interpreter, call)?;
    let before = interpreter.word_of(call, "prefix_string")?.unwrap_or_default();
    let behind = interpreter.word_of(call, "suffix_string")?.unwrap_or_default();
    if before.is_empty() && behind.is_empty() {
        return Err(vec![call.missing(&["prefix_string", "suffix_string"])]);
    }
    for id in members {
        let object = interpreter.database.object(id);
        if object.class.id == "ground" || interpreter.is_built_in(id) {
            return Err(vec![
                Diagnostic::error("name/permanent", "the ground of a model keeps its name")
                    .at(call.span, "a member of the group"),
            ]);
        }
        let name = model::quoted(&format!("{before}{}{behind}", object.name));
        interpreter.rename(id, &name, call.span)?;
    }
    Ok(Flow::Next)
}

fn attributes(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let mut groups = interpreter.objects_argument(call, "group_name")?;
    if groups.is_empty() {
        groups.extend(interpreter.database.current("group"));
    }
    if groups.is_empty() {
        return Err(vec![call.missing(&["group_name"])]);
    }
    let mut ids = shared::expanded(&interpreter.database, &groups);
    if call.field("type_filter").is_some() {
        shared::filter_by_type(interpreter, call, &mut ids)?;
    }
    for id in ids {
        let class = interpreter.database.object(id).class;
        for (parameter, argument) in call.all() {
            let field = parameter.field;
            if matches!(field.name, "group_name" | "type_filter") {
                continue;
            }
            // A member that has no such attribute is left as it is, as a group mixes kinds.
            if let Some(cell) = class.cell_index(field.name) {
                let draft = interpreter.read_value(call, &field, argument, Some(id))?;
                interpreter.store(model::CellKey::new(id, cell), draft);
            }
        }
    }
    Ok(Flow::Next)
}
