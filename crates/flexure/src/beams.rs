//! What goes through every beam of a model in one state: a table, and the beams in the order in which
//! they follow one another, for diagrams. All of it is read from the columns that a run records.

use std::collections::{BTreeMap, BTreeSet};

use elements::forces::beam;
use elements::output::member::COLUMNS;
use model::{Database, ObjectId};
use results::Table;
use schema::Dimension;
use text::Diagnostic;

/// The state that is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BeamsAt<'a> {
    /// As modelled, or where the last analysis of the unchanged model left it.
    Present,
    /// The static equilibrium.
    Equilibrium,
    /// A dynamic simulation's end, s; from the static equilibrium if asked for.
    Time { end: f64, statics: bool },
    /// The row of a results table of the model nearest to a time, s, or its last row.
    Table { table: &'a Table, time: Option<f64> },
}

/// One beam, in model units. Signs and axes are those of the columns: tension is positive, moments act on
/// the face that looks to I.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamState {
    /// Full name.
    pub name: String,
    /// Undeformed length.
    pub length: f64,
    /// Young's modulus times area, a force: the force of a strain of one.
    pub stretching: f64,
    /// Axial force and the two shear forces.
    pub force: [f64; 3],
    /// Torque and the two bending moments at J and at I.
    pub moments: [[f64; 3]; 2],
    /// Largest rotation that the beam's law sees.
    pub angle: f64,
    /// Strain energy.
    pub energy: f64,
    /// Power taken by damping.
    pub power: f64,
    /// What is left of the balance of its loads, as a part of the largest.
    pub residual: f64,
}

impl BeamState {
    /// Size of the shear force.
    pub fn shear(&self) -> f64 {
        self.force[1].hypot(self.force[2])
    }

    /// The torque of the larger size, of the two ends.
    pub fn torque(&self) -> f64 {
        let [j, i] = self.moments;
        if i[0].abs() > j[0].abs() { i[0] } else { j[0] }
    }

    /// Torque and bending moments at a share of the way from J (0) to I (1).
    pub fn moment(&self, station: f64) -> [f64; 3] {
        let [j, i] = self.moments;
        std::array::from_fn(|k| j[k] * (1.0 - station) + i[k] * station)
    }

    /// Sizes of the bending moment at J and at I; between them it is never larger.
    pub fn bending(&self) -> [f64; 2] {
        self.moments.map(|[_, y, z]| y.hypot(z))
    }
}

/// A beam as a piece of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChainLink {
    /// Index into the beams of the report.
    pub beam: usize,
    /// Whether the chain runs through it from I to J.
    pub reversed: bool,
}

/// All beams of a model in one state.
#[derive(Clone, Debug, Default)]
pub struct BeamsReport {
    /// Time of the state, model units.
    pub time: f64,
    /// In order of creation.
    pub beams: Vec<BeamState>,
    /// Beams that follow one another: two of them, and no third, end on each part between.
    pub chains: Vec<Vec<ChainLink>>,
    /// Unit of each column, in the order of the columns.
    pub units: [String; COLUMNS.len()],
    pub length_unit: String,
    pub time_unit: String,
    pub diagnostics: Vec<Diagnostic>,
}

impl BeamsReport {
    /// Strain energy of all beams.
    pub fn energy(&self) -> f64 {
        self.beams.iter().map(|b| b.energy).sum()
    }

    /// Power that the damping of all beams takes.
    pub fn power(&self) -> f64 {
        self.beams.iter().map(|b| b.power).sum()
    }

    /// Unit of a column by the name of the column.
    pub fn unit(&self, column: &str) -> &str {
        let at = COLUMNS.iter().position(|(name, _)| *name == column);
        at.map_or("", |at| self.units[at].as_str())
    }
}

/// The beams of a model as a table has them.
pub(crate) fn from_table(
    database: &Database,
    model: ObjectId,
    table: &Table,
    time: Option<f64>,
) -> Result<BeamsReport, Vec<Diagnostic>> {
    let beams = beam::lower::active(database, model);
    if beams.is_empty() {
        let name = database.full_name(model);
        return Err(vec![
            Diagnostic::error("beams/none", format!("model `{name}` has no active beam"))
                .help("`force create element_like beam` makes one, `flexible_link create` a chain of them"),
        ]);
    }
    let units = database.units();
    let row = row(table, time.map(|t| t / units.factor(Dimension::TIME)), &units.label(Dimension::TIME))?;
    let mut report = BeamsReport {
        time: table.series.first().and_then(|s| s.values.get(row)).copied().unwrap_or_default(),
        units: COLUMNS.map(|(_, dimension)| units.label(dimension)),
        length_unit: units.label(Dimension::LENGTH),
        time_unit: units.label(Dimension::TIME),
        ..BeamsReport::default()
    };
    let mut used: BTreeMap<String, usize> = BTreeMap::new();
    let mut missing = Vec::new();
    for &beam in &beams {
        let count = used.entry(database.object(beam).name.to_ascii_lowercase()).or_insert(0);
        *count += 1;
        match state(database, beam, *count, table, row) {
            Some(state) => report.beams.push(state),
            None => missing.push(database.full_name(beam)),
        }
    }
    if let Some(first) = missing.first() {
        let rest = if missing.len() > 1 { format!(" and {} more", missing.len() - 1) } else { String::new() };
        return Err(vec![
            Diagnostic::error(
                "beams/not-recorded",
                format!("the results do not hold what goes through `{first}`{rest}"),
            )
            .help("record it with `--beam-loads`, or with everything else by `--all`"),
        ]);
    }
    report.chains = chains(database, &beams);
    Ok(report)
}

/// The row of a table nearest to a time in its unit, the last one without.
fn row(table: &Table, time: Option<f64>, unit: &str) -> Result<usize, Vec<Diagnostic>> {
    let times = table.series.first().map_or(&[][..], |s| s.values.as_slice());
    let (Some(first), Some(last)) = (times.first(), times.last()) else {
        return Err(vec![Diagnostic::error("beams/no-rows", "the results have no rows").help("run the model again")]);
    };
    let Some(time) = time else { return Ok(times.len() - 1) };
    // Half a step beyond an end still means that end.
    let margin = if times.len() > 1 { 0.5 * (last - first) / (times.len() - 1) as f64 } else { 1e-9 };
    if !(first - margin..=last + margin).contains(&time) {
        return Err(vec![
            Diagnostic::error("beams/no-such-time", format!("the results have no time {time} {unit}"))
                .help(format!("they go from {first} to {last} {unit}")),
        ]);
    }
    let distance = |k: &usize| (times[*k] - time).abs();
    Ok((0..times.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or_default())
}

/// One beam; `count` tells which of those that share its short name it is.
fn state(database: &Database, beam: ObjectId, count: usize, table: &Table, row: usize) -> Option<BeamState> {
    let short = &database.object(beam).name;
    let end = if count > 1 { format!("_{count}") } else { String::new() };
    let mut values = [0.0; COLUMNS.len()];
    for (value, (column, _)) in values.iter_mut().zip(COLUMNS) {
        *value = *table.get(&format!("{short}.{column}{end}"))?.values.get(row)?;
    }
    let [n, vy, vz, tj, myj, mzj, ti, myi, mzi, angle, energy, power, residual] = values;
    let section = beam::lower::section(database, beam);
    let units = database.units();
    Some(BeamState {
        name: database.full_name(beam),
        length: section.length / units.factor(Dimension::LENGTH),
        stretching: section.e * section.area / units.factor(Dimension::FORCE),
        force: [n, vy, vz],
        moments: [[tj, myj, mzj], [ti, myi, mzi]],
        angle,
        energy,
        power,
        residual,
    })
}

/// The part that a marker is on.
fn part_of(database: &Database, marker: Option<ObjectId>) -> Option<ObjectId> {
    let mut next = marker;
    while let Some(id) = next {
        let object = database.get(id)?;
        if object.class.is("body") {
            return Some(id);
        }
        next = object.parent;
    }
    None
}

/// Puts beams in the order in which they follow one another. A chain begins where no beam precedes, in the
/// order of creation; a ring begins with its first beam.
fn chains(database: &Database, beams: &[ObjectId]) -> Vec<Vec<ChainLink>> {
    let ends: Vec<[Option<ObjectId>; 2]> = beams
        .iter()
        .map(|&beam| {
            let [i, j] = beam::lower::ends(database, beam);
            [j, i].map(|marker| part_of(database, marker))
        })
        .collect();
    let mut at_part: BTreeMap<ObjectId, Vec<(usize, usize)>> = BTreeMap::new();
    for (beam, ends) in ends.iter().enumerate() {
        for (end, part) in ends.iter().enumerate() {
            if let Some(part) = part {
                at_part.entry(*part).or_default().push((beam, end));
            }
        }
    }
    // The beam and its end that follow behind an end of a beam.
    let next = |beam: usize, end: usize| -> Option<(usize, usize)> {
        let part = ends[beam][end]?;
        let here = at_part.get(&part)?;
        let other = here.iter().find(|(b, _)| *b != beam)?;
        (here.len() == 2 && database.object(part).class.id != "ground").then_some(*other)
    };
    let mut left: BTreeSet<usize> = (0..beams.len()).collect();
    let mut chains = Vec::new();
    let mut follow = |first: usize, from: usize, left: &mut BTreeSet<usize>| {
        let (mut chain, mut place) = (Vec::new(), Some((first, from)));
        while let Some((beam, enters)) = place.filter(|(beam, _)| left.remove(beam)) {
            chain.push(ChainLink { beam, reversed: enters == 1 });
            place = next(beam, 1 - enters);
        }
        chains.push(chain);
    };
    for beam in 0..beams.len() {
        // From J if the chain begins there, else from I.
        let begins = (0..2).find(|&end| next(beam, end).is_none());
        if let (Some(from), true) = (begins, left.contains(&beam)) {
            follow(beam, from, &mut left);
        }
    }
    while let Some(&beam) = left.first() {
        follow(beam, 0, &mut left);
    }
    chains
}
