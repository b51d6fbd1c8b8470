//! Runs the chapters beside this file: prose, commands, and what must be true after them.
//!
//! A heading `# ...` begins with a new session on a small model (see `FIXTURE`). Blocks:
//! - `cmd`: commands. Lines `! error: [code] "text"` and `! warning: ...` say what is reported; every
//!   report must be said.
//! - `file NAME`: a file that commands may read.
//! - `absent`, `present`: names of objects, one a line.
//! - `values`: `object.field = value`; numbers to 1e-9 because they are shown rounded.
//! - `global`: `frame = x, y, z` for the origin, `frame axis = x, y, z` for the direction of an axis.
//! - `shown`: the information window holds these lines.
//! - `file_is NAME`: what a command has written to a file.
//! - `runs`: what was asked of the solver, one run a line.

use std::{
    path::{Path, PathBuf},
    sync::{Arc, Mutex},
};

use flexure_commands::{BodyMass, Host, Interpreter, OnError, SimulationRequest};
use model::{Database, ObjectId, Value};
use text::Diagnostic;

const FIXTURE: &str = "
model create model_name = m
marker create marker_name = .m.ground.base location = 0,0,0
part create rigid_body name_and_position part_name = .m.p location = 100,0,0 orientation = 90,0,0
marker create marker_name = .m.p.a location = 0,0,0 relative_to = .m.p
marker create marker_name = .m.p.b location = 10,0,0 relative_to = .m.p
defaults coordinate_system default_coordinate_system = .m.ground
force create element_like beam beam_name = .m.beam i_marker_name = .m.p.a j_marker_name = .m.ground.base &
   ixx=1 iyy=1 izz=1 youngs_modulus=1 shear_modulus=1 length=100 area_of_cross_section=1
";

#[derive(Default)]
struct Seen {
    shown: Vec<String>,
    runs: Vec<String>,
}

struct Recorder {
    seen: Arc<Mutex<Seen>>,
    folder: PathBuf,
}

impl Host for Recorder {
    fn simulate(&mut self, _: &mut Database, request: &SimulationRequest) -> Result<(), Vec<Diagnostic>> {
        let mut words = vec![format!("{:?}", request.kind).to_lowercase()];
        words.extend(request.end.map(|end| format!("end={end}")));
        words.extend(request.duration.map(|duration| format!("duration={duration}")));
        words.push(format!("{:?}", request.output).to_lowercase());
        words.extend(request.settings.iter().map(|(statement, key, value)| format!("{statement}/{key}={value}")));
        let line = words.join(" ");
        self.seen.lock().unwrap().runs.push(line);
        Ok(())
    }

    fn write_data_set(&mut self, _: &mut Database, _: ObjectId, _: &Path) -> Result<(), Vec<Diagnostic>> {
        Ok(())
    }

    fn verify(&mut self, _: &Database, _: ObjectId) -> (Vec<String>, Vec<Diagnostic>) {
        (Vec::new(), Vec::new())
    }

    fn mass_properties(&self, database: &Database, body: ObjectId) -> Result<BodyMass, Vec<Diagnostic>> {
        let found = elements::bodies::part::lower::mass_properties(database, body)?;
        Ok(BodyMass { mass: found.mass, centre: found.centre, inertia: found.inertia_c_b })
    }

    fn show(&mut self, lines: &[String]) {
        self.seen.lock().unwrap().shown.extend_from_slice(lines);
    }

    fn resolve(&self, path: &str) -> PathBuf {
        self.folder.join(path)
    }
}

struct Stage {
    interpreter: Interpreter,
    seen: Arc<Mutex<Seen>>,
    folder: PathBuf,
}

impl Stage {
    fn new(folder: &Path) -> Stage {
        let seen = Arc::new(Mutex::new(Seen::default()));
        let host = Recorder { seen: seen.clone(), folder: folder.to_path_buf() };
        let mut interpreter = Interpreter::with_host(elements::registry(), Box::new(host));
        interpreter.on_error = OnError::IgnoreCommand;
        let report = interpreter.run_text("fixture", FIXTURE);
        assert!(!report.has_errors(), "{:?}", report.diagnostics);
        Stage { interpreter, seen, folder: folder.to_path_buf() }
    }

    fn find(&self, name: &str) -> Option<ObjectId> {
        self.interpreter.database.find(name, "any")
    }

    /// Checks one block; the trouble, if any.
    fn block(&mut self, kind: &str, body: &str) -> Result<(), String> {
        let lines = || body.lines().map(str::trim).filter(|l| !l.is_empty());
        if let Some(name) = kind.strip_prefix("file ") {
            return std::fs::write(self.folder.join(name), body).map_err(|e| e.to_string());
        }
        if let Some(name) = kind.strip_prefix("file_is ") {
            let found = std::fs::read_to_string(self.folder.join(name)).map_err(|e| format!("{name}: {e}"))?;
            return if found == body { Ok(()) } else { Err(format!("{name} holds\n{found}")) };
        }
        match kind {
            "cmd" => self.commands(body),
            "absent" => lines().try_for_each(|n| self.find(n).map_or(Ok(()), |_| Err(format!("{n} exists")))),
            "present" => lines().try_for_each(|n| self.find(n).map(|_| ()).ok_or(format!("{n} is missing"))),
            "values" => lines().try_for_each(|l| self.value(l)),
            "global" => lines().try_for_each(|l| self.global(l)),
            "shown" => {
                let shown = &self.seen.lock().unwrap().shown;
                lines().try_for_each(|l| {
                    let found = shown.iter().any(|s| s.split_whitespace().eq(l.split_whitespace()));
                    if found { Ok(()) } else { Err(format!("not shown: {l}\n{}", shown.join("\n"))) }
                })
            }
            "runs" => {
                let runs = std::mem::take(&mut self.seen.lock().unwrap().runs);
                let wanted: Vec<&str> = lines().collect();
                if runs == wanted { Ok(()) } else { Err(format!("the runs were {runs:#?}")) }
            }
            other => Err(format!("there is no block `{other}`")),
        }
    }

    fn commands(&mut self, body: &str) -> Result<(), String> {
        let expected = |mark: &str| -> Vec<(String, String)> {
            let lines = body.lines().filter_map(|l| l.trim().strip_prefix(mark));
            lines
                .map(|l| {
                    let (code, text) = l.trim().trim_start_matches('[').split_once(']').unwrap_or((l, ""));
                    (code.to_string(), text.trim().trim_matches('"').to_string())
                })
                .collect()
        };
        let wanted = [(true, expected("! error:")), (false, expected("! warning:"))];
        let report = self.interpreter.execute(body);
        for (is_error, wanted) in wanted {
            let mut found: Vec<&Diagnostic> = report.diagnostics.iter().filter(|d| d.is_error() == is_error).collect();
            found.retain(|d| d.severity != text::Severity::Note);
            for (code, text) in wanted {
                let at = found.iter().position(|d| d.code == code && d.message.contains(&text));
                match at {
                    Some(at) => drop(found.remove(at)),
                    None => return Err(format!("[{code}] {text:?} is not reported: {:#?}", report.diagnostics)),
                }
            }
            if let Some(extra) = found.first() {
                return Err(format!("not expected: [{}] {}", extra.code, extra.message));
            }
        }
        Ok(())
    }

    fn value(&self, line: &str) -> Result<(), String> {
        let (cell, wanted) = line.split_once('=').ok_or(format!("no value: {line}"))?;
        let (name, field) = cell.trim().rsplit_once('.').ok_or(format!("no field: {line}"))?;
        let id = self.find(name).ok_or(format!("{name} is missing"))?;
        let database = &self.interpreter.database;
        let wanted = wanted.trim();
        let found = match database.value(id, field) {
            None => "nothing".to_string(),
            Some(Value::Number(_) | Value::Integer(_) | Value::Array(_)) => {
                let numbers = database.numbers(id, field).unwrap_or_default();
                if close(&numbers, wanted) {
                    return Ok(());
                }
                format!("{numbers:?}")
            }
            Some(Value::Flag(flag)) => if *flag { "yes" } else { "no" }.to_string(),
            Some(Value::Text(text)) => format!("\"{text}\""),
            Some(Value::Texts(texts)) => texts.iter().map(|t| format!("\"{t}\"")).collect::<Vec<_>>().join(", "),
            Some(Value::Function(f)) => format!("\"{}\"", f.write(|id| database.full_name(id))),
            Some(other) => other.objects().iter().map(|o| database.full_name(*o)).collect::<Vec<_>>().join(", "),
        };
        if found == wanted { Ok(()) } else { Err(format!("{} is {found}, not {wanted}", cell.trim())) }
    }

    fn global(&self, line: &str) -> Result<(), String> {
        let (frame, wanted) = line.split_once('=').ok_or(format!("no value: {line}"))?;
        let mut words = frame.split_whitespace();
        let name = words.next().unwrap_or("");
        let id = self.find(name).ok_or(format!("{name} is missing"))?;
        let pose = self.interpreter.database.global_pose(id);
        let found = match words.next() {
            None => pose.origin,
            Some("x") => pose.rotation.col(0),
            Some("y") => pose.rotation.col(1),
            Some("z") => pose.rotation.col(2),
            Some(other) => return Err(format!("there is no axis {other}")),
        };
        if close(&found.to_array(), wanted) {
            Ok(())
        } else {
            Err(format!("{} is {found}, not {wanted}", frame.trim()))
        }
    }
}

fn close(found: &[f64], wanted: &str) -> bool {
    let wanted: Option<Vec<f64>> = wanted.split(',').map(|w| w.trim().parse().ok()).collect();
    wanted.is_some_and(|w| {
        w.len() == found.len() && w.iter().zip(found).all(|(a, b)| (a - b).abs() <= 1e-9 * a.abs().max(1.0))
    })
}

fn run_chapter(name: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(format!("{name}.md"));
    let text = std::fs::read_to_string(&path).unwrap();
    let folder = std::env::temp_dir().join(format!("flexure-literate-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (mut stage, mut title, mut blocks, mut troubles) = (None, "", 0, Vec::new());
    let mut lines = text.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        if let Some(heading) = line.strip_prefix("# ") {
            title = heading;
            stage = Some(Stage::new(&folder));
        } else if let Some(kind) = line.strip_prefix("```") {
            let body: Vec<&str> = lines.by_ref().map(|(_, l)| l).take_while(|l| *l != "```").collect();
            let stage = stage.as_mut().expect("a chapter begins with a heading");
            blocks += 1;
            if let Err(trouble) = stage.block(kind.trim(), &(body.join("\n") + "\n")) {
                troubles.push(format!("{name}.md:{} ({title}): {trouble}", number + 1));
            }
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(blocks > 2, "{name}.md holds nothing to check");
    assert!(troubles.is_empty(), "{}", troubles.join("\n\n"));
}

#[test]
fn control_flow() {
    run_chapter("control_flow");
}

#[test]
fn macros() {
    run_chapter("macros");
}

#[test]
fn objects() {
    run_chapter("objects");
}

#[test]
fn places() {
    run_chapter("places");
}

#[test]
fn files_and_runs() {
    run_chapter("files_and_runs");
}

#[test]
fn nothing_is_ignored() {
    run_chapter("nothing_is_ignored");
}

#[test]
fn moving() {
    run_chapter("moving");
}

#[test]
fn merging() {
    run_chapter("merging");
}

#[test]
fn groups() {
    run_chapter("groups");
}

#[test]
fn listing() {
    run_chapter("listing");
}

#[test]
fn naming() {
    run_chapter("naming");
}

#[test]
fn sections() {
    run_chapter("sections");
}

#[test]
fn session_and_files() {
    run_chapter("session_and_files");
}
