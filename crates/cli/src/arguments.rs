//! What can be said on the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

/// Opens, checks, edits, simulates and plots MSC Adams models, without Adams.
#[derive(Debug, Parser)]
#[command(name = "flexure", version, about, propagate_version = true, arg_required_else_help = true)]
#[command(
    after_help = "Exit status: 0 fine, 1 findings or a failed run, 2 wrong usage, 3 internal error, 130 interrupted."
)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

// The options of a subcommand are put together when it is called: a process calls one of many.
#[derive(Debug, Subcommand)]
#[command(defer = true)]
pub enum Command {
    /// Execute command files; the commands in them decide what is simulated.
    Run(Run),
    /// Simulate a model over time and write the results.
    Simulate(Simulate),
    /// Linear modes about the initial or the equilibrium state.
    Modes(Modes),
    /// What goes through every beam: forces and moments along it, energy, power; with diagrams.
    Beams(BeamLoads),
    /// Read and bind command files without simulating.
    Check(Check),
    /// Degrees of freedom, redundant constraints, and the traps of beams.
    Verify(Verify),
    /// Write a model in another format: .cmd, .adm or .fx to another of them.
    Convert(Convert),
    /// Draw series of a results file, or a model, as SVG or PNG.
    Plot(Plot),
    /// Area, moments, torsion constant and shear factors of a cross section, with a drawing.
    Section(Section),
    /// Compare two models, or two results files.
    Diff(Diff),
    /// The command window: Tab completes, `?` lists what may follow, every command can be undone.
    Shell(Shell),
    /// Lay out command files and macros as Adams View writes its own.
    Fmt(Fmt),
    /// List what is run, what is kept but not simulated, and what is not supported; or explain a command.
    Support(Support),
}

// What is said of a group of options in `///` would stand in the help in place of what the subcommand does.

// Options that change a model after it is read.
#[derive(Debug, Args)]
pub struct Edits {
    /// Command to execute after the model is read; can be repeated.
    #[arg(short = 'e', long = "execute", value_name = "COMMAND")]
    pub commands: Vec<String>,
}

/// How angles of LINEAR and STRING beams are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Angles {
    /// Each about its own axis of J, like the functions AX, AY and AZ.
    Projected,
    /// Components of the rotation vector.
    Rotvec,
}

// Options for what the public description of beams leaves open.
#[derive(Debug, Args)]
pub struct Beams {
    /// How LINEAR and STRING beams measure the rotation of I from J.
    #[arg(long, value_enum, default_value = "projected", value_name = "HOW")]
    pub beam_angles: Angles,
    /// Let NONLINEAR beams shear by their shear ratios.
    #[arg(long)]
    pub nonlinear_shear: bool,
}

// What runs record beside requests and measures.
#[derive(Clone, Copy, Debug, Args)]
pub struct Recording {
    /// Record everything: parts, joints, motions and forces too.
    #[arg(long)]
    pub all: bool,
    /// Record what goes through every beam, its energy and the power it takes.
    #[arg(long)]
    pub beam_loads: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum OnError {
    /// Stop the file at the first error.
    Abort,
    /// Drop the command and go on with the next.
    Ignore,
}

#[derive(Debug, Args)]
pub struct Run {
    /// Command files (.cmd, .mac) and models (.adm, .fx); `-` reads standard input.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    #[command(flatten)]
    pub edits: Edits,
    #[command(flatten)]
    pub beams: Beams,
    /// Folder for results.
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub out: PathBuf,
    /// What happens after an error.
    #[arg(long, value_enum, default_value = "ignore")]
    pub on_error: OnError,
    /// Stop at the first error and let warnings fail the run.
    #[arg(long)]
    pub strict: bool,
    /// Write a journal in the layout of aview.log.
    #[arg(long, value_name = "FILE")]
    pub journal: Option<PathBuf>,
    #[command(flatten)]
    pub record: Recording,
}

#[derive(Debug, Args)]
pub struct Simulate {
    /// Model (.cmd, .adm, .fx).
    pub model: PathBuf,
    #[command(flatten)]
    pub edits: Edits,
    #[command(flatten)]
    pub beams: Beams,
    /// Static equilibrium first; alone: only the equilibrium.
    #[arg(long = "static")]
    pub statics: bool,
    /// Kinematic analysis (no degrees of freedom).
    #[arg(long)]
    pub kinematic: bool,
    /// End time, seconds.
    #[arg(long, value_name = "T", required_unless_present = "statics", allow_negative_numbers = true)]
    pub end: Option<f64>,
    /// Number of output steps.
    #[arg(long, value_name = "N", conflicts_with = "dtout")]
    pub steps: Option<usize>,
    /// Time between outputs, seconds.
    #[arg(long, value_name = "H", allow_negative_numbers = true)]
    pub dtout: Option<f64>,
    /// Integrator by its Adams name (gstiff, si2, wstiff, hht, newmark, ...).
    #[arg(long, value_name = "NAME")]
    pub integrator: Option<String>,
    /// Local error tolerance.
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    pub error: Option<f64>,
    /// Largest step, seconds.
    #[arg(long, value_name = "H")]
    pub hmax: Option<f64>,
    /// Results: FILE.csv, FILE.parquet or a folder.
    #[arg(long, value_name = "PATH")]
    pub out: PathBuf,
    #[command(flatten)]
    pub record: Recording,
}

#[derive(Debug, Args)]
#[command(
    after_help = "Forces and moments act on the face that looks to I, along the axes of J (of the chord, for NONLINEAR \
                  beams): tension is positive, dMy/dx = Vz, dMz/dx = -Vy."
)]
pub struct BeamLoads {
    /// Model (.cmd, .adm, .fx).
    pub model: PathBuf,
    #[command(flatten)]
    pub edits: Edits,
    #[command(flatten)]
    pub beams: Beams,
    /// In the static equilibrium; with --at, from there on.
    #[arg(long = "static", conflicts_with = "result")]
    pub statics: bool,
    /// After a dynamic simulation to this time, or at the output of --result nearest to it; seconds.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub at: Option<f64>,
    /// As a run of this model recorded it (.csv, .parquet); without --at, at the end.
    #[arg(long, value_name = "FILE")]
    pub result: Option<PathBuf>,
    /// Form of the report.
    #[arg(long, value_enum, default_value = "text")]
    pub format: DiffFormat,
    /// Print at most N beams; the total is that of all.
    #[arg(long, value_name = "N", default_value_t = 40)]
    pub most: usize,
    /// Draw N, V, T and M along the beams that follow one another: FILE.svg or FILE.png.
    #[arg(long, value_name = "FILE")]
    pub draw: Option<PathBuf>,
    /// Width and height of the drawing in pixels, as 1000x900.
    #[arg(long, default_value = "1000x900")]
    pub size: String,
}

#[derive(Debug, Args)]
pub struct Modes {
    /// Model (.cmd, .adm, .fx).
    pub model: PathBuf,
    #[command(flatten)]
    pub edits: Edits,
    #[command(flatten)]
    pub beams: Beams,
    /// About the static equilibrium.
    #[arg(long = "static", conflicts_with = "spin")]
    pub statics: bool,
    /// About a steady spin of the whole model: rad/s, or with a unit as 57rpm or 340d (degrees per second).
    #[arg(long, value_name = "RATE", requires = "about", allow_negative_numbers = true)]
    pub spin: Option<SpinRate>,
    /// The marker whose z axis the model spins about.
    #[arg(long, value_name = "MARKER", requires = "spin")]
    pub about: Option<String>,
    /// Write eigenvalues and shapes to FILE.csv.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Print at most N modes.
    #[arg(long, value_name = "N", default_value_t = 40)]
    pub most: usize,
    /// Print JSON.
    #[arg(long)]
    pub json: bool,
}

/// A rate of rotation, rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinRate(pub f64);

impl std::str::FromStr for SpinRate {
    type Err = String;

    fn from_str(text: &str) -> Result<SpinRate, String> {
        let units = [("rpm", std::f64::consts::TAU / 60.0), ("d", 1f64.to_radians()), ("", 1.0)];
        let split = units.iter().find_map(|(unit, factor)| Some((text.strip_suffix(unit)?, factor)));
        let rate = split.and_then(|(number, factor)| Some(number.trim().parse::<f64>().ok()? * factor));
        rate.filter(|r| r.is_finite()).map(SpinRate).ok_or_else(|| "a number of rad/s, or 57rpm, or 340d".to_string())
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ReportFormat {
    Text,
    Json,
    Github,
    Sarif,
    Junit,
}

#[derive(Debug, Args)]
pub struct Check {
    /// Command files (.cmd, .mac) and models (.adm, .fx); `-` reads standard input.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// Form of the report.
    #[arg(long, value_enum, default_value = "text")]
    pub format: ReportFormat,
    /// Mend in the files (.cmd, .mac, .adm) what is certain to be mended so; standard input is written to
    /// standard output.
    #[arg(long)]
    pub fix: bool,
    /// With --fix: show what would change, and write nothing.
    #[arg(long, requires = "fix")]
    pub diff: bool,
}

#[derive(Debug, Args)]
pub struct Fmt {
    /// Command files and macros (.cmd, .mac); `-` reads standard input and writes standard output.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// List the files that would change, and write nothing; exit status 1 if there are any.
    #[arg(long)]
    pub check: bool,
    /// Show what would change, and write nothing; exit status 1 if anything would.
    #[arg(long)]
    pub diff: bool,
}

#[derive(Debug, Args)]
pub struct Verify {
    /// Model (.cmd, .adm, .fx).
    pub model: PathBuf,
    #[command(flatten)]
    pub edits: Edits,
    #[command(flatten)]
    pub beams: Beams,
    /// Print JSON.
    #[arg(long)]
    pub json: bool,
    /// Mend what is certain and write the model beside the original, as NAME_fixed.cmd or to --out.
    #[arg(long)]
    pub fix: bool,
    /// Where --fix writes the mended model.
    #[arg(long, value_name = "FILE", requires = "fix")]
    pub out: Option<PathBuf>,
    /// With --fix: mend only findings of this code, as beam/length; can be repeated.
    #[arg(long, value_name = "CODE", requires = "fix")]
    pub only: Vec<String>,
}

#[derive(Debug, Args)]
pub struct Convert {
    /// Model (.cmd, .adm, .fx).
    pub input: PathBuf,
    /// .cmd, .adm or .fx.
    pub output: PathBuf,
    #[command(flatten)]
    pub edits: Edits,
}

#[derive(Debug, Args)]
pub struct Plot {
    /// Results (.csv, .parquet) or a model (.cmd, .adm, .fx).
    pub input: PathBuf,
    /// Picture: FILE.svg or FILE.png.
    #[arg(short, long, value_name = "FILE")]
    pub out: PathBuf,
    /// Series to draw; `NAME*` takes all that begin so. Without: the first ones.
    #[arg(short, long, value_name = "NAME")]
    pub series: Vec<String>,
    /// Title; without: the file's name.
    #[arg(long)]
    pub title: Option<String>,
    /// Width and height in pixels, as 1000x600.
    #[arg(long, default_value = "1000x600")]
    pub size: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ShearTheory {
    /// Energy of Jourawski's shear stress: 6/5 for a rectangle, 10/9 for a circle.
    Energy,
    /// Cowper 1966, with Poisson's ratio.
    Cowper,
    /// No shear deflection.
    None,
}

#[derive(Debug, Args)]
#[command(after_help = "Widths are along y of the beam, heights along z. Sizes and answers are in one unit of length.")]
pub struct Section {
    /// Shape.
    #[arg(value_parser = ["rectangle", "circle", "tube", "box", "i", "ellipse"])]
    pub kind: String,
    /// Size along y.
    #[arg(long, value_name = "W", allow_negative_numbers = true)]
    pub width: Option<f64>,
    /// Size along z.
    #[arg(long, value_name = "H", allow_negative_numbers = true)]
    pub height: Option<f64>,
    /// Outer diameter of a circle or tube.
    #[arg(long, value_name = "D", allow_negative_numbers = true)]
    pub diameter: Option<f64>,
    /// Wall of a tube or box.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub thickness: Option<f64>,
    /// Web of an I.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub web_thickness: Option<f64>,
    /// Flanges of an I; of a box, if other than the wall.
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub flange_thickness: Option<f64>,
    /// Poisson's ratio, for the shear factors of Cowper.
    #[arg(long, value_name = "NU", default_value_t = 0.3, allow_negative_numbers = true)]
    pub nu: f64,
    /// Where shear factors come from.
    #[arg(long, value_enum, default_value = "energy")]
    pub theory: ShearTheory,
    /// Unit of length of the sizes, as it is printed.
    #[arg(long, value_name = "UNIT", default_value = "mm")]
    pub units: String,
    /// Form of the report.
    #[arg(long, value_enum, default_value = "text")]
    pub format: DiffFormat,
    /// Draw the section with its sizes: FILE.svg or FILE.png.
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DiffFormat {
    Text,
    Json,
}

#[derive(Debug, Args)]
pub struct Support {
    /// Words of a command, as `force modify element_like beam`: what it does and takes.
    pub words: Vec<String>,
    /// Form of the report.
    #[arg(long, value_enum, default_value = "text")]
    pub format: DiffFormat,
}

#[derive(Debug, Args)]
pub struct Diff {
    /// Model (.cmd, .adm, .fx) or results (.csv, .parquet).
    pub a: PathBuf,
    pub b: PathBuf,
    /// Largest difference, relative to the largest value of a series, that still counts as equal;
    /// of models, relative to the value.
    #[arg(long, default_value_t = 0.0)]
    pub tolerance: f64,
    /// Form of the report.
    #[arg(long, value_enum, default_value = "text")]
    pub format: DiffFormat,
}

#[derive(Debug, Args)]
pub struct Shell {
    /// Model (.cmd, .adm, .fx); a .fx file is saved with every command and made if it is missing.
    pub model: Option<PathBuf>,
    /// Save every command in FILE.fx from now on.
    #[arg(long, value_name = "FILE.fx")]
    pub save: Option<PathBuf>,
    /// Let --save replace a file that exists.
    #[arg(long, requires = "save")]
    pub overwrite: bool,
    /// Look into a .fx file, also while another session holds it; nothing is saved.
    #[arg(long, requires = "model")]
    pub read_only: bool,
    /// Write a journal in the layout of aview.log.
    #[arg(long, value_name = "FILE")]
    pub journal: Option<PathBuf>,
    /// Folder for results.
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub out: PathBuf,
    #[command(flatten)]
    pub record: Recording,
}
