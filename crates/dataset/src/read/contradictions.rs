//! Arguments of a statement that exclude each other: what stands first is kept, the rest is named.

use text::Diagnostic;

use super::{entry, statement::Argument, statement::Statement};
use crate::statements::Choice;

/// Takes from a statement what contradicts the rest of it.
pub(super) fn resolve(statement: &mut Statement, choices: &[Choice]) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    for sets in choices {
        let set_of = |argument: &Argument| {
            let set = sets.iter().position(|set| set.contains(&argument.keyword.as_str()));
            set.filter(|_| argument.known)
        };
        let given = |wanted: &dyn Fn(usize, &Argument) -> bool| {
            statement.arguments.iter().find_map(|a| set_of(a).filter(|set| wanted(*set, a)))
        };
        // The word that names an alternative tells more than what goes with it.
        let named = given(&|set, argument| sets[set].first().is_some_and(|word| *word == argument.keyword));
        let Some(kept) = named.or_else(|| given(&|_, _| true)) else { continue };
        let (out, stays): (Vec<_>, Vec<_>) =
            statement.arguments.drain(..).partition(|a| set_of(a).is_some_and(|set| set != kept));
        statement.arguments = stays;
        let (Some(first), Some(counts)) = (out.first(), statement.arguments.iter().find(|a| set_of(a).is_some()))
        else {
            statement.arguments.extend(out);
            continue;
        };
        let mut words: Vec<_> = out.iter().map(|argument| format!("`{}`", argument.keyword)).collect();
        words.dedup();
        let words = words.join(", ");
        let message =
            format!("{} has `{}` and {words}: one excludes the other", entry::name(statement), counts.keyword);
        diagnostics.push(
            Diagnostic::error("dataset/contradiction", message)
                .at(first.keyword_span, "left out")
                .label(counts.keyword_span, "this one counts")
                .help(format!("remove `{}` or {words}", counts.keyword)),
        );
    }
    diagnostics
}
