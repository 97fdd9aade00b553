//! Which nodes count at a station, and with which arms.

use super::*;
use crate::small::goland;

/// Rows by single degrees of freedom: what a unit force or moment there gives.
fn momentum<'a>(system: &'a System, units: &'a Mat<f64>) -> Momentum<'a> {
    Momentum { system, fields: units.as_ref(), modes: units.as_ref() }
}

#[test]
fn what_lies_outboard_of_a_station_counts_with_its_arms_and_what_lies_on_it_does_not() {
    let wing = goland().elastic;
    let system = &wing.structure.as_ref().expect("a beam").0;
    let points = system.points();
    let units = Mat::identity(6 * points.len(), 6 * points.len());
    let momentum = momentum(system, &units);
    // on a node, and a hair before it
    for (y, first) in [(points[2].y, 3), (points[2].y - 1e-6, 2)] {
        let at = Point3::new(0.1, y, 0.2);
        let station = Station { name: "mid".into(), point: at };
        let rows = LoadRows::station(&wing, &station, Some(&momentum), units.ncols());
        assert_eq!(rows.names, ["Fz_mid_N", "Mx_mid_Nm", "My_mid_Nm"]);
        for (node, point) in points.iter().enumerate() {
            // Fz, Mx, My of unit forces along x, y, z and moments about them
            let arm = point - at;
            let of = [
                [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
                [0.0, -arm.z, arm.y, 1.0, 0.0, 0.0],
                [arm.z, 0.0, -arm.x, 0.0, 1.0, 0.0],
            ];
            for (row, of) in of.into_iter().enumerate() {
                for (dof, wanted) in of.into_iter().enumerate() {
                    let wanted = if node >= first { wanted } else { 0.0 };
                    let found = rows.by_fields[(row, 6 * node + dof)];
                    assert!(
                        (found - wanted).abs() < 1e-12,
                        "node {node}, row {row}, {dof}: {found} {wanted}"
                    );
                    assert_eq!(rows.by_modes[(row, 6 * node + dof)], found);
                }
            }
        }
        // boxes outboard alone, along their normals
        for (j, panel) in wing.lattice.boxes.iter().enumerate() {
            let counts = f64::from(u8::from(panel.mid_point().y > y));
            assert!((rows.air[(0, 2 * j)] - counts).abs() < 1e-12, "box {j}");
        }
    }
}

#[test]
fn the_balance_has_all_nodes_and_stacked_rows_keep_their_order() {
    let wing = goland().elastic;
    let system = &wing.structure.as_ref().expect("a beam").0;
    let units = Mat::identity(6 * system.points().len(), 6 * system.points().len());
    let momentum = momentum(system, &units);
    let balance = LoadRows::balance(&wing, Some(&momentum), units.ncols());
    assert_eq!(balance.names, ["Fz_N", "Mx_Nm", "My_Nm"]);
    for (node, point) in system.points().iter().enumerate() {
        let arm = point - wing.balance.point;
        let found: [f64; 3] = std::array::from_fn(|row| balance.by_fields[(row, 6 * node + 2)]);
        for (found, wanted) in found.into_iter().zip([1.0, arm.y, -arm.x]) {
            assert!((found - wanted).abs() < 1e-12, "node {node}");
        }
    }
    let still = LoadRows::balance(&wing, None, 3);
    assert_eq!((still.by_fields.nrows(), still.by_fields.ncols(), still.by_modes.ncols()), (3, 3, 0));
    assert_eq!(still.by_fields.norm_max(), 0.0);
    let strips = LoadRows::strips(&wing, units.ncols(), units.ncols());
    assert_eq!(strips.names, [1, 2, 3, 4].map(|strip| format!("lift_strip_{strip}_N_m")));
    let stacked = LoadRows::stacked(&[balance.clone(), strips.clone()]);
    assert_eq!((stacked.names[2].as_str(), stacked.names[3].as_str()), ("My_Nm", "lift_strip_1_N_m"));
    let parts = [
        (&stacked.air, &balance.air, &strips.air),
        (&stacked.by_fields, &balance.by_fields, &strips.by_fields),
    ];
    for (all, first, second) in
        parts.into_iter().chain([(&stacked.by_modes, &balance.by_modes, &strips.by_modes)])
    {
        assert_eq!((all.nrows(), all.ncols()), (7, first.ncols()));
        assert!(all.subrows(0, 3) == first.as_ref() && all.subrows(3, 4) == second.as_ref());
    }
    // a newton on a box of a strip 1.524 m wide
    assert!((strips.air[(1, 4)] - 1.0 / 1.524).abs() < 1e-9 && strips.air[(1, 0)] == 0.0);
    assert_eq!(strips.by_fields.norm_max() + strips.by_modes.norm_max(), 0.0);
}

#[test]
fn stations_of_a_wing_stand_at_the_balance_where_the_file_does_not_say() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let mut file = WingFile::read(&path).expect("the shipped wing");
    let at = |name: &str, x_m, z_m| StationAt { name: name.into(), y_m: 0.7, x_m, z_m };
    file.stations = vec![at("own", Some(0.3), Some(-0.1)), at("left out", None, None)];
    let stations = Station::of_wing(&file);
    assert_eq!((stations[0].name.as_str(), stations[0].point), ("own", Point3::new(0.3, 0.7, -0.1)));
    assert_eq!(stations[1].point, Point3::new(file.balance.x_m, 0.7, file.balance.z_m));
    assert_eq!(stations.len(), 2);
}
