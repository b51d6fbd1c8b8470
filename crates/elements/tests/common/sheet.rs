//! The sheet of commands, read from its tables, and its comparison with the schemas: names, kinds,
//! sizes of lists, defaults, which command takes a parameter, what excludes what.
#![allow(dead_code)] // each test file uses its own part

use std::path::PathBuf;

use schema::{Count, Default, Dimension, Field, Group, Kind, Quantity, Registry, Rule, Use};

/// One command of the sheet, or a pair that creates and modifies.
#[derive(Clone, Debug)]
pub struct Command {
    /// As [`Group::command`] has it: `force create element_like beam`.
    pub path: String,
    pub rows: Vec<Row>,
    /// Sets of parameters of which one may be given.
    pub exclusive: Vec<Vec<String>>,
}

/// One parameter.
#[derive(Clone, Debug)]
pub struct Row {
    pub name: String,
    /// The type as written: `old marker [list]`.
    pub kind: String,
    pub required: bool,
    pub default: String,
    pub usage: Use,
}

/// The sections of the sheet with their commands.
pub struct Sheet {
    sections: Vec<(String, Vec<Command>)>,
}

impl Sheet {
    /// The sheet; none, with a printed line, where the shared folder is not at hand.
    pub fn read() -> Option<Sheet> {
        let Some(folder) = std::env::var_os("FLEXURE_SHARED").map(PathBuf::from) else {
            println!("skipped: FLEXURE_SHARED is not set");
            return None;
        };
        let path = folder.join("spec/commands-core.md");
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        Some(Sheet::parse(&text))
    }

    pub fn parse(text: &str) -> Sheet {
        let mut sections: Vec<(String, Vec<Command>)> = Vec::new();
        // How many of the last commands the tables below a heading are about.
        let mut open = 0;
        for line in text.lines() {
            if let Some(title) = line.strip_prefix("## ") {
                sections.push((title.trim().to_string(), Vec::new()));
                open = 0;
            } else if let (Some(heading), Some((_, commands))) = (line.strip_prefix("### "), sections.last_mut()) {
                let paths: Vec<_> = heading.split(';').map(|p| p.trim().replace("create|modify", "create")).collect();
                open = paths.len();
                commands.extend(paths.into_iter().map(|path| Command {
                    path,
                    rows: Vec::new(),
                    exclusive: Vec::new(),
                }));
            } else if let Some((_, commands)) = sections.last_mut() {
                let begin = commands.len() - open.min(commands.len());
                for command in &mut commands[begin..] {
                    command.line(line);
                }
            }
        }
        Sheet { sections }
    }

    /// The commands of a section.
    pub fn section(&self, title: &str) -> &[Command] {
        let found = self.sections.iter().find(|(t, _)| t == title);
        &found.unwrap_or_else(|| panic!("the sheet has no section {title}")).1
    }
}

impl Command {
    fn line(&mut self, line: &str) {
        if let Some(list) = line.strip_prefix("Exclusive: ") {
            self.exclusive.push(list.split('|').map(|n| n.trim().to_string()).collect());
        }
        let Some(inner) = line.strip_prefix("| ") else { return };
        let cells: Vec<&str> = inner.trim_end_matches('|').split(" |").map(str::trim).collect();
        let &[name, kind, required, default, _, meaning] = cells.as_slice() else { return };
        if name == "parameter" || name.starts_with('-') {
            return;
        }
        let usage = match meaning {
            m if m.starts_with("create only") => Use::Create,
            m if m.starts_with("modify only") => Use::Modify,
            _ => Use::Both,
        };
        self.rows.push(Row {
            name: name.to_string(),
            kind: kind.to_string(),
            required: required == "yes",
            default: default.to_string(),
            usage,
        });
    }

    /// Whether it sets attributes, copies or deletes, and so belongs to several classes or to none.
    pub fn is_of_a_class(&self) -> bool {
        self.path.contains(" create ") || self.path.ends_with(" create")
    }
}

/// A type of the sheet: kind and number of values.
struct Wanted<'a> {
    base: &'a str,
    count: Option<Count>,
}

/// Splits `old marker [2..3]` into what it is and how many; `None` where one value is meant.
fn wanted(kind: &str) -> Wanted<'_> {
    let Some((base, rest)) = kind.split_once(" [") else { return Wanted { base: kind, count: None } };
    let size = rest.trim_end_matches(']');
    let count = match size.split_once("..") {
        Some((least, most)) => Count::between(least.parse().unwrap_or(1), most.parse().unwrap_or(usize::MAX)),
        None => size.parse().map_or(Count::MANY, Count::exactly),
    };
    Wanted { base, count: Some(count) }
}

/// Names of quantities that the sheet shortens.
fn dimension(word: &str) -> Option<Dimension> {
    let full = match word {
        "angular_vel" => "angular_velocity",
        "angular_acc" => "angular_acceleration",
        "torsion_stiff" => "torsion_stiffness",
        "torsion_damp" => "torsion_damping",
        "real" => "no_units",
        other => other,
    };
    Quantity::named(full).map(|q| q.dimension)
}

/// What differs between the rows of a command and the fields of its group, one line each.
pub fn differences(registry: &Registry, command: &Command) -> Vec<String> {
    let groups = registry.groups(&command.path);
    let Some((_, group)) = groups.iter().find(|(_, g)| g.creates).or(groups.first()) else {
        return vec![format!("{}: missing", command.path)];
    };
    let mut found = Vec::new();
    for row in &command.rows {
        if row.name == group.object || row.name == format!("new_{}", group.object) {
            continue;
        }
        let Some(field) = group.fields.iter().find(|f| f.name == row.name) else {
            found.push(format!("{} {}: missing", command.path, row.name));
            continue;
        };
        for what in compare(row, field, group) {
            found.push(format!("{} {}: {what}", command.path, row.name));
        }
    }
    for field in group.fields {
        if !command.rows.iter().any(|row| row.name == field.name) {
            found.push(format!("{} {}: not in the sheet", command.path, field.name));
        }
    }
    for set in &command.exclusive {
        // Which object is meant is one parameter in each group.
        let fields = set.iter().filter(|n| group.fields.iter().any(|f| f.name == **n)).count();
        let ruled = group.rules.iter().any(|rule| match rule {
            Rule::AtMostOne(names) => set.iter().all(|n| names.contains(&n.as_str())),
            Rule::OneOf(sets) => set.iter().all(|n| sets.iter().any(|s| s.contains(&n.as_str()))),
            Rule::AtLeastOne(_) => false,
        });
        if fields > 1 && !ruled {
            found.push(format!("{}: {} do not exclude each other", command.path, set.join(", ")));
        }
    }
    found
}

fn compare(row: &Row, field: &Field, group: &Group) -> Vec<String> {
    let mut found = Vec::new();
    let Wanted { base, count } = wanted(&row.kind);
    if !kind_fits(base, count.is_some(), field) {
        found.push(format!("kind {:?}, not {}", field.kind, row.kind));
    }
    // Functions and subroutine constants take what is given; directions take one or two points more.
    let free = matches!(field.kind, Kind::Function | Kind::Location | Kind::Orientation);
    let constants = base == "real" && count.is_none() && field.count.most > 1;
    if !free && !constants && field.count != count.unwrap_or(Count::ONE) {
        found.push(format!("{:?}, not {}", field.count, row.kind));
    }
    if field.usage != row.usage {
        found.push(format!("{:?}, not {:?}", field.usage, row.usage));
    }
    if !default_fits(row, field) {
        found.push(format!("default {:?}, not {}", field.default, row.default));
    }
    let demanded = group.rules.iter().any(|rule| match rule {
        Rule::AtLeastOne(names) => names.contains(&field.name),
        Rule::OneOf(sets) => sets.iter().any(|s| s.contains(&field.name)),
        Rule::AtMostOne(_) => false,
    });
    if row.required && row.default.is_empty() && !field.required && !demanded {
        found.push("not required".into());
    }
    if !row.required && field.required {
        found.push("required".into());
    }
    found
}

fn kind_fits(base: &str, list: bool, field: &Field) -> bool {
    let words: Vec<&str> = base.split('/').collect();
    match field.kind {
        // Colours, views and pictures are names only.
        Kind::Text | Kind::File => {
            matches!(base, "string" | "file" | "old colour" | "old view" | "old gcell" | "Any" | "any")
        }
        Kind::Function => base == "function",
        Kind::Integer => matches!(base, "integer" | "id"),
        Kind::Location => base == "location",
        Kind::Orientation => base == "orientation",
        Kind::Real => dimension(base) == Some(field.dimension),
        Kind::Boolean(yes, no) => !list && (words == [yes, no] || (base == "true" && yes == "true")),
        // Of a long list the sheet gives the first words and how many there are.
        Kind::Choice(choices) if base.contains('…') => {
            let (first, last) = words.split_at(words.len() - 1);
            last[0] == format!("…({})", choices.len()) && first.iter().zip(choices).all(|(a, b)| a == b)
        }
        Kind::Choice(choices) => {
            words.len() == choices.len() && words.iter().zip(choices).all(|(a, b)| a.eq_ignore_ascii_case(b))
        }
        Kind::Object(_, wanted) => {
            let Some(word) = base.strip_prefix("old ") else { return false };
            let word = word.split(" (").next().unwrap_or(word);
            let word = if word == "design_point" { "point" } else { word };
            word.replace(' ', "_") == wanted
        }
        Kind::Any => true,
    }
}

fn default_fits(row: &Row, field: &Field) -> bool {
    // What is not given places nothing; where a place is read is a frame.
    if matches!(field.kind, Kind::Orientation | Kind::Location) {
        return true;
    }
    let numbers: Result<Vec<f64>, _> = row.default.split(',').map(|n| n.trim().parse::<f64>()).collect();
    match (field.default, row.default.as_str()) {
        (Default::None, "") | (Default::CoordinateSystem, "default coord. system") => true,
        (Default::Current, text) => text.starts_with("current default"),
        (Default::Word(word), text) => text.eq_ignore_ascii_case(word),
        (Default::Number(x), _) => numbers.is_ok_and(|list| {
            list.iter().all(|n| *n == x) && (list.len() == 1 || field.count == Count::exactly(list.len()))
        }),
        _ => false,
    }
}

/// Compares commands that make objects with the schemas. Each known difference is a piece of its line
/// with the reason for it; one that no longer holds is a failure as well.
pub fn assert_same(registry: &Registry, commands: &[&Command], known: &[(&str, &str)]) {
    let found: Vec<String> = commands.iter().flat_map(|c| differences(registry, c)).collect();
    let new: Vec<_> = found.iter().filter(|line| !known.iter().any(|(piece, _)| line.contains(piece))).collect();
    assert!(new.is_empty(), "{} differences without a reason: {new:#?}", new.len());
    let old: Vec<_> = known.iter().filter(|(piece, _)| !found.iter().any(|line| line.contains(piece))).collect();
    assert!(old.is_empty(), "no longer a difference: {old:#?}");
}
