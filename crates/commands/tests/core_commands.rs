//! The commands of Adams View that build, change, list and simulate models, against the tables of
//! parameters in the fact sheet `spec/commands-core.md` (outside of this repository, found by
//! `FLEXURE_SHARED`): every one is known, takes the same parameters, and does something, unless a
//! reason is written here. And whatever is known has an explanation.

use std::collections::BTreeSet;

use flexure_commands::{Action, Command, CommandTree, Interpreter, Path};
use model::Database;

/// Commands that are understood and not executed, and why.
const REFUSED: &[(&str, &str)] = &[
    ("simulation single_run statematrix", "the solver computes modes, not matrices, for now"),
    ("simulation single_run save", "runs keep their results by the name of their analysis"),
    ("simulation single_run set", "there is no picture to update"),
    ("simulation set", "there is one solver"),
    ("simulation multi_run design_study", "sets of runs are made with loops"),
    ("simulation multi_run optimization", "nothing is optimised"),
    ("file analysis read", "results are files, not objects"),
    ("file analysis write", "results are files, not objects"),
    ("file binary read", "the format is not published"),
    ("file binary write", "the format is not published"),
    ("file log_file", "the log is chosen where the session begins"),
    ("file parasolid read", "the format is not published"),
    ("file parasolid write", "the format is not published"),
    ("file request read", "results are files, not objects"),
    ("file results read", "results are files, not objects"),
    ("file graphics read", "results are files, not objects"),
    ("numeric_results write", "results are files, not objects"),
    ("numeric_results read_from_file", "results are files, not objects"),
    ("numeric_results create values", "results are files, not objects"),
    ("numeric_results delete", "results are files, not objects"),
    ("pause", "nobody is asked"),
    ("system", "no program is started"),
];

/// Commands of the sheet that are not known yet.
const NOT_YET: &[(&str, &str)] = &[];

/// Parameters of the sheet that a command does not take, and why.
const NOT_TAKEN: &[(&str, &str, &str)] = &[
    ("part attributes", "flexible_body_name", "there are no flexible bodies"),
    ("part attributes", "external_system_name", "there are no external systems"),
    ("part attributes", "fe_part_name", "there are no flexible parts"),
    ("part attributes", "fe_node_name", "there are no flexible parts"),
];

/// Shortest forms of the sheet that are longer here, and why.
const LONGER: &[(&str, &str, &str)] = &[("simulation script modify", "n", "it can be renamed as well")];

/// Parameters of our own.
const OUR_OWN: &[(&str, &str, &str)] = &[
    ("simulation single_run transient", "analysis_name", "results have a name"),
    ("defaults units", "system_of_units", "four systems by name, as the dialog offers them"),
    ("file command write", "model_name", "as for datasets"),
    ("simulation single_run reset", "model_name", "the model that goes back, if it is not the current one"),
    ("simulation script modify", "new_sim_script_name", "every class can be renamed by its modify command"),
];

/// The commands of a session, which knows macros and libraries besides the elements.
fn tree() -> CommandTree {
    CommandTree::new(Interpreter::new(elements::registry()).registry())
}

fn find(tree: &CommandTree, path: &str) -> Option<Command> {
    let words: Vec<&str> = path.split(' ').collect();
    match tree.find(&words, &Database::default()) {
        Path::Found(command) => Some(command),
        _ => None,
    }
}

/// A parameter of the sheet: name, whether create and modify take it, shortest form for each.
#[derive(Clone)]
struct Row {
    name: String,
    modify_only: bool,
    create_only: bool,
    short: (String, String),
}

/// The commands of the sheet with their parameters.
fn sheet() -> Option<Vec<(String, Vec<Row>)>> {
    let Ok(shared) = std::env::var("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return None;
    };
    let text = std::fs::read_to_string(format!("{shared}/spec/commands-core.md")).unwrap();
    let mut found: Vec<(String, Vec<Row>)> = Vec::new();
    let mut titles: Vec<String> = Vec::new();
    let mut rows: Vec<Row> = Vec::new();
    let mut wanted = false;
    for line in text.lines().chain(["## end"]) {
        if line.starts_with('#') {
            for title in std::mem::take(&mut titles) {
                found.push((title, rows.clone()));
            }
            rows.clear();
            // The commands of beams stand in tables of another form; they have tests of their own.
            if line.starts_with("## ") {
                wanted = !line.contains("Beam") && !line.contains("abbreviations");
            }
            if let Some(heading) = line.strip_prefix("### ").filter(|_| wanted) {
                titles = heading.split("; ").map(str::to_string).collect();
            }
        } else if let Some(row) = line.strip_prefix("| ") {
            let cells: Vec<&str> = row.split(" | ").map(|c| c.trim().trim_end_matches('|').trim()).collect();
            let name = cells[0];
            if name.starts_with("---") || name == "parameter" || titles.is_empty() {
                continue;
            }
            let meaning = cells.last().copied().unwrap_or("");
            let short = cells.get(4).copied().unwrap_or("");
            let (create, modify) = short.split_once('/').unwrap_or((short, short));
            rows.push(Row {
                name: name.to_string(),
                modify_only: meaning.contains("modify only"),
                create_only: meaning.contains("create only"),
                short: (create.to_string(), modify.to_string()),
            });
        }
    }
    Some(found)
}

/// A command with its parameters: name and what stands behind it.
type SheetCommand = (String, Vec<(String, String)>);

/// `marker create|modify` as two commands.
fn commands() -> Option<Vec<SheetCommand>> {
    let mut all = Vec::new();
    for (title, rows) in &sheet()? {
        let both = title.contains("create|modify");
        for verb in if both { &["create", "modify"][..] } else { &[""] } {
            let path = title.replace("create|modify", verb);
            let creating = *verb != "modify";
            let takes = |r: &&Row| if creating { !r.modify_only } else { !r.create_only };
            let short = |r: &Row| if creating { r.short.0.clone() } else { r.short.1.clone() };
            let list = rows.iter().filter(takes).map(|r| (r.name.clone(), short(r))).collect();
            all.push((path, list));
        }
    }
    Some(all)
}

#[test]
fn every_command_of_the_sheet_is_known_and_does_something() {
    let Some(commands) = commands() else { return };
    let tree = tree();
    let mut troubles = Vec::new();
    let mut refused = BTreeSet::new();
    for (path, _) in &commands {
        let known = NOT_YET.iter().any(|(p, _)| p == path);
        match find(&tree, path) {
            None if !known => troubles.push(format!("{path}: not a command")),
            Some(c) if matches!(c.action, Action::Unsupported) && !known => {
                troubles.push(format!("{path}: not executed"));
            }
            Some(c) if !matches!(c.action, Action::Unsupported) => {
                if known {
                    println!("{path} is there now");
                }
                if c.is_refused() {
                    refused.insert(path.clone());
                }
            }
            _ => {}
        }
    }
    let listed: BTreeSet<String> = REFUSED.iter().map(|(p, _)| (*p).to_string()).collect();
    assert!(commands.len() > 300, "only {} commands were read from the sheet", commands.len());
    assert!(troubles.is_empty(), "{} of {}:\n{}", troubles.len(), commands.len(), troubles.join("\n"));
    assert_eq!(refused, listed, "what is refused and why");
}

#[test]
fn commands_take_the_parameters_of_the_sheet() {
    let Some(commands) = commands() else { return };
    let tree = tree();
    let mut troubles = Vec::new();
    for (path, rows) in &commands {
        let Some(command) = find(&tree, path).filter(|c| !matches!(c.action, Action::Unsupported)) else { continue };
        let taken: BTreeSet<&str> = command.parameters.iter().map(|p| &*p.name).collect();
        let wanted: BTreeSet<&str> = rows.iter().map(|r| r.0.as_str()).collect();
        let excused = |list: &[(&str, &str, &str)], name: &str| {
            list.iter().any(|(p, n, _)| (*p == path || *p == "*") && *n == name)
        };
        let missing: Vec<&str> = wanted.difference(&taken).copied().filter(|n| !excused(NOT_TAKEN, n)).collect();
        let extra: Vec<&str> = taken.difference(&wanted).copied().filter(|n| !excused(OUR_OWN, n)).collect();
        if !missing.is_empty() {
            troubles.push(format!("{path}: lacks {}", missing.join(", ")));
        }
        if !extra.is_empty() {
            troubles.push(format!("{path}: has in addition {}", extra.join(", ")));
        }
    }
    assert!(troubles.is_empty(), "{}\n{}", troubles.len(), troubles.join("\n"));
}

/// The shortest forms of parameters in the sheet stand for the same parameters here.
#[test]
fn parameters_are_found_by_their_shortest_forms() {
    let Some(commands) = commands() else { return };
    let tree = tree();
    let mut troubles = Vec::new();
    for (path, rows) in &commands {
        let Some(command) = find(&tree, path).filter(|c| !matches!(c.action, Action::Unsupported)) else { continue };
        for (name, short) in rows {
            let excused = LONGER.iter().any(|(p, s, _)| p == path && s == short);
            if excused || short.is_empty() || short == "-" || !command.parameters.iter().any(|p| *p.name == **name) {
                continue;
            }
            let begins: Vec<&str> =
                command.parameters.iter().map(|p| &*p.name).filter(|n| n.starts_with(short.as_str())).collect();
            if begins != [name.as_str()] && short != name {
                troubles.push(format!("{path}: `{short}` may be {}", begins.join(", ")));
            }
        }
    }
    assert!(troubles.is_empty(), "{}\n{}", troubles.len(), troubles.join("\n"));
}

#[test]
fn everything_is_explained() {
    let tree = tree();
    let mut troubles = Vec::new();
    for command in tree.commands(&Database::default()).into_iter().filter(|c| !matches!(c.action, Action::Unsupported))
    {
        if command.doc().is_empty() {
            troubles.push(format!("{} has no explanation", command.path));
        }
        for parameter in command.parameters.iter().filter(|p| p.field.doc.is_empty()) {
            let named = matches!(parameter.role, flexure_commands::Role::Object | flexure_commands::Role::NewName);
            if !named {
                troubles.push(format!("{}: {} has no explanation", command.path, parameter.name));
            }
        }
    }
    assert!(troubles.is_empty(), "{}", troubles.join("\n"));
}
