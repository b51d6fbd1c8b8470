//! One session at a time writes a file: a lock of the operating system on `MODEL.fx.lock`, which the
//! system itself takes back when the process ends, however it ends. The lock's file says who holds it.

use std::fs::{File, OpenOptions};
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};

use fs4::FileExt;
use text::Diagnostic;

use crate::troubles;

/// Held while a session writes a file.
#[derive(Debug)]
pub struct Lock {
    file: File,
    path: PathBuf,
}

impl Lock {
    /// Takes the lock at once or says who has it.
    pub fn take(model: &Path) -> Result<Lock, Diagnostic> {
        let mut path = model.as_os_str().to_owned();
        path.push(".lock");
        let path = PathBuf::from(path);
        // The file may be taken away between opening and locking it, by the session that ends.
        for _ in 0..100 {
            let opened = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path);
            let mut file = opened.map_err(|e| troubles::cannot_write(&path, e))?;
            if FileExt::try_lock(&file).is_err() {
                let mut holder = String::new();
                let known = file.read_to_string(&mut holder).is_ok() && !holder.trim().is_empty();
                return Err(troubles::in_use(model, known.then(|| holder.trim())));
            }
            if !still_there(&file, &path) {
                continue;
            }
            let holder = format!("process {}{}", std::process::id(), host());
            let noted = file.set_len(0).and_then(|()| file.rewind()).and_then(|()| file.write_all(holder.as_bytes()));
            noted.map_err(|e| troubles::cannot_write(&path, e))?;
            return Ok(Lock { file, path });
        }
        Err(troubles::in_use(model, None))
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // First away, then free: nobody can lock a file that is about to go.
        let _ = std::fs::remove_file(&self.path);
        let _ = FileExt::unlock(&self.file);
    }
}

fn host() -> String {
    let name = std::fs::read_to_string("/etc/hostname").ok().or_else(|| std::env::var("COMPUTERNAME").ok());
    name.map(|n| n.trim().to_string()).filter(|n| !n.is_empty()).map_or_else(String::new, |n| format!(" on {n}"))
}

#[cfg(unix)]
fn still_there(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), std::fs::metadata(path)) {
        (Ok(a), Ok(b)) => a.ino() == b.ino() && a.dev() == b.dev(),
        _ => false,
    }
}

#[cfg(not(unix))]
fn still_there(_: &File, path: &Path) -> bool {
    path.exists()
}
