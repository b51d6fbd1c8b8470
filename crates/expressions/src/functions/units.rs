//! Functions about units.

use model::Value;
use schema::{Dimension, Quantity, parse_unit_expression};

use super::{Arguments, Function, fields::dimension_of, function, real};
use crate::scope::Outcome;

pub const TABLE: &[Function] = &[
    function("UNITS_CONVERSION_FACTOR", "unit", "factor from a unit to the one in force", |a| {
        let unit = a.text(0)?;
        let (dimension, si) = parse_unit_expression(&unit).ok_or_else(|| crate::evaluate::unknown_unit(&unit))?;
        real(si / a.database().units().factor(dimension))
    }),
    function("UNITS_STRING", "field", "unit in force of a field", |a| {
        let dimension = dimension_of(a)?;
        Ok(Value::Text(a.database().units().label(dimension)))
    }),
    function("UNITS_TYPE", "field", "kind of quantity of a field", |a| Ok(Value::Text(a.text(0)?))),
    function("UNITS_VALUE", "quantity", "unit in force of a kind of quantity", |a| {
        let dimension = quantity_expression(a)?;
        Ok(Value::Text(a.database().units().label(dimension)))
    }),
];

/// `angle`, `length/time**2`: names of quantities joined by `*` and `/`.
fn quantity_expression(a: &Arguments) -> Outcome<Dimension> {
    let text = a.text(0)?;
    let wrong = || a.error(format!("\"{text}\" is not a kind of quantity"));
    let mut dimension = Dimension::NONE;
    let powered = text.replace("**", "^");
    let (mut rest, mut below) = (powered.as_str(), false);
    while !rest.is_empty() {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let (word, power) = rest[..end].trim().split_once('^').unwrap_or((rest[..end].trim(), "1"));
        let power: i8 = power.trim().parse().ok().filter(|p: &i8| p.abs() <= 9).ok_or_else(wrong)?;
        let quantity = Quantity::named(word.trim()).ok_or_else(wrong)?.dimension.power(power);
        dimension = if below { dimension.per(quantity) } else { dimension.times(quantity) };
        below = rest[end..].starts_with('/');
        rest = rest.get(end + 1..).unwrap_or("");
    }
    Ok(dimension)
}
