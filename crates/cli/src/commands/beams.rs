//! `flexure beams`: what goes through every beam in one state, as a table, as JSON and as diagrams.

use comfy_table::{CellAlignment, Table, presets};
use flexure::results::{Curve, DiagramRequest, Panel, diagram};
use flexure::{BeamState, BeamsAt, BeamsReport};

use crate::Outcome;
use crate::arguments::{BeamLoads, DiffFormat};
use crate::commands::{
    complain, open, picture_format, picture_size, print_found, save_picture, session, set_beams, shown,
};
use crate::output::read_table;

/// Beside the largest of its kind a value below this part of it is a zero with rounding.
const ROUNDING: f64 = 1e-9;
/// Strain that is rounding of a length, and angle that is rounding of an axis.
const NO_STRAIN: f64 = 1e-15;

pub(super) fn execute(request: &BeamLoads) -> Outcome {
    let drawing = match &request.draw {
        None => None,
        Some(path) => match (picture_format(path), picture_size(&request.size)) {
            (Some(format), Some(size)) => Some((path.as_path(), format, size)),
            _ => return Outcome::Usage,
        },
    };
    let mut session = session();
    set_beams(&mut session, &request.beams);
    session.simulate_nothing(true);
    if !open(&mut session, &request.model, &request.edits) {
        complain("the model has errors; nothing was computed");
        return Outcome::Findings;
    }
    session.simulate_nothing(false);
    let recorded = match request.result.as_deref().map(|path| read_table(path).map_err(|e| (path, e))) {
        None => None,
        Some(Ok(table)) => Some(table),
        Some(Err((path, error))) => {
            complain(format_args!("cannot read {}: {error}", path.display()));
            return Outcome::Findings;
        }
    };
    let at = match (&recorded, request.at) {
        (Some(table), time) => BeamsAt::Table { table, time },
        (None, Some(end)) => BeamsAt::Time { end, statics: request.statics },
        (None, None) if request.statics => BeamsAt::Equilibrium,
        (None, None) => BeamsAt::Present,
    };
    let report = match session.beams(&at) {
        Ok(report) => report,
        Err(diagnostics) => {
            print_found(&session, &diagnostics);
            return Outcome::Findings;
        }
    };
    print_found(&session, &report.diagnostics);
    match request.format {
        DiffFormat::Json => println!("{:#}", json(&report)),
        DiffFormat::Text => print_table(&report, request.most),
    }
    let Some((path, format, size)) = drawing else { return Outcome::Fine };
    let panels = panels(&report);
    let name = session.model_name().unwrap_or_default();
    let title = format!("{name}, time = {} {}", shown(report.time), report.time_unit);
    let along = format!("along the beams ({})", report.length_unit);
    let marks = marks(&report);
    let drawn = diagram(&DiagramRequest { title: &title, along: &along, panels: &panels, marks: &marks, size, format });
    save_picture(path, drawn, request.format == DiffFormat::Text)
}

/// The largest force, moment, and so on of a report, beside which others are zeros.
fn largest(report: &BeamsReport, of: impl Fn(&BeamState) -> f64) -> f64 {
    report.beams.iter().map(|b| of(b).abs()).fold(0.0, f64::max)
}

/// A value, or 0 where it is rounding beside the largest.
fn clean(value: f64, largest: f64) -> f64 {
    if value.abs() <= ROUNDING * largest { 0.0 } else { value }
}

/// Sizes beside which others are zeros: of forces, moments, energies and angles. Where nothing is loaded it
/// is what a strain of rounding would make.
struct Scale {
    force: f64,
    moment: f64,
    energy: f64,
    angle: f64,
}

impl Scale {
    fn of(report: &BeamsReport) -> Scale {
        let noise = |of: &dyn Fn(&BeamState) -> f64| largest(report, of) * NO_STRAIN / ROUNDING;
        let force = largest(report, |b| b.force[0].abs().max(b.shear()));
        let moment = largest(report, |b| b.bending()[0].max(b.bending()[1]).max(b.torque().abs()));
        Scale {
            force: force.max(noise(&|b| b.stretching)),
            moment: moment.max(noise(&|b| b.stretching * b.length)),
            energy: largest(report, |b| b.energy).max(noise(&|b| NO_STRAIN * b.stretching * b.length)),
            angle: largest(report, |b| b.angle).max(NO_STRAIN / ROUNDING),
        }
    }
}

fn print_table(report: &BeamsReport, most: usize) {
    let scale = Scale::of(report);
    let power = largest(report, |b| b.power);
    let total = clean(report.energy(), scale.energy);
    let mut table = Table::new();
    table.load_preset(presets::ASCII_BORDERS_ONLY_CONDENSED);
    let unit = |column: &str| format!("({})", report.unit(column));
    table.set_header([
        "beam".to_string(),
        format!("N\n{}", unit("N")),
        format!("V\n{}", unit("VY")),
        format!("T\n{}", unit("T_J")),
        format!("largest M\n{}", unit("MY_J")),
        "at".to_string(),
        format!("rotation\n{}", unit("ANGLE")),
        format!("energy\n{}", unit("ENERGY")),
        "share\n(%)".to_string(),
        format!("power\n{}", unit("POWER")),
    ]);
    let share = |energy: f64| if total > 0.0 { format!("{:.2}", 100.0 * energy / total) } else { "-".into() };
    for beam in report.beams.iter().take(most) {
        let (bent, place) = worst(beam, scale.moment);
        table.add_row([
            beam.name.clone(),
            shown(clean(beam.force[0], scale.force)),
            shown(clean(beam.shear(), scale.force)),
            shown(clean(beam.torque(), scale.moment)),
            shown(clean(bent, scale.moment)),
            place.to_string(),
            shown(clean(beam.angle, scale.angle)),
            shown(clean(beam.energy, scale.energy)),
            share(beam.energy),
            shown(clean(beam.power, power)),
        ]);
    }
    if report.beams.len() > most {
        table.add_row([format!("... and {} more (--most)", report.beams.len() - most)]);
    }
    let count = report.beams.len();
    table.add_row([
        "largest size".to_string(),
        shown(clean(largest(report, |b| b.force[0]), scale.force)),
        shown(clean(largest(report, BeamState::shear), scale.force)),
        shown(clean(largest(report, BeamState::torque), scale.moment)),
        shown(clean(largest(report, |b| worst(b, scale.moment).0), scale.moment)),
        String::new(),
        shown(clean(largest(report, |b| b.angle), scale.angle)),
        shown(clean(largest(report, |b| b.energy), scale.energy)),
        share(largest(report, |b| b.energy)),
        shown(power),
    ]);
    let mut sums = vec![String::new(); 10];
    (sums[0], sums[7], sums[8], sums[9]) =
        (format!("total of {count}"), shown(total), share(total), shown(report.power()));
    table.add_row(sums);
    for column in [1, 2, 3, 4, 6, 7, 8, 9] {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    println!("time {} {}", shown(report.time), report.time_unit);
    println!("{table}");
    match largest(report, |b| b.residual) {
        0.0 => println!("the loads of each beam balance exactly"),
        left => println!("the loads of each beam balance to {left:.0e} of its largest"),
    }
}

/// The largest bending moment of a beam and the end where it acts; it is linear in between.
fn worst(beam: &BeamState, largest: f64) -> (f64, &'static str) {
    let [j, i] = beam.bending();
    let place = match () {
        () if j.max(i) <= ROUNDING * largest => "",
        () if (j - i).abs() <= ROUNDING * largest => "J, I",
        () if j > i => "J",
        () => "I",
    };
    (j.max(i), place)
}

fn json(report: &BeamsReport) -> serde_json::Value {
    let total = report.energy();
    let beams: Vec<_> = report
        .beams
        .iter()
        .map(|b| {
            let [j, i] = b.moments;
            serde_json::json!({
                "name": b.name, "length": b.length,
                "n": b.force[0], "vy": b.force[1], "vz": b.force[2],
                "t_j": j[0], "my_j": j[1], "mz_j": j[2], "t_i": i[0], "my_i": i[1], "mz_i": i[2],
                "angle": b.angle, "energy": b.energy, "power": b.power, "residual": b.residual,
                "share_of_energy": if total > 0.0 { Some(b.energy / total) } else { None },
            })
        })
        .collect();
    let chains: Vec<Vec<_>> = report
        .chains
        .iter()
        .map(|chain| {
            let link = |l: &flexure::ChainLink| {
                report.beams.get(l.beam).map(|b| serde_json::json!({ "beam": b.name, "reversed": l.reversed }))
            };
            chain.iter().filter_map(link).collect()
        })
        .collect();
    serde_json::json!({
        "time": report.time,
        "units": {
            "time": report.time_unit, "length": report.length_unit, "force": report.unit("N"),
            "moment": report.unit("MY_J"), "angle": report.unit("ANGLE"), "energy": report.unit("ENERGY"),
            "power": report.unit("POWER"),
        },
        "beams": beams,
        "chains": chains,
        "total": { "energy": total, "power": report.power() },
    })
}

/// Where every piece of a diagram lies: chains one after another, with a gap between them.
fn places(report: &BeamsReport) -> Vec<Vec<(usize, bool, f64)>> {
    let all: f64 = report.beams.iter().map(|b| b.length).sum();
    let mut x = 0.0;
    let mut places = Vec::new();
    for chain in &report.chains {
        let mut along = Vec::new();
        for link in chain {
            along.push((link.beam, link.reversed, x));
            x += report.beams.get(link.beam).map_or(0.0, |b| b.length);
        }
        places.push(along);
        x += 0.05 * all;
    }
    places
}

/// Both ends of every beam along the diagram.
fn marks(report: &BeamsReport) -> Vec<f64> {
    let length = |beam: usize| report.beams.get(beam).map_or(0.0, |b| b.length);
    places(report).into_iter().flatten().flat_map(|(beam, _, x)| [x, x + length(beam)]).collect()
}

fn panels(report: &BeamsReport) -> Vec<Panel> {
    let Scale { force, moment, .. } = Scale::of(report);
    let places = places(report);
    // A curve from the values at J and at I; a beam that is run through from I is turned round.
    let curve = |name: &str, largest: f64, ends: &dyn Fn(&BeamState) -> [f64; 2]| {
        let piece = |along: &Vec<(usize, bool, f64)>| {
            let mut points = Vec::new();
            for (beam, reversed, x) in along {
                let Some(beam) = report.beams.get(*beam) else { continue };
                let [j, i] = ends(beam).map(|value| clean(value, largest));
                let (first, second) = if *reversed { (i, j) } else { (j, i) };
                points.extend([(*x, first), (x + beam.length, second)]);
            }
            points
        };
        Curve { name: name.into(), pieces: places.iter().map(piece).collect() }
    };
    let unit = |name: &str, column: &str| format!("{name} ({})", report.unit(column));
    let same = |k: usize| move |b: &BeamState| [b.force[k]; 2];
    let ends = |k: usize| move |b: &BeamState| b.moments.map(|m| m[k]);
    vec![
        Panel { title: unit("N", "N"), curves: vec![curve("N", force, &same(0))] },
        Panel { title: unit("V", "VY"), curves: vec![curve("Vy", force, &same(1)), curve("Vz", force, &same(2))] },
        Panel { title: unit("T", "T_J"), curves: vec![curve("T", moment, &ends(0))] },
        Panel { title: unit("M", "MY_J"), curves: vec![curve("My", moment, &ends(1)), curve("Mz", moment, &ends(2))] },
    ]
}
