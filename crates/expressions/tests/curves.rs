//! Curves and surfaces through points.

mod common;
use common::*;

/// Truth: the examples of the help pages, at thirds of the pieces, as fractions. CSPLINE's page
/// swaps two digits of one value (0.936), which the page of SPLINE prints as 0.963 = 26/27.
#[test]
fn splines_go_through_the_documented_values() {
    let db = fixture().db;
    let n = 27.0;
    for (name, expected) in [
        ("AKIMA_SPLINE", [0.0, 1.0, 5.0 / 3.0, 2.0, 16.0 / 9.0, 11.0 / 9.0, 1.0, 4.0 / 3.0, 2.0, 3.0]),
        ("CSPLINE", [0.0, 26.0 / n, 46.0 / n, 2.0, 47.0 / n, 34.0 / n, 1.0, 35.0 / n, 55.0 / n, 3.0]),
        ("CUBIC_SPLINE", [0.0, 1.0, 5.0 / 3.0, 2.0, 2.0, 5.0 / 3.0, 1.0, 4.0 / 3.0, 2.0, 3.0]),
        ("HERMITE_SPLINE", [0.0, 28.0 / n, 47.0 / n, 2.0, 47.0 / n, 34.0 / n, 1.0, 34.0 / n, 53.0 / n, 3.0]),
        // A single cubic through four points: Lagrange's formula.
        ("NOTAKNOT_SPLINE", [0.0, 37.0 / n, 53.0 / n, 2.0, 46.0 / n, 35.0 / n, 1.0, 28.0 / n, 44.0 / n, 3.0]),
        ("LINEAR_SPLINE", [0.0, 2.0 / 3.0, 4.0 / 3.0, 2.0, 5.0 / 3.0, 4.0 / 3.0, 1.0, 5.0 / 3.0, 7.0 / 3.0, 3.0]),
    ] {
        near(&db, &format!("{name}({{1,2,3,4}},{{0,2,1,3}},10)"), &expected, 1e-12);
    }
    let rows = numbers(&db, "SPLINE({[1,2,3,4],[0,2,1,3]},\"CSPLINE\",10)");
    assert_eq!(rows.len(), 20);
    assert!((rows[3] - 26.0 / n).abs() < 1e-12 && (rows[2] - 4.0 / 3.0).abs() < 1e-12, "{rows:?}");
    for (kind, function) in [("AKIMA", "AKIMA"), ("CUBIC", "CUBIC"), ("LINEAR", "LINEAR"), ("HERMITE", "HERMITE")] {
        let same = format!(
            "SPLINE({{[0,1,2,5],[0,2,1,3]}},\"{kind}\",6)[2,4] - {function}_SPLINE({{0,1,2,5}},{{0,2,1,3}},6)[4]"
        );
        near(&db, &same, &[0.0], 1e-14);
    }
}

/// Twin: SciPy 1.17 Akima1DInterpolator, CubicSpline (not-a-knot, natural), PchipInterpolator on
/// uneven points; the differences are rounding.
#[test]
fn splines_on_uneven_points() {
    let db = fixture().db;
    let call = |name: &str| format!("{name}({{0,1,2.5,3,4.5,6}},{{1,3,2,5,4,0.5}},7)");
    for (name, expected) in [
        ("AKIMA_SPLINE", [1.0, 3.0, 2.121_693_121_693_12, 5.0, 4.777_777_777_777_78, 3.0, 0.5]),
        ("NOTAKNOT_SPLINE", [1.0, 3.0, 0.986_944_444_444_444, 5.0, 5.731_697_530_864_2, 1.990_524_691_358_02, 0.5]),
        ("HERMITE_SPLINE", [1.0, 3.0, 2.259_259_259_259_26, 5.0, 4.489_711_934_156_38, 3.213_991_769_547_33, 0.5]),
        ("CSPLINE", [1.0, 3.0, 1.173_573_276_099_3, 5.0, 5.506_301_249_243_3, 2.636_866_435_529_1, 0.5]),
    ] {
        near(&db, &call(name), &expected, 1e-12);
    }
}

/// Truth: INTEGR of x**2 from its help page is x**3/3, which every spline with end conditions exact
/// for parabolas gives. Twin: the spline of Forsythe, Malcolm and Moler solved by NumPy as one
/// system for the coefficients of all pieces.
#[test]
fn curves_are_integrated_and_differentiated() {
    let db = fixture().db;
    near(&db, "INTEGR(SERIES(0,1,5), {0,1,4,9,16})", &[0.0, 1.0 / 3.0, 8.0 / 3.0, 9.0, 64.0 / 3.0], 1e-12);
    near(&db, "INTEGR({0,2},{1,3})", &[0.0, 4.0], 1e-12);
    near(&db, "DIFFERENTIATE({[0,1,3],[0,1,9]})", &[0.0, 0.0, 1.0, 2.0, 3.0, 6.0], 1e-12);
    let points = "{[0,1,2.5,3,4.5,6],[1,3,2,5,4,0.5]}";
    let every_second = |values: Vec<f64>| values.into_iter().skip(1).step_by(2).collect::<Vec<_>>();
    for (call, expected) in [
        (
            "DIFFERENTIATE",
            [
                7.172_351_105_684_5,
                -1.705_684_439_017_8,
                4.769_895_536_562_2,
                5.182_173_382_173_4,
                -3.767_073_667_073_7,
                0.886_121_286_121_26,
            ],
        ),
        (
            "INTEGRATE",
            [0.0, 2.739_836_295_391_9, 5.275_665_049_970_6, 7.017_075_928_187, 15.445_059_749_921, 17.947_585_696_197],
        ),
    ] {
        let found = every_second(numbers(&db, &format!("{call}({points})")));
        for (x, y) in found.iter().zip(expected) {
            assert!((x - y).abs() < 1e-11, "{call}: {found:?}");
        }
        assert_eq!(found.len(), 6);
    }
}

/// Twin: NumPy polyfit and unwrap(period=360). Truth: overlaps and steps by hand.
#[test]
fn curves_are_straightened_and_resampled() {
    let db = fixture().db;
    let line = [0.092_857_142_857_142_9, 0.714_285_714_285_714, -0.664_285_714_285_715, 0.457_142_857_142_857];
    let rest = [-1.421_428_571_428_57, 0.821_428_571_428_57];
    near(&db, "DETREND({0,1,2,3,4,6},{1,2.5,2,4,3,7})", &[&line[..], &rest].concat(), 1e-13);
    near(
        &db,
        "UNWRAP({0,170,-170,-90,100,-100,-170,10})",
        &[0.0, 170.0, 190.0, 270.0, 100.0, 260.0, 190.0, 370.0],
        1e-12,
    );
    near(&db, "UNWRAP({0,720,359})", &[0.0, 0.0, -1.0], 1e-12);
    // Points of one line: every spline is the line.
    near(&db, "RESAMPLE({[0,1,2,4],[1,3,5,9]},{0.5,3.25},\"AKIMA\",50)", &[2.0, 7.5], 1e-12);
    near(&db, "AKIMA_SPLINE2({0,1,2,3},{0,2,4,6},{0.5,1,1.5,2},0)", &[1.0, 2.0, 3.0, 4.0], 1e-12);
    near(&db, "AKIMA_SPLINE2({0,1,2,3},{0,2,4,6},{0.5,1,1.5,2},1)", &[1.0, 3.0], 1e-12);
}

/// Twin: SciPy RegularGridInterpolator (linear), CubicSpline in both directions (spline), the
/// weights of Keys' cubic convolution written out in Python (cubic), scipy.signal.resample (upwards)
/// and the sum of waves by NumPy's fft (downwards).
#[test]
fn surfaces_and_periodic_curves() {
    let db = fixture().db;
    let surface = "{0,1,2,3.5},{0,1,3,4},{[1,2,0,3],[4,1,3,2],[2,5,1,0],[3,2,2,4]},{0.5,1.5,3},{0.25,2,3.5}";
    // Column by column, one row for each y.
    near(
        &db,
        &format!("INTERP2({surface})"),
        &[1.75, 3.0, 3.0, 1.25, 2.5, 2.5, 2.083_333_333_333_333, 1.333_333_333_333_333, 1.833_333_333_333_333],
        1e-12,
    );
    near(
        &db,
        &format!("INTERP2({surface},\"spline\")"),
        &[
            1.592_857_142_857_14,
            3.492_857_142_857_14,
            4.332_142_857_142_86,
            1.114_174_107_142_86,
            2.923_809_523_809_52,
            2.928_273_809_523_81,
            2.204_464_285_714_29,
            0.885_714_285_714_286,
            -0.685_714_285_714_287,
        ],
        1e-12,
    );
    near(&db, &format!("INTERP2({surface},\"nearest\")"), &[2.0, 5.0, 2.0, 0.0, 1.0, 2.0, 3.0, 0.0, 4.0], 0.0);
    near(
        &db,
        "INTERP2({0,1,2,3},{0,1,2},{[1,2,0,3],[4,1,3,2],[2,5,1,0]},{0.5,2.25},{0.5,1.75},\"cubic\")",
        &[1.5625, 3.515_625, 2.320_312_5, 1.607_421_875],
        1e-12,
    );
    near(
        &db,
        "INTERPFT({1,3,2,5,4},8)",
        &[
            1.0,
            2.431_295_207_332_12,
            2.914_235_090_730_97,
            2.033_201_332_430_83,
            3.0,
            5.381_012_229_942_27,
            5.085_764_909_269_03,
            2.154_491_230_294_78,
        ],
        1e-12,
    );
    near(&db, "INTERPFT({1,3,2,5},8)[4]", &[2.396_446_609_406_73], 1e-12);
    near(&db, "INTERPFT({1,3,2,5,4,0},4)", &[1.0, 2.288_675_134_594_8, 5.0, 1.711_324_865_405_2], 1e-12);
    near(&db, "MESHGRID({1,2,3},{4,5},0)", &[1.0, 1.0, 2.0, 2.0, 3.0, 3.0], 0.0);
    near(&db, "MESHGRID({1,2,3},{4,5},1)", &[4.0, 5.0, 4.0, 5.0, 4.0, 5.0], 0.0);
}

/// Twin: SciPy griddata, linear on its Delaunay triangulation; at a given point the given height.
#[test]
fn scattered_points_carry_a_surface() {
    let db = fixture().db;
    let points = "{0,2,0,2,1},{0,0,2,2,0.8},{0,2,1,5,3}";
    let call = format!("GRIDDATA({points},{{0.5,1.4,1,1,0.2}},{{0.3,1.2,1.9,0.8,1}})");
    near(&db, &call, &[1.25, 3.68, 3.0, 3.0, 1.02], 1e-9);
    near(&db, &format!("GRIDDATA({points},{{1,2,0}},{{0,1,0}})"), &[1.0, 3.5, 0.0], 1e-8);
    assert!(error(&db, &format!("GRIDDATA({points},{{2.5}},{{1}})")).message.contains("outside the points"));
}

/// What is no curve is refused by name.
#[test]
fn curves_that_are_none_are_refused() {
    let db = fixture().db;
    for (call, text) in [
        ("AKIMA_SPLINE({1,2,2,3},{0,1,2,3},5)", "must rise"),
        ("CSPLINE({1,2,3},{0,1},5)", "make no curve"),
        ("SPLINE({[1,2],[3,4]},\"ROUND\",5)", "not \"ROUND\""),
        ("DIFFERENTIATE({1,2,3})", "2 x n"),
        ("INTERP2({0,1},{0,1},{[1,2,3],[4,5,6]},{0},{0})", "2 rows and 3 columns"),
        ("INTERP2({0,1},{0,1},{[1,2],[4,5]},{7},{0})", "outside the grid"),
        ("LINEAR_SPLINE({0,1},{0,1},1)", "two output values"),
    ] {
        let found = error(&db, call);
        assert!(found.message.contains(text), "{call}: {}", found.message);
    }
}
