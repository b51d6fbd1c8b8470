//! Setting attributes: values that doors give become the arguments of the commands that modify an
//! object. A text is a value, never a piece of a command: what would be read as anything else is
//! quoted, and what no command can hold is refused.

use model::{Database, Object, ObjectId};
use schema::{Count, Field, Group, Kind, Use};
use syntax::command::{ItemKind, Statement, StatementKind, parse, quote};
use text::{Diagnostic, FileId};

use crate::attributes::AttributeValue;
use crate::coordinates;

/// A value as doors give it.
#[derive(Clone, Debug, PartialEq)]
pub enum AttributeInput {
    /// No object.
    None,
    Number(f64),
    Integer(i64),
    Flag(bool),
    /// A text, a word or an object's name, by what the attribute takes. Where it takes numbers, a number with
    /// a unit or an expression: `3.5`, `7.1e10(newton/meter**2)`, `(.m.length / 2)`; in parentheses an
    /// expression also where it takes objects or words.
    Text(String),
    List(Vec<AttributeInput>),
}

impl From<AttributeValue> for AttributeInput {
    fn from(value: AttributeValue) -> Self {
        let texts = |texts: Vec<String>| texts.into_iter().map(AttributeInput::Text).collect();
        match value {
            AttributeValue::None => AttributeInput::None,
            AttributeValue::Number(x) => AttributeInput::Number(x),
            AttributeValue::Integer(i) => AttributeInput::Integer(i),
            AttributeValue::Flag(flag) => AttributeInput::Flag(flag),
            AttributeValue::Text(text) => AttributeInput::Text(text),
            AttributeValue::Numbers(xs) => AttributeInput::List(xs.into_iter().map(AttributeInput::Number).collect()),
            AttributeValue::Texts(all) => AttributeInput::List(texts(all)),
        }
    }
}

impl AttributeInput {
    /// Whether these are coordinates one by one, and not an expression that yields them all.
    fn is_coordinates(&self) -> bool {
        matches!(self, AttributeInput::List(items) if items.len() > 1)
    }
}

/// One modify command in the making.
struct Modify {
    group: &'static Group,
    /// The frame its coordinates are in, if it is not left to the defaults.
    frame: Option<ObjectId>,
    arguments: Vec<String>,
}

/// The commands that set attributes: one for each group of the class that is concerned. Coordinates are in
/// the frame in which they are read; what one expression yields is in the one that commands take.
pub(crate) fn modify_commands(
    database: &Database,
    object: &str,
    values: &[(String, AttributeInput)],
) -> Result<Vec<String>, Diagnostic> {
    let unknown = |what: String| Diagnostic::error("attribute/unknown", what);
    let id = database.find(object, "any").ok_or_else(|| unknown(format!("there is no object `{object}`")))?;
    let named = values.iter().any(|(name, _)| name.eq_ignore_ascii_case("relative_to"));
    let mut commands: Vec<Modify> = Vec::new();
    for (name, value) in values {
        let (group, field) = group_of(database.object(id), name)
            .ok_or_else(|| unknown(format!("`{object}` has no attribute `{name}`")))?;
        let framed = !named && value.is_coordinates() && group.fields.iter().any(|f| f.name == "relative_to");
        let frame = if framed { frame_of(database, id, field) } else { None };
        let typed = frame.and_then(|_| coordinates::typed(database, field, value));
        let argument = format!("{} = {}", field.name, written(field, typed.as_ref().unwrap_or(value))?);
        match commands.iter_mut().find(|c| std::ptr::eq(c.group, group) && c.frame == frame) {
            Some(command) => command.arguments.push(argument),
            None => commands.push(Modify { group, frame, arguments: vec![argument] }),
        }
    }
    // What is aimed from a place comes behind it.
    commands.sort_by_key(|command| command.frame.is_none());
    Ok(commands.into_iter().map(|command| command.text(database, id)).collect())
}

/// The command that gives an object another name, bare and without quotes.
pub(crate) fn rename_command(database: &Database, object: &str, name: &str) -> Result<String, Diagnostic> {
    let id = database
        .find(object, "any")
        .ok_or_else(|| Diagnostic::error("attribute/unknown", format!("there is no object `{object}`")))?;
    let parent = database.object(id).parent.map_or_else(String::new, |parent| database.full_name(parent));
    let full = format!("{parent}.{}", model::quoted(name));
    if name.trim().is_empty() || name.contains('"') || items(&full).as_deref() != Some(&[ItemKind::Word]) {
        return Err(Diagnostic::error("attribute/not-writable", format!("{name:?} is no name of an object")));
    }
    Ok(format!("entity modify entity_name = {} new_entity_name = {full}", database.full_name(id)))
}

impl Modify {
    fn text(mut self, database: &Database, id: ObjectId) -> String {
        let words = self.group.command.split(' ').map(|word| if word == "create" { "modify" } else { word });
        let mut text = words.collect::<Vec<_>>().join(" ");
        let object = match self.group.object {
            // Settings, of which each model has one set.
            "" if self.arguments.iter().any(|a| a.starts_with("model_name ")) => None,
            "" => database.model_of(id).map(|model| ("model_name", model)),
            name => Some((name, id)),
        };
        if let Some(frame) = self.frame {
            self.arguments.push(format!("relative_to = {}", database.full_name(frame)));
        }
        let object = object.map(|(name, id)| format!("{name} = {}", database.full_name(id)));
        for argument in object.into_iter().chain(self.arguments) {
            text.extend([SEPARATOR, &argument]);
        }
        text
    }
}

/// A line for each argument: a text with line breaks ends only before one.
const SEPARATOR: &str = " &\n   ";

/// The group whose modify command sets an attribute, and its field.
fn group_of(object: &Object, name: &str) -> Option<(&'static Group, &'static Field)> {
    let fields = || {
        let all = object.class.groups.iter().flat_map(|g| g.fields.iter().map(move |f| (g, f)));
        all.filter(|(_, f)| f.name.eq_ignore_ascii_case(name))
    };
    fields().find(|(_, f)| f.usage != Use::Create).or_else(|| fields().next())
}

/// The frame in which the coordinates of an attribute are kept.
fn frame_of(database: &Database, id: ObjectId, field: &Field) -> Option<ObjectId> {
    let parent = database.object(id).parent;
    match field.kind {
        Kind::Location if field.count == Count::MANY => database.reference(id, "reference_marker").or(parent),
        Kind::Location if field.name == "location" => parent,
        Kind::Orientation if field.name == "orientation" => parent,
        _ => None,
    }
}

/// A value as the text of an argument.
fn written(field: &Field, value: &AttributeInput) -> Result<String, Diagnostic> {
    let refused = |what: &str| Diagnostic::error("attribute/not-writable", format!("`{}` {what}", field.name));
    let is_text = matches!(field.kind, Kind::Text | Kind::File | Kind::Function | Kind::Any);
    Ok(match value {
        AttributeInput::None if matches!(field.kind, Kind::Object(..)) => "none".into(),
        AttributeInput::None => return Err(refused("cannot be taken away; give it a value")),
        AttributeInput::List(items) if items.is_empty() => return Err(refused("wants a value, not an empty list")),
        AttributeInput::List(items) => {
            items.iter().map(|item| written(field, item)).collect::<Result<Vec<_>, _>>()?.join(", ")
        }
        AttributeInput::Number(x) if !x.is_finite() => return Err(refused(&format!("cannot be {x}"))),
        AttributeInput::Number(x) => format!("{x:?}"),
        AttributeInput::Integer(i) => i.to_string(),
        AttributeInput::Flag(flag) => word_of(field, *flag).into(),
        AttributeInput::Text(text) if is_text => {
            let quoted = quote(text);
            let read = items(&quoted).filter(|items| *items == [ItemKind::Text(text.clone())]);
            read.map(|_| quoted).ok_or_else(|| {
                refused(&format!("cannot hold {text:?}")).note("no command could hold a text with such line breaks")
            })?
        }
        AttributeInput::Text(text) if matches!(field.kind, Kind::Object(..) | Kind::Choice(_) | Kind::Boolean(..)) => {
            let sole = matches!(items(text).as_deref(), Some([ItemKind::Word | ItemKind::Expression(_)]));
            let quoted = quote(text);
            match items(&quoted).as_deref() {
                _ if sole => text.clone(),
                Some([ItemKind::Text(_)]) => quoted,
                _ => return Err(refused(&format!("cannot be {text:?}"))),
            }
        }
        AttributeInput::Text(text) => numeric(text).ok_or_else(|| {
            refused(&format!("cannot be {text:?}")).help("give a number, or an expression as `(...)`")
        })?,
    })
}

/// Numbers and expressions as they are typed; in parentheses what is an expression only then.
fn numeric(text: &str) -> Option<String> {
    let text = text.trim();
    let is_number = |item: &ItemKind| matches!(item, ItemKind::Number { .. } | ItemKind::Expression(_));
    if text.contains(['\n', '\r']) {
        return None;
    }
    if items(text).is_some_and(|items| items.iter().all(is_number)) {
        return Some(text.to_string());
    }
    let enclosed = format!("({text})");
    matches!(items(&enclosed).as_deref(), Some([ItemKind::Expression(_)])).then_some(enclosed)
}

/// The word that stands for yes or no.
fn word_of(field: &Field, flag: bool) -> &'static str {
    let known = if flag { ["yes", "on", "true"] } else { ["no", "off", "false"] };
    match field.kind {
        Kind::Boolean(yes, _) if flag => yes,
        Kind::Boolean(_, no) => no,
        Kind::Choice(words) => known.into_iter().find(|word| words.contains(word)).unwrap_or(known[0]),
        _ => known[0],
    }
}

/// The values that a text is read as behind a `=`, with further arguments behind it; none if it is read
/// as anything else.
fn items(text: &str) -> Option<Vec<ItemKind>> {
    let before = "attribute = ";
    let command = format!("set {before}{text}{SEPARATOR}further = 1\n");
    let (mut statements, troubles) = parse(FileId(0), &command);
    let (Some(Statement { kind: StatementKind::Command { arguments, .. }, .. }), true, false) =
        (statements.pop(), statements.is_empty(), troubles.iter().any(Diagnostic::is_error))
    else {
        return None;
    };
    let [argument, _] = <[_; 2]>::try_from(arguments).ok()?;
    let start = "set ".len() + before.len();
    // Nothing of it may be a comment.
    let whole = argument.value_span.range() == (start..start + text.len());
    whole.then(|| argument.values.into_iter().map(|item| item.kind).collect())
}
