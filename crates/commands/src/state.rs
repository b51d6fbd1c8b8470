//! What a session knows beside its database, as texts by key: for a file that keeps the session.
//!
//! A new field of [`Interpreter`] that outlives a command belongs here too.

use std::collections::BTreeMap;

use model::{Database, ObjectId, UnitsId};

use crate::{Interpreter, kept::Kept, macros::Macros, names::Names, tree::CommandTree};

const UNMADE: &str = "unmade";
const UNMADE_SOLIDS: &str = "unmade_solids";
const KEPT: &str = "kept/";
const MACRO: &str = "macro/";
/// Between a parameter and its value, and between parameters; no text that is typed has them.
const UNIT: char = '\u{1f}';
const RECORD: char = '\u{1e}';

impl Interpreter {
    /// What must be put back beside the database for the session to go on as it was.
    pub fn state(&self) -> BTreeMap<String, String> {
        let mut state = BTreeMap::new();
        if !self.unmade.is_empty() {
            let mut names: Vec<&str> = self.unmade.iter().map(String::as_str).collect();
            names.sort_unstable();
            state.insert(UNMADE.to_string(), names.join("\n"));
        }
        if !self.unmade_solids.is_empty() {
            state.insert(UNMADE_SOLIDS.to_string(), self.unmade_solids.join("\n"));
        }
        for (number, kept) in self.kept.iter().enumerate() {
            let frame = kept.frame.map_or_else(|| "-".to_string(), |f| f.0.to_string());
            let text = format!("{} {} {frame}\n{}", kept.model.0, kept.units.0, kept.text);
            state.insert(format!("{KEPT}{number:09}"), text);
        }
        for (id, defaults) in self.macros.updated_defaults() {
            let pairs: Vec<String> = defaults.iter().map(|(name, value)| format!("{name}{UNIT}{value}")).collect();
            state.insert(format!("{MACRO}{:09}", id.0), pairs.join(&RECORD.to_string()));
        }
        state
    }

    /// Goes on with a database and what [`Interpreter::state`] said.
    ///
    /// # Errors
    /// Where an entry cannot be understood; nothing has changed then.
    pub fn restore(&mut self, database: Database, state: &BTreeMap<String, String>) -> Result<(), String> {
        let mut kept = Vec::new();
        let mut defaults = Vec::new();
        for (key, text) in state {
            if let Some(number) = key.strip_prefix(KEPT) {
                kept.push(read_kept(text, &database).ok_or_else(|| format!("the skipped command {number}"))?);
            } else if let Some(id) = key.strip_prefix(MACRO) {
                let id = id.parse().map_err(|_| format!("the macro {id}"))?;
                defaults.push((ObjectId(id), text));
            } else if key != UNMADE && key != UNMADE_SOLIDS {
                return Err(format!("there is an unknown entry `{key}`"));
            }
        }
        let lines = |key: &str| state.get(key).map(|t| t.lines().map(str::to_string)).into_iter().flatten();
        self.unmade = lines(UNMADE).collect();
        self.unmade_solids = lines(UNMADE_SOLIDS).collect();
        self.kept = kept;
        self.database = database;
        self.names = Names::default();
        self.macros = Macros::default();
        self.tree = CommandTree::new(&self.registry);
        (self.undo_blocks, self.suppress_undo) = (0, false);
        let macros: Vec<ObjectId> =
            self.database.ids().filter(|id| self.database.object(*id).class.id == crate::macros::CLASS.id).collect();
        macros.into_iter().for_each(|id| self.register_macro(id));
        for (id, text) in defaults {
            for (name, value) in text.split(RECORD).filter_map(|pair| pair.split_once(UNIT)) {
                self.macros.update_default(id, name, value);
            }
        }
        Ok(())
    }
}

fn read_kept(text: &str, database: &Database) -> Option<Kept> {
    let (head, text) = text.split_once('\n')?;
    let mut words = head.split(' ');
    let model = ObjectId(words.next()?.parse().ok()?);
    let units = UnitsId(words.next()?.parse().ok()?);
    let frame = match words.next()? {
        "-" => None,
        number => Some(ObjectId(number.parse().ok()?)),
    };
    let known = usize::from(units.0) < database.unit_systems().len();
    known.then(|| Kept { model, text: text.to_string(), units, frame })
}
