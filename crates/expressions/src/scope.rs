//! What an expression sees: the model, who owns it, and the texts that errors point into.

use model::{Database, ObjectId};
use text::{Diagnostic, Sources};

use crate::World;

/// Errors travel boxed inside this room: a diagnostic is large and rare.
pub(crate) type Outcome<T> = Result<T, Box<Diagnostic>>;

/// An error found while evaluating; the caller knows the place.
pub(crate) fn problem(code: &'static str, message: impl Into<String>) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(code, message))
}

/// Surroundings of an expression.
#[derive(Clone, Copy, Debug)]
pub struct Scope<'a> {
    pub database: &'a Database,
    /// Object whose cell the expression fills. LOC_RELATIVE_TO, ORI_RELATIVE_TO and the ORI
    /// functions that aim at frames answer in the frame of its parent; without owner, global.
    pub owner: Option<ObjectId>,
    /// Frame of those answers when the owner does not exist yet: its future parent.
    pub frame: Option<ObjectId>,
    pub sources: &'a Sources,
    /// The world outside; none: it may be looked at, but nothing is changed and nothing printed.
    pub world: Option<&'a World>,
}

impl<'a> Scope<'a> {
    /// An expression that belongs to no object: frames are global.
    pub fn new(database: &'a Database, sources: &'a Sources) -> Scope<'a> {
        Scope { database, owner: None, frame: None, sources, world: None }
    }

    /// The expression fills a cell of an existing object.
    #[must_use]
    pub fn owned_by(self, owner: ObjectId) -> Scope<'a> {
        Scope { owner: Some(owner), ..self }
    }

    /// The expression will fill a cell of an object to be created below `parent`.
    #[must_use]
    pub fn in_frame(self, parent: ObjectId) -> Scope<'a> {
        Scope { frame: Some(parent), ..self }
    }

    /// The expression belongs to a session with these surroundings.
    #[must_use]
    pub fn in_world(self, world: &'a World) -> Scope<'a> {
        Scope { world: Some(world), ..self }
    }

    /// Object in whose frame the owner's locations are stored; none: global.
    pub(crate) fn owner_frame(&self) -> Option<ObjectId> {
        self.frame.or_else(|| self.database.get(self.owner?)?.parent)
    }
}
