//! `flexure run`: executes command files; they decide what is simulated.

use std::sync::PoisonError;

use crate::arguments::{OnError, Run};
use crate::commands::{Tally, complain, count, print, read, session, set_beams, set_recording};
use crate::output::Target;
use crate::progress::Watcher;
use crate::{Outcome, interrupt};

pub(super) fn execute(run: &Run) -> Outcome {
    interrupt::install();
    let mut session = session();
    set_beams(&mut session, &run.beams);
    session.abort_on_error(run.strict || run.on_error == OnError::Abort);
    set_recording(&mut session, run.record);
    if let Some(path) = &run.journal
        && let Err(error) = session.keep_journal(path)
    {
        complain(format_args!("cannot write the journal {}: {error}", path.display()));
        return Outcome::Findings;
    }
    let (watcher, log) = Watcher::new(Target::Folder(run.out.clone()));
    session.set_observer(Box::new(watcher));
    let (mut executed, mut found) = (0, Tally::default());
    let mut tally = |report: &flexure::Report| {
        let mut said = Tally::of(&report.diagnostics);
        said.errors = said.errors.max(report.failed);
        executed += report.executed;
        found.add(said);
        run.strict && said.errors + said.warnings > 0
    };
    let mut stopped = false;
    for file in &run.files {
        if stopped || interrupt::requested() {
            break;
        }
        let report = read(&mut session, file);
        print(&session, &report.diagnostics);
        stopped = tally(&report);
    }
    for command in &run.edits.commands {
        if stopped || interrupt::requested() {
            break;
        }
        let report = session.execute(command);
        print(&session, &report.diagnostics);
        stopped = tally(&report);
    }
    let log = log.lock().unwrap_or_else(PoisonError::into_inner);
    log.troubles.iter().for_each(complain);
    for path in &log.written {
        println!("{}", path.display());
    }
    let interrupted = interrupt::requested() || log.interrupted;
    let ending = if interrupted { "; stopped by Ctrl-C" } else { "" };
    eprintln!("{} executed, {found}{ending}", count(executed, "command"));
    if interrupted {
        Outcome::Interrupted
    } else if found.errors > 0 || stopped || !log.troubles.is_empty() {
        Outcome::Findings
    } else {
        Outcome::Fine
    }
}
