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
            for argument in &statement.arguments {
                self.unit(argument, &mut units);
            }
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

    fn unit(&mut self, argument: &Argument, units: &mut UnitSystem) {
        let value = argument.value(self.text);
        let wanted = match argument.keyword.as_str() {
            "FORCE" => Dimension::FORCE,
            "MASS" => Dimension::MASS,
            "LENGTH" => Dimension::LENGTH,
            "TIME" => Dimension::TIME,
            "UCF" => {
                if let Some(factor) = self.list(argument).and_then(|list| list.first().map(|(n, _)| n.value)) {
                    units.consistency_factor = Some(factor);
                }
                return;
            }
            "SYSTEM" => {
                let system = match value.to_ascii_uppercase().as_str() {
                    "CGS" => UnitSystem::named("cm", "gram", "second", "dyne", "degrees"),
                    "FPS" => UnitSystem::named("foot", "slug", "second", "pound_force", "degrees"),
                    "IPS" => UnitSystem::named("inch", "pound_mass", "second", "pound_force", "degrees"),
                    "MKS" => UnitSystem::named("meter", "kg", "second", "newton", "degrees"),
                    // Values without units: what makes the factor 1 stands for them.
                    "NONE" => {
                        let message = "values without units are shown in meter, kg, newton and second";
                        let note = Diagnostic::new(Severity::Note, "dataset/without-units", message);
                        self.report(note.at(argument.span, "the consistency factor is 1"));
                        UnitSystem::named("meter", "kg", "second", "newton", "degrees")
                    }
                    _ => return self.unknown_word(argument, &value, &["CGS", "FPS", "IPS", "MKS", "NONE"]),
                };
                if let Ok(system) = system {
                    *units = system;
                }
                return;
            }
            _ => return,
        };
        let named = unit_words::unit_of_word(&value).and_then(UnitName::find).filter(|unit| unit.dimension == wanted);
        match named {
            Some(unit) if wanted == Dimension::FORCE => units.force = unit,
            Some(unit) if wanted == Dimension::MASS => units.mass = unit,
            Some(unit) if wanted == Dimension::LENGTH => units.length = unit,
            Some(unit) => units.time = unit,
            None => self.unknown_word(argument, &value, &unit_words::words_of_units(wanted)),
        }
    }
}
