//! What every class has in common: creating, modifying and renaming objects from their tables.

use model::{ObjectId, Value};
use schema::{Class, Default, Group, Kind};
use text::{Diagnostic, Span};

use crate::{
    Interpreter,
    call::Call,
    ends,
    lookup::{self, NewName},
    refusals,
    tree::{ClassGroup, Role},
};

type Outcome<T> = Result<T, Vec<Diagnostic>>;

impl Interpreter {
    /// Creates an object from a command.
    pub(crate) fn create_object(
        &mut self,
        class: &'static Class,
        group: &'static Group,
        call: &Call,
    ) -> Outcome<ObjectId> {
        let (place_of_new, typed, span) = self.name_for_new(class, call)?;
        // Which objects the command refers to is read first: it may not refer to what it makes.
        for field in group.fields {
            if field.required && call.argument(field.name).is_none() && field.default == Default::None {
                return Err(vec![call.missing(&[field.name])]);
            }
        }
        let id = self
            .database
            .create(class, place_of_new.parent, &place_of_new.name)
            .map_err(|t| vec![lookup::taken(&self.database, class, &typed, t.0, span)])?;
        self.names.created(&self.database, id);
        self.set_fields(id, call)?;
        self.set_defaults(id, class, group, call)?;
        self.set_formulas(id, group, call)?;
        ends::generate_markers(self, id, call)?;
        ends::generate_floating(self, id, call)?;
        refusals::joint_of_a_point_mass(&self.database, id, call.span)?;
        self.database.make_current(id);
        if class.id == "model" {
            self.model_created(id);
        }
        Ok(id)
    }

    /// A new model has its ground part, and becomes what names and locations refer to.
    fn model_created(&mut self, model: ObjectId) {
        let current_part: Vec<&'static str> = vec!["part", "body", "marker", "rigid_body"];
        self.database.change_settings(|s| {
            for name in current_part {
                s.current.shift_remove(name);
            }
            s.default_frame = None;
        });
        if let Some(class) = self.registry.class("ground")
            && let Ok(ground) = self.database.create(class, Some(model), "ground")
        {
            self.names.created(&self.database, ground);
            if class.cell_index("adams_id").is_some() {
                self.database.set_value(ground, "adams_id", Value::Integer(1));
            }
            self.database.make_current(ground);
        }
    }

    /// The name of the object a command creates: as given, or generated.
    fn name_for_new(&mut self, class: &'static Class, call: &Call) -> Outcome<(NewName, String, Span)> {
        let Some((_, argument)) = call.object_argument() else {
            let parent = lookup::default_parent(&self.database, class);
            if parent.is_none() && !class.parents.is_empty() {
                let parents = class.parents.join(" or ");
                return Err(vec![
                    Diagnostic::error(
                        "name/no-parent",
                        format!("a new {} needs a {parents} to belong to", class.word.to_lowercase()),
                    )
                    .at(call.keywords, "nothing it could go below")
                    .help(format!("create a {} first", class.parents[0]))
                    .adams("Invalid input. Enter '.' or an entity name."),
                ]);
            }
            let name = self.generate_name(class, parent);
            return Ok((NewName { parent, name: name.clone() }, name, call.keywords));
        };
        let typed = self.text_argument(call, argument)?;
        let span = argument.value_span;
        let name = lookup::new_name(&self.database, &self.registry, class, &typed, span).map_err(|e| vec![e])?;
        Ok((name, typed, span))
    }

    /// Sets cells of existing objects.
    pub(crate) fn modify_objects(&mut self, groups: &[ClassGroup], call: &Call) -> Outcome<()> {
        let (ids, object_name) = self.objects_to_modify(groups, call)?;
        for id in ids {
            let class = self.database.object(id).class;
            let Some((_, group)) =
                groups.iter().find(|(c, g)| *c == class && (object_name.is_empty() || g.object == object_name))
            else {
                return Err(vec![
                    Diagnostic::error(
                        "name/wrong-kind",
                        format!("`{}` does not apply to `{}`", call.path, self.database.full_name(id)),
                    )
                    .at(call.span, format!("`{}` is a {}", self.database.full_name(id), class.word))
                    .adams("Invalid input. Enter '.' or an entity name."),
                ]);
            };
            // The ground stays where it is whatever a command says.
            let extra = call.given.iter().find(|g| {
                let p = &call.parameters[g.parameter];
                p.role == Role::Field && !group.fields.iter().any(|f| f.name == &*p.name)
            });
            if let Some(extra) = extra {
                let name = &call.parameters[extra.parameter].name;
                return Err(vec![
                    Diagnostic::error(
                        "command/unknown-argument",
                        format!("`{name}` does not apply to `{}`", self.database.full_name(id)),
                    )
                    .at(extra.argument.name, format!("a {} has no such value", class.word.to_lowercase()))
                    .adams(format!("'{}' is not a valid parameter.", call.program.word(extra.argument.name))),
                ]);
            }
            self.set_fields(id, call)?;
            ends::generate_floating(self, id, call)?;
            refusals::joint_of_a_point_mass(&self.database, id, call.span)?;
            self.clear_by_no(id, call);
            if call.path.starts_with("part ") && class.id == "part" {
                self.warn_about_mass(id, call);
            }
            self.database.make_current(id);
            self.rename_from(id, call)?;
        }
        Ok(())
    }

    /// The objects a modify command is about, and the parameter that names them.
    fn objects_to_modify(&mut self, groups: &[ClassGroup], call: &Call) -> Outcome<(Vec<ObjectId>, String)> {
        if let Some((parameter, argument)) = call.object_argument() {
            let (field, name) = (parameter.field, parameter.name.to_string());
            let draft = self.read_value(call, &field, argument, None)?;
            return Ok((draft.value.objects(), name));
        }
        let first = call.parameters.iter().find(|p| p.role == Role::Object);
        let wanted = first.map_or("any", |p| match p.field.kind {
            Kind::Object(_, wanted) => wanted,
            _ => "any",
        });
        let current = self.database.current(wanted).filter(|id| {
            let class = self.database.object(*id).class;
            groups.iter().any(|(c, _)| *c == class)
        });
        match (current, first) {
            (Some(id), _) => Ok((vec![id], String::new())),
            (None, Some(p)) => Err(vec![call.missing(&[&*p.name])]),
            (None, None) => Ok((Vec::new(), String::new())),
        }
    }

    fn rename_from(&mut self, id: ObjectId, call: &Call) -> Outcome<()> {
        let Some((_, argument)) = call.with_role(Role::NewName) else { return Ok(()) };
        let typed = self.text_argument(call, argument)?;
        self.rename(id, &typed, argument.value_span)
    }

    /// Gives an object another name, bare or in full.
    pub(crate) fn rename(&mut self, id: ObjectId, typed: &str, span: Span) -> Outcome<()> {
        let object = self.database.object(id);
        let class = object.class;
        let parent = object.parent;
        let mut name = lookup::new_name(&self.database, &self.registry, class, typed, span).map_err(|e| vec![e])?;
        if !typed.starts_with('.') {
            name.parent = parent;
        }
        if let Some(p) = name.parent
            && self.database.subtree(id).contains(&p)
        {
            return Err(vec![
                Diagnostic::error("name/no-parent", format!("`{typed}` would be below itself"))
                    .at(span, "not possible")
                    .adams("Invalid input. Enter return or a parameter."),
            ]);
        }
        self.names.forget();
        self.database
            .rename(id, name.parent, &name.name)
            .map_err(|t| vec![lookup::taken(&self.database, class, typed, t.0, span)])
    }

    /// The one object of a settings class of a model.
    pub(crate) fn change_settings_object(&mut self, class: &'static Class, call: &Call) -> Outcome<()> {
        let model = match (call.argument("model_name"), call.field("model_name")) {
            (Some(argument), Some(field)) => {
                let field = *field;
                self.read_value(call, &field, argument, None)?.value.as_object()
            }
            _ => self.database.current("model"),
        };
        let Some(model) = model else { return Err(vec![call.missing(&["model_name"])]) };
        let id = match self.database.child(Some(model), class.id, class.id) {
            Some(id) => id,
            None => self
                .database
                .create(class, Some(model), class.id)
                .map_err(|t| vec![lookup::taken(&self.database, class, class.id, t.0, call.span)])?,
        };
        if class.cell_index("model_name").is_some() {
            self.database.set_value(id, "model_name", Value::Object(model));
        }
        self.set_fields(id, call)
    }
}
