//! Macros: commands of the user's own, made of text with `$parameters`.

use std::collections::HashMap;

use model::{ObjectId, Value};
use schema::{Class, Count, Field, Group, Kind};
use syntax::command::quote;
use text::{Diagnostic, Span};

use crate::{
    Interpreter,
    call::Call,
    interpreter::{Flow, cannot_read},
    lookup,
    macro_text::{Doubt, Formal, KEYS, What, declarations, find_formals, substitute},
    macro_values::{PLAIN_TYPES, Wanted},
    tree::{Parameter, Role},
    words::did_you_mean,
};

/// What is kept of a macro.
pub const CLASS: Class = Class {
    id: "macro",
    word: "Macro",
    families: &[],
    parents: &["library", "model", "macro"],
    prefix: "MACRO_",
    statement: None,
    groups: &[Group {
        command: "macro create",
        creates: true,
        object: "macro_name",
        fields: &[
            Field::text("user_entered_command").doc("words that call the macro"),
            Field::texts("commands_to_be_executed").required().doc("lines of the macro"),
            Field::yes_no("wrap_in_undo").default_word("yes").doc("a call is one step of undo"),
            Field::text("help_file").doc("file with help on the macro"),
            Field::text("help_string").doc("text of help on the macro"),
            Field::yes_no("create_panel").default_word("no").doc("make a dialog box"),
        ],
        rules: &[],
        doc: "a command made of other commands",
    }],
};

/// A library only owns other objects.
pub const LIBRARY: Class = Class {
    id: "library",
    word: "Library",
    families: &[],
    parents: &["library", "model"],
    prefix: "LIBRARY_",
    statement: None,
    groups: &[Group {
        command: "library create",
        creates: true,
        object: "library_name",
        fields: &[],
        rules: &[],
        doc: "a place for variables and macros",
    }],
};

#[derive(Clone, Debug, Default)]
struct Macro {
    formals: Vec<Formal>,
    body: String,
    path: String,
}

/// Macros by object.
#[derive(Debug, Default)]
pub struct Macros {
    known: HashMap<ObjectId, Macro>,
}

impl Interpreter {
    /// Makes the command of a macro known; called after it was created, modified or read.
    pub(crate) fn register_macro(&mut self, id: ObjectId) {
        let (path, text) = self.macro_as_stored(id);
        if let Some(old) = self.macros.known.get(&id)
            && old.path != path
            && !old.path.is_empty()
        {
            let old_path = old.path.clone();
            self.tree.remove_macro(&old_path, id);
        }
        let formals = find_formals(&text);
        if !path.is_empty() {
            let parameters = formals
                .iter()
                .map(|f| Parameter {
                    name: f.name.as_str().into(),
                    role: Role::Field,
                    field: Field::new("value", Kind::Any).count(Count::between(1, usize::MAX)),
                })
                .collect();
            self.tree.add_macro(&path, id, parameters);
        }
        self.macros.known.insert(id, Macro { formals, body: text, path });
    }

    /// The words that call a macro and its lines, as the database has them.
    fn macro_as_stored(&self, id: ObjectId) -> (String, String) {
        let text = match self.database.value(id, "commands_to_be_executed") {
            Some(Value::Texts(lines)) => lines.join("\n"),
            Some(Value::Text(line)) => line.clone(),
            _ => String::new(),
        };
        // Without words of its own a macro is called by its full name, which is no keyword path.
        let words = self.database.text(id, "user_entered_command").unwrap_or_default();
        (words.split_whitespace().collect::<Vec<_>>().join(" ").to_ascii_lowercase(), text)
    }

    /// Puts right what is remembered of macros whose words or lines were taken back. Others keep the
    /// defaults that calls gave their parameters.
    pub(crate) fn refresh_macros(&mut self) {
        let known = self.macros.known.iter().filter(|(id, _)| self.database.get(**id).is_some());
        let changed =
            known.filter(|(id, known)| self.macro_as_stored(**id) != (known.path.clone(), known.body.clone()));
        let mut changed: Vec<ObjectId> = changed.map(|(id, _)| *id).collect();
        changed.sort_unstable();
        changed.into_iter().for_each(|id| self.register_macro(id));
    }

    /// Runs a macro: its text with the parameters put in, line by line.
    pub(crate) fn call_macro(&mut self, id: ObjectId, call: &Call) -> Result<Flow, Vec<Diagnostic>> {
        let Some(known) = self.macros.known.get(&id).cloned() else { return Ok(Flow::Next) };
        let mut values: Vec<(String, String)> = Vec::new();
        let mut updated = Vec::new();
        for (index, formal) in known.formals.iter().enumerate() {
            let given = call.given.iter().find(|g| g.parameter == index).map(|g| g.argument);
            let text = match (given, &formal.default) {
                (Some(argument), _) => {
                    let text = self.actual(formal, call, argument)?;
                    if formal.updated {
                        updated.push((index, text.clone()));
                    }
                    text
                }
                (None, Some(default)) => default.clone(),
                (None, None) if formal.least == 0 => String::new(),
                (None, None) => return Err(vec![call.missing(&[&formal.name])]),
            };
            values.push((formal.name.clone(), text));
        }
        values.push(("_self".into(), self.database.full_name(id)));
        if let Some(stored) = self.macros.known.get_mut(&id) {
            for (index, text) in updated {
                stored.formals[index].default = Some(text);
            }
        }
        let text = substitute(&known.body, &values);
        let file = self.sources.add(format!("macro {}", self.database.full_name(id)), text);
        let wrap = self.database.flag(id, "wrap_in_undo") != Some(false);
        self.trace.push(call.span);
        self.undo_blocks += usize::from(wrap);
        let flow = self.run_source(file);
        self.undo_blocks -= usize::from(wrap);
        self.trace.pop();
        Ok(flow)
    }

    /// Says what is not understood in the parameters of a macro that was just made. `place` finds an
    /// offset and a length of its text.
    pub(crate) fn doubt_parameters(&mut self, id: ObjectId, place: &dyn Fn(&str, usize, usize) -> Span) {
        let (_, text) = self.macro_as_stored(id);
        let mut said = Vec::new();
        for Doubt { at, length, parameter, what } in declarations(&text).1 {
            let written = &text[at..at + length];
            let span = place(&text, at, length);
            let warning = |code, message: String| Diagnostic::warning(code, message);
            said.push(match what {
                What::Type => {
                    let kind = written.to_ascii_lowercase();
                    if !matches!(Wanted::of(&kind, &self.registry), Wanted::Unknown) {
                        continue;
                    }
                    let message = format!("`{written}` is no type that Flexure knows");
                    let warning = warning("macro/unknown-type", message)
                        .at(span, format!("values of `{parameter}` are not checked"));
                    let classes = self.registry.classes.iter().map(|c| c.id);
                    let guess =
                        did_you_mean(warning, PLAIN_TYPES.into_iter().chain(classes), &kind, span, |w| w.into());
                    guess.unwrap_or_else(|w| w)
                }
                What::UnknownQualifier => {
                    let message = format!("`{written}` is no qualifier of a parameter");
                    let warning =
                        warning("macro/unknown-qualifier", message).at(span, format!("`{parameter}` goes without it"));
                    did_you_mean(warning, KEYS, written, span, |w| w.into())
                        .unwrap_or_else(|w| w.note(format!("the qualifiers are {}", KEYS.join(", "))))
                }
                What::Value => {
                    let message = format!("`{written}` is not understood in the declaration of `{parameter}`");
                    warning("macro/bad-qualifier", message)
                        .at(span, "taken as not given")
                        .help("counts are whole numbers (`c=2`, `c=1,3`, `c=0`), bounds are numbers (`gt=0`)")
                }
                What::Unquoted(value) => {
                    warning("macro/unquoted-default", format!("the default of `{parameter}` has blanks but no quotes"))
                        .at(span, "all of this is taken")
                        .fix("put it in quotes", span, quote(&value))
                }
            });
        }
        self.complain(said);
    }

    /// `macro read`: makes or replaces a macro from a file.
    pub(crate) fn read_macro(&mut self, call: &Call) -> Result<Flow, Vec<Diagnostic>> {
        let (Some(name), Some(file)) = (call.argument("macro_name"), call.argument("file_name")) else {
            return Err(vec![call.missing(&[if call.argument("macro_name").is_none() {
                "macro_name"
            } else {
                "file_name"
            }])]);
        };
        let file_name = self.text_argument_plain(call, file)?;
        let path = self.host.resolve(&file_name);
        let text = std::fs::read(&path).map_err(|e| {
            let mut error = cannot_read(&path, &e).at(file.value_span, "this file");
            error.adams_text = vec![format!("Unable to open file named '{file_name}'.")];
            vec![error]
        })?;
        let source = self.sources.add_bytes(path.display().to_string(), text);
        let text = self.sources.text(source).to_string();
        let typed = self.text_argument(call, name)?;
        let id = if let Some(id) = lookup::search_one(&self.database, &typed, "macro") {
            id
        } else {
            let place = lookup::new_name(&self.database, &self.registry, &CLASS, &typed, name.value_span)
                .or_else(|e| {
                    if typed.contains('.') { Err(e) } else { Ok(lookup::NewName { parent: None, name: typed.clone() }) }
                })
                .map_err(|e| vec![e])?;
            self.database
                .create(&CLASS, place.parent, &place.name)
                .map_err(|t| vec![lookup::taken(&self.database, &CLASS, &typed, t.0, name.value_span)])?
        };
        for line in text.lines() {
            let Some(header) = line.trim().strip_prefix('!') else { continue };
            let (key, value) = header.trim().split_once(char::is_whitespace).unwrap_or((header.trim(), ""));
            match key.to_ascii_uppercase().as_str() {
                "USER_ENTERED_COMMAND" => {
                    self.database.set_value(id, "user_entered_command", Value::Text(value.trim().into()));
                }
                "WRAP_IN_UNDO" => {
                    self.database.set_value(id, "wrap_in_undo", Value::Flag(value.trim().eq_ignore_ascii_case("yes")));
                }
                "HELP_STRING" => self.database.set_value(id, "help_string", Value::Text(value.trim().into())),
                "END_OF_PARAMETERS" => break,
                _ => {}
            }
        }
        if let Some(argument) = call.argument("user_entered_command") {
            let words = self.text_argument_plain(call, argument)?;
            self.database.set_value(id, "user_entered_command", Value::Text(words));
        }
        let lines = text.lines().map(str::to_string).collect();
        self.database.set_value(id, "commands_to_be_executed", Value::Texts(lines));
        self.register_macro(id);
        let starts: Vec<usize> = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        self.doubt_parameters(id, &|stored, at, length| {
            // Ends of lines may be longer in the file.
            let line = stored[..at].matches('\n').count();
            let column = at - stored[..at].rfind('\n').map_or(0, |n| n + 1);
            let start = starts.get(line).copied().unwrap_or(0) + column;
            Span::new(source, start, start + length)
        });
        Ok(Flow::Next)
    }
}

/// What is known of a parameter of a macro, for help.
pub(crate) struct ParameterOfMacro<'a> {
    pub kind: &'a str,
    pub default: Option<&'a str>,
    pub required: bool,
}

impl Macros {
    pub(crate) fn parameter(&self, id: ObjectId, name: &str) -> Option<ParameterOfMacro<'_>> {
        let formal = self.known.get(&id)?.formals.iter().find(|f| f.name.eq_ignore_ascii_case(name))?;
        let kind = if formal.kind.is_empty() { "any value" } else { &formal.kind };
        let default = formal.default.as_deref();
        Some(ParameterOfMacro { kind, default, required: default.is_none() && formal.least > 0 })
    }

    /// Defaults that calls have changed (`ud`), by macro and parameter.
    pub(crate) fn updated_defaults(&self) -> Vec<(ObjectId, Vec<(&str, &str)>)> {
        let mut found: Vec<_> = Vec::new();
        for (id, known) in &self.known {
            let changing = known.formals.iter().filter(|f| f.updated);
            let defaults: Vec<_> = changing.filter_map(|f| Some((f.name.as_str(), f.default.as_deref()?))).collect();
            if !defaults.is_empty() {
                found.push((*id, defaults));
            }
        }
        found.sort_unstable_by_key(|(id, _)| *id);
        found
    }

    /// Puts a changed default back.
    pub(crate) fn update_default(&mut self, id: ObjectId, parameter: &str, value: &str) {
        let formals = self.known.get_mut(&id).map(|m| m.formals.as_mut_slice()).unwrap_or_default();
        for formal in formals.iter_mut().filter(|f| f.updated && f.name == parameter) {
            formal.default = Some(value.to_string());
        }
    }
}
