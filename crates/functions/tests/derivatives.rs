//! Gradients and jets of every function against central differences.

mod support;

use flexure_functions::Function;
use support::function;

/// Functions of the measures `DX(1)` (called x below) and `VX(1)` and of time.
const SMOOTH: &[&str] = &[
    "DX(1)*VX(1) + TIME",
    "DX(1)/VX(1) - TIME/DX(1)",
    "(DX(1)+2)**3 - VX(1)**2 + TIME**0.5",
    "(DX(1)+2)**(VX(1)*TIME)",
    "2**DX(1)",
    "(-DX(1)-1)**3",
    "ATAN2(DX(1), VX(1)*TIME)",
    "SQRT(DX(1)+VX(1)) * EXP(-TIME) / LOG(VX(1)+2) + LOG10(TIME+3)",
    "SIN(DX(1))*COS(VX(1))*TAN(TIME/4)",
    "ASIN(DX(1)/3) + ACOS(VX(1)/7) + ATAN(TIME*DX(1))",
    "SINH(DX(1)) + COSH(VX(1)/3) * TANH(TIME)",
    "STEP(DX(1), 0, TIME, 2, VX(1))",
    "STEP(DX(1), 2, TIME, 0, VX(1))",
    "STEP5(TIME, 0, DX(1), 2, VX(1)) + STEP5(DX(1)+TIME, 0.1, 1, 5, 2)",
    "HAVSIN(DX(1), 0.1*TIME, 1, 2, 3)",
    "SHF(TIME, DX(1), VX(1), 2, 0.3, 1)",
    "POLY(DX(1), TIME, 1, 2, 3, 4) + CHEBY(VX(1), TIME, 1, 2, 3, 4, 5)",
    "FORCOS(DX(1), 0.1, 2, 1, 2, 3) * FORSIN(TIME, 0.1, VX(1), 1, 2, 3)",
    "IMPACT(DX(1), VX(1), 3, 100, 2.2, 0.5, 5)",
    "BISTOP(DX(1), VX(1), 2, 4, 100, 1.5, 0.3, 5) + BISTOP(DX(1), -VX(1), -2, 0.1, 100, 1.5, 0.3, 5)",
    "SWEEP(TIME, DX(1), 0.2, 1, 3, VX(1), 5) + SWEEP(DX(1), 1, 2, 1, 3, 2, 0.5)",
    "MOD(10*DX(1), 3) + SIGN(DX(1), -VX(1)) + DIM(VX(1), DX(1)) + ABS(-TIME)",
    "MAX(DX(1), VX(1)) * MIN(DX(1)*TIME, VX(1))",
    "IF(DX(1)-VX(1): TIME*VX(1), 0, 5)",
];

/// Central difference of second order with one extrapolation; error about h^4.
fn difference(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let h = 1e-3;
    let d = |h: f64| (f(x + h) - f(x - h)) / (2.0 * h);
    (4.0 * d(h / 2.0) - d(h)) / 3.0
}

fn close(found: f64, expected: f64, tolerance: f64) -> bool {
    (found - expected).abs() <= tolerance * (1.0 + expected.abs())
}

/// Values of the measures by name: the order in a function is that of appearance.
fn arranged<T: Copy>(f: &Function, x: T, v: T) -> Vec<T> {
    f.measures()
        .iter()
        .map(|m| if matches!(m, flexure_functions::Measure::Displacement { .. }) { x } else { v })
        .collect()
}

/// Twin: extrapolated central differences; h = 1e-3 leaves about 1e-10, with a margin for the fifth
/// derivatives of the steep functions.
#[test]
fn gradients_agree_with_differences() {
    let (t, x, v) = (0.7, 1.3, 2.1);
    for text in SMOOTH {
        let f = function(text);
        let at = arranged(&f, x, v);
        let mut gradient = vec![f64::NAN; at.len()];
        let (value, by_time) = f.value_and_gradient(t, &at, &mut gradient);
        assert_eq!(value, f.value(t, &at), "{text}");
        let expected = difference(|t| f.value(t, &at), t);
        assert!(close(by_time, expected, 1e-7), "{text}: d/dt {by_time} {expected}");
        for (index, &slope) in gradient.iter().enumerate() {
            let along = |y: f64| {
                let mut moved = at.clone();
                moved[index] = y;
                f.value(t, &moved)
            };
            let expected = difference(along, at[index]);
            assert!(close(slope, expected, 1e-7), "{text}: measure {index} {slope} {expected}");
        }
    }
}

/// Twin: differences of the value and of the first derivative along a motion given in closed form.
#[test]
fn jets_agree_with_differences_along_a_motion() {
    let x = |t: f64| [1.0 + 0.3 * t.sin(), 0.3 * t.cos(), -0.3 * t.sin()];
    let v = |t: f64| [2.0 + 0.2 * t * t, 0.4 * t, 0.4];
    let t = 0.7;
    for text in SMOOTH {
        let f = function(text);
        let jet = |t: f64| f.jet(t, &arranged(&f, x(t), v(t)));
        let [value, first, second] = jet(t);
        assert_eq!(value, f.value(t, &arranged(&f, x(t)[0], v(t)[0])), "{text}");
        let (expected_first, expected_second) = (difference(|t| jet(t)[0], t), difference(|t| jet(t)[1], t));
        assert!(close(first, expected_first, 1e-7), "{text}: first {first} {expected_first}");
        assert!(close(second, expected_second, 1e-6), "{text}: second {second} {expected_second}");
    }
}

/// Truth: a motion as models write it, 360 degrees per second with a smooth start.
#[test]
fn a_motion_has_exact_velocity_and_acceleration() {
    let [value, first, second] = function("360D*TIME + STEP(TIME, 0, 0, 2, 1)").jet(0.5, &[]);
    // s = 1/4: s^2 (3 - 2 s), its derivatives 6 s (1 - s) / 2 and (6 - 12 s) / 4.
    assert_eq!(value, std::f64::consts::PI + 0.15625);
    assert!((first - (std::f64::consts::TAU + 0.5625)).abs() < 1e-15);
    assert!((second - 0.75).abs() < 1e-15);
}

/// Singular points and branches not taken must not put NaN or infinity into the Newton matrix.
#[test]
fn derivatives_stay_finite_at_kinks_and_singular_points() {
    for (text, expected) in [
        ("SQRT(DX(1)**2)", 0.0),
        ("ABS(DX(1))", 1.0),
        ("DX(1)**2", 0.0),
        ("DX(1)**1", 1.0),
        ("DX(1)**0", 0.0),
        ("DX(1)**0.5", 0.0),
        ("ATAN2(DX(1), 0*DX(1))", 0.0),
        ("IMPACT(DX(1), 1, 0, 1E5, 1.5, 10, 0.01)", 0.0),
        ("IF(DX(1): SQRT(DX(1)), 5, 6)", 0.0),
        ("IF(1-DX(1): LOG(DX(1)), 5, 2*DX(1))", 2.0),
    ] {
        let f = function(text);
        let mut gradient = [f64::NAN];
        let (value, _) = f.value_and_gradient(0.0, &[0.0], &mut gradient);
        assert!(value.is_finite(), "{text}: {value}");
        assert_eq!(gradient, [expected], "{text}");
        let [_, first, second] = f.jet(0.0, &[[0.0, 1.0, 0.0]]);
        assert_eq!(first, expected, "{text}");
        assert!(second.is_finite(), "{text}: {second}");
    }
}

/// Outside a domain the value says so, whatever the branches around it.
#[test]
fn outside_the_domain_the_value_is_not_a_number() {
    let f = function("STEP(SQRT(DX(1)), 0, 0, 1, 1)");
    assert!(f.value(0.0, &[-1.0]).is_nan());
    assert!(f.jet(0.0, &[[-1.0, 0.0, 0.0]])[0].is_nan());
}
