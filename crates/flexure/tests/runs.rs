//! What a run refuses, what it says, and from where it starts.

use flexure::{Analysis, Outputs, Session, SimulationOptions};

const DOOR: &str = "\
defaults units length=mm angle=deg force=newton mass=kg time=sec
model create model_name=m
part create rigid_body name_and_position part_name=.m.door location=0,0,0
marker create marker_name=.m.door.cm location=400,0,0 relative_to=.m.door
marker create marker_name=.m.door.low location=0,0,-500 relative_to=.m.door
marker create marker_name=.m.door.high location=0,0,500 relative_to=.m.door
part create rigid_body mass_properties part_name=.m.door mass=20 center_of_mass_marker=.m.door.cm &
   ixx=1.0E+06 iyy=1.0E+06 izz=1.0E+06
marker create marker_name=.m.ground.low location=0,0,-500 relative_to=.m.ground
marker create marker_name=.m.ground.high location=0,0,500 relative_to=.m.ground
constraint create joint revolute joint_name=.m.lower i_marker_name=.m.door.low j_marker_name=.m.ground.low
";

fn session(text: &str) -> Session {
    let mut session = Session::new();
    let report = session.execute(text);
    assert_eq!(report.failed, 0, "{}", session.render(&report.diagnostics, false));
    session
}

fn dynamic(end: f64) -> SimulationOptions {
    SimulationOptions::new(Analysis::Dynamic { end, outputs: Outputs::Steps(2) })
}

/// The code of the first error.
fn refusal(session: &mut Session, options: &SimulationOptions) -> &'static str {
    session.simulate(options).expect_err("a refusal").first().expect("a diagnostic").code
}

/// Truth: a second hinge on the same axis repeats the five equations of the first.
#[test]
fn a_door_with_two_hinges_loses_five_of_ten_equations_by_name() {
    let upper = "constraint create joint revolute joint_name=.m.upper i_marker_name=.m.door.high \
                 j_marker_name=.m.ground.high";
    let run = session(&format!("{DOOR}{upper}\n")).simulate(&dynamic(0.1)).unwrap();
    let named: Vec<_> = run.messages.iter().filter(|m| m.contains("deactivating constraint equation")).collect();
    assert_eq!(named.len(), 5, "{:?}", run.messages);
    assert!(named.iter().all(|m| m.ends_with("in .m.upper")), "{named:?}");
}

#[test]
fn hinges_that_contradict_each_other_are_refused() {
    let off = "marker create marker_name=.m.ground.off location=0,10,500 relative_to=.m.ground\n\
               constraint create joint spherical joint_name=.m.upper i_marker_name=.m.door.low &\n\
               j_marker_name=.m.ground.off\n";
    assert_eq!(refusal(&mut session(&format!("{DOOR}{off}")), &dynamic(0.1)), "run/contradictory-constraints");
}

#[test]
fn two_motions_of_different_speed_on_one_joint_are_refused() {
    let motions = "constraint create motion_generator motion_name=.m.a joint_name=.m.lower &\n\
                   type_of_freedom=rotational function=\"time\"\n\
                   constraint create motion_generator motion_name=.m.b joint_name=.m.lower &\n\
                   type_of_freedom=rotational function=\"2*time\"\n";
    assert_eq!(refusal(&mut session(&format!("{DOOR}{motions}")), &dynamic(0.1)), "run/contradictory-constraints");
}

#[test]
fn markers_that_are_apart_are_said_to_be() {
    let text =
        DOOR.replace("marker_name=.m.ground.low location=0,0,-500", "marker_name=.m.ground.low location=0,0,-400");
    let run = session(&text).simulate(&dynamic(0.1)).unwrap();
    let said = run.messages.iter().find(|m| m.contains("not initially coincident")).expect("a warning");
    assert!(said.contains("m.lower") && said.contains("Delta Z = -100.0000"), "{said}");
}

#[test]
fn a_kinematic_analysis_of_what_moves_freely_is_refused() {
    let options = SimulationOptions::new(Analysis::Kinematic { end: 1.0, outputs: Outputs::Steps(2) });
    assert_eq!(refusal(&mut session(DOOR), &options), "run/degrees-of-freedom");
}

#[test]
fn impossible_times_and_integrators_are_refused() {
    let mut session = session(DOOR);
    for end in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(refusal(&mut session, &dynamic(end)), "run/no-time");
    }
    let options = SimulationOptions { integrator: Some("magic".into()), ..dynamic(1.0) };
    assert_eq!(refusal(&mut session, &options), "run/unknown-integrator");
}

#[test]
fn a_run_goes_on_where_the_last_one_ended_until_the_model_changes() {
    let mut session = session(DOOR);
    let first = session.simulate(&dynamic(0.1)).unwrap();
    let second = session.simulate(&dynamic(0.2)).unwrap();
    let times = |run: &flexure::Run| run.table.series[0].values.clone();
    assert_eq!(times(&second)[0], *times(&first).last().unwrap());
    session.execute("part modify rigid_body mass_properties part_name=.m.door mass=30");
    assert_eq!(times(&session.simulate(&dynamic(0.2)).unwrap())[0], 0.0);
}

#[test]
fn files_that_are_not_read_yet_are_named_as_what_they_are() {
    let report = Session::new().read(std::path::Path::new("model.acf"));
    assert!(report.diagnostics[0].message.contains("a solver command file"));
}
