//! Numbers, texts, arrays: each function against the documented example or arithmetic by hand.

mod common;
use common::*;
use model::Value;

/// Truth: documented examples (function help pages), further digits by hand. 1e-12: the doubles
/// differ by rounding only; printed examples with fewer digits get half their last digit.
#[test]
fn mathematical_functions() {
    let db = fixture().db;
    for (text, expected, tolerance) in [
        ("ABS(3*(-.89))", 2.67, 1e-12),
        ("AINT(-6.5)", -6.0, 0.0),
        ("AINT(4.6)", 4.0, 0.0),
        ("ANINT(-4.6)", -5.0, 0.0),
        ("CEIL(10.001)", 11.0, 0.0),
        ("FLOOR(.7)", 0.0, 0.0),
        ("NINT(4.78)", 5.0, 0.0),
        ("RTOI(.09)", 0.0, 0.0),
        ("INT(-2.7)", -2.0, 0.0),
        ("MOD(45,16)", 13.0, 0.0),
        ("MOD(-45,16)", -13.0, 0.0),
        ("SIGN(9.6,4.5)", 9.6, 0.0),
        ("SIGN(9.6,-4.5)", -9.6, 0.0),
        ("DIM(5*4,5)", 15.0, 0.0),
        ("DIM(5,20)", 0.0, 0.0),
        ("MAG(5,3,1)", 35.0_f64.sqrt(), 1e-12),
        ("SQRT(5*45)", 15.0, 0.0),
        ("ACOS(.75)", 41.409_622_109_270_86, 1e-12), // degrees, arccos by 50-digit arithmetic
        ("ASIN(0.5)", 30.0, 1e-12),
        ("ATAN(1)", 45.0, 1e-12),
        ("ATAN2(1,-1)", 135.0, 1e-12),
        ("SIN(30)", 0.5, 1e-12),
        ("COS(60)", 0.5, 1e-12),
        ("TAN(45)", 1.0, 1e-12),
        ("SINH(0.0) + COSH(0.0) + TANH(0.0)", 1.0, 0.0),
        ("LOG(EXP(2))", 2.0, 1e-12),
        ("LOG10(1000)", 3.0, 1e-12),
        ("STEP(0.5,0,0,1,10)", 5.0, 0.0),
        ("STEP(0.25,0,0,1,64)", 10.0, 1e-12), // 64 (3/16 - 2/64)
        ("IF(-2,1,2,3) + IF(0,1,2,3) + IF(4,1,2,3)", 6.0, 0.0),
        ("2**3", 8.0, 0.0),
        ("-2**2", -4.0, 0.0),
        ("2**-1", 0.5, 0.0),
        ("7/2", 3.5, 0.0),
        ("24.0/12*1.016**3 + 1.016/12*24.0**3", 1_172.529_544_192, 1e-9), // export, ten digits
        ("(0.4167**2 - 0.3333**2)*PI/4", 4.912_665_512_1e-2, 5e-13),      // export, ten decimals
        ("(3 > 2) + (3 >= 4) + (1 == 1.0) + (1 != 1)", 2.0, 0.0),
        ("1 < 2 && !(2 < 1) || 0", 1.0, 0.0),
        ("(2>0)? 5 : 1/0", 5.0, 0.0),
        ("(\"a\" == \"a\")", 1.0, 0.0),
        ("DTOR*RTOD", 1.0, 1e-15),
    ] {
        near(&db, text, &[expected], tolerance);
    }
}

/// Truth: documented examples; inverse, determinant and products by hand.
#[test]
fn array_functions() {
    let db = fixture().db;
    for (text, expected) in [
        ("CROSS({1,0,0},{0,1,0})", &[0.0, 0.0, 1.0][..]),
        ("DOT({1,1,0},{1,0,1})", &[1.0]),
        ("DET({[1,2,0],[2,2,-1],[3,1,1]})", &[-7.0]), // 1(2+1) - 2(2+3) + 0
        ("INVERSE({[1,2,0],[2,1,-1],[3,1,1]})", &[-0.25, 0.625, 0.125, 0.25, -0.125, -0.625, 0.25, -0.125, 0.375]),
        ("ROWS({1,2,3})", &[3.0]),
        ("COLS({[1,2,3]})", &[3.0]),
        ("COLS({{7,5,0},{15,11,0}})", &[2.0]),
        ("SHAPE({1,2,3})", &[3.0, 1.0]),
        ("SERIES(1,2,3)", &[1.0, 3.0, 5.0]),
        ("SERIES2(2,8,4)", &[2.0, 4.0, 6.0, 8.0]),
        ("SORT({3,2,1},\"a\")", &[1.0, 2.0, 3.0]),
        ("SORT({1,3,2},\"d\")", &[3.0, 2.0, 1.0]),
        ("SORT_INDEX({3,5,4,2},\"a\")", &[4.0, 1.0, 3.0, 2.0]),
        ("SORT_BY({3,1,2},{30,10,20},\"a\")", &[10.0, 20.0, 30.0]),
        ("APPEND({1,2},{3,4})", &[1.0, 2.0, 3.0, 4.0]),
        ("COLS(APPEND({1,2},{3,4}))", &[2.0]),
        ("STACK({[1,2],[3,4]},{[5,6]})", &[1.0, 3.0, 5.0, 2.0, 4.0, 6.0]),
        ("NORM2({[1,2],[3,4]})", &[30.0_f64.sqrt()]),
        ("NORM({[3,0],[4,5]})", &[45.0_f64.sqrt()]), // singular values sqrt(45), sqrt(5)
        ("SSQ({1,2,3,4})", &[30.0]),
        ("SUM({1,2,3,4})", &[10.0]),
        ("PROD({1,2,3,4})", &[24.0]),
        ("MEAN({1,2,3,6})", &[3.0]),
        ("RMS({0,1,4,9,16})", &[70.8_f64.sqrt()]), // 354 / 5
        ("MAX({{2,4,5},{1,8,2}})", &[8.0]),
        ("MIN({2,-4,5})", &[-4.0]),
        ("MAXI({.1,.2,.3,3.3})", &[4.0]),
        ("MINI({.1,.02,.3})", &[2.0]),
        ("FIRST({})", &[0.0]),
        ("LAST({4,5})", &[5.0]),
        ("FIRST_N({4,5,6},2)", &[4.0, 5.0]),
        ("LAST_N({4,5,6},2)", &[5.0, 6.0]),
        ("REVERSE({1,2,3})", &[3.0, 2.0, 1.0]),
        ("UNIQUE({9,1,1})", &[1.0, 9.0]),
        ("VAL({2,0,3},2.2)", &[2.0]),
        ("VALI({2,0,3},2.2)", &[1.0]),
        ("VALAT({-1,0,2,3},{1,2,3,4},{1}[1])", &[2.5]),
        ("VALAT({-1,0,2,3},{1,2,3,4},-2)", &[0.0]),
        ("VALAT({-1,0,2,3},{1,2,3,4},4)", &[5.0]),
        ("ELEMENT({1,2},2)", &[1.0]),
        ("ELEMENT({1,2},3)", &[0.0]),
        ("TILDE({1,2,3})*{4,5,6}", &[-3.0, 6.0, -3.0]), // {1,2,3} x {4,5,6}
        ("TRANSPOSE({[1,2],[3,4]})", &[1.0, 2.0, 3.0, 4.0]),
        ("{1,2,3} + 1", &[2.0, 3.0, 4.0]),
        ("{1,2,3}**2", &[1.0, 4.0, 9.0]),
        ("{[1,2],[3,4]}[2,1]", &[3.0]),
        ("INTERP1({0,1,2},{0,10,40},{0.5,1.5},\"linear\")", &[5.0, 25.0]),
        ("INTERP1({0,1,2},{0,10,40},1.4,\"nearest\")", &[10.0]),
        // A cubic through four points is the cubic itself: x**3.
        ("INTERP1({0,1,2,4,5},{0,1,8,64,125},{1.5,3,4.5},\"spline\")", &[3.375, 27.0, 91.125]),
        ("INTERP1({0,1,3},{2,4,8},2.5,\"pchip\")", &[7.0]), // points on one line
        ("POLYFIT({0,1,2,3},{1,2,5,10},2)", &[1.0, 0.0, 1.0]), // 1 + x**2
        ("POLYVAL({1,0,1},{2,3})", &[5.0, 10.0]),
        ("TMAT({90,0,0},\"body313\")", &[0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
        ("CONVERT_ANGLES({90,90,0},\"space123\")", &[90.0, 0.0, 90.0]), // Rz(90) Rx(90)
        ("ANYM({0,0,1}) + ALLM({0,1})", &[1.0]),
        ("ALIGN({3,4,6},0)", &[0.0, 1.0, 3.0]),
        ("DIFF({3,4,6})", &[1.0, 2.0]),
        ("EXCLUDE({3,4,3},3)", &[4.0]),
    ] {
        near(&db, text, expected, 1e-12);
    }
    near(&db, "NORMALIZE({3,4,5})", &[0.424, 0.566, 0.707], 5e-4);
}

/// Twin: the rotation matrix made again from the angles, for all 24 sequences.
#[test]
fn angles_of_every_sequence_give_the_rotation_back() {
    let db = fixture().db;
    for kind in ["body", "space"] {
        for axes in ["123", "231", "312", "132", "213", "321", "121", "131", "212", "232", "313", "323"] {
            for angles in ["{20,-35,50}", "{0,0,0}", "{-100,70,10}", "{30,90,0}"] {
                let round = format!(
                    "TMAT(CONVERT_ANGLES({angles},\"{kind}{axes}\"),\"{kind}{axes}\") - TMAT({angles},\"body313\")"
                );
                near(&db, &round, &[0.0; 9], 1e-12);
            }
        }
    }
}

/// Truth: documented examples.
#[test]
fn text_functions() {
    let db = fixture().db;
    for (text, expected) in [
        ("STR_CASE(\"this is a TEST!\",1)", "THIS IS A TEST!"),
        ("STR_CASE(\"this is a TEST!\",3)", "This Is A Test!"),
        ("STR_CHR(65)", "A"),
        ("CHR(65)", "A"),
        ("STR_INSERT(\"That'sfolks\",\" all \",7)", "That's all folks"),
        ("STR_SUBSTR(\"This is one string\",9,8)", "one stri"),
        ("STR_DELETE(\"This is your life\",9,1)", "This is our life"),
        ("STR_REPLACE_ALL(\"aabbccaaaeeffaaaa\",\"aa\",\"cba\")", "cbabbcccbaaeeffcbacba"),
        ("STR_SPLIT(\" apple; orange; grape \",\";\")[2]", "orange"),
        ("STR_SPRINTF(\"The %s of %s is %03d%%.\", {\"value\",\"angle\",2})", "The value of angle is 002%."),
        ("STR_SPRINTF(\"%8.3f|%-5s|%e|%g\", {2.5,\"ab\",12345.678,0.0001})", "   2.500|ab   |1.234568e+04|0.0001"),
        ("STR_MERGE_STRINGS(\" \", {\"how\",\"now\"})", "how now"),
        ("STR_REMOVE_WHITESPACE(\"   It's summer    \")", "It's summer"),
        ("STR_XLATE(\"Why/-are/-you/-here/-?\", \"/-\", \">_\")", "Why>_are>_you>_here>_?"),
        ("\"C_\" // 1+(3-1)*4", "C_9"),
        ("\"mass_\" // RTOI(3.0) // '.cm'", "mass_3.cm"),
        ("ON_OFF(1)", "on"),
        ("\"x\" // 2.0 // 2.5", "x2.02.5"),
        ("UNIQUE_NAME(\"stat\")", "stat_1"),
        ("UNIQUE_LOCAL_NAME(.m, \"p\")", "p_1"),
        ("UNIQUE_FULL_NAME(\"marker\")", ".m.MARKER_1"),
        ("UNITS_VALUE(\"angle\")", "degrees"),
        ("UNITS_VALUE(\"length/time**2\")", "mm/second**2"),
        ("UNITS_STRING(\".m.b.youngs_modulus\")", "newton/mm**2"),
        ("DB_TYPE(p1)", "part"),
        ("DB_SHORT_NAME(.m.p2.cm)", "cm"),
        ("p1.m1.name", "m1"),
    ] {
        assert_eq!(text_value(&db, text), expected, "{text}");
    }
    for (text, expected) in [
        ("STR_COMPARE(\"ADJECTIVE\",\"adjective\")", 0.0),
        ("STR_FIND(\"Hello\",\"l\")", 3.0),
        ("STR_FIND(\"Hello\",\"z\")", 0.0),
        ("STR_FIND_COUNT(\"hellllo jello\",\"ll\")", 3.0),
        ("STR_FIND_N(\"meant human\",\"an\",2)", 10.0),
        ("STR_FIND_N(\"43### 55###9 22##5\",\"##\",3)", 16.0),
        ("STR_FIND_IN_STRINGS({\"a\",\"force\"},\"force\")", 2.0),
        ("STR_LENGTH(\"Hello there\")", 11.0),
        ("STR_MATCH(\"f?d\",\"fad\")", 1.0),
        ("STR_MATCH(\"[a-c]*_{left,right}\",\"beam_right\")", 1.0),
        ("STR_MATCH(\"*a*b\",\"xaayb\") + STR_MATCH(\"[ac]*\",\"dx\")", 1.0),
        ("STR_IS_REAL(\" 1.5e3 \") + STR_IS_REAL(\"abc\")", 1.0),
        ("STOI(\"12\") + STOR(\"0.5\")", 12.5),
        ("UNITS_CONVERSION_FACTOR(\"inch\")", 25.4),
        ("DB_EXISTS(\".m.p1\") + DB_EXISTS(\".m.p9\") + DB_EXISTS(\".colors.X\")", 1.0),
        ("DB_OBJECT_COUNT(DB_CHILDREN(.m,\"marker\"))", 3.0),
        ("DB_OBJECT_COUNT(DB_IMMEDIATE_CHILDREN(.m,\"part\"))", 3.0),
        ("DB_OBJECT_COUNT(DB_DESCENDANTS(.m,\"all\",0,1))", 4.0),
        ("DB_OBJECT_COUNT(DB_FILTER_NAME(DB_CHILDREN(.m,\"marker\"),\"[cm]*\"))", 2.0),
        ("DB_OBJECT_COUNT(DB_FILTER_TYPE(DB_CHILDREN(.m,\"all\"),\"beam\"))", 1.0),
        ("DB_COUNT(.m.p1,\"location\")", 3.0),
        ("DB_OF_CLASS(.m.b,\"force\")", 1.0),
        ("DB_OBJ_EXISTS(.m.p1,\"m1\") + DB_OBJ_EXISTS(.m.p1,\"mar1\")", 1.0),
        ("DB_OF_TYPE_EXISTS(\".m.p1\",\"part\") + DB_OF_TYPE_EXISTS(\".m.p1\",\"marker\")", 1.0),
        ("DB_ANCESTOR(.m.p1.m1,\"model\") == .m", 1.0),
        ("DB_ANCESTOR(.m.p1.m1,\"beam\") == (none)", 1.0),
        ("DB_DEFAULT(system_defaults,\"model\") == .m", 1.0),
        ("STOO(\"p1.m1\").adams_id + .m.b.i.adams_id", 0.0),
        ("UNIQUE_ID(\"marker\")", 1.0),
        ("FILE_EXISTS(\"/no/such/file\")", 0.0),
    ] {
        near(&db, text, &[expected], 1e-12);
    }
    assert!(text_value(&db, "STR_TIMESTAMP()").len() == 19);
    assert!(matches!(value(&db, "GETENV(\"NO_SUCH_VARIABLE_HERE\")"), Value::Text(t) if t.is_empty()));
}

#[test]
fn functions_of_the_moment_are_not_kept() {
    let db = fixture().db;
    assert!(matches!(bound_for(&db, "GETCWD()", None), Ok(flexure_expressions::Bound::Value(_))));
    let kept = bound(&db, "\"file_\" // UNIQUE_NAME(\"a\")");
    assert_eq!(flexure_expressions::print(&kept, &db), "\"file_\" // \"a_1\"");
}
