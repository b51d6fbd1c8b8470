//! Integration in time.
//!
//! One method, the generalised-alpha method on the Lie group of the positions (Bruels, Cardona and
//! Arnold 2012), serves all requests; the HHT method of Hilber, Hughes and Taylor is a member.

mod alpha;
mod dense_output;
mod step_size;

pub use alpha::integrate;

/// Which member of the family.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// HHT with `alpha` in [-1/3, 0]; -0.3 is usual.
    Hht { alpha: f64 },
    /// Generalised-alpha with the spectral radius at infinite frequency in [0, 1].
    GeneralisedAlpha { rho: f64 },
    /// Newmark, with `gamma >= 1/2` and `beta >= (gamma + 1/2)^2 / 4`.
    Newmark { beta: f64, gamma: f64 },
}

impl Default for Method {
    fn default() -> Self {
        Self::Hht { alpha: -0.3 }
    }
}

/// Coefficients of the method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Coefficients {
    pub am: f64,
    pub af: f64,
    pub beta: f64,
    pub gamma: f64,
}

impl Method {
    pub(crate) fn coefficients(self) -> Result<Coefficients, &'static str> {
        let c = match self {
            Self::Hht { alpha } if (-1.0 / 3.0..=0.0).contains(&alpha) => {
                Coefficients { am: 0.0, af: -alpha, beta: (1.0 - alpha) * (1.0 - alpha) / 4.0, gamma: 0.5 - alpha }
            }
            Self::Hht { .. } => return Err("ALPHA of the HHT integrator lies between -1/3 and 0"),
            Self::GeneralisedAlpha { rho } if (0.0..=1.0).contains(&rho) => {
                let (am, af) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
                let gamma = 0.5 + af - am;
                Coefficients { am, af, beta: (gamma + 0.5) * (gamma + 0.5) / 4.0, gamma }
            }
            Self::GeneralisedAlpha { .. } => return Err("the spectral radius lies between 0 and 1"),
            Self::Newmark { beta, gamma }
                if gamma >= 0.5
                    && beta >= (gamma + 0.5) * (gamma + 0.5) / 4.0 - 1e-12
                    && gamma.is_finite()
                    && beta.is_finite() =>
            {
                Coefficients { am: 0.0, af: 0.0, beta, gamma }
            }
            Self::Newmark { .. } => {
                return Err("NEWMARK is stable for GAMMA of at least 1/2 and BETA of at least (GAMMA + 1/2)^2 / 4");
            }
        };
        Ok(c)
    }

    /// The method that serves an integrator asked for by its Adams name, and a sentence for the
    /// user where that is not the method named. `None` for a name that is no integrator.
    pub fn for_request(name: &str) -> Option<(Self, Option<String>)> {
        let upper = name.to_ascii_uppercase();
        match upper.as_str() {
            "HHT" => Some((Self::default(), None)),
            "NEWMARK" => Some((Self::Newmark { beta: 0.36, gamma: 0.7 }, None)),
            "GSTIFF" | "WSTIFF" | "CONSTANT_BDF" | "CBDF" | "HASTIFF" | "SI1" | "SI2" | "I3" | "ABAM" | "RKF45" => {
                Some((
                    Self::default(),
                    Some(format!("{upper} was asked for; the HHT method integrates instead, with the requested error")),
                ))
            }
            _ => None,
        }
    }
}

/// How to integrate. Times in s.
#[derive(Clone, Debug, PartialEq)]
pub struct IntegratorOptions {
    pub method: Method,
    /// Error allowed in each step, relative to [`crate::Dae::scales`].
    pub error: f64,
    /// First step; by default a twentieth of the largest.
    pub hinit: Option<f64>,
    /// Smallest step; by default 1e-7 of the largest.
    pub hmin: Option<f64>,
    /// Largest step; by default the distance of the outputs.
    pub hmax: Option<f64>,
    /// Largest number of iterations of the corrector.
    pub maxit: usize,
    /// Outputs by interpolation instead of steps that end at them.
    pub interpolate: bool,
    /// Steps of the largest size without error control.
    pub fixed: bool,
    /// What is left to iterate, in parts of the error, when the corrector stops.
    pub corrector: f64,
}

impl Default for IntegratorOptions {
    fn default() -> Self {
        Self {
            method: Method::default(),
            error: 1e-5,
            hinit: None,
            hmin: None,
            hmax: None,
            maxit: 10,
            interpolate: false,
            fixed: false,
            corrector: 0.01,
        }
    }
}

/// Times of `steps` equal outputs after `start`, the last exactly at `end`.
pub fn output_times(start: f64, end: f64, steps: usize) -> Vec<f64> {
    (1..=steps).map(|i| if i == steps { end } else { start + (end - start) * i as f64 / steps as f64 }).collect()
}
