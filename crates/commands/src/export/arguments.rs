//! The arguments of exported commands: cells as text in the units and frames of the export.

use model::{Cell, CellKey, ObjectId, Source, Value};
use schema::{Dimension, Field, Group, Kind, Use};

use super::{Phase, Writer};
use crate::{
    evaluation, number, place,
    values::{function_string, text_of},
};

impl Writer<'_> {
    /// The arguments of one command for one object.
    pub(super) fn arguments(&self, id: ObjectId, group: &Group, phase: Phase) -> Vec<(String, String)> {
        let object = self.database.object(id);
        let class = object.class;
        let mut found = Vec::new();
        for field in group.fields {
            let Some(index) = class.cell_index(field.name) else { continue };
            let Some(cell) = object.cells.get(index) else { continue };
            let field = &Field { dimension: self.database.dimension(id, field), ..*field };
            let unused = if phase == Phase::Create { Use::Modify } else { Use::Create };
            if field.usage == unused || field.name == "relative_to" && class.cell_index("location").is_some() {
                continue;
            }
            // Fields that only place or only appear once the object is there are not repeated.
            if field.name == "adams_id" && cell.value == Value::Integer(0) {
                continue;
            }
            let function = matches!(cell.value, Value::Function(_));
            let value = match phase {
                Phase::Create if function => "\"\"".to_string(),
                Phase::Create => match self.value(CellKey::new(id, index), field, cell) {
                    Some(text) => text,
                    None => continue,
                },
                Phase::Functions if function => match &cell.value {
                    Value::Function(f) if !f.is_empty() => quoted_text(&function_string(f, self.database)),
                    _ => continue,
                },
                Phase::Expressions if cell.is_expression() && !function => self.expression(id, field, cell),
                _ => continue,
            };
            found.push((field.name.to_string(), value));
            let points = place::holds_points(field);
            let placed = points || place::PLACING.contains(&field.name);
            if phase == Phase::Expressions && placed && !found.iter().any(|(n, _)| n == "relative_to") {
                let frame = if points {
                    place::frame_of_points(self.database, id)
                } else {
                    self.database.reference(id, "relative_to").or(object.parent)
                };
                if let Some(frame) = frame.filter(|_| class.cell_index("relative_to").is_some()) {
                    found.push(("relative_to".into(), self.name(frame)));
                }
            }
        }
        // One `relative_to` behind all that it concerns.
        if let Some(at) = found.iter().position(|(n, _)| n == "relative_to") {
            let entry = found.remove(at);
            found.push(entry);
        }
        found
    }

    fn expression(&self, id: ObjectId, field: &Field, cell: &Cell) -> String {
        match &cell.source {
            Source::Expression(e) => format!("({})", evaluation::print(e, self.database)),
            Source::Elements(elements) => {
                let mut numbers = cell.value.as_numbers().unwrap_or_default();
                let ratio = self.database.ratio(cell.units, field.dimension);
                for x in &mut numbers {
                    *x *= ratio;
                }
                if matches!(field.kind, Kind::Location | Kind::Orientation) {
                    numbers = self.in_frame(id, field, numbers);
                }
                let text = |(i, e): (usize, &Option<model::Expression>)| match e {
                    Some(e) => format!("({})", evaluation::print(e, self.database)),
                    None => self.number(field, numbers.get(i).copied().unwrap_or(0.0)),
                };
                elements.iter().enumerate().map(text).collect::<Vec<_>>().join(", ")
            }
            Source::Literal => String::new(),
        }
    }

    /// Stored coordinates as they were typed: in the frame `relative_to`.
    fn in_frame(&self, id: ObjectId, field: &Field, numbers: Vec<f64>) -> Vec<f64> {
        let Some(frame) = self.database.reference(id, "relative_to") else { return numbers };
        let parent = self.database.object(id).parent;
        if Some(frame) == parent || numbers.len() != 3 {
            return numbers;
        }
        let parent = parent.map_or(model::Pose::GLOBAL, |p| self.database.global_pose(p));
        let change = self.database.global_pose(frame).inverse().then(&parent);
        let angle = self.database.units().angle.si;
        let v = [numbers[0], numbers[1], numbers[2]];
        if field.kind == Kind::Orientation {
            let turned = change.rotation * model::rotation_of(model::Sequence::BODY_313, v.map(|a| a * angle));
            model::angles_of(&turned).map(|a| a / angle).to_vec()
        } else {
            (change.origin + change.rotation * glam::DVec3::from_array(v)).to_array().to_vec()
        }
    }

    fn number(&self, field: &Field, x: f64) -> String {
        match field.kind {
            Kind::Integer => format!("{}", x as i64),
            Kind::Orientation => self.angle(x),
            _ if is_angle(field) => self.angle(x),
            _ => number::real(x),
        }
    }

    fn angle(&self, x: f64) -> String {
        let angle = self.database.units().angle;
        if angle.name == "degrees" { number::angle(x) } else { number::real(x) }
    }

    /// The text of a value; none for what cannot be written.
    fn value(&self, key: CellKey, field: &Field, cell: &Cell) -> Option<String> {
        let _ = key;
        let ratio = self.database.ratio(cell.units, field.dimension);
        Some(match &cell.value {
            Value::Nothing => return None,
            // What an expression computes is set again by it: as many digits as Adams writes will do.
            Value::Number(x) if cell.is_expression() && !is_angle(field) => {
                number::real(number::ten_decimals(x * ratio))
            }
            Value::Number(x) => self.number(field, x * ratio),
            // Colours are objects.
            Value::Text(text) if field.name == "color" => model::quoted(text),
            Value::Integer(i) => i.to_string(),
            Value::Array(array) => {
                array.values.iter().map(|x| self.number(field, x * ratio)).collect::<Vec<_>>().join(", ")
            }
            Value::Flag(flag) => match field.kind {
                Kind::Boolean(yes, no) => (if *flag { yes } else { no }).to_string(),
                _ => i64::from(*flag).to_string(),
            },
            Value::Text(text) if matches!(field.kind, Kind::Choice(_)) => text.clone(),
            Value::Texts(texts) if matches!(field.kind, Kind::Choice(_)) => texts.join(", "),
            Value::Text(text) => quoted_text(text),
            Value::Texts(texts) if texts.is_empty() => return None,
            Value::Texts(texts) => texts.iter().map(|t| quoted_text(t)).collect::<Vec<_>>().join(", "),
            Value::Objects(ids) if ids.is_empty() => return None,
            Value::Object(id) if self.database.get(*id).is_none() => return None,
            Value::Object(_) | Value::Objects(_) => text_of(&cell.value, self.database),
            Value::Function(f) => quoted_text(&function_string(f, self.database)),
        })
    }
}

/// Angles are written with their unit, but not the values of variables.
fn is_angle(field: &Field) -> bool {
    field.kind == Kind::Orientation || field.dimension == Dimension::ANGLE && field.quantity_in.is_none()
}

/// A text in quotes, with what needs it escaped.
fn quoted_text(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
