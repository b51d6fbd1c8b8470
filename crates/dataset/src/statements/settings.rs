//! Settings of solver and output: one statement each, arguments as words, switches or numbers.

use model::{ObjectId, Value};

use schema::Kind;
use text::Diagnostic;

use super::numbers;
use crate::{
    layout::Lines,
    read::{Builder, Entry, Form, Word},
    write::Writer,
};

/// How a field becomes an argument.
#[derive(Clone, Copy)]
enum As {
    /// `, KEYWORD = value`.
    Value,
    /// The value itself, in capitals: `, HHT`.
    Word,
    /// `, KEYWORD` when on.
    On,
    /// `, KEYWORD` when off.
    Off,
    /// `, KEYWORD` when on or not set.
    OnUnlessOff,
}

const INTEGRATOR: &[(&str, &str, As)] = &[
    ("integrator_type", "", As::Word),
    ("formulation", "", As::Word),
    ("error_tolerance", "ERROR", As::Value),
    ("maxit_corrector_iterations", "MAXIT", As::Value),
    ("hinit_time_step", "HINIT", As::Value),
    ("hmin_time_step", "HMIN", As::Value),
    ("hmax_time_step", "HMAX", As::Value),
    ("kmax_integrator_order", "KMAX", As::Value),
    ("adaptivity", "ADAPTIVITY", As::Value),
    ("alpha", "ALPHA", As::Value),
    ("beta", "BETA", As::Value),
    ("gamma", "GAMMA", As::Value),
    ("corrector", "CORRECTOR", As::Value),
];
const EQUILIBRIUM: &[(&str, &str, As)] = &[
    ("alimit", "ALIMIT", As::Value),
    ("error", "ERROR", As::Value),
    ("imbalance", "IMBALANCE", As::Value),
    ("maxit", "MAXIT", As::Value),
    ("stability", "STABILITY", As::Value),
    ("tlimit", "TLIMIT", As::Value),
];
const KINEMATICS: &[(&str, &str, As)] = &[
    ("alimit", "ALIMIT", As::Value),
    ("error", "ERROR", As::Value),
    ("maxit", "MAXIT", As::Value),
    ("aerror", "AERROR", As::Value),
    ("amaxit", "AMAXIT", As::Value),
    ("tlimit", "TLIMIT", As::Value),
    ("hmax", "HMAX", As::Value),
];
const OUTPUT: &[(&str, &str, As)] = &[
    ("reqsave", "REQSAVE", As::OnUnlessOff),
    ("grsave", "GRSAVE", As::OnUnlessOff),
    ("osformat", "OSFORMAT", As::On),
    ("chart", "CHART", As::On),
    ("fixed", "FIXED", As::On),
    ("ypr", "YPR", As::On),
    ("icsave", "ICSAVE", As::On),
    ("teletype", "TELETYPE", As::On),
    ("separator", "NOSEPARATOR", As::Off),
    ("print", "NOPRINT", As::Off),
    ("dscale", "DSCALE", As::Value),
    ("vscale", "VSCALE", As::Value),
    ("ascale", "ASCALE", As::Value),
    ("fscale", "FSCALE", As::Value),
    ("dzero", "DZERO", As::Value),
    ("vzero", "VZERO", As::Value),
    ("azero", "AZERO", As::Value),
    ("fzero", "FZERO", As::Value),
];
const RESULTS: &[(&str, &str, As)] = &[
    ("formatted", "FORMATTED", As::On),
    ("displacements", "NODISPLACEMENTS", As::Off),
    ("velocities", "NOVELOCITIES", As::Off),
    ("accelerations", "NOACCELERATIONS", As::Off),
    ("applied_forces", "NOAPPLIEDFORCES", As::Off),
    ("reaction_forces", "NOREACTIONFORCES", As::Off),
    ("data_structures", "NODATASTRUCTURES", As::Off),
    ("system_elements", "NOSYSTEMELEMENTS", As::Off),
    ("linear", "NOLINEAR", As::Off),
    ("floating_markers", "NOFLOATINGMARKERS", As::Off),
    ("xrf", "XRF", As::OnUnlessOff),
    ("request", "NOREQUESTS", As::Off),
    ("contact_incidents", "NOCONTACTS", As::Off),
    ("comment", "COMMENT", As::Value),
];
const PREFERENCES: &[(&str, &str, As)] =
    &[("contact_faceting_tolerance", "CONTACT_FACETING_TOLERANCE", As::Value), ("thread_count", "NTHREADS", As::Value)];

/// The fields of a class with their keywords and how they are written.
type Table = &'static [(&'static str, &'static str, As)];

/// The statements of settings in the order they are written, with their arguments.
const SETTINGS: &[(&str, Table)] = &[
    ("INTEGRATOR", INTEGRATOR),
    ("EQUILIBRIUM", EQUILIBRIUM),
    ("KINEMATICS", KINEMATICS),
    ("OUTPUT", OUTPUT),
    ("RESULTS", RESULTS),
    ("PREFERENCES", PREFERENCES),
];

/// The statements of settings in the order they are written.
pub(crate) fn setting_names() -> impl Iterator<Item = &'static str> {
    SETTINGS.iter().map(|(name, _)| *name)
}

pub(crate) fn is_setting(statement: &str) -> bool {
    setting_names().any(|name| name == statement)
}

/// The arguments of a statement of settings.
fn table(statement: &str) -> Table {
    SETTINGS.iter().find(|(name, _)| *name == statement).map_or(&[], |(_, table)| *table)
}

/// The statement of a settings object. OUTPUT and RESULTS are written without one too, as View does.
pub(crate) fn settings(w: &mut Writer<'_>, statement: &str, object: Option<ObjectId>) -> Option<Lines> {
    let table = table(statement);
    if object.is_none() && statement != "OUTPUT" && statement != "RESULTS" {
        return None;
    }
    let mut lines = Lines::new(statement, None);
    for (field, keyword, how) in table {
        let value = object.and_then(|id| w.database.value(id, field)).cloned();
        if *field == "error_tolerance" && value.as_ref().and_then(Value::as_number) == Some(default_error(w, object)) {
            continue;
        }
        argument(w, object, (field, keyword, *how), value.as_ref(), &mut lines);
    }
    if let Some(id) = object {
        unwritten(w, id, table);
    }
    Some(lines)
}

/// The local error an integrator allows unless told otherwise; exports leave it out even where the
/// model states it.
fn default_error(w: &Writer<'_>, object: Option<ObjectId>) -> f64 {
    match object.and_then(|id| w.database.text(id, "integrator_type")) {
        Some("hht" | "newmark") => 1e-5,
        _ => 1e-3,
    }
}

fn argument(
    w: &Writer<'_>,
    object: Option<ObjectId>,
    (name, keyword, how): (&str, &str, As),
    value: Option<&Value>,
    lines: &mut Lines,
) {
    let on = value.map(|v| match v {
        Value::Text(word) => word != "off" && word != "no",
        other => other.as_number() != Some(0.0),
    });
    match (how, value) {
        (As::On, _) if on == Some(true) => lines.flag(keyword),
        (As::Off, _) if on == Some(false) => lines.flag(keyword),
        (As::OnUnlessOff, _) if on != Some(false) => lines.flag(keyword),
        (As::Word, Some(Value::Text(word))) if word != "none" => {
            let capitals = word.to_ascii_uppercase();
            lines.flag(if word == "si2_gstiff" { "SI2" } else { &capitals });
        }
        (As::Value, Some(Value::Text(word))) => lines.argument(keyword, &word.to_ascii_uppercase()),
        (As::Value, Some(_)) => {
            let Some(id) = object else { return };
            let class = w.database.object(id).class;
            let Some(field) = class.cell_index(name).map(|index| class.field(index)) else { return };
            if let Some(values) = numbers(w, id, field) {
                lines.list(keyword, &values);
            }
        }
        _ => {}
    }
}

/// Names settings that are given but have no argument here.
fn unwritten(w: &mut Writer<'_>, id: ObjectId, table: &[(&str, &str, As)]) {
    let class = w.database.object(id).class;
    for field in class.fields() {
        let known = field.name == "model_name" || table.iter().any(|(name, ..)| *name == field.name);
        let default = match field.default {
            schema::Default::Number(x) => w.database.number(id, field.name) == Some(x),
            schema::Default::Word(word) => w.database.text(id, field.name) == Some(word),
            _ => false,
        };
        if !known && !default && w.database.value(id, field.name).is_some() {
            let statement = class.statement.unwrap_or(class.word);
            w.warn("dataset/argument-not-written", format!("`{}` of {statement} is not written yet", field.name));
        }
    }
}

/// Integrators and formulations by the words of the statement.
const INTEGRATORS: &[&str] =
    &["CONSTANT_BDF", "GSTIFF", "WSTIFF", "DSTIFF", "ABAM", "CPBDF", "RKF45", "HHT", "NEWMARK", "HASTIFF"];
const FORMULATIONS: &[&str] = &["I3", "SI2", "SI1", "PSI2"];

/// What a statement of settings knows.
pub(crate) fn setting_words(statement: &str) -> Vec<Word> {
    let mut words: Vec<Word> = Vec::new();
    for (_, keyword, how) in table(statement) {
        match how {
            As::Value if *keyword == "COMMENT" => words.push((keyword, Form::Text)),
            As::Value => words.push((keyword, Form::Value)),
            As::Word => words.extend([INTEGRATORS, FORMULATIONS].concat().into_iter().map(|w| (w, Form::Flag))),
            _ => words.push((keyword, Form::Flag)),
        }
    }
    words
}

/// Reads a statement of settings.
pub(crate) fn read_setting<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for (name, keyword, how) in table(e.statement.name) {
        let Some(field) = Builder::field(e, name) else { continue };
        match how {
            As::Value => {
                let Some(argument) = e.take(keyword) else { continue };
                let Some(id) = b.settings_object(e.class) else { continue };
                e.id = id;
                match field.kind {
                    Kind::Choice(_) => b.set_word(e, field, argument),
                    Kind::Text | Kind::File => b.set_text(e, field, argument),
                    _ => b.set_numbers(e, name, argument),
                }
            }
            As::Word => {
                // Of several the last one counts; the others stay unread, and are reported as that.
                let last = |known: &[&'static str]| {
                    let mut given = e.statement.arguments.iter().rev().filter(|a| a.form == Form::Flag);
                    given.find_map(|a| known.iter().copied().find(|word| *word == a.keyword))
                };
                // `SI2` alone is an integrator of old files; behind another one it is its formulation.
                let (keyword, word) = match (*name, last(INTEGRATORS), last(FORMULATIONS)) {
                    ("integrator_type", Some(word), _) | ("formulation", Some(_), Some(word)) => {
                        (word, word.to_ascii_lowercase())
                    }
                    ("integrator_type", None, Some("SI2")) => ("SI2", "si2_gstiff".to_string()),
                    ("formulation", None, Some(word)) if word != "SI2" => {
                        without_integrator(b, e, word);
                        continue;
                    }
                    _ => continue,
                };
                e.flag(keyword);
                if let Some(id) = b.settings_object(e.class) {
                    b.store(id, name, Value::Text(word));
                }
            }
            As::On | As::Off | As::OnUnlessOff => {
                let given = e.flag(keyword);
                let on = matches!(how, As::On);
                // What a statement without the word says is what a model says without the setting, but
                // for words that stand there unless told otherwise.
                let unless = matches!(how, As::OnUnlessOff);
                if given == unless {
                    continue;
                }
                let Some(id) = b.settings_object(e.class) else { continue };
                let value = match field.kind {
                    Kind::Text => Value::Text(if on { "on" } else { "off" }.to_string()),
                    _ => Value::Flag(on),
                };
                b.store(id, name, value);
            }
        }
    }
}

/// Says of a formulation that stands alone that nobody knows what it is one of.
fn without_integrator(b: &mut Builder<'_>, e: &mut Entry<'_>, word: &'static str) {
    let argument = e.statement.arguments.iter().rev().find(|a| a.keyword == word);
    let Some(at) = argument.map(|a| a.span) else { return };
    e.flag(word);
    let message = format!("`{word}` of {} is not read: it stands without an integrator", e.name());
    let alone = Diagnostic::warning("dataset/argument-not-read", message).at(at, "left out");
    b.report(alone.help(format!("name the integrator too: `INTEGRATOR/GSTIFF, {word}`")));
}
