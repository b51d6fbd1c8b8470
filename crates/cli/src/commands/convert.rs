//! `flexure convert`: a model in another format.

use crate::Outcome;
use crate::arguments::Convert;
use crate::commands::{open, print, session};

pub(super) fn execute(convert: &Convert) -> Outcome {
    let mut session = session();
    session.simulate_nothing(true);
    let sound = open(&mut session, &convert.input, &convert.edits);
    if session.model().is_none() {
        return Outcome::Findings;
    }
    match session.write(&convert.output) {
        Ok(warnings) => {
            print(&session, &warnings);
            println!("{}", convert.output.display());
            if sound { Outcome::Fine } else { Outcome::Findings }
        }
        Err(diagnostics) => {
            print(&session, &diagnostics);
            Outcome::Findings
        }
    }
}
