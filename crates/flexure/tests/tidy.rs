//! The import table of ARCHITECTURE.md against the manifests of the crates.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Rows `| crate | may import |` of the table under "Who may import whom".
fn table() -> Vec<(String, BTreeSet<String>)> {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let section = page.split("## Who may import whom").nth(1).expect("the section").split("\n## ").next().unwrap();
    section
        .lines()
        .filter(|l| l.starts_with("| ") && !l.contains("may import"))
        .map(|line| {
            let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            let allowed = cells[1].split(',').map(|s| s.trim().to_string()).filter(|s| s != "–").collect();
            (cells[0].to_string(), allowed)
        })
        .collect()
}

/// Own crates in `[dependencies]` of a manifest.
fn imports(name: &str, own: &BTreeSet<String>) -> BTreeSet<String> {
    let path = root().join("crates").join(name).join("Cargo.toml");
    let manifest = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let dependencies = manifest.split("[dependencies]").nth(1).unwrap_or("").split("\n[").next().unwrap_or("");
    dependencies
        .lines()
        .filter_map(|l| l.split(['.', '=', ' ']).next())
        // A crate may also be named in full.
        .map(|n| n.strip_prefix("flexure-").unwrap_or(n))
        // The room `parquet` is named after the library it wraps.
        .filter(|n| own.contains(*n) && *n != name)
        .map(ToString::to_string)
        .collect()
}

#[test]
fn no_crate_imports_what_the_table_does_not_allow() {
    let table = table();
    let own: BTreeSet<String> = table.iter().map(|(name, _)| name.clone()).collect();
    assert!(own.len() > 10, "the table was not found");
    for (name, allowed) in &table {
        let extra: Vec<_> = imports(name, &own).difference(allowed).cloned().collect();
        assert!(extra.is_empty(), "{name} imports {extra:?}");
    }
}

#[test]
fn every_crate_is_in_the_table() {
    let named: BTreeSet<String> = table().into_iter().map(|(name, _)| name).collect();
    for entry in fs::read_dir(root().join("crates")).expect("crates") {
        let name = entry.expect("entry").file_name().to_string_lossy().into_owned();
        assert!(named.contains(&name), "{name} is not in ARCHITECTURE.md");
    }
}
