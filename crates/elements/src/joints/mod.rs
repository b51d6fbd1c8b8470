//! Constraints: joints, primitive joints and motions.

pub mod between;
pub mod convel;
pub mod coupler;
pub mod curve_curve;
pub mod cylindrical;
pub mod fixed;
pub mod gear;
pub mod general_constraint;
pub mod hooke;
pub mod jprim_at_point;
pub mod jprim_inline;
pub mod jprim_inplane;
pub mod jprim_orientation;
pub mod jprim_parallel_axis;
pub mod jprim_perpendicular;
pub mod jprim_point_point;
pub mod motion;
pub mod planar;
pub mod point_curve;
pub mod rackpin;
pub mod revolute;
pub mod screw;
pub mod spherical;
pub mod translational;
pub mod universal;
pub mod user_constraint;
