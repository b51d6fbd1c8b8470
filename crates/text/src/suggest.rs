//! "Did you mean ...?"

/// The candidate that `word` was most likely meant to be, if one is close enough: a third of its
/// letters may be wrong, missing, doubled or swapped, or its parts may stand in another order.
/// Case does not matter; of equally close candidates the first wins.
pub fn suggest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let word = word.to_lowercase();
    let length = word.chars().count();
    let limit = (length / 3).clamp(1, 4);
    if length < 3 {
        return None; // two letters resemble everything
    }
    let parts = sorted_parts(&word);
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let lower = candidate.to_lowercase();
        let distance = if lower.chars().count().abs_diff(length) <= limit {
            let letters = strsim::damerau_levenshtein(&word, &lower);
            if letters > 1 && parts.len() > 1 && parts == sorted_parts(&lower) { 1 } else { letters }
        } else {
            continue;
        };
        if distance <= limit && best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

fn sorted_parts(word: &str) -> Vec<&str> {
    let mut parts: Vec<&str> = word.split('_').collect();
    parts.sort_unstable();
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    const NAMES: [&str; 6] = ["youngs_modulus", "shear_modulus", "length", "ixx", "iyy", "i_marker_name"];

    #[test]
    fn a_slip_of_the_finger_is_recognised() {
        assert_eq!(suggest("yongs_modulus", NAMES), Some("youngs_modulus"));
        assert_eq!(suggest("YOUNGS_MODULSU", NAMES), Some("youngs_modulus"));
        assert_eq!(suggest("lenght", NAMES), Some("length"));
        assert_eq!(suggest("modulus_shear", NAMES), Some("shear_modulus"));
        assert_eq!(suggest("ixy", NAMES), Some("ixx"));
    }

    #[test]
    fn a_different_word_is_not() {
        assert_eq!(suggest("colour", NAMES), None);
        assert_eq!(suggest("i", NAMES), None);
        assert_eq!(suggest("", NAMES), None);
    }
}
