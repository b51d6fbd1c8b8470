//! The units of a dataset: from UNITS, or those in force where it does not tell them.

use schema::{Dimension, UnitName, UnitSystem};
use text::{Diagnostic, Severity, Span};

use super::{
    Builder,
    statement::{Argument, Statement},
};
use crate::unit_words;

impl Builder<'_> {
    /// Puts the units of the dataset in force.
    pub(super) fn units(&mut self, all: &[Statement], in_force: UnitSystem) {
        let mut units = in_force;
        units.angle = UnitName::find("degrees").unwrap_or(units.angle);
        let mut given = all.iter().filter(|s| s.name == "UNITS" && !s.inactive);
        if let Some(statement) = given.next() {
            // A unit that is named stands above what SYSTEM says, whichever comes first.
            if let Some(argument) = statement.argument("SYSTEM") {
                self.system(argument, &mut units);
            }
            for argument in &statement.arguments {
                self.unit(argument, &mut units);
            }
            self.above_system(statement);
            self.untold(statement, &units);
        } else {
            // The solver takes such values as they are: force = mass * acceleration.
            let missing = format!(
                "the dataset has no UNITS: values are taken in {}, {}, {} and {}, with a consistency factor of {}",
                units.length.name,
                units.mass.name,
                units.force.name,
                units.time.name,
                units.consistency_factor()
            );
            let at = Span::new(self.file, 0, 0);
            let help = "add UNITS, or give the units with the command that reads it";
            self.report(Diagnostic::warning("dataset/no-units", missing).at(at, "not told").help(help));
        }
        for again in given {
            let second = Diagnostic::error("dataset/second-units", "there is a second UNITS");
            self.report(second.at(again.head, "left out").help("remove one of them"));
        }
        self.database.set_units(UnitSystem { angle: UnitName::find("radians").unwrap_or(units.angle), ..units });
        self.radians = self.database.settings().units;
        self.database.set_units(units);
        self.degrees = self.database.settings().units;
    }

    /// Names the units that UNITS leaves open. None are open where a system or a factor is given alone.
    fn untold(&mut self, statement: &Statement, units: &UnitSystem) {
        let units = unit_words::arguments(units);
        let given = |keyword: &str| statement.argument(keyword).is_some();
        let alone = units.iter().all(|(keyword, _)| !given(keyword)) && given("UCF");
        if alone || given("SYSTEM") {
            return;
        }
        let open: Vec<_> = units.iter().filter(|(keyword, _)| !given(keyword)).collect();
        if open.is_empty() {
            return;
        }
        let names: Vec<_> = open.iter().map(|(keyword, _)| *keyword).collect();
        let taken: Vec<_> = open
            .iter()
            .map(|(keyword, unit)| format!("{keyword} = {}", unit_words::solver_unit(unit.name).unwrap_or(unit.name)))
            .collect();
        let message = format!("UNITS does not tell {}: taken is `{}`", names.join(", "), taken.join(", "));
        let missing = Diagnostic::warning("dataset/missing-units", message);
        self.report(missing.at(statement.head, "not told").help("add what is right"));
    }

    /// Says of units that are named beside a system that they count.
    fn above_system(&mut self, statement: &Statement) {
        let Some(system) = statement.argument("SYSTEM") else { return };
        let named = |argument: &&Argument| ["FORCE", "MASS", "LENGTH", "TIME"].contains(&argument.keyword.as_str());
        let named: Vec<_> = statement.arguments.iter().filter(named).collect();
        let Some(first) = named.first() else { return };
        let words: Vec<_> = named.iter().map(|argument| format!("`{}`", argument.keyword)).collect();
        let message = format!("UNITS gives SYSTEM and {}: the system tells what is not named", words.join(", "));
        let both = Diagnostic::warning("dataset/units-twice", message).at(first.span, "this one counts");
        self.report(
            both.label(system.span, "the rest follows from it")
                .help("give either SYSTEM, or FORCE, MASS, LENGTH and TIME"),
        );
    }

    /// The units of a system that has a name.
    fn system(&mut self, argument: &Argument, units: &mut UnitSystem) {
        let Some((word, at)) = self.only(argument) else { return };
        let system = match word.to_ascii_uppercase().as_str() {
            "CGS" => UnitSystem::named("cm", "gram", "second", "dyne", "degrees"),
            "FPS" => UnitSystem::named("foot", "pound_mass", "second", "pound_force", "degrees"),
            "IPS" => UnitSystem::named("inch", "pound_mass", "second", "pound_force", "degrees"),
            "MKS" => UnitSystem::named("meter", "kg", "second", "newton", "degrees"),
            // Values without units: what makes the factor 1 stands for them.
            "NONE" => {
                let message = "values without units are shown in meter, kg, newton and second";
                let note = Diagnostic::new(Severity::Note, "dataset/without-units", message);
                self.report(note.at(argument.span, "the consistency factor is 1"));
                UnitSystem::named("meter", "kg", "second", "newton", "degrees")
            }
            _ => return self.unknown_word(argument, (word, at), &["CGS", "FPS", "IPS", "MKS", "NONE"]),
        };
        if let Ok(system) = system {
            *units = system;
        }
    }

    fn unit(&mut self, argument: &Argument, units: &mut UnitSystem) {
        let wanted = match argument.keyword.as_str() {
            "FORCE" => Dimension::FORCE,
            "MASS" => Dimension::MASS,
            "LENGTH" => Dimension::LENGTH,
            "TIME" => Dimension::TIME,
            "UCF" => {
                let Some([factor]) = self.exactly::<1>(argument) else { return };
                if factor > 0.0 {
                    units.consistency_factor = Some(factor);
                } else {
                    let message = format!("`UCF` is {factor}: it must be greater than 0");
                    let outside = Diagnostic::error("dataset/outside", message).at(argument.span, "outside");
                    self.report(outside.help("give mass times acceleration over force, in the units of the dataset"));
                }
                return;
            }
            _ => return,
        };
        let Some((word, at)) = self.only(argument) else { return };
        let named = unit_words::unit_of_word(word).and_then(UnitName::find).filter(|unit| unit.dimension == wanted);
        match named {
            Some(unit) if wanted == Dimension::FORCE => units.force = unit,
            Some(unit) if wanted == Dimension::MASS => units.mass = unit,
            Some(unit) if wanted == Dimension::LENGTH => units.length = unit,
            Some(unit) => units.time = unit,
            None => match unit_words::meant(word, wanted) {
                // The short name of commands is none here.
                Some(meant) => {
                    let span = self.span(&at);
                    let message = format!("`{}` cannot be `{word}`", argument.keyword);
                    let wrong = Diagnostic::error("dataset/unknown-word", message).at(span, "not known");
                    self.report(wrong.fix(format!("did you mean `{meant}`?"), span, meant));
                }
                None => self.unknown_word(argument, (word, at), &unit_words::words_of_units(wanted)),
            },
        }
    }
}
