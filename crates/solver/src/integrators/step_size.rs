//! The step that comes next.

/// Step-size control for an error of third order.
pub struct StepSize {
    pub min: f64,
    pub max: f64,
    /// The step wanted; the one taken may be shorter to meet an output.
    pub wanted: f64,
    fixed: bool,
    /// No growth right after a failure.
    cautious: bool,
}

impl StepSize {
    pub fn new(first: f64, min: f64, max: f64, fixed: bool) -> Self {
        Self { min, max, wanted: if fixed { max } else { first.min(max) }, fixed, cautious: false }
    }

    /// The next step towards `target`: equal steps, none longer than wanted.
    pub fn towards(&self, remaining: f64) -> f64 {
        let count = (remaining / self.wanted * (1.0 - 1e-9)).ceil().max(1.0);
        remaining / count
    }

    /// An accepted step of size `h` with an error of `theta` tolerances.
    pub fn accepted(&mut self, h: f64, theta: f64) {
        if self.fixed {
            return;
        }
        let ideal = 0.9 / theta.max(1e-9).cbrt();
        let mut next = if ideal > 1.2 {
            (h * ideal.min(2.0)).max(self.wanted.min(h * ideal))
        } else if ideal < 0.9 {
            h * ideal
        } else {
            self.wanted.min(h * ideal).max(h)
        };
        if self.cautious {
            next = next.min(h.max(self.wanted));
            self.cautious = false;
        }
        self.wanted = next.min(self.max);
    }

    /// A step whose error was too large. False when it cannot become smaller.
    pub fn rejected(&mut self, h: f64, theta: f64) -> bool {
        self.reduce(h, (0.9 / theta.cbrt()).clamp(0.3, 0.9))
    }

    /// A step on which the corrector failed.
    pub fn failed(&mut self, h: f64) -> bool {
        self.reduce(h, 0.25)
    }

    fn reduce(&mut self, h: f64, factor: f64) -> bool {
        self.cautious = true;
        self.wanted = h * factor;
        self.wanted >= self.min
    }
}
