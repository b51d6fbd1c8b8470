//! `flexure verify`: degrees of freedom, redundant constraints, the traps of beams, and their mending.

use std::path::PathBuf;

use flexure::{Session, Verification};

use crate::Outcome;
use crate::arguments::Verify;
use crate::commands::{complain, count, open, print, session};

pub(super) fn execute(verify: &Verify) -> Outcome {
    let mut session = session();
    session.simulate_nothing(true);
    let sound = open(&mut session, &verify.model, &verify.edits);
    if session.model().is_none() {
        return Outcome::Findings;
    }
    let found = session.verify();
    if verify.json {
        let findings: Vec<_> = found
            .findings
            .iter()
            .map(|f| {
                serde_json::json!({
                    "severity": if f.diagnostic.is_error() { "error" } else { "warning" },
                    "code": f.diagnostic.code,
                    "message": f.diagnostic.message,
                    "notes": f.diagnostic.notes,
                    "fix": f.fix,
                })
            })
            .collect();
        println!("{:#}", serde_json::json!({ "report": found.report, "findings": findings }));
    } else {
        found.report.iter().for_each(|line| println!("{line}"));
        let diagnostics: Vec<_> = found.findings.iter().map(|f| f.diagnostic.clone()).collect();
        print(&session, &diagnostics);
        if !found.findings.is_empty() {
            let mendable = found.findings.iter().filter(|f| f.fix.is_some()).count();
            eprintln!("{}, {mendable} of them can be mended with --fix", count(found.findings.len(), "finding"));
        }
    }
    if verify.fix {
        let mended = mend(&mut session, &found);
        let path = verify.out.clone().unwrap_or_else(|| beside(&verify.model));
        if let Err(diagnostics) = session.write(&path) {
            print(&session, &diagnostics);
            return Outcome::Findings;
        }
        eprintln!("{}; written to {}", count(mended, "finding") + " mended", path.display());
        if session.verify().findings.is_empty() && sound {
            println!("{}", path.display());
        } else {
            complain("not everything could be mended");
        }
    }
    // The model as given had findings, whatever was mended in the copy.
    if found.findings.is_empty() && sound { Outcome::Fine } else { Outcome::Findings }
}

/// Mends until nothing more can be: exchanged ends hide a wrong length. Returns how many findings had a
/// fix that was executed.
fn mend(session: &mut Session, found: &Verification) -> usize {
    let mut tried: Vec<String> = Vec::new();
    let mut mended = 0;
    let mut left = found.clone();
    loop {
        // What did not help is not tried again.
        left.findings.retain(|f| f.fix.as_ref().is_some_and(|fix| !tried.contains(fix)));
        if left.findings.is_empty() {
            return mended;
        }
        tried.extend(left.findings.iter().filter_map(|f| f.fix.clone()));
        let report = session.fix(&left);
        print(session, &report.diagnostics);
        mended += left.findings.len().saturating_sub(report.failed);
        left = session.verify();
    }
}

/// `car.cmd` -> `car_fixed.cmd`, in the folder one works in.
fn beside(model: &std::path::Path) -> PathBuf {
    let stem = model.file_stem().map_or_else(|| "model".into(), |s| s.to_string_lossy().into_owned());
    PathBuf::from(format!("{stem}_fixed.cmd"))
}
