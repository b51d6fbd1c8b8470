//! What holds for the session: units, coordinate systems, current defaults, generated names.

use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;
use schema::UnitSystem;
use serde::{Deserialize, Serialize};

use crate::{ObjectId, Sequence};

/// Index of a unit system in [`crate::Database::unit_systems`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct UnitsId(pub u16);

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum CoordinateSystem {
    Cartesian,
    Cylindrical,
    Spherical,
}

/// Settings that `defaults ...` commands change. Undone like everything else.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Units in force.
    pub units: UnitsId,
    pub coordinate_system: CoordinateSystem,
    /// Rotation sequence of orientations typed in; stored orientations are always body 3-1-3.
    pub sequence: Sequence,
    /// Frame that locations and orientations refer to without `relative_to`; none: global.
    pub default_frame: Option<ObjectId>,
    /// Current default object by class id and by family.
    pub current: IndexMap<&'static str, ObjectId, FxBuildHasher>,
    /// Words of other defaults, by command parameter, as given (`axis_and_plane_setting`, ...).
    pub words: IndexMap<String, String>,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            units: UnitsId(0),
            coordinate_system: CoordinateSystem::Cartesian,
            sequence: Sequence::BODY_313,
            default_frame: None,
            current: IndexMap::default(),
            words: IndexMap::new(),
        }
    }
}

/// What a new session's units are.
pub(crate) fn first_units() -> UnitSystem {
    UnitSystem::mmks()
}
