//! The file: opened, followed, written as a whole.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use model::{Database, ObjectId};
use rusqlite::{Connection, OpenFlags, OptionalExtension, Transaction, TransactionBehavior, params};
use schema::Registry;
use text::Diagnostic;

use crate::{
    lock::Lock,
    rows::{self, ObjectRow},
    seal::{Seal, sum},
    troubles,
};

/// `FLXR`: the mark by which `file` and others may know these files.
const APPLICATION: i64 = 0x464C_5852;
/// Number of the layout below.
const LAYOUT: i64 = 1;
const TABLES: &str = "
CREATE TABLE object (id INTEGER PRIMARY KEY, parent INTEGER, class TEXT NOT NULL, name TEXT NOT NULL,
                     content TEXT NOT NULL, sum INTEGER NOT NULL) STRICT;
CREATE TABLE session (key TEXT PRIMARY KEY, content TEXT NOT NULL, sum INTEGER NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE journal (number INTEGER PRIMARY KEY, command TEXT NOT NULL, sum INTEGER NOT NULL) STRICT;
CREATE TABLE seal (id INTEGER PRIMARY KEY CHECK (id = 1), rows INTEGER NOT NULL, total INTEGER NOT NULL) STRICT;
INSERT INTO seal VALUES (1, 0, 0);
";
/// Key of the settings of the database; the others belong to whoever gave them.
const SETTINGS: &str = "settings";
/// How long another program that looks into the file is waited for.
const PATIENCE: Duration = Duration::from_millis(500);

/// How a file is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// This session alone writes it.
    Write,
    /// It is read once; another session may hold it.
    Read,
}

/// What a file holds.
#[derive(Debug)]
pub struct Content {
    pub database: Database,
    /// What else the session wants to find again, by key.
    pub session: BTreeMap<String, String>,
    /// Commands that were accepted, in order.
    pub journal: Vec<String>,
}

/// A file that follows a session.
#[derive(Debug)]
pub struct Store {
    connection: Connection,
    path: PathBuf,
    seal: Seal,
    /// Entries of the session as they stand in the file.
    session: BTreeMap<String, String>,
    /// Number of the last command in the journal.
    journal: i64,
    /// Taken back last of all.
    _lock: Lock,
}

type Outcome<T> = Result<T, Diagnostic>;

/// Reads a file once.
///
/// # Errors
/// If it cannot be opened, or is damaged, foreign or too new.
pub fn read(path: &Path, registry: &Registry) -> Outcome<Content> {
    let connection = connect(path, Access::Read)?;
    load(&connection, path, registry).map(|(content, _)| content)
}

/// Writes a file as a whole; the one it replaces stays until the new one is on the disk.
///
/// # Errors
/// If it is in use by another session, or cannot be written.
pub fn write(path: &Path, database: &Database, session: &BTreeMap<String, String>, journal: &[String]) -> Outcome<()> {
    let _lock = Lock::take(path)?;
    write_locked(path, database, session, journal)
}

fn write_locked(
    path: &Path,
    database: &Database,
    session: &BTreeMap<String, String>,
    journal: &[String],
) -> Outcome<()> {
    let new = beside(path, &format!(".new-{}", std::process::id()));
    let _ = std::fs::remove_file(&new);
    let written = fill(&new, database, session, journal);
    let placed = written.and_then(|()| {
        // What an ended session left of the old file must not be read into the new one.
        for rest in ["-wal", "-shm", "-journal"] {
            let _ = std::fs::remove_file(beside(path, rest));
        }
        std::fs::rename(&new, path).map_err(|e| troubles::cannot_write(path, e))
    });
    if placed.is_err() {
        let _ = std::fs::remove_file(&new);
    }
    placed
}

fn beside(path: &Path, more: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(more);
    PathBuf::from(name)
}

fn fill(path: &Path, database: &Database, session: &BTreeMap<String, String>, journal: &[String]) -> Outcome<()> {
    let failed = |e: rusqlite::Error| troubles::while_writing(path, &e);
    let mut connection = Connection::open(path).map_err(failed)?;
    connection.pragma_update(None, "synchronous", "FULL").map_err(failed)?;
    connection.pragma_update(None, "application_id", APPLICATION).map_err(failed)?;
    connection.pragma_update(None, "user_version", LAYOUT).map_err(failed)?;
    let transaction = connection.transaction().map_err(failed)?;
    transaction.execute_batch(TABLES).map_err(failed)?;
    let mut seal = Seal::default();
    put_objects(&transaction, database, database.ids(), &mut seal, path)?;
    let entries = entries(database, session.clone(), path)?;
    put_entries(&transaction, &entries, &BTreeMap::new(), &mut seal).map_err(failed)?;
    for (number, command) in journal.iter().enumerate() {
        put_command(&transaction, number as i64 + 1, command, &mut seal).map_err(failed)?;
    }
    put_seal(&transaction, seal).map_err(failed)?;
    transaction.commit().map_err(failed)?;
    connection.close().map_err(|(_, e)| failed(e))
}

impl Store {
    /// Opens a file for a session that writes it.
    ///
    /// # Errors
    /// If another session holds it, or it is damaged, foreign or too new.
    pub fn open(path: &Path, registry: &Registry) -> Outcome<(Store, Content)> {
        if !path.is_file() {
            return Err(troubles::cannot_open(path, "there is no such file"));
        }
        let lock = Lock::take(path)?;
        Self::open_locked(path, registry, lock)
    }

    fn open_locked(path: &Path, registry: &Registry, lock: Lock) -> Outcome<(Store, Content)> {
        let connection = connect(path, Access::Write)?;
        let (mut content, seal) = load(&connection, path, registry)?;
        let failed = |e: rusqlite::Error| troubles::while_writing(path, &e);
        // Commits append to a log beside the file; each is on the disk before it counts.
        connection.pragma_update(None, "journal_mode", "WAL").map_err(failed)?;
        connection.pragma_update(None, "synchronous", "FULL").map_err(failed)?;
        content.database.watch();
        let mut session = content.session.clone();
        session.insert(SETTINGS.into(), rows::encode_session(&content.database).unwrap_or_default());
        let journal = content.journal.len() as i64;
        Ok((Store { connection, path: path.to_path_buf(), seal, session, journal, _lock: lock }, content))
    }

    /// Writes a new file and follows the session from then on.
    ///
    /// # Errors
    /// As [`write`].
    pub fn create(
        path: &Path,
        registry: &Registry,
        database: &mut Database,
        session: &BTreeMap<String, String>,
        journal: &[String],
    ) -> Outcome<Store> {
        let lock = Lock::take(path)?;
        write_locked(path, database, session, journal)?;
        let (store, _) = Self::open_locked(path, registry, lock)?;
        database.watch();
        database.take_touched();
        Ok(store)
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes what has changed since the last call, with the command that did it. It is on the disk
    /// when this returns.
    ///
    /// # Errors
    /// If it cannot be written; the next call tries again.
    pub fn commit(
        &mut self,
        database: &mut Database,
        session: BTreeMap<String, String>,
        command: Option<&str>,
    ) -> Outcome<()> {
        let touched = database.take_touched();
        let outcome = self.write_changes(database, &touched, session, command);
        if outcome.is_err() {
            database.touch_again(touched);
        }
        outcome
    }

    fn write_changes(
        &mut self,
        database: &Database,
        touched: &std::collections::BTreeSet<ObjectId>,
        session: BTreeMap<String, String>,
        command: Option<&str>,
    ) -> Outcome<()> {
        let path = self.path.clone();
        let failed = |e: rusqlite::Error| troubles::while_writing(&path, &e);
        let entries = entries(database, session, &path)?;
        if touched.is_empty() && command.is_none() && entries == self.session {
            return Ok(());
        }
        let mut seal = self.seal;
        let transaction = self.connection.transaction_with_behavior(TransactionBehavior::Immediate).map_err(failed)?;
        put_objects(&transaction, database, touched.iter().copied(), &mut seal, &path)?;
        put_entries(&transaction, &entries, &self.session, &mut seal).map_err(failed)?;
        if let Some(command) = command {
            put_command(&transaction, self.journal + 1, command, &mut seal).map_err(failed)?;
        }
        put_seal(&transaction, seal).map_err(failed)?;
        transaction.commit().map_err(failed)?;
        self.seal = seal;
        self.session = entries;
        self.journal += i64::from(command.is_some());
        Ok(())
    }
}

impl Drop for Store {
    fn drop(&mut self) {
        // A file at rest is one file: the log is worked in and taken away.
        let _ = self.connection.pragma_update(None, "journal_mode", "DELETE");
    }
}

// ---- writing rows ----

fn entries(
    database: &Database,
    mut session: BTreeMap<String, String>,
    path: &Path,
) -> Outcome<BTreeMap<String, String>> {
    let settings = rows::encode_session(database).map_err(|e| troubles::cannot_write(path, e))?;
    session.insert(SETTINGS.into(), settings);
    Ok(session)
}

fn put_objects(
    transaction: &Transaction,
    database: &Database,
    ids: impl Iterator<Item = ObjectId>,
    seal: &mut Seal,
    path: &Path,
) -> Outcome<()> {
    let failed = |e: rusqlite::Error| troubles::while_writing(path, &e);
    let mut old = transaction.prepare("SELECT sum FROM object WHERE id = ?1").map_err(failed)?;
    let mut put =
        transaction.prepare("INSERT OR REPLACE INTO object VALUES (?1, ?2, ?3, ?4, ?5, ?6)").map_err(failed)?;
    let mut remove = transaction.prepare("DELETE FROM object WHERE id = ?1").map_err(failed)?;
    for id in ids {
        let before: Option<i64> = old.query_row([id.0], |row| row.get(0)).optional().map_err(failed)?;
        let row = rows::encode(database, id).map_err(|e| troubles::cannot_write(path, e))?;
        match row {
            Some(row) => {
                let sum = row.sum();
                if before == Some(sum) {
                    continue;
                }
                let parent = row.parent.map(|p| p.0);
                put.execute(params![id.0, parent, row.class, row.name, row.content, sum]).map_err(failed)?;
                seal.add(sum);
            }
            None if before.is_some() => {
                remove.execute([id.0]).map_err(failed)?;
            }
            None => {}
        }
        before.into_iter().for_each(|sum| seal.take(sum));
    }
    Ok(())
}

fn put_entries(
    transaction: &Transaction,
    new: &BTreeMap<String, String>,
    old: &BTreeMap<String, String>,
    seal: &mut Seal,
) -> rusqlite::Result<()> {
    for (key, content) in old.iter().filter(|(key, content)| new.get(*key) != Some(content)) {
        seal.take(sum("session", &[key, content]));
        transaction.execute("DELETE FROM session WHERE key = ?1", [key])?;
    }
    for (key, content) in new.iter().filter(|(key, content)| old.get(*key) != Some(content)) {
        let sum = sum("session", &[key, content]);
        seal.add(sum);
        transaction.execute("INSERT INTO session VALUES (?1, ?2, ?3)", params![key, content, sum])?;
    }
    Ok(())
}

fn put_command(transaction: &Transaction, number: i64, command: &str, seal: &mut Seal) -> rusqlite::Result<()> {
    let sum = sum("journal", &[&number.to_string(), command]);
    seal.add(sum);
    transaction.execute("INSERT INTO journal VALUES (?1, ?2, ?3)", params![number, command, sum])?;
    Ok(())
}

fn put_seal(transaction: &Transaction, seal: Seal) -> rusqlite::Result<()> {
    transaction.execute("UPDATE seal SET rows = ?1, total = ?2 WHERE id = 1", params![seal.rows, seal.total])?;
    Ok(())
}

// ---- reading ----

fn connect(path: &Path, access: Access) -> Outcome<Connection> {
    let failed = |e: rusqlite::Error| troubles::while_reading(path, &e);
    let size = std::fs::metadata(path).map_err(|e| troubles::cannot_open(path, e))?;
    // SQLite takes nothing at all for an empty database.
    if !size.is_file() || size.len() == 0 {
        return Err(troubles::not_a_model(path));
    }
    let common = OpenFlags::SQLITE_OPEN_NO_MUTEX;
    let open = |flags| -> rusqlite::Result<Connection> {
        let connection = Connection::open_with_flags(path, flags | common)?;
        connection.busy_timeout(PATIENCE)?;
        // The first question opens the file in truth.
        connection.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get::<_, i64>(0))?;
        Ok(connection)
    };
    let read_only = OpenFlags::SQLITE_OPEN_READ_ONLY;
    match access {
        Access::Write => open(OpenFlags::SQLITE_OPEN_READ_WRITE).map_err(failed),
        Access::Read => open(read_only).map_err(failed),
    }
}

fn load(connection: &Connection, path: &Path, registry: &Registry) -> Outcome<(Content, Seal)> {
    let failed = |e: rusqlite::Error| troubles::while_reading(path, &e);
    // One look: what another session writes meanwhile is not seen.
    let look = connection.unchecked_transaction().map_err(failed)?;
    let pragma = |name| look.query_row(&format!("PRAGMA {name}"), [], |row| row.get::<_, i64>(0));
    if pragma("application_id").map_err(failed)? != APPLICATION {
        return Err(troubles::not_a_model(path));
    }
    let layout = pragma("user_version").map_err(failed)?;
    if layout > LAYOUT {
        return Err(troubles::newer(path, layout, LAYOUT));
    }
    let verdict: String = look.query_row("PRAGMA integrity_check(1)", [], |row| row.get(0)).map_err(failed)?;
    if layout < 1 || verdict != "ok" {
        return Err(troubles::damaged(path, verdict));
    }
    let mut found = Seal::default();
    let spoiled = |what: &str| troubles::damaged(path, format!("{what} differs from its checksum"));

    let mut rows = Vec::new();
    let mut query = look.prepare("SELECT id, parent, class, name, content, sum FROM object").map_err(failed)?;
    let mut all = query.query([]).map_err(failed)?;
    while let Some(row) = all.next().map_err(failed)? {
        let read = || -> rusqlite::Result<(ObjectRow, i64)> {
            let parent: Option<u32> = row.get(1)?;
            let (id, parent) = (ObjectId(row.get(0)?), parent.map(ObjectId));
            let object = ObjectRow { id, parent, class: row.get(2)?, name: row.get(3)?, content: row.get(4)? };
            Ok((object, row.get(5)?))
        };
        let (object, sum) = read().map_err(failed)?;
        if object.sum() != sum {
            return Err(spoiled(&format!("the object `{}`", object.name)));
        }
        found.add(sum);
        rows.push(object);
    }
    let mut session = BTreeMap::new();
    for entry in texts(&look, "SELECT key, content, sum FROM session").map_err(failed)? {
        let (key, content, stored) = entry;
        if sum("session", &[&key, &content]) != stored {
            return Err(spoiled(&format!("the entry `{key}`")));
        }
        found.add(stored);
        session.insert(key, content);
    }
    let mut journal = Vec::new();
    let commands = "SELECT CAST(number AS TEXT), command, sum FROM journal ORDER BY number";
    for (number, command, stored) in texts(&look, commands).map_err(failed)? {
        if sum("journal", &[&number, &command]) != stored {
            return Err(spoiled(&format!("command {number} of the journal")));
        }
        found.add(stored);
        journal.push(command);
    }
    let noted = look
        .query_row("SELECT rows, total FROM seal", [], |row| Ok(Seal { rows: row.get(0)?, total: row.get(1)? }))
        .map_err(failed)?;
    if noted != found {
        let how = format!("{} rows are noted and {} are there", noted.rows, found.rows);
        return Err(troubles::damaged(
            path,
            if noted.rows == found.rows { "the sum of all rows is wrong".into() } else { how },
        ));
    }
    let settings = session.remove(SETTINGS).ok_or_else(|| troubles::damaged(path, "the settings are missing"))?;
    let database = rows::restore(rows, &settings, registry).map_err(|e| troubles::damaged(path, e))?;
    Ok((Content { database, session, journal }, found))
}

fn texts(look: &Transaction, query: &str) -> rusqlite::Result<Vec<(String, String, i64)>> {
    let mut query = look.prepare(query)?;
    let found = query.query_map([], |row| Ok((row.get(0)?, row.get(1)?, row.get(2)?)))?;
    found.collect()
}
