//! GRAPHICS: the shapes the solver knows. Shapes only View draws (links, plates, polylines) have no
//! statement; they change no result.

use model::ObjectId;

use super::{number_field, reference};
use crate::{layout::Lines, write::Writer};

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
