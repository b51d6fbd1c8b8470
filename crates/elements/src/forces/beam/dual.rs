//! Numbers that carry their derivatives along, for formulas whose derivative by hand is longer and
//! easier to get wrong than the formula.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the formulas of a beam need of a number. `f64` gives values, [`Dual`] gives derivatives.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Mul<f64, Output = Self>
    + Add<f64, Output = Self>
{
    fn constant(value: f64) -> Self;
    /// The number without its derivatives.
    fn value(self) -> f64;
    fn sqrt(self) -> Self;
    fn tan(self) -> Self;
    /// Angle of the point `(x, self)`.
    fn atan2(self, x: Self) -> Self;
}

impl Scalar for f64 {
    fn constant(value: f64) -> f64 {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn sqrt(self) -> f64 {
        self.sqrt()
    }
    fn tan(self) -> f64 {
        self.tan()
    }
    fn atan2(self, x: f64) -> f64 {
        self.atan2(x)
    }
}

/// A number with its derivatives by six variables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    pub value: f64,
    pub by: [f64; 6],
}

impl Dual {
    /// `f(self)` for a function with this value and slope here.
    fn chain(self, value: f64, slope: f64) -> Dual {
        Dual { value, by: self.by.map(|d| d * slope) }
    }

    /// `f(self, other)` for a function with these slopes here.
    fn join(self, other: Dual, value: f64, slope: f64, slope_other: f64) -> Dual {
        Dual { value, by: std::array::from_fn(|k| self.by[k] * slope + other.by[k] * slope_other) }
    }
}

impl Add for Dual {
    type Output = Dual;
    fn add(self, other: Dual) -> Dual {
        self.join(other, self.value + other.value, 1.0, 1.0)
    }
}

impl Sub for Dual {
    type Output = Dual;
    fn sub(self, other: Dual) -> Dual {
        self.join(other, self.value - other.value, 1.0, -1.0)
    }
}

impl Mul for Dual {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        self.join(other, self.value * other.value, other.value, self.value)
    }
}

impl Div for Dual {
    type Output = Dual;
    fn div(self, other: Dual) -> Dual {
        let value = self.value / other.value;
        self.join(other, value, 1.0 / other.value, -value / other.value)
    }
}

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        self.chain(-self.value, -1.0)
    }
}

impl Mul<f64> for Dual {
    type Output = Dual;
    fn mul(self, factor: f64) -> Dual {
        self.chain(self.value * factor, factor)
    }
}

impl Add<f64> for Dual {
    type Output = Dual;
    fn add(self, constant: f64) -> Dual {
        Dual { value: self.value + constant, ..self }
    }
}

impl Scalar for Dual {
    fn constant(value: f64) -> Dual {
        Dual { value, by: [0.0; 6] }
    }
    fn value(self) -> f64 {
        self.value
    }
    fn sqrt(self) -> Dual {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    fn tan(self) -> Dual {
        let tan = self.value.tan();
        self.chain(tan, 1.0 + tan * tan)
    }
    fn atan2(self, x: Dual) -> Dual {
        let square = self.value * self.value + x.value * x.value;
        self.join(x, self.value.atan2(x.value), x.value / square, -self.value / square)
    }
}
