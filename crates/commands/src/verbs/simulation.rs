//! `simulation single_run ...`: requests to the solver, made by hand or by a script.

use model::{ObjectId, Value};
use schema::{Dimension, Field, Rule, Verb};
use text::Diagnostic;

use super::{
    VerbEntry, entry,
    shared::{MODEL, Outcome},
    solver_commands::{SolverCommand, parse_solver_command},
};
use crate::{Interpreter, OutputTimes, SimulationKind, SimulationRequest, call::Call, interpreter::Flow};

const TYPES: &[&str] = &["dynamic", "kinematic", "static", "auto_select"];

const fn verb(path: &'static str, fields: &'static [Field], run: super::Run, doc: &'static str) -> VerbEntry {
    entry(Verb { path, fields, rules: &[], doc }, run)
}

pub const TRANSIENT: VerbEntry = entry(
    Verb {
        path: "simulation single_run transient",
        fields: &[
            MODEL,
            Field::yes_no("initial_static").doc("find static equilibrium first"),
            Field::choice("type", TYPES).doc("kind of analysis"),
            Field::integer("number_of_steps").doc("number of output steps"),
            Field::real("step_size", Dimension::TIME).doc("time between outputs"),
            Field::real("end_time", Dimension::TIME).doc("time at which the run ends"),
            Field::real("duration", Dimension::TIME).doc("how long to run from now"),
            Field::true_false("forever").doc("run until stopped"),
            Field::text("analysis_name").doc("name of the results"),
        ],
        rules: &[
            Rule::AtMostOne(&["number_of_steps", "step_size"]),
            Rule::AtMostOne(&["end_time", "duration", "forever"]),
        ],
        doc: "simulates a span of time",
    },
    transient,
);

fn kind_of(word: Option<&str>) -> SimulationKind {
    match word {
        Some("dynamic") => SimulationKind::Dynamic,
        Some("kinematic") => SimulationKind::Kinematic,
        Some("static") => SimulationKind::Static,
        _ => SimulationKind::Auto,
    }
}

fn transient(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    if let Some(argument) = call.argument("forever") {
        return Err(vec![
            Diagnostic::error("simulation/no-end", "a run without end is not possible")
                .at(argument.name, "give `end_time` or `duration`"),
        ]);
    }
    let model = interpreter.model_argument(call)?;
    interpreter.database.make_current(model);
    let second = interpreter.database.units().time.si;
    let mut request = SimulationRequest::new(model, kind_of(interpreter.word_of(call, "type")?.as_deref()));
    request.initial_static = interpreter.flag_argument(call, "initial_static")? == Some(true);
    request.duration = interpreter.number_argument(call, "duration")?.map(|t| t * second);
    request.end = interpreter.number_argument(call, "end_time")?.map(|t| t * second);
    if request.end.is_none() && request.duration.is_none() {
        request.end = Some(second);
    }
    if let Some(step) = interpreter.number_argument(call, "step_size")? {
        request.output = OutputTimes::Every(step * second);
    } else if let Some(steps) = interpreter.number_argument(call, "number_of_steps")? {
        request.output = OutputTimes::Steps(steps.max(0.0) as u64);
    }
    request.analysis_name = interpreter.word_of(call, "analysis_name")?;
    interpreter.simulate(&request, call)
}

pub const EQUILIBRIUM: VerbEntry =
    verb("simulation single_run equilibrium", &[MODEL], equilibrium, "finds static equilibrium");
pub const ASSEMBLE: VerbEntry =
    verb("simulation single_run assemble", &[MODEL], assemble, "brings the parts together as the constraints want");

const EIGEN_FIELDS: &[Field] = &[
    MODEL,
    Field::object("plant_state_name", "plant_state").doc("states that the solution is reduced to"),
    Field::object("reference_marker", "marker").doc("marker in which shapes are given"),
    Field::text("eigen_name").doc("name of the solution"),
    Field::yes_no("original").default_word("yes").doc("use the original algorithm"),
    Field::yes_no("damping").default_word("yes").doc("include damping"),
    Field::yes_no("vectors").default_word("yes").doc("also compute shapes"),
];
pub const EIGEN: VerbEntry =
    verb("simulation single_run eigensolution", EIGEN_FIELDS, eigen, "finds linear modes about the present state");
pub const EIGEN_OLD: VerbEntry =
    verb("simulation single_run eigen_solution", EIGEN_FIELDS, eigen, "finds linear modes about the present state");
pub const RESET: VerbEntry = verb("simulation single_run reset", &[MODEL], reset, "goes back to the state as modelled");

fn one(interpreter: &mut Interpreter, call: &Call, kind: SimulationKind) -> Outcome<Flow> {
    let model = interpreter.model_argument(call)?;
    interpreter.database.make_current(model);
    interpreter.simulate(&SimulationRequest::new(model, kind), call)
}

fn equilibrium(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    one(interpreter, call, SimulationKind::Equilibrium)
}

fn assemble(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    one(interpreter, call, SimulationKind::Assemble)
}

fn reset(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    one(interpreter, call, SimulationKind::Reset)
}

fn eigen(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let model = interpreter.model_argument(call)?;
    let mut request = SimulationRequest::new(model, SimulationKind::Eigen);
    request.analysis_name = interpreter.word_of(call, "eigen_name")?;
    for name in ["damping", "vectors"] {
        if let Some(flag) = interpreter.flag_argument(call, name)? {
            let word = if flag { "yes" } else { "no" };
            request.settings.push(("LINEAR".into(), name.to_uppercase(), word.into()));
        }
    }
    interpreter.simulate(&request, call)
}

pub const SCRIPTED: VerbEntry = verb(
    "simulation single_run scripted",
    &[
        MODEL,
        Field::object("sim_script_name", "script").current().doc("script"),
        Field::yes_no("reset_before_and_after").doc("go back to the state as modelled before and after"),
    ],
    scripted,
    "runs a script",
);

fn scripted(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let Some(script) =
        interpreter.object_argument(call, "sim_script_name")?.or_else(|| interpreter.database.current("script"))
    else {
        return Err(vec![call.missing(&["sim_script_name"])]);
    };
    let model = match interpreter.object_argument(call, "model_name")? {
        Some(model) => model,
        None => match interpreter.database.model_of(script).or_else(|| interpreter.database.current("model")) {
            Some(model) => model,
            None => return Err(vec![call.missing(&["model_name"])]),
        },
    };
    interpreter.database.make_current(script);
    let reset = interpreter.flag_argument(call, "reset_before_and_after")? != Some(false);
    let back = SimulationRequest::new(model, SimulationKind::Reset);
    if reset {
        interpreter.host.simulate(&mut interpreter.database, &back)?;
    }
    let flow = interpreter.run_script(script, model, call)?;
    if reset && flow != Flow::Abort {
        interpreter.host.simulate(&mut interpreter.database, &back)?;
    }
    Ok(flow)
}

impl Interpreter {
    /// Passes a request to the solver; troubles get the place of the command.
    pub(crate) fn simulate(&mut self, request: &SimulationRequest, call: &Call) -> Outcome<Flow> {
        match self.host.simulate(&mut self.database, request) {
            Ok(()) => Ok(Flow::Next),
            Err(diagnostics) => {
                Err(diagnostics.into_iter().map(|d| d.or_at(call.span, "while running this")).collect())
            }
        }
    }

    fn lines_of(&self, id: ObjectId, name: &str) -> Vec<String> {
        match self.database.value(id, name) {
            Some(Value::Texts(lines)) => lines.clone(),
            Some(Value::Text(line)) => vec![line.clone()],
            _ => Vec::new(),
        }
    }

    /// A script is Adams View commands, or solver commands, or one transient run.
    fn run_script(&mut self, script: ObjectId, model: ObjectId, call: &Call) -> Outcome<Flow> {
        let commands = self.lines_of(script, "commands");
        let name = self.database.full_name(script);
        if !commands.is_empty() {
            let file = self.sources.add(format!("script {name}"), commands.join("\n"));
            self.trace.push(call.span);
            let flow = self.run_source(file);
            self.trace.pop();
            return Ok(flow);
        }
        let lines = self.lines_of(script, "solver_commands");
        if !lines.is_empty() {
            return self.run_solver_commands(&lines, &name, model, call);
        }
        let second = self.database.units().time.si;
        let mut request = SimulationRequest::new(model, kind_of(self.database.text(script, "type")));
        request.initial_static = self.database.flag(script, "initial_static") == Some(true);
        request.duration = self.database.number(script, "duration").map(|t| t * second);
        if request.duration.is_none() {
            request.end = Some(self.database.number(script, "end_time").unwrap_or(1.0) * second);
        }
        request.output = match self.database.number(script, "step_size") {
            Some(step) => OutputTimes::Every(step * second),
            None => OutputTimes::Steps(self.database.number(script, "number_of_steps").unwrap_or(10.0).max(0.0) as u64),
        };
        request.analysis_name = Some("Last_Run".into());
        self.simulate(&request, call)
    }

    fn run_solver_commands(&mut self, lines: &[String], name: &str, model: ObjectId, call: &Call) -> Outcome<Flow> {
        let second = self.database.units().time.si;
        let mut settings: Vec<(String, String, String)> = Vec::new();
        for line in lines {
            match parse_solver_command(line) {
                SolverCommand::Nothing => {}
                SolverCommand::Stop => break,
                SolverCommand::Simulate { kind, end, duration, output } => {
                    let mut request = SimulationRequest::new(model, kind);
                    request.end = end.map(|t| t * second);
                    request.duration = duration.map(|t| t * second);
                    request.output = match output {
                        Some(OutputTimes::Every(t)) => OutputTimes::Every(t * second),
                        Some(steps) => steps,
                        None => OutputTimes::Steps(50),
                    };
                    request.settings.clone_from(&settings);
                    let flow = self.simulate(&request, call)?;
                    if flow != Flow::Next {
                        return Ok(flow);
                    }
                }
                SolverCommand::Setting { statement, arguments } => {
                    settings.extend(arguments.into_iter().map(|(k, v)| (statement.clone(), k, v)));
                }
                SolverCommand::Other(what) => self.report.diagnostics.push(
                    Diagnostic::warning("command/not-supported", format!("`{what}` is not executed by Flexure"))
                        .at(call.span, format!("solver command of `{name}`"))
                        .note("the run goes on as if the line were not there"),
                ),
            }
        }
        Ok(Flow::Next)
    }
}
