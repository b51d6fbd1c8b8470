//! What rows say: objects, units and settings as JSON, so that other programs can ask the file too.

use std::collections::{BTreeMap, HashMap};

use indexmap::IndexMap;
use model::{Cell, CellKey, Cells, CoordinateSystem, Database, ObjectId, Sequence, Settings, StoredObject, UnitsId};
use schema::{Class, Registry, UnitName, UnitSystem};
use serde::{Deserialize, Serialize};

/// A row of the table of objects, but for its checksum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjectRow {
    pub id: ObjectId,
    pub parent: Option<ObjectId>,
    pub class: String,
    pub name: String,
    pub content: String,
}

impl ObjectRow {
    pub fn sum(&self) -> i64 {
        let parent = self.parent.map_or_else(String::new, |p| p.0.to_string());
        crate::seal::sum("object", &[&self.id.0.to_string(), &parent, &self.class, &self.name, &self.content])
    }
}

#[derive(Serialize, Deserialize, Default)]
struct ObjectContent {
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    cells: BTreeMap<String, Cell>,
    /// What a cell was computed from: number and field of objects.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    reads: BTreeMap<String, Vec<(ObjectId, String)>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    order: Option<Vec<ObjectId>>,
}

fn field_name(class: &Class, cell: usize) -> Option<&'static str> {
    class.fields().nth(cell).map(|f| f.name)
}

/// A living object as a row.
pub fn encode(database: &Database, id: ObjectId) -> Result<Option<ObjectRow>, String> {
    let Some(stored) = database.stored(id) else { return Ok(None) };
    let name_of = |cell: usize| field_name(stored.class, cell).unwrap_or_default().to_string();
    let mut content = ObjectContent { order: stored.order, ..ObjectContent::default() };
    content.cells.extend(stored.cells.iter().map(|(index, cell)| (name_of(index), cell.clone())));
    for (cell, reads) in stored.reads {
        // What was deleted since is read no more.
        let living = reads.iter().filter_map(|key| {
            let class = database.get(key.object)?.class;
            Some((key.object, field_name(class, usize::from(key.cell))?.to_string()))
        });
        content.reads.insert(name_of(usize::from(cell)), living.collect());
    }
    Ok(Some(ObjectRow {
        id,
        parent: stored.parent,
        class: stored.class.id.to_string(),
        name: stored.name,
        content: serde_json::to_string(&content).map_err(|e| e.to_string())?,
    }))
}

/// All objects of the rows.
pub fn decode(rows: Vec<ObjectRow>, registry: &Registry) -> Result<Vec<StoredObject>, String> {
    let by_id: HashMap<&str, &'static Class> = registry.classes.iter().map(|c| (c.id, *c)).collect();
    let mut classes: HashMap<ObjectId, &'static Class> = HashMap::with_capacity(rows.len());
    for row in &rows {
        let class = by_id.get(row.class.as_str());
        let class = class.ok_or_else(|| format!("`{}` is a `{}`, which is unknown here", row.name, row.class))?;
        classes.insert(row.id, class);
    }
    let cell_of = |class: &'static Class, field: &str| {
        class.cell_index(field).ok_or_else(|| format!("a {} has no `{field}` here", class.id))
    };
    let mut objects = Vec::with_capacity(rows.len());
    for row in rows {
        let Some(&class) = classes.get(&row.id) else { continue };
        let content: ObjectContent = serde_json::from_str(&row.content).map_err(|e| format!("`{}`: {e}", row.name))?;
        let mut cells = Cells::default();
        for (field, cell) in content.cells {
            cells.replace(cell_of(class, &field)?, Some(cell));
        }
        let mut reads = Vec::new();
        for (field, list) in content.reads {
            let mut keys = Vec::with_capacity(list.len());
            for (object, field) in list {
                let read = classes.get(&object).ok_or_else(|| format!("`{}` reads a missing object", row.name))?;
                keys.push(CellKey::new(object, cell_of(read, &field)?));
            }
            reads.push((cell_of(class, &field)? as u16, keys));
        }
        reads.sort_by_key(|(cell, _)| *cell);
        let (id, name, parent, order) = (row.id, row.name, row.parent, content.order);
        objects.push(StoredObject { id, class, name, parent, cells, reads, order });
    }
    Ok(objects)
}

/// What holds for the whole session.
#[derive(Serialize, Deserialize)]
struct SessionContent {
    units: UnitsId,
    coordinate_system: CoordinateSystem,
    sequence: Sequence,
    default_frame: Option<ObjectId>,
    current: IndexMap<String, ObjectId>,
    words: IndexMap<String, String>,
    /// How many objects there have been, so that no number is used again.
    count: usize,
    /// Top-level objects, where their order is not that of their creation.
    roots: Option<Vec<ObjectId>>,
    unit_systems: Vec<Units>,
}

/// A system of units by the names of the units.
#[derive(Serialize, Deserialize)]
struct Units {
    length: String,
    mass: String,
    time: String,
    force: String,
    angle: String,
    frequency: String,
    factor: Option<f64>,
}

pub fn encode_session(database: &Database) -> Result<String, String> {
    // Named one by one, so that a new setting cannot be forgotten here.
    let Settings { units, coordinate_system, sequence, default_frame, current, words } = database.settings();
    let named = |u: &UnitSystem| {
        let UnitSystem { length, mass, time, force, angle, frequency, consistency_factor } = u;
        let word = |unit: &UnitName| unit.name.to_string();
        Units {
            length: word(length),
            mass: word(mass),
            time: word(time),
            force: word(force),
            angle: word(angle),
            frequency: word(frequency),
            factor: *consistency_factor,
        }
    };
    let content = SessionContent {
        units: *units,
        coordinate_system: *coordinate_system,
        sequence: *sequence,
        default_frame: *default_frame,
        current: current.iter().map(|(name, id)| ((*name).to_string(), *id)).collect(),
        words: words.clone(),
        count: database.count_of_all(),
        roots: (!database.roots().is_sorted()).then(|| database.roots().to_vec()),
        unit_systems: database.unit_systems().iter().map(named).collect(),
    };
    serde_json::to_string(&content).map_err(|e| e.to_string())
}

/// Objects and settings as a database.
pub fn restore(objects: Vec<ObjectRow>, session: &str, registry: &Registry) -> Result<Database, String> {
    let content: SessionContent = serde_json::from_str(session).map_err(|e| format!("the settings: {e}"))?;
    let unit = |name: &str| UnitName::find(name).ok_or_else(|| format!("`{name}` is no unit"));
    let mut unit_systems = Vec::new();
    for u in &content.unit_systems {
        unit_systems.push(UnitSystem {
            length: unit(&u.length)?,
            mass: unit(&u.mass)?,
            time: unit(&u.time)?,
            force: unit(&u.force)?,
            angle: unit(&u.angle)?,
            frequency: unit(&u.frequency)?,
            consistency_factor: u.factor,
        });
    }
    let families = registry.classes.iter().flat_map(|c| std::iter::once(c.id).chain(c.families.iter().copied()));
    let known: HashMap<&str, &'static str> = families.map(|name| (name, name)).collect();
    let mut current = IndexMap::default();
    for (name, id) in content.current {
        let name = *known.get(name.as_str()).ok_or_else(|| format!("`{name}` is no kind of object here"))?;
        current.insert(name, id);
    }
    let settings = Settings {
        units: content.units,
        coordinate_system: content.coordinate_system,
        sequence: content.sequence,
        default_frame: content.default_frame,
        current,
        words: content.words,
    };
    Database::restore(decode(objects, registry)?, content.count, content.roots, settings, unit_systems)
}
