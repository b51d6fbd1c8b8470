//! The values of a command in the cells of an object: given ones, defaults, places, formulas.

use model::{Cell, CellKey, ObjectId, Value};
use schema::{Class, Default, Field, Group, Kind, Use};
use syntax::command::ItemKind;
use text::{Diagnostic, Span};

use crate::{
    Interpreter,
    call::Call,
    ends, evaluation, place,
    tree::Role,
    values::{Draft, Reader},
};

type Outcome<T> = Result<T, Vec<Diagnostic>>;

impl Interpreter {
    /// Stores every given value in its cell and re-evaluates what depends on it.
    pub(crate) fn set_fields(&mut self, id: ObjectId, call: &Call) -> Outcome<()> {
        let class = self.database.object(id).class;
        let mut changed = Vec::new();
        self.place(id, call, &mut changed)?;
        let has_points = class.fields().any(place::holds_points);
        for (parameter, argument) in call.all() {
            if parameter.role != Role::Field || place::PLACING.contains(&parameter.field.name) && is_placed(class) {
                continue;
            }
            // Points come last: their frame may be among the other arguments.
            if place::holds_points(&parameter.field) || has_points && parameter.field.name == "relative_to" {
                continue;
            }
            let Some(cell) = class.cell_index(parameter.field.name) else { continue };
            let made = parameter.field.name == "j_marker_id" && class.cell_index("j_floating_marker_name").is_some();
            let end = parameter.field.usage == Use::Create && ends::is_end(parameter.field.name);
            if end || made || ends::is_body(parameter.field.name) {
                continue;
            }
            let field = *class.field(cell);
            let draft = self.read_value(call, &field, argument, Some(id))?;
            if field.name == "adams_id" {
                self.check_id(id, &draft.value, argument.value_span)?;
            }
            if field.default == Default::Current
                && let Some(object) = draft.value.as_object()
            {
                self.database.make_current(object);
            }
            let key = CellKey::new(id, cell);
            self.store(key, draft);
            changed.push(key);
        }
        if has_points {
            self.set_points(id, call, &mut changed)?;
        }
        self.recompute(&changed, call.span)
    }

    /// What reads the values of a command, for cells of `owner`.
    pub(crate) fn reader<'a>(&'a self, call: &Call<'a>, owner: Option<ObjectId>) -> Reader<'a> {
        Reader {
            database: &self.database,
            registry: &self.registry,
            sources: &self.sources,
            program: call.program,
            world: &self.world,
            owner,
            warnings: Vec::new(),
        }
    }

    /// Stores the points of a shape in the frame they belong to.
    fn set_points(&mut self, id: ObjectId, call: &Call, changed: &mut Vec<CellKey>) -> Outcome<()> {
        let class = self.database.object(id).class;
        for (parameter, argument) in call.all().filter(|(p, _)| place::holds_points(&p.field)) {
            let Some(cell) = class.cell_index(parameter.field.name) else { continue };
            let field = *class.field(cell);
            let mut reader = self.reader(call, Some(id));
            let draft = place::read_points(&mut reader, call, &field, argument, id)?;
            let warnings = std::mem::take(&mut reader.warnings);
            self.report.diagnostics.extend(warnings);
            let key = CellKey::new(id, cell);
            self.store(key, draft);
            changed.push(key);
        }
        Ok(())
    }

    /// Stores location and orientation in the frame of the parent.
    fn place(&mut self, id: ObjectId, call: &Call, changed: &mut Vec<CellKey>) -> Outcome<()> {
        let class = self.database.object(id).class;
        if !is_placed(class)
            || !call.given.iter().any(|g| place::PLACING.contains(&&*call.parameters[g.parameter].name))
        {
            return Ok(());
        }
        let parent = self.database.object(id).parent;
        let mut reader = self.reader(call, Some(id));
        let placement = place::read(&mut reader, call, Some(id), parent)?;
        let warnings = std::mem::take(&mut reader.warnings);
        self.report.diagnostics.extend(warnings);
        let kept = [&placement.location, &placement.orientation]
            .into_iter()
            .flatten()
            .any(|d| d.source != model::Source::Literal);
        for (name, draft) in [("location", placement.location), ("orientation", placement.orientation)] {
            if let (Some(draft), Some(cell)) = (draft, class.cell_index(name)) {
                let key = CellKey::new(id, cell);
                self.store(key, draft);
                changed.push(key);
            }
        }
        if kept && let Some(frame) = placement.relative_to {
            self.database.set_value(id, "relative_to", Value::Object(frame));
        }
        Ok(())
    }

    /// Fills cells that were not given and have a default.
    pub(crate) fn set_defaults(
        &mut self,
        id: ObjectId,
        class: &'static Class,
        group: &'static Group,
        call: &Call,
    ) -> Outcome<()> {
        for field in group.fields {
            if field.default == Default::None || field.usage == Use::Modify || call.argument(field.name).is_some() {
                continue;
            }
            let Some(cell) = class.cell_index(field.name) else { continue };
            let key = CellKey::new(id, cell);
            if self.database.object(id).cells.get(cell).is_some() {
                continue;
            }
            let value = match (field.default, field.kind) {
                (Default::Current, Kind::Object(_, wanted)) => match self.database.current(wanted) {
                    Some(current) => Value::Object(current),
                    None if field.required => return Err(vec![call.missing(&[field.name])]),
                    None => continue,
                },
                _ => match Value::of_default(field) {
                    Some(value) => value,
                    None => continue,
                },
            };
            self.store(key, Draft::literal(value));
        }
        if is_placed(class) {
            let frame = match (call.argument("relative_to"), call.field("relative_to").copied()) {
                (Some(argument), Some(field)) => self.read_value(call, &field, argument, None)?.value.as_object(),
                _ => self.database.settings().default_frame.filter(|f| self.database.get(*f).is_some()),
            };
            for name in ["location", "orientation"] {
                if let Some(cell) = class.cell_index(name)
                    && self.database.object(id).cells.get(cell).is_none()
                {
                    // Not given: at the frame values would have been read in.
                    self.place_at_frame(id, name, cell, frame);
                }
            }
        }
        Ok(())
    }

    /// Fills cells that follow from others of the object, where no value is given.
    pub(crate) fn set_formulas(&mut self, id: ObjectId, group: &'static Group, call: &Call) -> Outcome<()> {
        for field in group.fields {
            let (Default::Formula(formula), false) = (field.default, call.argument(field.name).is_some()) else {
                continue;
            };
            let text = formula.replace('@', &self.database.full_name(id));
            self.store_written(id, field.name, &text, call.span)?;
        }
        Ok(())
    }

    /// Stores an expression that Flexure itself has written.
    pub(crate) fn store_written(&mut self, id: ObjectId, cell: &str, text: &str, span: Span) -> Outcome<CellKey> {
        let number = self.database.object(id).class.cell_index(cell).unwrap_or_default();
        let outcome = evaluation::written(text, &self.database, &self.world, id).map_err(|errors| {
            errors.into_iter().map(|e| e.or_at(span, format!("gives no `{cell}`"))).collect::<Vec<_>>()
        })?;
        let source = outcome.kept.map_or(model::Source::Literal, |e| model::Source::Expression(Box::new(e)));
        let key = CellKey::new(id, number);
        self.store(key, Draft { value: outcome.value, source, reads: outcome.reads });
        Ok(key)
    }

    fn place_at_frame(&mut self, id: ObjectId, name: &str, cell: usize, frame: Option<ObjectId>) {
        let database = &self.database;
        let parent = database.object(id).parent;
        let pose = if frame == parent {
            model::Pose::GLOBAL
        } else {
            let parent_pose = parent.map_or(model::Pose::GLOBAL, |p| database.global_pose(p));
            parent_pose.inverse().then(&frame.map_or(model::Pose::GLOBAL, |f| database.global_pose(f)))
        };
        let numbers = if name == "location" {
            pose.origin.to_array()
        } else {
            let angle = database.units().angle.si;
            model::angles_of(&pose.rotation).map(|a| a / angle)
        };
        let value = Value::Array(model::Array::column(numbers.to_vec()));
        self.store(CellKey::new(id, cell), Draft::literal(value));
    }

    /// `no_vx = true` takes the value of `vx` away.
    pub(crate) fn clear_by_no(&mut self, id: ObjectId, call: &Call) {
        let class = self.database.object(id).class;
        for given in &call.given {
            let name = call.parameters[given.parameter].field.name;
            if let Some(other) = name.strip_prefix("no_")
                && let Some(cell) = class.cell_index(other)
                && self.database.flag(id, name) == Some(true)
            {
                let key = CellKey::new(id, cell);
                self.database.set_reads(key, Vec::new());
                self.database.set_cell(key, None);
                if let Some(flag) = class.cell_index(name) {
                    self.database.set_cell(CellKey::new(id, flag), None);
                }
            }
        }
    }

    pub(crate) fn warn_about_mass(&mut self, id: ObjectId, call: &Call) {
        if self.database.value(id, "mass").is_some() && self.database.reference(id, "center_of_mass_marker").is_none() {
            let name = self.database.full_name(id);
            self.report.diagnostics.push(
                Diagnostic::warning(
                    "part/no-center-of-mass",
                    format!("`{name}` has mass but no centre-of-mass marker"),
                )
                .at(call.span, "its centre of mass is taken at its origin")
                .adams(format!("Part {name} has mass but no center-of-mass marker is specified.")),
            );
        }
    }

    pub(crate) fn check_id(&mut self, id: ObjectId, value: &Value, span: Span) -> Outcome<()> {
        let Value::Integer(number) = *value else { return Ok(()) };
        if number < 0 {
            return Err(vec![
                Diagnostic::error("value/negative-id", "`adams_id` must not be negative")
                    .at(span, "0 asks for a number to be generated")
                    .adams("Invalid input. Enter a positive integer."),
            ]);
        }
        let Some(other) = self.names.holder_of_id(&self.database, id, number) else { return Ok(()) };
        let class = self.database.object(other).class;
        let (mine, theirs) = (self.database.full_name(id), self.database.full_name(other));
        Err(vec![
            Diagnostic::error("name/id-taken", format!("the id {number} belongs to `{theirs}` already"))
                .at(span, "id in use")
                .help("give another number, or 0 to have one generated")
                .adams(format!(
                    "The ADAMS ID {number} of {mine} conflicts with the ADAMS ID of {} entity {theirs}.",
                    class.word
                )),
        ])
    }

    // ---- helpers ----

    /// Reads the value of an argument.
    pub(crate) fn read_value(
        &mut self,
        call: &Call,
        field: &Field,
        argument: &syntax::command::Argument,
        owner: Option<ObjectId>,
    ) -> Outcome<Draft> {
        let mut reader = self.reader(call, owner);
        let outcome = reader.read(field, argument);
        let warnings = std::mem::take(&mut reader.warnings);
        self.report.diagnostics.extend(warnings);
        if let (schema::Kind::Function, Some(owner)) = (field.kind, owner)
            && let Some(cell) = self.database.object(owner).class.cell_index(field.name)
        {
            self.function_places.insert(CellKey::new(owner, cell), argument.value_span);
        }
        outcome
    }

    /// The text of a one-word argument; an expression is evaluated.
    pub(crate) fn text_argument(&mut self, call: &Call, argument: &syntax::command::Argument) -> Outcome<String> {
        if let [item] = argument.values.as_slice() {
            match &item.kind {
                ItemKind::Expression(e) => {
                    let value = evaluation::evaluate(e, &self.database, &self.sources, &self.world, None)?.value;
                    return Ok(match &value {
                        Value::Text(text) => quoted_steps(text),
                        other => crate::values::text_of(other, &self.database),
                    });
                }
                // A quoted name that is not plain keeps its quotes, so that dots in it are no path.
                ItemKind::Text(text) => return Ok(quoted_steps(text)),
                _ => return Ok(call.program.word(item.span).to_string()),
            }
        }
        Err(vec![
            Diagnostic::error("command/wrong-count", "one name is wanted")
                .at(argument.value_span, format!("{} values", argument.values.len()))
                .adams("Invalid input. Enter return or a parameter."),
        ])
    }

    pub(crate) fn store(&mut self, key: CellKey, draft: Draft) {
        let units = self.database.settings().units;
        self.database.set_reads(key, draft.reads);
        self.database.set_cell(key, Some(Cell { value: draft.value, units, source: draft.source }));
    }

    pub(crate) fn recompute(&mut self, changed: &[CellKey], span: Span) -> Outcome<()> {
        evaluation::recompute(&mut self.database, changed).map_err(|e| vec![e.or_at(span, "needed by this change")])
    }
}

/// A full name, or a bare one, that was given as a text: steps that are not plain words are put in quotes.
fn quoted_steps(text: &str) -> String {
    if text.contains('"') || text.contains('.') && !text.starts_with('.') {
        return text.to_string();
    }
    let quoted = |step: &str| if step.is_empty() { String::new() } else { model::quoted(step) };
    text.split('.').map(quoted).collect::<Vec<_>>().join(".")
}

/// Whether objects of a class have a place of their own (and are not merely created at one).
fn is_placed(class: &Class) -> bool {
    let place = |f: &Field| f.name == "location" && f.usage != Use::Create && f.kind == Kind::Location;
    class.fields().any(|f| place(f) && !place::holds_points(f))
}
