//! Functions of arrays and matrices (column-major).

use glam::DMat3;
use model::{Array, Sequence, Value, rotation_of};

use super::{Arguments, Function, column, function, location, modelling::sequence_angles, real};
use crate::{arithmetic::flag, scope::Outcome};

pub const TABLE: &[Function] = &[
    function("ALIGN", "values, start", "values shifted so that the first becomes a given number", |a| {
        let (values, start) = (a.array(0)?, a.number(1)?);
        let shift = values.values.first().map_or(0.0, |first| start - first);
        Ok(Value::Array(Array { values: values.values.iter().map(|x| x + shift).collect(), ..values }))
    }),
    function("ALLM", "values", "1 if no element is zero", |a| Ok(flag(a.numbers(0)?.iter().all(|x| *x != 0.0)))),
    function("ANGLES", "matrix, sequence", "angles of a rotation matrix in a sequence such as body313", |a| {
        angles(matrix3(a, 0)?, a)
    }),
    function("ANYM", "values", "1 if any element is not zero", |a| Ok(flag(a.numbers(0)?.iter().any(|x| *x != 0.0)))),
    function("APPEND", "matrix, matrix", "columns of one matrix beside those of another", append),
    function("CENTER", "values", "mean of the smallest and the largest element", |a| {
        real(f64::midpoint(extreme(a, |x, y| x < y)?.1, extreme(a, |x, y| x > y)?.1))
    }),
    function("CLIP", "matrix, start, n", "n columns of a matrix, from a given one on", |a| {
        let (m, start, n) = (a.array(0)?, a.count(1)?, a.count(2)?);
        if start == 0 || start - 1 + n > m.columns {
            return Err(a.error(format!("the matrix has {} columns", m.columns)));
        }
        let values = m.values[(start - 1) * m.rows..(start - 1 + n) * m.rows].to_vec();
        Ok(Value::Array(Array { rows: m.rows, columns: n, values }))
    }),
    function("COLS", "matrix", "number of columns", |a| Ok(count(a.array(0)?.columns))),
    function("COMPRESS", "values", "elements that are neither zero nor empty; one such if all are", compressed),
    function("CONVERT_ANGLES", "orientation, sequence", "body 3-1-3 angles changed to another sequence", |a| {
        angles(a.rotation(0)?, a)
    }),
    function("CROSS", "vector, vector", "vector product", |a| location(a.vector(0)?.cross(a.vector(1)?))),
    function("DIFF", "values", "differences of neighbours", |a| {
        column(a.numbers(0)?.windows(2).map(|w| w[1] - w[0]).collect())
    }),
    function("DMAT", "values", "diagonal matrix", |a| {
        let values = a.numbers(0)?;
        let n = a_matrix_side(values.len(), a)?;
        let mut diagonal = vec![0.0; n * n];
        for (i, x) in values.iter().enumerate() {
            diagonal[i * n + i] = *x;
        }
        Ok(Value::Array(Array { rows: n, columns: n, values: diagonal }))
    }),
    function("DOT", "vector, vector", "scalar product", |a| {
        let (x, y) = (a.numbers(0)?, a.numbers(1)?);
        if x.len() != y.len() {
            return Err(a.error(format!("{} and {} numbers have no scalar product", x.len(), y.len())));
        }
        real(x.iter().zip(&y).map(|(x, y)| x * y).sum())
    }),
    function("ELEMENT", "values, x", "1 if x is among the values", |a| {
        if let Some(list) = listed(a) {
            let wanted = one_of_list(a, 1)?;
            return Ok(flag(list.contains(&wanted)));
        }
        let x = a.number(1)?;
        Ok(flag(a.numbers(0)?.contains(&x)))
    }),
    function("EXCLUDE", "values, x", "the values without x", |a| {
        if let Some(list) = listed(a) {
            let unwanted = one_of_list(a, 1)?;
            return a.relisted(list.into_iter().filter(|v| *v != unwanted).collect());
        }
        let x = a.number(1)?;
        column(a.numbers(0)?.into_iter().filter(|y| *y != x).collect())
    }),
    function("FIRST", "values", "first element, zero if there is none", |a| match listed(a) {
        Some(list) => Ok(list.into_iter().next().unwrap_or(Value::Nothing)),
        None => real(a.numbers(0)?.first().copied().unwrap_or(0.0)),
    }),
    function("FIRST_N", "values, n", "first n elements", |a| {
        let n = a.count(1)?;
        if let Some(list) = listed(a) {
            return a.relisted(list.into_iter().take(n).collect());
        }
        let values = a.numbers(0)?;
        column(values[..n.min(values.len())].to_vec())
    }),
    function("LAST", "values", "last element, zero if there is none", |a| match listed(a) {
        Some(list) => Ok(list.into_iter().next_back().unwrap_or(Value::Nothing)),
        None => real(a.numbers(0)?.last().copied().unwrap_or(0.0)),
    }),
    function("LAST_N", "values, n", "last n elements", |a| {
        let n = a.count(1)?;
        if let Some(list) = listed(a) {
            let skipped = list.len().saturating_sub(n);
            return a.relisted(list.into_iter().skip(skipped).collect());
        }
        let values = a.numbers(0)?;
        column(values[values.len() - n.min(values.len())..].to_vec())
    }),
    function("MAX", "values", "largest element", |a| real(extreme(a, |x, y| x > y)?.1)),
    function("MAXI", "values", "position of the largest element", |a| Ok(count(extreme(a, |x, y| x > y)?.0 + 1))),
    function("MEAN", "values", "arithmetic mean", |a| {
        let values = filled(a)?;
        real(values.iter().sum::<f64>() / values.len() as f64)
    }),
    function("MIN", "values", "smallest element", |a| real(extreme(a, |x, y| x < y)?.1)),
    function("MINI", "values", "position of the smallest element", |a| Ok(count(extreme(a, |x, y| x < y)?.0 + 1))),
    function("NORM2", "matrix", "square root of the sum of squares", |a| real(sum_of_squares(&a.numbers(0)?).sqrt())),
    function("NORMALIZE", "vector", "vector of length 1", |a| {
        let array = a.array(0)?;
        let length = sum_of_squares(&array.values).sqrt();
        if length == 0.0 {
            return Err(a.error("all elements are zero"));
        }
        Ok(Value::Array(Array { values: array.values.iter().map(|x| x / length).collect(), ..array }))
    }),
    function("PROD", "values", "product of all elements", |a| real(a.numbers(0)?.iter().product())),
    function("RESHAPE", "values, shape", "the same elements in another number of rows and columns", |a| {
        let (array, shape) = (a.array(0)?, a.numbers(1)?);
        match *shape.as_slice() {
            [r, c] if r >= 0.0 && c >= 0.0 && r * c == array.values.len() as f64 && r.fract() == 0.0 => {
                Ok(Value::Array(Array { rows: r as usize, columns: c as usize, values: array.values }))
            }
            _ => Err(a.error(format!("{} elements do not fill that shape", array.values.len()))),
        }
    }),
    function("REVERSE", "values", "elements in reverse order", |a| {
        if let Some(mut list) = listed(a) {
            list.reverse();
            return a.relisted(list);
        }
        let mut array = a.array(0)?;
        array.values.reverse();
        Ok(Value::Array(array))
    }),
    function("RMS", "values", "root of the mean of squares", |a| {
        let values = filled(a)?;
        real((sum_of_squares(&values) / values.len() as f64).sqrt())
    }),
    function("ROWS", "matrix", "number of rows, or of elements of a list", |a| {
        Ok(count(match &a.values[0] {
            Value::Texts(list) => list.len(),
            Value::Objects(list) => list.len(),
            Value::Text(_) | Value::Object(_) => 1,
            Value::Nothing => 0,
            _ => a.array(0)?.rows,
        }))
    }),
    function("SERIES", "start, step, n", "n numbers at equal steps", |a| {
        let (start, step, n) = (a.number(0)?, a.number(1)?, a.count(2)?);
        column((0..n).map(|i| start + step * i as f64).collect())
    }),
    function("SERIES2", "start, end, n", "n numbers at equal steps between two ends", |a| {
        let (start, end, n) = (a.number(0)?, a.number(1)?, a.count(2)?);
        let step = if n > 1 { (end - start) / (n - 1) as f64 } else { 0.0 };
        column((0..n).map(|i| if i + 1 == n && n > 1 { end } else { start + step * i as f64 }).collect())
    }),
    function("SHAPE", "matrix", "numbers of rows and columns", |a| {
        let array = a.array(0)?;
        column(vec![array.rows as f64, array.columns as f64])
    }),
    function("SORT", "values, direction", "sorted elements; \"a\" ascending or \"d\" descending", |a| {
        if let Value::Texts(list) = &a.values[0] {
            let (mut list, down) = (list.clone(), descending(a)?);
            list.sort_by(|x, y| if down { y.cmp(x) } else { x.cmp(y) });
            return Ok(Value::Texts(list));
        }
        let (mut array, down) = (a.array(0)?, descending(a)?);
        array.values.sort_by(|x, y| if down { y.total_cmp(x) } else { x.total_cmp(y) });
        Ok(Value::Array(array))
    }),
    function("SORT_BY", "keys, values, direction", "elements in the order of their keys", |a| {
        let (keys, array) = (a.numbers(0)?, a.array(1)?);
        if keys.len() != array.values.len() {
            return Err(a.error("the two arrays must have the same length"));
        }
        let text = a.text(2)?;
        let down = text.to_ascii_lowercase().starts_with('d');
        let order = sorted_indices(&keys, down);
        Ok(Value::Array(Array { values: order.into_iter().map(|i| array.values[i]).collect(), ..array.clone() }))
    }),
    function("SORT_INDEX", "values, direction", "positions of the elements in sorted order", |a| {
        let (values, down) = (a.numbers(0)?, descending(a)?);
        column(sorted_indices(&values, down).into_iter().map(|i| (i + 1) as f64).collect())
    }),
    function("SSQ", "values", "sum of squares", |a| real(sum_of_squares(&a.numbers(0)?))),
    function("STACK", "matrix, matrix", "rows of one matrix above those of another", stack),
    function("SUM", "values", "sum of all elements", |a| real(a.numbers(0)?.iter().sum())),
    function("TILDE", "vector", "matrix whose product with a vector is the vector product", |a| {
        let v = a.vector(0)?;
        let values = vec![0.0, v.z, -v.y, -v.z, 0.0, v.x, v.y, -v.x, 0.0];
        Ok(Value::Array(Array { rows: 3, columns: 3, values }))
    }),
    function("TMAT", "angles, sequence", "rotation matrix of three angles", |a| {
        let (angles, sequence) = (a.vector(0)? * a.angle_unit(), sequence(a)?);
        let rotation = rotation_of(sequence, angles.to_array());
        Ok(Value::Array(Array { rows: 3, columns: 3, values: rotation.to_cols_array().to_vec() }))
    }),
    function("TMAT3", "angles, kind, axes", "rotation matrix of three angles; kind b or s, axes such as 313", |a| {
        let word = match a.text(1)?.trim().to_ascii_lowercase().as_str() {
            "b" => format!("body{}", a.integer(2)?),
            "s" => format!("space{}", a.integer(2)?),
            other => return Err(a.error(format!("the kind of rotation is \"b\" or \"s\", not \"{other}\""))),
        };
        let sequence = named_sequence(&word, a)?;
        let rotation = rotation_of(sequence, (a.vector(0)? * a.angle_unit()).to_array());
        Ok(Value::Array(Array { rows: 3, columns: 3, values: rotation.to_cols_array().to_vec() }))
    }),
    function("TRANSPOSE", "matrix", "transposed matrix", |a| Ok(Value::Array(transposed(&a.array(0)?)))),
    function("UNIQUE", "values", "sorted elements, each once", |a| {
        if let Some(list) = listed(a) {
            let mut kept: Vec<Value> = Vec::new();
            for value in list {
                if !kept.contains(&value) {
                    kept.push(value);
                }
            }
            return a.relisted(kept);
        }
        let mut values = a.numbers(0)?;
        values.sort_by(f64::total_cmp);
        values.dedup();
        column(values)
    }),
    function("VAL", "values, x", "element nearest to x", |a| {
        let values = filled(a)?;
        real(values[nearest(&values, a.number(1)?)])
    }),
    function("VALI", "values, x", "position of the element nearest to x", |a| {
        let values = filled(a)?;
        Ok(count(nearest(&values, a.number(1)?) + 1))
    }),
];

fn count(n: usize) -> Value {
    Value::Integer(n as i64)
}

/// Side of a square matrix that memory can hold.
fn a_matrix_side(n: usize, a: &Arguments) -> Outcome<usize> {
    if n <= 3000 { Ok(n) } else { Err(a.error("the matrix would be too large")) }
}

fn filled(a: &Arguments) -> Outcome<Vec<f64>> {
    let values = a.numbers(0)?;
    if values.is_empty() { Err(a.error("the array is empty")) } else { Ok(values) }
}

fn sum_of_squares(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum()
}

/// First of the extreme elements: index from 0 and value.
fn extreme(a: &Arguments, better: fn(f64, f64) -> bool) -> Outcome<(usize, f64)> {
    let values = filled(a)?;
    let start = (0, values[0]);
    Ok(values.into_iter().enumerate().fold(start, |best, (i, x)| if better(x, best.1) { (i, x) } else { best }))
}

fn nearest(values: &[f64], x: f64) -> usize {
    let mut best = 0;
    for (i, y) in values.iter().enumerate() {
        if (y - x).abs() < (values[best] - x).abs() {
            best = i;
        }
    }
    best
}

fn descending(a: &Arguments) -> Outcome<bool> {
    match a.text(1)?.to_ascii_lowercase().as_str() {
        "a" | "ascending" => Ok(false),
        "d" | "descending" => Ok(true),
        other => Err(a.error(format!("the direction must be \"a\" or \"d\", not \"{other}\""))),
    }
}

fn sorted_indices(values: &[f64], down: bool) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|i, j| {
        let (x, y) = (values[*i], values[*j]);
        if down { y.total_cmp(&x) } else { x.total_cmp(&y) }
    });
    order
}

/// The elements of an array of texts or objects; none for numbers.
fn listed(a: &Arguments) -> Option<Vec<Value>> {
    match &a.values[0] {
        Value::Texts(list) => Some(list.iter().cloned().map(Value::Text).collect()),
        Value::Objects(list) => Some(list.iter().copied().map(Value::Object).collect()),
        Value::Text(_) | Value::Object(_) => Some(vec![a.values[0].clone()]),
        _ => None,
    }
}

/// An element to look for in the first argument, of its type.
fn one_of_list(a: &Arguments, i: usize) -> Outcome<Value> {
    match &a.values[0] {
        Value::Objects(_) | Value::Object(_) => a.object(i).map(Value::Object),
        _ => a.text(i).map(Value::Text),
    }
}

impl Arguments<'_, '_> {
    /// Elements as an array of the type of the first argument.
    fn relisted(&self, list: Vec<Value>) -> Outcome<Value> {
        Ok(match &self.values[0] {
            Value::Objects(_) | Value::Object(_) => Value::Objects(list.iter().filter_map(Value::as_object).collect()),
            _ => Value::Texts(
                list.into_iter().filter_map(|v| if let Value::Text(text) = v { Some(text) } else { None }).collect(),
            ),
        })
    }
}

fn compressed(a: &mut Arguments) -> Outcome<Value> {
    if let Some(list) = listed(a) {
        let mut kept: Vec<Value> =
            list.into_iter().filter(|v| !matches!(v, Value::Text(t) if t.trim().is_empty())).collect();
        if kept.is_empty() && matches!(a.values[0], Value::Texts(_) | Value::Text(_)) {
            kept.push(Value::Text(String::new()));
        }
        return a.relisted(kept);
    }
    let kept: Vec<f64> = a.numbers(0)?.into_iter().filter(|x| *x != 0.0).collect();
    column(if kept.is_empty() { vec![0.0] } else { kept })
}

fn append(a: &mut Arguments) -> Outcome<Value> {
    if matches!(a.values[0], Value::Texts(_) | Value::Text(_) | Value::Objects(_) | Value::Object(_)) {
        return stack(a);
    }
    let (x, y) = (a.array(0)?, a.array(1)?);
    if x.values.is_empty() {
        return Ok(Value::Array(y));
    }
    if x.rows != y.rows {
        return Err(a.error(format!("the matrices have {} and {} rows", x.rows, y.rows)));
    }
    Ok(Value::Array(Array { rows: x.rows, columns: x.columns + y.columns, values: [x.values, y.values].concat() }))
}

fn stack(a: &mut Arguments) -> Outcome<Value> {
    match (&a.values[0], &a.values[1]) {
        (Value::Texts(_) | Value::Text(_), _) | (_, Value::Texts(_) | Value::Text(_)) => {
            return Ok(Value::Texts([a.texts(0)?, a.texts(1)?].concat()));
        }
        (Value::Objects(_) | Value::Object(_), _) | (_, Value::Objects(_) | Value::Object(_)) => {
            return Ok(Value::Objects([a.objects(0)?, a.objects(1)?].concat()));
        }
        _ => {}
    }
    let (x, y) = (a.array(0)?, a.array(1)?);
    if x.values.is_empty() || y.values.is_empty() {
        return Ok(Value::Array(if x.values.is_empty() { y } else { x }));
    }
    if x.columns != y.columns {
        return Err(a.error(format!("the matrices have {} and {} columns", x.columns, y.columns)));
    }
    let mut values = Vec::with_capacity(x.values.len() + y.values.len());
    for (upper, lower) in x.values.chunks_exact(x.rows).zip(y.values.chunks_exact(y.rows)) {
        values.extend_from_slice(upper);
        values.extend_from_slice(lower);
    }
    Ok(Value::Array(Array { rows: x.rows + y.rows, columns: x.columns, values }))
}

pub(super) fn transposed(m: &Array) -> Array {
    let values = (0..m.rows * m.columns).map(|k| m.values[(k % m.columns) * m.rows + k / m.columns]).collect();
    Array { rows: m.columns, columns: m.rows, values }
}

fn matrix3(a: &Arguments, i: usize) -> Outcome<DMat3> {
    let m = a.array(i)?;
    let values: Result<[f64; 9], _> = m.values.try_into();
    match values {
        Ok(values) if m.rows == 3 => Ok(DMat3::from_cols_array(&values)),
        _ => Err(a.error("a 3 x 3 matrix is needed")),
    }
}

fn sequence(a: &Arguments) -> Outcome<Sequence> {
    named_sequence(&a.text(1)?, a)
}

fn named_sequence(word: &str, a: &Arguments) -> Outcome<Sequence> {
    Sequence::named(word).ok_or_else(|| a.error(format!("`{word}` is not one of the 24 rotation sequences")))
}

fn angles(rotation: DMat3, a: &Arguments) -> Outcome<Value> {
    let unit = a.angle_unit();
    column(sequence_angles(&rotation, sequence(a)?).iter().map(|x| x / unit).collect())
}
