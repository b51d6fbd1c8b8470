//! A compiled function and its evaluation: value, gradient (reverse mode), time jet (forward mode).

use smallvec::SmallVec;

use crate::{
    Measure, rules,
    tape::{Node, Op, Tape},
};

/// Operations up to this number are evaluated on the stack; longer functions use the heap.
const ON_STACK: usize = 128;

/// The value of `MODE` in a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Mode {
    Kinematics = 1,
    InitialConditions = 3,
    #[default]
    Dynamics = 4,
    Statics = 5,
    QuasiStatics = 6,
    Linear = 7,
}

/// A run-time function ready for evaluation. Arguments and value are in model units, angles in
/// radians. Where an argument is outside a function's domain the value is not a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    ops: Box<[Op]>,
    constants: Box<[f64]>,
    measures: Box<[Measure]>,
    mode: Mode,
}

impl Function {
    pub(crate) fn new(tape: &Tape, root: Node) -> Function {
        let tape = tape.pruned(root);
        Function {
            ops: tape.ops.into(),
            constants: tape.constants.into(),
            measures: tape.measures.into(),
            mode: Mode::default(),
        }
    }

    /// The function that is `x` everywhere.
    pub fn constant(x: f64) -> Function {
        let mut tape = Tape::default();
        let root = tape.constant(x);
        Function::new(&tape, root)
    }

    /// What the function asks of the state, without duplicates; the order of `measures` and
    /// `gradient` in the other methods.
    pub fn measures(&self) -> &[Measure] {
        &self.measures
    }

    /// Whether the value follows from time alone.
    pub fn is_function_of_time_only(&self) -> bool {
        self.measures.is_empty()
    }

    /// The value, if it is the same at all times.
    pub fn as_constant(&self) -> Option<f64> {
        match (&*self.ops, &*self.constants) {
            ([Op::Constant(_)], [x]) => Some(*x),
            _ => None,
        }
    }

    /// Whether the value depends on the kind of analysis.
    pub fn uses_mode(&self) -> bool {
        self.ops.contains(&Op::Mode)
    }

    /// Sets what `MODE` stands for; dynamics unless set.
    pub fn set_mode(&mut self, mode: Mode) {
        self.mode = mode;
    }

    /// The value at time `t` with the values of [`Function::measures`].
    pub fn value(&self, t: f64, measures: &[f64]) -> f64 {
        let mut values: SmallVec<[f64; ON_STACK]> = SmallVec::with_capacity(self.ops.len());
        self.run(t, measures, &mut values);
        values.last().copied().unwrap_or(f64::NAN)
    }

    /// The value and its derivative with respect to `t`, measures held; `gradient` receives the
    /// derivative with respect to each measure.
    pub fn value_and_gradient(&self, t: f64, measures: &[f64], gradient: &mut [f64]) -> (f64, f64) {
        let mut values: SmallVec<[f64; ON_STACK]> = SmallVec::with_capacity(self.ops.len());
        self.run(t, measures, &mut values);
        gradient.fill(0.0);
        let mut slopes: SmallVec<[f64; ON_STACK]> = SmallVec::from_elem(0.0, values.len());
        if let Some(last) = slopes.last_mut() {
            *last = 1.0;
        }
        let mut by_time = 0.0;
        for (index, op) in self.ops.iter().enumerate().rev() {
            let slope = slopes[index];
            // Also what keeps a branch that is not taken, however singular, out of the result.
            if slope == 0.0 {
                continue;
            }
            match *op {
                Op::Constant(_) | Op::Mode => {}
                Op::Time => by_time = slope,
                Op::Measure(m) => {
                    if let Some(g) = gradient.get_mut(m as usize) {
                        *g = slope;
                    }
                }
                Op::Unary(kind, a) => {
                    let a = a.0 as usize;
                    slopes[a] += slope * rules::unary_slope(kind, values[a], values[index]);
                }
                Op::Binary(kind, a, b) => {
                    let (a, b) = (a.0 as usize, b.0 as usize);
                    let (by_a, by_b) = rules::binary_slopes(kind, values[a], values[b], values[index]);
                    slopes[a] += slope * by_a;
                    slopes[b] += slope * by_b;
                }
                Op::If { test, negative, zero, positive } => {
                    let branch = branch(values[test.0 as usize], negative, zero, positive);
                    slopes[branch.0 as usize] += slope;
                }
            }
        }
        (values.last().copied().unwrap_or(f64::NAN), by_time)
    }

    /// Value, first and second time derivative along a motion on which each measure has the value,
    /// first and second derivative given.
    pub fn jet(&self, t: f64, measure_jets: &[[f64; 3]]) -> [f64; 3] {
        let mut jets: SmallVec<[[f64; 3]; ON_STACK]> = SmallVec::with_capacity(self.ops.len());
        for op in &self.ops {
            let jet = match *op {
                Op::Constant(c) => [self.constants[c as usize], 0.0, 0.0],
                Op::Time => [t, 1.0, 0.0],
                Op::Mode => [self.mode_number(), 0.0, 0.0],
                Op::Measure(m) => measure_jets.get(m as usize).copied().unwrap_or([f64::NAN; 3]),
                Op::Unary(kind, a) => {
                    let [x, x1, x2] = jets[a.0 as usize];
                    let f = rules::unary(kind, x);
                    if x1 == 0.0 && x2 == 0.0 {
                        [f, 0.0, 0.0]
                    } else {
                        let slope = rules::unary_slope(kind, x, f);
                        [f, slope * x1, slope * x2 + rules::unary_curvature(kind, x, f) * x1 * x1]
                    }
                }
                Op::Binary(kind, a, b) => {
                    let ([x, x1, x2], [y, y1, y2]) = (jets[a.0 as usize], jets[b.0 as usize]);
                    let f = rules::binary(kind, x, y);
                    if [x1, x2, y1, y2] == [0.0; 4] {
                        [f, 0.0, 0.0]
                    } else {
                        let (fx, fy) = rules::binary_slopes(kind, x, y, f);
                        let (fxx, fxy, fyy) = rules::binary_curvatures(kind, x, y, f);
                        let second = fx * x2 + fy * y2 + fxx * x1 * x1 + 2.0 * fxy * x1 * y1 + fyy * y1 * y1;
                        [f, fx * x1 + fy * y1, second]
                    }
                }
                Op::If { test, negative, zero, positive } => {
                    let test = jets[test.0 as usize][0];
                    if test.is_nan() { [f64::NAN; 3] } else { jets[branch(test, negative, zero, positive).0 as usize] }
                }
            };
            jets.push(jet);
        }
        jets.last().copied().unwrap_or([f64::NAN; 3])
    }

    fn mode_number(&self) -> f64 {
        f64::from(self.mode as u8)
    }

    fn run(&self, t: f64, measures: &[f64], values: &mut SmallVec<[f64; ON_STACK]>) {
        for op in &self.ops {
            let value = match *op {
                Op::Constant(c) => self.constants[c as usize],
                Op::Time => t,
                Op::Mode => self.mode_number(),
                Op::Measure(m) => measures.get(m as usize).copied().unwrap_or(f64::NAN),
                Op::Unary(kind, a) => rules::unary(kind, values[a.0 as usize]),
                Op::Binary(kind, a, b) => rules::binary(kind, values[a.0 as usize], values[b.0 as usize]),
                Op::If { test, negative, zero, positive } => {
                    let test = values[test.0 as usize];
                    if test.is_nan() { test } else { values[branch(test, negative, zero, positive).0 as usize] }
                }
            };
            values.push(value);
        }
    }
}

fn branch(test: f64, negative: Node, zero: Node, positive: Node) -> Node {
    if test < 0.0 {
        negative
    } else if test > 0.0 {
        positive
    } else {
        zero
    }
}
