//! A resolver with numbered markers and short ways to compile.
#![allow(dead_code)] // each test file uses its own part

use flexure_functions::{Function, Resolver, compile};
use syntax::function::FunctionExpression;
use text::{Diagnostic, FileId};

/// Markers are called by their number or by `m<number>`; element `e` exists; `dv` is 2.5.
pub struct Bench;

impl Resolver for Bench {
    fn marker(&mut self, name: &str) -> Result<u32, String> {
        name.trim_start_matches('m').parse().map_err(|_| format!("no marker named `{name}`"))
    }
    fn element(&mut self, function: &str, name: &str) -> Result<u32, String> {
        if name == "e" { Ok(7) } else { Err(format!("no element for {function} named `{name}`")) }
    }
    fn number(&mut self, name: &str) -> Result<f64, String> {
        if name == "dv" { Ok(2.5) } else { Err(format!("`{name}` is nothing")) }
    }
}

pub fn function(text: &str) -> Function {
    compile(&parse(text), &mut Bench).unwrap_or_else(|e| panic!("{text}: {e:#?}"))
}

pub fn errors(text: &str) -> Vec<Diagnostic> {
    compile(&parse(text), &mut Bench).expect_err(text)
}

/// Value of a function of constants or of time 0.
pub fn number(text: &str) -> f64 {
    function(text).value(0.0, &[])
}

pub fn parse(text: &str) -> FunctionExpression {
    let (tree, diagnostics) = syntax::function::parse(FileId(0), text, 0);
    assert_eq!(diagnostics, [], "{text}");
    tree
}
