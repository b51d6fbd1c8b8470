//! `flexure verify`: degrees of freedom, redundant constraints, the traps of beams, and their mending.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use flexure::text::Severity;
use flexure::{AttributeValue, Finding, Session, Verification};

use crate::Outcome;
use crate::arguments::Verify;
use crate::commands::{complain, count, mention_other_models, open, print_found, session, set_beams, shown};

/// A mended model may show the next trap: exchanged ends hide a wrong length. So often at most.
const MOST_ROUNDS: usize = 20;
/// Changes that one fix is described with.
const MOST_CHANGES: usize = 6;

pub(super) fn execute(verify: &Verify) -> Outcome {
    let mut session = session();
    session.simulate_nothing(true);
    set_beams(&mut session, &verify.beams);
    let sound = open(&mut session, &verify.model, &verify.edits);
    if session.model().is_none() {
        return Outcome::Findings;
    }
    mention_other_models(&session, "verified");
    let found = session.verify();
    if verify.json {
        println!("{:#}", json(&found));
    } else {
        show(&session, &found, sound, verify.fix);
    }
    if verify.fix {
        let wanted = |finding: &Finding| {
            verify.only.is_empty() || verify.only.iter().any(|code| code == finding.diagnostic.code)
        };
        let (mended, left) = mend(&mut session, &found, &wanted);
        let path = verify.out.clone().unwrap_or_else(|| beside(&verify.model));
        if let Err(diagnostics) = session.write(&path) {
            print_found(&session, &diagnostics);
            return Outcome::Findings;
        }
        eprintln!("{}; written to {}", count(mended, "finding") + " mended", path.display());
        if left.iter().any(|finding| matters(finding) && wanted(finding)) || !sound {
            complain("not everything could be mended");
        } else {
            println!("{}", path.display());
        }
    }
    // The model as given had findings, whatever was mended in the copy.
    if found.findings.iter().any(matters) || !sound { Outcome::Findings } else { Outcome::Fine }
}

/// Whether a finding asks for action.
fn matters(finding: &Finding) -> bool {
    finding.diagnostic.severity != Severity::Note
}

fn show(session: &Session, found: &Verification, sound: bool, mending: bool) {
    // What is wrong is printed with its notes below.
    let told = |line: &&String| {
        let error = line.strip_prefix("ERROR:").map(str::trim);
        error.is_none_or(|message| !found.findings.iter().any(|f| f.diagnostic.message == message))
    };
    let (last, report) = found.report.split_last().map_or(("", &[][..]), |(last, report)| (last.as_str(), report));
    report.iter().filter(told).for_each(|line| println!("{line}"));
    // A part of a model is not verified.
    println!("{}", if sound { last } else { "Model not verified: its file has errors" });
    let diagnostics: Vec<_> = found.findings.iter().map(|f| f.diagnostic.clone()).collect();
    print_found(session, &diagnostics);
    if !found.findings.is_empty() {
        let mendable = found.findings.iter().filter(|f| f.fix.is_some()).count();
        let advice = if mending { String::new() } else { format!(", {mendable} of them can be mended with --fix") };
        let notes = found.findings.iter().filter(|f| !matters(f)).count();
        let noted = if notes == 0 { String::new() } else { format!(" and {}", count(notes, "note")) };
        eprintln!("{}{noted}{advice}", count(found.findings.len() - notes, "finding"));
    }
}

fn json(found: &Verification) -> serde_json::Value {
    let findings: Vec<_> = found
        .findings
        .iter()
        .map(|f| {
            serde_json::json!({
                "severity": f.diagnostic.severity.word(),
                "code": f.diagnostic.code,
                "message": f.diagnostic.message,
                "notes": f.diagnostic.notes,
                "helps": f.diagnostic.helps.iter().map(|help| help.text.as_str()).collect::<Vec<_>>(),
                "fix": f.fix,
            })
        })
        .collect();
    serde_json::json!({ "report": found.report, "findings": findings })
}

/// What findings are of one kind: the code, and the object they are about.
type Kind = (&'static str, String);

fn kind(session: &Session, finding: &Finding) -> Kind {
    (finding.diagnostic.code, finding.object.map(|id| session.database().full_name(id)).unwrap_or_default())
}

/// Mends round by round, and says what was changed. A kind of finding is tried in one round only: what did
/// not help is not tried again with other numbers. Returns how many findings are gone, and those that are left.
fn mend(session: &mut Session, found: &Verification, wanted: &dyn Fn(&Finding) -> bool) -> (usize, Vec<Finding>) {
    let mut tried: BTreeMap<Kind, Vec<String>> = BTreeMap::new();
    let mut left = found.findings.clone();
    for _ in 0..MOST_ROUNDS {
        let new = |f: &&Finding| f.fix.is_some() && wanted(f) && !tried.contains_key(&kind(session, f));
        let round: Vec<Finding> = left.iter().filter(new).cloned().collect();
        if round.is_empty() {
            break;
        }
        for finding in round {
            let kind = kind(session, &finding);
            let change = fix(session, finding);
            tried.entry(kind).or_default().push(change);
        }
        left = session.verify().findings;
    }
    let mut of_kind: BTreeMap<Kind, usize> = BTreeMap::new();
    left.iter().for_each(|f| *of_kind.entry(kind(session, f)).or_default() += 1);
    let mut mended = 0;
    for (kind, changes) in tried {
        let rest = of_kind.get(&kind).copied().unwrap_or_default();
        let gone = changes.len().saturating_sub(rest);
        mended += gone;
        let word = match () {
            () if rest == 0 => "mended",
            () if gone == 0 => "not mended, though the fix was made",
            () => "partly mended",
        };
        changes.iter().for_each(|change| eprintln!("{word}: {}: {change}", kind.0));
    }
    (mended, left)
}

/// Executes the fix of one finding and describes what it changed.
fn fix(session: &mut Session, finding: Finding) -> String {
    let commands: Vec<Vec<(String, String)>> =
        finding.fix.iter().flat_map(|text| text.lines()).map(parameters).filter(|p| !p.is_empty()).collect();
    let before: Vec<Vec<String>> = commands.iter().map(|command| values(session, command, true)).collect();
    let report = session.fix(&Verification { report: Vec::new(), findings: vec![finding] });
    print_found(session, &report.diagnostics);
    let mut changes = Vec::new();
    for (command, before) in commands.iter().zip(before) {
        let Some((_, object)) = command.first() else { continue };
        if before.is_empty() {
            changes.push(format!("`{object}` is new"));
        }
        let cells = command.iter().skip(1).zip(before).zip(values(session, command, false));
        changes.extend(cells.map(|(((cell, _), old), new)| format!("{cell} of `{object}` {old} -> {new}")));
    }
    let more = changes.len().saturating_sub(MOST_CHANGES);
    changes.truncate(MOST_CHANGES);
    if more > 0 {
        changes.push(format!("{more} more"));
    }
    changes.join(", ")
}

/// The parameters of a command: names and values, the object first.
fn parameters(command: &str) -> Vec<(String, String)> {
    let mut quoted = false;
    let words = command.split(|c: char| {
        quoted ^= c == '"';
        c == ' ' && !quoted
    });
    words.filter_map(|word| word.split_once('=')).map(|(name, value)| (name.to_string(), value.to_string())).collect()
}

/// The cells that a command sets, as they are now; none of an object that is not there yet.
fn values(session: &Session, command: &[(String, String)], name_expressions: bool) -> Vec<String> {
    let Some((_, object)) = command.first() else { return Vec::new() };
    let cells = command.iter().skip(1).map(|(cell, _)| session.attribute(object, cell));
    let Some(cells) = cells.collect::<Option<Vec<_>>>() else { return Vec::new() };
    cells
        .into_iter()
        .map(|cell| {
            let value = match cell.value {
                AttributeValue::None => "nothing".to_string(),
                AttributeValue::Number(x) => shown(x),
                AttributeValue::Integer(n) => n.to_string(),
                AttributeValue::Flag(flag) => flag.to_string(),
                AttributeValue::Text(text) => text,
                AttributeValue::Numbers(xs) => xs.iter().map(|x| shown(*x)).collect::<Vec<_>>().join(","),
                AttributeValue::Texts(texts) => texts.join(","),
            };
            match cell.expression.filter(|_| name_expressions) {
                Some(expression) => format!("{value}, which was the expression ({expression}),"),
                None => value,
            }
        })
        .collect()
}

/// `models/car.cmd` -> `models/car_fixed.cmd`.
fn beside(model: &Path) -> PathBuf {
    let stem = model.file_stem().filter(|_| model != Path::new("-"));
    let stem = stem.map_or_else(|| "model".into(), |s| s.to_string_lossy().into_owned());
    model.with_file_name(format!("{stem}_fixed.cmd"))
}
