//! Where the sizes of a shape are marked in its drawing.

use crate::{Shape, boxed, i_beam};

/// On which side of its line the text of a mark stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Left,
    Right,
    Above,
    Below,
}

/// One marked size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Name of the size, as in [`Shape::KINDS`].
    pub name: &'static str,
    pub size: f64,
    /// Ends of the line, y and z.
    pub from: [f64; 2],
    pub to: [f64; 2],
    pub side: Side,
}

impl Shape {
    /// The sizes with where they are marked: overall sizes beside the shape, walls within it.
    #[must_use]
    pub fn marks(self) -> Vec<Mark> {
        let (width, height) = self.extent();
        let (y, z) = (width / 2.0, height / 2.0);
        let gap = 0.12 * width.max(height);
        let below = |name| Mark { name, size: width, from: [-y, -z - gap], to: [y, -z - gap], side: Side::Below };
        let beside = Mark { name: "height", size: height, from: [-y - gap, -z], to: [-y - gap, z], side: Side::Left };
        let across = |name, size, from: f64, at: f64| Mark {
            name,
            size,
            from: [from, at],
            to: [from + size, at],
            side: Side::Right,
        };
        let upright = |size: f64, at: f64| Mark {
            name: "flange_thickness",
            size,
            from: [at, z - size],
            to: [at, z],
            side: Side::Above,
        };
        match self {
            Shape::Circle { .. } => vec![below("diameter")],
            Shape::Tube { thickness, .. } => {
                let wall = Mark { side: Side::Left, ..across("thickness", thickness, -y, 0.0) };
                vec![below("diameter"), wall]
            }
            Shape::Rectangle { .. } | Shape::Ellipse { .. } => vec![below("width"), beside],
            Shape::Box(boxed::Walls { web, flange, .. }) => {
                vec![below("width"), beside, across("thickness", web, y - web, -z / 2.0), upright(flange, -y / 2.0)]
            }
            Shape::I(i_beam::Walls { web, flange, .. }) => {
                let web = across("web_thickness", web, -web / 2.0, -z / 3.0);
                vec![below("width"), beside, web, upright(flange, -y / 2.0)]
            }
        }
    }
}
