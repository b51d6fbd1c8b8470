//! GRAPHICS: the shapes the solver knows. Shapes only View draws (links, plates, polylines) have no
//! statement; they change no result.

use model::{Array, ObjectId, Value};

use super::{Chosen, number_field, reference};
use crate::{
    layout::Lines,
    read::{Builder, Entry, Form, Statement, Word},
    write::Writer,
};

/// Whether a class of shapes belongs to the section of moving graphics.
pub(crate) fn moves(class: &str) -> bool {
    ["force_graphic", "spring_damper_graphic"].contains(&class)
}

/// Field, keyword and the value at which the argument is left out.
type Argument = (&'static str, &'static str, Option<f64>);

const SHAPES: &[(&str, &str, &[Argument])] = &[
    (
        "cylinder",
        "CYLINDER",
        &[
            ("length", "LENGTH", None),
            ("side_count_for_body", "SIDES", Some(20.0)),
            ("radius", "RADIUS", None),
            ("segment_count_for_ends", "SEG", Some(20.0)),
            ("angle_extent", "RANGLE", Some(360.0)),
        ],
    ),
    (
        "frustum",
        "FRUSTUM",
        &[
            ("length", "LENGTH", None),
            ("side_count_for_body", "SIDES", Some(20.0)),
            ("top_radius", "TOP", None),
            ("bottom_radius", "BOTTOM", None),
            ("segment_count_for_ends", "SEG", Some(20.0)),
            ("angle_extent", "RANGLE", Some(360.0)),
        ],
    ),
    (
        "ellipsoid",
        "ELLIPSOID",
        &[("x_scale_factor", "XSCALE", None), ("y_scale_factor", "YSCALE", None), ("z_scale_factor", "ZSCALE", None)],
    ),
    ("circle", "CIRCLE", &[("radius", "RADIUS", None), ("segment_count", "SEG", Some(20.0))]),
];

/// Why there is no statement for a class of shapes.
fn without_statement(class: &str) -> &'static str {
    if moves(class) {
        "graphics that are not written yet, which change no result"
    } else {
        "shapes without a statement, which change no result"
    }
}

pub(super) fn graphics(w: &mut Writer<'_>, id: ObjectId, mut lines: Lines) -> Option<Lines> {
    let class = w.database.object(id).class.id;
    match class {
        "force_graphic" => {
            let fields = ["force_element_name", "joint_name", "jprim_name"];
            let Some(element) = fields.iter().find_map(|field| w.database.reference(id, field)) else {
                w.skip(id, "graphics without a force");
                return None;
            };
            let number = w.id_of(id, element);
            let statement = w.database.get(element).and_then(|e| e.class.statement).unwrap_or("?");
            lines.flag("FORCE");
            lines.argument("ETYPE", statement);
            lines.argument("EID", &number);
            reference(w, id, "applied_at_marker_name", "EMARKER", &mut lines);
        }
        "block" => {
            lines.flag("BOX");
            reference(w, id, "corner_marker", "CORNER", &mut lines);
            let Some(corner) = w.database.numbers(id, "diag_corner_coords") else {
                w.skip(id, "blocks without `diag_corner_coords`");
                return None;
            };
            for (keyword, x) in ["X", "Y", "Z"].iter().zip(corner) {
                lines.argument(keyword, &crate::number(x, w.options.digits));
            }
        }
        _ => {
            let Some((_, word, arguments)) = SHAPES.iter().find(|(shape, ..)| *shape == class) else {
                w.skip(id, without_statement(class));
                return None;
            };
            lines.flag(word);
            reference(w, id, "center_marker", "CM", &mut lines);
            let angle = w.database.units().angle.si;
            for (name, keyword, omitted) in *arguments {
                // The turn that is left out is a full one, whatever the unit of angles.
                let plain = if *name == "angle_extent" {
                    w.database.number(id, name).map(|x| (x * angle).to_degrees().round())
                } else {
                    w.database.number(id, name)
                };
                if plain != *omitted || omitted.is_none() {
                    number_field(w, id, name, keyword, &mut lines);
                }
            }
        }
    }
    Some(lines)
}

/// Shapes that the solver knows, and that are not read.
const UNREAD: &[&str] = &["ARC", "CURVE", "EXTERNAL", "OUTLINE", "PLANE", "POINT", "SPDP", "SPRINGDAMPER", "TORUS"];

pub(super) const WORDS: &[Word] = &[
    ("CYLINDER", Form::Flag),
    ("FRUSTUM", Form::Flag),
    ("ELLIPSOID", Form::Flag),
    ("CIRCLE", Form::Flag),
    ("BOX", Form::Flag),
    ("FORCE", Form::Flag),
    ("ARC", Form::Flag),
    ("CURVE", Form::Flag),
    ("EXTERNAL", Form::Flag),
    ("OUTLINE", Form::Flag),
    ("PLANE", Form::Flag),
    ("POINT", Form::Flag),
    ("SPDP", Form::Flag),
    ("SPRINGDAMPER", Form::Flag),
    ("TORUS", Form::Flag),
    ("CM", Form::Value),
    ("CORNER", Form::Value),
    ("RM", Form::Value),
    ("X", Form::Value),
    ("Y", Form::Value),
    ("Z", Form::Value),
    ("LENGTH", Form::Value),
    ("RADIUS", Form::Value),
    ("SIDES", Form::Value),
    ("SEG", Form::Value),
    ("RANGLE", Form::Value),
    ("ANGLE", Form::Value),
    ("TOP", Form::Value),
    ("BOTTOM", Form::Value),
    ("XSCALE", Form::Value),
    ("YSCALE", Form::Value),
    ("ZSCALE", Form::Value),
    ("ETYPE", Form::Value),
    ("EID", Form::Value),
    ("EMARKER", Form::Value),
    ("CID", Form::Value),
    ("CRM", Form::Value),
    ("FILE", Form::Value),
    ("ELEMENT", Form::Value),
    ("FACETING_TOLERANCE", Form::Value),
    ("OUTLINE", Form::Value),
    ("XMIN", Form::Value),
    ("XMAX", Form::Value),
    ("YMIN", Form::Value),
    ("YMAX", Form::Value),
    ("COIL", Form::Value),
];

/// The bare words of shapes, of which a statement has one.
pub(super) fn shapes() -> Vec<&'static str> {
    SHAPES.iter().map(|(_, word, _)| *word).chain(["BOX", "FORCE"]).chain(UNREAD.iter().copied()).collect()
}

/// The class of a shape.
pub(super) fn kind(statement: &Statement) -> Chosen {
    if let Some((class, ..)) = SHAPES.iter().find(|(_, word, _)| statement.has(word)) {
        return Chosen::Class(class);
    }
    if statement.has("BOX") {
        return Chosen::Class("block");
    }
    if statement.has("FORCE") {
        return Chosen::Class("force_graphic");
    }
    let named = |word: &&&str| statement.has(word) || statement.argument(word).is_some();
    match UNREAD.iter().find(named) {
        Some(word) => Chosen::Unread(word),
        None => Chosen::OneOf(SHAPES.iter().map(|(_, word, _)| *word).chain(["BOX", "FORCE"]).collect()),
    }
}

pub(super) fn read<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    let marker = |b: &mut Builder<'a>, e: &mut Entry<'a>, keyword, cell| {
        if let (Some(field), Some(argument)) = (Builder::field(e, cell), e.take(keyword)) {
            b.set_objects(e, field, argument);
        }
    };
    match e.class.id {
        "force_graphic" => {
            e.flag("FORCE");
            marker(b, e, "EMARKER", "applied_at_marker_name");
            read_force(b, e);
        }
        "block" => {
            e.flag("BOX");
            marker(b, e, "CORNER", "corner_marker");
            for keyword in ["X", "Y", "Z"] {
                b.needs(e, keyword);
            }
            let corner = ["X", "Y", "Z"].map(|keyword| e.take(keyword).and_then(|argument| b.exactly::<1>(argument)));
            if let [Some([x]), Some([y]), Some([z])] = corner {
                b.store(e.id, "diag_corner_coords", Value::Array(Array::column(vec![x, y, z])));
            }
        }
        class => {
            let Some((_, word, arguments)) = SHAPES.iter().find(|(shape, ..)| *shape == class) else { return };
            e.flag(word);
            marker(b, e, "CM", "center_marker");
            for (cell, keyword, omitted) in *arguments {
                if omitted.is_none() {
                    b.needs(e, keyword);
                }
                if let Some(argument) = e.take(keyword) {
                    b.set_numbers(e, cell, argument);
                } else if let Some(full) = omitted.filter(|_| *cell == "angle_extent") {
                    // In degrees, which the dataset's own units have.
                    b.store(e.id, cell, Value::Number(full));
                }
            }
        }
    }
}

/// The element whose arrow is drawn.
fn read_force<'a>(b: &mut Builder<'a>, e: &mut Entry<'a>) {
    for keyword in ["ETYPE", "EID"] {
        b.needs(e, keyword);
    }
    let (kind, number) = (e.take("ETYPE"), e.take("EID"));
    let (Some(kind), Some(number)) = (kind, number) else { return };
    let typed = kind.value(b.text).to_ascii_uppercase();
    for cell in ["force_element_name", "joint_name", "jprim_name"] {
        let Some(field) = Builder::field(e, cell) else { continue };
        let schema::Kind::Object(_, wanted) = field.kind else { continue };
        let classes = b.registry.classes.iter().filter(|class| class.is(wanted));
        let Some(statement) = classes.filter_map(|class| class.statement).find(|s| *s == typed) else { continue };
        if let Some(item) = b.only(number)
            && let Some(object) = b.object(e, number, item, &[statement], wanted)
        {
            b.store(e.id, cell, Value::Object(object));
        }
        return;
    }
    b.not_read(e, kind);
}
