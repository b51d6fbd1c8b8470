//! Elements between two bodies: where bodies and a location are given instead of markers, a marker
//! is generated on each body; where the second end floats, a floating marker without a place.

use model::{CellKey, ObjectId, Value};
use text::{Diagnostic, Severity};

use crate::{Interpreter, call::Call, place, values::Draft};

const ENDS: [(&str, &str); 2] = [("i_part_name", "i_marker_name"), ("j_part_name", "j_marker_name")];

/// Where the second end floats.
const FLOATING: (&str, &str) = ("j_part_name", "j_floating_marker_name");

/// Whether a parameter only says where markers are to be generated.
pub fn is_end(name: &str) -> bool {
    is_body(name) || place::PLACING.contains(&name)
}

/// Whether a parameter names a body that gets a marker, and is no value of the element itself.
pub fn is_body(name: &str) -> bool {
    ENDS.iter().any(|(part, _)| *part == name)
}

/// Generates the floating marker of an element that was given the body of its second end.
pub fn generate_floating(interpreter: &mut Interpreter, id: ObjectId, call: &Call) -> Result<(), Vec<Diagnostic>> {
    let class = interpreter.database.object(id).class;
    let (part, marker) = FLOATING;
    let Some(argument) = call.argument(part) else { return Ok(()) };
    let (Some(field), Some(cell)) = (call.field(part).copied(), class.cell_index(marker)) else { return Ok(()) };
    let Some(body) = interpreter.read_value(call, &field, argument, None)?.value.as_object() else { return Ok(()) };
    let Some(marker_class) = interpreter.registry.class("floating_marker") else { return Ok(()) };
    let name = interpreter.generate_name(marker_class, Some(body));
    let Ok(made) = interpreter.database.create(marker_class, Some(body), &name) else { return Ok(()) };
    interpreter.names.created(&interpreter.database, made);
    let number = match (call.argument("j_marker_id"), call.field("j_marker_id").copied()) {
        (Some(argument), Some(field)) => {
            let draft = interpreter.read_value(call, &field, argument, None)?;
            interpreter.check_id(made, &draft.value, argument.value_span)?;
            draft.value
        }
        _ => Value::Integer(0),
    };
    interpreter.database.set_value(made, "adams_id", number);
    interpreter.store(CellKey::new(id, cell), Draft::literal(Value::Object(made)));
    let body = interpreter.database.full_name(body);
    interpreter.report.diagnostics.push(
        Diagnostic::new(
            Severity::Note,
            "marker/floating-made",
            format!("the floating marker `{name}` is made on `{body}`"),
        )
        .at(argument.value_span, "it follows the first marker and gets the reaction")
        .adams(format!("The floating marker {name} has been created on part {body}.")),
    );
    Ok(())
}

/// Generates the markers of a new element that was given bodies.
pub fn generate_markers(interpreter: &mut Interpreter, id: ObjectId, call: &Call) -> Result<(), Vec<Diagnostic>> {
    let class = interpreter.database.object(id).class;
    for (end, (part, marker)) in ENDS.into_iter().enumerate() {
        let Some(argument) = call.argument(part) else { continue };
        let (Some(field), Some(cell)) = (call.field(part).copied(), class.cell_index(marker)) else { continue };
        let Some(body) = interpreter.read_value(call, &field, argument, None)?.value.as_object() else { continue };
        if call.argument("location").is_none() {
            return Err(vec![call.missing(&["location"])]);
        }
        let Some(marker_class) = interpreter.registry.class("marker") else { continue };
        let name = interpreter.generate_name(marker_class, Some(body));
        let Ok(made) = interpreter.database.create(marker_class, Some(body), &name) else { continue };
        interpreter.names.created(&interpreter.database, made);
        let mut reader = interpreter.reader(call, Some(made));
        let placement = place::read_one(&mut reader, call, Some(made), Some(body), end)?;
        let pose = default_orientation(interpreter, body);
        let orientation = placement.orientation.unwrap_or(pose);
        for (name, draft) in [("location", placement.location), ("orientation", Some(orientation))] {
            if let (Some(draft), Some(index)) = (draft, marker_class.cell_index(name)) {
                // The marker belongs to the element from now on; it does not follow an expression.
                interpreter.store(CellKey::new(made, index), Draft::literal(draft.value));
            }
        }
        if marker_class.cell_index("adams_id").is_some() {
            interpreter.database.set_value(made, "adams_id", Value::Integer(0));
        }
        interpreter.store(CellKey::new(id, cell), Draft::literal(Value::Object(made)));
    }
    Ok(())
}

/// Angles 0, 0, 0 in the frame that values are read in, seen from the body.
fn default_orientation(interpreter: &Interpreter, body: ObjectId) -> Draft {
    let database = &interpreter.database;
    let frame = database.settings().default_frame.filter(|f| database.get(*f).is_some());
    let frame = frame.map_or(model::Pose::GLOBAL, |f| database.global_pose(f));
    let local = database.global_pose(body).inverse().then(&frame);
    let angle = database.units().angle.si;
    let angles = model::angles_of(&local.rotation).map(|a| a / angle);
    Draft::literal(Value::Array(model::Array::column(angles.to_vec())))
}
