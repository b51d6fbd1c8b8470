//! Patterns of names: in commands that take several objects, and in the functions of strings.

/// Wildcards: `*` any text, `?` one character, `[abc]` one of these (also `a-z`), `{one,two}` one of
/// these words. Letters match ignoring case, as names do. The time is bounded by the product of
/// the lengths for each way through the braces.
pub fn glob(pattern: &str, text: &str) -> bool {
    let text: Vec<char> = text.to_lowercase().chars().collect();
    alternatives(&pattern.to_lowercase()).iter().any(|p| fits(&p.chars().collect::<Vec<_>>(), &text))
}

/// Patterns without braces; at most 256.
fn alternatives(pattern: &str) -> Vec<String> {
    let mut open = vec![pattern.to_string()];
    let mut plain = Vec::new();
    while let Some(next) = open.pop() {
        let braces = next.find('{').and_then(|a| next[a..].find('}').map(|b| (a, a + b)));
        match braces {
            Some((a, b)) if open.len() + plain.len() < 256 => {
                open.extend(next[a + 1..b].split(',').map(|word| format!("{}{word}{}", &next[..a], &next[b + 1..])));
            }
            _ => plain.push(next),
        }
    }
    plain
}

fn fits(pattern: &[char], text: &[char]) -> bool {
    let (mut p, mut t) = (0, 0);
    let mut star: Option<(usize, usize)> = None;
    loop {
        let step = match pattern.get(p) {
            Some('*') => {
                star = Some((p + 1, t));
                p += 1;
                continue;
            }
            Some('?') if t < text.len() => Some(1),
            Some('[') => match pattern[p..].iter().position(|c| *c == ']') {
                Some(close) if text.get(t).is_some_and(|c| in_set(&pattern[p + 1..p + close], *c)) => Some(close + 1),
                Some(_) => None,
                None => (text.get(t) == Some(&'[')).then_some(1),
            },
            Some(c) if text.get(t) == Some(c) => Some(1),
            None if t == text.len() => return true,
            _ => None,
        };
        match (step, star) {
            (Some(step), _) => (p, t) = (p + step, t + 1),
            (None, Some((after, from))) if from < text.len() => {
                star = Some((after, from + 1));
                (p, t) = (after, from + 1);
            }
            _ => return false,
        }
    }
}

fn in_set(set: &[char], c: char) -> bool {
    let mut i = 0;
    while i < set.len() {
        if i + 2 < set.len() && set[i + 1] == '-' {
            if (set[i]..=set[i + 2]).contains(&c) {
                return true;
            }
            i += 3;
        } else {
            if set[i] == c {
                return true;
            }
            i += 1;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::glob;

    #[test]
    fn patterns_match_as_documented() {
        assert!(glob("f?d", "FED"));
        assert!(glob("left_*", "left_"));
        assert!(glob("m[abc]x", "mbx") && !glob("m[abc]x", "mdx"));
        assert!(glob("m[a-c]x", "mbx") && !glob("m[a-c]x", "m-x"));
        assert!(glob("{a,b}1", "b1") && !glob("{a,b}1", "c1"));
    }

    /// What a pattern of letters, `?` and `*` means, said by recursion.
    fn told(pattern: &[u8], text: &[u8]) -> bool {
        match pattern.split_first() {
            None => text.is_empty(),
            Some((b'*', rest)) => (0..=text.len()).any(|skip| told(rest, &text[skip..])),
            Some((b'?', rest)) => !text.is_empty() && told(rest, &text[1..]),
            Some((c, rest)) => text.first() == Some(c) && told(rest, &text[1..]),
        }
    }

    proptest! {
        #[test]
        fn stars_mean_any_text(pattern in "[ab?*]{0,8}", text in "[ab]{0,8}") {
            prop_assert_eq!(glob(&pattern, &text), told(pattern.as_bytes(), text.as_bytes()));
        }
    }

    #[test]
    fn many_stars_take_no_time() {
        let pattern = format!("{}b", "*a".repeat(30));
        assert!(!glob(&pattern, &"a".repeat(60)));
    }
}
