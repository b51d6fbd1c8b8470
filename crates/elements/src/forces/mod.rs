//! Elements that put loads on bodies.

pub mod angles;
pub mod beam;
pub mod bushing;
pub mod contact;
pub mod elastic;
pub mod field;
pub mod force_vector;
pub mod friction;
pub mod general_force;
pub mod gravity;
pub mod modal_force;
pub mod multi_point_force;
pub mod rotational_spring_damper;
pub mod shared;
pub mod single_component_force;
pub mod torque_vector;
pub mod translational_spring_damper;
