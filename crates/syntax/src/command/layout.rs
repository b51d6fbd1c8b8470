//! The lines of one statement.

use text::Span;

use super::pieces::{Gap, Remark};
use super::{Item, Statement, StatementKind};

/// Blanks for each level of indentation.
pub(super) const INDENT: usize = 3;
/// A command that was typed on one line stays there up to this width.
const ONE_LINE: usize = 100;
/// Lists are filled up to this width, which is about that of the longest rows in exports.
const LIST: usize = 120;

/// One line, without its indentation.
#[derive(Debug)]
pub(super) struct Line {
    /// Levels beyond that of the statement.
    pub indent: usize,
    pub text: String,
}

#[derive(Debug, Default)]
pub(super) struct Sheet {
    pub lines: Vec<Line>,
}

/// Lays out a statement that was understood; `gaps` follow its tokens.
pub(super) fn lay_out(text: &str, statement: &Statement, gaps: &[Gap], depth: usize, opener: bool) -> Sheet {
    let mut desk = Desk { text, sheet: Sheet::default(), gaps: gaps.iter(), depth };
    let typed_on_one_line = gaps.split_last().is_none_or(|(_, inner)| inner.iter().all(|gap| !gap.broken));
    if typed_on_one_line && let Some(line) = one_line(text, statement, depth, opener) {
        desk.sheet.lines.push(Line { indent: 0, text: line });
        desk.gaps = gaps[gaps.len().saturating_sub(1)..].iter();
        desk.end();
        return desk.sheet;
    }
    match &statement.kind {
        StatementKind::Command { keywords, arguments } => {
            desk.new_line(0);
            for (i, keyword) in keywords.iter().enumerate() {
                desk.put(if i == 0 || desk.at_line_start() { "" } else { " " }, *keyword);
                if i + 1 < keywords.len() {
                    if desk.gap().comments.is_empty() {
                        desk.gaps.next();
                    } else {
                        desk.remarks(1);
                    }
                }
            }
            for argument in arguments {
                desk.remarks(1);
                desk.named(argument.name, &argument.values, 1);
            }
        }
        StatementKind::Assignment { target, values } => {
            desk.new_line(0);
            desk.named(*target, values, 0);
        }
        StatementKind::Broken => {}
    }
    desk.end();
    desk.sheet
}

/// The whole statement on one line, if it may stand so.
fn one_line(text: &str, statement: &Statement, depth: usize, opener: bool) -> Option<String> {
    let list = |values: &[Item]| values.iter().map(|v| &text[v.span.range()]).collect::<Vec<_>>().join(", ");
    let (line, short) = match &statement.kind {
        StatementKind::Command { keywords, arguments } => {
            let mut line = keywords.iter().map(|k| &text[k.range()]).collect::<Vec<_>>().join(" ");
            for (i, argument) in arguments.iter().enumerate() {
                // One argument follows its command closely, several stand apart from each other.
                line.push_str(if i == 0 && (opener || arguments.len() == 1) { " " } else { "  " });
                line.push_str(&text[argument.name.range()]);
                line.push_str(" = ");
                line.push_str(&list(&argument.values));
            }
            (line, arguments.is_empty() || opener)
        }
        StatementKind::Assignment { target, values } => {
            (format!("{} = {}", &text[target.range()], list(values)), values.len() < 2)
        }
        StatementKind::Broken => return None,
    };
    (!line.contains('\n') && (short || depth * INDENT + width(&line) <= ONE_LINE)).then_some(line)
}

fn width(text: &str) -> usize {
    text.chars().count()
}

/// Where a statement is put together, line by line. The gaps are used up in the order of tokens.
struct Desk<'a> {
    text: &'a str,
    sheet: Sheet,
    gaps: std::slice::Iter<'a, Gap<'a>>,
    depth: usize,
}

impl<'a> Desk<'a> {
    fn new_line(&mut self, indent: usize) {
        self.sheet.lines.push(Line { indent, text: String::new() });
    }

    fn line(&mut self) -> &mut String {
        if self.sheet.lines.is_empty() {
            self.new_line(0);
        }
        let last = self.sheet.lines.len() - 1;
        &mut self.sheet.lines[last].text
    }

    fn at_line_start(&self) -> bool {
        self.sheet.lines.last().is_none_or(|l| l.text.is_empty())
    }

    fn put(&mut self, before: &str, token: Span) {
        let text = self.text;
        let line = self.line();
        line.push_str(before);
        line.push_str(&text[token.range()]);
    }

    /// The gap behind the token put down last.
    fn gap(&self) -> &'a Gap<'a> {
        const NONE: &Gap<'static> = &Gap { comments: Vec::new(), broken: false };
        self.gaps.as_slice().first().unwrap_or(NONE)
    }

    /// Ends the line with a continuation mark and the comments behind it; a new line begins.
    fn remarks(&mut self, indent: usize) {
        let gap = self.gap();
        self.line().push_str("  &");
        self.comments(&gap.comments, 1, " ");
        self.gaps.next();
        self.new_line(indent);
    }

    fn comments(&mut self, comments: &[Remark], indent: usize, before: &str) {
        for (i, comment) in comments.iter().enumerate() {
            if i == 0 && !comment.own_line {
                let line = self.line();
                line.push_str(before);
                line.push_str(comment.text);
            } else {
                self.sheet.lines.push(Line { indent, text: comment.text.to_owned() });
            }
        }
    }

    /// Comments behind the last token.
    fn end(&mut self) {
        let gap = self.gap();
        self.comments(&gap.comments, 0, "  ");
    }

    /// `name = value, value` on as many lines as it takes.
    fn named(&mut self, name: Span, values: &[Item], indent: usize) {
        self.put("", name);
        self.line().push_str(" =");
        let Some((first, others)) = values.split_first() else { return };
        let inner = indent + 1;
        let gap = self.gap();
        if gap.broken || !gap.comments.is_empty() {
            // Exports set a single value apart by one blank more.
            self.line().push_str(if others.is_empty() { " " } else { "" });
            self.remarks(inner);
            self.put("", first.span);
        } else {
            self.gaps.next();
            self.put(" ", first.span);
        }
        for (i, value) in others.iter().enumerate() {
            self.line().push(',');
            let comma = usize::from(i + 1 < others.len());
            let gap = self.gap();
            if gap.broken || !gap.comments.is_empty() || !self.fits(&self.text[value.span.range()], comma) {
                self.remarks(inner);
                self.put("", value.span);
            } else {
                self.gaps.next();
                self.put(" ", value.span);
            }
        }
    }

    /// Whether one more value has room on the present line.
    fn fits(&self, value: &str, comma: usize) -> bool {
        let Some(line) = self.sheet.lines.last() else { return true };
        let indent = (self.depth + line.indent) * INDENT;
        indent + width(&line.text) + 1 + width(value) + comma <= LIST
    }
}
