//! Linear algebra, lists of texts and objects, masses.

mod common;
use common::*;
use model::Value;

const A: &str = "{[4,1,2],[0.5,3,-1],[2,-2,1]}";
const B: &str = "{[2,0.3,0],[0.3,1,0.2],[0,0.2,3]}";

/// Twin: SciPy linalg.eig(A, B), in order of the real parts, vectors scaled to a largest element 1.
#[test]
fn eigenvalues_of_a_pair() {
    let db = fixture().db;
    let values = [-0.270_182_363_052_241_1, 2.224_459_010_899_073_6, 3.681_121_582_241_664_3];
    near(&db, &format!("EIGENVALUES_R({A},{B})"), &values, 1e-12);
    near(&db, &format!("EIGENVALUES_I({A},{B})"), &[0.0; 3], 1e-13);
    let [p, q, r] = values;
    near(&db, &format!("EIG_DR({A},{B})"), &[p, 0.0, 0.0, 0.0, q, 0.0, 0.0, 0.0, r], 1e-12);
    let vectors = [
        -0.531_869_145_535,
        0.383_773_276_105,
        1.0,
        1.0,
        0.483_975_273_607,
        0.143_958_847_86,
        -0.219_036_769_259,
        1.0,
        -0.316_059_202_769,
    ];
    near(&db, &format!("EIG_VR({A},{B})"), &vectors, 1e-10); // the twin is printed to 12 digits
    near(&db, &format!("EIG_VI({A},{B})"), &[0.0; 9], 1e-10);
}

/// Truth: the help page's pair has the double eigenvalue 1: det(A - l B) = -2 (l - 1)**2, with the
/// vector 1, -1. A double root of a perturbed polynomial moves by the root of the rounding: 1e-7.
/// Twin: SciPy linalg.eig for the conjugate pair.
#[test]
fn eigenvalues_that_are_double_or_complex() {
    let db = fixture().db;
    let pair = "{{1,2},{3,4}}, {{5,6},{7,8}}";
    near(&db, &format!("EIGENVALUES_R({pair})"), &[1.0, 1.0], 1e-6);
    near(&db, &format!("EIG_DI({pair})"), &[0.0; 4], 1e-6);
    for column in [1, 2] {
        near(&db, &format!("EIG_VR({pair})[1,{column}] + EIG_VR({pair})[2,{column}]"), &[0.0], 1e-5);
    }
    let pair = "{[0,1,0],[-2,-0.5,1],[0.3,0,-1]}, DMAT({1,1,1})";
    let (re, im) = (-0.314_572_779_886_008, 1.361_304_433_944_74);
    near(&db, &format!("EIGENVALUES_R({pair})"), &[-0.870_854_440_227_985, re, re], 1e-12);
    near(&db, &format!("EIGENVALUES_I({pair})"), &[0.0, -im, im], 1e-12);
    assert!(error(&db, "EIG_DR({[1,2],[3,4]},{[1,2],[2,4]})").message.contains("singular"));
    assert!(error(&db, "EIG_DR({[1,2],[3,4]},{[1]})").message.contains("rows"));
}

/// Each eigenvalue satisfies its equation: A v - l B v = 0 for random matrices up to 12 rows.
#[test]
fn eigenvectors_satisfy_their_equation() {
    let db = fixture().db;
    let mut state = 7_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1 << 24) - 0.5
    };
    for n in [1_usize, 2, 3, 5, 8, 12] {
        let m: Vec<f64> = (0..n * n).map(|_| random()).collect();
        let rows: Vec<String> = (0..n)
            .map(|r| format!("[{}]", (0..n).map(|c| format!("{:?}", m[r * n + c])).collect::<Vec<_>>().join(",")))
            .collect();
        let ones = vec!["1"; n].join(",");
        let pair = format!("({{{}}}, DMAT({{{ones}}}))", rows.join(","));
        let part = |name: &str| numbers(&db, &format!("{name}{pair}"));
        let (lr, li, vr, vi) = (part("EIGENVALUES_R"), part("EIGENVALUES_I"), part("EIG_VR"), part("EIG_VI"));
        assert!((lr.iter().sum::<f64>() - (0..n).map(|i| m[i * n + i]).sum::<f64>()).abs() < 1e-10, "trace, n = {n}");
        for k in 0..n {
            for r in 0..n {
                let (re, im) = (0..n)
                    .fold((0.0, 0.0), |(x, y), c| (x + m[r * n + c] * vr[k * n + c], y + m[r * n + c] * vi[k * n + c]));
                let (x, y) = (vr[k * n + r], vi[k * n + r]);
                let (ex, ey) = (re - (lr[k] * x - li[k] * y), im - (lr[k] * y + li[k] * x));
                assert!(ex.hypot(ey) < 1e-9, "n = {n}, vector {k}: {ex} {ey}");
            }
        }
    }
}

/// Twin: NumPy cond and norm (2). Truth: BALANCE's help page; the balanced form of the second
/// matrix by SciPy matrix_balance, whose factors are powers of two as here.
#[test]
fn conditions_norms_and_balance() {
    let db = fixture().db;
    near(&db, &format!("COND({A})"), &[7.701_562_118_716_43], 1e-12);
    near(&db, "COND({[1,2],[3,4]})", &[14.933_034_373_659_268], 1e-11);
    near(&db, "NORM({[3,1,2],[0,4,1]})", &[4.656_678_906_519_804], 1e-12);
    assert!(error(&db, "COND({[1,2],[2,4]})").message.contains("singular"));
    near(&db, "BALANCE({{1,2},{3,4}})", &[1.0, 2.0, 3.0, 4.0], 0.0);
    let graded = "{[1,100,10000],[0.01,1,100],[0.0001,0.01,1]}";
    let balanced = numbers(&db, &format!("BALANCE({graded})"));
    // Similar, so products across the diagonal stay; 1 each here.
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        assert!((balanced[j * 3 + i] * balanced[i * 3 + j] - 1.0).abs() < 1e-14, "{balanced:?}");
    }
    assert!(balanced.iter().all(|x| (0.4..2.5).contains(x)), "{balanced:?}");
}

/// Truth: documented examples (CENTER, CLIP, COMPRESS); TMAT3 is TMAT with its sequence in two parts.
#[test]
fn parts_of_matrices() {
    let db = fixture().db;
    near(&db, "CENTER({1, 0, 4, 3})", &[2.0], 0.0); // (0 + 4) / 2; the page prints 2.5
    near(&db, "CLIP( {[8, 10], [12,14], [16, 18]} , 1 ,1 )", &[8.0, 12.0, 16.0], 0.0);
    near(&db, "CLIP( {[8, 10], [12,14], [16, 18]} , 2 ,1 )", &[10.0, 14.0, 18.0], 0.0);
    assert!(error(&db, "CLIP({1,2},1,2)").message.contains("1 columns"));
    near(&db, "COMPRESS({1.1,0.0,2.2,3.3,0.0,4.4,0})", &[1.1, 2.2, 3.3, 4.4], 0.0);
    near(&db, "COMPRESS({0,0})", &[0.0], 0.0);
    near(&db, "TMAT3({20,-35,50},\"B\",313) - TMAT({20,-35,50},\"body313\")", &[0.0; 9], 0.0);
    near(&db, "TMAT3({20,-35,50},\"s\",123) - TMAT({20,-35,50},\"space123\")", &[0.0; 9], 0.0);
    assert!(error(&db, "TMAT3({1,2,3},\"x\",313)").message.contains("\"b\" or \"s\""));
    near(&db, "{5,6,7,8,9}[2:4]", &[6.0, 7.0, 8.0], 0.0);
    assert!(error(&db, "{5,6,7}[2:4]").message.contains("no element 4"));
    assert!(error(&db, "{5,6,7}[3:2]").message.contains("counted"));
}

/// Truth: the same calls on numbers; COMPRESS's help page for texts.
#[test]
fn lists_of_texts_and_objects() {
    let db = fixture().db;
    let texts = |call: &str| match value(&db, call) {
        Value::Texts(list) => list,
        Value::Text(one) => vec![one],
        other => panic!("{call}: {other:?}"),
    };
    assert_eq!(texts("COMPRESS({\"  \",\"a\",\"\",\" b\",\"\",\"c \",\"\"})"), ["a", " b", "c "]);
    assert_eq!(texts("COMPRESS({\"  \",\"\"})"), [""]);
    assert_eq!(texts("SORT({\"pear\",\"fig\",\"plum\"},\"d\")"), ["plum", "pear", "fig"]);
    assert_eq!(texts("UNIQUE({\"b\",\"a\",\"b\"})"), ["b", "a"]);
    assert_eq!(texts("REVERSE({\"b\",\"a\"})"), ["a", "b"]);
    assert_eq!(texts("FIRST_N({\"b\",\"a\",\"c\"},2)"), ["b", "a"]);
    assert_eq!(texts("LAST_N({\"b\",\"a\",\"c\"},2)"), ["a", "c"]);
    assert_eq!(texts("EXCLUDE({\"b\",\"a\",\"c\"},\"a\")"), ["b", "c"]);
    assert_eq!(texts("FIRST({\"b\",\"a\"})"), ["b"]);
    assert_eq!(texts("{\"part\",\"marker\"}[2]"), ["marker"]); // case 89
    assert_eq!(texts("APPEND({\"b\"},{\"a\"})"), ["b", "a"]);
    near(&db, "ELEMENT({\"b\",\"a\"},\"a\") + ELEMENT({p1,p2},p1) + ELEMENT({p1},p2)", &[2.0], 0.0);
    near(&db, "ROWS(EXCLUDE({p1,p2,ground},p2)) + ROWS(STACK({p1},{p2}))", &[4.0], 0.0);
    near(&db, "LAST({p1,p2}) == p2", &[1.0], 0.0);
    near(&db, "COMPRESS({p1,p2})[2] != p1", &[1.0], 0.0);
}

/// Twin: NumPy with rotations and the parallel axis rule written out in Python.
#[test]
fn masses_of_several_bodies_add_up() {
    let mut f = fixture();
    let cm = f.db.find(".m.p2.cm", "marker").unwrap();
    for (body, marker, mass, inertia) in
        [(f.p1, f.m1, 2.0, [4.0, 5.0, 6.0, 0.5]), (f.db.find(".m.p2", "part").unwrap(), cm, 3.0, [1.0, 2.0, 3.0, 0.0])]
    {
        f.db.set_value(body, "mass", Value::Number(mass));
        f.db.set_value(body, "center_of_mass_marker", Value::Object(marker));
        for (name, x) in ["ixx", "iyy", "izz", "ixy"].into_iter().zip(inertia) {
            f.db.set_value(body, name, Value::Number(x));
        }
    }
    let db = f.db;
    near(&db, "AGGREGATE_MASS({p1,p2},0,\"mass\")", &[5.0], 0.0);
    near(&db, "AGGREGATE_MASS({p1,p2},0,\"CM_Pos\")", &[41.8, 6.4, 0.0], 1e-12);
    near(&db, "AGGREGATE_MASS({p1,p2},.m.ground.ref,\"cm_pos\")", &[-108.2, 6.4, 0.0], 1e-12);
    let inertias = [49.2, 11_297.8, 11_342.0, 697.9, 0.0, 0.0];
    near(&db, "AGGREGATE_MASS({p1,p2},0,\"inertias\")", &inertias, 1e-9);
    // Along the axes of p1, which is turned by 90 degrees about z: x and y change places.
    let turned = [11_297.8, 49.2, 11_342.0, -697.9, 0.0, 0.0];
    near(&db, "AGGREGATE_MASS({p1,p2},p1,\"inertias\")", &turned, 1e-9);
    near(&db, "AGGREGATE_MASS(.m,0,\"all\")[1:4]", &[5.0, 41.8, 6.4, 0.0], 1e-12);
    near(&db, "AGGREGATE_MASS({p1,p2},0,\"All\")[11:13]", &[697.9, 0.0, 0.0], 1e-9);
    assert!(error(&db, "AGGREGATE_MASS({p1,.m.ground.ref},0,\"mass\")").message.contains("not a body"));
}
