//! Classes of objects, the command groups that make them, and commands that own no class.

use crate::{Field, Kind};

/// A condition over several parameters of one command. [`Rule::OneOf`] and [`Rule::AtLeastOne`]
/// hold for the command that creates; a `modify` command may leave everything out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Exactly one of these sets of parameters places the object; each set is given whole.
    OneOf(&'static [&'static [&'static str]]),
    /// At most one of these parameters in one command.
    AtMostOne(&'static [&'static str]),
    /// At least one of these parameters; with [`Rule::AtMostOne`], exactly one.
    AtLeastOne(&'static [&'static str]),
}

/// One family of commands that creates or modifies objects of a class: the beam has one, a rigid
/// part has three (`name_and_position`, `mass_properties`, `initial_velocity`).
#[derive(Clone, Copy, Debug)]
pub struct Group {
    /// `force create element_like beam`; `modify` in place of `create` follows from it. Several
    /// classes may share a command (`force attributes`); the object named then decides.
    pub command: &'static str,
    /// Whether the `create` form makes the object, or only sets cells of one that exists
    /// (`part create rigid_body mass_properties`).
    pub creates: bool,
    /// Parameter that names the object (`beam_name`); its `new_...` form renames on modify. Empty
    /// for settings of which a model has one set (`executive_control set ...`): the object is made
    /// by the first use, below the model of the field `model_name`.
    pub object: &'static str,
    /// Parameters other than the object's name, in the order exports write them. `adams_id` and
    /// `comments` are listed like any other.
    pub fields: &'static [Field],
    pub rules: &'static [Rule],
    /// One sentence of our own.
    pub doc: &'static str,
}

/// One kind of object.
#[derive(Clone, Copy, Debug)]
pub struct Class {
    /// Unique id, lower case: `beam`, `marker`, `joint_revolute`.
    pub id: &'static str,
    /// The word Adams uses in messages: `Beam`, `Marker`, `Joint`.
    pub word: &'static str,
    /// What else it counts as when a parameter asks for an object: `force`, `joint`, `frame`, ...
    pub families: &'static [&'static str],
    /// Class ids an object of this class may be a child of, the usual one first.
    pub parents: &'static [&'static str],
    /// Prefix of generated names: `BEAM_`.
    pub prefix: &'static str,
    /// Name of the solver statement: `BEAM`; `None` if the class has none.
    pub statement: Option<&'static str>,
    pub groups: &'static [Group],
}

impl Class {
    /// Number of cells of an object of this class.
    pub fn cell_count(&self) -> usize {
        self.groups.iter().map(|g| g.fields.len()).sum()
    }

    /// Index of a cell by the name of its field. The first field of that name counts: groups of
    /// one class share fields of equal name.
    pub fn cell_index(&self, name: &str) -> Option<usize> {
        self.fields().position(|f| f.name == name)
    }

    /// The field of a cell.
    ///
    /// # Panics
    /// If the class has no cell of that number, which only a mistake in Flexure can bring about.
    pub fn field(&self, cell: usize) -> &'static Field {
        let mut index = cell;
        for group in self.groups {
            if let Some(field) = group.fields.get(index) {
                return field;
            }
            index -= group.fields.len();
        }
        panic!("cell index belongs to the class");
    }

    /// All fields of all groups, in cell order.
    pub fn fields(&self) -> impl Iterator<Item = &'static Field> + use<> {
        self.groups.iter().flat_map(|g| g.fields.iter())
    }

    /// Whether an object of this class satisfies a parameter that asks for `wanted`.
    pub fn is(&self, wanted: &str) -> bool {
        wanted == "any" || self.id == wanted || self.families.contains(&wanted)
    }
}

impl PartialEq for Class {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}
impl Eq for Class {}

/// A command that owns no class; `commands` binds `path` to the function that runs it.
#[derive(Clone, Copy, Debug)]
pub struct Verb {
    /// Full keywords: `file command read`.
    pub path: &'static str,
    pub fields: &'static [Field],
    pub rules: &'static [Rule],
    pub doc: &'static str,
}

/// The classes and verbs known to a session; built once by the facade and passed on.
#[derive(Clone, Debug, Default)]
pub struct Registry {
    pub classes: Vec<&'static Class>,
    pub verbs: Vec<&'static Verb>,
}

impl Registry {
    pub fn class(&self, id: &str) -> Option<&'static Class> {
        self.classes.iter().copied().find(|c| c.id == id)
    }

    /// The groups of all classes that a command, as written in [`Group::command`], belongs to.
    pub fn groups(&self, command: &str) -> Vec<(&'static Class, &'static Group)> {
        let all = self.classes.iter().flat_map(|&class| class.groups.iter().map(move |group| (class, group)));
        all.filter(|(_, group)| group.command == command).collect()
    }

    /// Breaches of the rules a table must keep; empty for a sound registry. Tested once.
    pub fn check(&self) -> Vec<String> {
        let mut breaches = Vec::new();
        for class in &self.classes {
            for group in class.groups {
                for field in group.fields {
                    if field.doc.is_empty() {
                        breaches.push(format!("{}.{} has no doc", class.id, field.name));
                    }
                    if field.name == group.object {
                        breaches.push(format!("{}.{} repeats the object's name", class.id, field.name));
                    }
                    if let Kind::Object(_, wanted) = field.kind
                        && wanted != "any"
                        && !self.classes.iter().any(|c| c.is(wanted))
                    {
                        breaches.push(format!("{}.{} wants the unknown class {wanted}", class.id, field.name));
                    }
                }
            }
        }
        breaches
    }
}
