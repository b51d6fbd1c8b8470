//! A model as a command file in the layout of exports. The order makes every object exist before
//! it is referred to; what refers back and forth, functions and expressions, is filled in at the
//! end by modify commands.

mod arguments;

use model::{Database, ObjectId, UnitsId, Value};
use schema::{Class, Dimension, Field, Group};

use crate::{kept::Kept, number, parameters::is_attributes, place};

/// The commands that build a model, without those that its session has skipped.
pub fn write_model(database: &Database, model: ObjectId) -> String {
    write(database, model, &[])
}

/// The commands that build a model, with skipped ones as they were typed.
pub(crate) fn write(database: &Database, model: ObjectId, kept: &[&Kept]) -> String {
    let mut writer =
        Writer { database, out: String::new(), frame: None, order: indexmap::IndexSet::new(), later: Vec::new() };
    writer.header(model);
    writer.data(model);
    writer.materials(model);
    writer.bodies(model);
    writer.elements(model);
    writer.dynamic_graphics();
    writer.kept(model, kept);
    writer.late(model);
    writer.footer(model);
    writer.out
}

struct Writer<'a> {
    database: &'a Database,
    out: String,
    /// The default frame as the commands written so far have set it.
    frame: Option<ObjectId>,
    /// Objects in the order of their commands, which is the order in which they are made again.
    order: indexmap::IndexSet<ObjectId>,
    /// Shapes whose commands must wait until what they name is made.
    later: Vec<ObjectId>,
}

/// Which cells of an object a command shows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// Everything; functions empty, expressions by their present value.
    Create,
    Functions,
    Expressions,
}

impl Writer<'_> {
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// A title across 80 columns.
    fn banner(&mut self, title: &str) {
        self.line("!");
        let width = 78usize.saturating_sub(title.chars().count() + 2);
        let left = width / 2;
        let dashes = |n: usize| "-".repeat(n);
        self.line(&format!("!{} {title} {}!", dashes(left), dashes(width - left)));
        self.line("!");
        self.line("!");
    }

    fn command(&mut self, path: &str, arguments: &[(String, String)]) {
        self.out.push_str(path);
        for (name, value) in arguments {
            self.out.push_str("  &\n   ");
            self.out.push_str(name);
            self.out.push_str(" = ");
            self.out.push_str(value);
        }
        self.out.push_str("\n!\n");
    }

    fn name(&self, id: ObjectId) -> String {
        self.database.full_name(id)
    }

    // ---- sections ----

    fn header(&mut self, model: ObjectId) {
        let settings = self.database.settings();
        let units = self.database.units();
        self.line("! CMD Version:2");
        self.banner("Default Units for Model");
        self.units(settings.units);
        let word = |name: &str, word: &str| (name.to_string(), word.to_string());
        self.command(
            "defaults units",
            &[word("coordinate_system_type", "cartesian"), word("orientation_type", "body313")],
        );
        self.banner("Default Attributes for Model");
        let mut attributes = Vec::new();
        for (name, default) in
            [("inheritance", Some("bottom_up")), ("icon_visibility", Some("on")), ("grid_visibility", Some("off"))]
        {
            let value = settings.words.get(name).map(String::as_str).or(default);
            attributes.extend(value.map(|v| word(name, v)));
        }
        for name in ["size_of_icons", "spacing_for_grid"] {
            if let Some(metres) = settings.words.get(name).and_then(|t| t.parse::<f64>().ok()) {
                attributes.push(word(name, &number::real(metres / units.factor(Dimension::LENGTH))));
            }
        }
        self.command("defaults attributes", &attributes);
        self.banner("Adams View Model");
        let object = self.database.object(model);
        let mut arguments = vec![word("model_name", &model::quoted(&object.name))];
        arguments.extend(self.arguments(model, &object.class.groups[0], Phase::Create));
        self.command("model create", &arguments);
        self.line("view erase");
        self.line("!");
    }

    /// The command that sets a system of units.
    fn units(&mut self, id: UnitsId) {
        let units = self.database.unit_system(id);
        let word = |name: &str, word: &str| (name.to_string(), word.to_string());
        let mut arguments = vec![
            word("length", units.length.name),
            word("angle", if units.angle.name == "degrees" { "deg" } else { units.angle.name }),
            word("force", units.force.name),
            word("mass", units.mass.name),
            word("time", if units.time.name == "second" { "sec" } else { units.time.name }),
        ];
        if let Some(factor) = units.consistency_factor {
            arguments.push(word("units_consistency_factor", &number::real(factor)));
        }
        self.command("defaults units", &arguments);
    }

    /// Splines, arrays, matrices and the like, which what comes later refers to; but for those that
    /// refer to something later themselves.
    fn data(&mut self, model: ObjectId) {
        let found = self.children(model, |c| c.is("data_element") && !c.is("measure"));
        let mut begun = false;
        for id in self.in_order(found) {
            if self.named_by(id).any(|o| !self.order.contains(&o)) {
                continue;
            }
            if !begun {
                begun = true;
                self.banner("Data storage");
            }
            self.object(id);
        }
    }

    /// The objects that the command of an object names.
    fn named_by(&self, id: ObjectId) -> impl Iterator<Item = ObjectId> {
        let cells = self.database.object(id).cells.values();
        cells.filter(|c| !matches!(c.value, Value::Function(_))).flat_map(|c| c.value.objects())
    }

    fn materials(&mut self, model: ObjectId) {
        let found = self.children(model, |c| c.id == "material");
        if !found.is_empty() {
            self.banner("Materials");
            for id in found {
                self.object(id);
            }
        }
    }

    fn bodies(&mut self, model: ObjectId) {
        self.banner("Rigid Parts");
        self.line("! Create parts and their dependent markers and graphics");
        let mut bodies = self.children(model, |c| c.is("body"));
        // The ground is there already; its markers come first.
        bodies.sort_by_key(|id| self.database.object(*id).class.id != "ground");
        let ground = self.database.child(Some(model), "ground", "ground");
        for id in bodies {
            let object = self.database.object(id);
            self.order.insert(id);
            self.banner(&object.name.clone());
            if Some(id) == ground {
                self.line("! ****** Ground Part ******");
                self.line("!");
                self.command("defaults model", &[("part_name".into(), "ground".into())]);
                self.ground_comments(id);
            } else {
                if let Some(ground) = ground {
                    self.default_frame(ground);
                }
                if let Some(group) = object.class.groups.iter().find(|g| g.creates) {
                    self.create(id, group);
                }
            }
            self.default_frame(id);
            let children = object.children.clone();
            self.line("! ****** Markers for current part ******");
            self.line("!");
            for &child in &children {
                let class = self.database.object(child).class;
                if class.is("frame") {
                    self.object(child);
                }
            }
            let floating = |class: &Class| class.id == "floating_marker";
            if children.iter().any(|c| floating(self.database.object(*c).class)) {
                self.line("! ****** Floating Markers for current part ******");
                self.line("!");
                for &child in children.iter().filter(|c| floating(self.database.object(**c).class)) {
                    self.object(child);
                }
            }
            for group in object.class.groups.iter().filter(|g| !g.creates && !is_attributes(g.command)) {
                if object.class.id == "ground" {
                    // A ground has no mass and no velocity, but it may be of some material.
                    let values = self.arguments(id, group, Phase::Create);
                    if let Some(material) = values.into_iter().find(|(name, _)| name == "material_type") {
                        self.command(group.command, &[(group.object.to_string(), self.name(id)), material]);
                    }
                } else {
                    self.set(id, group);
                }
            }
            self.line("! ****** Graphics for current part ******");
            self.line("!");
            let shapes = children.into_iter().filter(|c| {
                let class = self.database.object(*c).class;
                !class.is("frame") && !floating(class)
            });
            for child in self.in_order(shapes.collect()) {
                // Arrows of forces and what hangs between parts may name what comes later.
                if self.named_by(child).any(|o| !self.order.contains(&o)) {
                    self.later.push(child);
                } else {
                    self.object(child);
                }
            }
            for group in object.class.groups.iter().filter(|g| is_attributes(g.command)) {
                self.set(id, group);
            }
        }
    }

    /// No command makes the ground, so that another one says what is kept with it.
    fn ground_comments(&mut self, ground: ObjectId) {
        let class = self.database.object(ground).class;
        for group in class.groups.iter().filter(|g| g.fields.iter().any(|f| f.name == "comments")) {
            let mut values = self.arguments(ground, group, Phase::Create);
            values.retain(|(name, _)| name == "comments");
            if !values.is_empty() {
                values.insert(0, (group.object.to_string(), self.name(ground)));
                self.command("part modify rigid_body name_and_position", &values);
            }
        }
    }

    fn elements(&mut self, model: ObjectId) {
        type Belongs = fn(&Class) -> bool;
        let done = |c: &Class| c.is("body") || c.id == "material";
        let sections: &[(&str, Belongs)] = &[
            ("Contacts", |c| c.is("contact")),
            ("Equations", |c| c.is("equation")),
            ("Higher pair contacts", |c| c.is("higher_pair_contact")),
            ("Joints", |c| c.is("joint")),
            ("Joint Primitives", |c| c.is("primitive_joint")),
            ("Forces", |c| c.is("force") && c.id != "gravity"),
            ("Gears", |c| c.id == "gear"),
            ("Constraints", |c| c.is("constraint") && c.id != "coupler" && c.id != "motion"),
            ("Simulation Scripts", |c| c.id == "script"),
            ("Couplers", |c| c.id == "coupler"),
            ("Motions", |c| c.id == "motion"),
            ("Accgrav", |c| c.id == "gravity"),
            ("Analysis settings", |c| c.groups.first().is_some_and(|g| g.object.is_empty())),
            ("Other objects", |_| true),
        ];
        let mut rest = self.children(model, |c| !done(c));
        rest.retain(|id| !self.order.contains(id));
        for &(title, belongs) in sections {
            let (now, later): (Vec<_>, Vec<_>) =
                rest.into_iter().partition(|id| belongs(self.database.object(*id).class));
            rest = later;
            if now.is_empty() {
                continue;
            }
            self.banner(title);
            // Groups name what may come after them.
            let (groups, others): (Vec<_>, Vec<_>) =
                now.into_iter().partition(|id| self.database.object(*id).class.id == "group");
            for id in self.in_order(others).into_iter().chain(groups) {
                self.object(id);
                for child in self.database.object(id).children.clone() {
                    self.object(child);
                }
            }
        }
    }

    /// Shapes that name what is written behind the parts.
    fn dynamic_graphics(&mut self) {
        let shapes = std::mem::take(&mut self.later);
        if shapes.is_empty() {
            return;
        }
        self.banner("Dynamic Graphics");
        for id in self.in_order(shapes) {
            if let Some(parent) = self.database.object(id).parent {
                self.default_frame(parent);
            }
            self.object(id);
        }
    }

    /// Commands that were skipped: verbatim, with the units and the frame they were typed in.
    fn kept(&mut self, model: ObjectId, kept: &[&Kept]) {
        if kept.is_empty() {
            return;
        }
        self.banner("Commands that are kept but not executed");
        let ground = self.database.child(Some(model), "ground", "ground");
        let (own_frame, own_units) = (self.frame, self.database.settings().units);
        let mut units = own_units;
        for command in kept {
            let frame =
                command.frame.filter(|f| self.database.get(*f).is_some() && self.database.model_of(*f) == Some(model));
            let frame = frame.or(ground);
            if let Some(frame) = frame {
                self.default_frame(frame);
            }
            if command.units != units {
                units = command.units;
                self.units(units);
            }
            self.line(&command.text);
            self.line("!");
        }
        if units != own_units {
            self.units(own_units);
        }
        if let Some(frame) = own_frame {
            self.default_frame(frame);
        }
    }

    /// Functions and expressions, now that everything exists.
    fn late(&mut self, model: ObjectId) {
        let mut order = std::mem::take(&mut self.order);
        order.extend(self.database.subtree(model));
        for (title, phase) in
            [("Function definitions", Phase::Functions), ("Expression definitions", Phase::Expressions)]
        {
            let mut begun = false;
            for &id in &order {
                let object = self.database.object(id);
                for group in object.class.groups {
                    let late = self.arguments(id, group, phase);
                    if late.is_empty() {
                        continue;
                    }
                    if !begun {
                        begun = true;
                        self.banner(title);
                    }
                    let path = modify_path(group);
                    let mut arguments = Vec::new();
                    if !group.object.is_empty() {
                        arguments.push((group.object.to_string(), self.name(id)));
                    }
                    arguments.extend(late);
                    self.command(&path, &arguments);
                }
            }
        }
    }

    fn footer(&mut self, model: ObjectId) {
        for group in self.database.object(model).class.groups.iter().filter(|g| is_attributes(g.command)) {
            self.set(model, group);
        }
        let name = model::quoted(&self.database.object(model).name);
        self.command("model display", &[("model_name".into(), name)]);
        while self.out.ends_with("!\n") {
            self.out.truncate(self.out.len() - 2);
        }
    }

    // ---- objects ----

    fn children(&self, parent: ObjectId, wanted: impl Fn(&Class) -> bool) -> Vec<ObjectId> {
        let children = &self.database.object(parent).children;
        children.iter().copied().filter(|id| wanted(self.database.object(*id).class)).collect()
    }

    /// Objects in their own order, but each behind those of them that its command names.
    fn in_order(&self, ids: Vec<ObjectId>) -> Vec<ObjectId> {
        let all: std::collections::HashSet<ObjectId> = ids.iter().copied().collect();
        let mut ordered = indexmap::IndexSet::with_capacity(ids.len());
        let mut begun = std::collections::HashSet::with_capacity(ids.len());
        // Each object on the stack twice: first for what it names, then for itself.
        let mut stack: Vec<(ObjectId, bool)> = Vec::new();
        for id in ids {
            stack.push((id, false));
            while let Some((id, named)) = stack.pop() {
                if named {
                    ordered.insert(id);
                } else if begun.insert(id) {
                    stack.push((id, true));
                    let wanted: Vec<_> = self.named_by(id).filter(|o| all.contains(o) && !begun.contains(o)).collect();
                    stack.extend(wanted.into_iter().rev().map(|o| (o, false)));
                }
            }
        }
        ordered.into_iter().collect()
    }

    fn default_frame(&mut self, id: ObjectId) {
        if self.frame != Some(id) {
            self.frame = Some(id);
            let name = self.name(id);
            self.command("defaults coordinate_system", &[("default_coordinate_system".into(), name)]);
        }
    }

    /// The command that creates an object, and those that set what it has besides.
    fn object(&mut self, id: ObjectId) {
        self.order.insert(id);
        for group in self.database.object(id).class.groups {
            if group.creates {
                self.create(id, group);
            } else {
                self.set(id, group);
            }
        }
    }

    fn create(&mut self, id: ObjectId, group: &Group) {
        // Points are written in the frame they are stored in.
        let own = self.frame;
        if let Some(frame) = self.points_frame(id) {
            self.default_frame(frame);
        }
        let mut arguments = Vec::new();
        if !group.object.is_empty() {
            arguments.push((group.object.to_string(), self.name(id)));
        }
        arguments.extend(self.arguments(id, group, Phase::Create));
        self.command(group.command, &arguments);
        if let Some(own) = own {
            self.default_frame(own);
        }
    }

    /// The frame of the points of a shape that has any.
    fn points_frame(&self, id: ObjectId) -> Option<ObjectId> {
        let class = self.database.object(id).class;
        let given = |f: &Field| place::holds_points(f) && self.database.value(id, f.name).is_some();
        class.fields().any(given).then(|| place::frame_of_points(self.database, id)).flatten()
    }

    fn set(&mut self, id: ObjectId, group: &Group) {
        let values = self.arguments(id, group, Phase::Create);
        if !values.is_empty() {
            let mut arguments = vec![(group.object.to_string(), self.name(id))];
            arguments.extend(values);
            self.command(group.command, &arguments);
        }
    }
}

fn modify_path(group: &Group) -> String {
    if !group.creates && !group.command.contains(" create ") {
        return group.command.to_string();
    }
    group.command.split(' ').map(|w| if w == "create" { "modify" } else { w }).collect::<Vec<_>>().join(" ")
}
