//! Cells of an outline to its lines.

use glam::DVec3;
use model::{Database, ObjectId, Pose, Value};
use text::Diagnostic;

use crate::{
    geometry::Placed,
    place::{Cells, OnBody, on_body},
    shape::Shape,
};

/// Lines from marker to marker, without the pieces that are switched off.
pub fn shape(database: &Database, id: ObjectId) -> Result<Placed, Diagnostic> {
    let cells = Cells { database, id };
    let on = on_body(database, id).ok_or_else(|| cells.trouble("geometry/no-body", "is on no body"))?;
    let body = OnBody { body: on.body, pose: Pose::GLOBAL };
    let markers = database.value(id, "marker_name").map(Value::objects).unwrap_or_default();
    let mut points: Vec<DVec3> = Vec::new();
    for marker in markers {
        let place = on_body(database, marker)
            .ok_or_else(|| cells.trouble("geometry/no-body", "has a marker that is on no body"))?;
        points.push(cells.relative(&body, &place).origin);
    }
    if points.len() < 2 {
        return Err(cells.trouble("geometry/missing-value", "has fewer than two markers"));
    }
    if database.flag(id, "close") == Some(true) {
        points.push(points[0]);
    }
    let shown: Vec<String> = match database.value(id, "visibility_between_markers") {
        Some(Value::Texts(words)) => words.clone(),
        Some(Value::Text(word)) => vec![word.clone()],
        _ => Vec::new(),
    };
    let mut lines: Vec<Vec<DVec3>> = Vec::new();
    let mut open = false;
    for (k, pair) in points.windows(2).enumerate() {
        if shown.get(k).is_some_and(|word| word == "off") {
            open = false;
            continue;
        }
        match lines.last_mut() {
            Some(line) if open => line.push(pair[1]),
            _ => lines.push(pair.to_vec()),
        }
        open = true;
    }
    Ok(Placed { on: body, shape: Shape::Lines(lines) })
}

#[cfg(test)]
mod tests {
    use model::Value;

    use crate::{geometry, shape::Shape, testing::Build};

    /// Truth: corners of a triangle; the second piece is switched off.
    #[test]
    fn pieces_that_are_off_are_left_out() {
        let mut b = Build::new();
        let model = b.make("model", None, "m", &[]);
        let part = b.make("part", Some(model), "p", &[]);
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let markers =
            corners.iter().enumerate().map(|(k, at)| b.marker(part, &format!("k{k}"), *at, [0.0; 3])).collect();
        let words = ["on", "off", "on"].map(String::from).to_vec();
        let cells = [
            ("marker_name", Value::Objects(markers)),
            ("close", Value::Flag(true)),
            ("visibility_between_markers", Value::Texts(words)),
        ];
        let outline = b.make("outline", Some(part), "O", &cells);
        let placed = geometry::shape(&b.database, outline).unwrap().unwrap();
        let Shape::Lines(lines) = placed.shape else { panic!("lines") };
        let at = |k: usize| glam::DVec3::from_array(corners[k]) * 0.0254;
        assert_eq!(lines, [vec![at(0), at(1)], vec![at(2), at(0)]]);
    }
}
