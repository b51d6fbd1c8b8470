//! Names typed in commands: which object is meant, and where a new one goes.

use expressions::glob;
use model::{Database, ObjectId, name_steps, quoted, split_name};
use schema::{Class, Registry};
use smallvec::{SmallVec, smallvec};
use text::{Diagnostic, Severity, Span};

use crate::{
    journal::PATTERN,
    words::{did_you_mean, is_pattern, nearest},
};

/// A place for a new object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewName {
    pub parent: Option<ObjectId>,
    pub name: String,
}

/// The word Adams uses for what a parameter asks for.
pub fn word_of(registry: &Registry, wanted: &str) -> String {
    if let Some(class) = registry.class(wanted) {
        return class.word.to_string();
    }
    if wanted == "any" {
        return "Object".into();
    }
    let mut chars = wanted.chars();
    match chars.next() {
        Some(first) => first.to_uppercase().chain(chars).collect(),
        None => String::new(),
    }
}

/// Finds the existing object a name means.
pub fn find(
    database: &Database,
    registry: &Registry,
    name: &str,
    wanted: &str,
    span: Span,
) -> Result<ObjectId, Diagnostic> {
    let found = search(database, name, wanted);
    match found.as_slice() {
        [one] => Ok(*one),
        [] => Err(not_found(database, registry, name, wanted, span)),
        many => {
            let names: Vec<String> = many.iter().take(8).map(|id| database.full_name(*id)).collect();
            Err(Diagnostic::error("name/ambiguous", format!("`{name}` may mean {}", names.join(", ")))
                .at(span, "more than one object has this name")
                .help(format!("write the full name, for example `{}`", names[0])))
        }
    }
}

/// Finds an object without complaining: one candidate or none.
pub fn search_one(database: &Database, name: &str, wanted: &str) -> Option<ObjectId> {
    match search(database, name, wanted).as_slice() {
        [one] => Some(*one),
        _ => None,
    }
}

fn search(database: &Database, name: &str, wanted: &str) -> SmallVec<[ObjectId; 1]> {
    search_for(database, name, &|class| class.is(wanted))
}

/// Every object of a class that fits which a name may mean.
pub fn search_for(database: &Database, name: &str, fits: &dyn Fn(&Class) -> bool) -> SmallVec<[ObjectId; 1]> {
    if let Some(rest) = name.strip_prefix('.') {
        return database.descend_to(None, &name_steps(rest), fits).into_iter().collect();
    }
    let steps = name_steps(name);
    if steps.iter().any(|s| s.is_empty()) {
        return SmallVec::new();
    }
    let model = database.current("model");
    // The current part, then the model itself, then anything below it, then other top-level objects.
    let near = [database.current("part"), database.current("body"), model];
    for parent in near.into_iter().flatten() {
        if let Some(id) = database.descend_to(Some(parent), &steps, fits) {
            return smallvec![id];
        }
    }
    if let Some(id) = database.descend_to(None, &steps, fits) {
        return smallvec![id];
    }
    let Some(model) = model else { return SmallVec::new() };
    let mut found = SmallVec::new();
    for (_, id) in database.holders_of_name(model, &steps[0]) {
        if let Some(child) = database.descend_to(Some(id), &steps, fits)
            && !found.contains(&child)
        {
            found.push(child);
        }
    }
    found
}

/// Every object that a name or a pattern means, in order of creation.
pub fn find_all(
    database: &Database,
    registry: &Registry,
    name: &str,
    wanted: &str,
    span: Span,
) -> Result<Vec<ObjectId>, Diagnostic> {
    if !is_pattern(name) {
        return find(database, registry, name, wanted, span).map(|id| vec![id]);
    }
    let found = meant_by(database, name, wanted);
    if found.is_empty() {
        let word = word_of(registry, wanted);
        return Err(Diagnostic::error("name/not-found", format!("no {} matches `{name}`", word.to_lowercase()))
            .at(span, "matches nothing")
            .adams(format!("No {word} entities matching \"{name}\" were found.")));
    }
    Ok(found)
}

/// Which objects a pattern means.
pub fn several(database: &Database, registry: &Registry, name: &str, wanted: &str, found: &[ObjectId]) -> Diagnostic {
    let word = word_of(registry, wanted);
    let pattern = name.rsplit('.').next().unwrap_or(name);
    let names: Vec<String> = found.iter().map(|id| database.full_name(*id)).collect();
    let message = format!("`{name}` means {} objects", found.len());
    let mut note = Diagnostic::new(Severity::Note, PATTERN, message);
    note.adams_text = wrapped(&format!("Found {} {word} entities matching \"{pattern}\": ", found.len()), &names);
    note.notes.push(names.join(", "));
    note
}

/// A list of names behind a text, broken behind a comma where a line gets longer than Adams lets it.
pub fn wrapped(text: &str, names: &[String]) -> Vec<String> {
    /// A first line of 90 characters with one name, and no room for a second of 33, were seen.
    const WIDEST: usize = 100;
    let mut lines = vec![text.to_string()];
    for (i, name) in names.iter().enumerate() {
        let last = i + 1 == names.len();
        let piece = if last { name.clone() } else { format!("{name}, ") };
        match lines.last_mut() {
            Some(line) if i == 0 || line.len() + piece.len() <= WIDEST => line.push_str(&piece),
            _ => lines.push(piece),
        }
    }
    lines
}

/// Objects of a class or family that a pattern means, in order of creation.
fn meant_by(database: &Database, name: &str, wanted: &str) -> Vec<ObjectId> {
    let fitting = |mut found: Vec<ObjectId>| {
        found.retain(|id| database.object(*id).class.is(wanted));
        found
    };
    let from_root = name.strip_prefix('.');
    if from_root.is_some_and(|rest| rest.chars().all(|c| c == '*')) {
        return fitting(database.ids().collect());
    }
    let steps = split_name(from_root.unwrap_or(name));
    let Some((first, rest)) = steps.split_first() else { return Vec::new() };
    let meant = |place: &[ObjectId]| fitting(follow(database, matching(database, place, first), rest));
    if from_root.is_some() {
        return meant(database.roots());
    }
    // As a partial name is searched: in the current part, in the model, from the top, and then
    // anywhere below the model. A pattern that stands alone means what is anywhere below the model
    // first: the model itself only where nothing else is meant.
    let model = database.current("model");
    let below = || model.map(|m| database.subtree(m).split_off(1)).unwrap_or_default();
    let children = |name: &str| database.current(name).map(|id| database.object(id).children.clone());
    let near = ["part", "body", "model"].into_iter().filter(|_| !rest.is_empty()).filter_map(children);
    let top = || database.roots().to_vec();
    let mut places: Vec<Vec<ObjectId>> = near.collect();
    places.extend(if rest.is_empty() { [below(), top()] } else { [top(), below()] });
    places.iter().map(|place| meant(place)).find(|found| !found.is_empty()).unwrap_or_default()
}

/// Follows patterns down from objects; each is found once, in order of creation.
fn follow(database: &Database, from: Vec<ObjectId>, steps: &[String]) -> Vec<ObjectId> {
    let mut level = from;
    for step in steps {
        level = level.iter().flat_map(|id| matching(database, &database.object(*id).children, step)).collect();
    }
    level.sort_unstable();
    level.dedup();
    level
}

fn matching(database: &Database, ids: &[ObjectId], pattern: &str) -> Vec<ObjectId> {
    ids.iter().copied().filter(|id| glob(pattern, &database.object(*id).name)).collect()
}

fn not_found(database: &Database, registry: &Registry, name: &str, wanted: &str, span: Span) -> Diagnostic {
    let word = word_of(registry, wanted);
    let lower = word.to_lowercase();
    let Some(rest) = name.strip_prefix('.') else {
        let mut error = Diagnostic::error("name/not-found", format!("there is no {lower} named `{name}`"))
            .at(span, "not found")
            .adams(format!("No {word} named '{name}' was found."));
        if let Some(id) = search_one(database, name, "any") {
            error.message = wrong_kind(database, id, name, &lower);
            return error;
        }
        let below = database.current("model").map(|model| database.below(model, wanted)).unwrap_or_default();
        let names = below.iter().map(|id| database.object(*id).name.as_str());
        return did_you_mean(error, names, name, span, quoted).unwrap_or_else(|error| error);
    };
    let steps = split_name(rest);
    let mut parent: Option<ObjectId> = None;
    for (depth, step) in steps.iter().enumerate() {
        let last = depth + 1 == steps.len();
        let next = if last {
            database.child(parent, step, wanted)
        } else {
            database.children_named(parent, step).first().copied()
        };
        if let Some(next) = next {
            parent = Some(next);
            continue;
        }
        let siblings = parent.map_or_else(|| database.roots().to_vec(), |p| database.object(p).children.clone());
        let names: Vec<&str> = siblings
            .iter()
            .map(|id| database.object(*id))
            .filter(|o| !last || o.class.is(wanted))
            .map(|o| o.name.as_str())
            .collect();
        let mut error = Diagnostic::error(
            "name/not-found",
            match parent {
                Some(p) => format!("there is no {lower} `{name}`: `{}` has no `{step}`", database.full_name(p)),
                None => format!("there is no {lower} `{name}`: nothing is named `.{step}`"),
            },
        )
        .at(span, "not found")
        .adams(match parent {
            Some(p) => {
                format!("No {word} was found because '{step}' does not exist beneath '{}'.", database.full_name(p))
            }
            None => format!("No {word} named '{step}' was found."),
        });
        if let Some(other) = database.child(parent, step, "any") {
            error.message = wrong_kind(database, other, name, &lower);
            return error;
        }
        let full = |near: &str| {
            let mut full: Vec<String> = steps.iter().map(|s| quoted(s)).collect();
            full[depth] = quoted(near);
            format!(".{}", full.join("."))
        };
        return did_you_mean(error, names, step, span, full).unwrap_or_else(|error| error);
    }
    Diagnostic::error("name/not-found", format!("there is no {lower} `{name}`")).at(span, "not found")
}

/// The complaint about an object that is there and is of another kind than is wanted.
fn wrong_kind(database: &Database, id: ObjectId, name: &str, wanted: &str) -> String {
    format!("`{name}` is a {}, not a {wanted}", database.object(id).class.word)
}

/// Where a new object of a class goes when nothing or only its own name is given.
pub fn default_parent(database: &Database, class: &Class) -> Option<ObjectId> {
    class.parents.iter().find_map(|wanted| {
        let current = database.current(wanted)?;
        class.parents.iter().any(|p| database.object(current).class.is(p)).then_some(current)
    })
}

/// Reads the name of an object to be created: bare, or in full.
pub fn new_name(
    database: &Database,
    registry: &Registry,
    class: &'static Class,
    typed: &str,
    span: Span,
) -> Result<NewName, Diagnostic> {
    let steps = name_steps(typed.strip_prefix('.').unwrap_or(typed));
    let Some((name, path)) = steps.split_last() else { return Err(bad_name(typed, span)) };
    if name.is_empty() || steps.iter().any(|s| s.is_empty()) || name.contains(char::is_control) {
        return Err(bad_name(typed, span));
    }
    if typed.contains("\\\"") {
        return Err(bad_name(typed, span).help("a name holds no double quotes"));
    }
    let odd = quoted(name);
    if !typed.ends_with('"') && odd != *name {
        let path = typed.strip_suffix(name.as_ref()).unwrap_or_default();
        return Err(bad_name(typed, span).fix("put the name in double quotes", span, format!("{path}{odd}")));
    }
    if !typed.starts_with('.') {
        if !path.is_empty() {
            let mut error = Diagnostic::error(
                "name/partial-path",
                format!("the new name `{typed}` has a path but does not start at the root"),
            )
            .at(span, "starts without a dot")
            .adams("Invalid input. Enter return or a parameter.");
            if let Some(model) = database.current("model") {
                let full = format!("{}.{typed}", database.full_name(model));
                error = error.fix(format!("write `{full}`"), span, full);
            }
            return Err(error);
        }
        let parent = default_parent(database, class);
        if parent.is_none() && !class.parents.is_empty() {
            return Err(no_parent(class, typed, span));
        }
        return Ok(NewName { parent, name: name.to_string() });
    }
    let mut parent = None;
    for (depth, step) in path.iter().enumerate() {
        let last = depth + 1 == path.len();
        let candidates = database.children_named(parent, step);
        let next = candidates
            .iter()
            .copied()
            .find(|c| {
                !last || class.parents.iter().any(|p| database.object(*c).class.is(p)) || holds_anything(database, *c)
            })
            .or_else(|| if last { None } else { candidates.first().copied() });
        let Some(next) = next else {
            let word = class.word;
            if let Some(wrong) = candidates.first() {
                return Err(Diagnostic::error(
                    "name/no-parent",
                    format!(
                        "a {} cannot be below `{}`, which is a {}",
                        word.to_lowercase(),
                        database.full_name(*wrong),
                        database.object(*wrong).class.word
                    ),
                )
                .at(span, format!("goes below: {}", class.parents.join(", ")))
                .adams("Invalid input. Enter return or a parameter."));
            }
            let mut error = match parent {
                Some(p) => Diagnostic::error(
                    "name/no-parent",
                    format!("`{typed}` has no place: `{}` has no `{step}`", database.full_name(p)),
                )
                .adams(format!(
                    "No {word} was found because '{step}' does not exist beneath '{}'.",
                    database.full_name(p)
                )),
                None => {
                    Diagnostic::error("name/no-parent", format!("`{typed}` has no place: nothing is named `.{step}`"))
                        .adams(format!("No {word} named '{step}' was found."))
                }
            }
            .at(span, "create what it belongs to first");
            let siblings = parent.map_or_else(|| database.roots().to_vec(), |p| database.object(p).children.clone());
            if let Some(near) = nearest(siblings.iter().map(|s| database.object(*s).name.as_str()), step) {
                error = error.help(format!("did you mean `{near}`?"));
            }
            return Err(error);
        };
        parent = Some(next);
    }
    // Variables, macros and libraries may be at the top; what else needs a parent may not.
    if parent.is_none() && !class.parents.is_empty() && !matches!(class.id, "variable" | "macro" | "library") {
        let _ = registry;
        return Err(no_parent(class, typed, span));
    }
    Ok(NewName { parent, name: name.to_string() })
}

fn no_parent(class: &Class, typed: &str, span: Span) -> Diagnostic {
    let parents = class.parents.join(" or ");
    Diagnostic::error(
        "name/no-parent",
        format!("the {} `{typed}` has no place: there is no {parents}", class.word.to_lowercase()),
    )
    .at(span, format!("must be below a {parents}"))
    .help(format!("create a {} first, or write the full name", class.parents.first().unwrap_or(&"model")))
    .adams("Invalid input. Enter return or a parameter.")
}

fn bad_name(typed: &str, span: Span) -> Diagnostic {
    Diagnostic::error("name/invalid", format!("`{typed}` cannot be a name"))
        .at(span, "letters, digits and `_`, not starting with a digit; other names in double quotes")
        .adams("Invalid input. Enter return or a parameter.")
}

/// The complaint about a name that is in use.
pub fn taken(database: &Database, class: &Class, typed: &str, other: ObjectId, span: Span) -> Diagnostic {
    Diagnostic::error(
        "name/taken",
        format!("the {} `{}` exists already", class.word.to_lowercase(), database.full_name(other)),
    )
    .at(span, "name in use")
    .adams(format!("The {} '{typed}' already exists.", class.word))
}

/// Libraries and macros own variables and macros of their own.
fn holds_anything(database: &Database, id: ObjectId) -> bool {
    matches!(database.object(id).class.id, "library" | "macro" | "variable")
}
