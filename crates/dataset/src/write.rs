//! A model as the text of a dataset: sections in View's order, objects by number.

use std::collections::{BTreeMap, HashSet};

use model::{Database, ObjectId};
use schema::{UnitName, UnitSystem};
use text::Diagnostic;

use crate::{
    Digits,
    ids::number_objects,
    layout::{Lines, banner, centred},
    number::number,
    read::{END_OF_MODEL_COMMENTS, NOT_WRITTEN, TITLE},
    statements, unit_words,
};

/// Mass of a part in model units: where it follows from the shapes of the part, only the caller
/// knows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    pub mass: f64,
    /// Marker at the centre of mass.
    pub center: Option<ObjectId>,
    /// Marker the inertias refer to, if it is another one.
    pub inertia_marker: Option<ObjectId>,
    /// xx, yy, zz, xy, xz, yz.
    pub inertia: [f64; 6],
}

/// Finds the mass of a part.
pub type MassOf<'a> = dyn Fn(&Database, ObjectId) -> Option<Mass> + 'a;

/// How to write.
#[derive(Clone, Copy, Default)]
pub struct Options<'a> {
    pub digits: Digits,
    /// Asked for parts that have no mass of their own given.
    pub mass: Option<&'a MassOf<'a>>,
}

/// A dataset, and what of the model is not in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    pub text: String,
    /// Each is also a comment line in the text.
    pub warnings: Vec<Diagnostic>,
}

/// Writes a model in the units in force. Objects without a number get one first, for good. What a
/// dataset cannot say becomes a comment and a warning, and so does what refers to it. An error means
/// that no dataset could stand for the model; numbers given by then stay.
pub fn write(database: &mut Database, model: ObjectId, options: Options<'_>) -> Result<Written, Vec<Diagnostic>> {
    number_objects(database, model)?;
    let mut unwritten = HashSet::new();
    loop {
        let known = unwritten.len();
        let mut writer = Writer {
            database,
            options,
            lines: Vec::new(),
            warnings: Vec::new(),
            errors: Vec::new(),
            troubles: Vec::new(),
            unwritten,
            skipped: BTreeMap::new(),
        };
        writer.model(model);
        if !writer.errors.is_empty() {
            return Err(writer.errors);
        }
        // An object may refer to one that turned out later to have no place: once more, until
        // nothing is left that refers to what is not there. Few objects are ever concerned.
        if writer.unwritten.len() == known {
            let mut text = writer.lines.join("\n");
            text.push('\n');
            return Ok(Written { text, warnings: writer.warnings });
        }
        unwritten = writer.unwritten;
    }
}

/// Sections after the parts: banner and statements in the order exports write them.
const SECTIONS: &[(&str, &[&str])] = &[
    ("CONSTRAINTS", &["JOINT", "JPRIM", "COUPLER", "GEAR", "GCON", "MOTION"]),
    ("FORCES", &["BEAM", "BUSHING", "FIELD", "SFORCE", "SPRINGDAMPER", "VFORCE", "VTORQUE", "GFORCE", "NFORCE"]),
    ("DATA STRUCTURES", &["SPLINE", "MATRIX", "VARIABLE", "ARRAY", "CURVE", "STRING"]),
    ("EQUATIONS", &["DIFF", "LSE", "TFSISO", "GSE"]),
    ("HIGHER PAIR CONTACTS", &["PTCV", "CVCV"]),
    ("OUTPUT", &["REQUEST"]),
    ("EXECUTION CONTROL", &["SENSOR"]),
];

/// Whether the writer knows a statement.
pub(crate) fn known(statement: &str) -> bool {
    ["PART", "POINT_MASS", "MARKER", "GRAPHICS", "ACCGRAV", "CONTACT"].contains(&statement)
        || statements::is_setting(statement)
        || SECTIONS.iter().any(|(_, kinds)| kinds.contains(&statement))
}

pub(crate) struct Writer<'a> {
    pub database: &'a Database,
    pub options: Options<'a>,
    lines: Vec<String>,
    warnings: Vec<Diagnostic>,
    errors: Vec<Diagnostic>,
    /// Why the statement under construction cannot stand.
    troubles: Vec<Diagnostic>,
    /// Objects whose statement is only a comment.
    unwritten: HashSet<ObjectId>,
    /// Kinds of objects without a statement, counted by their word, and why that is.
    skipped: BTreeMap<(&'static str, &'static str), usize>,
}

impl Writer<'_> {
    fn model(&mut self, model: ObjectId) {
        let name = self.database.object(model).name.clone();
        let title = self.database.text(model, "title").filter(|title| !title.trim().is_empty());
        let title = title.map_or_else(|| format!("{TITLE}{name}"), |title| title.replace(['\n', '\r'], " "));
        self.lines.push(title);
        let comments = statements::texts(self.database, model, "comments");
        self.lines.extend(comments.iter().map(|c| comment(c)));
        // What stands behind the line that ends them belongs to UNITS.
        if !comments.is_empty() && !comments.iter().any(|c| c.trim() == END_OF_MODEL_COMMENTS) {
            self.lines.push(comment(END_OF_MODEL_COMMENTS));
        }
        self.banner("SYSTEM UNITS");
        self.units();
        self.banner("PARTS");
        self.bodies(model);
        self.sections(model);
        self.gravity(model);
        self.settings(model);
        self.rest(model);
        self.lines.push("!".to_string());
        self.lines.push("END".to_string());
    }

    fn banner(&mut self, title: &str) {
        self.lines.push("!".to_string());
        self.lines.push(banner(title));
    }

    fn units(&mut self) {
        let units: &UnitSystem = self.database.units();
        let mut lines = Lines::new("UNITS", None);
        for (keyword, unit) in unit_words::arguments(units) {
            if let Some(word) = unit_words::solver_unit(unit.name) {
                lines.argument(keyword, word);
            } else {
                let message = format!("a dataset has no word for the unit `{}`", unit.name);
                self.errors.push(Diagnostic::error("dataset/unknown-unit", message));
            }
        }
        if let Some(factor) = units.consistency_factor {
            lines.argument("UCF", &number(factor, self.options.digits));
        }
        self.lines.push("!".to_string());
        self.lines.extend(lines.finish());
    }

    /// Objects of some statements below a parent, by number.
    fn by_number(&self, parent: ObjectId, wanted: impl Fn(&str, &str) -> bool) -> Vec<ObjectId> {
        let mut found: Vec<_> = self.database.subtree(parent);
        found.retain(|&id| {
            let class = self.database.object(id).class;
            id != parent && class.statement.is_some_and(|s| wanted(s, class.id))
        });
        found.sort_by_key(|&id| (self.database.integer(id, "adams_id").unwrap_or(0), id));
        found
    }

    fn bodies(&mut self, model: ObjectId) {
        let mut bodies = self.by_number(model, |s, _| s == "PART" || s == "POINT_MASS");
        bodies.sort_by_key(|&id| {
            let class = self.database.object(id).class;
            (class.id != "ground", class.statement == Some("POINT_MASS"))
        });
        for body in bodies {
            let class = self.database.object(body).class;
            self.banner(match class.id {
                "ground" => "Ground",
                "point_mass" => "Point Mass",
                _ => "Part",
            });
            self.object(body);
            let markers = self.by_number(body, |s, _| s == "MARKER");
            let shapes = self.by_number(body, |s, class| s == "GRAPHICS" && !statements::moves(class));
            for id in markers.into_iter().chain(shapes) {
                self.object(id);
            }
        }
    }

    fn sections(&mut self, model: ObjectId) {
        let contacts = self.by_number(model, |s, _| s == "CONTACT");
        if !contacts.is_empty() {
            self.banner("CONTACTS");
            for id in contacts {
                self.object(id);
            }
        }
        let dynamic = self.by_number(model, |s, class| s == "GRAPHICS" && statements::moves(class));
        if !dynamic.is_empty() {
            self.banner("DYNAMIC GRAPHICS");
            for id in dynamic {
                self.object(id);
            }
        }
        for (title, kinds) in SECTIONS {
            let groups: Vec<_> = kinds.iter().map(|kind| self.by_number(model, |s, _| s == *kind)).collect();
            // Measures count as requests in the schema, but have no number.
            let (objects, measures): (Vec<_>, Vec<_>) = groups
                .into_iter()
                .flatten()
                .partition(|id| self.database.object(*id).class.cell_index("adams_id").is_some());
            for id in measures {
                self.skip(id, "measures are not part of a dataset");
            }
            if !objects.is_empty() {
                self.banner(title);
                for id in objects {
                    self.object(id);
                }
            }
        }
    }

    fn gravity(&mut self, model: ObjectId) {
        let fields = self.by_number(model, |s, _| s == "ACCGRAV");
        if let Some((&last, others)) = fields.split_last() {
            for &other in others {
                let name = self.database.full_name(other);
                self.warn("dataset/second-gravity", format!("`{name}` is not written: a dataset has one gravity"));
            }
            self.banner("GRAVITATIONAL ACCELERATION");
            let lines = statements::gravity(self, last);
            self.lines.push("!".to_string());
            let comments = statements::texts(self.database, last, "comments");
            self.lines.extend(comments.iter().map(|c| comment(c)));
            // Exports do not name what has the usual name.
            let name = self.name_in_section(last);
            let inactive = self.database.text(last, "active").is_some_and(|word| word == "off");
            if inactive || name != statements::GRAVITY {
                self.lines.push(centred(&format!("adams_view_name='{name}'")));
            }
            self.commented(last, lines.finish());
        }
    }

    fn settings(&mut self, model: ObjectId) {
        self.banner("ANALYSIS SETTINGS");
        for statement in statements::setting_names() {
            let object = self.by_number(model, |s, _| s == statement).pop();
            if let Some(lines) = statements::settings(self, statement, object) {
                self.lines.push("!".to_string());
                self.lines.extend(lines.finish());
            }
        }
    }

    /// Names what acts, or what a dataset has a statement for, and the writer has none.
    fn rest(&mut self, model: ObjectId) {
        const ACTING: [&str; 4] = ["force", "constraint", "contact", "equation"];
        let mut unwritten = self.by_number(model, |s, _| !known(s));
        unwritten.extend(self.database.subtree(model).into_iter().filter(|id| {
            let class = self.database.object(*id).class;
            class.statement.is_none() && ACTING.iter().any(|family| class.families.contains(family))
        }));
        for id in unwritten {
            let name = self.database.full_name(id);
            let word = self.database.object(id).class.word;
            self.warn("dataset/not-written", format!("{word} `{name}` is not written yet"));
        }
        for ((word, why), count) in std::mem::take(&mut self.skipped) {
            self.warn("dataset/kind-not-written", format!("{count} {word}: {why}"));
        }
    }

    /// One object: its comments, its name, its statement; inactive objects, and what cannot be said,
    /// as comments.
    fn object(&mut self, id: ObjectId) {
        let statement = statements::statement(self, id);
        let troubles = std::mem::take(&mut self.troubles);
        if !troubles.is_empty() {
            self.unwritten.insert(id);
        }
        for trouble in &troubles {
            self.warn(trouble.code, trouble.message.clone());
        }
        let Some(lines) = statement else { return };
        self.lines.push("!".to_string());
        let name = self.name_in_section(id);
        let comments = statements::texts(self.database, id, "comments");
        self.lines.extend(comments.iter().map(|c| comment(c)));
        self.lines.push(centred(&format!("adams_view_name='{name}'")));
        if let Some(units) = self.database.text(id, "units").filter(|units| !units.is_empty()) {
            self.lines.push(centred(&format!("adams_view_units='{units}'")));
        }
        self.commented(id, lines.finish());
    }

    fn commented(&mut self, id: ObjectId, lines: Vec<String>) {
        let inactive = self.database.text(id, "active").is_some_and(|word| word == "off");
        let mark = if inactive || self.unwritten.contains(&id) { "!" } else { "" };
        self.lines.extend(lines.into_iter().map(|line| format!("{mark}{line}")));
    }

    /// Name below the model or the body that owns the object; steps joined by dots.
    fn name_in_section(&self, id: ObjectId) -> String {
        let mut name = self.database.object(id).name.clone();
        let mut next = self.database.object(id).parent;
        while let Some(parent) = next {
            let object = self.database.object(parent);
            if object.class.id == "model" || object.class.is("body") {
                break;
            }
            name = format!("{}.{name}", object.name);
            next = object.parent;
        }
        name
    }

    // ---- for the statements ----

    /// Numbers of a cell in the units of the dataset: angles in degrees, what is per angle or per time
    /// of an angle in radians. Values entered in those units come back as they are.
    pub fn plain_numbers(&self, id: ObjectId, name: &str) -> Option<Vec<f64>> {
        let cell = self.database.cell(id, name)?;
        let class = self.database.object(id).class;
        let dimension = class.field(class.cell_index(name)?).dimension;
        let angle = if statements::is_angle(dimension) { "degrees" } else { "radians" };
        let units = self.database.units();
        let target = UnitSystem { angle: UnitName::find(angle).unwrap_or(units.angle), ..*units };
        let entered = self.database.unit_system(cell.units).factor(dimension);
        let written = target.factor(dimension);
        let mut values = cell.value.as_numbers()?;
        if entered != written {
            values.iter_mut().for_each(|x| *x *= entered / written);
        }
        Some(values)
    }

    /// An object of a kind that has no statement; each kind is reported once.
    pub fn skip(&mut self, id: ObjectId, why: &'static str) {
        *self.skipped.entry((self.database.object(id).class.word, why)).or_default() += 1;
    }

    /// Something of the model that is not in the dataset.
    pub fn warn(&mut self, code: &'static str, message: String) {
        self.lines.push("!".to_string());
        self.lines.push(format!("!{NOT_WRITTEN}{message}"));
        self.warnings.push(Diagnostic::warning(code, message));
    }

    /// Something without which the statement under construction would be wrong: it becomes a comment.
    pub fn fail(&mut self, code: &'static str, message: String) {
        if !self.troubles.iter().any(|t| t.message == message) {
            self.troubles.push(Diagnostic::warning(code, message));
        }
    }

    /// What `part` builds, unless something failed in it: then the messages of what failed.
    pub fn attempt<T>(&mut self, part: impl FnOnce(&mut Self) -> T) -> (T, Vec<Diagnostic>) {
        let earlier = std::mem::take(&mut self.troubles);
        let built = part(self);
        (built, std::mem::replace(&mut self.troubles, earlier))
    }

    /// Reports an argument that is left out while the rest of its statement stands.
    pub fn leave_out(&mut self, argument: &str, troubles: Vec<Diagnostic>) {
        for trouble in troubles {
            self.warn(trouble.code, format!("{}: `{argument}`", trouble.message));
        }
    }

    /// Number of an object in the dataset; its name and a failure if it has none.
    pub fn id_of(&mut self, user: ObjectId, id: ObjectId) -> String {
        let Some(object) = self.database.get(id) else {
            let name = self.database.full_name(user);
            self.fail("dataset/no-statement", format!("`{name}` refers to an object that was deleted"));
            return "?".to_string();
        };
        let number = self.database.integer(id, "adams_id").filter(|n| *n > 0);
        let place = object.class.statement.is_some_and(known) && (user == id || !self.unwritten.contains(&id));
        if let Some(number) = number.filter(|_| place) {
            return number.to_string();
        }
        let (name, other) = (self.database.full_name(user), self.database.full_name(id));
        let message = if self.unwritten.contains(&id) {
            format!("`{name}` refers to `{other}`, which is not written")
        } else {
            format!("`{name}` refers to `{other}`, which has no place in a dataset")
        };
        self.fail("dataset/no-statement", message);
        other
    }
}

/// A comment line; the reader takes the blank away again, which tells it from a mark that only parts
/// statements. Without it stands what would pass for a message of ours.
fn comment(text: &str) -> String {
    let blank = if text.starts_with(NOT_WRITTEN.trim_start()) { "" } else { " " };
    format!("!{blank}{}", text.replace(['\n', '\r'], " "))
}
