//! What many verbs share: fields of one meaning, the words of units, choosing objects by type, and
//! the answer of commands that are known, checked, and not executed.

use model::{Database, ObjectId, Value};
use schema::{Class, Field, Kind, Names};
use text::Diagnostic;

use crate::{Interpreter, call::Call, interpreter::Flow};

pub type Outcome<T> = Result<T, Vec<Diagnostic>>;

pub const MODEL: Field = Field::object("model_name", "model").current().doc("model");
pub const TYPE_FILTER: Field = Field::text("type_filter").doc("take only objects of this type");
pub const EXPAND_GROUPS: Field =
    Field::yes_no("expand_groups").default_word("no").doc("take the members of groups in place of the groups");
pub const VIEWS: Field = Field::texts("view_name").doc("views that show the object");
pub const FILE: Field = Field::new("file_name", Kind::File).required().doc("file");
pub const OPTIONAL_FILE: Field = Field::new("file_name", Kind::File).doc("file");
pub const COMMENTS: Field = Field::texts("comments").doc("lines kept with the object and written before it");
pub const SHOW: Field = Field::on_off("write_to_terminal").default_word("on").doc("show it in the information window");

pub const LENGTHS: &[&str] = &[
    "mm",
    "cm",
    "meter",
    "km",
    "inch",
    "foot",
    "mile",
    "micrometer",
    "nanometer",
    "angstrom",
    "microinch",
    "mils",
    "yard",
];
pub const FORCES: &[&str] = &[
    "newton",
    "knewton",
    "dyne",
    "pound_force",
    "kpound_force",
    "kg_force",
    "ounce_force",
    "millinewton",
    "centinewton",
    "poundal",
    "micronewton",
    "nanonewton",
    "meganewton",
];
pub const MASSES: &[&str] = &[
    "kg",
    "gram",
    "pound_mass",
    "kpound_mass",
    "slug",
    "slinch",
    "ounce_mass",
    "tonne",
    "milligram",
    "microgram",
    "nanogram",
    "us_ton",
];
pub const TIMES: &[&str] = &["second", "millisecond", "microsecond", "nanosecond", "minute", "hour", "day"];
pub const ANGLES: &[&str] = &["degrees", "radians", "angular_minutes", "angular_seconds", "revolutions"];

/// Units of a file where they differ from those in force.
pub const LENGTH: Field = Field::choice("length", LENGTHS).doc("unit of length in the file");
pub const FORCE: Field = Field::choice("force", FORCES).doc("unit of force in the file");
pub const MASS: Field = Field::choice("mass", MASSES).doc("unit of mass in the file");
pub const TIME: Field = Field::choice("time", TIMES).doc("unit of time in the file");
pub const ANGLE: Field = Field::choice("angle", ANGLES).doc("unit of angles in the file");

/// Whether objects of a class pass a type filter.
pub fn is_of_type(class: &Class, wanted: &str) -> bool {
    class.is(&wanted.to_ascii_lowercase()) || class.word.eq_ignore_ascii_case(wanted)
}

/// Applies `type_filter`, if given.
pub fn filter_by_type(interpreter: &mut Interpreter, call: &Call, ids: &mut Vec<ObjectId>) -> Outcome<()> {
    if let Some(wanted) = interpreter.word_of(call, "type_filter")? {
        ids.retain(|id| is_of_type(interpreter.database.object(*id).class, &wanted));
    }
    Ok(())
}

/// The members of a group.
pub fn members(database: &Database, group: ObjectId) -> Vec<ObjectId> {
    database.value(group, "objects_in_group").map(Value::objects).unwrap_or_default()
}

/// Groups replaced by their members, theirs by theirs, each object once.
pub fn expanded(database: &Database, ids: &[ObjectId]) -> Vec<ObjectId> {
    let mut seen = indexmap::IndexSet::new();
    let mut found = indexmap::IndexSet::new();
    let mut open: Vec<ObjectId> = ids.iter().rev().copied().collect();
    while let Some(id) = open.pop() {
        if database.object(id).class.id != "group" {
            found.insert(id);
        } else if seen.insert(id) {
            open.extend(members(database, id).into_iter().rev());
        }
    }
    found.into_iter().collect()
}

/// A command whose words and values are checked, and that does nothing else: it is named once in a
/// run, with what that means.
pub fn refuse(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let mut unmade = Vec::new();
    for (parameter, argument) in call.all() {
        let field = parameter.field;
        if let Kind::Object(Names::New | Names::OldOrNew, _) = field.kind {
            unmade.push(call.program.word(argument.value_span).to_ascii_lowercase());
        } else {
            interpreter.read_value(call, &field, argument, None)?;
        }
    }
    interpreter.unmade.extend(unmade);
    interpreter.not_supported(&call.path, call.span);
    Ok(Flow::Skipped)
}

/// Says that arguments are understood and change nothing here.
pub fn without_effect(interpreter: &mut Interpreter, call: &Call, why: &str) {
    let names: Vec<String> = call.all().map(|(p, _)| p.name.to_string()).collect();
    if !names.is_empty() {
        interpreter.report.diagnostics.push(
            Diagnostic::warning("command/no-effect", format!("{} of `{}` has no effect", names.join(", "), call.path))
                .at(call.span, "understood, not used")
                .note(why.to_string()),
        );
    }
}
