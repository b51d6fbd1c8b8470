//! Names, types, units and defaults of the settings of the time integrator.

use schema::{Class, Dimension, Field, Group};

pub const CLASS: Class = Class {
    id: "numerical_integration_parameters",
    word: "Settings",
    families: &["settings"],
    parents: &["model"],
    prefix: "NUMERICAL_INTEGRATION_PARAMETERS_",
    statement: Some("INTEGRATOR"),
    groups: &[Group {
        command: "executive_control set numerical_integration_parameters",
        creates: true,
        object: "",
        fields: &[
            Field::object("model_name", "model").current().doc("model the setting belongs to"),
            Field::choice(
                "integrator_type",
                &[
                    "constant_bdf",
                    "gstiff",
                    "wstiff",
                    "dstiff",
                    "abam",
                    "cpbdf",
                    "si2_gstiff",
                    "rkf45",
                    "hht",
                    "newmark",
                    "hastiff",
                ],
            )
            .doc("time integrator"),
            Field::choice("formulation", &["i3", "si2", "si1", "psi2", "none"])
                .doc("index of the equations that are integrated"),
            Field::choice("solver_type", &["calahan", "harwell"]).doc("linear solver"),
            Field::real("error_tolerance", Dimension::NONE).doc("local error allowed"),
            Field::yes_no("pattern_for_jacobian").doc("iterations at which the matrix is evaluated anew"),
            Field::integer("maxit_corrector_iterations").doc("corrector iterations at most"),
            Field::real("hinit_time_step", Dimension::TIME).doc("first time step"),
            Field::real("hmin_time_step", Dimension::TIME).doc("smallest time step"),
            Field::real("hmax_time_step", Dimension::TIME).doc("largest time step"),
            Field::real("adaptivity", Dimension::NONE).doc("loosens the corrector at small steps"),
            Field::real("scale", Dimension::NONE)
                .many()
                .doc("weights of the error of displacements, angles and states"),
            Field::integer("kmax_integrator_order").doc("highest order"),
            Field::yes_no("interpolate").doc("interpolate at output times"),
            Field::choice("reconcile", &["all", "displacements", "none"])
                .doc("what is brought back onto the constraints at output times"),
            Field::real("repartition_threshold", Dimension::NONE)
                .doc("change at which independent coordinates are chosen anew"),
            Field::choice("corrector", &["original", "modified", "orig_constant"])
                .doc("test by which the corrector is said to have converged"),
            Field::real("alpha", Dimension::NONE).doc("numerical damping of HHT"),
            Field::real("beta", Dimension::NONE).doc("Newmark parameter beta"),
            Field::real("gamma", Dimension::NONE).doc("Newmark parameter gamma"),
            Field::integer("fixed_iterations").doc("iterations made in every step"),
            Field::integer("hratio").doc("ratio of output to integration step of the fixed-step integrator"),
            Field::real("max_error", Dimension::NONE).doc("error above which a step is refused"),
        ],
        rules: &[],
        doc: "how a run is integrated in time; one set for each model, made by the first use",
    }],
};
