//! `flexible_link ...`: a chain of rigid parts and beams between two markers, as the dialog for a
//! discrete flexible link makes it. The verb writes commands and runs them, so that the journal, undo
//! and exports see nothing but parts, markers, beams and joints.
//!
//! A link of length L and n segments has n parts, each of a length h = L/n and with its centre of mass
//! in its middle. Beams of length h join the middles. At either end the outer half segment is free, is
//! fixed to the body of the marker there, or is replaced by a beam of length h/2 to that body. Masses,
//! inertias, geometry and beams refer to material and section by expressions, so that they follow a
//! change.
//!
//! The dialog puts the name of the link before that of each object: of a link `ARM` the parts are `ARM_1`,
//! `ARM_2`, ..., the beams `ARM_BEAM_1`, ..., the fixed joints `ARM_JOINT_1` and `ARM_JOINT_2` by their end.
//! The markers at the ends of the link are `ARM_MARKER_1` and `ARM_MARKER_2` on its outer parts, and
//! `ARM_MARKER_3` and `ARM_MARKER_4` on the bodies that hold it. Which number which marker has is ours.

mod chain;
mod outline;
mod report;

use glam::DVec3;
use model::{CoordinateSystem, ObjectId, Sequence};
use schema::{Dimension, Field, Verb};
use text::Diagnostic;

use super::{VerbEntry, entry, shared::Outcome};
use crate::{Interpreter, call::Call, interpreter::Flow};
use chain::{Attachment, Chain};
use outline::Outline;

const ATTACHMENTS: &[&str] = &["rigid", "flexible", "free"];

const MATERIAL: Field =
    Field::object("material_name", "material").required().doc("density, modulus and Poisson's ratio of the link");
const SECTION: Field = Field::object("section_name", "section").required().doc("cross section of the link");
const SEGMENTS: Field = Field::integer("segments").default(5.0).at_least(1.0).doc("number of rigid parts");
const FORMULATION: Field =
    Field::choice("formulation", &["linear", "string", "nonlinear"]).default_word("linear").doc("law of the beams");
const fn attachment(name: &'static str, doc: &'static str) -> Field {
    Field::choice(name, ATTACHMENTS).default_word("rigid").doc(doc)
}
const ATTACHMENT_1: Field = attachment(
    "attachment_1",
    "first end: rigid fixes the first part, flexible puts a beam of half a segment, free does nothing",
);
const ATTACHMENT_2: Field = attachment("attachment_2", "second end, in the same way");

pub const CREATE: VerbEntry = entry(
    Verb {
        path: "flexible_link create",
        fields: &[
            Field::text("link_name").required().doc("beginning of the names of parts, beams and joints"),
            Field::object("marker_1", "marker")
                .required()
                .doc("where the link begins; its y axis is that of the section"),
            Field::object("marker_2", "marker").required().doc("where the link ends"),
            MATERIAL,
            SECTION,
            SEGMENTS,
            Field::real("damping_ratio", Dimension::TIME).default(0.0).at_least(0.0).doc("damping ratio of the beams"),
            ATTACHMENT_1,
            ATTACHMENT_2,
            FORMULATION,
            Field::text("color").doc("colour of the parts and their geometry"),
            Field::yes_no("geometry").default_word("yes").doc("draw the section along every segment"),
            Field::yes_no("convergence_report")
                .default_word("no")
                .doc("list natural frequencies of n, 2 n and 4 n segments against those of the continuous beam"),
        ],
        rules: &[],
        doc: "makes a chain of parts and beams between two markers (an extension of Flexure)",
    },
    create,
);

pub const REPORT: VerbEntry = entry(
    Verb {
        path: "flexible_link report",
        fields: &[
            MATERIAL,
            SECTION,
            Field::real("length", Dimension::LENGTH).required().above(0.0).doc("length of the link"),
            SEGMENTS,
            ATTACHMENT_1,
            ATTACHMENT_2,
            super::shared::SHOW,
            Field::text("file_name").doc("file for the listing"),
        ],
        rules: &[],
        doc: "natural frequencies of n, 2 n and 4 n segments against the continuous beam (an extension of Flexure)",
    },
    report,
);

/// The largest number of segments; four times as many are in a report.
const MOST_SEGMENTS: f64 = 10_000.0;

fn create(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let chain = read_chain(interpreter, call)?;
    let failed = interpreter.report.failed;
    let text = chain.commands();
    let file = interpreter.sources.add(format!("flexible link {}", chain.name), text);
    // The commands are written in x, y, z and body 3-1-3, whatever the session reads otherwise.
    let settings = interpreter.database.settings();
    let (system, sequence) = (settings.coordinate_system, settings.sequence);
    interpreter.database.change_settings(|s| {
        (s.coordinate_system, s.sequence) = (CoordinateSystem::Cartesian, Sequence::BODY_313);
    });
    interpreter.trace.push(call.span);
    interpreter.undo_blocks += 1;
    let flow = interpreter.run_source(file);
    interpreter.undo_blocks -= 1;
    interpreter.trace.pop();
    interpreter.database.change_settings(|s| (s.coordinate_system, s.sequence) = (system, sequence));
    if interpreter.report.failed > failed || flow == Flow::Abort {
        return Err(vec![
            Diagnostic::error("flexible_link/not-made", format!("the flexible link `{}` is not made", chain.name))
                .at(call.span, "nothing of it is left")
                .note("the command that failed is named above"),
        ]);
    }
    if interpreter.flag_argument(call, "convergence_report")? == Some(true) {
        let case = report::Case::of(interpreter, call, chain.length_si, chain.segments, chain.attachments)?;
        let lines = report::lines(interpreter, &case)?;
        interpreter.show(&lines);
    }
    Ok(flow)
}

fn report(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let length = interpreter.number_argument(call, "length")?.unwrap_or(0.0);
    let length = length * interpreter.database.units().factor(Dimension::LENGTH);
    if length <= 0.0 || !length.is_finite() {
        return Err(vec![no_length("the length of the link is not above 0").at(call.span, "no link")]);
    }
    let (segments, attachments) = (read_segments(interpreter, call)?, read_attachments(interpreter, call)?);
    let case = report::Case::of(interpreter, call, length, segments, attachments)?;
    let lines = report::lines(interpreter, &case)?;
    super::list::deliver(interpreter, call, &lines)
}

fn no_length(sentence: &str) -> Diagnostic {
    Diagnostic::error("flexible_link/no-length", sentence).help("put the two ends apart")
}

/// An object that the command must name.
fn needed(interpreter: &mut Interpreter, call: &Call, name: &str) -> Outcome<ObjectId> {
    interpreter.object_argument(call, name)?.ok_or_else(|| vec![call.missing(&[name])])
}

fn read_segments(interpreter: &mut Interpreter, call: &Call) -> Outcome<usize> {
    let segments = interpreter.number_argument(call, "segments")?.unwrap_or(5.0);
    if !(1.0..=MOST_SEGMENTS).contains(&segments) {
        return Err(vec![
            Diagnostic::error("flexible_link/segments", format!("a flexible link cannot have {segments} segments"))
                .at(call.argument("segments").map_or(call.span, |a| a.value_span), "not possible")
                .help(format!("give 1 to {MOST_SEGMENTS}; 10 are enough for the first bending mode")),
        ]);
    }
    Ok(segments as usize)
}

fn read_attachments(interpreter: &mut Interpreter, call: &Call) -> Outcome<[Attachment; 2]> {
    let mut both = [Attachment::Rigid; 2];
    for (end, name) in both.iter_mut().zip(["attachment_1", "attachment_2"]) {
        *end = match interpreter.word_of(call, name)?.as_deref() {
            Some("flexible") => Attachment::Flexible,
            Some("free") => Attachment::Free,
            _ => Attachment::Rigid,
        };
    }
    Ok(both)
}

/// A material with what beams need.
fn read_material(interpreter: &mut Interpreter, call: &Call) -> Outcome<ObjectId> {
    let material = needed(interpreter, call, "material_name")?;
    for cell in ["density", "youngs_modulus", "poissons_ratio"] {
        if interpreter.database.number(material, cell).is_none() {
            let name = interpreter.database.full_name(material);
            return Err(vec![
                Diagnostic::error("flexible_link/material", format!("the material `{name}` has no `{cell}`"))
                    .at(call.argument("material_name").map_or(call.span, |a| a.value_span), "this material")
                    .help(format!("material modify material_name={name} {cell}=...")),
            ]);
        }
    }
    Ok(material)
}

fn read_chain(interpreter: &mut Interpreter, call: &Call) -> Outcome<Chain> {
    let Some(typed) = interpreter.word_of(call, "link_name")? else { return Err(vec![call.missing(&["link_name"])]) };
    let name = model::split_name(typed.strip_prefix('.').unwrap_or(&typed)).pop().unwrap_or_default();
    let markers = [needed(interpreter, call, "marker_1")?, needed(interpreter, call, "marker_2")?];
    let material = read_material(interpreter, call)?;
    let section = needed(interpreter, call, "section_name")?;
    let segments = read_segments(interpreter, call)?;
    let attachments = read_attachments(interpreter, call)?;
    let damping_ratio = interpreter.number_argument(call, "damping_ratio")?.unwrap_or(0.0);
    let formulation = interpreter.word_of(call, "formulation")?.unwrap_or_else(|| "linear".into());
    let color = interpreter.word_of(call, "color")?;
    let drawn = interpreter.flag_argument(call, "geometry")? != Some(false);
    let database = &interpreter.database;
    let poses = markers.map(|m| database.global_pose(m));
    let chord = poses[1].origin - poses[0].origin;
    let size = poses[0].origin.abs().max_element().max(poses[1].origin.abs().max_element());
    if chord.length() <= 1e-12 * size.max(1e-300) {
        let names = markers.map(|m| database.full_name(m));
        let error = no_length(&format!("`{}` and `{}` are at one place", names[0], names[1]));
        return Err(vec![error.at(call.span, "a link between them has no length")]);
    }
    let Some(model) = database.model_of(markers[0]) else { return Err(vec![call.missing(&["marker_1"])]) };
    let Some(ground) = database.child(Some(model), "ground", "ground") else {
        return Err(vec![call.missing(&["marker_1"])]);
    };
    let bodies = markers.map(|m| database.object(m).parent.map(|p| database.full_name(p)).unwrap_or_default());
    let units = database.units();
    let angle = units.angle.si;
    Ok(Chain {
        name,
        model: database.full_name(model),
        ground: database.full_name(ground),
        bodies,
        start: poses[0].origin,
        chord,
        angles: model::angles_of(&chain::axes(chord, &poses[0].rotation)).map(|a| a / angle),
        length_unit: units.length.name,
        length_si: chord.length() * units.factor(Dimension::LENGTH),
        segments,
        attachments,
        material: database.full_name(material),
        section: database.full_name(section),
        damping_ratio,
        formulation,
        color,
        outline: drawn.then(|| Outline::of(database.object(section).class.id)),
    })
}

/// A point as a command wants it.
fn point(p: DVec3) -> String {
    format!("{:?}, {:?}, {:?}", p.x, p.y, p.z)
}
