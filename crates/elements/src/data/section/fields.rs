//! Parameters that sections share. The last eight are what a beam takes; they are cells with
//! expressions over the sizes, so that they follow a change of a size, until a value of its own is
//! given for one.

use schema::{Dimension, Field};

pub const WIDTH: Field = Field::real("width", Dimension::LENGTH).above(0.0).doc("size along y of the beam");
pub const HEIGHT: Field = Field::real("height", Dimension::LENGTH).above(0.0).doc("size along z of the beam");
pub const DIAMETER: Field = Field::real("diameter", Dimension::LENGTH).above(0.0).doc("outer diameter");
pub const THICKNESS: Field = Field::real("thickness", Dimension::LENGTH).above(0.0).doc("thickness of the wall");
pub const WEB_THICKNESS: Field =
    Field::real("web_thickness", Dimension::LENGTH).above(0.0).doc("thickness of the web, along y");
pub const FLANGE_THICKNESS: Field =
    Field::real("flange_thickness", Dimension::LENGTH).above(0.0).doc("thickness of each flange, along z");
pub const POISSON_RATIO: Field = Field::real("poisson_ratio", Dimension::NONE)
    .default(0.3)
    .doc("lateral contraction ratio; matters to shear factors of Cowper alone");
pub const SHEAR_THEORY: Field = Field::choice("shear_theory", &["energy", "cowper", "none"])
    .default_word("energy")
    .doc("where shear factors come from: energy of Jourawski's stresses, Cowper 1966, or no shear deflection");

pub const AREA: Field = Field::real("area_of_cross_section", Dimension::AREA).above(0.0).doc("area of the section");
pub const IXX: Field = Field::real("ixx", Dimension::AREA_INERTIA)
    .at_least(0.0)
    .doc("torsion constant; the polar moment for round sections only");
pub const IYY: Field =
    Field::real("iyy", Dimension::AREA_INERTIA).at_least(0.0).doc("second moment of area about y: of z squared");
pub const IZZ: Field =
    Field::real("izz", Dimension::AREA_INERTIA).at_least(0.0).doc("second moment of area about z: of y squared");
pub const Y_SHEAR: Field = Field::real("y_shear_area_ratio", Dimension::NONE)
    .zero_or_at_least(1.0)
    .doc("shear factor along y: area over shear area, or 0 for no shear deflection");
pub const Z_SHEAR: Field = Field::real("z_shear_area_ratio", Dimension::NONE)
    .zero_or_at_least(1.0)
    .doc("shear factor along z: area over shear area, or 0 for no shear deflection");
pub const Y_EXTREME: Field =
    Field::real("y_extreme_fibre", Dimension::LENGTH).at_least(0.0).doc("largest distance of material from z, along y");
pub const Z_EXTREME: Field =
    Field::real("z_extreme_fibre", Dimension::LENGTH).at_least(0.0).doc("largest distance of material from y, along z");
