//! Functions that ask the world outside: they belong to the moment and are never kept.

use std::time::Duration;

use model::Value;

use super::{Arguments, Function, momentary, real};
use crate::{World, scope::Outcome, scope::problem};

pub const TABLE: &[Function] = &[
    momentary(
        "ALERT",
        "type, text, button, [button], [button], [choice]",
        "writes a message; gives the number of the default button",
        |a| {
            let text = format!("{}: {}", a.text(0)?, a.text(1)?);
            a.print(text);
            default_button(a, 2)
        },
    ),
    momentary("ALERT2", "texts, type", "writes lines of a message; gives 1", alert_lines),
    momentary(
        "ALERT3",
        "texts, type, button, [button], [button], [choice]",
        "writes lines of a message; gives the number of the default button",
        alert_lines,
    ),
    momentary("EXECUTE_VIEW_COMMAND", "command", "runs a command after this one; 1 if it was accepted", |a| {
        let command = a.text(0)?;
        a.changes()?.ask_for(command);
        Ok(Value::Integer(1))
    }),
    momentary("FILE_ALERT", "file", "1 if a file may be written over, 0 if it does not exist", |a| {
        let name = a.text(0)?;
        let exists = !name.is_empty() && std::path::Path::new(&name).exists();
        if exists {
            a.print(format!("the file {name} exists"));
        }
        Ok(Value::Integer(i64::from(exists)))
    }),
    momentary("GETENV", "name", "value of an environment variable", |a| {
        let name = a.text(0)?;
        // Names with `=` or a zero byte cannot be set.
        if !is_variable(&name) {
            return Ok(Value::Text(String::new()));
        }
        let value = match a.evaluator.scope.world {
            Some(world) => world.variable(&name),
            None => std::env::var_os(&name).map(|v| v.to_string_lossy().into_owned()),
        };
        Ok(Value::Text(value.unwrap_or_default()))
    }),
    momentary("PUTENV", "name, value", "sets an environment variable of the session; 0 if that worked", |a| {
        let (name, value) = (a.text(0)?, a.text(1)?);
        if !is_variable(&name) {
            return Ok(Value::Integer(1));
        }
        a.changes()?.set_variable(&name, value);
        Ok(Value::Integer(0))
    }),
    momentary("RAND", "", "the next random number from 0 to 1; every session has the same", |a| {
        real(a.evaluator.scope.world.map_or_else(|| World::default().random(), World::random))
    }),
    momentary("STATUS_PRINT", "text", "writes a text to the status line and gives it back", |a| {
        let text = a.text(0)?;
        a.print(text.clone());
        Ok(Value::Text(text))
    }),
    momentary("STR_DATE", "format", "date and time now, by a format such as %Y-%m-%d", |a| {
        let format = a.text(0)?;
        Ok(Value::Text(dated(&format, now(a).as_secs()).unwrap_or(format)))
    }),
    momentary("STR_PRINT", "text", "writes a text to the log", |a| {
        let text = a.text(0)?;
        a.print(text);
        Ok(Value::Integer(1))
    }),
    momentary("STR_TIMESTAMP", "", "date and time now", |a| {
        let seconds = now(a).as_secs();
        Ok(Value::Text(dated("%Y/%m/%d,%H:%M:%S", seconds).unwrap_or_default()))
    }),
    momentary(
        "SYS_INFO",
        "what",
        "USERNAME, REALNAME, HOSTNAME, UID, GID or GROUPNAME of the machine",
        system_information,
    ),
    momentary("TIMER_CPU", "end", "starts a timer of processor time (0) or reads it (1), in seconds", |a| {
        let (end, time) =
            (a.number(0)? != 0.0, a.evaluator.scope.world.map_or_else(Duration::default, World::processor));
        timer(a, 1, time, end)
    }),
    momentary("TIMER_ELAPSED", "end", "starts a timer (0) or reads it (1), in seconds", |a| {
        let (end, time) = (a.number(0)? != 0.0, now(a));
        timer(a, 0, time, end)
    }),
];

fn is_variable(name: &str) -> bool {
    !name.is_empty() && !name.contains(['=', '\0'])
}

fn now(a: &Arguments) -> Duration {
    a.evaluator.scope.world.map_or_else(|| World::default().now(), World::now)
}

fn timer(a: &Arguments, which: usize, time: Duration, end: bool) -> Outcome<Value> {
    real(a.evaluator.scope.world.map_or(time, |world| world.timer(which, time, end)).as_secs_f64())
}

/// The texts of an array, or of the variable given itself.
fn alert_lines(a: &mut Arguments) -> Outcome<Value> {
    let lines = match a.values[0] {
        Value::Object(id) if a.database().get(id).is_some_and(|o| o.class.id == "variable") => {
            let value = a.evaluator.variable(id)?;
            match value {
                Value::Texts(list) => list,
                other => vec![crate::arithmetic::text_of(&other, &a.evaluator.scope)?],
            }
        }
        _ => a.texts(0)?,
    };
    let kind = a.text(1)?;
    for line in lines {
        a.print(format!("{kind}: {line}"));
    }
    default_button(a, 2)
}

/// The choice is the last argument if it is a number, else the first button.
fn default_button(a: &Arguments, first: usize) -> Outcome<Value> {
    let Some(choice) = a.values.last().filter(|_| a.len() > first + 1).and_then(Value::as_number) else {
        return Ok(Value::Integer(1));
    };
    let buttons = a.len() - first - 1;
    if choice.fract() == 0.0 && (1.0..=buttons as f64).contains(&choice) {
        Ok(Value::Integer(choice as i64))
    } else {
        Err(a.error(format!("there are {buttons} buttons to choose from")))
    }
}

impl<'e> Arguments<'_, 'e> {
    /// The world, if it may be changed.
    pub(super) fn changes(&self) -> Outcome<&'e World> {
        self.evaluator.scope.world.filter(|w| w.allows_changes).ok_or_else(|| {
            Box::new(
                problem(
                    "expression/side-effect",
                    format!("{} would change something outside the model, which is not allowed here", self.name),
                )
                .help("run the commands with `flexure run` to have it done"),
            )
        })
    }

    fn print(&self, line: String) {
        if let Some(world) = self.evaluator.scope.world {
            world.print(line);
        }
    }
}

fn system_information(a: &mut Arguments) -> Outcome<Value> {
    let variable = |names: &[&str]| names.iter().find_map(|n| std::env::var(n).ok()).unwrap_or_default();
    let asked = a.text(0)?;
    Ok(Value::Text(match asked.to_ascii_uppercase().as_str() {
        "USERNAME" | "REALNAME" => variable(&["USER", "USERNAME", "LOGNAME"]),
        "HOSTNAME" => std::fs::read_to_string("/etc/hostname")
            .map_or_else(|_| variable(&["HOSTNAME", "COMPUTERNAME"]), |name| name.trim().to_string()),
        "UID" => identity("Uid:"),
        "GID" => identity("Gid:"),
        "GROUPNAME" => {
            let (id, groups) = (identity("Gid:"), std::fs::read_to_string("/etc/group").unwrap_or_default());
            let mut lines = groups.lines().map(|l| l.split(':').collect::<Vec<_>>());
            lines.find(|l| l.get(2) == Some(&id.as_str())).map_or_else(String::new, |l| l[0].to_string())
        }
        _ => {
            return Err(a.error(format!(
                "\"{asked}\" is not known here; USERNAME, REALNAME, HOSTNAME, UID, GID and GROUPNAME are"
            )));
        }
    }))
}

/// A number of the user or group, as the kernel lists it for this process.
fn identity(key: &str) -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|l| l.strip_prefix(key));
    line.and_then(|l| l.split_whitespace().next()).unwrap_or("").to_string()
}

const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];
const DAYS: [&str; 7] = ["Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"];

/// A date by the directives of C's strftime, universal time, from seconds since 1970. None if a
/// directive is not known.
fn dated(format: &str, seconds: u64) -> Option<String> {
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
    let (hour, minute, second) = (clock / 3600, clock / 60 % 60, clock % 60);
    let leap = year.is_multiple_of(4) && !year.is_multiple_of(100) || year.is_multiple_of(400);
    let in_year = [0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334][month as usize - 1]
        + date
        + u64::from(leap && month > 2);
    let (name, weekday) = (MONTHS[month as usize - 1], DAYS[(days as usize + 4) % 7]);
    let twelve = (hour + 11) % 12 + 1;
    let mut out = String::new();
    let mut characters = format.chars();
    while let Some(c) = characters.next() {
        if c != '%' {
            out.push(c);
            continue;
        }
        let piece = match characters.next()? {
            'Y' => year.to_string(),
            'y' => format!("{:02}", year % 100),
            'm' => format!("{month:02}"),
            'd' => format!("{date:02}"),
            'e' => format!("{date:2}"),
            'j' => format!("{in_year:03}"),
            'H' => format!("{hour:02}"),
            'I' => format!("{twelve:02}"),
            'M' => format!("{minute:02}"),
            'S' => format!("{second:02}"),
            'p' => if hour < 12 { "AM" } else { "PM" }.to_string(),
            'B' => name.to_string(),
            'b' | 'h' => name[..3].to_string(),
            'A' => weekday.to_string(),
            'a' => weekday[..3].to_string(),
            'w' => ((days + 4) % 7).to_string(),
            'D' | 'x' => format!("{month:02}/{date:02}/{:02}", year % 100),
            'F' => format!("{year:04}-{month:02}-{date:02}"),
            'T' | 'X' => format!("{hour:02}:{minute:02}:{second:02}"),
            'R' => format!("{hour:02}:{minute:02}"),
            'c' => format!("{} {} {date:2} {hour:02}:{minute:02}:{second:02} {year}", &weekday[..3], &name[..3]),
            'Z' => "UTC".to_string(),
            'z' => "+0000".to_string(),
            'n' => "\n".to_string(),
            't' => "\t".to_string(),
            '%' => "%".to_string(),
            _ => return None,
        };
        out.push_str(&piece);
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::dated;

    /// Truth: GNU `date -u -d @883967428` and `@951782400`, with the same formats.
    #[test]
    fn dates_follow_the_calendar() {
        let first = |format: &str| dated(format, 883_967_428).unwrap();
        assert_eq!(first("%Y/%m/%d,%H:%M:%S"), "1998/01/05,02:30:28");
        assert_eq!(
            first("%a %A %b %B %j %I%p %D %T %y %e %%"),
            "Mon Monday Jan January 005 02AM 01/05/98 02:30:28 98  5 %"
        );
        assert_eq!(dated("%F %j %A", 951_782_400).unwrap(), "2000-02-29 060 Tuesday");
        assert_eq!(dated("%Q", 0), None);
    }
}
