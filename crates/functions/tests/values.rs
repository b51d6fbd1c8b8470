//! Values of the library against closed forms.

mod support;

use std::f64::consts::PI;

use flexure_functions::{Component, Measure, Mode};
use support::{function, number};

/// Truth: exact arithmetic and closed forms; compared bit for bit.
#[test]
fn shaped_functions_give_the_published_values() {
    let cases = [
        ("STEP(0.25,0,0,1,1)", 0.15625),
        ("STEP5(0.25,0,0,1,1)", 0.103515625),
        ("HAVSIN(0.25,0,0,1,1)", 0.14644660940672624),
        ("SHF(1,0,2,30D,0,1)", 2.0),
        ("CHEBY(0.5,0,1,1,1)", 1.0),
        ("POLY(2,1,1,2,3)", 6.0),
        ("IMPACT(-0.001,0,0,1E5,1.5,10,0.01)", 3.1622776601683795),
        ("BISTOP(2,1,-1,1,100,1,5,0.5)", -105.0),
        ("MOD(-7,3)", -1.0),
        ("FORSIN(1,0,90D,1,2,3)", 3.0),
    ];
    for (text, expected) in cases {
        let value = number(text);
        // One rounding of sin(30 D) or sin(180 D) is all that may differ.
        assert!((value - expected).abs() <= 4.0 * f64::EPSILON * f64::abs(expected), "{text}: {value:e}");
    }
}

/// Truth: definitions.
#[test]
fn intrinsics_follow_their_definitions() {
    let cases = [
        ("ABS(-2)", 2.0),
        ("AINT(-2.7)", -2.0),
        ("ANINT(-2.7)", -3.0),
        ("ANINT(2.5)", 3.0),
        ("ATAN2(1,-1)", 0.75 * PI),
        ("DIM(5,3)", 2.0),
        ("DIM(3,5)", 0.0),
        ("MAX(-1,2)", 2.0),
        ("MIN(-1,2)", -1.0),
        ("SIGN(3,-0.1)", -3.0),
        ("SIGN(-3,0)", 3.0),
        ("SQRT(-1E-13)", 0.0),
        ("LOG10(1000)", 1000.0_f64.log10()),
        ("IF(-1:2,3,4)", 2.0),
        ("IF(0:2,3,4)", 3.0),
        ("IF(1:2,3,4)", 4.0),
        ("-2**2", -4.0),
        ("2**3**2", 512.0),
        ("2*-3", -6.0),
        ("180D-PI", 0.0),
        ("RTOD*DTOR", (180.0 / PI) * (PI / 180.0)),
        ("2*dv", 5.0),
    ];
    for (text, expected) in cases {
        assert_eq!(number(text), expected, "{text}");
    }
}

/// Truth: the ends of STEP are flat and a falling pair of ends is the same curve.
#[test]
fn steps_hold_their_ends_and_may_be_given_in_falling_order() {
    for name in ["STEP", "STEP5", "HAVSIN"] {
        let step = function(&format!("{name}(TIME, 1, 2, 3, 10)"));
        assert_eq!(step.value(0.5, &[]), 2.0);
        assert_eq!(step.value(1.0, &[]), 2.0);
        assert_eq!(step.value(3.0, &[]), 10.0);
        assert_eq!(step.value(9.0, &[]), 10.0);
        assert!((step.value(2.0, &[]) - 6.0).abs() < 1e-15, "the middle is half way");
        let falling = function(&format!("{name}(TIME, 3, 10, 1, 2)"));
        for t in [0.0, 1.2, 2.9, 4.0] {
            assert_eq!(step.value(t, &[]), falling.value(t, &[]));
        }
    }
    // No width at all: a jump, never a division 0 / 0 that reaches the result.
    let jump = function("STEP(TIME, 1, 2, 1, 10)");
    assert_eq!([0.9, 1.0, 1.1].map(|t| jump.value(t, &[])), [2.0, 2.0, 10.0]);
}

/// Truth: elastic force k p^e alone where the stop is left fast or damping has not begun.
#[test]
fn stops_push_but_never_pull() {
    assert_eq!(number("IMPACT(0.1, -5, 0, 1E5, 1.5, 10, 0.01)"), 0.0);
    assert_eq!(number("IMPACT(-0.5, 1E6, 0, 100, 1, 10, 0.1)"), 0.0, "leaving fast does not stick");
    assert_eq!(number("IMPACT(-0.5, -2, 0, 100, 1, 10, 0.1)"), 70.0, "50 elastic and 20 from damping");
    assert_eq!(number("IMPACT(-0.5, -2, 0, 100, 1, 10, 0)"), 70.0, "depth 0: full damping at once");
    assert_eq!(number("BISTOP(0, 9, -1, 1, 100, 1, 5, 0.5)"), 0.0);
    assert_eq!(number("BISTOP(-2, -1, -1, 1, 100, 1, 5, 0.5)"), 105.0);
}

/// Truth: Chebyshev T_n(cos a) = cos(n a); Fourier sums by hand.
#[test]
fn series_sum_their_terms() {
    let a: f64 = 0.7;
    let value = number(&format!("CHEBY({}, 0, 0, 0, 0, 0, 0, 1)", a.cos()));
    assert!((value - (5.0 * a).cos()).abs() < 1e-14, "five roundings of the recurrence");
    let value = number("FORCOS(0.3, 0.1, 2, 1, 2, 3)");
    assert!((value - (1.0 + 2.0 * 0.4_f64.cos() + 3.0 * 0.8_f64.cos())).abs() < 1e-14);
    assert_eq!(number("POLY(5, 2, 7)"), 7.0);
}

/// Truth: outside the sweep the frequency is constant, so one period later the value repeats; inside
/// the phase is the integral of the frequency.
#[test]
fn a_sweep_has_continuous_phase() {
    let sweep = function("SWEEP(TIME, 3, 1, 2, 2, 5, 0.1)");
    assert_eq!(sweep.value(0.0, &[]), 0.0);
    assert!((sweep.value(0.6, &[]) - 3.0 * (2.0 * PI * 2.0 * 0.6).sin()).abs() < 1e-13);
    let cycles = 2.0 + 2.0 * 0.5 + 1.5 * 0.25;
    assert!((sweep.value(1.5, &[]) - 3.0 * (2.0 * PI * cycles).sin()).abs() < 1e-13);
    assert!((sweep.value(3.0, &[]) - sweep.value(3.2, &[])).abs() < 1e-12, "5 cycles per unit afterwards");
    assert!((sweep.value(2.0 - 1e-9, &[]) - sweep.value(2.0 + 1e-9, &[])).abs() < 1e-6, "no jump at the end");
}

#[test]
fn measures_are_listed_once_in_the_order_of_appearance() {
    let f = function("DX(m1,2,3) + 2*dx(1,m2,m3)*VZ(4) + BEAM(e,1,2,m5) - DX(1,2,3)");
    let dx = Measure::Displacement { component: Component::X, i: 1, j: Some(2), k: Some(3) };
    let vz = Measure::Velocity { component: Component::Z, i: 4, j: None, k: None, l: None };
    let beam = Measure::Load { element: 7, j_flag: true, component: 2, rm: Some(5) };
    assert_eq!(f.measures(), [dx, vz, beam]);
    assert_eq!(f.value(0.0, &[2.0, 3.0, 5.0]), 2.0 + 2.0 * 2.0 * 3.0 + 5.0 - 2.0);
    assert!(!f.is_function_of_time_only());
    assert!(function("SIN(TIME)").is_function_of_time_only());
    assert_eq!(function("2*PI").as_constant(), Some(2.0 * PI));
}

#[test]
fn a_branch_that_cannot_be_taken_asks_for_nothing() {
    let f = function("IF(1: DX(1), DX(2), TIME)");
    assert!(f.is_function_of_time_only());
    assert_eq!(f.value(3.0, &[]), 3.0);
}

#[test]
fn marker_arguments_go_where_their_function_says() {
    let of = |text: &str| function(text).measures().to_vec();
    let vm = Measure::Velocity { component: Component::Magnitude, i: 1, j: Some(2), k: None, l: Some(3) };
    assert_eq!(of("VM(1,2,3)"), [vm], "the third marker of VM is the frame of the derivative");
    assert_eq!(of("VR(1,2)"), [Measure::RadialVelocity { i: 1, j: Some(2), l: None }]);
    assert_eq!(of("PITCH(1,2)"), [Measure::EulerAngle { yaw_pitch_roll: true, which: 1, i: 1, j: Some(2) }]);
    assert_eq!(of("INCANG(1,2,3)"), [Measure::IncludedAngle { i: 1, j: 2, k: 3 }]);
    let wx = Measure::AngularVelocity { component: Component::X, i: 1, j: None, k: Some(3) };
    assert_eq!(of("WX(1,0,3)"), [wx], "0 is the global frame");
    let tz = Measure::MarkerLoad { torque: true, component: Component::Z, i: 1, j: Some(2), k: None };
    assert_eq!(of("TZ(1,2)"), [tz]);
}

#[test]
fn mode_tells_the_analysis() {
    let mut f = function("IF(MODE-5: 1, 0, 1)*TIME");
    assert!(f.uses_mode());
    assert_eq!(f.value(2.0, &[]), 2.0);
    f.set_mode(Mode::Statics);
    assert_eq!(f.value(2.0, &[]), 0.0);
}

/// A sum of many terms loses none; it leans to the left and is walked without recursion.
#[test]
fn long_sums_are_evaluated() {
    let text = (0..900).map(|_| "TIME").collect::<Vec<_>>().join("+");
    assert_eq!(function(&text).value(0.5, &[]), 450.0);
}
