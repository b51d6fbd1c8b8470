//! The format of `truth.toml`: cases, each a table of inputs and expected values.

use std::collections::BTreeMap;

use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Truth {
    /// Command files that are read before each row, in order, relative to the folder.
    pub models: Vec<String>,
    pub case: Vec<Case>,
}

/// One table. Each row is a run of its own.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    pub name: String,
    /// Executed after the models; `{column}` stands for the row's number.
    pub commands: Vec<String>,
    /// Names of the numbers of a row. Those that `find` knows are expected, the others are inputs.
    pub columns: Vec<String>,
    /// `nan` is not compared.
    pub rows: Vec<Vec<f64>>,
    /// `truth`: closed form or published; `twin`: an independent computation.
    pub kind: String,
    pub source: String,
    pub tolerance: Tolerance,
    /// How to find the expected columns.
    pub find: BTreeMap<String, Find>,
    /// Modes about a state instead of series of a run.
    pub modes: Option<About>,
    /// Numbers of beams, given as `{n}`, from which values are extrapolated to infinitely many: the
    /// error is a polynomial in 1/n^2.
    #[serde(default)]
    pub extrapolate: Vec<f64>,
    #[serde(default)]
    pub rotation_vector: bool,
    #[serde(default)]
    pub nonlinear_shear: bool,
    /// There is no solution, and the program says so.
    #[serde(default)]
    pub fails: bool,
    /// Why these are our values and not the source's, and by how much they are off.
    pub differs: Option<String>,
}

#[derive(Deserialize, Clone)]
#[serde(deny_unknown_fields)]
pub struct Tolerance {
    #[serde(default)]
    pub abs: f64,
    #[serde(default)]
    pub rel: f64,
    pub because: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct About {
    /// `present`, `equilibrium` or `spin`.
    pub state: String,
    #[serde(default)]
    pub marker: String,
    /// rad/s; `{column}` stands for the row's number.
    #[serde(default)]
    pub rate: String,
}

/// One number of the results: `offset + factor * what`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Find {
    /// A series of the last run.
    pub series: Option<String>,
    /// Component of the rotation vector, rad, of a displacement request.
    pub rotation: Option<String>,
    /// Circular frequency of a mode, rad/s; the first is 1.
    pub mode: Option<usize>,
    /// Damping ratio of a mode; only those count that swing.
    pub damping: Option<usize>,
    /// The input of this name at which the lowest mode has frequency zero.
    pub critical: Option<String>,
    /// Where in the series: `end`, `least`, `largest`, `time of least`, `mean`, or a time in s.
    #[serde(default)]
    pub at: At,
    /// Mean, least and largest from this time on, s.
    #[serde(default)]
    pub from: f64,
    #[serde(default = "one")]
    pub factor: f64,
    #[serde(default)]
    pub offset: f64,
    /// Tolerance of this column, where the case's does not fit.
    pub abs: Option<f64>,
}

fn one() -> f64 {
    1.0
}

#[derive(Deserialize)]
#[serde(untagged)]
pub enum At {
    Time(f64),
    Word(String),
}

impl Default for At {
    fn default() -> At {
        At::Word("end".into())
    }
}
