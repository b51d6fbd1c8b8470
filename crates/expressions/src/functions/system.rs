//! Functions that ask the world outside: they belong to the moment and are never kept.

use std::time::{SystemTime, UNIX_EPOCH};

use model::Value;

use super::{Arguments, Function, momentary};
use crate::{arithmetic::flag, scope::Outcome};

pub const TABLE: &[Function] = &[
    momentary("FILE_EXISTS", "file", "1 if a file exists", |a| Ok(flag(std::path::Path::new(&a.text(0)?).exists()))),
    momentary("GETCWD", "", "working folder", |a| {
        let folder =
            std::env::current_dir().map_err(|e| a.error(format!("the working folder is not readable: {e}")))?;
        Ok(Value::Text(folder.to_string_lossy().into_owned()))
    }),
    momentary("GETENV", "name", "value of an environment variable", |a| {
        let name = a.text(0)?;
        // Names with `=` or a zero byte cannot be set.
        let known = !name.is_empty() && !name.contains(['=', '\0']);
        let value = if known { std::env::var_os(&name) } else { None };
        Ok(Value::Text(value.map_or_else(String::new, |v| v.to_string_lossy().into_owned())))
    }),
    momentary("STR_TIMESTAMP", "", "date and time now", |_| {
        let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
        Ok(Value::Text(timestamp(seconds)))
    }),
    momentary("SYS_INFO", "what", "user name, real name or host name", system_information),
];

fn system_information(a: &mut Arguments) -> Outcome<Value> {
    let variable = |names: &[&str]| names.iter().find_map(|n| std::env::var(n).ok()).unwrap_or_default();
    let asked = a.text(0)?;
    Ok(Value::Text(match asked.to_ascii_uppercase().as_str() {
        "USERNAME" | "REALNAME" => variable(&["USER", "USERNAME", "LOGNAME"]),
        "HOSTNAME" => std::fs::read_to_string("/etc/hostname")
            .map_or_else(|_| variable(&["HOSTNAME", "COMPUTERNAME"]), |name| name.trim().to_string()),
        _ => return Err(a.error(format!("\"{asked}\" is not known here; USERNAME, REALNAME and HOSTNAME are"))),
    }))
}

/// `1998/01/05,02:30:28`, universal time, from seconds since 1970.
fn timestamp(seconds: u64) -> String {
    let (days, clock) = (seconds / 86_400, seconds % 86_400);
    // Days since 0000-03-01, so that leap days end a year (Howard Hinnant's civil calendar).
    let shifted = days + 719_468;
    let (era, day) = (shifted / 146_097, shifted % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let day_of_year = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day_of_year + 2) / 153;
    let date = day_of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year + era * 400 + u64::from(month <= 2);
    format!("{year:04}/{month:02}/{date:02},{:02}:{:02}:{:02}", clock / 3600, clock / 60 % 60, clock % 60)
}

#[cfg(test)]
mod tests {
    /// Truth: the time the documented example prints, 884226628 s after 1970 (`date -u -d`).
    #[test]
    fn timestamps_follow_the_calendar() {
        assert_eq!(super::timestamp(883_967_428), "1998/01/05,02:30:28");
        assert_eq!(super::timestamp(951_782_400), "2000/02/29,00:00:00");
    }
}
