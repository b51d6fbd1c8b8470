//! Where frames are on their bodies, in SI units, and cells read for shapes.

use glam::{DMat3, DVec3};
use model::{Database, ObjectId, Pose};
use schema::Default;
use text::Diagnostic;

/// A frame on a body: pose in body axes, lengths in metre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnBody {
    pub body: ObjectId,
    pub pose: Pose,
}

/// Pose of an object in its parent, lengths in metre.
pub fn local_pose(database: &Database, id: ObjectId) -> Pose {
    let pose = database.local_pose(id);
    Pose { origin: pose.origin * database.units().length.si, ..pose }
}

/// Pose of an object in the global frame, lengths in metre.
pub fn global_pose(database: &Database, id: ObjectId) -> Pose {
    let pose = database.global_pose(id);
    Pose { origin: pose.origin * database.units().length.si, ..pose }
}

/// Where a frame is on the body that carries it; a body carries itself. `None` outside bodies.
pub fn on_body(database: &Database, frame: ObjectId) -> Option<OnBody> {
    let (mut pose, mut next) = (Pose::GLOBAL, frame);
    loop {
        let object = database.get(next)?;
        if object.class.is("body") {
            return Some(OnBody { body: next, pose });
        }
        pose = local_pose(database, next).then(&pose);
        next = object.parent?;
    }
}

/// Reads the cells of one object that is a shape; what is missing becomes a diagnostic.
#[derive(Clone, Copy)]
pub struct Cells<'a> {
    pub database: &'a Database,
    pub id: ObjectId,
}

impl Cells<'_> {
    /// A diagnostic about this object.
    pub fn trouble(&self, code: &'static str, what: &str) -> Diagnostic {
        let object = self.database.object(self.id);
        let (word, name) = (object.class.word.to_lowercase(), self.database.full_name(self.id));
        Diagnostic::error(code, format!("{word} `{name}` {what}"))
    }

    /// A number in SI, or the default of its field.
    pub fn number(&self, name: &str) -> Result<f64, Diagnostic> {
        let value = self.database.si(self.id, name).or_else(|| {
            let class = self.database.object(self.id).class;
            let field = class.field(class.cell_index(name)?);
            match field.default {
                Default::Number(x) => Some(x * self.database.units().factor(field.dimension)),
                _ => None,
            }
        });
        match value {
            Some(x) if x.is_finite() => Ok(x),
            Some(_) => Err(self.trouble("geometry/not-a-number", &format!("has a `{name}` that is not finite"))),
            None => Err(self.trouble("geometry/missing-value", &format!("has no `{name}`"))),
        }
    }

    /// A length that must be above zero, metre.
    pub fn above_zero(&self, name: &str) -> Result<f64, Diagnostic> {
        let x = self.number(name)?;
        if x > 0.0 {
            Ok(x)
        } else {
            Err(self.trouble("geometry/not-positive", &format!("has a `{name}` that is not above zero")))
        }
    }

    /// A length along an axis, either way but not zero, metre.
    pub fn not_zero(&self, name: &str) -> Result<f64, Diagnostic> {
        let x = self.number(name)?;
        if x == 0.0 {
            return Err(self.trouble("geometry/not-positive", &format!("has a `{name}` of zero")));
        }
        Ok(x)
    }

    /// A swept angle, radians; `full` where none is given.
    pub fn angle(&self, name: &str, full: f64) -> Result<f64, Diagnostic> {
        let turn = std::f64::consts::TAU;
        match self.database.si(self.id, name) {
            None => Ok(full),
            Some(x) if x.is_finite() && x != 0.0 && x.abs() <= turn * (1.0 + 1e-9) => Ok(x.clamp(-turn, turn)),
            Some(_) => {
                Err(self.trouble("geometry/angle", &format!("has a `{name}` that is zero or more than a full turn")))
            }
        }
    }

    /// A number of drawn sides.
    pub fn sides(&self, name: &str) -> Result<usize, Diagnostic> {
        let given = self.database.integer(self.id, name).unwrap_or(20);
        usize::try_from(given)
            .ok()
            .filter(|n| (3..=5000).contains(n))
            .ok_or_else(|| self.trouble("geometry/sides", &format!("has a `{name}` that is not between 3 and 5000")))
    }

    /// The object a cell names.
    pub fn object(&self, name: &str) -> Result<ObjectId, Diagnostic> {
        self.database
            .reference(self.id, name)
            .ok_or_else(|| self.trouble("geometry/missing-value", &format!("has no `{name}`")))
    }

    /// The frame a cell names, on its body.
    pub fn frame(&self, name: &str) -> Result<OnBody, Diagnostic> {
        on_body(self.database, self.object(name)?)
            .ok_or_else(|| self.trouble("geometry/no-body", &format!("has a `{name}` that is on no body")))
    }

    /// Pose of one frame seen from another, at the design positions of their bodies.
    pub fn relative(&self, from: &OnBody, to: &OnBody) -> Pose {
        if from.body == to.body {
            return from.pose.inverse().then(&to.pose);
        }
        let global = |f: &OnBody| global_pose(self.database, f.body).then(&f.pose);
        global(from).inverse().then(&global(to))
    }

    /// A radius, or the distance of a reference marker from the z axis of `centre`.
    pub fn radius(&self, centre: &OnBody) -> Result<f64, Diagnostic> {
        if self.database.reference(self.id, "ref_radius_by_marker").is_none() {
            return self.above_zero("radius");
        }
        let through = self.frame("ref_radius_by_marker")?;
        let arm = self.relative(centre, &through).origin;
        let radius = arm.x.hypot(arm.y);
        if radius > 0.0 {
            Ok(radius)
        } else {
            Err(self.trouble("geometry/not-positive", "has its reference marker on its axis"))
        }
    }
}

/// Axes with x along `along` and z as near as possible to `near_z`; `None` if they are parallel.
pub fn axes(along: DVec3, near_z: DVec3) -> Option<DMat3> {
    let x = along.try_normalize()?;
    let y = near_z.cross(x);
    if y.length() < 1e-9 * near_z.length() {
        return None;
    }
    let y = y.try_normalize()?;
    Some(DMat3::from_cols(x, y, x.cross(y)))
}
