//! Orientations in the 24 rotation sequences.

use flexure_commands::Interpreter;
use glam::{DMat3, DVec3};

const ORDERS: [&str; 12] = ["123", "231", "312", "132", "213", "321", "121", "131", "212", "232", "313", "323"];

/// Twin: products of elementary rotations of another library. Body-fixed turns are applied from the
/// left to the right, space-fixed ones from the right to the left.
#[test]
fn orientations_are_read_in_every_sequence() {
    let angles = [20.0_f64, -35.0, 70.0];
    for kind in ["body", "space"] {
        for order in ORDERS {
            let mut i = Interpreter::new(elements::registry());
            let report = i.run_text(
                "test",
                &format!(
                    "model create model_name = m\ndefaults units orientation_type = {kind}{order}\n\
                     marker create marker_name = .m.ground.k orientation = 20, -35, 70"
                ),
            );
            assert!(!report.has_errors(), "{:?}", report.diagnostics);
            let turns: Vec<DMat3> = order
                .bytes()
                .zip(angles)
                .map(|(axis, angle)| {
                    let axis = [DVec3::X, DVec3::Y, DVec3::Z][usize::from(axis - b'1')];
                    DMat3::from_axis_angle(axis, angle.to_radians())
                })
                .collect();
            let wanted = if kind == "body" { turns[0] * turns[1] * turns[2] } else { turns[2] * turns[1] * turns[0] };
            let id = i.database.find(".m.ground.k", "marker").unwrap();
            let found = i.database.global_pose(id).rotation;
            // Rounding of a few products and of the angles taken back from the matrix.
            assert!(found.abs_diff_eq(wanted, 1e-14), "{kind}{order}: {found} is not {wanted}");
        }
    }
}
