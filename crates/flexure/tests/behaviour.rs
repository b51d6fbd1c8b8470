//! How Adams View behaves, case by case: each test is one documented or observed fact, or one that
//! is inferred from them. The numbers are those of the list of cases the project works from.

#[path = "behaviour/beam_values.rs"]
mod beam_values;
#[path = "behaviour/beams.rs"]
mod beams;
#[path = "behaviour/control.rs"]
mod control;
#[path = "behaviour/export.rs"]
mod export;
#[path = "behaviour/expressions.rs"]
mod expressions;
#[path = "behaviour/keywords.rs"]
mod keywords;
#[path = "behaviour/lines.rs"]
mod lines;
#[path = "behaviour/names.rs"]
mod names;
#[path = "behaviour/physics.rs"]
mod physics;
#[path = "behaviour/scene.rs"]
mod scene;
