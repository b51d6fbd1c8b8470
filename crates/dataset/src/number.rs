//! Numbers as datasets show them.

/// How many digits of a number are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Digits {
    /// Ten significant digits and ten decimals at most, as View writes them.
    #[default]
    View,
    /// As many as it takes to read the same number again.
    Exact,
}

/// `0.0017484654`, `75000`, `1.9E+05`, `8.742327157E-04`: exponents from 1E+05 up and below 1E-03.
pub fn number(x: f64, digits: Digits) -> String {
    if x == 0.0 {
        return "0".to_string();
    }
    if !x.is_finite() {
        return x.to_string();
    }
    let scientific = match digits {
        Digits::View => format!("{x:.9e}"),
        Digits::Exact => format!("{x:e}"),
    };
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-3..5).contains(&exponent) {
        return match digits {
            Digits::View => trimmed(&format!("{x:.*}", (9 - exponent).clamp(0, 10) as usize)).to_string(),
            Digits::Exact => x.to_string(),
        };
    }
    let mantissa = trimmed(mantissa);
    let point = if mantissa.contains('.') { "" } else { ".0" };
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{mantissa}{point}E{sign}{:02}", exponent.abs())
}

/// Without the zeros behind the last decimal that counts.
fn trimmed(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

/// An angle in degrees, `333.4349488D`, brought into one turn.
pub(crate) fn turn(degrees: f64, digits: Digits) -> String {
    let text = number(degrees.rem_euclid(360.0), digits);
    if text == "360" { "0D".to_string() } else { format!("{text}D") }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: numbers as public exports print them.
    #[test]
    fn numbers_look_like_an_export() {
        for (x, text) in [
            (6.85449719, "6.85449719"),
            (0.00174846539, "0.0017484654"),
            (8.742327157e-4, "8.742327157E-04"),
            (75000.0, "75000"),
            (1.9e5, "1.9E+05"),
            (5e5, "5.0E+05"),
            (4.32e9, "4.32E+09"),
            (2.5e-4, "2.5E-04"),
            (0.001, "0.001"),
            (0.012_588_402_34, "0.0125884023"),
            (13814.270833333, "13814.27083"),
            (-1.042_353_938e-11, "-1.042353938E-11"),
            (12.0, "12"),
            (0.0, "0"),
            (-0.0, "0"),
        ] {
            assert_eq!(number(x, Digits::View), text);
        }
    }

    #[test]
    fn exact_numbers_read_back_the_same() {
        for x in [0.1 + 0.2, 1e5, 1.0 / 3.0, -7e-300, 123_456_789.123, 99_999.999_999_99, f64::MAX] {
            assert_eq!(number(x, Digits::Exact).parse::<f64>(), Ok(x));
        }
    }

    #[test]
    fn angles_stay_within_one_turn() {
        assert_eq!(turn(-90.0, Digits::View), "270D");
        assert_eq!(turn(-1e-14, Digits::View), "0D");
        assert_eq!(turn(333.434_948_822_9, Digits::View), "333.4349488D");
        assert_eq!(turn(720.0, Digits::View), "0D");
    }
}
