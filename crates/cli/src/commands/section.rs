//! `flexure section`: the properties of a cross section, and a drawing of it.

use comfy_table::{CellAlignment, Table, presets};
use flexure::results::{Format, OutlineRequest, SizeMark, TextSide, outline};
use flexure::sections::{Properties, Shape, Side, Theory};
use flexure::{Dimension, UnitName};

use crate::Outcome;
use crate::arguments::{DiffFormat, Section, ShearTheory};
use crate::commands::{complain, picture_format, save_picture, shown};

pub(super) fn execute(request: &Section) -> Outcome {
    let format = request.out.as_deref().map(picture_format);
    if format == Some(None) {
        return Outcome::Usage;
    }
    let shape = match shape(request) {
        Ok(shape) => shape,
        Err(sentence) => {
            complain(sentence);
            return Outcome::Usage;
        }
    };
    if !(request.nu > -1.0 && request.nu <= 0.5) {
        complain(format_args!("Poisson's ratio is {}; it must be above -1 and at most 0.5", request.nu));
        return Outcome::Usage;
    }
    let theory = match request.theory {
        ShearTheory::Energy => Theory::Energy,
        ShearTheory::Cowper => Theory::Cowper,
        ShearTheory::None => Theory::None,
    };
    let is_length = |word: &str| UnitName::find(word).is_some_and(|unit| unit.dimension == Dimension::LENGTH);
    if !request.units.is_empty() && !is_length(&request.units) {
        complain(format_args!("`{}` is no unit of length; mm, cm, m, inch or foot are", request.units));
        return Outcome::Usage;
    }
    let properties = shape.properties(theory, request.nu);
    let lost = rows(&properties, "").into_iter().find(|(name, _, value, _)| {
        // Without shear deflection a factor is 0; nothing else of a section is.
        !value.is_finite() || *value == 0.0 && !name.ends_with("shear_area_ratio")
    });
    if let Some((name, _, value, _)) = lost {
        let size = if value == 0.0 { "small" } else { "large" };
        complain(format_args!("the sizes are too {size}: `{name}` cannot be written as a number; choose another unit"));
        return Outcome::Usage;
    }
    match request.format {
        DiffFormat::Text => println!("{}", table(request, shape, theory, &properties)),
        DiffFormat::Json => println!("{:#}", json(request, shape, theory, &properties)),
    }
    let (Some(path), Some(format)) = (&request.out, format.flatten()) else { return Outcome::Fine };
    let drawn = draw(request, shape, &properties, format);
    save_picture(path, drawn, request.format == DiffFormat::Text)
}

/// Every size that was given, with the name of its option.
fn given(request: &Section) -> [(&'static str, Option<f64>); 6] {
    [
        ("width", request.width),
        ("height", request.height),
        ("diameter", request.diameter),
        ("thickness", request.thickness),
        ("web_thickness", request.web_thickness),
        ("flange_thickness", request.flange_thickness),
    ]
}

/// The sizes a shape has, in the order in which it wants them.
fn names(kind: &str) -> &'static [&'static str] {
    Shape::KINDS.iter().find(|(word, _)| *word == kind).map_or(&[], |(_, names)| names)
}

fn shape(request: &Section) -> Result<Shape, String> {
    let (kind, given) = (request.kind.as_str(), given(request));
    let option = |name: &str| format!("--{}", name.replace('_', "-"));
    let names = names(kind);
    let list = || names.iter().map(|n| option(n)).collect::<Vec<_>>().join(", ");
    if let Some((extra, _)) = given.iter().find(|(name, size)| size.is_some() && !names.contains(name)) {
        return Err(format!("a section `{kind}` has no {}; its sizes are {}", option(extra), list()));
    }
    let mut sizes = Vec::new();
    for name in names {
        match given.iter().find(|(n, _)| n == name).and_then(|(_, size)| *size) {
            Some(size) => sizes.push(size),
            None if kind == "box" && *name == "flange_thickness" => {}
            None if names.len() == 1 => return Err(format!("a section `{kind}` needs {}", option(name))),
            None => return Err(format!("a section `{kind}` needs {}; its sizes are {}", option(name), list())),
        }
    }
    Shape::new(kind, &sizes)
}

/// Name as in commands, symbol, value and unit of every property.
fn rows(p: &Properties, unit: &str) -> [(&'static str, &'static str, f64, String); 8] {
    let power = |n: u32| if unit.is_empty() { String::new() } else { format!("{unit}**{n}") };
    [
        ("area_of_cross_section", "A", p.area, power(2)),
        ("ixx", "Ixx", p.ixx, power(4)),
        ("iyy", "Iyy", p.iyy, power(4)),
        ("izz", "Izz", p.izz, power(4)),
        ("y_shear_area_ratio", "ASY", p.asy, String::new()),
        ("z_shear_area_ratio", "ASZ", p.asz, String::new()),
        ("y_extreme_fibre", "ey", p.extreme_y, unit.to_string()),
        ("z_extreme_fibre", "ez", p.extreme_z, unit.to_string()),
    ]
}

fn table(request: &Section, shape: Shape, theory: Theory, properties: &Properties) -> Table {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_BORDERS_ONLY_CONDENSED);
    table.set_header(["property", "value", "unit", "from"]);
    let notes = shape.notes(theory);
    for (name, _, value, unit) in rows(properties, &request.units) {
        let note = notes.iter().find(|n| n.of == name).map_or("", |n| n.text);
        table.add_row([name.to_string(), shown(value), unit, note.to_string()]);
    }
    if let Some(column) = table.column_mut(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

fn json(request: &Section, shape: Shape, theory: Theory, properties: &Properties) -> serde_json::Value {
    let sizes = given(request).into_iter().filter_map(|(name, size)| Some((name.to_string(), size?.into())));
    let mut all = serde_json::json!({
        "kind": shape.kind(),
        "sizes": serde_json::Value::Object(sizes.collect()),
        "length_unit": request.units,
        "shear_theory": Theory::WORDS[theory as usize],
        "poisson_ratio": request.nu,
    });
    for (name, _, value, _) in rows(properties, &request.units) {
        all[name] = value.into();
    }
    for note in shape.notes(theory) {
        all["from"][note.of] = note.text.into();
    }
    all
}

fn draw(request: &Section, shape: Shape, properties: &Properties, format: Format) -> Result<Vec<u8>, String> {
    let side = |side| match side {
        Side::Left => TextSide::Left,
        Side::Right => TextSide::Right,
        Side::Above => TextSide::Above,
        Side::Below => TextSide::Below,
    };
    let marks: Vec<SizeMark> = shape
        .marks()
        .into_iter()
        .map(|m| SizeMark { from: m.from, to: m.to, text: shown(m.size), side: side(m.side) })
        .collect();
    let mut lines: Vec<String> = rows(properties, &request.units)
        .into_iter()
        .map(|(_, symbol, value, unit)| {
            format!("{symbol} = {} {}", shown(value), unit.replace("**2", "²").replace("**4", "⁴"))
        })
        .collect();
    lines.push(String::new());
    lines.push("x of J points to the viewer".into());
    let title = format!("{} ({})", shape.kind(), request.units);
    outline(&OutlineRequest {
        title: &title,
        outlines: &shape.outlines(),
        axes: ["y", "z"],
        marks: &marks,
        lines: &lines,
        size: (900, 560),
        format,
    })
    .map_err(|error| error.to_string())
}
