//! Lines of a dataset: banners, centred comments, arguments, wrapping.

/// Longest line written.
const WIDTH: usize = 80;
/// What a line that continues a statement begins with.
const LEAD: &str = ", ";

/// `!----------------------------------- PARTS -------------------------------------`
pub(crate) fn banner(title: &str) -> String {
    let left = 38usize.saturating_sub(title.len().div_ceil(2));
    let right = WIDTH.saturating_sub(1 + left + title.len() + 2);
    format!("!{} {title} {}", "-".repeat(left), "-".repeat(right))
}

/// A comment centred as View centres names.
pub(crate) fn centred(text: &str) -> String {
    let left = WIDTH.saturating_sub(text.chars().count()) / 2;
    format!("!{}{text}", " ".repeat(left))
}

/// A statement under construction.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    lines: Vec<String>,
}

impl Lines {
    /// Begins with `NAME/id`, or `NAME/` without one.
    pub fn new(statement: &str, id: Option<i64>) -> Lines {
        let id = id.map(|i| i.to_string()).unwrap_or_default();
        Lines { lines: vec![format!("{statement}/{id}")] }
    }

    /// Adds the arguments of another one.
    pub fn append(&mut self, other: Lines) {
        self.lines.extend(other.lines);
    }

    pub fn flag(&mut self, word: &str) {
        self.lines.push(format!("{LEAD}{word}"));
    }

    pub fn argument(&mut self, keyword: &str, value: &str) {
        self.lines.push(format!("{LEAD}{keyword} = {value}"));
    }

    /// `, QP = 0, 6, 0`, wrapped between items.
    pub fn list(&mut self, keyword: &str, items: &[String]) {
        let mut line = format!("{LEAD}{keyword} = ");
        for (index, item) in items.iter().enumerate() {
            let comma = if index == 0 { "" } else { LEAD };
            if index > 0 && line.chars().count() + comma.len() + item.chars().count() > WIDTH {
                self.lines.push(std::mem::replace(&mut line, format!("{LEAD}{item}")));
            } else {
                line.push_str(comma);
                line.push_str(item);
            }
        }
        self.lines.push(line);
    }

    /// A run-time function, wrapped between its tokens.
    pub fn function(&mut self, keyword: &str, text: &str) {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        self.wrapped(&format!("{LEAD}{keyword} ="), &text);
    }

    fn wrapped(&mut self, head: &str, text: &str) {
        let mut rest = text;
        let mut start = format!("{head} ");
        let mut first = true;
        loop {
            let room = WIDTH.saturating_sub(start.chars().count());
            if rest.chars().nth(room).is_none() {
                self.lines.push(format!("{start}{rest}"));
                return;
            }
            let Some(cut) = cut(rest, room, !first) else {
                if !first {
                    self.lines.push(format!("{start}{rest}"));
                    return;
                }
                // Nothing fits behind the keyword: the expression begins on the next line.
                self.lines.push(head.to_string());
                (start, first) = (LEAD.to_string(), false);
                continue;
            };
            // The blank behind the comma is part of the expression: it is there only if it was.
            let parted = rest[..cut].ends_with(' ');
            self.lines.push(format!("{start}{}", rest[..cut].trim_end()));
            rest = rest[cut..].trim_start();
            (start, first) = (if parted { LEAD } else { "," }.to_string(), false);
        }
    }

    /// Ends the last argument so that another one may follow a function.
    pub fn end_function(&mut self) {
        if let Some(last) = self.lines.last_mut() {
            last.push('\\');
        }
    }

    pub fn finish(self) -> Vec<String> {
        self.lines
    }
}

/// The last place within so many characters at which an expression may go on in the next line; if
/// there is none, and `beyond` says so, the first one behind them.
fn cut(text: &str, room: usize, beyond: bool) -> Option<usize> {
    let mut last = None;
    let mut width = 1;
    for at in 1..text.len() {
        if !text.is_char_boundary(at) {
            continue;
        }
        if may_go_on(text.as_bytes(), at) {
            if text[..at].trim_end().chars().count() <= room {
                last = Some(at);
            } else {
                return last.or(Some(at).filter(|_| beyond));
            }
        }
        width += 1;
        // A blank at the edge is not written.
        if width > room + 2 && (last.is_some() || !beyond) {
            return last;
        }
    }
    last
}

/// Whether an expression may go on in the next line from a position: behind commas and colons, and
/// before operators. Never inside a number (`1E-3`) or `**`; never before a comma.
fn may_go_on(bytes: &[u8], at: usize) -> bool {
    let (before, here) = (bytes[at - 1], bytes[at]);
    match here {
        b'+' | b'-' => operand_ends(bytes, at) && !in_exponent(bytes, at),
        b'*' => before != b'*' && operand_ends(bytes, at),
        b'/' => operand_ends(bytes, at),
        b',' | b' ' => false,
        _ => {
            before == b','
                || before == b':'
                || (before == b' ' && matches!(bytes.get(at.wrapping_sub(2)), Some(b',' | b':')))
        }
    }
}

/// Whether what stands before an operator (blanks apart) is an operand.
fn operand_ends(bytes: &[u8], at: usize) -> bool {
    let before = bytes[..at].iter().rev().find(|b| **b != b' ');
    before.is_some_and(|b| b.is_ascii_alphanumeric() || matches!(b, b')' | b'.' | b'_'))
}

/// Whether the sign at a position belongs to an exponent: `1.5E-3`.
fn in_exponent(bytes: &[u8], at: usize) -> bool {
    let Some(b'e' | b'E' | b'd' | b'D') = bytes[..at].last() else { return false };
    let mantissa = bytes[..at - 1].iter().rev().take_while(|b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'_'));
    let mantissa: Vec<_> = mantissa.collect();
    !mantissa.is_empty() && mantissa.iter().all(|b| b.is_ascii_digit() || **b == b'.')
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: lines of public exports.
    #[test]
    fn banners_and_names_are_centred_as_in_exports() {
        assert_eq!(banner("PARTS"), "!----------------------------------- PARTS -------------------------------------");
        assert_eq!(
            banner("SYSTEM UNITS"),
            "!-------------------------------- SYSTEM UNITS ---------------------------------"
        );
        assert_eq!(
            banner("GRAVITATIONAL ACCELERATION"),
            "!------------------------- GRAVITATIONAL ACCELERATION --------------------------"
        );
        assert_eq!(centred("adams_view_name='MARKER_10'"), "!                          adams_view_name='MARKER_10'");
        assert_eq!(centred("adams_view_name='cm'"), "!                              adams_view_name='cm'");
    }

    #[test]
    fn functions_break_between_tokens_only() {
        let text = (0..12).map(|i| format!("STEP(TIME, {i}.5E-3, 0, 1.0, {i}D)**2")).collect::<Vec<_>>().join(" + ");
        let mut lines = Lines::new("MOTION", Some(1));
        lines.function("FUNCTION", &text);
        let lines = lines.finish();
        assert!(lines.len() > 5);
        assert!(lines.iter().all(|l| l.len() <= 80));
        assert!(lines.iter().all(|l| !l.ends_with("E-") && !l.ends_with('E') && !l.ends_with('*')));
        // What a reader joins is the same expression.
        let joined: String = lines[1..].iter().map(|l| l.trim_start_matches(',')).collect();
        assert_eq!(joined, format!(" FUNCTION = {text}"));
    }

    #[test]
    fn a_text_without_a_place_to_break_stays_whole() {
        let name = "x".repeat(100);
        let mut lines = Lines::new("VARIABLE", Some(1));
        lines.function("FUNCTION", &name);
        assert_eq!(lines.finish()[1..], [", FUNCTION =".to_string(), format!(", {name}")]);
    }

    #[test]
    fn lists_wrap_with_the_comma_in_front() {
        let mut lines = Lines::new("REQUEST", Some(1));
        lines.list("CLABELS", &vec!["\"(sec)\"".to_string(); 9]);
        assert_eq!(
            lines.finish()[1..],
            [
                ", CLABELS = \"(sec)\", \"(sec)\", \"(sec)\", \"(sec)\", \"(sec)\", \"(sec)\", \"(sec)\"",
                ", \"(sec)\", \"(sec)\""
            ]
        );
    }
}
