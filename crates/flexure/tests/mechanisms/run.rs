//! Runs the rows of a case and compares.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::Path;

use flexure::{BeamAngles, Mode, ModesAbout, Run, Session};

use crate::balance;
use crate::truth::{About, At, Case, Find};

/// Inputs of a row by name.
type Inputs = BTreeMap<String, f64>;

/// What is wrong with a case, a line each.
pub fn troubles(folder: &Path, models: &[String], case: &Case) -> Vec<String> {
    assert!(["truth", "twin"].contains(&case.kind.as_str()), "{}", case.name);
    assert!(!case.source.is_empty() && !case.tolerance.because.is_empty() && !case.rows.is_empty(), "{}", case.name);
    assert!(case.find.keys().all(|k| case.columns.contains(k)), "{}", case.name);
    let mut troubles = Vec::new();
    for row in &case.rows {
        assert_eq!(row.len(), case.columns.len(), "{} {row:?}", case.name);
        let named = case.columns.iter().cloned().zip(row.iter().copied());
        let (expected, inputs): (Inputs, Inputs) = named.partition(|(name, _)| case.find.contains_key(name));
        let found = find_all(folder, models, case, &inputs, &expected);
        let ours = case.differs.as_deref().map_or_else(String::new, |why| format!(" (ours, because {why})"));
        let where_ = format!("{} {inputs:?}{ours}", case.name);
        match found {
            Ok(_) if case.fails => troubles.push(format!("{where_}: an equilibrium was found")),
            Ok((values, imbalance)) => {
                troubles.extend(imbalance.map(|text| format!("{where_}: {text}")));
                for (name, value) in values {
                    let wanted = expected[&name];
                    let abs = case.find[&name].abs.unwrap_or(case.tolerance.abs + case.tolerance.rel * wanted.abs());
                    let off = (value - wanted).abs();
                    if std::env::var_os("SHOW").is_some() {
                        eprintln!("{where_} {name}: {value:.9} printed {wanted} off {:.1e}", value - wanted);
                    }
                    let within = off <= abs;
                    if !wanted.is_nan() && !within {
                        troubles.push(format!("{where_} {name}: {value:.9}, not {wanted} ({off:.1e} > {abs:.1e})"));
                    }
                }
            }
            Err(text) if case.fails => assert!(text.contains("run/failed"), "{text}"),
            Err(text) => troubles.push(format!("{where_}: {text}")),
        }
    }
    troubles
}

type Values = Vec<(String, f64)>;

/// Finds every expected column of a row, by extrapolation where the case asks for it.
fn find_all(
    folder: &Path,
    models: &[String],
    case: &Case,
    inputs: &Inputs,
    expected: &Inputs,
) -> Result<(Values, Option<String>), String> {
    if case.extrapolate.is_empty() {
        return find_once(folder, models, case, inputs, expected);
    }
    let mut sets = Vec::new();
    let mut imbalance = None;
    for n in &case.extrapolate {
        let mut inputs = inputs.clone();
        inputs.insert("n".into(), *n);
        let (values, text) = find_once(folder, models, case, &inputs, expected)?;
        imbalance = imbalance.or(text);
        sets.push(values);
    }
    let steps: Vec<f64> = case.extrapolate.iter().map(|n| 1.0 / (n * n)).collect();
    let limit = |k: usize| at_zero(&steps, sets.iter().map(|s| s[k].1).collect());
    Ok(((0..sets[0].len()).map(|k| (sets[0][k].0.clone(), limit(k))).collect(), imbalance))
}

/// Neville's scheme: the polynomial through the points, at zero.
fn at_zero(x: &[f64], mut y: Vec<f64>) -> f64 {
    for level in 1..x.len() {
        for i in 0..x.len() - level {
            y[i] = (x[i + level] * y[i] - x[i] * y[i + 1]) / (x[i + level] - x[i]);
        }
    }
    y[0]
}

fn find_once(
    folder: &Path,
    models: &[String],
    case: &Case,
    inputs: &Inputs,
    expected: &Inputs,
) -> Result<(Values, Option<String>), String> {
    let mut values = Vec::new();
    if let Some((name, find)) = case.find.iter().find(|(_, f)| f.critical.is_some()) {
        let load = find.critical.as_deref().unwrap_or_default();
        values.push((name.clone(), critical(folder, models, case, inputs, load, expected[name])?));
        return Ok((values, None));
    }
    let mut session = session(folder, models, case, inputs)?;
    if let Some(about) = &case.modes {
        let modes = modes(&mut session, about, inputs)?;
        for (name, find) in &case.find {
            values.push((name.clone(), find.offset + find.factor * of_modes(&modes, find)?));
        }
        return Ok((values, None));
    }
    let runs = session.take_runs();
    let run = runs.last().ok_or("no run was made")?;
    for (name, find) in &case.find {
        values.push((name.clone(), find.offset + find.factor * of_run(run, find)?));
    }
    Ok((values, runs.iter().find_map(balance::trouble)))
}

/// Whole numbers without a point, so that they can count.
fn fill(text: &str, inputs: &Inputs) -> String {
    inputs
        .iter()
        .fold(text.to_string(), |text, (name, value)| text.replace(&format!("{{{name}}}"), &format!("{value}")))
}

fn session(folder: &Path, models: &[String], case: &Case, inputs: &Inputs) -> Result<Session, String> {
    let mut session = Session::new();
    session.measure_beam_angles(if case.rotation_vector { BeamAngles::RotationVector } else { BeamAngles::Projected });
    session.shear_nonlinear_beams(case.nonlinear_shear);
    for model in models {
        let report = session.read(&folder.join(model));
        assert!(report.diagnostics.is_empty(), "{}", session.render(&report.diagnostics, false));
    }
    let mut watched = false;
    for command in &case.commands {
        if command.starts_with("simulation") && !watched {
            balance::watch(&mut session);
            watched = true;
        }
        let report = session.execute(&fill(command, inputs));
        if report.failed > 0 {
            return Err(session.render(&report.diagnostics, false));
        }
    }
    Ok(session)
}

fn modes(session: &mut Session, about: &About, inputs: &Inputs) -> Result<Vec<Mode>, String> {
    let about = match about.state.as_str() {
        "present" => ModesAbout::Present,
        "equilibrium" => ModesAbout::Equilibrium,
        "spin" => ModesAbout::Spin {
            marker: about.marker.clone(),
            rate: fill(&about.rate, inputs).parse().map_err(|_| format!("`{}` is no rate", about.rate))?,
        },
        other => return Err(format!("modes about `{other}`?")),
    };
    session.modes(&about).map(|found| found.modes).map_err(|d| session.render(&d, false))
}

fn of_modes(modes: &[Mode], find: &Find) -> Result<f64, String> {
    let mode = |k: usize| modes.get(k - 1).ok_or_else(|| format!("no mode {k}"));
    match (find.mode, find.damping) {
        (Some(k), _) => Ok(mode(k)?.frequency_hz * TAU),
        (None, Some(k)) => {
            let mut swinging = modes.iter().filter(|m| m.damping_ratio < 1.0 - 1e-6);
            swinging.nth(k - 1).map(|m| m.damping_ratio).ok_or_else(|| format!("no mode {k} that swings"))
        }
        _ => Err("of modes, `mode` or `damping` can be found".into()),
    }
}

/// The load at which the square of the lowest frequency passes zero, by the secant rule.
fn critical(
    folder: &Path,
    models: &[String],
    case: &Case,
    inputs: &Inputs,
    load: &str,
    guess: f64,
) -> Result<f64, String> {
    let about = case.modes.as_ref().ok_or("a critical load needs modes")?;
    let square = |value: f64| -> Result<f64, String> {
        let mut inputs = inputs.clone();
        inputs.insert(load.to_string(), value);
        let found = modes(&mut session(folder, models, case, &inputs)?, about, &inputs)?;
        let lowest = found.first().ok_or("no mode")?;
        Ok(lowest.imaginary * lowest.imaginary - lowest.real * lowest.real)
    };
    let (mut a, mut b) = (0.9 * guess, 0.99 * guess);
    let (mut at_a, mut at_b) = (square(a)?, square(b)?);
    assert!(at_a > at_b && at_b > 0.0, "{}: buckles below {b}", case.name);
    for _ in 0..12 {
        let next = b - at_b * (b - a) / (at_b - at_a);
        let at_next = square(next)?;
        (a, at_a, b, at_b) = (b, at_b, next, at_next);
        if (b - a).abs() < 1e-5 * b {
            // The error of a secant is about the product of the two before: 1e-5 times what b was off.
            return Ok(b);
        }
    }
    Err(format!("no critical load found near {b}"))
}

fn series<'a>(run: &'a Run, name: &str) -> Result<&'a [f64], String> {
    run.table.get(name).map(|s| s.values.as_slice()).ok_or_else(|| format!("no series {name}"))
}

fn of_run(run: &Run, find: &Find) -> Result<f64, String> {
    let times = &run.table.series[0].values;
    if let (Some(request), Some(axis)) = (&find.series, &find.rotation) {
        let row = times.len() - 1;
        let angle = |r: &str| Ok::<_, String>(series(run, &format!("{request}.{r}"))?[row].to_radians());
        let turned = glam::DQuat::from_rotation_z(angle("R1")?)
            * glam::DQuat::from_rotation_x(angle("R2")?)
            * glam::DQuat::from_rotation_z(angle("R3")?);
        let vector = turned.to_scaled_axis();
        return match axis.as_str() {
            "x" => Ok(vector.x),
            "y" => Ok(vector.y),
            "z" => Ok(vector.z),
            other => Err(format!("no axis {other}")),
        };
    }
    let name = find.series.as_ref().ok_or("of a run, a `series` can be found")?;
    let values = series(run, name)?;
    let kept = || times.iter().copied().zip(values.iter().copied()).filter(|(t, _)| *t >= find.from);
    let least = || kept().min_by(|a, b| a.1.total_cmp(&b.1)).ok_or("no values");
    Ok(match &find.at {
        At::Time(t) => {
            let row = times.iter().position(|x| (x - t).abs() < 1e-9).ok_or_else(|| format!("no output at {t}"))?;
            values[row]
        }
        At::Word(word) => match word.as_str() {
            "end" => values[values.len() - 1],
            "least" => least()?.1,
            "time of least" => least()?.0,
            "largest" => kept().map(|v| v.1).fold(f64::NEG_INFINITY, f64::max),
            "mean" => kept().map(|v| v.1).sum::<f64>() / kept().count() as f64,
            other => return Err(format!("`{other}` is no place in a series")),
        },
    })
}
