//! The functions, one file for each or for a small group. A file states name, number of arguments
//! and definition in terms of the tape; [`find`] is the list.

mod choices;
mod displacement;
mod havsin;
mod impact;
mod intrinsics;
mod loads;
mod series;
mod shf;
mod step;
mod sweep;
mod unsupported;
mod velocity;

pub(crate) use unsupported::why_not_supported;

use crate::{
    Component, Measure,
    tape::{Node, Tape},
};

/// A function of numbers.
pub(crate) struct Numeric {
    pub name: &'static str,
    /// Fewest and most arguments.
    pub arguments: (usize, usize),
    /// Appends the definition to the tape. The number of arguments is checked before.
    pub build: fn(&mut Tape, &[Node]) -> Node,
}

/// A function of markers. Markers left out are the global frame.
pub(crate) struct OfMarkers {
    pub name: &'static str,
    /// Fewest and most arguments; the first `fewest` must be markers other than 0.
    pub arguments: (usize, usize),
    /// Makes the measure; the slice has four entries.
    pub measure: fn(&Markers) -> Measure,
}

/// Marker arguments in order.
pub(crate) struct Markers {
    pub first: u32,
    pub rest: [Option<u32>; 3],
}

/// What a function name stands for.
pub(crate) enum Entry {
    Numeric(&'static Numeric),
    OfMarkers(&'static OfMarkers),
    /// A function `(id, jflag, component, rm)` of an element.
    Load,
}

const NUMERIC: &[&[Numeric]] =
    &[intrinsics::ALL, choices::ALL, step::ALL, havsin::ALL, shf::ALL, series::ALL, impact::ALL, sweep::ALL];
const OF_MARKERS: &[&[OfMarkers]] = &[displacement::ALL, velocity::ALL, loads::AT_MARKERS];

/// The function of a name, ignoring case.
pub(crate) fn find(name: &str) -> Option<Entry> {
    let numeric = NUMERIC.iter().copied().flatten().find(|f| f.name.eq_ignore_ascii_case(name));
    let of_markers = || OF_MARKERS.iter().copied().flatten().find(|f| f.name.eq_ignore_ascii_case(name));
    let load = || loads::OF_ELEMENTS.iter().any(|f| f.eq_ignore_ascii_case(name));
    numeric.map(Entry::Numeric).or_else(|| of_markers().map(Entry::OfMarkers)).or_else(|| load().then_some(Entry::Load))
}

/// All names that can be compiled, in a fixed order.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    let numeric = NUMERIC.iter().copied().flatten().map(|f| f.name);
    let of_markers = OF_MARKERS.iter().copied().flatten().map(|f| f.name);
    numeric.chain(of_markers).chain(loads::OF_ELEMENTS.iter().copied())
}

/// The axes in the order of function names.
const X: Component = Component::X;
const Y: Component = Component::Y;
const Z: Component = Component::Z;
const MAGNITUDE: Component = Component::Magnitude;
