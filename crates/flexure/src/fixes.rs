//! Applying the fixes that diagnostics carry to the text of a file.

use text::{Diagnostic, FileId, Sources, one_line};

/// What came of the fixes for one file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fixed {
    pub text: String,
    /// One line for each fix that was applied.
    pub applied: Vec<String>,
    /// One line for each fix that contradicts another one and was left out.
    pub left: Vec<String>,
}

/// Applies what diagnostics say about a file. Where two fixes want different things of the same
/// place, neither is applied.
pub fn apply_fixes(sources: &Sources, file: FileId, diagnostics: &[Diagnostic]) -> Fixed {
    let before = sources.text(file);
    let mut fixes: Vec<(std::ops::Range<usize>, &str, String)> = Vec::new();
    for diagnostic in diagnostics {
        // Only one way to mend a trouble is certain.
        let mut of_it = diagnostic.helps.iter().filter_map(|help| help.fix.as_ref().map(|fix| (fix, &help.text)));
        let (Some((fix, _)), None) = (of_it.next(), of_it.next()) else { continue };
        let range = fix.span.range();
        if fix.span.file != file || before.get(range.clone()).is_none() {
            continue;
        }
        let said = format!(
            "{}: `{}` becomes `{}`",
            one_line(sources, diagnostic),
            before.get(range.clone()).unwrap_or_default(),
            fix.replacement
        );
        // The same command may have been executed several times.
        if !fixes.iter().any(|(r, text, _)| *r == range && *text == fix.replacement) {
            fixes.push((range, &fix.replacement, said));
        }
    }
    fixes.sort_by(|p, q| (p.0.start, p.0.end, p.1).cmp(&(q.0.start, q.0.end, q.1)));
    let touches = |p: &std::ops::Range<usize>, q: &std::ops::Range<usize>| {
        p.start < q.end && q.start < p.end || p.start == q.start
    };
    let mut fixed = Fixed::default();
    let mut at = 0;
    for (i, (range, replacement, said)) in fixes.iter().enumerate() {
        let contested = fixes.iter().enumerate().any(|(j, (other, ..))| i != j && touches(range, other));
        if contested {
            fixed.left.push(said.clone());
            continue;
        }
        fixed.text.push_str(before.get(at..range.start).unwrap_or_default());
        fixed.text.push_str(replacement);
        at = range.end;
        fixed.applied.push(said.clone());
    }
    fixed.text.push_str(before.get(at..).unwrap_or_default());
    fixed
}

#[cfg(test)]
mod tests {
    use super::*;
    use text::Span;

    fn diagnostic(file: FileId, from: usize, to: usize, replacement: &str) -> Diagnostic {
        let span = Span::new(file, from, to);
        Diagnostic::error("x/y", "wrong").at(span, "").fix("did you mean?", span, replacement)
    }

    #[test]
    fn fixes_are_applied_once_each_and_in_any_order() {
        let mut sources = Sources::default();
        let file = sources.add("a.cmd", "marker creat nme = 1");
        let all =
            [diagnostic(file, 13, 16, "name"), diagnostic(file, 7, 12, "create"), diagnostic(file, 7, 12, "create")];
        let fixed = apply_fixes(&sources, file, &all);
        assert_eq!(fixed.text, "marker create name = 1");
        assert_eq!((fixed.applied.len(), fixed.left.len()), (2, 0));
    }

    #[test]
    fn fixes_that_contradict_each_other_are_left_out() {
        let mut sources = Sources::default();
        let file = sources.add("a.cmd", "abc def");
        let all = [diagnostic(file, 0, 3, "x"), diagnostic(file, 2, 3, "y"), diagnostic(file, 4, 7, "z")];
        let fixed = apply_fixes(&sources, file, &all);
        assert_eq!(fixed.text, "abc z");
        assert_eq!((fixed.applied.len(), fixed.left.len()), (1, 2));
        let other = sources.add("b.cmd", "abc def");
        assert_eq!(apply_fixes(&sources, other, &all).text, "abc def");
    }
}
