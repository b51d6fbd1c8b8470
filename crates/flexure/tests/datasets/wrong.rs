//! What is wrong with a dataset is named with its place and its mending, and the rest is read.

use super::{Desk, quiet};

/// A ground with two markers, and whatever follows.
const HEAD: &str = "Adams View model name: m\nUNITS/\n, SYSTEM = MKS\nPART/1\n, GROUND\nMARKER/1\n, PART = 1\nMARKER/2\n, PART = 1\nPART/2\n, MASS = 1\nMARKER/3\n, PART = 2\n";

/// Codes with the text they underline, in order, and what is said with the first one.
fn troubles(text: &str) -> (Vec<(&'static str, String)>, String) {
    let desk = Desk::new();
    let path = desk.put("m.adm", &format!("{HEAD}{text}"));
    let mut session = quiet();
    let report = session.read(&path);
    let sources = session.sources();
    let found = report.diagnostics.iter().map(|d| {
        let under = d.primary.as_ref().map(|label| sources.slice(label.span).to_string());
        (d.code, under.unwrap_or_default())
    });
    let found: Vec<_> = found.collect();
    // The part and its marker are there whatever else is wrong.
    assert!(session.database().find(".m.PART_2.MARKER_3", "marker").is_some(), "{text}");
    let first = report.diagnostics.first().map(|d| {
        let helps = d.helps.iter().map(|help| help.text.as_str());
        let labels = d.primary.iter().map(|label| label.text.as_str());
        std::iter::once(d.message.as_str())
            .chain(labels)
            .chain(helps)
            .chain(d.notes.iter().map(String::as_str))
            .collect::<Vec<_>>()
            .join(" | ")
    });
    (found, first.unwrap_or_default())
}

/// A statement behind [`HEAD`], the one trouble that is named, the text underlined, and something that
/// is said of it.
type Case = (&'static str, &'static str, &'static str, &'static str);

const CASES: &[Case] = &[
    ("BEM/1, I=3, J=1", "dataset/unknown-statement", "BEM", "did you mean `BEAM`?"),
    ("MA/4, PART = 1", "dataset/ambiguous-statement", "MA", "`MARKER`"),
    ("hello world", "dataset/not-a-statement", "hello world", "a name and a slash"),
    ("MARKER/4, PART = 1, LOCATON = 1", "dataset/unknown-argument", "LOCATON", "MARKER has no argument `LOCATON`"),
    ("JOINT/1, REVOLUTE, I=3, J=1, PICH = 2", "dataset/unknown-argument", "PICH", "did you mean `PITCH`?"),
    ("JOINT/1, REVOLTE, I=3, J=1", "dataset/unknown-argument", "REVOLTE", "did you mean `REVOLUTE`?"),
    ("JOINT/1, I=3, J=1", "dataset/no-kind", "JOINT/1", "REVOLUTE"),
    ("MARKER/4, PART = 1, V = 1", "dataset/ambiguous-argument", "V", "`VELOCITY`"),
    ("MARKER/4, PART = 9", "dataset/unknown-id", "9", "there is no PART/9"),
    ("MARKER/4, PART = x", "dataset/reference", "x", "a number was expected"),
    ("MARKER/4, QP = 1, 2, 3", "dataset/missing-argument", "MARKER/4", "`PART` is missing"),
    ("MARKER/, PART = 1", "dataset/no-id", "MARKER/", "MARKER/1"),
    ("MARKER/99999999999, PART = 1", "dataset/id", "99999999999", "2147483647"),
    ("MARKER/2, PART = 1", "dataset/duplicate-id", "MARKER/2", ".m.ground.MARKER_2"),
    ("MARKER/4, PART = 1, QP = 1, 2", "dataset/count", "QP = 1, 2", "takes 3 values, not 2"),
    ("MARKER/4, PART = 1, QP = 1, 2, 3D4", "dataset/number", "3D4", "write `3E4`"),
    ("MARKER/4, PART = 1, QP = 1, 2, z", "dataset/number", "z", "a number was expected"),
    ("MARKER/4, PART = 1, ZP = 0, 0, 0", "dataset/no-direction", "ZP = 0, 0, 0", "no direction"),
    ("MARKER/4, PART = 1, QP = 1,0,0, QP = 2,0,0", "dataset/repeated-argument", "QP", "this one counts"),
    ("MARKER/4, PART = 1, VM = 2", "dataset/argument-not-read", "VM = 2", "no place for it"),
    ("MARKER/4, FLEX_BODY = 1", "dataset/statement-not-read", "FLEX_BODY = 1", "flexible"),
    ("FE_PART/1, TYPE = 3DBEAM", "dataset/statement-not-read", "FE_PART", "is not read"),
    ("GRAPHICS/1, TORUS, CM = 1", "dataset/shape-not-read", "GRAPHICS/1", "`TORUS`"),
    ("GRAPHICS/1, CIRCLE, RADIUS = 1", "dataset/missing-argument", "GRAPHICS/1", "marker"),
    ("PART/3, GROUND", "dataset/second-ground", "PART/3", "one ground"),
    ("UNITS/MASS=GRAM", "dataset/second-units", "UNITS/", "second"),
    ("VFORCE/1, I=3, JFLOAT=1, RM=1, FX=1", "dataset/wrong-kind", "1", "MARKER/1 is a marker"),
    (
        "BEAM/1,I=3,J=1,LENGTH=1,IXX=1,IYY=1,IZZ=1,AREA=1,EMODULUS=1,GMODULUS=1,FORMULATION=STRNG",
        "dataset/unknown-word",
        "STRNG",
        "did you mean `STRING`?",
    ),
    (
        "BEAM/1,I=3,J=1,LENGTH=-2,IXX=1,IYY=1,IZZ=1,AREA=1,EMODULUS=1,GMODULUS=1",
        "dataset/outside",
        "-2",
        "greater than 0",
    ),
    ("BEAM/1,I=3,J=1,IXX=1,IYY=1,IZZ=1,AREA=1,EMODULUS=1,GMODULUS=1", "dataset/missing-argument", "BEAM/1", "LENGTH"),
    ("SFORCE/1, ROTATION, I=3, J=1, FUNCTION = 2*AZ(3,\n, 12)", "dataset/unknown-id", "12", "there is no MARKER/12"),
    (
        "GFORCE/1, I=3, JFLOAT=4, RM=1, FUNCTION = 3\nMARKER/4, PART=1, FLOATING",
        "dataset/function",
        "FUNCTION = 3",
        "USER",
    ),
    (
        "!  adams_view_name='off'\n!JOINT/1, REVOLUTE, I=77, J=1\nMARKER/4, PART=1",
        "dataset/inactive-not-read",
        "JOINT/1",
        "behind comment marks",
    ),
    ("!  adams_view_name='x'\n!UNITS/LENGTH=MM\n!", "dataset/inactive-not-read", "UNITS/", "behind comment marks"),
    ("!  adams_view_name='x'\n!INTEGRATOR/HHT\n!", "dataset/inactive-not-read", "INTEGRATOR/", "behind comment marks"),
    ("!  adams_view_name='x'\n!PART/7, GROUND\n!", "dataset/inactive-not-read", "PART/7", "behind comment marks"),
    ("INTEGRATOR/SI1", "dataset/argument-not-read", "SI1", "`INTEGRATOR/GSTIFF, SI1`"),
    ("INTEGRATOR/GSTIFF, WSTIFF", "dataset/argument-not-read", "GSTIFF", "not read"),
    ("INTEGRATOR/GSTIFF\nINTEGRATOR/ERROR=1", "dataset/second-setting", "INTEGRATOR/", "the last one counts"),
    ("EQUILIBRIUM/ERROR=2\nEQUILIBRIUM/ERROR=1", "dataset/second-setting", "EQUILIBRIUM/", "the last one counts"),
    ("END\nPART/9, MASS=1", "dataset/behind-end", "PART/9, MASS=1", "move END behind them"),
    ("END\nin/out\n  BEAM/1 ! beam\nM/1\nVAR/2, IC=1", "dataset/behind-end", "BEAM/1 ! beam", "2 statements"),
    ("SPLINE/1, X=1,2,3,4, Y=1,2,3\nEND\n", "dataset/count", "Y=1,2,3", "takes 4 values, not 3"),
    (
        "SPLINE/1, X = 1,2,3,4, Y = 0,1,2,3,4, Y = 1,4,5,6, Y = 2,9,8,7,6",
        "dataset/count",
        "Y = 1,4,5,6",
        "takes 5 values, not 4",
    ),
    ("CONTACT/1, POISSON, PENALTY=1, IMPACT", "dataset/contradiction", "IMPACT", "remove `POISSON` or `IMPACT`"),
    ("CONTACT/1, PENALTY=1, IMPACT, STIFFNESS=1", "dataset/contradiction", "PENALTY", "CONTACT/1 has `IMPACT`"),
    ("CONTACT/1, IMPACT, DMAX=1", "dataset/missing-argument", "CONTACT/1", "`STIFFNESS` is missing"),
    ("CONTACT/1, POISSON", "dataset/missing-argument", "CONTACT/1", "`PENALTY` is missing"),
    ("CONTACT/1, STIFFNESS=1", "dataset/no-kind", "CONTACT/1", "IMPACT, POISSON, NORMAL_FUNCTION"),
    ("CURVE/1, CONTROL_POINTS, CURVE_POINTS", "dataset/contradiction", "CURVE_POINTS", "`CONTROL_POINTS`"),
    ("CURVE/1, OPEN, CLOSED", "dataset/contradiction", "CLOSED", "remove `OPEN` or `CLOSED`"),
    ("JOINT/1, FIXED, REVOLUTE, I=3, J=1", "dataset/contradiction", "REVOLUTE", "JOINT/1 has `FIXED`"),
    ("JPRIM/1, INLINE, INPLANE, I=3, J=1", "dataset/contradiction", "INPLANE", "one excludes the other"),
    ("MARKER/4, PART=1, POINT_MASS=2", "dataset/contradiction", "POINT_MASS", "remove `PART`"),
    ("MARKER/4, PART=1, REULER=0,0,1, ZP=0,0,1", "dataset/contradiction", "ZP", "remove `REULER`"),
    ("SFORCE/1, ROTA, TRANS, I=3, J=1, FUNCTION=1", "dataset/contradiction", "TRANS", "`ROTATIONAL`"),
    ("SPRINGDAMPER/1, ROTA, I=3, J=1, K=2, C=1", "dataset/contradiction", "K", "`K`, `C`"),
    ("MOTION/1, I=3, J=1, X, Y, FUNCTION=1", "dataset/contradiction", "Y", "MOTION/1 has `X` and `Y`"),
    ("MATRIX/1, FULL=RORDER, ROWS=1, COLUMNS=1, VALUES=1, SPARSE", "dataset/contradiction", "SPARSE", "`FULL`"),
    ("MATRIX/1, FULL=Q, ROWS=1, COLUMNS=1, VALUES=1", "dataset/unknown-word", "Q", "RORDER, CORDER"),
    (
        "JOINT/1, REVOLUTE, I=3, J=1\nJOINT/2, CYLINDRICAL, I=3, J=2\nCOUPLER/1, JOINTS=1,2, TYPE=R:RUT, SCALES=2",
        "dataset/unknown-word",
        "RUT",
        "cannot be `RUT`",
    ),
    (
        "JOINT/1, REVOLUTE, I=3, J=1\nJOINT/2, CYLINDRICAL, I=3, J=2\nCOUPLER/1, JOINTS=1,2, TYPE=R, SCALES=2",
        "dataset/count",
        "TYPE=R",
        "one for each joint",
    ),
    (
        "JOINT/1, REVOLUTE, I=3, J=1\nJOINT/2, CYLINDRICAL, I=3, J=2\nCOUPLER/1, JOINTS=1,2, TYPE=R:T, SCALES=1,2,3",
        "dataset/count",
        "SCALES=1,2,3",
        "takes 1 or 2 values, not 3",
    ),
    (
        "JOINT/1, REVOLUTE, I=3, J=1\nJOINT/2, CYLINDRICAL, I=3, J=2\nCOUPLER/1, JOINTS=1,2, TYPE=R:T",
        "dataset/missing-argument",
        "COUPLER/1",
        "`SCALES` is missing",
    ),
    (
        "JOINT/1, REVOLUTE, I=3, J=1\nJOINT/2, CYLINDRICAL, I=3, J=2\nCOUPLER/1, JOINTS=1,2, SCALES=2, FUNC=USER(1)",
        "dataset/contradiction",
        "FUNC",
        "remove `SCALES`",
    ),
    ("MARKER/4\n PART = 1\n, QP = 1,2,3", "dataset/missing-comma", "PART", "write `, PART`"),
    ("MARKER/4, PART = 1,\nQP = 1,2,3", "dataset/missing-comma", "QP", "begins with a comma"),
    ("MARKER/4, PART = 1, &\nQP = 1,2,3", "dataset/missing-comma", "QP", "`&` is for command files"),
    ("MARKER/4, PART = 1, QP = 1,\n2,3", "dataset/missing-comma", "2", "write `, 2`"),
    ("MARKER/4, PART = 1 QP = 1,2,3", "dataset/missing-comma", "QP", "no comma before `QP`"),
    ("REQUEST/1, F2 = DX(3,1) F3 = TIME", "dataset/missing-comma", "F3", "write `, F3`"),
    ("MARKER/4, PART = 1, QP = 1 2 3", "dataset/number", "1 2 3", "commas: `1, 2, 3`"),
    ("JOINT/1, FIXED, I = 3 1, J = 2", "dataset/reference", "3 1", "commas: `3, 1`"),
    ("MARKER/-4, PART = 1", "dataset/id", "-4", "whole number"),
    ("MARKER/4.5, PART = 1", "dataset/id", "4.5", "whole number"),
    ("MARKER/4x, PART = 1", "dataset/id", "4x", "whole number"),
    ("MARKER 4, PART = 1", "dataset/not-a-statement", "MARKER 4, PART = 1", "write `MARKER/`"),
    ("MARKER/4, PART = 1, 2", "dataset/count", "PART = 1, 2", "takes 1 value, not 2"),
    ("VARIABLE/1, FUNCTION =", "dataset/count", "FUNCTION", "nothing is given"),
    ("VARIABLE/1, IC = 1", "dataset/missing-argument", "VARIABLE/1", "`FUNCTION` is missing"),
    ("MOTION/1, FUNCTION = 1", "dataset/missing-argument", "MOTION/1", "drives nothing"),
    ("MOTION/1, I=3, J=1, FUNCTION = 1", "dataset/no-kind", "MOTION/1", "X, Y, Z, B1, B2, B3"),
    ("REQUEST/1, I=3, J=1", "dataset/no-kind", "REQUEST/1", "DISPLACEMENT, VELOCITY"),
    ("REQUEST/1, FORCE", "dataset/missing-argument", "REQUEST/1", "`I` is missing"),
    ("SFORCE/1, I=3, J=1, FUNCTION=1", "dataset/kind-taken", "SFORCE/1", "taken is `TRANSLATIONAL`"),
    ("SPRINGDAMPER/1, I=3, J=1, K=1", "dataset/kind-taken", "SPRINGDAMPER/1", "taken is `TRANSLATIONAL`"),
    ("GFORCE/1, I=3, JFLOAT=4\nMARKER/4, PART=1, FLOATING", "dataset/missing-argument", "GFORCE/1", "FX, FY, FZ"),
    ("PART/3, MASS=1, IP=1,2", "dataset/count", "IP=1,2", "3 or 6 values, not 2"),
    ("JOINT/1, REVOLUTE, I=3, J=1, IC=1,2,3", "dataset/count", "IC=1,2,3", "1 or 2 values, not 3"),
    ("MATRIX/1, SPARSE, ENTRIES=1,1", "dataset/count", "ENTRIES=1,1", "three for each entry"),
    ("PART/3, MASS=1D", "dataset/degrees", "1D", "exponent with `E`"),
    ("ACCGRAV/KGRAV=-1\nACCGRAV/KGRAV=-2", "dataset/second-setting", "ACCGRAV/", "the last one counts"),
    ("ACCGRAV/1, KGRAV=-1", "dataset/number-not-read", "1", "write `ACCGRAV/`"),
    ("INTEGRATOR/3, GSTIFF", "dataset/number-not-read", "3", "INTEGRATOR has no number"),
    ("EQUILIBRIUM/MAXIT=2.5", "dataset/number", "2.5", "a whole number"),
    ("GRAPHICS/1, BOX, CORNER=1, X=1, Y=1", "dataset/missing-argument", "GRAPHICS/1", "`Z` is missing"),
    ("GRAPHICS/1, CIRCLE, CM=1", "dataset/missing-argument", "GRAPHICS/1", "`RADIUS` is missing"),
    ("GRAPHICS/1, FORCE, EMARKER=1, ETYPE=BEAM", "dataset/missing-argument", "GRAPHICS/1", "`EID` is missing"),
    ("MATRIX/1, FULL=R, ROWS=2, COLUMNS=2, VALUES=1,2,3", "dataset/count", "VALUES=1,2,3", "2 times 2 values"),
    ("SPLINE/1, X=1,2,2,3, Y=1,2,3,4", "dataset/not-rising", "2", "rise from value to value"),
    ("REQUEST/1, CNAMES = \"a, b, F2 = TIME", "dataset/open-quote", "\"a, b, F2 = TIME", "opened and not closed"),
    ("VARIABLE/1, FUNCTION = USER(1,,2)", "dataset/number", "FUNCTION = USER(1,,2)", "needs a number, not ``"),
    ("PART/3, EXACT=X:Q", "dataset/unknown-word", "Q", "PSI"),
    (
        "!  adams_view_name='x'\nMARKER/4, PART=1\n!  adams_view_name='X'\nMARKER/5, PART=1",
        "dataset/name-taken",
        "MARKER/5",
        "X_2",
    ),
];

#[test]
fn every_trouble_is_named_where_it_is() {
    let mut wrong = Vec::new();
    for (text, code, under, says) in CASES {
        let (found, said) = troubles(&format!("{text}\nEND\n"));
        let expected = matches!(&found[..], [(c, u)] if c == code && u == under);
        if !expected || !said.contains(says) {
            wrong.push(format!("{text}: {found:?} {said}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn what_is_missing_from_the_file_is_named() {
    let codes = |text: &str| -> Vec<&'static str> {
        let desk = Desk::new();
        let mut session = quiet();
        session.read(&desk.put("m.adm", text)).diagnostics.iter().map(|d| d.code).collect()
    };
    assert_eq!(codes("t\nUNITS/SYSTEM=MKS\nPART/1, GROUND\n"), ["dataset/missing-end"]);
    assert_eq!(codes("t\nPART/1, GROUND\nEND\n"), ["dataset/no-units"]);
    assert_eq!(codes("t\nUNITS/SYSTEM=MKS\nPART/2, MASS=1\nEND\n"), ["dataset/no-ground"]);
    assert_eq!(codes("PART/1, GROUND\nUNITS/SYSTEM=MKS\nEND\n"), ["dataset/statement-as-title", "dataset/no-ground"]);
    // A file of another kind is told once, not line by line.
    assert_eq!(codes("<html>\n<body>\n<p>\n</p>\n</body>\n</html>\n"), ["dataset/empty"]);
    // Lines of old systems end with a carriage return alone.
    assert_eq!(codes("t\rUNITS/SYSTEM=MKS\rPART/1, GROUND\r"), ["dataset/missing-end"]);
    assert_eq!(codes("t\n, A = 1\nEND\n"), ["dataset/stray-continuation", "dataset/empty"]);
    assert_eq!(codes(""), ["dataset/missing-end", "dataset/empty"]);
    assert_eq!(
        codes("t\nUNITS/SYSTEM=MKS\n!  adams_view_name='world'\nPART/1, GROUND\nEND\n"),
        ["dataset/ground-name"]
    );
    assert_eq!(
        codes("t\nUNITS/LENGTH=METRE,MASS=GRAM,TIME=DAY,FORCE=DYNE\nPART/1, GROUND\nEND\n"),
        ["dataset/unknown-word"]
    );
    assert_eq!(
        codes(
            "t\nUNITS/SYSTEM=MKS\nPART/1, GROUND\nGRAPHICS/1, PLANE, RM = 1\nCONTACT/1, IGEOM=1, JGEOM=1, IMPACT, STIFFNESS=1\nEND\n"
        ),
        ["dataset/shape-not-read", "dataset/refers-to-unread", "dataset/refers-to-unread"]
    );
}

/// What a broken dataset leaves can be looked at; the report says that it is not whole.
#[test]
fn a_broken_statement_leaves_the_rest() {
    let desk = Desk::new();
    let mut session = quiet();
    let report = session.read(&desk.put("m.adm", &format!("{HEAD}JOINT/1, REVOLUTE, I=3, J=88\nEND\n")));
    assert!(report.has_errors());
    assert_eq!(session.objects("marker").len(), 3);
    assert!(session.undo());
    assert_eq!(session.model(), None);
}

/// What both say of what counts: the settings that two statements give.
#[test]
fn of_two_statements_of_settings_the_last_one_counts() {
    let desk = Desk::new();
    let text = format!(
        "{HEAD}INTEGRATOR/HHT, ERROR=1E-4, HMAX=0.1\nINTEGRATOR/GSTIFF, SI2, ERROR=1E-6\nOUTPUT/REQSAVE\nOUTPUT/GRSAVE\nEND\n"
    );
    let mut session = quiet();
    let report = session.read(&desk.put("m.adm", &text));
    assert_eq!(report.failed, 0);
    let second = report.diagnostics.iter().find(|d| d.code == "dataset/second-setting").unwrap();
    let at = second.primary.as_ref().unwrap().span;
    assert_eq!(session.sources().line_column(at.file, at.start).line, 15);
    let written = desk.written(&mut session, "again.adm");
    let expected = "INTEGRATOR/\n, GSTIFF\n, SI2\n, ERROR = 1.0E-06\n, HMAX = 0.1\n!\n";
    assert!(written.contains(expected), "{written}");
    assert!(written.contains("OUTPUT/\n, REQSAVE\n, GRSAVE\n!\n"), "{written}");
}

/// What is right although it looks odd: speeds of turning in degrees, tabs, comments and blank lines
/// between the lines of a statement, small letters, a number of an object with zeros before it.
#[test]
fn what_is_odd_but_right_is_read_without_a_word() {
    for text in [
        "PART/3, WX = 1D",
        "marker/0004\n! between\n\n\t,\tpart\t=\t02 ! behind\n!\n,qp=1,\n! again\n, 2,3",
        "SFORCE/1,TRAN,I=3,J=1,FUNCTION = STEP(TIME,\n! between\n,\t0,0,1,\n,1)*DX(\t3,\t1)",
        "MARKER/4, PART=1, QP=1,2,3,\n, REULER=0,0,1,",
        "MARKER/4,PART=1;MARKER/5,PART=1",
        "COUPLER/1,JOINTS=1,2,TYPE=Trans:R,SCALES=2\nJOINT/1,TRAN,I=3,J=1\nJOINT/2,CYL,I=3,J=2",
        "VARIABLE/1, IC = 1\\ FUNCTION = 2\\",
        "SPRINGDAMPER/1, ROTATION, I=3, J=1, KT=2",
    ] {
        assert_eq!(troubles(&format!("{text}\nEND\n")).0, [], "{text}");
        assert_eq!(troubles(&format!("{text}\nEND\n").replace('\n', "\r\n")).0, [], "{text}");
    }
}

/// A dataset that a command file names is refused where it is named, before a line of it is run.
#[test]
fn a_dataset_that_commands_read_is_told_once() {
    let desk = Desk::new();
    let path = desk.put("m.adm", &format!("{HEAD}END\n"));
    let name = path.display().to_string();
    let outer =
        desk.put("outer.cmd", &format!("model create model_name = .m\nfile command read file_name = \"{name}\"\n"));
    let mut session = quiet();
    let report = session.read(&outer);
    let [one] = &report.diagnostics[..] else { panic!("{:#?}", report.diagnostics) };
    assert_eq!((one.code, report.failed), ("file/dataset", 1));
    let at = one.primary.as_ref().unwrap().span;
    assert_eq!(session.sources().slice(at), format!("\"{name}\""));
    assert!(one.helps[0].text.contains("file adams_data_set read"), "{:?}", one.helps);
}

/// One complaint about a file of the other kind, and nothing is made of it.
#[test]
fn files_of_the_other_kind_are_told_from_their_text() {
    let desk = Desk::new();
    let commands = "model create model_name = .m\npart create rigid_body name_and_position &\n part_name = .m.p\n";
    for (path, code, help) in [
        (desk.put("a.adm", commands), "dataset/command-file", ".cmd"),
        (desk.put("a.cmd", &format!("{HEAD}END\n")), "file/dataset", ".adm"),
        (desk.put("b.cmd", "! a remark\nPART/1, GROUND\n"), "file/dataset", ".adm"),
    ] {
        let mut session = quiet();
        let report = session.read(&path);
        assert_eq!(report.failed, 1, "{}", path.display());
        let [one] = &report.diagnostics[..] else { panic!("{:#?}", report.diagnostics) };
        assert_eq!(one.code, code);
        assert!(one.helps[0].text.contains(help), "{:?}", one.helps);
        assert_eq!(session.model(), None);
    }
}

/// What is wrong in a function is told where the dataset gives it.
#[test]
fn functions_of_datasets_are_checked_at_their_places() {
    let desk = Desk::new();
    let text = format!("{HEAD}VARIABLE/1\n, FUNCTION = STEP(TIME, 0,\n, 0, 1\nEND\n");
    let mut session = quiet();
    assert_eq!(session.read(&desk.put("m.adm", &text)).failed, 0);
    let [one] = &session.check_functions()[..] else { panic!("{:#?}", session.check_functions()) };
    assert_eq!(one.code, "function/incomplete");
    let at = one.primary.as_ref().unwrap().span;
    assert_eq!(session.sources().slice(at).trim(), "STEP(TIME, 0,\n, 0, 1");
}
