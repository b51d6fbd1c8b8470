//! Units of datasets: what is taken where they are not told.

use flexure::{Analysis, Outputs, Session, SimulationOptions};

use super::{Desk, quiet};

/// A mass that a force pushes along z, both 1.
const PUSHED: &str = "PART/1, GROUND\nMARKER/1, PART=1\nPART/2, MASS=1, CM=2, IP=1,1,1\nMARKER/2, PART=2\n\
    SFORCE/1, I=2, J=1, ACTIONONLY, TRANSLATIONAL, FUNCTION=1\nREQUEST/1, F2=DZ(2,1)\\\nEND\n";

/// The codes and messages with which a session reads that text behind a title.
fn reads(session: &mut Session, text: &str) -> Vec<(&'static str, String)> {
    let desk = Desk::new();
    let report = session.read(&desk.put("m.adm", &format!("title\n{text}")));
    assert_eq!(report.failed, 0, "{text}\n{}", session.render(&report.diagnostics, false));
    report.diagnostics.into_iter().map(|d| (d.code, d.message)).collect()
}

/// Closed form: s = F t^2 / (2 m) where the consistency factor is 1; F UCF in place of F where it is not.
#[test]
fn without_units_the_consistency_factor_is_one() {
    for (units, factor) in [
        ("", 1.0),
        ("UNITS/SYSTEM=NONE\n", 1.0),
        ("UNITS/LENGTH=METER\n", 1.0),
        ("UNITS/UCF=2\n", 2.0),
        ("UNITS/SYSTEM=MKS, LENGTH=MILLIMETER\n", 1000.0),
        ("UNITS/LENGTH=MILLIMETER, SYSTEM=MKS\n", 1000.0),
        // Newton's law by definition of the pound-force: the pound mass falls with 32.174049 feet/s2.
        ("UNITS/SYSTEM=FPS\n", 9.806_65 / 0.3048),
    ] {
        let mut session = Session::new();
        reads(&mut session, &format!("{units}{PUSHED}"));
        let analysis = Analysis::Dynamic { end: 1.0, outputs: Outputs::Steps(10) };
        let run = session.simulate(&SimulationOptions::new(analysis)).unwrap_or_else(|e| panic!("{e:#?}"));
        let way = run.table.series.iter().find(|s| s.name.ends_with("F2")).and_then(|s| s.values.last().copied());
        let way = way.unwrap_or_else(|| panic!("{:?}", run.table.series.iter().map(|s| &s.name).collect::<Vec<_>>()));
        // The error an integrator allows.
        assert!((way / (0.5 * factor) - 1.0).abs() < 1e-3, "{units}: {way}");
    }
}

#[test]
fn what_units_does_not_tell_is_named_with_what_is_taken() {
    let taken = |units: &str| reads(&mut quiet(), &format!("{units}PART/1, GROUND\nEND\n"));
    assert_eq!(
        taken(""),
        [(
            "dataset/no-units",
            "the dataset has no UNITS: values are taken in meter, kg, newton and second, with a consistency factor of 1"
                .to_string()
        )]
    );
    assert_eq!(
        taken("UNITS/LENGTH=FOOT, TIME=SECOND\n"),
        [(
            "dataset/missing-units",
            "UNITS does not tell FORCE, MASS: taken is `FORCE = NEWTON, MASS = KILOGRAM`".to_string()
        )]
    );
    assert_eq!(taken("UNITS/\n").len(), 1);
    for whole in ["UNITS/UCF=1\n", "UNITS/SYSTEM=IPS\n", "UNITS/FORCE=DYNE,MASS=GRAM,LENGTH=CENTIMETER,TIME=SECOND\n"] {
        assert_eq!(taken(whole), [], "{whole}");
    }
    assert_eq!(taken("UNITS/SYSTEM=NONE\n")[0].0, "dataset/without-units");
}

/// A unit that is named counts beside a system, wherever it stands; a factor is one number above zero.
#[test]
fn units_that_contradict_or_say_nothing_are_named() {
    let said = |units: &str| {
        let desk = Desk::new();
        let mut session = quiet();
        let report = session.read(&desk.put("m.adm", &format!("t\n{units}\nPART/1, GROUND\nEND\n")));
        let under = |d: &text::Diagnostic| session.sources().slice(d.primary.as_ref().unwrap().span).to_string();
        let found: Vec<_> = report.diagnostics.iter().map(|d| (d.code, under(d), d.message.clone())).collect();
        (found, session.database().units().length.name, session.database().units().consistency_factor())
    };
    for units in ["UNITS/LENGTH=INCH, SYSTEM=MKS", "UNITS/SYSTEM=MKS, LENGTH=INCH"] {
        let (found, length, _) = said(units);
        let [(code, under, message)] = &found[..] else { panic!("{found:?}") };
        assert_eq!((*code, under.as_str(), length), ("dataset/units-twice", "LENGTH=INCH", "inch"), "{units}");
        assert!(message.contains("SYSTEM and `LENGTH`"), "{message}");
    }
    for (given, code, under) in [
        ("UCF=", "dataset/count", "UCF"),
        ("UCF=1,2", "dataset/count", "UCF=1,2"),
        ("UCF=0", "dataset/outside", "UCF=0"),
        ("UCF=-1", "dataset/outside", "UCF=-1"),
        ("LENGTH=", "dataset/count", "LENGTH"),
        ("LENGTH=METER,INCH", "dataset/count", "LENGTH=METER,INCH"),
        ("LENGTH=MM", "dataset/unknown-word", "MM"),
        ("SYSTEM=MSK", "dataset/unknown-word", "MSK"),
    ] {
        let (found, _, factor) = said(&format!("UNITS/FORCE=NEWTON,MASS=KILOGRAM,TIME=SECOND,{given}"));
        assert!(found.iter().any(|(c, u, _)| *c == code && u == under), "{given}: {found:?}");
        assert!((factor - 1.0).abs() < 1e-12, "{given}: {factor}");
    }
}

/// Twin: the same file in sessions whose units differ.
#[test]
fn a_file_is_one_model_in_all_sessions() {
    for units in ["", "UNITS/LENGTH=METER\n", "UNITS/SYSTEM=NONE\n", "UNITS/UCF=2\n"] {
        let desk = Desk::new();
        let mut texts = Vec::new();
        for before in ["", "defaults units length = foot force = dyne mass = slug time = minute angle = rad\n"] {
            let mut session = quiet();
            session.execute(before);
            reads(&mut session, &format!("{units}{PUSHED}"));
            texts.push(desk.written(&mut session, "m.cmd"));
        }
        assert_eq!(texts[0], texts[1], "{units}");
    }
}
