//! What can be wrong with a file, as diagnostics.

use std::fmt::Display;
use std::path::Path;

use rusqlite::ErrorCode;
use text::Diagnostic;

pub fn not_a_model(path: &Path) -> Diagnostic {
    Diagnostic::error("store/not-a-model", format!("{} is not a model file of Flexure", path.display()))
        .help("`.fx` files are written by `flexure convert MODEL.cmd MODEL.fx` and by `flexure shell --save`")
}

pub fn newer(path: &Path, version: i64, known: i64) -> Diagnostic {
    Diagnostic::error("store/newer-version", format!("{} is written by a newer Flexure", path.display()))
        .note(format!("its layout is number {version}; this program knows layouts up to {known}"))
        .help("use the newer program, there `flexure convert` writes the model as `.cmd`")
}

pub fn damaged(path: &Path, how: impl Display) -> Diagnostic {
    Diagnostic::error("store/damaged", format!("{} is damaged; nothing of it was read", path.display()))
        .note(how.to_string())
        .help("restore the file from a copy, or build the model again from its command file")
}

pub fn in_use(path: &Path, holder: Option<&str>) -> Diagnostic {
    let who = holder.unwrap_or("another program");
    Diagnostic::error("store/in-use", format!("{} is in use by {who}", path.display()))
        .help("end that session first, or open the file with --read-only")
}

pub fn cannot_write(path: &Path, why: impl Display) -> Diagnostic {
    Diagnostic::error("store/cannot-write", format!("cannot write {}: {why}", path.display()))
}

pub fn cannot_open(path: &Path, why: impl Display) -> Diagnostic {
    Diagnostic::error("store/cannot-open", format!("cannot open {}: {why}", path.display()))
}

/// What SQLite says while a file is read.
pub fn while_reading(path: &Path, error: &rusqlite::Error) -> Diagnostic {
    match error.sqlite_error_code() {
        Some(ErrorCode::NotADatabase) => not_a_model(path),
        Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => in_use(path, None),
        Some(ErrorCode::CannotOpen | ErrorCode::PermissionDenied | ErrorCode::SystemIoFailure) => {
            cannot_open(path, error)
        }
        // Everything else is an answer that an undamaged file does not give.
        _ => damaged(path, error),
    }
}

/// What SQLite says while a file is written.
pub fn while_writing(path: &Path, error: &rusqlite::Error) -> Diagnostic {
    match error.sqlite_error_code() {
        Some(ErrorCode::DatabaseBusy | ErrorCode::DatabaseLocked) => in_use(path, None),
        Some(ErrorCode::DatabaseCorrupt | ErrorCode::NotADatabase) => damaged(path, error),
        _ => cannot_write(path, error),
    }
}
