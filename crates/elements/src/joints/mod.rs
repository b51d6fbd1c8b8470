//! Constraints: joints, primitive joints and motions.

pub mod between;
pub mod cylindrical;
pub mod fixed;
pub mod hooke;
pub mod jprim_at_point;
pub mod jprim_inline;
pub mod jprim_inplane;
pub mod jprim_orientation;
pub mod jprim_parallel_axis;
pub mod jprim_perpendicular;
pub mod motion;
pub mod planar;
pub mod revolute;
pub mod spherical;
pub mod translational;
pub mod universal;
