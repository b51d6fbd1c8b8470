//! `model merge` and `part merge rigid_body`: what is in one model or part, once more in another.
//! The source stays as it is.

use glam::{DMat3, DVec3};
use model::{ObjectId, Pose, Value, rotation_of};
use schema::{Field, Kind, Names, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry,
    shared::{self, Outcome},
    twins::Twins,
};
use crate::{Interpreter, call::Call, interpreter::Flow, lookup, lookup::NewName, place};

pub const MODEL: VerbEntry = entry(
    Verb {
        path: "model merge",
        fields: &[
            Field::object("model_name", "model").required().doc("model whose objects are taken"),
            Field::object("into_model_name", "model").required().doc("model that receives them"),
            Field::location("translation").doc("shift of the parts in global axes, after the turn"),
            Field::orientation("rotation").doc("turn of the parts about the global origin"),
            Field::choice("duplicate_parts", &["merge", "rename"])
                .default_word("rename")
                .doc("whether parts of equal names become one, or the one that arrives is renamed"),
            Field::new("add_to_group_name", Kind::Object(Names::OldOrNew, "group"))
                .doc("group that receives the objects; made if it does not exist"),
        ],
        rules: &[],
        doc: "puts a copy of all objects of a model into another model",
    },
    merge_models,
);

pub const PART: VerbEntry = entry(
    Verb {
        path: "part merge rigid_body",
        fields: &[
            Field::object("part_name", "body").required().doc("part whose markers and shapes are taken"),
            Field::object("into_part_name", "body").required().doc("part that receives them"),
        ],
        rules: &[],
        doc: "puts a copy of the markers and shapes of a part, where they are, into another part",
    },
    merge_parts,
);

fn two(interpreter: &mut Interpreter, call: &Call, names: [&str; 2]) -> Outcome<(ObjectId, ObjectId)> {
    let mut found = Vec::new();
    for name in names {
        found.push(interpreter.object_argument(call, name)?.ok_or_else(|| vec![call.missing(&[name])])?);
    }
    if found[0] == found[1] {
        return Err(vec![
            Diagnostic::error("merge/same", "nothing can be merged into itself")
                .at(call.span, format!("`{}` twice", interpreter.database.full_name(found[0]))),
        ]);
    }
    Ok((found[0], found[1]))
}

fn merge_parts(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (source, target) = two(interpreter, call, ["part_name", "into_part_name"])?;
    let twins = Twins::from([(source, target)]);
    let mut moving = Moving { shift: Pose::GLOBAL, taken: Vec::new(), placed: Vec::new() };
    moving.take_children(interpreter, source, target);
    interpreter.warn_about_merged_mass(source, target, call);
    moving.put(interpreter, twins, call)?;
    Ok(Flow::Next)
}

fn merge_models(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let (source, target) = two(interpreter, call, ["model_name", "into_model_name"])?;
    let merge = interpreter.word_of(call, "duplicate_parts")?.as_deref() == Some("merge");
    let shift = shift_of(interpreter, call)?;
    let made = interpreter.merge_model(source, target, merge, shift, call)?;
    if let Some(argument) = call.argument("add_to_group_name") {
        let typed = interpreter.text_argument(call, argument)?;
        let group = match lookup::search_one(&interpreter.database, &typed, "group") {
            Some(group) => group,
            None => interpreter.new_group(&typed, Some(target), argument.value_span)?,
        };
        let mut members = shared::members(&interpreter.database, group);
        members.extend(made);
        interpreter.database.set_value(group, "objects_in_group", Value::Objects(members));
    }
    Ok(Flow::Next)
}

/// The turn about the global origin and the shift behind it.
fn shift_of(interpreter: &mut Interpreter, call: &Call) -> Outcome<Pose> {
    let numbers = |i: &mut Interpreter, name: &str| -> Outcome<Option<Vec<f64>>> {
        let (Some(argument), Some(field)) = (call.argument(name), call.field(name).copied()) else { return Ok(None) };
        Ok(i.read_value(call, &field, argument, None)?.value.as_numbers())
    };
    let origin = match numbers(interpreter, "translation")? {
        Some(v) => place::cartesian(&interpreter.database, &v),
        None => DVec3::ZERO,
    };
    let rotation = match numbers(interpreter, "rotation")?.as_deref() {
        Some(&[a, b, c]) => {
            let angle = interpreter.database.units().angle.si;
            rotation_of(interpreter.database.settings().sequence, [a, b, c].map(|x| x * angle))
        }
        _ => DMat3::IDENTITY,
    };
    Ok(Pose { origin, rotation })
}

/// Objects on their way, and where those with a place go.
struct Moving {
    shift: Pose,
    taken: Vec<(ObjectId, NewName)>,
    /// Originals with their new place in global axes.
    placed: Vec<(ObjectId, Pose)>,
}

impl Moving {
    fn take(&mut self, interpreter: &Interpreter, id: ObjectId, parent: Option<ObjectId>, name: &str) {
        // Names that are taken, by objects that are there or by others on their way, get a number.
        let mut free = interpreter.free_name(parent, name);
        let mut number = 2;
        while self.taken.iter().any(|(_, n)| n.parent == parent && n.name.eq_ignore_ascii_case(&free)) {
            free = interpreter.free_name(parent, &format!("{name}_{number}"));
            number += 1;
        }
        self.taken.push((id, NewName { parent, name: free }));
        if interpreter.database.object(id).class.cell_index("location").is_some() {
            self.placed.push((id, self.shift.then(&interpreter.database.global_pose(id))));
        }
    }

    fn take_children(&mut self, interpreter: &Interpreter, from: ObjectId, to: ObjectId) {
        for child in interpreter.database.object(from).children.clone() {
            let name = interpreter.database.object(child).name.clone();
            self.take(interpreter, child, Some(to), &name);
        }
    }

    /// Makes the twins, each where it belongs; returns those that were taken one by one.
    fn put(self, interpreter: &mut Interpreter, known: Twins, call: &Call) -> Outcome<Vec<ObjectId>> {
        let twins = interpreter.make_twins(&self.taken, known, "", call.span)?;
        let mut changed = Vec::new();
        for (original, pose) in self.placed {
            let Some(&twin) = twins.get(&original) else { continue };
            let now = interpreter.database.global_pose(twin);
            if !now.origin.abs_diff_eq(pose.origin, 1e-12) || !now.rotation.abs_diff_eq(pose.rotation, 1e-14) {
                interpreter.put_at(twin, &pose, &mut changed);
            }
        }
        interpreter.recompute(&changed, call.span)?;
        Ok(self.taken.iter().filter_map(|(id, _)| twins.get(id).copied()).collect())
    }
}

impl Interpreter {
    /// Copies all objects of a model into another; parts of equal names are renamed.
    pub(crate) fn merge_into(&mut self, source: ObjectId, target: ObjectId, call: &Call) -> Outcome<()> {
        self.merge_model(source, target, false, Pose::GLOBAL, call).map(drop)
    }

    fn merge_model(
        &mut self,
        source: ObjectId,
        target: ObjectId,
        merge: bool,
        shift: Pose,
        call: &Call,
    ) -> Outcome<Vec<ObjectId>> {
        let mut moving = Moving { shift, taken: Vec::new(), placed: Vec::new() };
        let mut twins = Twins::from([(source, target)]);
        for child in self.database.object(source).children.clone() {
            let object = self.database.object(child);
            let (class, name) = (object.class, object.name.clone());
            let same = self.database.child(Some(target), &name, class.id);
            let one_each = class.id == "ground" || merge && class.is("body");
            match same {
                Some(same) if one_each => {
                    twins.insert(child, same);
                    moving.take_children(self, child, same);
                    self.warn_about_merged_mass(child, same, call);
                }
                // Settings: a model has one set, and the receiving model keeps its own.
                Some(same) if class.groups.iter().all(|g| g.object.is_empty()) => {
                    twins.insert(child, same);
                }
                Some(same) if class.id == "material" && self.equal_numbers(child, same) => {
                    twins.insert(child, same);
                }
                _ => moving.take(self, child, Some(target), &name),
            }
        }
        moving.put(self, twins, call)
    }

    /// A new group that holds nothing.
    pub(crate) fn new_group(&mut self, typed: &str, model: Option<ObjectId>, span: text::Span) -> Outcome<ObjectId> {
        let Some(class) = self.registry.class("group") else { return Err(Vec::new()) };
        let mut place = lookup::new_name(&self.database, &self.registry, class, typed, span).map_err(|e| vec![e])?;
        if !typed.starts_with('.') {
            place.parent = model.or(place.parent);
        }
        let id = self
            .database
            .create(class, place.parent, &place.name)
            .map_err(|t| vec![lookup::taken(&self.database, class, typed, t.0, span)])?;
        self.names.created(&self.database, id);
        Ok(id)
    }

    /// Whether all numbers of two objects of one class are equal.
    fn equal_numbers(&self, a: ObjectId, b: ObjectId) -> bool {
        let fields = self.database.object(a).class.fields();
        fields.filter(|f| f.name != "adams_id").all(|f| {
            match (self.database.si_numbers(a, f.name), self.database.si_numbers(b, f.name)) {
                (Some(x), Some(y)) => {
                    x.len() == y.len() && x.iter().zip(&y).all(|(x, y)| (x - y).abs() <= 1e-12 * x.abs())
                }
                (x, y) => x.is_none() && y.is_none(),
            }
        })
    }

    fn warn_about_merged_mass(&mut self, source: ObjectId, target: ObjectId, call: &Call) {
        if self.database.number(source, "mass").is_some_and(|m| m != 0.0) {
            let [from, into] = [source, target].map(|id| self.database.full_name(id));
            self.report.diagnostics.push(
                Diagnostic::warning("merge/mass", format!("the mass of `{from}` is not added to `{into}`"))
                    .at(call.span, "markers and shapes are merged, mass properties are not")
                    .help(format!("`list_info aggregate_mass part_names = {from}, {into}` gives those of both")),
            );
        }
    }
}
