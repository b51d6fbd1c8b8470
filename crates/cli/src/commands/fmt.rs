//! `flexure fmt`: the layout of command files. Nothing is executed.

use std::io::{IsTerminal, Read, Write};
use std::path::Path;

use flexure::Layout;
use flexure::text::{Diagnostic, Format};

use crate::Outcome;
use crate::arguments::Fmt;
use crate::commands::{complain, count, unified};
use crate::output::extension;

pub(super) fn execute(fmt: &Fmt) -> Outcome {
    let (mut changed, mut troubled) = (0_usize, false);
    for path in &fmt.files {
        match one(fmt, path) {
            Ok((change, trouble)) => {
                changed += usize::from(change);
                troubled |= trouble;
            }
            Err(sentence) => {
                complain(sentence);
                troubled = true;
            }
        }
    }
    let only_looked = fmt.check || fmt.diff;
    if only_looked && fmt.files.len() > 1 {
        eprintln!("{} would change", count(changed, "file"));
    }
    if troubled || only_looked && changed > 0 { Outcome::Findings } else { Outcome::Fine }
}

/// Lays out one file; whether it changed, and whether some of it was not understood.
fn one(fmt: &Fmt, path: &Path) -> Result<(bool, bool), String> {
    let stdin = path == Path::new("-");
    let name = if stdin { "<standard input>".to_owned() } else { path.display().to_string() };
    if extension(path) == "adm" {
        let help = "command files are laid out; `flexure convert` writes a dataset anew, or as commands";
        return Err(format!("{name} is a solver dataset: {help}"));
    }
    let mut bytes = Vec::new();
    let read = if stdin {
        std::io::stdin().read_to_end(&mut bytes).map(|_| ())
    } else {
        std::fs::read(path).map(|read| bytes = read)
    };
    read.map_err(|error| format!("cannot read {name}: {error}"))?;
    let layout = Layout::of(&name, bytes);
    report(&layout, &name);
    let changed = layout.changed();
    if fmt.diff && changed {
        print!("{}", unified(&name, layout.before(), layout.after()));
    } else if fmt.check && changed {
        println!("{name}");
    }
    if !fmt.check && !fmt.diff {
        let cannot = |error| format!("cannot write {name}: {error}");
        if stdin {
            std::io::stdout().write_all(&layout.bytes()).map_err(cannot)?;
        } else if changed {
            flexure::files::write(path, layout.bytes()).map_err(cannot)?;
        }
    }
    Ok((changed, layout.diagnostics().iter().any(Diagnostic::is_error)))
}

/// Says what was left as it is, and why.
fn report(layout: &Layout, name: &str) {
    const MOST: usize = 20;
    let all = layout.diagnostics();
    if all.is_empty() {
        return;
    }
    let colours = flexure::text::use_colours(std::io::stderr().is_terminal());
    let shown = all.get(..MOST).unwrap_or(all);
    eprint!("{}", flexure::text::render(layout.sources(), shown, Format::Terminal { colours }));
    if all.len() > MOST {
        eprintln!("... and {} more in {name}", all.len() - MOST);
    }
    eprintln!("{name}: what is not understood is left as it is");
}
