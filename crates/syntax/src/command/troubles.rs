//! What can be wrong with the text of a command: one function per code, so that all messages can be
//! read side by side.

use text::{Diagnostic, Severity, Span};

use super::cursor::is_control;

pub(super) fn unexpected_character(span: Span, found: &str) -> Diagnostic {
    let code = found.chars().next().map_or(0, u32::from);
    Diagnostic::error("syntax/unexpected-character", format!("a control character (U+{code:04X}) stands in a command"))
        .at(span, "not a printable character")
        .help("is this a command file?")
}

pub(super) fn out_of_range(span: Span, text: &str) -> Diagnostic {
    Diagnostic::error("syntax/number-out-of-range", format!("the number {text} is too large"))
        .at(span, "infinite")
        .note("the largest number is 1.797E+308")
}

pub(super) fn unclosed_parenthesis(span: Span) -> Diagnostic {
    Diagnostic::error("syntax/unclosed-parenthesis", "a parenthesis is not closed on its line")
        .at(span, "opened here")
        .note("an expression stands on one line; `&` does not continue it")
}

pub(super) fn unclosed_quote(span: Span, escaped_quote_behind: bool) -> Diagnostic {
    let diagnostic =
        Diagnostic::error("syntax/unclosed-quote", "a quoted string is not closed on its line").at(span, "opened here");
    if escaped_quote_behind {
        diagnostic.note("the last quote of the line belongs to the text, because a backslash stands before it")
    } else {
        diagnostic
    }
}

/// `above`: the end of a command on the line before, which this one may belong to.
pub(super) fn missing_keyword(word: Span, text: &str, above: Option<Span>) -> Diagnostic {
    let help = "if this belongs to the command above, end the line before with `&`";
    let diagnostic = Diagnostic::error(
        "syntax/missing-keyword",
        format!("`{text}` is given a value, but no command stands before it"),
    )
    .at(word, "a command begins with its keywords");
    let diagnostic = match above {
        Some(end) => diagnostic.fix(help, end, "  &"),
        None => diagnostic.help(help),
    };
    diagnostic
        .adams(format!("'{text}' is not a valid keyword. You may have misspelled"))
        .adams("the keyword or you may be missing a continuation character(&)")
        .adams("on the previous line.")
}

pub(super) fn stray_text(span: Span, text: &str) -> Diagnostic {
    let text = text.lines().next().unwrap_or_default();
    Diagnostic::error("syntax/stray-text", format!("`{text}` stands behind a complete value"))
        .at(span, "neither a further value nor an argument")
        .note("values are separated by commas; an argument is `name = value`; text with blanks needs quotes")
        .adams(format!("'{}' is not a valid parameter.", text.split_ascii_whitespace().next().unwrap_or_default()))
}

pub(super) fn joined(equals: Span) -> Diagnostic {
    Diagnostic::new(Severity::Note, "syntax/continued-without-mark", "the value is taken from the next line")
        .at(equals, "the line ends here without `&`")
        .fix("Adams View needs `&` at the end of this line", Span { start: equals.end, ..equals }, "  &")
}

pub(super) fn missing_value(span: Span, name: &str, behind_comma: bool, at_line_end: bool) -> Diagnostic {
    let message = if behind_comma {
        format!("a value of `{name}` is missing behind a comma")
    } else {
        format!("`{name}` has no value")
    };
    let diagnostic = Diagnostic::error("syntax/missing-value", message).at(span, "a value must follow");
    if at_line_end { diagnostic.help("a value on the next line needs `&` at the end of this one") } else { diagnostic }
}

pub(super) fn misplaced(span: Span, found: &str) -> Diagnostic {
    if found.bytes().next().is_some_and(is_control) {
        unexpected_character(span, found)
    } else if found == "&" {
        Diagnostic::error("syntax/misplaced-continuation", "`&` stands in the middle of a line")
            .at(span, "only a comment may follow it")
    } else {
        Diagnostic::error("syntax/unexpected-token", format!("`{found}` stands where a word is needed"))
            .at(span, "a keyword or `name = value` is needed here")
    }
}

pub(super) fn expression_without_parentheses(span: Span, text: &str) -> Diagnostic {
    Diagnostic::error(
        "syntax/expression-without-parentheses",
        format!("`{text}` is an expression without parentheses around it"),
    )
    .at(span, "read as plain text")
    .fix(format!("write `({text})`"), span, format!("({text})"))
}
