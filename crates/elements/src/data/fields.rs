//! Parameters that several data elements share.

use schema::{Count, Dimension, Field};

pub const SIZE: Field = Field::integer("size").keyword("SIZE").doc("how many values there are");
pub const NUMBERS: Field =
    Field::real("numbers", Dimension::NONE).many().required().keyword("NUMBERS").doc("the values");
pub const UNITS: Field = Field::text("units").doc("kind of quantity of the values");
pub const ROUTINE: Field = Field::text("routine").keyword("ROUTINE").doc("library and entry of the subroutine");
/// Constants for a subroutine.
pub const USER_FUNCTION: Field =
    Field::real("user_function", Dimension::NONE).count(Count::between(1, 30)).doc("constants handed to a subroutine");
