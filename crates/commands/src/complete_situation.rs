//! Where in half-typed text the cursor stands: which keywords and parameters are there already, and
//! what of the next word. The text may be wrong or unfinished everywhere, so this reads less than the
//! grammar does and never fails.

/// The command the cursor is in.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Place {
    pub keywords: Vec<String>,
    /// Names of the parameters that have a value, as typed.
    pub given: Vec<String>,
    /// Where the half-typed word begins: everything from there on is replaced.
    pub start: usize,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Situation {
    /// In a comment, or behind something that must be followed by a blank.
    Nowhere,
    /// A keyword, or the name of a parameter.
    Word(Place),
    /// A value of a parameter; `quoted` inside a text.
    Value { place: Place, parameter: String, quoted: bool },
    /// Inside parentheses.
    Expression(Place),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Word,
    Equals,
    Comma,
    /// A closed text or parenthesis.
    Closed,
}

#[derive(Clone, Copy, Debug)]
struct Token {
    kind: Kind,
    start: usize,
    end: usize,
}

/// What is open at the end of the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Open {
    Nothing,
    Comment,
    /// A text that begins behind this place.
    Text(usize),
    /// A parenthesis; inside a text of its own or not.
    Parenthesis {
        text: bool,
    },
}

/// The last statement of a text.
#[derive(Debug)]
struct Scan {
    tokens: Vec<Token>,
    open: Open,
    /// Whether the command goes on, on the next line.
    continued: bool,
}

/// Reads a text up to its end.
fn scan(text: &str) -> Scan {
    let bytes = text.as_bytes();
    let mut scan = Scan { tokens: Vec::new(), open: Open::Nothing, continued: false };
    // Of the present line: whether it has words, a comment, and whether its last mark is `&`.
    let (mut content, mut comment, mut mark) = (false, false, false);
    let mut at = 0;
    while let Some(&byte) = bytes.get(at) {
        scan.open = Open::Nothing;
        match byte {
            b'\n' => {
                let goes_on = mark || !content && comment && scan.continued;
                if !goes_on {
                    scan.tokens.clear();
                }
                scan.continued = goes_on;
                (content, comment, mark) = (false, false, false);
                at += 1;
            }
            b' ' | b'\t' | b'\r' => at += 1,
            b'!' => {
                at = line_end(bytes, at);
                scan.open = Open::Comment;
                comment = true;
            }
            b'&' => {
                mark = true;
                at += 1;
            }
            _ => {
                (content, mark) = (true, false);
                let (kind, end, open) = token(bytes, at);
                if open == Open::Nothing {
                    scan.tokens.push(Token { kind, start: at, end });
                }
                scan.open = open;
                at = end;
            }
        }
    }
    scan.continued = mark || !content && scan.continued;
    scan
}

fn line_end(bytes: &[u8], from: usize) -> usize {
    bytes[from..].iter().position(|b| *b == b'\n').map_or(bytes.len(), |n| from + n)
}

/// The token at a place: its kind, where it ends, and whether it is still open at the end of the text.
fn token(bytes: &[u8], at: usize) -> (Kind, usize, Open) {
    match bytes[at] {
        b'=' => (Kind::Equals, at + 1, Open::Nothing),
        b',' => (Kind::Comma, at + 1, Open::Nothing),
        b'"' => match text_end(bytes, at) {
            Some(end) => (Kind::Closed, end, Open::Nothing),
            None if line_end(bytes, at) == bytes.len() => (Kind::Closed, bytes.len(), Open::Text(at + 1)),
            // A text ends with its line at the latest.
            None => (Kind::Closed, line_end(bytes, at), Open::Nothing),
        },
        b'(' => parenthesis(bytes, at),
        _ => {
            let mut end = at;
            while let Some(&b) = bytes.get(end) {
                match b {
                    // A quoted step of a name: `.m."odd one".x`.
                    b'"' => match text_end(bytes, end) {
                        Some(after) => end = after,
                        None => return (Kind::Word, line_end(bytes, end), Open::Nothing),
                    },
                    b' ' | b'\t' | b'\r' | b'\n' | b'=' | b',' | b'(' | b'!' | b'&' => break,
                    _ => end += 1,
                }
            }
            // A lone closing parenthesis or the like is a word of its own.
            (Kind::Word, end.max(at + 1), Open::Nothing)
        }
    }
}

/// Behind the quote that closes a text in the same line.
fn text_end(bytes: &[u8], at: usize) -> Option<usize> {
    let quote = *bytes.get(at)?;
    let mut next = at + 1;
    while let Some(&b) = bytes.get(next) {
        match b {
            b'\\' => next += 2,
            b'\n' => return None,
            b if b == quote => return Some(next + 1),
            _ => next += 1,
        }
    }
    None
}

fn parenthesis(bytes: &[u8], at: usize) -> (Kind, usize, Open) {
    let mut depth = 0usize;
    let mut next = at;
    while let Some(&b) = bytes.get(next) {
        match b {
            b'(' => depth += 1,
            b')' => {
                depth -= 1;
                if depth == 0 {
                    return (Kind::Closed, next + 1, Open::Nothing);
                }
            }
            b'"' | b'\'' => match text_end(bytes, next) {
                Some(end) => {
                    next = end;
                    continue;
                }
                None if line_end(bytes, next) == bytes.len() => {
                    return (Kind::Closed, bytes.len(), Open::Parenthesis { text: true });
                }
                None => {}
            },
            b'\n' => return (Kind::Closed, next, Open::Nothing),
            _ => {}
        }
        next += 1;
    }
    (Kind::Closed, bytes.len(), Open::Parenthesis { text: false })
}

/// Whether the command at the end of a text goes on in the next line.
pub(crate) fn is_continued(text: &str) -> bool {
    scan(text).continued
}

/// Where the end of a text stands.
pub(crate) fn situation(text: &str) -> Situation {
    let Scan { mut tokens, open, .. } = scan(text);
    let mut start = text.len();
    match open {
        Open::Comment | Open::Parenthesis { text: true } => return Situation::Nowhere,
        Open::Text(from) => start = from,
        Open::Parenthesis { text: false } => start = name_start(text),
        Open::Nothing => {
            if let Some(last) = tokens.last().copied().filter(|t| t.end == text.len()) {
                match last.kind {
                    Kind::Word => {
                        start = last.start;
                        tokens.pop();
                    }
                    Kind::Closed => return Situation::Nowhere,
                    Kind::Equals | Kind::Comma => {}
                }
            }
        }
    }
    let mut place = Place { start, ..Place::default() };
    let parameter = arrange(text, &tokens, &mut place);
    match (open, parameter) {
        (Open::Parenthesis { .. }, _) => Situation::Expression(place),
        (Open::Text(_), Some(parameter)) => Situation::Value { place, parameter, quoted: true },
        (Open::Text(_), None) => Situation::Nowhere,
        (_, Some(parameter)) => Situation::Value { place, parameter, quoted: false },
        (_, None) => Situation::Word(place),
    }
}

/// Parameters that have a whole value at the end of a text, with the first word of that value.
pub(crate) fn given_values(text: &str) -> Vec<(String, String)> {
    let tokens = scan(text).tokens;
    let word = |token: &Token| text.get(token.start..token.end).unwrap_or("").to_string();
    let pair = |t: &[Token]| {
        let [name, equals, value] = t else { return None };
        let whole = value.end < text.len() && matches!(value.kind, Kind::Word | Kind::Closed);
        (name.kind == Kind::Word && equals.kind == Kind::Equals && whole).then(|| (word(name), word(value)))
    };
    tokens.windows(3).filter_map(pair).collect()
}

/// Sorts tokens into keywords and parameters; returns the parameter that a value is wanted for.
fn arrange(text: &str, tokens: &[Token], place: &mut Place) -> Option<String> {
    let mut name: Option<String> = None;
    let mut wanted: Option<String> = None;
    let mut in_values = false;
    for token in tokens {
        match token.kind {
            Kind::Equals => {
                let parameter = if in_values { name.take() } else { place.keywords.pop() };
                in_values = true;
                wanted = Some(parameter.unwrap_or_default());
            }
            Kind::Comma => wanted = place.given.last().cloned().or(wanted),
            Kind::Word | Kind::Closed => {
                if let Some(parameter) = wanted.take() {
                    if place.given.last() != Some(&parameter) {
                        place.given.push(parameter);
                    }
                } else if token.kind == Kind::Word {
                    let word = text.get(token.start..token.end).unwrap_or("").to_string();
                    if in_values { name = Some(word) } else { place.keywords.push(word) }
                }
            }
        }
    }
    wanted
}

/// Where the name at the end of an expression begins.
fn name_start(text: &str) -> usize {
    let is_name = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    text.char_indices().rev().take_while(|(_, c)| is_name(*c)).last().map_or(text.len(), |(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn word(keywords: &[&str], given: &[&str], start: usize) -> Situation {
        Situation::Word(place(keywords, given, start))
    }

    fn place(keywords: &[&str], given: &[&str], start: usize) -> Place {
        let list = |l: &[&str]| l.iter().map(ToString::to_string).collect();
        Place { keywords: list(keywords), given: list(given), start }
    }

    fn value(place: Place, parameter: &str, quoted: bool) -> Situation {
        Situation::Value { place, parameter: parameter.into(), quoted }
    }

    #[test]
    fn words_come_before_and_behind_values() {
        assert_eq!(situation(""), word(&[], &[], 0));
        assert_eq!(situation("mar"), word(&[], &[], 0));
        assert_eq!(situation("marker "), word(&["marker"], &[], 7));
        assert_eq!(situation("a b x = 1 yz"), word(&["a", "b"], &["x"], 10));
        assert_eq!(situation("a x = 1, 2 "), word(&["a"], &["x"], 11));
        assert_eq!(situation("a x=(1+2) y = \"t\" "), word(&["a"], &["x", "y"], 18));
        assert_eq!(situation("first x = 1\nsec"), word(&[], &[], 12));
    }

    #[test]
    fn values_follow_equals_signs_and_commas() {
        assert_eq!(situation("a x ="), value(place(&["a"], &[], 5), "x", false));
        assert_eq!(situation("a x = .m.\"odd one\".p"), value(place(&["a"], &[], 6), "x", false));
        assert_eq!(situation("a x = 1,"), value(place(&["a"], &["x"], 8), "x", false));
        assert_eq!(situation("a x = 1 y = 2, 3"), value(place(&["a"], &["x", "y"], 15), "y", false));
        assert_eq!(situation("a x = \"some te"), value(place(&["a"], &[], 7), "x", true));
    }

    #[test]
    fn a_command_goes_on_behind_its_mark_and_past_comments() {
        let text = "a b & ! first\n  x = 1 &\n ! aside\n  ";
        assert_eq!(situation(text), word(&["a", "b"], &["x"], text.len()));
        assert!(
            is_continued("a &") && is_continued("a & ! c\n") && is_continued("a &\n! c\n") && is_continued("a &\n&\n")
        );
        assert!(
            !is_continued("a &\n\n") && !is_continued("a \"&\"") && !is_continued("! a &\n") && !is_continued("a & b")
        );
        assert_eq!(situation("a &\n\nc"), word(&[], &[], 5));
    }

    #[test]
    fn parentheses_hold_expressions_and_comments_nothing() {
        assert_eq!(situation("a x = (DM(.m.a, .m."), Situation::Expression(place(&["a"], &[], 16)));
        assert_eq!(situation("if condition = (! db"), Situation::Expression(place(&["if"], &[], 18)));
        for nowhere in ["a ! b", "a x = (\"te", "a x = \"text\"", "a x = (1)"] {
            assert_eq!(situation(nowhere), Situation::Nowhere, "{nowhere}");
        }
    }

    #[test]
    fn any_end_of_any_text_is_some_situation() {
        let text = "a x=(1,'b\",\"c)\n&,=\" ! \\ \"(.m.\"o o\".\u{e4}=,)\n,=&";
        for (at, _) in text.char_indices() {
            situation(&text[..at]);
            situation(&text[at..]);
        }
    }
}
