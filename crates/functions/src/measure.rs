//! What a function asks of the state of the system.

/// A component of a vector, or its magnitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    X,
    Y,
    Z,
    Magnitude,
}

/// One state-dependent quantity. Markers are the numbers the [`Resolver`] gave out; `None` is the
/// global frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measure {
    /// DX DY DZ DM (i, j, k).
    Displacement { component: Component, i: u32, j: Option<u32>, k: Option<u32> },
    /// AX AY AZ (i, j): `component` is the axis.
    Angle { component: Component, i: u32, j: Option<u32> },
    /// PSI THETA PHI YAW PITCH ROLL: angle `which` (0, 1, 2) of the body sequence 313 or 321;
    /// PITCH is minus the second angle.
    EulerAngle { yaw_pitch_roll: bool, which: u8, i: u32, j: Option<u32> },
    /// INCANG(i, j, k).
    IncludedAngle { i: u32, j: u32, k: u32 },
    /// VX VY VZ VM (i, j, k, l).
    Velocity { component: Component, i: u32, j: Option<u32>, k: Option<u32>, l: Option<u32> },
    /// VR(i, j, l).
    RadialVelocity { i: u32, j: Option<u32>, l: Option<u32> },
    /// WX WY WZ WM (i, j, k).
    AngularVelocity { component: Component, i: u32, j: Option<u32>, k: Option<u32> },
    /// ACCX ACCY ACCZ ACCM (i, j, k, l).
    Acceleration { component: Component, i: u32, j: Option<u32>, k: Option<u32>, l: Option<u32> },
    /// WDTX WDTY WDTZ WDTM (i, j, k, l).
    AngularAcceleration { component: Component, i: u32, j: Option<u32>, k: Option<u32>, l: Option<u32> },
    /// BEAM, SFORCE, JOINT, MOTION, ... (id, jflag, comp, rm): component 1..8 of the load at the I
    /// (`j_flag` false) or J marker, in the axes of `rm`.
    Load { element: u32, j_flag: bool, component: u8, rm: Option<u32> },
    /// FX FY FZ FM TX TY TZ TM (i, j, k): sum of the loads at marker i from elements between i and j.
    MarkerLoad { torque: bool, component: Component, i: u32, j: Option<u32>, k: Option<u32> },
}

/// Turns names in a function into numbers. Errors are sentences: "no marker named `x`".
pub trait Resolver {
    /// Number of a marker given by name or id.
    fn marker(&mut self, name: &str) -> Result<u32, String>;
    /// Number of an element that a load function (`BEAM`, `JOINT`, ...) names.
    fn element(&mut self, function: &str, name: &str) -> Result<u32, String>;
    /// Value of a name that stands where a number is wanted: a design variable. None by default.
    fn number(&mut self, name: &str) -> Result<f64, String> {
        Err(format!("`{name}` is not a number, a constant or a function"))
    }
}
