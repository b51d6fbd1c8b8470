//! Functions of files and folders. Those that change something need a session that allows it.

use std::path::{Path, PathBuf};

use model::Value;

use super::{Arguments, Function, function, momentary};
use crate::{arithmetic::flag, scope::Outcome};

pub const TABLE: &[Function] = &[
    momentary("BACKUP_FILE", "file", "renames a file to its name with %; 0 if that worked", |a| {
        let from = a.path(0)?;
        a.changes()?;
        let mut to = from.clone().into_os_string();
        to.push("%");
        failed(std::fs::rename(from, to).is_ok())
    }),
    momentary("CHDIR", "folder", "changes the working folder; 1 if that worked", |a| {
        let to = a.path(0)?;
        a.changes()?;
        Ok(flag(std::env::set_current_dir(to).is_ok()))
    }),
    momentary("COPY_FILES", "from, to", "copies a file to a file or folder; 1 if that worked", |a| {
        let (from, mut to) = (a.path(0)?, a.path(1)?);
        a.changes()?;
        if to.is_dir()
            && let Some(name) = from.file_name()
        {
            to = to.join(name);
        }
        // A copy onto itself would empty the file.
        let same = from.canonicalize().ok().is_some_and(|f| to.canonicalize().ok() == Some(f));
        Ok(flag(!same && std::fs::copy(from, to).is_ok()))
    }),
    function("FILE_DIRECTORY_NAME", "file", "the folder part of a file name", |a| {
        let name = a.text(0)?;
        Ok(Value::Text(name.rfind(['/', '\\']).map_or_else(String::new, |at| name[..at.max(1)].to_string())))
    }),
    momentary("FILE_EXISTS", "file", "1 if a file exists", |a| Ok(flag(a.path(0)?.exists()))),
    function("FILE_MINUS_EXT", "file", "a file name without its ending", |a| {
        let name = a.text(0)?;
        let start = name.rfind(['/', '\\']).map_or(0, |at| at + 1);
        let end = name[start..].rfind('.').filter(|at| *at > 0).map_or(name.len(), |at| start + at);
        Ok(Value::Text(name[..end].to_string()))
    }),
    momentary("FILE_TEMP_NAME", "", "a name in the folder for temporary files that no file has", |_| {
        let base = std::env::temp_dir().join("flexure").display().to_string();
        Ok(Value::Text(free_name(&base)))
    }),
    momentary("GETCWD", "", "working folder", |a| {
        let folder =
            std::env::current_dir().map_err(|e| a.error(format!("the working folder is not readable: {e}")))?;
        Ok(Value::Text(folder.to_string_lossy().into_owned()))
    }),
    momentary("MKDIR", "folder", "makes a folder; 1 if that worked", |a| {
        let folder = a.path(0)?;
        a.changes()?;
        Ok(flag(std::fs::create_dir(folder).is_ok()))
    }),
    momentary("REMOVE_FILE", "file", "deletes a file; 0 if that worked", |a| {
        let file = a.path(0)?;
        a.changes()?;
        failed(std::fs::remove_file(file).is_ok())
    }),
    momentary("RENAME_FILE", "from, to", "renames a file; 0 if that worked", |a| {
        let (from, to) = (a.path(0)?, a.path(1)?);
        a.changes()?;
        failed(std::fs::rename(from, to).is_ok())
    }),
    momentary("RMDIR", "folder", "deletes an empty folder; 1 if that worked", |a| {
        let folder = a.path(0)?;
        a.changes()?;
        Ok(flag(std::fs::remove_dir(folder).is_ok()))
    }),
    momentary("UNIQUE_FILE_NAME", "base", "a name that no file has", |a| Ok(Value::Text(free_name(&a.text(0)?)))),
];

/// 0 for success, as functions that follow C's have it.
fn failed(worked: bool) -> Outcome<Value> {
    Ok(Value::Integer(i64::from(!worked)))
}

fn free_name(base: &str) -> String {
    let mut n = 1_u64;
    loop {
        let name = format!("{base}_{n}");
        if !Path::new(&name).exists() {
            return name;
        }
        n += 1;
    }
}

impl Arguments<'_, '_> {
    /// The name of a file; a zero byte cannot be part of one.
    fn path(&self, i: usize) -> Outcome<PathBuf> {
        let name = self.text(i)?;
        if name.is_empty() || name.contains('\0') {
            return Err(self.error("a file needs a name"));
        }
        Ok(PathBuf::from(name))
    }
}
