//! Which argument of which call a run-time function has come to, for readers that go through its
//! text piece by piece: a text may be half typed, or have objects in it that are no text.

/// Follows a text.
#[derive(Clone, Debug, Default)]
pub struct Calls {
    /// Calls whose parentheses are open, and which argument of them is read; the name is empty for
    /// parentheses alone.
    open: Vec<(String, usize)>,
    /// The last word, which becomes the name of a call if `(` follows.
    word: String,
    /// Whether something stands behind the last word.
    ended: bool,
    quoted: bool,
}

impl Calls {
    /// Goes on by a piece of text.
    pub fn read(&mut self, text: &str) {
        for c in text.chars() {
            self.quoted ^= c == '"';
            match c {
                _ if self.quoted || c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '"') => {
                    if std::mem::take(&mut self.ended) {
                        self.word.clear();
                    }
                    self.word.push(c);
                    continue;
                }
                '(' => {
                    let name = std::mem::take(&mut self.word);
                    self.open.push((name, 0));
                }
                ')' => {
                    self.open.pop();
                    self.word.clear();
                }
                ',' => {
                    if let Some((_, argument)) = self.open.last_mut() {
                        *argument += 1;
                    }
                    self.word.clear();
                }
                _ if c.is_whitespace() => {}
                _ => self.word.clear(),
            }
            self.ended = true;
        }
    }

    /// Goes on by an object that is no text.
    pub fn read_object(&mut self) {
        self.word.clear();
        self.ended = true;
    }

    /// The function whose argument comes next, and its number from 0; none outside of calls.
    pub fn place(&self) -> Option<(&str, usize)> {
        self.open.last().map(|(name, argument)| (name.as_str(), *argument))
    }
}

#[cfg(test)]
mod tests {
    use super::Calls;

    #[test]
    fn the_place_is_the_innermost_open_call() {
        for (text, place) in [
            ("", None),
            ("2*", None),
            ("DX(", Some(("DX", 0))),
            ("DX (.m.\"a, (b\", ", Some(("DX", 1))),
            ("STEP(TIME, 0, 0, 1, DX(2, 1,", Some(("DX", 2))),
            ("STEP(DX(2), 0, ", Some(("STEP", 2))),
            ("3*(", Some(("", 0))),
            ("DX 2 (", Some(("2", 0))),
            (")),", None),
        ] {
            let mut calls = Calls::default();
            calls.read(text);
            assert_eq!(calls.place(), place, "{text}");
        }
    }
}
