//! What every case starts from, and how a test looks at what came of it.

use std::sync::{Arc, Mutex};

use flexure::{AttributeValue, Report, RunObserver, Session};
use tempfile::TempDir;

/// A beam from a part to ground; millimetres, newtons, kilograms, seconds, degrees.
const BEAM: &str = "\
model create model_name = m
marker create marker_name = .m.ground.marker_2 location = 0,0,0
part create rigid_body name_and_position part_name = .m.p1 location = 0,0,0
marker create marker_name = .m.p1.marker_1 location = 2,0,0
force create element_like beam beam_name = .m.beam1 i_marker_name = .m.p1.marker_1 &
   j_marker_name = .m.ground.marker_2 ixx=1 iyy=1 izz=1 youngs_modulus=1 shear_modulus=1 length=2 &
   area_of_cross_section=1
";

/// Keeps what would stand in the information window.
struct Window(Arc<Mutex<Vec<String>>>);

impl RunObserver for Window {
    fn message(&mut self, text: &str) {
        self.0.lock().unwrap().extend(text.lines().map(str::to_string));
    }
}

/// A session with its journal, its information window and a folder for files.
pub struct Scene {
    pub session: Session,
    pub folder: TempDir,
    window: Arc<Mutex<Vec<String>>>,
}

impl Scene {
    /// Nothing but an empty session.
    pub fn empty() -> Scene {
        let folder = tempfile::tempdir().unwrap();
        let window = Arc::new(Mutex::new(Vec::new()));
        let mut session = Session::new();
        session.keep_journal(&folder.path().join("aview.log")).unwrap();
        session.set_observer(Box::new(Window(window.clone())));
        Scene { session, folder, window }
    }

    /// The beam between part `p1` and ground.
    pub fn beam() -> Scene {
        let mut scene = Scene::empty();
        scene.accept(BEAM);
        scene
    }

    /// Runs commands that must all be executed.
    pub fn accept(&mut self, text: &str) -> Report {
        let report = self.session.execute(text);
        assert!(report.failed == 0 && report.skipped == 0, "{text}\n{}", self.told(&report));
        report
    }

    /// Runs commands of which some are refused; the lines Adams prints for the errors.
    pub fn refuse(&mut self, text: &str) -> Vec<String> {
        let report = self.session.execute(text);
        assert!(report.failed > 0, "nothing was refused: {text}\n{}", self.told(&report));
        adams_lines(&report)
    }

    /// Reads a command file of these lines; the report of it.
    pub fn read(&mut self, name: &str, text: &str) -> Report {
        let path = self.folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        self.session.read(&path)
    }

    /// Reads a command file; what the journal says of it, without its first line.
    pub fn logged(&mut self, name: &str, text: &str) -> Vec<String> {
        let before = self.journal().len();
        self.read(name, text);
        self.journal().split_off(before + 1)
    }

    pub fn journal(&self) -> Vec<String> {
        let text = std::fs::read_to_string(self.folder.path().join("aview.log")).unwrap();
        text.lines().map(str::to_string).collect()
    }

    /// Takes what the information window holds.
    pub fn window(&mut self) -> Vec<String> {
        std::mem::take(&mut self.window.lock().unwrap())
    }

    pub fn told(&self, report: &Report) -> String {
        self.session.render(&report.diagnostics, false)
    }

    pub fn exists(&self, name: &str) -> bool {
        self.session.database().find(name, "any").is_some()
    }

    pub fn value(&self, object: &str, name: &str) -> AttributeValue {
        self.session.attribute(object, name).unwrap_or_else(|| panic!("no {object}.{name}")).value
    }

    pub fn number(&self, object: &str, name: &str) -> f64 {
        match self.value(object, name) {
            AttributeValue::Number(x) => x,
            AttributeValue::Integer(i) => i as f64,
            other => panic!("{object}.{name} is {other:?}"),
        }
    }

    /// The solver id; 0 while an object has none.
    pub fn id(&self, object: &str) -> i64 {
        match self.value(object, "adams_id") {
            AttributeValue::Integer(id) => id,
            AttributeValue::None => 0,
            other => panic!("{object}.adams_id is {other:?}"),
        }
    }

    pub fn numbers(&self, object: &str, name: &str) -> Vec<f64> {
        match self.value(object, name) {
            AttributeValue::Numbers(list) => list,
            AttributeValue::Number(x) => vec![x],
            other => panic!("{object}.{name} is {other:?}"),
        }
    }

    pub fn text(&self, object: &str, name: &str) -> String {
        match self.value(object, name) {
            AttributeValue::Text(text) => text,
            other => panic!("{object}.{name} is {other:?}"),
        }
    }

    pub fn expression(&self, object: &str, name: &str) -> Option<String> {
        self.session.attribute(object, name).and_then(|a| a.expression)
    }

    /// The numbers of an expression.
    pub fn evaluated(&mut self, expression: &str) -> Vec<f64> {
        self.accept(&format!("variable set variable_name = .evaluated real_value = (eval({expression}))"));
        self.numbers(".evaluated", "real_value")
    }

    /// The text of an expression that yields one.
    pub fn string(&mut self, expression: &str) -> String {
        self.accept(&format!("variable set variable_name = .string string_value = (eval({expression}))"));
        self.text(".string", "string_value")
    }

    /// A session that has read an export. What only concerns the display is skipped.
    #[allow(dead_code, reason = "the tests of the help page share this file")]
    pub fn of_export(text: &str) -> Scene {
        let mut scene = Scene::empty();
        let report = scene.session.execute(text);
        assert!(report.failed == 0, "{text}\n{}", scene.told(&report));
        scene
    }

    /// The model as a command file.
    pub fn export(&mut self) -> String {
        let path = self.folder.path().join("export.cmd");
        self.session.write(&path).unwrap();
        std::fs::read_to_string(path).unwrap()
    }

    /// The model as a solver dataset, as the command writes it.
    pub fn data_set(&mut self) -> String {
        let path = self.folder.path().join("export.adm");
        let report = self.session.execute(&format!("file adams_data_set write file_name=\"{}\"", path.display()));
        assert!(!report.has_errors(), "{:#?}", report.diagnostics);
        std::fs::read_to_string(path).unwrap()
    }

    /// Everything of the model that an export shows, to see that nothing has changed.
    pub fn unchanged(&mut self, text: &str) -> Vec<String> {
        let before = self.export();
        let lines = self.refuse(text);
        assert_eq!(self.export(), before, "{text}");
        lines
    }
}

/// The lines Adams prints for the errors of a report.
pub fn adams_lines(report: &Report) -> Vec<String> {
    report.diagnostics.iter().filter(|d| d.is_error()).flat_map(|d| d.adams_text.clone()).collect()
}

/// The codes of the errors of a report.
pub fn codes(report: &Report) -> Vec<&'static str> {
    report.diagnostics.iter().filter(|d| d.is_error()).map(|d| d.code).collect()
}

pub fn close(found: f64, wanted: f64, tolerance: f64) {
    assert!((found - wanted).abs() <= tolerance, "{found} is not {wanted} to {tolerance}");
}

pub fn all_close(found: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?} is not {wanted:?}");
    for (f, w) in found.iter().zip(wanted) {
        assert!((f - w).abs() <= tolerance, "{found:?} is not {wanted:?} to {tolerance}");
    }
}
