//! Functions that ask for the load of an element, `BEAM(id, jflag, component, rm)`, while they act
//! themselves. The element may be lowered after the function, so the two are brought together when
//! everything is there; what would depend on itself is refused by name.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Arc, OnceLock},
};

use equations::{Force, FrameCotangent, FrameId, FrameLoad, Gradient, LoadCotangent, Side, State};
use functions::Measure;
use glam::DVec3;
use model::ObjectId;
use text::Diagnostic;

use crate::lower::{LoadId, Lowering, is_active};

/// Where a function finds the element whose load it asks for. Empty for a deactivated element, which
/// has no load.
#[derive(Clone, Default)]
pub struct LoadSlot(Arc<OnceLock<Arc<dyn Force>>>);

impl std::fmt::Debug for LoadSlot {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("LoadSlot").field(&self.0.get().map(Force::name)).finish()
    }
}

/// A function that waits for the element it asks for.
pub(crate) struct Wanted {
    /// Who has the function.
    owner: ObjectId,
    element: ObjectId,
    slot: LoadSlot,
}

/// A place for the load of an element, and the frames it depends on.
pub(super) fn slot(lowering: &mut Lowering<'_>, owner: ObjectId, element: ObjectId) -> (LoadSlot, Vec<FrameId>) {
    let slot = LoadSlot::default();
    if !is_active(lowering.database, element) {
        return (slot, Vec::new());
    }
    let markers = ["i_marker_name", "j_marker_name"].map(|cell| lowering.database.reference(element, cell));
    let ends = markers.into_iter().flatten().filter_map(|marker| lowering.frame(marker)).collect();
    lowering.wanted.push(Wanted { owner, element, slot: slot.clone() });
    (slot, ends)
}

impl LoadSlot {
    /// The component asked for, SI; adds its derivative.
    pub(super) fn value(&self, measure: &Measure, state: &State, gradient: Option<&mut Gradient>) -> f64 {
        let (Measure::Load { j_flag, component, rm, .. }, Some(force)) = (measure, self.0.get()) else { return 0.0 };
        let side = if *j_flag { Side::J } else { Side::I };
        let load = force.load_at(state, side);
        let value = component_of(state, load, *component, *rm);
        if let (Some(gradient), Some(source)) = (gradient, force.load_of_state()) {
            let is_force = *component <= 4;
            let vector = if is_force { load.f_g } else { load.t_g };
            let axis = match component {
                1 | 5 => vector.normalize_or_zero(),
                _ => {
                    let axes = state.frame_or_global(rm.map(FrameId));
                    let axis = axes.rot_gi.col(axis_of(*component));
                    // The component changes as its axis turns, too.
                    let turning = FrameCotangent { phi: axis.cross(vector), ..FrameCotangent::default() };
                    gradient.add_frame(state, axes, &turning);
                    axis
                }
            };
            let (f, t) = if is_force { (axis, DVec3::ZERO) } else { (DVec3::ZERO, axis) };
            source.add_load_gradient(state, side, &LoadCotangent { f, t }, gradient);
        }
        value
    }
}

/// Components as load functions number them: 1 size of the force, 2 to 4 its components, 5 size of
/// the torque, 6 to 8 its components; in the axes of `rm`.
pub(crate) fn component_of(state: &State, load: FrameLoad, component: u8, rm: Option<u32>) -> f64 {
    let vector = if component <= 4 { load.f_g } else { load.t_g };
    match component {
        1 | 5 => vector.length(),
        _ => vector.dot(state.frame_or_global(rm.map(FrameId)).rot_gi.col(axis_of(component))),
    }
}

fn axis_of(component: u8) -> usize {
    usize::from(component.clamp(2, 8) - 2) % 4
}

/// Brings functions and elements together when all elements are lowered.
pub(crate) fn connect(lowering: &mut Lowering<'_>) {
    let wanted = std::mem::take(&mut lowering.wanted);
    let mut asks: BTreeMap<ObjectId, Vec<ObjectId>> = BTreeMap::new();
    for w in &wanted {
        asks.entry(w.owner).or_default().push(w.element);
    }
    let mut shared: BTreeMap<usize, Arc<dyn Force>> = BTreeMap::new();
    let mut refused = BTreeSet::new();
    for Wanted { owner, element, slot } in wanted {
        // An element with errors of its own has no entry; those errors are reported already.
        let Some(load) = lowering.loads.get(&element).copied() else { continue };
        let readable = match load {
            LoadId::Constraint(_) => Err("follows from the solution as a whole, like every reaction"),
            LoadId::Force(index) if lowering.forces[index].load_of_state().is_none() => {
                Err("is given by a function itself")
            }
            LoadId::Force(index) => Ok(index),
        };
        let index = match readable {
            Ok(index) => index,
            // Two components of one load are one trouble.
            Err(why) => {
                if refused.insert((owner, element)) {
                    refuse(lowering, &asks, (owner, element), why);
                }
                continue;
            }
        };
        let force = shared.entry(index).or_insert_with(|| share(lowering, index));
        // A slot is filled once: it was made for this entry.
        let _ = slot.0.set(force.clone());
    }
}

/// Makes a force one that others can read too.
fn share(lowering: &mut Lowering<'_>, index: usize) -> Arc<dyn Force> {
    let shared: Arc<dyn Force> = Arc::from(lowering.forces.swap_remove(index));
    lowering.forces.push(Box::new(shared.clone()));
    let last = lowering.forces.len() - 1;
    lowering.forces.swap(index, last);
    shared
}

/// The way from a function over elements back to it, if there is one.
fn loop_through(asks: &BTreeMap<ObjectId, Vec<ObjectId>>, owner: ObjectId, element: ObjectId) -> Option<Vec<ObjectId>> {
    let mut ways = vec![vec![owner, element]];
    let mut seen = Vec::new();
    while let Some(way) = ways.pop() {
        let last = *way.last()?;
        if last == owner {
            return Some(way);
        }
        if !seen.contains(&last) {
            seen.push(last);
            ways.extend(asks.get(&last).into_iter().flatten().map(|next| [way.as_slice(), &[*next]].concat()));
        }
    }
    None
}

/// Says that a load cannot be asked for; a loop is called one.
fn refuse(
    lowering: &mut Lowering<'_>,
    asks: &BTreeMap<ObjectId, Vec<ObjectId>>,
    (owner, element): (ObjectId, ObjectId),
    why: &str,
) {
    if let Some(way) = loop_through(asks, owner, element) {
        report_loop(lowering, &way);
        return;
    }
    let (owner, element) = (lowering.name(owner), lowering.name(element));
    lowering.report(
        Diagnostic::error(
            "function/not-of-state",
            format!("the function of `{owner}` uses the load of `{element}`, which cannot act as a force yet"),
        )
        .note(format!("the load of `{element}` {why}"))
        .help("loads of beams, bushings and spring-dampers can; others can be recorded by a request"),
    );
}

fn report_loop(lowering: &mut Lowering<'_>, way: &[ObjectId]) {
    let names: Vec<String> = way.iter().map(|id| format!("`{}`", lowering.name(*id))).collect();
    let message = match names.as_slice() {
        [owner, _] => format!("the function of {owner} asks for the load of {owner}: an algebraic loop"),
        _ => format!("the function of {} asks for its own load: an algebraic loop", names[0]),
    };
    let mut diagnostic = Diagnostic::error("function/algebraic-loop", message);
    if names.len() > 2 {
        diagnostic = diagnostic.note(format!("{} asks for the load of the next", names.join(", ")));
    }
    lowering.report(diagnostic.help("let the function depend on positions and velocities instead"));
}
