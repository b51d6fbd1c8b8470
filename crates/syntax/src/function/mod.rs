//! The grammar of run-time functions: `STEP(TIME, 0, 0D, 1, 90D) * VX(.m.p.a, .m.p.b)`.

mod calls;
mod parser;
mod tree;

pub use calls::Calls;
pub use parser::parse;
pub use tree::{FunctionExpression, FunctionKind, FunctionOperator};
