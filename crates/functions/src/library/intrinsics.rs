//! Elementary functions of one or two numbers. Angles in radians.

use super::Numeric;
use crate::tape::{Binary, Unary};

pub(super) const ALL: &[Numeric] = &[
    Numeric { name: "ABS", arguments: (1, 1), build: |t, a| t.unary(Unary::Abs, a[0]) },
    Numeric { name: "ACOS", arguments: (1, 1), build: |t, a| t.unary(Unary::Acos, a[0]) },
    Numeric { name: "AINT", arguments: (1, 1), build: |t, a| t.unary(Unary::Truncate, a[0]) },
    Numeric { name: "ANINT", arguments: (1, 1), build: |t, a| t.unary(Unary::Round, a[0]) },
    Numeric { name: "ASIN", arguments: (1, 1), build: |t, a| t.unary(Unary::Asin, a[0]) },
    Numeric { name: "ATAN", arguments: (1, 1), build: |t, a| t.unary(Unary::Atan, a[0]) },
    Numeric { name: "ATAN2", arguments: (2, 2), build: |t, a| t.binary(Binary::Atan2, a[0], a[1]) },
    Numeric { name: "COS", arguments: (1, 1), build: |t, a| t.unary(Unary::Cos, a[0]) },
    Numeric { name: "COSH", arguments: (1, 1), build: |t, a| t.unary(Unary::Cosh, a[0]) },
    Numeric { name: "EXP", arguments: (1, 1), build: |t, a| t.unary(Unary::Exp, a[0]) },
    Numeric { name: "LOG", arguments: (1, 1), build: |t, a| t.unary(Unary::Log, a[0]) },
    Numeric { name: "LOG10", arguments: (1, 1), build: |t, a| t.unary(Unary::Log10, a[0]) },
    Numeric { name: "SIN", arguments: (1, 1), build: |t, a| t.unary(Unary::Sin, a[0]) },
    Numeric { name: "SINH", arguments: (1, 1), build: |t, a| t.unary(Unary::Sinh, a[0]) },
    Numeric { name: "SQRT", arguments: (1, 1), build: |t, a| t.unary(Unary::Sqrt, a[0]) },
    Numeric { name: "TAN", arguments: (1, 1), build: |t, a| t.unary(Unary::Tan, a[0]) },
    Numeric { name: "TANH", arguments: (1, 1), build: |t, a| t.unary(Unary::Tanh, a[0]) },
];
