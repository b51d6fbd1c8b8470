//! Which statements open, part and close blocks.

use syntax::command::Parser;

use crate::{
    program::Program,
    words::{Match, match_word},
};

/// What a statement does to the flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    Plain,
    If,
    ElseIf,
    Else,
    End,
    While,
    For,
    Break,
    Continue,
    Return,
}

/// The blocks of a program.
#[derive(Debug, Default)]
pub struct Blocks {
    pub control: Vec<Control>,
    /// For each opener, the statement that ends its block; the number of statements if none does.
    pub end: Vec<usize>,
    /// The `elseif` and `else` statements, each with the `if` it belongs to.
    arms: Vec<(usize, usize)>,
    /// Openers without end.
    pub unclosed: Vec<usize>,
}

const WORDS: [(&str, Control); 9] = [
    ("if", Control::If),
    ("elseif", Control::ElseIf),
    ("else", Control::Else),
    ("end", Control::End),
    ("while", Control::While),
    ("for", Control::For),
    ("break", Control::Break),
    ("continue", Control::Continue),
    ("return", Control::Return),
];

impl Blocks {
    /// Finds the blocks; `first_words` are all words a command may begin with.
    pub fn of(program: &Program, first_words: &[&str]) -> Blocks {
        let mut blocks = Blocks::default();
        for i in 0..program.statements.len() {
            blocks.add(control_of(program, i, first_words));
        }
        blocks.finish();
        blocks
    }

    /// Reads statements up to the end of the block that the first of them opens, or that one alone.
    /// False at the end of the text.
    pub fn read_unit(&mut self, program: &mut Program, parser: &mut Parser, first_words: &[&str]) -> bool {
        self.control.clear();
        self.end.clear();
        self.arms.clear();
        self.unclosed.clear();
        program.statements.clear();
        while program.read(parser) {
            self.add(control_of(program, program.statements.len() - 1, first_words));
            if self.unclosed.is_empty() {
                break;
            }
        }
        self.finish();
        !program.statements.is_empty()
    }

    fn add(&mut self, control: Control) {
        let i = self.control.len();
        self.control.push(control);
        self.end.push(usize::MAX);
        match control {
            Control::If | Control::While | Control::For => self.unclosed.push(i),
            Control::ElseIf | Control::Else => {
                if let Some(&opener) = self.unclosed.last()
                    && self.control[opener] == Control::If
                {
                    self.arms.push((opener, i));
                }
            }
            Control::End => {
                if let Some(opener) = self.unclosed.pop() {
                    self.end[opener] = i;
                }
            }
            // Left to the command of that name, which says what is wrong.
            Control::Break | Control::Continue if !self.in_loop() => self.control[i] = Control::Plain,
            Control::Plain | Control::Break | Control::Continue | Control::Return => {}
        }
    }

    /// Whether a loop is open. Those of other files and macros do not count.
    fn in_loop(&self) -> bool {
        self.unclosed.iter().any(|opener| matches!(self.control[*opener], Control::While | Control::For))
    }

    /// Blocks that nothing ends go on to the last statement.
    fn finish(&mut self) {
        let count = self.control.len();
        self.end.iter_mut().for_each(|end| *end = (*end).min(count));
    }

    /// The `elseif` and `else` statements of an `if`.
    pub fn arms(&self, opener: usize) -> impl Iterator<Item = usize> + '_ {
        self.arms.iter().filter(move |(of, _)| *of == opener).map(|(_, arm)| *arm)
    }
}

fn control_of(program: &Program, index: usize, first_words: &[&str]) -> Control {
    let Some((keywords, arguments)) = program.command(index) else { return Control::Plain };
    let Some(first) = keywords.first() else { return Control::Plain };
    let word = program.word(*first);
    if !word.starts_with(['i', 'I', 'e', 'E', 'w', 'W', 'f', 'F', 'b', 'B', 'c', 'C', 'r', 'R']) {
        return Control::Plain;
    }
    let control = match match_word(first_words.iter().copied(), word) {
        Match::One(i) => WORDS.iter().find(|(w, _)| *w == first_words[i]).map_or(Control::Plain, |(_, c)| *c),
        _ => Control::Plain,
    };
    // A word behind `end` is an error, and the block stays open; one behind `for` is an error that opens
    // no block, so that the rest of the file is not taken for its body.
    let bare = keywords.len() == 1 && arguments.is_empty();
    match control {
        Control::For if keywords.len() > 1 => Control::Plain,
        Control::End | Control::Else | Control::Break | Control::Continue | Control::Return if !bare => Control::Plain,
        other => other,
    }
}
