//! Which statements open, part and close blocks.

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
    /// For each `if`, its `elseif` and `else` statements.
    pub arms: Vec<Vec<usize>>,
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
        let count = program.statements.len();
        let mut blocks = Blocks {
            control: Vec::with_capacity(count),
            end: vec![count; count],
            arms: vec![Vec::new(); count],
            unclosed: Vec::new(),
        };
        let mut open: Vec<usize> = Vec::new();
        for i in 0..count {
            let control = control_of(program, i, first_words);
            blocks.control.push(control);
            match control {
                Control::If | Control::While | Control::For => open.push(i),
                Control::ElseIf | Control::Else => {
                    if let Some(&opener) = open.last()
                        && blocks.control[opener] == Control::If
                    {
                        blocks.arms[opener].push(i);
                    }
                }
                Control::End => {
                    if let Some(opener) = open.pop() {
                        blocks.end[opener] = i;
                    }
                }
                Control::Plain | Control::Break | Control::Continue | Control::Return => {}
            }
        }
        blocks.unclosed = open;
        blocks
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
    // A word behind `end` is an error, and the block stays open.
    let bare = keywords.len() == 1 && arguments.is_empty();
    match control {
        Control::End | Control::Else | Control::Break | Control::Continue | Control::Return if !bare => Control::Plain,
        other => other,
    }
}
