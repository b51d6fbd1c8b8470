//! Every parenthesised expression of the real exports: it binds or names what is unknown, and its
//! printed form is stable. Skipped without the folder of shared files.

mod common;
use common::*;
use flexure_expressions::{Bound, Scope, bind, print};
use model::ObjectId;
use std::collections::BTreeMap;
use syntax::command::{Expression, ExpressionKind, ItemKind, StatementKind, parse};

fn files(folder: &std::path::Path, found: &mut Vec<std::path::PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut entries: Vec<_> = entries.flatten().map(|e| e.path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "cmd") {
            found.push(path);
        }
    }
}

fn for_all(list: &[Expression], found: &mut Vec<String>) {
    for expression in list {
        names(expression, found);
    }
}

fn names(expression: &Expression, found: &mut Vec<String>) {
    match &expression.kind {
        ExpressionKind::Name(name) => found.push(name.clone()),
        ExpressionKind::Call { arguments: list, .. }
        | ExpressionKind::Array(list)
        | ExpressionKind::Row(list)
        | ExpressionKind::Tuple(list) => for_all(list, found),
        ExpressionKind::Index(inner, list) => {
            names(inner, found);
            for_all(list, found);
        }
        ExpressionKind::Attribute(inner, _) | ExpressionKind::Unary(_, inner) => names(inner, found),
        ExpressionKind::Binary(_, a, b) => {
            names(a, found);
            names(b, found);
        }
        ExpressionKind::Conditional(a, b, c) => {
            names(a, found);
            names(b, found);
            names(c, found);
        }
        _ => {}
    }
}

/// Makes every full name an object: three steps a marker, two a variable.
fn create(db: &mut model::Database, name: &str) {
    let steps = model::split_name(name.strip_prefix('.').unwrap_or(name));
    let mut parent: Option<ObjectId> = None;
    for (i, step) in steps.iter().enumerate() {
        let class = match (i, steps.len()) {
            (0, _) => &MODEL,
            (1, 2) => &VARIABLE,
            (1, _) => &PART,
            _ => &MARKER,
        };
        let existing = db.children_named(parent, step).first().copied();
        parent = existing.or_else(|| db.create(class, parent, step).ok());
    }
}

#[test]
fn real_expressions_bind_and_print_stably() {
    let Some(shared) = std::env::var_os("FLEXURE_SHARED") else {
        println!("skipped: FLEXURE_SHARED is not set");
        return;
    };
    let mut paths = Vec::new();
    files(&std::path::Path::new(&shared).join("corpus"), &mut paths);
    assert!(!paths.is_empty(), "the corpus has command files");
    let (mut count, mut refused) = (0, BTreeMap::<String, usize>::new());
    for path in paths {
        let mut sources = text::Sources::default();
        let file = sources.add_bytes(path.display().to_string(), std::fs::read(&path).unwrap());
        let (statements, _) = parse(file, sources.text(file));
        let mut expressions = Vec::new();
        for statement in statements {
            let items = match statement.kind {
                StatementKind::Command { arguments, .. } => arguments.into_iter().flat_map(|a| a.values).collect(),
                StatementKind::Assignment { values, .. } => values,
                StatementKind::Broken => continue,
            };
            for item in items {
                if let ItemKind::Expression(expression) = item.kind {
                    expressions.push(*expression);
                }
            }
        }
        let mut db = model::Database::default();
        // Unknown names first: nothing exists, nothing may panic.
        for expression in &expressions {
            let _ = bind(expression, &Scope::new(&db, &sources));
        }
        let mut found = Vec::new();
        for_all(&expressions, &mut found);
        found.iter().filter(|n| n.starts_with('.')).for_each(|n| create(&mut db, n));
        for expression in &expressions {
            count += 1;
            match bind(expression, &Scope::new(&db, &sources)) {
                Ok(Bound::Expression(bound)) => {
                    let printed = print(&bound, &db);
                    let again = bound_for(&db, &printed, None);
                    assert_eq!(again, Ok(Bound::Expression(bound)), "{}: {printed}", path.display());
                }
                Ok(Bound::Value(_)) => {}
                Err(errors) => {
                    assert!(!errors.is_empty(), "{}: {}", path.display(), sources.slice(expression.span));
                    *refused.entry(format!("{}: {}", errors[0].code, errors[0].message)).or_default() += 1;
                }
            }
        }
    }
    println!("{count} expressions, refused: {refused:#?}");
    assert!(count > 1000);
}
