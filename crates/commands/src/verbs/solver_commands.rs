//! Lines of the solver's own command language (`.acf`) as they stand in scripts:
//! `SIMULATE/DYNAMIC, END=20.0, DTOUT=0.1`.

use crate::{OutputTimes, SimulationKind};

/// What a line asks for. Times in model units.
#[derive(Clone, Debug, PartialEq)]
pub enum SolverCommand {
    /// A comment or an empty line.
    Nothing,
    Stop,
    Simulate {
        kind: SimulationKind,
        end: Option<f64>,
        duration: Option<f64>,
        output: Option<OutputTimes>,
    },
    /// A setting for the runs that follow: `INTEGRATOR/ERROR=1E-5` gives (`ERROR`, `1E-5`).
    Setting {
        statement: String,
        arguments: Vec<(String, String)>,
    },
    /// Understood as a command, but not executed.
    Other(String),
}

const SETTINGS: &[&str] = &["INTEGRATOR", "EQUILIBRIUM", "KINEMATICS", "IC", "PREFERENCES", "OUTPUT"];

/// Reads one line; keywords may be cut to three letters or more.
pub fn parse_solver_command(line: &str) -> SolverCommand {
    let line = line.trim();
    if line.is_empty() || line.starts_with('!') {
        return SolverCommand::Nothing;
    }
    let code = line.split('!').next().unwrap_or(line).trim();
    let upper = code.to_ascii_uppercase();
    let (statement, rest) = upper.split_once('/').unwrap_or((&upper, ""));
    let (_, original_rest) = code.split_once('/').unwrap_or((code, ""));
    let statement = statement.trim();
    let is = |full: &str| statement.len() >= 3 && full.starts_with(statement);
    if is("STOP") {
        return SolverCommand::Stop;
    }
    let pairs: Vec<(String, String)> = original_rest
        .split(',')
        .map(|part| {
            let (key, value) = part.split_once('=').unwrap_or((part, ""));
            (key.trim().to_ascii_uppercase(), value.trim().to_string())
        })
        .filter(|(key, _)| !key.is_empty())
        .collect();
    if is("SIMULATE") {
        return simulate(rest, &pairs).unwrap_or_else(|| SolverCommand::Other(code.to_string()));
    }
    if let Some(full) = SETTINGS.iter().find(|s| is(s)) {
        return SolverCommand::Setting { statement: (*full).to_string(), arguments: pairs };
    }
    SolverCommand::Other(code.to_string())
}

fn simulate(rest: &str, pairs: &[(String, String)]) -> Option<SolverCommand> {
    let first = rest.split(',').next()?.trim();
    let kinds = [
        ("DYNAMICS", SimulationKind::Dynamic),
        ("KINEMATICS", SimulationKind::Kinematic),
        ("STATICS", SimulationKind::Static),
        ("EQUILIBRIUM", SimulationKind::Equilibrium),
        ("TRANSIENT", SimulationKind::Auto),
        ("INITIAL_CONDITIONS", SimulationKind::Assemble),
    ];
    // A kind that is left out is chosen by the solver.
    let (kind, skip) = match kinds.iter().find(|(word, _)| first.len() >= 3 && word.starts_with(first)) {
        Some((_, kind)) => (*kind, 1),
        None if first.contains('=') => (SimulationKind::Auto, 0),
        None => return None,
    };
    let (mut end, mut duration, mut output) = (None, None, None);
    for (key, value) in pairs.iter().skip(skip) {
        let is = |full: &str| !key.is_empty() && full.starts_with(key.as_str());
        let number = value.to_ascii_uppercase().replace('D', "E").parse::<f64>().ok().filter(|x| x.is_finite())?;
        if key.len() >= 2 && is("END") {
            end = Some(number);
        } else if key.len() >= 2 && is("DURATION") {
            duration = Some(number);
        } else if key.len() >= 2 && is("STEPS") {
            output = Some(OutputTimes::Steps(number.max(0.0) as u64));
        } else if key.len() >= 2 && is("DTOUT") {
            output = Some(OutputTimes::Every(number));
        } else {
            return None;
        }
    }
    // A static run without end is one solution.
    let kind = if kind == SimulationKind::Static && end.is_none() && duration.is_none() {
        SimulationKind::Equilibrium
    } else {
        kind
    };
    Some(SolverCommand::Simulate { kind, end, duration, output })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_and_settings_are_understood() {
        assert_eq!(
            parse_solver_command("SIMULATE/DYNAMIC, END=20.0, DTOUT=0.1"),
            SolverCommand::Simulate {
                kind: SimulationKind::Dynamic,
                end: Some(20.0),
                duration: None,
                output: Some(OutputTimes::Every(0.1)),
            }
        );
        assert_eq!(
            parse_solver_command("sim/stat"),
            SolverCommand::Simulate { kind: SimulationKind::Equilibrium, end: None, duration: None, output: None }
        );
        assert_eq!(
            parse_solver_command("INTEGRATOR/GSTIFF, ERROR=1.0E-05"),
            SolverCommand::Setting {
                statement: "INTEGRATOR".into(),
                arguments: vec![("GSTIFF".into(), String::new()), ("ERROR".into(), "1.0E-05".into())],
            }
        );
        assert_eq!(parse_solver_command("! Insert ACF commands here:"), SolverCommand::Nothing);
        assert_eq!(
            parse_solver_command("DEACTIVATE/SENSOR, ID=1"),
            SolverCommand::Other("DEACTIVATE/SENSOR, ID=1".into())
        );
    }
}
