//! From the tree of a function to its tape: names are resolved, arguments counted and checked.

use syntax::function::{FunctionExpression, FunctionKind, FunctionOperator};
use text::{Diagnostic, Span};

use crate::{
    Function, Measure, Resolver,
    library::{self, Entry, Markers, Numeric, OfMarkers},
    tape::{Binary, Node, Tape},
};

/// Nesting deeper than this is refused rather than risking the stack.
const DEEPEST: usize = 256;

/// Compiles a function. All troubles are reported, not only the first.
pub fn compile(expression: &FunctionExpression, resolver: &mut dyn Resolver) -> Result<Function, Vec<Diagnostic>> {
    let mut compiler = Compiler { tape: Tape::default(), resolver, diagnostics: Vec::new() };
    let root = compiler.node(expression, 0);
    match root {
        Some(root) if compiler.diagnostics.is_empty() => Ok(Function::new(&compiler.tape, root)),
        _ => Err(compiler.diagnostics),
    }
}

/// The trouble is in the list of diagnostics.
struct Reported;

struct Compiler<'a> {
    tape: Tape,
    resolver: &'a mut dyn Resolver,
    diagnostics: Vec<Diagnostic>,
}

impl Compiler<'_> {
    fn report(&mut self, code: &'static str, message: String, span: Span, label: &str) {
        self.diagnostics.push(Diagnostic::error(code, message).at(span, label));
    }

    /// The node of an expression; `None` after a report.
    fn node(&mut self, e: &FunctionExpression, depth: usize) -> Option<Node> {
        if depth > DEEPEST {
            let message = format!("the function is nested deeper than {DEEPEST} levels");
            self.report("function/too-deep", message, e.span, "too deep");
            return None;
        }
        match &e.kind {
            FunctionKind::Number(x) => Some(self.tape.constant(*x)),
            FunctionKind::Name(name) => self.name(name, e.span),
            FunctionKind::Call { function, function_span, arguments } => {
                self.call(function, *function_span, arguments, e.span, depth)
            }
            FunctionKind::Negate(inner) => {
                let inner = self.node(inner, depth + 1)?;
                Some(self.tape.negate(inner))
            }
            FunctionKind::Binary(..) => self.chain(e, depth),
            FunctionKind::Broken => {
                let message = "a part of the function cannot be read".to_string();
                self.report("function/incomplete", message, e.span, "something is missing here");
                None
            }
        }
    }

    /// Sums and products of many terms lean to the left; their spine is walked in a loop.
    fn chain(&mut self, e: &FunctionExpression, depth: usize) -> Option<Node> {
        let mut spine = Vec::new();
        let mut left = e;
        while let FunctionKind::Binary(operator, a, b) = &left.kind {
            spine.push((*operator, &**b, left.span));
            left = a;
        }
        let mut node = self.node(left, depth + 1);
        for (operator, right, span) in spine.into_iter().rev() {
            let right = self.node(right, depth + 1);
            node = match (node, right) {
                (Some(a), Some(b)) => {
                    let operator = match operator {
                        FunctionOperator::Add => Binary::Add,
                        FunctionOperator::Subtract => Binary::Subtract,
                        FunctionOperator::Multiply => Binary::Multiply,
                        FunctionOperator::Divide => Binary::Divide,
                        FunctionOperator::Power => Binary::Power,
                    };
                    let result = self.tape.binary(operator, a, b);
                    self.checked(&[a, b], result, span)
                }
                _ => None,
            };
        }
        node
    }

    /// A constant that is no finite number although its operands are: division by 0, SQRT(-1).
    fn checked(&mut self, operands: &[Node], result: Node, span: Span) -> Option<Node> {
        let finite = |tape: &Tape, n: Node| tape.known_value(n).is_none_or(f64::is_finite);
        if !finite(&self.tape, result) && operands.iter().all(|&n| finite(&self.tape, n)) {
            let what = self.tape.known_value(result).unwrap_or(f64::NAN);
            let what = if what.is_nan() { "not a number" } else { "infinite" };
            self.report("function/not-finite", format!("a part of the function is {what}"), span, what);
            return None;
        }
        Some(result)
    }

    fn name(&mut self, name: &str, span: Span) -> Option<Node> {
        let constant = match name.to_ascii_uppercase().as_str() {
            "TIME" => return Some(self.tape.time()),
            "MODE" => return Some(self.tape.mode()),
            "PI" => Some(std::f64::consts::PI),
            "DTOR" => Some(std::f64::consts::PI / 180.0),
            "RTOD" => Some(180.0 / std::f64::consts::PI),
            upper => {
                if let Some(why) = library::why_not_supported(upper) {
                    self.not_supported(name, why, span);
                    return None;
                }
                None
            }
        };
        match constant.map_or_else(|| self.resolver.number(name), Ok) {
            Ok(x) => Some(self.tape.constant(x)),
            Err(reason) => {
                self.report("function/unknown-name", reason, span, "not a number, a constant or a function");
                None
            }
        }
    }

    fn not_supported(&mut self, name: &str, why: &str, span: Span) {
        let name = name.to_ascii_uppercase();
        let message = format!("the function `{name}` is not supported yet");
        let diagnostic = Diagnostic::error("function/not-supported", message).at(span, "not supported yet").note(why);
        self.diagnostics.push(diagnostic);
    }

    fn call(
        &mut self,
        function: &str,
        function_span: Span,
        arguments: &[FunctionExpression],
        span: Span,
        depth: usize,
    ) -> Option<Node> {
        match library::find(function) {
            Some(Entry::Numeric(numeric)) => self.numeric(numeric, function_span, arguments, span, depth),
            Some(Entry::OfMarkers(f)) => self.of_markers(f, function_span, arguments),
            Some(Entry::Load) => self.load(function, function_span, arguments, depth),
            None => {
                if let Some(why) = library::why_not_supported(function) {
                    self.not_supported(function, why, function_span);
                } else {
                    self.unknown_function(function, function_span);
                }
                None
            }
        }
    }

    fn unknown_function(&mut self, function: &str, span: Span) {
        let message = format!("there is no function `{function}`");
        let mut diagnostic = Diagnostic::error("function/unknown-function", message).at(span, "not a function");
        if let Some(name) = text::suggest(&function.to_ascii_uppercase(), library::names()) {
            diagnostic = diagnostic.help(format!("did you mean `{name}`?"));
        }
        self.diagnostics.push(diagnostic);
    }

    fn count(&mut self, name: &str, span: Span, given: usize, (least, most): (usize, usize)) -> Option<()> {
        if (least..=most).contains(&given) {
            return Some(());
        }
        let wanted = if least == most { least.to_string() } else { format!("{least} to {most}") };
        let s = if most == 1 { "" } else { "s" };
        let message = format!("`{name}` takes {wanted} argument{s}, but {given} are given");
        self.report("function/wrong-argument-count", message, span, "wrong number of arguments");
        None
    }

    fn numeric(
        &mut self,
        f: &Numeric,
        function_span: Span,
        arguments: &[FunctionExpression],
        span: Span,
        depth: usize,
    ) -> Option<Node> {
        self.count(f.name, function_span, arguments.len(), f.arguments)?;
        let nodes: Vec<_> = arguments.iter().map(|a| self.node(a, depth + 1)).collect();
        let nodes: Vec<_> = nodes.into_iter().collect::<Option<_>>()?;
        let result = (f.build)(&mut self.tape, &nodes);
        self.checked(&nodes, result, span)
    }

    fn of_markers(&mut self, f: &OfMarkers, function_span: Span, arguments: &[FunctionExpression]) -> Option<Node> {
        self.count(f.name, function_span, arguments.len(), f.arguments)?;
        let mut markers = [None; 4];
        let mut sound = true;
        for (index, (argument, marker)) in arguments.iter().zip(&mut markers).enumerate() {
            match self.marker(f.name, argument) {
                Ok(None) if index < f.arguments.0 => {
                    let message = format!("argument {} of `{}` must be a marker, not 0", index + 1, f.name);
                    self.report("function/wrong-argument", message, argument.span, "a marker is needed here");
                    sound = false;
                }
                Ok(found) => *marker = found,
                Err(Reported) => sound = false,
            }
        }
        let [first, rest @ ..] = markers;
        let first = first.filter(|_| sound)?;
        Some(self.tape.measure((f.measure)(&Markers { first, rest })))
    }

    /// A marker argument: a name or an id; 0 is the global frame.
    fn marker(&mut self, function: &str, argument: &FunctionExpression) -> Result<Option<u32>, Reported> {
        let name = self.object_name(function, "a marker", argument).ok_or(Reported)?;
        if name == "0" {
            return Ok(None);
        }
        self.resolver.marker(&name).map(Some).map_err(|reason| {
            self.report("function/unknown-object", reason, argument.span, "not a marker");
            Reported
        })
    }

    /// The name or id that stands as an argument.
    fn object_name(&mut self, function: &str, what: &str, argument: &FunctionExpression) -> Option<String> {
        match &argument.kind {
            FunctionKind::Name(name) => Some(name.clone()),
            FunctionKind::Number(x) if *x >= 0.0 && x.fract() == 0.0 && *x <= f64::from(i32::MAX) => {
                Some(format!("{x:.0}"))
            }
            FunctionKind::Broken => self.node(argument, 0).map(|_| String::new()),
            _ => {
                let message = format!("`{function}` needs the name or id of {what} here");
                self.report("function/wrong-argument", message, argument.span, "an expression");
                None
            }
        }
    }

    /// `BEAM(id, jflag, component, rm)`.
    fn load(
        &mut self,
        function: &str,
        function_span: Span,
        arguments: &[FunctionExpression],
        depth: usize,
    ) -> Option<Node> {
        let function = function.to_ascii_uppercase();
        self.count(&function, function_span, arguments.len(), (3, 4))?;
        let element = self.object_name(&function, "an element", &arguments[0]).and_then(|name| {
            self.resolver
                .element(&function, &name)
                .map_err(|reason| {
                    self.report("function/unknown-object", reason, arguments[0].span, "not such an element");
                })
                .ok()
        });
        let j_flag = self.whole(&arguments[1], depth, 0, 1, "0 for the I marker or 1 for the J marker");
        let words = "1 (force), 2 to 4 (its x, y, z), 5 (torque) or 6 to 8 (its x, y, z)";
        let component = self.whole(&arguments[2], depth, 1, 8, words);
        let rm = match arguments.get(3) {
            Some(argument) => self.marker(&function, argument).ok()?,
            None => None,
        };
        let measure = Measure::Load { element: element?, j_flag: j_flag? == 1, component: component?, rm };
        Some(self.tape.measure(measure))
    }

    /// A constant whole number between bounds.
    fn whole(&mut self, argument: &FunctionExpression, depth: usize, least: u8, most: u8, words: &str) -> Option<u8> {
        let node = self.node(argument, depth + 1)?;
        let value = self.tape.known_value(node);
        let whole = value.filter(|x| x.fract() == 0.0 && (f64::from(least)..=f64::from(most)).contains(x));
        if whole.is_none() {
            let message = format!("this argument must be {words}");
            self.report("function/wrong-argument", message, argument.span, "out of range");
        }
        whole.map(|x| x as u8)
    }
}
