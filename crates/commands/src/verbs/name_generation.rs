//! `defaults name_generation ...`: how names are made for objects that are given none.
//!
//! A name is the general prefix, the prefix of the kind, the number and the general suffix, joined
//! by underscores, as far as they are switched on: at first the prefix of the kind and the number. A
//! name that is in use gets `_2`, `_3`, ... behind it.

use model::{Database, ObjectId};
use schema::{Class, Field, Verb};

use super::{VerbEntry, defaults::keep_words, entry};
use crate::{Interpreter, names::Names};

const fn prefixes(path: &'static str, fields: &'static [Field]) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc: "what generated names of these kinds begin with" }, keep_words)
}

const fn prefix(name: &'static str) -> Field {
    Field::text(name).doc("what generated names of this kind begin with; an underscore follows")
}

pub const LAYOUT: VerbEntry = entry(
    Verb {
        path: "defaults name_generation layout",
        fields: &[
            Field::yes_no("prefix_active").default_word("no").doc("begin every name with the general prefix"),
            Field::text("prefix_text").doc("the general prefix"),
            Field::yes_no("entity_prefix").default_word("yes").doc("use the prefix of the kind"),
            Field::yes_no("integer_id").default_word("yes").doc("use a number"),
            Field::yes_no("suffix_active").default_word("no").doc("end every name with the general suffix"),
            Field::text("suffix_text").doc("the general suffix"),
        ],
        rules: &[],
        doc: "which pieces generated names have",
    },
    keep_words,
);
pub const MARKER: VerbEntry =
    prefixes("defaults name_generation marker", &[prefix("marker_prefix"), prefix("floating_marker_prefix")]);
pub const PART: VerbEntry = prefixes(
    "defaults name_generation part",
    &[
        prefix("part_prefix"),
        prefix("diff_prefix"),
        prefix("transfer_function_prefix"),
        prefix("linear_state_equation_prefix"),
        prefix("general_state_equation_prefix"),
    ],
);
pub const MODEL: VerbEntry = prefixes(
    "defaults name_generation model",
    &[prefix("model_prefix"), prefix("gravity_field_prefix"), prefix("sensor_prefix")],
);
pub const FORCE: VerbEntry = prefixes(
    "defaults name_generation force",
    &[
        prefix("beam_prefix"),
        prefix("bushing_prefix"),
        prefix("field_prefix"),
        prefix("single_component_force_prefix"),
        prefix("spring_damper_prefix"),
        prefix("multi_point_force_prefix"),
        prefix("force_vector_prefix"),
        prefix("torque_vector_prefix"),
        prefix("general_force_prefix"),
    ],
);
pub const CONSTRAINT: VerbEntry = prefixes(
    "defaults name_generation constraint",
    &[
        prefix("coupler_prefix"),
        prefix("gear_prefix"),
        prefix("joint_prefix"),
        prefix("jprim_prefix"),
        prefix("motion_prefix"),
        prefix("user_constraint_prefix"),
        prefix("point_curve_prefix"),
        prefix("curve_curve_prefix"),
        prefix("point_surface_prefix"),
    ],
);
pub const DATA_ELEMENT: VerbEntry = prefixes(
    "defaults name_generation data_element",
    &[
        prefix("curve_prefix"),
        prefix("spline_prefix"),
        prefix("variable_prefix"),
        prefix("array_prefix"),
        prefix("matrix_prefix"),
        prefix("plant_input_prefix"),
        prefix("plant_output_prefix"),
        prefix("plant_state_prefix"),
        prefix("string_prefix"),
    ],
);
pub const GEOMETRY: VerbEntry = prefixes(
    "defaults name_generation geometry",
    &[
        prefix("circle_prefix"),
        prefix("arc_prefix"),
        prefix("block_prefix"),
        prefix("cylinder_prefix"),
        prefix("ellipsoid_prefix"),
        prefix("frustum_prefix"),
        prefix("force_prefix"),
        prefix("spring_damper_prefix"),
        prefix("torus_prefix"),
        prefix("revolution_prefix"),
        prefix("extrusion_prefix"),
        prefix("note_prefix"),
        prefix("polyline_prefix"),
        prefix("bspline_prefix"),
        prefix("outline_prefix"),
    ],
);

const FAMILIES: &[&VerbEntry] = &[&MODEL, &PART, &MARKER, &FORCE, &CONSTRAINT, &DATA_ELEMENT, &GEOMETRY];

/// The parameter that sets the prefix of a class. The command that makes its objects tells: its last
/// word is the kind (`force create element_like beam`), unless a family of commands shares one.
fn parameter(class: &Class) -> Option<String> {
    let command = class.groups.iter().find(|g| g.creates)?.command;
    let words: Vec<&str> = command.split(' ').collect();
    let last = *words.last()?;
    let kind = match words.as_slice() {
        ["part", _, "equation", "differential_equation"] => "diff",
        ["part", "create", "rigid_body" | "point_mass", _] => "part",
        ["model", "create"] => "model",
        ["marker", "create"] => "marker",
        ["floating_marker", "create"] => "floating_marker",
        ["force", _, "body", _] => "gravity_field",
        ["force", _, _, "translational_spring_damper" | "rotational_spring_damper"] => "spring_damper",
        ["constraint", _, "joint", _] => "joint",
        ["constraint", _, "primitive_joint", _] => "jprim",
        ["constraint", _, "motion_generator"] => "motion",
        ["constraint", _, "user_defined"] => "user_constraint",
        ["data_element", _, kind, ..] => *kind,
        ["geometry" | "force" | "constraint" | "part", ..] | ["executive_control", _, "sensor"] => last,
        _ => return None,
    };
    Some(format!("{kind}_prefix"))
}

/// The settings live by parameter; a name that two families share is kept with its family.
fn setting(class: &Class) -> Option<String> {
    let parameter = parameter(class)?;
    let family = class.groups.iter().find(|g| g.creates)?.command.split(' ').next()?;
    let family = match family {
        "floating_marker" => "marker",
        "executive_control" => "model",
        "force" if parameter == "gravity_field_prefix" => "model",
        other => other,
    };
    Some(key(&format!("defaults name_generation {family}"), &parameter))
}

/// Where a word of a command is kept: with its family, where the name of the parameter says less.
pub fn key(path: &str, parameter: &str) -> String {
    match path.strip_prefix("defaults name_generation ") {
        Some(family) => format!("{family} {parameter}"),
        None => parameter.to_string(),
    }
}

struct Layout {
    before: String,
    number: bool,
    behind: String,
}

fn layout(database: &Database, class: &Class) -> Layout {
    let words = &database.settings().words;
    let word = |name: &str| words.get(&key(LAYOUT.verb.path, name)).map(String::as_str);
    let piece = |text: &str| format!("{}_", text.trim_end_matches('_').to_ascii_uppercase());
    let mut before = String::new();
    if word("prefix_active") == Some("yes") {
        before.push_str(&piece(word("prefix_text").unwrap_or_default()));
    }
    let number = word("integer_id") != Some("no");
    if word("entity_prefix") != Some("no") {
        match setting(class).and_then(|s| words.get(&s)) {
            Some(own) => before.push_str(&piece(own)),
            None => before.push_str(class.prefix),
        }
    }
    let mut behind = String::new();
    if word("suffix_active") == Some("yes") {
        behind = format!("_{}", word("suffix_text").unwrap_or_default().trim_start_matches('_').to_ascii_uppercase());
    }
    // A name of no pieces is none, and a number alone is no name.
    if before.is_empty() || before == "_" {
        before = class.prefix.to_string();
    }
    Layout { before, number, behind }
}

impl Interpreter {
    /// A free generated name.
    pub(crate) fn generate_name(&mut self, class: &'static Class, parent: Option<ObjectId>) -> String {
        let mut names = std::mem::take(&mut self.names);
        let name = self.name_from(&mut names, class, parent);
        self.names = names;
        name
    }

    /// The name that the next object of a class would get.
    pub(crate) fn next_name(&self, class: &'static Class, parent: Option<ObjectId>) -> String {
        self.name_from(&mut self.names.clone(), class, parent)
    }

    fn name_from(&self, names: &mut Names, class: &'static Class, parent: Option<ObjectId>) -> String {
        let Layout { before, number, behind } = layout(&self.database, class);
        if number && behind.is_empty() {
            return names.generate(&self.database, class, parent, &before);
        }
        let wanted = if number {
            format!("{}{behind}", names.generate(&self.database, class, parent, &before))
        } else {
            format!("{}{behind}", before.trim_end_matches('_'))
        };
        self.free_name(parent, &wanted)
    }
}

/// The settings as lines: the layout, and the prefixes that were set; in the long form every
/// parameter.
pub fn listing(database: &Database, brief: bool) -> Vec<String> {
    let words = &database.settings().words;
    let mut lines = Vec::new();
    for (k, entry) in std::iter::once(&&LAYOUT).chain(FAMILIES).enumerate() {
        for field in entry.verb.fields {
            let set = words.get(&key(entry.verb.path, field.name)).map(String::as_str);
            let default = match field.default {
                schema::Default::Word(word) => word,
                _ => "",
            };
            if k == 0 || !brief || set.is_some() {
                lines.push(format!("{:<30}: {}", field.name, set.unwrap_or(default)).trim_end().to_string());
            }
        }
    }
    lines
}
