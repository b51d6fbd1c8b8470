//! How objects look and whether they take part: the `attributes` commands. Each is a group of its
//! own that creates nothing; classes of one family share it, and the object named decides whose
//! cells are set. `entity attributes` knows all of them ([`ENTITY`]) and sets those the object has.

use schema::{Dimension, Field, Group, Rule};

const SWITCH: &[&str] = &["on", "off", "no_opinion", "toggle"];

const SCALE_OF_ICONS: Field = Field::real("scale_of_icons", Dimension::NONE).doc("size of the icon as a factor");
const SIZE_OF_ICONS: Field = Field::real("size_of_icons", Dimension::LENGTH).doc("size of the icon as a length");
const VISIBILITY: Field = Field::choice("visibility", SWITCH).doc("whether it is drawn");
const NAME_VISIBILITY: Field = Field::choice("name_visibility", SWITCH).doc("whether its name is drawn");
const TRANSPARENCY: Field = Field::integer("transparency").doc("how much shines through, 0 to 100");
const LOD: Field = Field::integer("lod").doc("level of detail, 0 to 100");
const COLOR: Field = Field::text("color").doc("name of its colour");
const ENTITY_SCOPE: Field =
    Field::choice("entity_scope", &["fill_color", "edge_color", "outline_color", "text_color", "all_color"])
        .doc("what the colour is for");
const RENDER_MODE: Field = Field::choice("render_mode", &["wireframe", "filled"]).doc("drawn as lines or filled");
const ACTIVE: Field = Field::choice("active", SWITCH).doc("whether it takes part in simulations");
const DEPENDENTS_ACTIVE: Field =
    Field::choice("dependents_active", SWITCH).doc("whether what depends on it takes part in simulations");
const LINE_THICKNESS: Field = Field::real("line_thickness", Dimension::NONE).doc("width of lines");
const LINE_TYPE: Field =
    Field::choice("line_type", &["solid", "dash", "dotdash", "dot", "none"]).doc("pattern of lines");

const ONE_SIZE: &[Rule] = &[Rule::AtMostOne(&["scale_of_icons", "size_of_icons"])];

const fn group(command: &'static str, object: &'static str, fields: &'static [Field], rules: &'static [Rule]) -> Group {
    Group { command, creates: false, object, fields, rules, doc: "how objects look and whether they take part" }
}

/// Everything `entity attributes` may set.
pub const ENTITY: &[Field] = &[
    SCALE_OF_ICONS,
    SIZE_OF_ICONS,
    Field::integer("expr_visibility").doc("number or expression that shows or hides it"),
    VISIBILITY,
    NAME_VISIBILITY,
    TRANSPARENCY,
    LOD,
    COLOR,
    ENTITY_SCOPE,
    LINE_THICKNESS,
    LINE_TYPE,
    Field::integer("expr_active").doc("number or expression that switches it on or off"),
    ACTIVE,
    RENDER_MODE,
    DEPENDENTS_ACTIVE,
];

const SIGN: &[Field] = &[SCALE_OF_ICONS, SIZE_OF_ICONS, VISIBILITY, NAME_VISIBILITY, COLOR, ACTIVE, DEPENDENTS_ACTIVE];
const BODY: &[Field] = &[
    SCALE_OF_ICONS,
    SIZE_OF_ICONS,
    VISIBILITY,
    NAME_VISIBILITY,
    TRANSPARENCY,
    LOD,
    COLOR,
    ENTITY_SCOPE,
    ACTIVE,
    DEPENDENTS_ACTIVE,
];

pub const MODEL: Group = group(
    "model attributes",
    "model_name",
    &[SCALE_OF_ICONS, SIZE_OF_ICONS, VISIBILITY, NAME_VISIBILITY, TRANSPARENCY, LOD, COLOR, ENTITY_SCOPE],
    ONE_SIZE,
);
pub const PART: Group = group("part attributes", "part_name", BODY, ONE_SIZE);
pub const POINT_MASS: Group = group("part attributes", "point_mass_name", BODY, ONE_SIZE);
pub const EQUATION: Group = group("part attributes", "equation_name", BODY, ONE_SIZE);
pub const MARKER: Group = group("marker attributes", "marker_name", SIGN, ONE_SIZE);
pub const POINT: Group = group("point attributes", "point_name", SIGN, ONE_SIZE);
pub const CONSTRAINT: Group = group("constraint attributes", "constraint_name", SIGN, ONE_SIZE);
pub const FORCE: Group = group("force attributes", "force_name", SIGN, ONE_SIZE);
pub const GEOMETRY: Group = group(
    "geometry attributes",
    "geometry_name",
    &[VISIBILITY, NAME_VISIBILITY, TRANSPARENCY, LOD, COLOR, ENTITY_SCOPE, RENDER_MODE, ACTIVE, DEPENDENTS_ACTIVE],
    &[],
);
/// What only `entity attributes` sets of geometry.
pub const GEOMETRY_MORE: Group =
    group("entity attributes", "entity_name", &[SCALE_OF_ICONS, SIZE_OF_ICONS, LINE_THICKNESS, LINE_TYPE], ONE_SIZE);
pub const DATA_ELEMENT: Group =
    group("data_element attributes", "data_element_name", &[VISIBILITY, COLOR, ACTIVE, DEPENDENTS_ACTIVE], &[]);
