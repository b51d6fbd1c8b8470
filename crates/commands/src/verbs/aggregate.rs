//! `list_info aggregate_mass`: mass, centre and inertia of several bodies together.

use glam::{DMat3, DVec3};
use model::{ObjectId, Pose};
use schema::{Dimension, Field, Rule, Verb};

use super::{
    VerbEntry, entry, list, listing,
    shared::{self, Outcome},
};
use crate::{BodyMass, Interpreter, call::Call, interpreter::Flow};

pub const AGGREGATE_MASS: VerbEntry = entry(
    Verb {
        path: "list_info aggregate_mass",
        fields: &[
            Field::objects("part_names", "body").doc("bodies; all of the model if not given"),
            Field::object("model_name", "model").current().doc("model whose bodies are taken"),
            Field::object("relative_to", "frame")
                .or_default_coordinate_system()
                .doc("frame in whose axes and about whose origin values are given"),
            Field::on_off("brief").default_word("on").doc("only the sums, not each body"),
            shared::SHOW,
            Field::text("file_name").doc("file for the listing"),
        ],
        rules: &[Rule::AtMostOne(&["part_names", "model_name"])],
        doc: "lists mass, centre of mass and inertia of bodies taken together",
    },
    aggregate_mass,
);

/// A body's mass in global axes, SI.
struct Lump {
    mass: f64,
    centre: DVec3,
    /// About its own centre.
    inertia: DMat3,
}

/// Inertia of a point mass at `arm` about the origin of `arm`.
fn away(mass: f64, arm: DVec3) -> DMat3 {
    let outer = DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z);
    (DMat3::from_diagonal(DVec3::splat(arm.length_squared())) - outer) * mass
}

fn sum(lumps: &[Lump]) -> Lump {
    let mass: f64 = lumps.iter().map(|l| l.mass).sum();
    let moment: DVec3 = lumps.iter().map(|l| l.centre * l.mass).sum();
    let centre = if mass == 0.0 { DVec3::ZERO } else { moment / mass };
    let inertia = lumps.iter().fold(DMat3::ZERO, |i, l| i + l.inertia + away(l.mass, l.centre - centre));
    Lump { mass, centre, inertia }
}

fn aggregate_mass(interpreter: &mut Interpreter, call: &Call) -> Outcome<Flow> {
    let mut bodies = interpreter.objects_argument(call, "part_names")?;
    if bodies.is_empty() {
        let model = interpreter.model_argument(call)?;
        bodies = interpreter.database.below(model, "body");
    }
    let given = interpreter.object_argument(call, "relative_to")?;
    let brief = interpreter.flag_argument(call, "brief")? != Some(false);
    let database = &interpreter.database;
    let frame_id = given.or(database.settings().default_frame).filter(|f| database.get(*f).is_some());
    let length = database.units().factor(Dimension::LENGTH);
    let global = |id: ObjectId| {
        let pose = database.global_pose(id);
        Pose { origin: pose.origin * length, ..pose }
    };
    let frame = frame_id.map_or(Pose::GLOBAL, global);
    let mut lumps = Vec::new();
    let mut lines = vec!["Aggregate mass".to_string()];
    for &body in &bodies {
        // The ground weighs nothing.
        if database.object(body).class.id == "ground" {
            continue;
        }
        let BodyMass { mass, centre, inertia } = interpreter
            .host
            .mass_properties(database, body)
            .map_err(|errors| errors.into_iter().map(|e| e.or_at(call.span, "needed here")).collect::<Vec<_>>())?;
        let pose = global(body);
        let lump = Lump {
            mass,
            centre: pose.origin + pose.rotation * centre,
            inertia: pose.rotation * inertia * pose.rotation.transpose(),
        };
        if !brief {
            lines.push(format!("Part            : {}", database.full_name(body)));
            describe(interpreter, &lump, &frame, &mut lines);
        }
        lumps.push(lump);
    }
    if lumps.is_empty() {
        return Err(vec![list::nothing_to_list(call, "no body with mass among these")]);
    }
    let name = frame_id.map_or("global".to_string(), |f| database.full_name(f));
    lines.push(format!("Bodies          : {}", lumps.len()));
    lines.push(format!("Relative to     : {name}"));
    describe(interpreter, &sum(&lumps), &frame, &mut lines);
    list::deliver(interpreter, call, &lines)
}

/// Mass, centre, inertia about the centre and about the frame's origin, in the axes of the frame.
fn describe(interpreter: &Interpreter, lump: &Lump, frame: &Pose, lines: &mut Vec<String>) {
    let units = interpreter.database.units();
    let turn = frame.rotation.transpose();
    let centre = turn * (lump.centre - frame.origin);
    let unit = |d: Dimension| units.label(d);
    lines.push(format!(
        "{:<16}: {} ({})",
        "Mass",
        listing::shown(lump.mass / units.factor(Dimension::MASS)),
        unit(Dimension::MASS)
    ));
    // Noise of turning and shifting is no value.
    let clean = |x: f64, scale: f64| if x.abs() <= 1e-12 * scale { 0.0 } else { x };
    let far = lump.centre.length() + frame.origin.length();
    let shown = centre.to_array().map(|x| listing::shown(clean(x, far) / units.factor(Dimension::LENGTH))).join(", ");
    lines.push(format!("{:<16}: {shown} ({})", "Centre of mass", unit(Dimension::LENGTH)));
    let about_centre = turn * lump.inertia * frame.rotation;
    let about_origin = about_centre + away(lump.mass, centre);
    for (label, inertia) in [("about centre", about_centre), ("about origin", about_origin)] {
        let i = inertia * (1.0 / units.factor(Dimension::INERTIA));
        // Products of inertia are the integrals of x y, which the tensor holds with a minus.
        let values = [
            ("Ixx", i.x_axis.x),
            ("Iyy", i.y_axis.y),
            ("Izz", i.z_axis.z),
            ("Ixy", -i.x_axis.y),
            ("Izx", -i.z_axis.x),
            ("Iyz", -i.y_axis.z),
        ];
        for (name, x) in values {
            let x = clean(x, i.x_axis.x + i.y_axis.y + i.z_axis.z);
            lines.push(format!("{name} {label:<12}: {} ({})", listing::shown(x), unit(Dimension::INERTIA)));
        }
    }
}
