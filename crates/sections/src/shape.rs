//! One shape with its dimensions, asked for any of its properties.

use crate::{Axis, Theory, boxed, circle, ellipse, i_beam, outline, rectangle, tube};

/// A cross section. Widths are along y, heights along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Rectangle {
        width: f64,
        height: f64,
    },
    Circle {
        diameter: f64,
    },
    /// A round tube; `thickness` is that of its wall.
    Tube {
        diameter: f64,
        thickness: f64,
    },
    /// A rectangular tube; webs stand along z, flanges lie along y.
    Box(boxed::Walls),
    I(i_beam::Walls),
    Ellipse {
        width: f64,
        height: f64,
    },
}

/// What a beam takes from its section, and the largest distances of material from the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Properties {
    pub area: f64,
    /// Torsion constant.
    pub ixx: f64,
    pub iyy: f64,
    pub izz: f64,
    /// Shear factors A/As; 0 for no shear deflection.
    pub asy: f64,
    pub asz: f64,
    /// Distance of the outermost fibre along y and z.
    pub extreme_y: f64,
    pub extreme_z: f64,
}

/// Where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Note {
    /// `ixx`, `y_shear_area_ratio`, `z_shear_area_ratio`.
    pub of: &'static str,
    pub text: &'static str,
}

impl Shape {
    /// Words for the shapes and the names of their dimensions, in the order in which [`Shape::new`]
    /// wants them.
    pub const KINDS: &'static [(&'static str, &'static [&'static str])] = &[
        ("rectangle", &["width", "height"]),
        ("circle", &["diameter"]),
        ("tube", &["diameter", "thickness"]),
        ("box", &["width", "height", "thickness", "flange_thickness"]),
        ("i", &["width", "height", "web_thickness", "flange_thickness"]),
        ("ellipse", &["width", "height"]),
    ];

    /// A shape by its word and its dimensions. The flanges of a box may be left out: they are as thick
    /// as its webs.
    ///
    /// # Errors
    /// A sentence, if there is no such shape or its dimensions do not make one.
    pub fn new(kind: &str, dimensions: &[f64]) -> Result<Shape, String> {
        let kind = kind.trim().to_ascii_lowercase();
        let Some((word, names)) = Self::KINDS.iter().find(|(word, _)| *word == kind) else {
            let words: Vec<&str> = Self::KINDS.iter().map(|(word, _)| *word).collect();
            return Err(format!("there is no section `{kind}`; there are {}", words.join(", ")));
        };
        let shape = match (*word, dimensions) {
            ("rectangle", &[width, height]) => Shape::Rectangle { width, height },
            ("circle", &[diameter]) => Shape::Circle { diameter },
            ("tube", &[diameter, thickness]) => Shape::Tube { diameter, thickness },
            ("box", &[width, height, web]) => Shape::Box(boxed::Walls { width, height, web, flange: web }),
            ("box", &[width, height, web, flange]) => Shape::Box(boxed::Walls { width, height, web, flange }),
            ("i", &[width, height, web, flange]) => Shape::I(i_beam::Walls { width, height, web, flange }),
            ("ellipse", &[width, height]) => Shape::Ellipse { width, height },
            _ => {
                return Err(format!(
                    "a section `{word}` wants {}, {} numbers; {} are given",
                    names.join(", "),
                    names.len(),
                    dimensions.len()
                ));
            }
        };
        for (name, x) in names.iter().zip(dimensions) {
            if !x.is_finite() || *x <= 0.0 {
                return Err(format!("the {name} of a section `{word}` is {x}; it must be above 0"));
            }
        }
        shape.walls_fit()?;
        Ok(shape)
    }

    fn walls_fit(self) -> Result<(), String> {
        let fits = |name: &str, wall: f64, room_name: &str, room: f64, walls: f64| {
            if walls * wall < room {
                return Ok(());
            }
            let twice = if walls > 1.0 { "twice " } else { "" };
            Err(format!("{twice}the {name} {wall} does not leave room within the {room_name} {room}"))
        };
        match self {
            Shape::Tube { diameter, thickness } => fits("thickness", thickness, "diameter", diameter, 2.0),
            Shape::Box(walls) => {
                fits("thickness", walls.web, "width", walls.width, 2.0)?;
                fits("flange_thickness", walls.flange, "height", walls.height, 2.0)
            }
            Shape::I(walls) => {
                fits("web_thickness", walls.web, "width", walls.width, 1.0)?;
                fits("flange_thickness", walls.flange, "height", walls.height, 2.0)
            }
            _ => Ok(()),
        }
    }

    /// The word for the shape.
    #[must_use]
    pub fn kind(self) -> &'static str {
        match self {
            Shape::Rectangle { .. } => "rectangle",
            Shape::Circle { .. } => "circle",
            Shape::Tube { .. } => "tube",
            Shape::Box(_) => "box",
            Shape::I(_) => "i",
            Shape::Ellipse { .. } => "ellipse",
        }
    }

    #[must_use]
    pub fn area(self) -> f64 {
        match self {
            Shape::Rectangle { width, height } => rectangle::area(width, height),
            Shape::Circle { diameter } => circle::area(diameter / 2.0),
            Shape::Tube { diameter, thickness } => tube::area(diameter / 2.0, diameter / 2.0 - thickness),
            Shape::Box(walls) => boxed::area(walls),
            Shape::I(walls) => i_beam::area(walls),
            Shape::Ellipse { width, height } => ellipse::area(width / 2.0, height / 2.0),
        }
    }

    /// Second moment of area about an axis.
    #[must_use]
    pub fn second_moment(self, about: Axis) -> f64 {
        let (width, height) = match about {
            Axis::Y => self.extent(),
            Axis::Z => (self.extent().1, self.extent().0),
        };
        match self {
            Shape::Rectangle { .. } => rectangle::second_moment(width, height),
            Shape::Circle { diameter } => circle::second_moment(diameter / 2.0),
            Shape::Tube { diameter, thickness } => tube::second_moment(diameter / 2.0, diameter / 2.0 - thickness),
            Shape::Box(walls) if about == Axis::Y => boxed::second_moment(walls),
            Shape::Box(walls) => boxed::second_moment(walls.turned()),
            Shape::I(walls) => i_beam::second_moment(walls, about),
            Shape::Ellipse { .. } => ellipse::second_moment(width / 2.0, height / 2.0),
        }
    }

    /// The torsion constant.
    #[must_use]
    pub fn torsion(self) -> f64 {
        match self {
            Shape::Rectangle { width, height } => rectangle::torsion(width, height),
            Shape::Circle { diameter } => circle::torsion(diameter / 2.0),
            Shape::Tube { diameter, thickness } => tube::torsion(diameter / 2.0, diameter / 2.0 - thickness),
            Shape::Box(walls) => boxed::torsion(walls),
            Shape::I(walls) => i_beam::torsion(walls),
            Shape::Ellipse { width, height } => ellipse::torsion(width / 2.0, height / 2.0),
        }
    }

    /// The shear factor A/As for a force along an axis.
    #[must_use]
    pub fn shear(self, along: Axis, theory: Theory, poisson: f64) -> f64 {
        match self {
            Shape::Rectangle { .. } => rectangle::shear(theory, poisson),
            Shape::Circle { .. } => circle::shear(theory, poisson),
            Shape::Tube { diameter, thickness } => {
                tube::shear(diameter / 2.0, diameter / 2.0 - thickness, theory, poisson)
            }
            Shape::Box(walls) => boxed::shear(if along == Axis::Z { walls } else { walls.turned() }, theory, poisson),
            Shape::I(walls) => i_beam::shear(walls, along, theory, poisson),
            Shape::Ellipse { width, height } => {
                let (a, b) = if along == Axis::Y { (width, height) } else { (height, width) };
                ellipse::shear(a, b, theory, poisson)
            }
        }
    }

    /// Everything at once. Poisson's ratio matters to Cowper's shear factors alone.
    #[must_use]
    pub fn properties(self, theory: Theory, poisson: f64) -> Properties {
        let (width, height) = self.extent();
        Properties {
            area: self.area(),
            ixx: self.torsion(),
            iyy: self.second_moment(Axis::Y),
            izz: self.second_moment(Axis::Z),
            asy: self.shear(Axis::Y, theory, poisson),
            asz: self.shear(Axis::Z, theory, poisson),
            extreme_y: width / 2.0,
            extreme_z: height / 2.0,
        }
    }

    /// Size along y and z.
    #[must_use]
    pub fn extent(self) -> (f64, f64) {
        match self {
            Shape::Rectangle { width, height }
            | Shape::Box(boxed::Walls { width, height, .. })
            | Shape::I(i_beam::Walls { width, height, .. })
            | Shape::Ellipse { width, height } => (width, height),
            Shape::Circle { diameter } | Shape::Tube { diameter, .. } => (diameter, diameter),
        }
    }

    /// Closed lines round the material, the outer one first; points are y, z.
    #[must_use]
    pub fn outlines(self) -> Vec<Vec<[f64; 2]>> {
        match self {
            Shape::Rectangle { width, height } => vec![outline::rectangle(width, height)],
            Shape::Circle { diameter } => vec![outline::ellipse(diameter / 2.0, diameter / 2.0)],
            Shape::Ellipse { width, height } => vec![outline::ellipse(width / 2.0, height / 2.0)],
            Shape::Tube { diameter, thickness } => {
                [diameter / 2.0, diameter / 2.0 - thickness].map(|r| outline::ellipse(r, r)).to_vec()
            }
            Shape::Box(boxed::Walls { width, height, web, flange }) => {
                vec![outline::rectangle(width, height), outline::rectangle(width - 2.0 * web, height - 2.0 * flange)]
            }
            Shape::I(i_beam::Walls { width, height, web, flange }) => {
                vec![outline::i_beam(width, height, web, flange)]
            }
        }
    }

    /// Where the torsion constant and the shear factors come from.
    #[must_use]
    pub fn notes(self, theory: Theory) -> Vec<Note> {
        let ixx = match self {
            Shape::Rectangle { .. } => "series of Saint-Venant (Timoshenko and Goodier, art. 109)",
            Shape::Circle { .. } | Shape::Tube { .. } => "polar moment, exact for a round section",
            Shape::Ellipse { .. } => "Saint-Venant, exact",
            Shape::Box(_) => "Bredt on the centre lines, and the walls as strips",
            Shape::I(_) => {
                "sum of thirds with the corrections of Roark's table for flange ends and junctions, no fillets"
            }
        };
        let energy = match self {
            Shape::Rectangle { .. } | Shape::Circle { .. } | Shape::Ellipse { .. } => {
                "energy of Jourawski's shear stress over straight cuts"
            }
            Shape::Tube { .. } => "energy of the exact stresses without Poisson's ratio",
            Shape::Box(_) | Shape::I(_) => {
                "energy of Jourawski's shear stress over straight cuts and along the flanges"
            }
        };
        let cowper = "Cowper, J. Appl. Mech. 33 (1966) 335";
        let of = |along: Axis| match (theory, self, along) {
            (Theory::None, _, _) => "no shear deflection (Euler and Bernoulli)",
            (_, Shape::I(_), Axis::Y) => "energy of Jourawski's shear stress over straight cuts",
            (Theory::Energy, _, _) => energy,
            (Theory::Cowper, _, _) => cowper,
        };
        vec![
            Note { of: "ixx", text: ixx },
            Note { of: "y_shear_area_ratio", text: of(Axis::Y) },
            Note { of: "z_shear_area_ratio", text: of(Axis::Z) },
        ]
    }
}
