//! Locations and orientations: from what was typed to the frame in which they are stored.
//!
//! A location is read in the current coordinate system and in the frame `relative_to` (or the
//! default frame), an orientation in the current rotation sequence; both are stored in the frame
//! of the object's parent, angles as body 3-1-3.

use glam::{DMat3, DVec3};
use model::{
    Array, CellKey, CoordinateSystem, Database, ObjectId, Pose, Sequence, Source, Value, angles_of, rotation_of,
};
use schema::{Field, Kind};
use syntax::command::{Argument, ItemKind};
use text::Diagnostic;

use crate::{
    call::Call,
    evaluation,
    values::{Draft, Reader},
};

/// Which fields place an object.
pub const PLACING: &[&str] =
    &["location", "orientation", "along_axis_orientation", "in_plane_orientation", "relative_to"];

/// Where something is, in the frame of its parent, with the drafts of its cells.
#[derive(Debug, Default)]
pub struct Placement {
    pub location: Option<Draft>,
    pub orientation: Option<Draft>,
    /// The frame that kept expressions refer to.
    pub relative_to: Option<ObjectId>,
}

/// Reads the placing arguments of a call. `object` is the object that is placed (its old location
/// is where axes are aimed from if none is given), `parent` what it belongs to.
pub fn read(
    reader: &mut Reader,
    call: &Call,
    object: Option<ObjectId>,
    parent: Option<ObjectId>,
) -> Result<Placement, Vec<Diagnostic>> {
    read_one(reader, call, object, parent, 0)
}

/// As [`read`], where a location may be several places: takes the one of that number, or the only one.
pub fn read_one(
    reader: &mut Reader,
    call: &Call,
    object: Option<ObjectId>,
    parent: Option<ObjectId>,
    which: usize,
) -> Result<Placement, Vec<Diagnostic>> {
    let database = reader.database;
    let frame = match (call.argument("relative_to"), call.field("relative_to")) {
        (Some(argument), Some(field)) => {
            let field = *field;
            reader.read(&field, argument)?.value.as_object()
        }
        _ => database.settings().default_frame.filter(|f| database.get(*f).is_some()),
    };
    let pose = |id: Option<ObjectId>| id.map_or(Pose::GLOBAL, |id| database.global_pose(id));
    // From the frame values are read in to the frame they are stored in.
    let convert = if frame == parent { Pose::GLOBAL } else { pose(parent).inverse().then(&pose(frame)) };
    // The model stands for the global frame, so that a kept expression always has one.
    let relative_to = frame.or_else(|| parent.and_then(|p| database.model_of(p)));
    let mut placement = Placement { relative_to, ..Placement::default() };
    let frame_reads = || {
        let frames = if frame == parent { [None; 2] } else { [frame, parent] };
        frames.into_iter().flatten().filter(|id| Some(*id) != object).flat_map(|id| database.pose_reads(id))
    };

    let mut origin = object.map_or(DVec3::ZERO, |o| database.local_pose(o).origin);
    if let (Some(argument), Some(field)) = (call.argument("location"), call.field("location")) {
        let field = *field;
        let mut draft = reader.read(&field, argument)?;
        let numbers = draft.value.numbers();
        if !numbers.len().is_multiple_of(3) {
            return Err(vec![
                Diagnostic::error(
                    "command/wrong-count",
                    format!("`location` wants three numbers for each place, not {}", numbers.len()),
                )
                .at(argument.value_span, format!("{} given", numbers.len()))
                .help("give three numbers for both ends, or six for one place each")
                .adams("Invalid input. Enter a location."),
            ]);
        }
        let numbers = numbers.chunks(3).nth(which).unwrap_or(numbers);
        let typed = if draft.source == Source::Literal || matches!(draft.source, Source::Elements(_)) {
            cartesian(database, numbers)
        } else {
            vector(numbers)
        };
        origin = if convert == Pose::GLOBAL { typed } else { convert.origin + convert.rotation * typed };
        draft.value = Value::Array(Array::column(origin.to_array().to_vec()));
        finish(&mut draft, frame_reads);
        placement.location = Some(draft);
    }
    placement.orientation =
        if let (Some(argument), Some(field)) = (call.argument("orientation"), call.field("orientation")) {
            let field = *field;
            let mut draft = reader.read(&field, argument)?;
            let typed = vector(draft.value.numbers());
            let sequence = if body_313(argument) { Sequence::BODY_313 } else { database.settings().sequence };
            // Angles that need no conversion are stored as typed.
            if convert.rotation != DMat3::IDENTITY || sequence != Sequence::BODY_313 {
                let angle = database.units().angle.si;
                let typed = rotation_of(sequence, typed.to_array().map(|a| a * angle));
                draft.value = angles_value(database, &(convert.rotation * typed));
            } else {
                draft.value = Value::Array(Array::column(typed.to_array().to_vec()));
            }
            finish(&mut draft, frame_reads);
            Some(draft)
        } else {
            aimed(reader, call, &convert, origin)?
        };
    Ok(placement)
}

/// Whether a field holds points of a shape, any number of them, and not the place of an object.
pub fn holds_points(field: &Field) -> bool {
    field.kind == Kind::Location && field.count.most == usize::MAX
}

/// The frame in which the points of an object are stored: its reference marker, else its parent.
pub fn frame_of_points(database: &Database, id: ObjectId) -> Option<ObjectId> {
    database.reference(id, "reference_marker").or(database.object(id).parent)
}

/// Reads the points of an object into the frame they are stored in. Expressions are kept where they
/// are in that frame already.
pub fn read_points(
    reader: &mut Reader,
    call: &Call,
    field: &Field,
    argument: &Argument,
    id: ObjectId,
) -> Result<Draft, Vec<Diagnostic>> {
    let database = reader.database;
    let frame = match (call.argument("relative_to"), call.field("relative_to").copied()) {
        (Some(argument), Some(field)) => reader.read(&field, argument)?.value.as_object(),
        _ => database.settings().default_frame.filter(|f| database.get(*f).is_some()),
    };
    let own = frame_of_points(database, id);
    let mut draft = reader.read(field, argument)?;
    let numbers = draft.value.as_numbers().unwrap_or_default();
    if !numbers.len().is_multiple_of(3) {
        return Err(vec![
            Diagnostic::error("command/wrong-count", format!("`{}` wants points of three numbers each", field.name))
                .at(argument.value_span, format!("{} numbers", numbers.len()))
                .adams("Invalid input. Enter a location."),
        ]);
    }
    let typed = |c: &[f64]| match draft.source {
        // What an expression yields is in x, y and z.
        Source::Expression(_) => vector(c),
        _ => cartesian(database, c),
    };
    let mut points: Vec<DVec3> = numbers.chunks_exact(3).map(typed).collect();
    if frame != own {
        let pose = |f: Option<ObjectId>| f.map_or(Pose::GLOBAL, |f| database.global_pose(f));
        let convert = pose(own).inverse().then(&pose(frame));
        points = points.iter().map(|p| convert.origin + convert.rotation * *p).collect();
        if draft.source != Source::Literal {
            let name = |f: Option<ObjectId>| f.map_or_else(|| "the global frame".into(), |f| database.full_name(f));
            reader.warnings.push(
                Diagnostic::warning(
                    "place/expression-not-kept",
                    format!("`{}` keeps the present values of its expressions alone", field.name),
                )
                .at(argument.value_span, format!("in the axes of {}", name(frame)))
                .note(format!("its points are stored in the axes of {}", name(own)))
                .help(format!("give the points with `relative_to = {}` to have them follow", name(own))),
            );
            draft = Draft::literal(draft.value);
        }
    }
    draft.value = Value::Array(Array::column(points.iter().flat_map(DVec3::to_array).collect()));
    Ok(draft)
}

fn finish<I: Iterator<Item = CellKey>>(draft: &mut Draft, frame_reads: impl Fn() -> I) {
    if draft.source != Source::Literal {
        for read in frame_reads() {
            if !draft.reads.contains(&read) {
                draft.reads.push(read);
            }
        }
    }
}

fn body_313(argument: &Argument) -> bool {
    match argument.values.as_slice() {
        [item] => matches!(&item.kind, ItemKind::Expression(e) if evaluation::yields_body_313(e)),
        _ => false,
    }
}

fn vector(numbers: &[f64]) -> DVec3 {
    let at = |i: usize| numbers.get(i).copied().unwrap_or(0.0);
    DVec3::new(at(0), at(1), at(2))
}

/// Coordinates typed in the current coordinate system, as x, y, z.
pub fn cartesian(database: &Database, numbers: &[f64]) -> DVec3 {
    let v = vector(numbers);
    let angle = database.units().angle.si;
    match database.settings().coordinate_system {
        CoordinateSystem::Cartesian => v,
        // Radius, angle from x about z, height.
        CoordinateSystem::Cylindrical => DVec3::new(v.x * (v.y * angle).cos(), v.x * (v.y * angle).sin(), v.z),
        // Distance, angle from x about z, angle from z.
        CoordinateSystem::Spherical => {
            let (turn, tilt) = (v.y * angle, v.z * angle);
            DVec3::new(v.x * tilt.sin() * turn.cos(), v.x * tilt.sin() * turn.sin(), v.x * tilt.cos())
        }
    }
}

fn angles_value(database: &Database, rotation: &DMat3) -> Value {
    let angle = database.units().angle.si;
    Value::Array(Array::column(angles_of(rotation).iter().map(|a| a / angle).collect()))
}

/// Axes aimed at points; the axes in question are those of `defaults orient_axis_and_plane`.
fn aimed(reader: &mut Reader, call: &Call, convert: &Pose, origin: DVec3) -> Result<Option<Draft>, Vec<Diagnostic>> {
    let database = reader.database;
    let setting = database.settings().words.get("axis_and_plane_setting").map_or("z_axis_xz_plane", String::as_str);
    let (first, second) = axes(setting);
    let mut points = |name: &str| -> Result<Option<Vec<DVec3>>, Vec<Diagnostic>> {
        let (Some(argument), Some(field)) = (call.argument(name), call.field(name)) else { return Ok(None) };
        let field = *field;
        let draft = reader.read(&field, argument)?;
        let numbers = draft.value.as_numbers().unwrap_or_default();
        if numbers.len() % 3 != 0 {
            return Err(vec![
                Diagnostic::error("command/wrong-count", format!("`{name}` wants points of three numbers each"))
                    .at(argument.value_span, format!("{} numbers", numbers.len()))
                    .adams("Invalid input. Enter a location."),
            ]);
        }
        let point = |c: &[f64]| convert.origin + convert.rotation * cartesian(database, c);
        Ok(Some(numbers.chunks(3).map(point).collect()))
    };
    let (name, rotation) = if let Some(points) = points("along_axis_orientation")? {
        let direction = match points.as_slice() {
            [to] => *to - origin,
            [from, to, ..] => *to - *from,
            [] => DVec3::ZERO,
        };
        ("along_axis_orientation", along(first, direction))
    } else if let Some(points) = points("in_plane_orientation")? {
        let (direction, side) = match points.as_slice() {
            [a, b] => (*a - origin, *b - origin),
            [a, b, c, ..] => (*b - *a, *c - *a),
            _ => (DVec3::ZERO, DVec3::ZERO),
        };
        ("in_plane_orientation", in_plane(first, second, direction, side))
    } else {
        return Ok(None);
    };
    let Some(rotation) = rotation else {
        let span = call.argument(name).map_or(call.span, |a| a.value_span);
        return Err(vec![
            Diagnostic::error("value/no-direction", format!("the points of `{name}` give no direction"))
                .at(span, "points coincide or lie on one line")
                .adams("Invalid input. Enter a location."),
        ]);
    };
    Ok(Some(Draft::literal(angles_value(database, &rotation))))
}

/// Reads `z_axis_xz_plane`: the axis that is aimed and the other axis of the plane.
fn axes(setting: &str) -> (usize, usize) {
    let axis = |c: Option<char>| match c {
        Some('x') => 0,
        Some('y') => 1,
        _ => 2,
    };
    let first = axis(setting.chars().next());
    let plane = setting.split('_').nth(2).unwrap_or("xz");
    let second = plane.chars().map(|c| axis(Some(c))).find(|a| *a != first).unwrap_or((first + 1) % 3);
    (first, second)
}

/// A frame whose axis `first` points along `direction`; for z its third body 3-1-3 angle is 0, for
/// the other axes the same rule holds with the axes exchanged in turn.
fn along(first: usize, direction: DVec3) -> Option<DMat3> {
    let aim = direction.try_normalize()?;
    // The next axis is perpendicular to the aim and lies in the plane normal to the same global axis.
    let normal = [DVec3::X, DVec3::Y, DVec3::Z][first];
    let next = normal.cross(aim).try_normalize().unwrap_or([DVec3::Y, DVec3::Z, DVec3::X][first]);
    let last = aim.cross(next);
    let mut columns = [DVec3::ZERO; 3];
    columns[first] = aim;
    columns[(first + 1) % 3] = next;
    columns[(first + 2) % 3] = last;
    Some(DMat3::from_cols(columns[0], columns[1], columns[2]))
}

/// A frame whose axis `first` points along `direction` and whose axis `second` is on the side of
/// `side` in their common plane.
fn in_plane(first: usize, second: usize, direction: DVec3, side: DVec3) -> Option<DMat3> {
    let aim = direction.try_normalize()?;
    let across = (side - aim * aim.dot(side)).try_normalize()?;
    let third = 3 - first - second;
    let mut columns = [DVec3::ZERO; 3];
    columns[first] = aim;
    columns[second] = across;
    columns[third] = if (first + 1) % 3 == second { aim.cross(across) } else { across.cross(aim) };
    Some(DMat3::from_cols(columns[0], columns[1], columns[2]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: right-handed orthonormal frames by construction; the aimed axis is the direction.
    #[test]
    fn aimed_frames_are_rotations_with_the_axis_on_target() {
        for direction in [DVec3::new(1.0, 2.0, -0.5), DVec3::Z, -DVec3::X, DVec3::Y] {
            for first in 0..3 {
                let frame = along(first, direction).unwrap();
                assert!((frame.determinant() - 1.0).abs() < 1e-12);
                assert!(frame.col(first).abs_diff_eq(direction.normalize(), 1e-12));
                for second in (0..3).filter(|s| *s != first) {
                    let side = DVec3::new(0.3, -0.7, 0.9);
                    let frame = in_plane(first, second, direction, side).unwrap();
                    assert!((frame.determinant() - 1.0).abs() < 1e-12);
                    assert!(frame.col(first).abs_diff_eq(direction.normalize(), 1e-12));
                    assert!(frame.col(second).dot(side) > 0.0);
                }
            }
        }
    }

    #[test]
    fn settings_name_axis_and_plane() {
        assert_eq!(axes("z_axis_xz_plane"), (2, 0));
        assert_eq!(axes("x_axis_xy_plane"), (0, 1));
        assert_eq!(axes("y_axis_yz_plane"), (1, 2));
    }
}
