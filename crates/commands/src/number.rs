//! Numbers in the forms Adams View writes to command files.

/// A real: up to ten decimals, at least one; exponent form from 10000 up and below 0.1, where the
/// value does not come out shorter plain (`9000.0`, `7.5E+04`, `8.0E-02`, `0.3`).
///
/// Digits beyond the tenth decimal are kept where they matter, so that a value written and read
/// again is the same.
pub fn real(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x.is_finite() { "0.0".into() } else { format!("{x}") };
    }
    let size = x.abs();
    if !(0.1..10000.0).contains(&size) {
        return exponent(x);
    }
    let text = trim(&format!("{x:.10}"));
    if text.parse() == Ok(x) { text } else { format!("{x:?}") }
}

fn exponent(x: f64) -> String {
    let short = format!("{x:.10E}");
    let (mantissa, power) = short.split_once('E').unwrap_or((&short, "0"));
    let mut mantissa = trim(mantissa);
    let mut power: i32 = power.parse().unwrap_or(0);
    if format!("{mantissa}E{power}").parse() != Ok(x) {
        let full = format!("{x:E}");
        let (m, p) = full.split_once('E').unwrap_or((&full, "0"));
        mantissa = if m.contains('.') { m.to_string() } else { format!("{m}.0") };
        power = p.parse().unwrap_or(0);
    }
    let sign = if power < 0 { '-' } else { '+' };
    format!("{mantissa}E{sign}{:02}", power.abs())
}

/// A number cut to the digits of its written form: ten decimals, in exponent form of the mantissa.
pub fn ten_decimals(x: f64) -> f64 {
    let plain = (0.1..10000.0).contains(&x.abs());
    let text = if plain { format!("{x:.10}") } else { format!("{x:.10E}") };
    text.parse().unwrap_or(x)
}

/// Cuts trailing zeros but one.
fn trim(text: &str) -> String {
    match text.split_once('.') {
        Some((whole, decimals)) => {
            let kept = decimals.trim_end_matches('0');
            format!("{whole}.{}", if kept.is_empty() { "0" } else { kept })
        }
        None => format!("{text}.0"),
    }
}

/// An angle in degrees with its suffix: `333.4349488229d`.
pub fn angle(degrees: f64) -> String {
    format!("{}d", real(degrees))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: forms printed in exported models.
    #[test]
    fn numbers_look_as_exported() {
        for (x, text) in [
            (75000.0, "7.5E+04"),
            (24.384, "24.384"),
            (0.0, "0.0"),
            (0.01, "1.0E-02"),
            (6.8544971902, "6.8544971902"),
            (1170.432, "1170.432"),
            (9000.0, "9000.0"),
            (0.3, "0.3"),
            (0.08, "8.0E-02"),
            (15000.0, "1.5E+04"),
            (-9806.65, "-9806.65"),
            (5.0, "5.0"),
        ] {
            assert_eq!(real(x), text);
        }
        assert_eq!(angle(90.0), "90.0d");
    }

    #[test]
    fn numbers_read_back_to_the_same_value() {
        for x in [1.0 / 3.0, 1e-300, 123_456.789_012_345_67, 0.1 + 0.2, -2.0f64.sqrt() * 1e5] {
            assert_eq!(real(x).parse::<f64>().unwrap(), x);
        }
    }
}
