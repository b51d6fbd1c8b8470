//! Physical dimensions, unit names and their factors to SI.
//!
//! Adams keeps force as a base dimension beside mass, length and time: `newton, kg, mm, second` is
//! a legal set, in which force * UCF = mass * acceleration (UCF = 1000 there). Dimensions therefore
//! have an exponent for force beside the usual ones. Factors are exact by definition where a definition exists (inch, pound,
//! kilogram-force).

/// Exponents of length, mass, time, force, angle and frequency. The unit of frequency is chosen
/// apart from that of time (Hz or radians per second), so frequency is no inverse time here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Dimension {
    pub length: i8,
    pub mass: i8,
    pub time: i8,
    pub force: i8,
    pub angle: i8,
    pub frequency: i8,
}

impl Dimension {
    pub const NONE: Dimension = Self::of(0, 0, 0, 0, 0);
    pub const LENGTH: Dimension = Self::of(1, 0, 0, 0, 0);
    pub const AREA: Dimension = Self::of(2, 0, 0, 0, 0);
    pub const VOLUME: Dimension = Self::of(3, 0, 0, 0, 0);
    pub const AREA_INERTIA: Dimension = Self::of(4, 0, 0, 0, 0);
    pub const MASS: Dimension = Self::of(0, 1, 0, 0, 0);
    pub const INERTIA: Dimension = Self::of(2, 1, 0, 0, 0);
    pub const DENSITY: Dimension = Self::of(-3, 1, 0, 0, 0);
    pub const TIME: Dimension = Self::of(0, 0, 1, 0, 0);
    pub const FREQUENCY: Dimension = Dimension { frequency: 1, ..Self::NONE };
    /// Per unit of time; as an angular velocity: radians per unit of time, whatever the angle unit.
    pub const PER_TIME: Dimension = Self::of(0, 0, -1, 0, 0);
    pub const FORCE: Dimension = Self::of(0, 0, 0, 1, 0);
    pub const TORQUE: Dimension = Self::of(1, 0, 0, 1, 0);
    pub const PRESSURE: Dimension = Self::of(-2, 0, 0, 1, 0);
    pub const ENERGY: Dimension = Self::of(1, 0, 0, 1, 0);
    pub const ANGLE: Dimension = Self::of(0, 0, 0, 0, 1);
    pub const VELOCITY: Dimension = Self::of(1, 0, -1, 0, 0);
    pub const ACCELERATION: Dimension = Self::of(1, 0, -2, 0, 0);
    pub const ANGULAR_VELOCITY: Dimension = Self::of(0, 0, -1, 0, 1);
    pub const ANGULAR_ACCELERATION: Dimension = Self::of(0, 0, -2, 0, 1);
    pub const STIFFNESS: Dimension = Self::of(-1, 0, 0, 1, 0);
    pub const DAMPING: Dimension = Self::of(-1, 0, 1, 1, 0);
    pub const TORSION_STIFFNESS: Dimension = Self::of(1, 0, 0, 1, -1);
    pub const TORSION_DAMPING: Dimension = Self::of(1, 0, 1, 1, -1);

    pub const fn of(length: i8, mass: i8, time: i8, force: i8, angle: i8) -> Dimension {
        Dimension { length, mass, time, force, angle, frequency: 0 }
    }

    #[must_use]
    pub const fn times(self, other: Dimension) -> Dimension {
        Dimension {
            length: self.length.saturating_add(other.length),
            mass: self.mass.saturating_add(other.mass),
            time: self.time.saturating_add(other.time),
            force: self.force.saturating_add(other.force),
            angle: self.angle.saturating_add(other.angle),
            frequency: self.frequency.saturating_add(other.frequency),
        }
    }

    #[must_use]
    pub const fn power(self, n: i8) -> Dimension {
        Dimension {
            length: self.length.saturating_mul(n),
            mass: self.mass.saturating_mul(n),
            time: self.time.saturating_mul(n),
            force: self.force.saturating_mul(n),
            angle: self.angle.saturating_mul(n),
            frequency: self.frequency.saturating_mul(n),
        }
    }

    #[must_use]
    pub const fn per(self, other: Dimension) -> Dimension {
        self.times(other.power(-1))
    }

    /// Name of the dimension as Adams' `units` parameter writes it (`"pressure"`), if it has one.
    pub fn name(self) -> Option<&'static str> {
        Quantity::ALL.iter().find(|q| q.dimension == self).map(|q| q.name)
    }
}

/// A named kind of quantity: the words of `units = "pressure"`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    pub name: &'static str,
    pub dimension: Dimension,
}

impl Quantity {
    pub const ALL: &'static [Quantity] = &[
        Quantity { name: "no_units", dimension: Dimension::NONE },
        Quantity { name: "length", dimension: Dimension::LENGTH },
        Quantity { name: "area", dimension: Dimension::AREA },
        Quantity { name: "volume", dimension: Dimension::VOLUME },
        Quantity { name: "area_inertia", dimension: Dimension::AREA_INERTIA },
        Quantity { name: "mass", dimension: Dimension::MASS },
        Quantity { name: "inertia", dimension: Dimension::INERTIA },
        Quantity { name: "density", dimension: Dimension::DENSITY },
        Quantity { name: "time", dimension: Dimension::TIME },
        Quantity { name: "frequency", dimension: Dimension::FREQUENCY },
        Quantity { name: "force", dimension: Dimension::FORCE },
        Quantity { name: "torque", dimension: Dimension::TORQUE },
        Quantity { name: "pressure", dimension: Dimension::PRESSURE },
        Quantity { name: "stress", dimension: Dimension::PRESSURE },
        Quantity { name: "energy", dimension: Dimension::ENERGY },
        Quantity { name: "angle", dimension: Dimension::ANGLE },
        Quantity { name: "velocity", dimension: Dimension::VELOCITY },
        Quantity { name: "acceleration", dimension: Dimension::ACCELERATION },
        Quantity { name: "angular_velocity", dimension: Dimension::ANGULAR_VELOCITY },
        Quantity { name: "angular_acceleration", dimension: Dimension::ANGULAR_ACCELERATION },
        Quantity { name: "stiffness", dimension: Dimension::STIFFNESS },
        Quantity { name: "damping", dimension: Dimension::DAMPING },
        Quantity { name: "torsion_stiffness", dimension: Dimension::TORSION_STIFFNESS },
        Quantity { name: "torsion_damping", dimension: Dimension::TORSION_DAMPING },
    ];

    pub fn named(name: &str) -> Option<Quantity> {
        Self::ALL.iter().copied().find(|q| q.name.eq_ignore_ascii_case(name))
    }
}

/// A unit word: `newton`, what it measures, and its size in SI (angles in radians).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitName {
    /// The word of `defaults units`.
    pub name: &'static str,
    /// Other spellings accepted in unit expressions and abbreviations used in output.
    pub symbols: &'static [&'static str],
    pub dimension: Dimension,
    pub si: f64,
}

/// Alias for a table of units.
pub type UnitTable = &'static [UnitName];

const fn unit(name: &'static str, symbols: &'static [&'static str], dimension: Dimension, si: f64) -> UnitName {
    UnitName { name, symbols, dimension, si }
}

const POUND: f64 = 0.453_592_37;
const GRAVITY: f64 = 9.806_65;
const L: Dimension = Dimension::LENGTH;
const M: Dimension = Dimension::MASS;
const T: Dimension = Dimension::TIME;
const F: Dimension = Dimension::FORCE;
const A: Dimension = Dimension::ANGLE;

static UNITS: [UnitName; 54] = [
    unit("mm", &["millimeter"], L, 1e-3),
    unit("cm", &["centimeter"], L, 1e-2),
    unit("meter", &["m"], L, 1.0),
    unit("km", &["kilometer"], L, 1e3),
    unit("inch", &["in"], L, 0.0254),
    unit("foot", &["ft", "feet"], L, 0.3048),
    unit("mile", &[], L, 1609.344),
    unit("micrometer", &["um"], L, 1e-6),
    unit("nanometer", &["nm"], L, 1e-9),
    unit("angstrom", &[], L, 1e-10),
    unit("microinch", &["uin"], L, 2.54e-8),
    unit("mils", &["mil"], L, 2.54e-5),
    unit("yard", &["yd"], L, 0.9144),
    unit("newton", &["n"], F, 1.0),
    unit("knewton", &["kn"], F, 1e3),
    unit("dyne", &[], F, 1e-5),
    unit("pound_force", &["lbf"], F, POUND * GRAVITY),
    unit("kpound_force", &["klbf"], F, 1e3 * POUND * GRAVITY),
    unit("kg_force", &["kgf", "kilogram_force"], F, GRAVITY),
    unit("ounce_force", &["ozf"], F, POUND * GRAVITY / 16.0),
    unit("millinewton", &["mnewton"], F, 1e-3),
    unit("centinewton", &["cnewton"], F, 1e-2),
    unit("poundal", &["pdl"], F, POUND * 0.3048),
    unit("micronewton", &["unewton"], F, 1e-6),
    unit("nanonewton", &["nnewton"], F, 1e-9),
    unit("meganewton", &[], F, 1e6),
    unit("kg", &["kilogram"], M, 1.0),
    unit("gram", &["g"], M, 1e-3),
    unit("pound_mass", &["lbm"], M, POUND),
    unit("kpound_mass", &["klbm"], M, 1e3 * POUND),
    unit("slug", &[], M, POUND * GRAVITY / 0.3048),
    unit("slinch", &[], M, POUND * GRAVITY / 0.0254),
    unit("ounce_mass", &["ozm"], M, POUND / 16.0),
    unit("tonne", &["megagram"], M, 1e3),
    unit("milligram", &["mg"], M, 1e-6),
    unit("microgram", &["ug"], M, 1e-9),
    unit("nanogram", &["ng"], M, 1e-12),
    unit("us_ton", &[], M, 2000.0 * POUND),
    unit("second", &["sec", "s"], T, 1.0),
    unit("millisecond", &["msec", "ms"], T, 1e-3),
    unit("microsecond", &["usec", "us"], T, 1e-6),
    unit("nanosecond", &["nsec", "ns"], T, 1e-9),
    unit("minute", &["min"], T, 60.0),
    unit("hour", &["h"], T, 3600.0),
    unit("day", &[], T, 86400.0),
    unit("degrees", &["deg", "d", "degree"], A, std::f64::consts::PI / 180.0),
    unit("radians", &["rad", "radian"], A, 1.0),
    unit("angular_minutes", &["angular_minute"], A, std::f64::consts::PI / 10800.0),
    unit("angular_seconds", &["angular_second"], A, std::f64::consts::PI / 648_000.0),
    unit("revolutions", &["rev", "revolution"], A, std::f64::consts::TAU),
    unit("hz", &["hertz"], Dimension::FREQUENCY, 1.0),
    unit("radians_sec", &[], Dimension::FREQUENCY, 1.0 / std::f64::consts::TAU),
    unit("pascal", &["pa"], Dimension::PRESSURE, 1.0),
    unit("megapascal", &["mpa"], Dimension::PRESSURE, 1e6),
];

/// All unit words.
pub fn unit_table() -> UnitTable {
    &UNITS
}

impl UnitName {
    /// The unit a word names, by full name or symbol, ignoring case.
    pub fn find(word: &str) -> Option<&'static UnitName> {
        UNITS
            .iter()
            .find(|u| u.name.eq_ignore_ascii_case(word))
            .or_else(|| UNITS.iter().find(|u| u.symbols.iter().any(|s| s.eq_ignore_ascii_case(word))))
    }
}

/// Reads a unit expression such as `kg/meter**3`, `newton-sec/mm` or `Newton/meter**2`: its
/// dimension and its size in SI. `*`, `-` between words, `/`, `**n` and `^n` are understood.
pub fn parse_unit_expression(text: &str) -> Option<(Dimension, f64)> {
    let (mut dimension, mut si, mut sign) = (Dimension::NONE, 1.0, 1i8);
    let mut rest = text.trim();
    let mut first = true;
    while !rest.is_empty() {
        if !first {
            let (operator_sign, after) = match rest.as_bytes()[0] {
                b'/' => (-1, &rest[1..]),
                b'*' | b'-' => (sign, &rest[1..]),
                _ => return None,
            };
            (sign, rest) = (operator_sign, after.trim_start());
        }
        first = false;
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
        let word = &rest[..end];
        rest = rest[end..].trim_start();
        let mut power = 1i8;
        if let Some(after) = rest.strip_prefix("**").or_else(|| rest.strip_prefix('^')) {
            let after = after.trim_start();
            let end = after.find(|c: char| !c.is_ascii_digit()).unwrap_or(after.len());
            power = after[..end].parse().ok()?;
            rest = after[end..].trim_start();
        }
        if word == "1" {
            continue;
        }
        let unit = UnitName::find(word)?;
        dimension = dimension.times(unit.dimension.power(sign.checked_mul(power)?));
        si *= unit.si.powi(i32::from(sign) * i32::from(power));
    }
    (!first).then_some((dimension, si))
}

/// The units in force: what a plain number means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitSystem {
    pub length: &'static UnitName,
    pub mass: &'static UnitName,
    pub time: &'static UnitName,
    pub force: &'static UnitName,
    pub angle: &'static UnitName,
    pub frequency: &'static UnitName,
    /// Overrides the factor that follows from the units, where the user set it.
    pub consistency_factor: Option<f64>,
}

impl UnitSystem {
    /// Units by name. Returns the word that is not a unit of that dimension.
    pub fn named<'a>(
        length: &'a str,
        mass: &'a str,
        time: &'a str,
        force: &'a str,
        angle: &'a str,
    ) -> Result<UnitSystem, &'a str> {
        let find = |word: &'a str, dimension| UnitName::find(word).filter(|u| u.dimension == dimension).ok_or(word);
        Ok(UnitSystem {
            length: find(length, L)?,
            mass: find(mass, M)?,
            time: find(time, T)?,
            force: find(force, F)?,
            angle: find(angle, A)?,
            frequency: UnitName::find("hz").ok_or(length)?,
            consistency_factor: None,
        })
    }

    /// Units by words that stand in the table above.
    fn known(length: &str, mass: &str, time: &str, force: &str, angle: &str) -> UnitSystem {
        Self::named(length, mass, time, force, angle).unwrap_or_else(|word| unreachable!("{word} is no unit"))
    }

    /// mm, kg, newton, second, degrees: what a new session starts with.
    pub fn mmks() -> UnitSystem {
        Self::known("mm", "kg", "second", "newton", "degrees")
    }

    /// meter, kg, newton, second, radians.
    pub fn si() -> UnitSystem {
        Self::known("meter", "kg", "second", "newton", "radians")
    }

    /// Size of one unit of a dimension in SI.
    pub fn factor(&self, dimension: Dimension) -> f64 {
        let power = |unit: &UnitName, n: i8| if n == 0 { 1.0 } else { unit.si.powi(i32::from(n)) };
        power(self.length, dimension.length)
            * power(self.mass, dimension.mass)
            * power(self.time, dimension.time)
            * power(self.force, dimension.force)
            * power(self.angle, dimension.angle)
            * power(self.frequency, dimension.frequency)
    }

    /// force * UCF = mass * acceleration.
    pub fn consistency_factor(&self) -> f64 {
        self.consistency_factor
            .unwrap_or_else(|| self.force.si / (self.mass.si * self.length.si / (self.time.si * self.time.si)))
    }

    /// Text of the unit of a dimension: `newton/mm**2`; empty without dimension.
    pub fn label(&self, dimension: Dimension) -> String {
        let parts = [
            (self.force.name, dimension.force),
            (self.mass.name, dimension.mass),
            (self.length.name, dimension.length),
            (self.angle.name, dimension.angle),
            (self.frequency.name, dimension.frequency),
            (self.time.name, dimension.time),
        ];
        let word = |&(name, n): &(&str, i8)| {
            if n.abs() == 1 { name.to_string() } else { format!("{name}**{}", n.abs()) }
        };
        let above: Vec<_> = parts.iter().filter(|p| p.1 > 0).map(word).collect();
        let below: Vec<_> = parts.iter().filter(|p| p.1 < 0).map(word).collect();
        match (above.is_empty(), below.is_empty()) {
            (true, true) => String::new(),
            (false, true) => above.join("-"),
            (true, false) => format!("1/{}", below.join("/")),
            (false, false) => format!("{}/{}", above.join("-"), below.join("/")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Truth: an export of a steel part shows 7801 kg/m^3 as 0.2818290049 lbm/in^3 and 2.07E+11 Pa
    /// as 3.002281171E+07 psi; ten printed digits.
    #[test]
    fn steel_converts_to_the_digits_adams_prints() {
        let ips = UnitSystem::named("inch", "pound_mass", "second", "pound_force", "degrees").unwrap();
        let density = parse_unit_expression("kg/meter**3").unwrap();
        assert_eq!(density.0, Dimension::DENSITY);
        assert!((7801.0 * density.1 / ips.factor(density.0) - 0.2818290049).abs() < 5e-11);
        let pressure = parse_unit_expression("Newton/meter**2").unwrap();
        assert!((2.07e11 * pressure.1 / ips.factor(pressure.0) - 3.002281171e7).abs() < 5e-3);
    }

    /// Truth: 386.0885827 is standard gravity in inch/s^2.
    #[test]
    fn consistency_factors_follow_from_the_units() {
        assert_eq!(UnitSystem::mmks().consistency_factor(), 1000.0);
        let ips = UnitSystem::named("inch", "pound_mass", "second", "pound_force", "degrees").unwrap();
        assert!((ips.consistency_factor() - 386.0885827).abs() < 1e-7);
    }

    #[test]
    fn unit_labels_read_like_adams() {
        let mmks = UnitSystem::mmks();
        assert_eq!(mmks.label(Dimension::PRESSURE), "newton/mm**2");
        assert_eq!(mmks.label(Dimension::TORQUE), "newton-mm");
        assert_eq!(mmks.label(Dimension::NONE), "");
    }

    /// Truth: by definition. The unit of frequency is not the inverse of the unit of time.
    #[test]
    fn frequencies_and_inverse_times_have_their_own_units() {
        let units = UnitSystem::named("mm", "kg", "millisecond", "newton", "degrees").unwrap();
        assert_eq!(units.factor(Dimension::PER_TIME), 1000.0);
        assert_eq!(units.factor(Dimension::FREQUENCY), 1.0);
        let turning = UnitSystem { frequency: UnitName::find("radians_sec").unwrap(), ..units };
        assert_eq!(turning.factor(Dimension::FREQUENCY), 1.0 / std::f64::consts::TAU);
        assert_eq!(turning.factor(Dimension::PER_TIME), 1000.0);
        assert_eq!(parse_unit_expression("1/sec"), Some((Dimension::PER_TIME, 1.0)));
        assert_eq!(parse_unit_expression("hz").map(|u| u.0), Some(Dimension::FREQUENCY));
        assert_eq!(units.label(Dimension::FREQUENCY), "hz");
        assert_eq!(units.label(Dimension::PER_TIME), "1/millisecond");
    }

    #[test]
    fn what_is_no_unit_is_refused() {
        assert_eq!(parse_unit_expression("furlong"), None);
        assert_eq!(parse_unit_expression(""), None);
        assert_eq!(parse_unit_expression("mm mm"), None);
    }
}
