//! Models as `.fx` files: one SQLite file holds every object of a session with its values and
//! expressions, the settings, and the commands that were accepted.
//!
//! A [`Store`] follows a session: [`Store::commit`] writes what a command has changed, together with
//! the command, in one transaction that is on the disk when it returns. So a process may be killed at
//! any moment. [`Content`] is what a file holds; a file that is damaged, foreign or written by a newer
//! program is refused with a diagnostic, never read in part: every row has a checksum, and a seal sums
//! them up. What a command means is not known here.

mod file;
mod lock;
mod rows;
mod seal;
mod troubles;

pub use file::{Access, Content, Store, read, write};
