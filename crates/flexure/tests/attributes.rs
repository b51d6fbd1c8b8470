//! Attributes through the facade: what is read can be set, for every class, and a text is a value.

use flexure::{AttributeInput, AttributeValue, Session};
use proptest::prelude::*;
use schema::{Field, Group, Kind, Rule, Use};

/// One object of what others refer to.
const SCENE: &str = "
model create model_name = m
part create rigid_body name_and_position part_name = .m.p location = 100,0,0 orientation = 90,0,0
part create rigid_body name_and_position part_name = .m.q location = 200,0,0
marker create marker_name = .m.p.a location = 110,5,0
marker create marker_name = .m.p.b location = 0,10,0
marker create marker_name = .m.q.c location = 7,0,0
floating_marker create floating_marker_name = .m.q.f
geometry create shape block block_name = .m.p.box corner_marker = .m.p.a diag_corner_coords = 1,2,3
geometry create shape block block_name = .m.q.box corner_marker = .m.q.c diag_corner_coords = 1,2,3
geometry create curve circle circle_name = .m.p.ring center_marker = .m.p.a radius = 3
constraint create joint revolute joint_name = .m.j1 i_marker_name = .m.p.a j_marker_name = .m.q.c
constraint create joint revolute joint_name = .m.j2 i_marker_name = .m.p.b j_marker_name = .m.q.c
force create element_like translational_spring_damper spring_damper_name = .m.spring i_marker_name = .m.p.a j_marker_name = .m.q.c
variable create variable_name = .m.v real_value = 2
data_element create variable variable_name = .m.state function = \"time\"
measure create function measure_name = .m.watched function = \"time\"
";

fn session(commands: &str) -> Session {
    let mut session = Session::new();
    session.touch_nothing(true);
    let report = session.execute(commands);
    assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
    session
}

/// A value an attribute may have, as command text; none if the scene has no such object.
fn example(session: &Session, field: &Field) -> Option<String> {
    let one = match field.kind {
        Kind::Object(_, wanted) => session.objects(wanted).first()?.clone(),
        Kind::Integer => "1".into(),
        // Walls have to fit into what they are of.
        Kind::Real if field.name.contains("thickness") => "0.3".into(),
        Kind::Real | Kind::Any => "1.5".into(),
        Kind::Boolean(_, no) => no.into(),
        Kind::Choice(words) => words[0].into(),
        Kind::Text | Kind::File => "\"odd, text\"".into(),
        Kind::Function => "\"2*time\"".into(),
        Kind::Location | Kind::Orientation => return Some("1.0, 2.0, 3.0".into()),
    };
    Some(vec![one; field.count.least].join(", "))
}

/// A command that makes an object of a class, with no more than it must have.
fn creation(session: &Session, group: &Group, name: &str) -> String {
    let mut given: Vec<&str> = group.fields.iter().filter(|f| f.required).map(|f| f.name).collect();
    for rule in group.rules {
        match rule {
            Rule::OneOf(sets) => given.extend(sets[0]),
            Rule::AtLeastOne(names) => given.extend(&names[..1]),
            Rule::AtMostOne(_) => {}
        }
    }
    let mut text = format!("{} {} = {name}", group.command, group.object);
    for field in group.fields.iter().filter(|f| given.contains(&f.name)) {
        let value = example(session, field).unwrap_or_default();
        text.extend([" ", field.name, " = ", &value]);
    }
    text
}

/// Truth: a value that an attribute has is one that it may have.
#[test]
fn every_attribute_of_every_class_takes_the_value_it_has() {
    let mut troubles = Vec::new();
    let mut set = 0;
    for class in elements::registry().classes {
        let mut session = session(SCENE);
        let object = match class.groups.iter().find(|group| group.creates) {
            _ if class.id == "model" => ".m".to_string(),
            _ if class.id == "ground" => ".m.ground".to_string(),
            Some(group) if !group.object.is_empty() => {
                let below = if class.parents.contains(&"model") { ".m" } else { ".m.p" };
                let name = format!("{below}.new");
                let command = creation(&session, group, &name);
                let report = session.execute(&command);
                if report.has_errors() {
                    troubles.push(format!("{command}\n{}", session.render(&report.diagnostics, false)));
                    continue;
                }
                name
            }
            Some(group) => {
                session.execute(group.command);
                format!(".m.{}", class.id)
            }
            None => {
                troubles.push(format!("{} is not made by a command", class.id));
                continue;
            }
        };
        for field in class.fields().filter(|f| f.usage != Use::Create) {
            let name = field.name;
            let read = |session: &Session| session.attribute(&object, name).map(|a| a.value);
            if read(&session) == Some(AttributeValue::None)
                && let Some(text) = example(&session, field)
            {
                // Not every value fits every object; what does not is not there to be set again.
                let group = class.groups.iter().find(|g| g.fields.iter().any(|f| f.name == name)).unwrap();
                let words = group.command.replace("create", "modify");
                session.execute(&format!("{words} {} = {object} {name} = {text}", group.object));
            }
            let Some(value) = read(&session).filter(|v| *v != AttributeValue::None) else { continue };
            let report = session.modify(&object, &[(name.to_string(), value.clone().into())]);
            set += 1;
            if report.has_errors() {
                let said = session.render(&report.diagnostics, false);
                troubles.push(format!("{}.{name} = {value:?}\n{said}", class.id));
            } else if !same(read(&session).as_ref(), &value) {
                troubles.push(format!("{}.{name} = {value:?} is {:?}", class.id, read(&session)));
            }
        }
    }
    assert!(troubles.is_empty(), "{}", troubles.join("\n"));
    assert!(set > 800, "{set} attributes were set");
}

/// Equal but for the rounding of coordinates that are turned into another frame and back.
fn same(read: Option<&AttributeValue>, value: &AttributeValue) -> bool {
    match (read, value) {
        (Some(AttributeValue::Numbers(a)), AttributeValue::Numbers(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-11 * b.abs().max(1.0))
        }
        (read, value) => read == Some(value),
    }
}

fn text(text: &str) -> AttributeInput {
    AttributeInput::Text(text.to_string())
}

fn texts(session: &Session, object: &str, name: &str) -> AttributeValue {
    session.attribute(object, name).unwrap().value
}

#[test]
fn variables_markers_and_materials_are_modified() {
    let mut session = session(SCENE);
    let set = |session: &mut Session, object: &str, name: &str, value: AttributeInput| {
        let report = session.modify(object, &[(name.to_string(), value)]);
        assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
        session.attribute(object, name).unwrap().value
    };
    assert_eq!(set(&mut session, ".m.v", "real_value", AttributeInput::Integer(3)), AttributeValue::Number(3.0));
    let place = AttributeInput::List([1, 2, 3].map(AttributeInput::Integer).to_vec());
    assert_eq!(set(&mut session, ".m.p.a", "location", place), AttributeValue::Numbers(vec![1.0, 2.0, 3.0]));
    session.execute("material create material_name = .m.mat density = 1 youngs_modulus = 1 poissons_ratio = 0.3");
    assert_eq!(set(&mut session, ".m.mat", "density", AttributeInput::Number(7.8e-6)), AttributeValue::Number(7.8e-6));
}

#[test]
fn a_text_is_a_value_and_no_piece_of_a_command() {
    let mut session = session(SCENE);
    for odd in ["a b", "say \"hi\"", "! x", "a, b", "(1+1)", "c:\\d\\", "&", "a &", "", " ", "x = 1", "'", "$a", "\t"] {
        let report = session.modify(".m.j1", &[("comments".into(), AttributeInput::List(vec![text(odd)]))]);
        assert!(!report.has_errors(), "{odd:?}: {}", session.render(&report.diagnostics, false));
        assert_eq!(texts(&session, ".m.j1", "comments"), AttributeValue::Texts(vec![odd.into()]), "{odd:?}");
    }
}

#[test]
fn a_text_with_a_line_break_executes_nothing() {
    let mut session = session(SCENE);
    for odd in [
        "a\nmodel create model_name = evil",
        "a\"\nmodel create model_name = evil\n",
        "(1)\nmodel delete model_name = .m",
    ] {
        for name in ["comments", "i_marker_name", "adams_id"] {
            let before = texts(&session, ".m.j1", name);
            let report = session.modify(".m.j1", &[(name.into(), text(odd))]);
            assert_eq!(session.model_name().as_deref(), Some("m"), "{name} {odd:?}");
            let kept = texts(&session, ".m.j1", name) == AttributeValue::Texts(vec![odd.to_string()]);
            assert!(kept || report.has_errors() && texts(&session, ".m.j1", name) == before, "{name} {odd:?}");
        }
    }
    let report = session.modify(".m.j1", &[("adams_id".into(), text("1\n2"))]);
    assert_eq!(report.diagnostics[0].code, "attribute/not-writable");
}

#[test]
fn numbers_with_units_expressions_and_names_go_on() {
    let mut session = session(SCENE);
    let set = |session: &mut Session, object: &str, name: &str, value: &str| {
        let report = session.modify(object, &[(name.to_string(), text(value))]);
        assert!(!report.has_errors(), "{value}: {}", session.render(&report.diagnostics, false));
        session.attribute(object, name).unwrap()
    };
    // Truth: 1 N/m is 1e-3 N/mm.
    let stiffness = |a: flexure::Attribute| a.value;
    for (typed, number) in [
        ("2000(newton/meter)", 2.0),
        ("3.5", 3.5),
        ("(.m.v * 2)", 4.0),
        ("-1e3(newton/meter)", -1.0),
        (".m.v * 3", 6.0),
    ] {
        let read = stiffness(set(&mut session, ".m.spring", "stiffness", typed));
        assert!(matches!(read, AttributeValue::Number(x) if (x - number).abs() < 1e-12), "{typed}: {read:?}");
    }
    let computed = set(&mut session, ".m.spring", "stiffness", "(.m.v * 2)");
    assert_eq!(computed.expression.as_deref(), Some(".m.v * 2"));
    for name in [".m.p.b", "b", "(.m.p.b)"] {
        set(&mut session, ".m.j1", "i_marker_name", ".m.p.a");
        assert_eq!(set(&mut session, ".m.j1", "i_marker_name", name).value, AttributeValue::Text(".m.p.b".into()));
    }
}

/// Truth: a marker's coordinates are read in the axes of its part, so they are set in them.
#[test]
fn coordinates_are_set_in_the_frame_in_which_they_are_read() {
    let mut session = session(SCENE);
    let before = texts(&session, ".m.p.a", "location");
    session.execute("defaults coordinate_system default_coordinate_system = .m.q");
    let report = session.modify(".m.p.a", &[("location".into(), before.clone().into())]);
    assert!(!report.has_errors());
    assert!(same(Some(&texts(&session, ".m.p.a", "location")), &before));
}

/// Truth: the same angles and coordinates, whatever commands are set to read. The tolerance is that of two
/// conversions by functions of angles.
#[test]
fn a_place_stays_in_every_sequence_and_coordinate_system() {
    let axes = ["123", "132", "213", "231", "312", "321", "121", "131", "212", "232", "313", "323"];
    let sequences = axes.iter().flat_map(|axes| [format!("body{axes}"), format!("space{axes}")]);
    let mut session = session(SCENE);
    session
        .execute("marker modify marker_name = .m.p.a orientation = 10, 20, 30 location = 3, -4, 5 relative_to = .m.p");
    let both =
        |session: &Session| ["location", "orientation"].map(|name| (name.to_string(), texts(session, ".m.p.a", name)));
    let before = both(&session);
    for (sequence, system) in sequences.zip(["cartesian", "cylindrical", "spherical"].into_iter().cycle()) {
        let settings = format!("orientation_type = {sequence} coordinate_system_type = {system}");
        let report = session.execute(&format!("defaults units {settings}"));
        assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
        let report = session.modify(".m.p.a", &both(&session).map(|(name, value)| (name, value.into())));
        assert!(!report.has_errors(), "{}", session.render(&report.diagnostics, false));
        for ((name, value), (_, first)) in both(&session).iter().zip(&before) {
            assert!(same(Some(value), first), "{settings}: {name} {value:?}, not {first:?}");
        }
    }
}

#[test]
fn several_attributes_are_set_together_or_not_at_all() {
    let mut session = session(SCENE);
    let values = [("mass".to_string(), AttributeInput::Number(3.0)), ("visibility".to_string(), text("nonsense"))];
    assert!(session.modify(".m.p", &values).has_errors());
    assert_eq!(texts(&session, ".m.p", "mass"), AttributeValue::None);
}

#[test]
fn a_name_is_no_piece_of_a_command_either() {
    let mut session = session(SCENE);
    for odd in ["", "a\"b", "a\nmodel create model_name = evil"] {
        assert_eq!(session.rename(".m.p.a", odd).diagnostics[0].code, "attribute/not-writable", "{odd:?}");
    }
    assert!(!session.rename(".m.p.a", "odd one").has_errors());
    assert!(session.attribute(".m.p.\"odd one\"", "location").is_some());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// Truth: what is set is what is read.
    #[test]
    fn odd_texts_are_kept_or_refused(odd in prop::collection::vec("[ -~\t\n\réλ]{0,12}", 1..4)) {
        let mut session = session(SCENE);
        let before = texts(&session, ".m.j1", "comments");
        let count = session.objects("any").len();
        let report = session.modify(".m.j1", &[("comments".into(), AttributeInput::List(odd.iter().map(|t| text(t)).collect()))]);
        let after = texts(&session, ".m.j1", "comments");
        if report.has_errors() {
            prop_assert!(odd.iter().any(|t| t.contains(['\n', '\r'])), "{:?} is refused", odd);
            prop_assert_eq!(after, before);
        } else {
            prop_assert_eq!(after, AttributeValue::Texts(odd));
        }
        prop_assert_eq!(session.objects("any").len(), count);
    }
}
