//! Matching of abbreviated words and guesses at misspelled ones.

use text::{Diagnostic, Span};

/// How many objects refer to something.
pub fn referring(count: usize) -> String {
    if count == 1 { "1 object refers to it".into() } else { format!("{count} objects refer to it") }
}

/// What an abbreviation may stand for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Match {
    /// Index of the only candidate, or of the one that is spelled out.
    One(usize),
    /// Several candidates begin like this.
    Many(Vec<usize>),
    None,
}

/// Finds the candidate a word stands for: an exact match wins, otherwise a unique prefix.
pub fn match_word<'a>(candidates: impl IntoIterator<Item = &'a str, IntoIter: Clone>, word: &str) -> Match {
    let candidates = candidates.into_iter();
    // Words are mostly spelled out, as exports write them.
    if let Some(i) = candidates.clone().position(|candidate| candidate == word) {
        return Match::One(i);
    }
    let mut found = Vec::new();
    for (i, candidate) in candidates.enumerate() {
        if candidate.len() >= word.len() && candidate.as_bytes()[..word.len()].eq_ignore_ascii_case(word.as_bytes()) {
            if candidate.len() == word.len() {
                return Match::One(i);
            }
            found.push(i);
        }
    }
    match found.as_slice() {
        [] => Match::None,
        [one] => Match::One(*one),
        _ => Match::Many(found),
    }
}

/// The candidate nearest to a misspelled word, if one is near enough to be meant.
pub fn nearest<'a>(candidates: impl IntoIterator<Item = &'a str>, word: &str) -> Option<&'a str> {
    let word = word.to_ascii_lowercase();
    let allowed = (word.chars().count() / 3).max(1);
    candidates
        .into_iter()
        .map(|c| (distance(&c.to_ascii_lowercase(), &word, allowed), c))
        .filter(|(d, _)| *d <= allowed)
        .min_by_key(|(d, _)| *d)
        .map(|(_, c)| c)
}

/// Says which candidate a misspelled word was probably meant to be: as a fix where it is certain,
/// which means that no other candidate is as near. `write` makes the replacement. Where nothing is
/// near, `Err` gives the diagnostic back.
pub fn did_you_mean<'a>(
    error: Diagnostic,
    candidates: impl IntoIterator<Item = &'a str>,
    word: &str,
    span: Span,
    write: impl Fn(&str) -> String,
) -> Result<Diagnostic, Diagnostic> {
    let lower = word.to_ascii_lowercase();
    let allowed = (lower.chars().count() / 3).max(1);
    let mut best: Option<(usize, &str, bool)> = None;
    for candidate in candidates {
        let far = distance(&candidate.to_ascii_lowercase(), &lower, allowed);
        match best {
            _ if far > allowed => {}
            Some((least, known, _)) if far == least && !known.eq_ignore_ascii_case(candidate) => {
                best = Some((least, known, false));
            }
            Some((least, ..)) if far >= least => {}
            _ => best = Some((far, candidate, true)),
        }
    }
    let Some((_, guess, only)) = best else { return Err(error) };
    let replacement = write(guess);
    let help = format!("did you mean `{replacement}`?");
    Ok(if only { error.fix(help, span, replacement) } else { error.help(help) })
}

/// Edit distance with swaps of neighbours, cut off above `limit`.
fn distance(a: &str, b: &str, limit: usize) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    if a.len().abs_diff(b.len()) > limit || a.len() > 64 || b.len() > 64 {
        return limit + 1;
    }
    let mut rows = vec![vec![0usize; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    rows[0] = (0..=b.len()).collect();
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let change = usize::from(a[i - 1] != b[j - 1]);
            let mut best = (rows[i - 1][j] + 1).min(rows[i][j - 1] + 1).min(rows[i - 1][j - 1] + change);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

/// Whether a name is a pattern.
pub fn is_pattern(name: &str) -> bool {
    let mut quoted = false;
    name.chars().any(|c| {
        quoted ^= c == '"';
        !quoted && matches!(c, '*' | '?' | '[' | '{')
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_words_win_over_longer_ones() {
        assert_eq!(match_word(["length_of", "length"], "length"), Match::One(1));
        assert_eq!(match_word(["length", "location"], "l"), Match::Many(vec![0, 1]));
        assert_eq!(match_word(["length", "location"], "LE"), Match::One(0));
        assert_eq!(match_word(["length"], "lengths"), Match::None);
    }

    #[test]
    fn misspelled_words_are_guessed_when_near() {
        assert_eq!(nearest(["youngs_modulus", "length"], "young_modulus"), Some("youngs_modulus"));
        assert_eq!(nearest(["youngs_modulus", "length"], "banana"), None);
    }

    #[test]
    fn a_guess_is_a_fix_where_no_other_is_as_near() {
        let span = Span::new(text::FileId(0), 0, 3);
        let guess = |word| {
            let error = Diagnostic::error("x/y", "wrong");
            let guessed = did_you_mean(error, ["ixx", "iyy", "ixz", "length"], word, span, str::to_string);
            guessed.ok().map(|d| (d.helps[0].text.clone(), d.helps[0].fix.clone().map(|f| f.replacement)))
        };
        assert_eq!(guess("lenght"), Some(("did you mean `length`?".into(), Some("length".into()))));
        assert_eq!(guess("ixy"), Some(("did you mean `ixx`?".into(), None)));
        assert_eq!(guess("mass"), None);
    }
}
