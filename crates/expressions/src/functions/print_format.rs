//! The formats of C's printf, as STR_SPRINTF takes them.

/// Fills a format with values. Numbers arrive as the shortest text that reads back.
///
/// # Errors
/// What of the format does not fit the values.
pub fn sprintf(format: &str, values: &[String]) -> Result<String, String> {
    let mut out = String::new();
    let mut values = values.iter();
    let mut characters = format.chars().peekable();
    while let Some(c) = characters.next() {
        if c != '%' {
            out.push(c);
            continue;
        }
        let mut flags = String::new();
        while let Some(f) = characters.next_if(|c| "-+ 0#".contains(*c)) {
            flags.push(f);
        }
        let mut digits = || {
            let mut text = String::new();
            while let Some(d) = characters.next_if(char::is_ascii_digit) {
                text.push(d);
            }
            text
        };
        let width = digits();
        let precision = characters.next_if_eq(&'.').map(|_| {
            let mut text = String::new();
            while let Some(d) = characters.next_if(char::is_ascii_digit) {
                text.push(d);
            }
            text
        });
        while characters.next_if(|c| matches!(c, 'l' | 'h')).is_some() {}
        let Some(kind) = characters.next() else { return Err("the format ends behind a %".into()) };
        if kind == '%' {
            out.push('%');
            continue;
        }
        let size = |text: &str| {
            if text.is_empty() {
                Ok(0)
            } else {
                text.parse::<usize>().ok().filter(|w| *w <= 4096).ok_or("a width is above 4096")
            }
        };
        let width = size(&width)?;
        let precision = precision.map(|p| size(&p)).transpose()?;
        let value = values.next().ok_or_else(|| format!("there is no value for %{kind}"))?;
        out.push_str(&padded(&one(kind, value, precision)?, &flags, width, kind));
    }
    Ok(out)
}

fn one(kind: char, value: &str, precision: Option<usize>) -> Result<String, String> {
    if kind == 's' {
        return Ok(value.chars().take(precision.unwrap_or(usize::MAX)).collect());
    }
    if kind == 'c' {
        return Ok(value.chars().take(1).collect());
    }
    let x: f64 = value.trim().parse().map_err(|_| format!("\"{value}\" is not a number, as %{kind} needs"))?;
    let digits = precision.unwrap_or(6);
    Ok(match kind {
        'd' | 'i' | 'u' => {
            let whole = (x.trunc() as i64).to_string();
            let (sign, digits) = whole.strip_prefix('-').map_or(("", whole.as_str()), |d| ("-", d));
            format!("{sign}{digits:0>width$}", width = precision.unwrap_or(1))
        }
        'x' => format!("{:x}", x as i64),
        'X' => format!("{:X}", x as i64),
        'o' => format!("{:o}", x as i64),
        'f' | 'F' => format!("{x:.digits$}"),
        'e' | 'E' => exponential(x, digits, kind),
        'g' | 'G' => general(x, digits.max(1), kind),
        other => return Err(format!("%{other} is not a known format")),
    })
}

/// Two digits of exponent at least, as C prints it.
fn exponential(x: f64, digits: usize, kind: char) -> String {
    let text = format!("{x:.digits$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (sign, exponent) = exponent.strip_prefix('-').map_or(('+', exponent), |e| ('-', e));
    format!("{mantissa}{kind}{sign}{exponent:0>2}")
}

fn general(x: f64, digits: usize, kind: char) -> String {
    let scientific = format!("{x:.places$e}", places = digits - 1);
    let exponent: i64 = scientific.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    let trim = |text: String| {
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
    };
    if exponent < -4 || exponent >= digits as i64 {
        let letter = if kind == 'G' { 'E' } else { 'e' };
        let text = exponential(x, digits - 1, letter);
        let (mantissa, rest) = text.split_once(letter).unwrap_or((&text, "+00"));
        return format!("{}{letter}{rest}", trim(mantissa.to_string()));
    }
    trim(format!("{x:.places$}", places = (digits as i64 - 1 - exponent).max(0) as usize))
}

fn padded(text: &str, flags: &str, width: usize, kind: char) -> String {
    let numeric = !matches!(kind, 's' | 'c');
    let signed = if numeric && !text.starts_with('-') && flags.contains('+') {
        format!("+{text}")
    } else if numeric && !text.starts_with('-') && flags.contains(' ') {
        format!(" {text}")
    } else {
        text.to_string()
    };
    if flags.contains('-') {
        format!("{signed:<width$}")
    } else if flags.contains('0') && numeric {
        let (sign, digits) = match signed.chars().next() {
            Some(c @ ('-' | '+' | ' ')) => (c.to_string(), &signed[1..]),
            _ => (String::new(), signed.as_str()),
        };
        format!("{sign}{digits:0>rest$}", rest = width.saturating_sub(sign.len()))
    } else {
        format!("{signed:>width$}")
    }
}
