//! The shell-and-solid wing that its file generates: counts, geometry and references of the mesh.

use crate::shell_mesh::{area_vector, centre, corner_jacobians, point, volume};
use coupling::planform::{
    BALANCE_GRID, FIRST_AXIS_GRID, MeshCounts, Mount, Planform, ROOT_GRID, ShellSolid, Structure,
};
use coupling::wing_file::WingFile;
use nalgebra::Vector3;
use nastran::{BulkData, MaterialDirection};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(file)
}

fn tuflex() -> WingFile {
    WingFile::read(&data("wing.ron")).unwrap_or_else(|error| panic!("{error}"))
}

fn shell(planform: &mut Planform) -> &mut ShellSolid {
    match &mut planform.structure {
        Some(Structure::ShellSolid(shell)) => shell,
        _ => panic!("wing.ron is no shell-and-solid wing"),
    }
}

/// The wing with its planform changed, in the tunnel.
fn changed(change: impl Fn(&mut Planform)) -> Result<BulkData, nastran::InputError> {
    let mut planform = tuflex().planform().expect("a parametric wing").clone();
    change(&mut planform);
    planform.bulk(&data(""), Mount::Tunnel)
}

/// Wings of other shapes, all with the shipped lay-up.
fn other_wings() -> Result<Vec<BulkData>, nastran::InputError> {
    Ok(vec![
        changed(|planform| shell(planform).mesh.thickness = 1)?,
        changed(|planform| {
            planform.quarter_chord_sweep_deg = -25.0;
            planform.dihedral_deg = 8.0;
            planform.twist_deg = (5.0, -7.0);
        })?,
        changed(|planform| {
            planform.quarter_chord_sweep_deg = 0.0;
            planform.tip_chord_m = 0.30;
            planform.boxes.chordwise = 5;
            planform.boxes.spanwise = 4;
            planform.boxes.strip_edges = Some(vec![0.0, 0.1, 0.4, 0.7, 1.0]);
            planform.controls.clear();
            let shell = shell(planform);
            shell.webs_over_c.truncate(1);
            shell.mesh.spanwise_per_strip = 3;
            shell.mesh.chordwise_per_box = 2;
        })?,
    ])
}

#[test]
fn the_paper_s_2016_solids_and_the_counts_of_the_readme_come_out() -> Outcome {
    let counts = MeshCounts::of(&tuflex().bulk(Mount::Tunnel)?);
    assert_eq!(counts.solids, 56 * 12 * 3);
    // Skins, closing faces, two webs, two ribs.
    assert_eq!(counts.shells, 2 * 56 * 12 + 2 * 56 * 3 + 2 * 56 * 3 + 2 * 12 * 3);
    // The block, the axis, root and balance, four masses and four sensors.
    assert_eq!(counts.grids, 57 * 13 * 4 + 57 + 2 + 8);
    assert_eq!((counts.averages, counts.masses), (56 + 8, 57 + 8));
    let readme = std::fs::read_to_string(data("README.md"))?;
    for count in [counts.grids, counts.shells, counts.solids] {
        assert!(readme.contains(&count.to_string()), "README.md does not mention {count}");
    }
    Ok(())
}

#[test]
fn half_the_element_size_is_a_setting() -> Outcome {
    let counts = MeshCounts::of(&changed(|planform| {
        let mesh = &mut shell(planform).mesh;
        (mesh.spanwise_per_strip, mesh.chordwise_per_box, mesh.thickness) = (2, 2, 6);
    })?);
    assert_eq!(counts.solids, 8 * 2016);
    assert_eq!(counts.shells, 4 * 2088);
    Ok(())
}

#[test]
fn span_stations_are_strip_edges_and_chord_lines_box_edges() -> Outcome {
    let wing = tuflex();
    let planform = wing.planform().ok_or("a parametric wing")?;
    let bulk = wing.bulk(Mount::Tunnel)?;
    let mesh = || bulk.solids.values().flat_map(|solid| &solid.grids).map(|&id| point(&bulk, id));
    let near = |value: f64, list: &[f64]| list.iter().any(|other| (value - other).abs() < 1e-12);
    let edges_m = planform.strip_edges_m();
    assert!(mesh().all(|point| near(point.y, &edges_m)));
    for &edge in &edges_m {
        // Hinge line and quarter chord are chord lines at every strip edge, the trailing edge is not.
        let on = |x_over_c: f64| {
            let place = planform.point(edge, x_over_c);
            mesh().any(|point| (point.y - edge).abs() < 1e-12 && (point.x - place.x).abs() < 1e-12)
        };
        assert!(on(0.75) && on(0.25) && on(0.01) && on(0.97) && !on(1.0) && !on(0.0), "y = {edge}");
    }
    Ok(())
}

#[test]
fn every_solid_has_a_positive_volume_at_each_corner() -> Outcome {
    for bulk in [vec![tuflex().bulk(Mount::Tunnel)?], other_wings()?].concat() {
        for solid in bulk.solids.values() {
            let corners = corner_jacobians(&bulk, solid);
            let mean = volume(&bulk, solid) / 8.0;
            assert!(corners.iter().all(|&corner| corner > 0.2 * mean), "CHEXA {}: {corners:?}", solid.id);
        }
    }
    Ok(())
}

#[test]
fn the_outer_shells_close_the_core_with_outward_normals() -> Outcome {
    for bulk in [vec![tuflex().bulk(Mount::Tunnel)?], other_wings()?].concat() {
        let is_web = |id: u32| (2_500_001..2_600_000).contains(&id);
        let outer = || bulk.shells.values().filter(|shell| !is_web(shell.id));
        for shell in outer() {
            // The one solid behind an outer shell lies against its normal.
            let behind: Vec<_> = bulk
                .solids
                .values()
                .filter(|solid| shell.grids.iter().all(|grid| solid.grids.contains(grid)))
                .collect();
            let [solid] = behind[..] else { panic!("shell {} covers {} solids", shell.id, behind.len()) };
            let outward = centre(&bulk, &shell.grids) - centre(&bulk, &solid.grids);
            assert!(area_vector(&bulk, shell).dot(&outward) > 0.0, "shell {} looks inward", shell.id);
        }
        // Gauss: a closed surface has no area vector, and encloses a third of its flux of place.
        let areas: f64 = outer().map(|shell| area_vector(&bulk, shell).norm()).sum();
        let vector: Vector3<f64> = outer().map(|shell| area_vector(&bulk, shell)).sum();
        assert!(vector.norm() < 1e-12 * areas);
        let flux: f64 = outer()
            .map(|shell| area_vector(&bulk, shell).dot(&centre(&bulk, &shell.grids).coords) / 3.0)
            .sum();
        let enclosed: f64 = bulk.solids.values().map(|solid| volume(&bulk, solid)).sum();
        // The centre of a warped facet is not exactly where its flux is.
        assert!((flux / enclosed - 1.0).abs() < 1e-4, "{flux} against {enclosed}");
    }
    Ok(())
}

#[test]
fn webs_stand_under_the_caps_and_at_the_hinge_line() -> Outcome {
    let wing = tuflex();
    let planform = wing.planform().ok_or("a parametric wing")?;
    let bulk = wing.bulk(Mount::Tunnel)?;
    let webs: Vec<_> =
        bulk.shells.values().filter(|shell| (2_500_001..2_600_000).contains(&shell.id)).collect();
    assert_eq!(webs.len(), 2 * 56 * 3);
    for (place, web) in webs.iter().enumerate() {
        let x_over_c = if place < 56 * 3 { 4.0 / 12.0 } else { 0.75 };
        for &grid in &web.grids {
            let at = point(&bulk, grid);
            assert!((at.x - planform.point(at.y, x_over_c).x).abs() < 1e-12);
        }
        assert!(area_vector(&bulk, web).x > 0.0);
    }
    Ok(())
}

/// Numbers of all elements, rigid ones and masses included: Nastran wants them different.
fn element_ids(bulk: &BulkData) -> Vec<u32> {
    let plain =
        bulk.shells.keys().chain(bulk.solids.keys()).chain(bulk.masses.keys()).chain(bulk.bushes.keys());
    let ties = bulk.rigid.keys().chain(bulk.averages.keys());
    let boxes = bulk.panels.keys().flat_map(|&first| first..first + 672);
    plain.chain(ties).copied().chain(boxes).collect()
}

#[test]
fn every_reference_is_there_and_no_number_is_given_twice() -> Outcome {
    let wing = tuflex();
    for bulk in [wing.bulk(Mount::Tunnel)?, wing.bulk(Mount::Aircraft)?] {
        let ids = element_ids(&bulk);
        assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
        let mut used = BTreeSet::new();
        for shell in bulk.shells.values() {
            assert!(bulk.laminates.contains_key(&shell.property));
            if let MaterialDirection::System(system) = shell.direction {
                assert!(bulk.coords.contains_key(&system));
            }
            used.extend(&shell.grids);
        }
        for laminate in bulk.laminates.values() {
            assert!(laminate.plies.iter().all(|ply| bulk.ply_materials.contains_key(&ply.material)));
        }
        for solid in bulk.solids.values() {
            assert!(bulk.materials.contains_key(&bulk.solid_properties[&solid.property].material));
            used.extend(&solid.grids);
        }
        for average in bulk.averages.values() {
            used.insert(&average.reference);
            used.extend(average.groups.iter().flat_map(|group| &group.grids));
        }
        for rigid in bulk.rigid.values() {
            used.insert(&rigid.independent);
            used.extend(&rigid.dependent);
        }
        for bush in bulk.bushes.values() {
            assert!(bulk.bush_properties.contains_key(&bush.property));
            used.extend([&bush.grids.0].into_iter().chain(bush.grids.1.as_ref()));
        }
        used.extend(bulk.masses.values().map(|mass| &mass.grid));
        used.extend(bulk.constraints.iter().flat_map(|card| &card.grids));
        used.extend(bulk.sets.values().flat_map(|set| &set.ids));
        assert!(used.iter().all(|id| bulk.grids.contains_key(id)), "a grid is missing");
        assert_eq!(used.len(), bulk.grids.len(), "a grid belongs to nothing");
    }
    Ok(())
}

#[test]
fn no_motion_depends_on_two_ties() -> Outcome {
    let wing = tuflex();
    for bulk in [wing.bulk(Mount::Tunnel)?, wing.bulk(Mount::Aircraft)?] {
        let dependent: Vec<u32> = bulk
            .rigid
            .values()
            .flat_map(|rigid| rigid.dependent.iter().copied())
            .chain(bulk.averages.values().map(|average| average.reference))
            .collect();
        let each: BTreeSet<u32> = dependent.iter().copied().collect();
        assert_eq!(each.len(), dependent.len());
        let followed =
            bulk.averages.values().flat_map(|average| average.groups.iter().flat_map(|group| &group.grids));
        assert!(followed.into_iter().all(|grid| !each.contains(grid)), "a mean of motions that are not free");
    }
    Ok(())
}

#[test]
fn the_balance_holds_the_root_rib_in_the_tunnel_and_nothing_does_in_flight() -> Outcome {
    let wing = tuflex();
    let tunnel = wing.bulk(Mount::Tunnel)?;
    let rib = tunnel.grids.values().filter(|grid| grid.id >= 1_000_001 && grid.xyz[1] == 0.0).count();
    assert_eq!(rib, 13 * 4);
    let rigid: Vec<_> = tunnel.rigid.values().collect();
    let [root] = rigid[..] else { panic!("one RBE2") };
    assert_eq!((root.independent, root.dependent.len()), (ROOT_GRID, rib + 1));
    assert!(root.dependent.contains(&FIRST_AXIS_GRID));
    for grid in [ROOT_GRID, BALANCE_GRID] {
        assert_eq!(tunnel.grids[&grid].xyz, [0.075, 0.0, 0.0].into());
    }
    assert_eq!(tunnel.constraints.len(), 1);
    assert_eq!(tunnel.constraints[0].grids, [BALANCE_GRID]);
    let [monitor] = &tunnel.monitors[..] else { panic!("one monitor point") };
    assert_eq!(tunnel.sets[&monitor.set.parse::<u32>()?].ids, [BALANCE_GRID]);

    let flight = wing.bulk(Mount::Aircraft)?;
    assert!(flight.constraints.is_empty() && flight.bushes.is_empty() && flight.monitors.is_empty());
    assert!(!flight.grids.contains_key(&BALANCE_GRID) && !flight.grids.contains_key(&ROOT_GRID));
    assert!(flight.rigid.values().all(|rigid| rigid.independent == FIRST_AXIS_GRID));
    Ok(())
}

#[test]
fn axis_and_sensors_are_where_the_beam_s_are() -> Outcome {
    let wing = tuflex();
    let beam = WingFile::read(&data("wing_beam.ron"))?;
    let (shell_bulk, beam_bulk) = (wing.bulk(Mount::Tunnel)?, beam.bulk(Mount::Tunnel)?);
    let sensors = wing.planform().ok_or("parametric")?.sensor_grids();
    assert_eq!(sensors, beam.planform().ok_or("parametric")?.sensor_grids());
    for (name, grid) in &sensors {
        let (at, beam_at) = (point(&shell_bulk, *grid), point(&beam_bulk, *grid));
        // On the shell wing a sensor is inside the section, not in the plane of the boxes.
        assert!((at - beam_at).xy().norm() < 1e-12, "{name}");
        assert!((0.0..0.1 * 0.3).contains(&at.z), "{name} at z = {}", at.z);
    }
    let axis = wing.spline_grid_ids(&shell_bulk);
    assert_eq!(axis.len(), 57);
    let ends =
        |grids: &[u32], bulk: &BulkData| [grids[0], grids[grids.len() - 1]].map(|grid| point(bulk, grid));
    let beam_axis = beam.spline_grid_ids(&beam_bulk);
    for (a, b) in ends(&axis, &shell_bulk).iter().zip(ends(&beam_axis, &beam_bulk)) {
        assert!((a - b).norm() < 1e-12);
    }
    Ok(())
}

#[test]
fn nose_up_twist_lifts_the_leading_edge_and_leaves_the_quarter_chord() -> Outcome {
    let mut planform = tuflex().planform().ok_or("parametric")?.clone();
    let flat = planform.section_point(1.8, 0.0, 0.0);
    planform.twist_deg = (0.0, 10.0);
    let turned = planform.section_point(1.8, 0.0, 0.0);
    let quarter = planform.point(1.8, 0.25);
    assert!((planform.section_point(1.8, 0.25, 0.0) - quarter).norm() < 1e-15);
    assert!((turned.z - flat.z - 0.25 * 0.15 * 10.0_f64.to_radians().sin()).abs() < 1e-15);
    assert!(((turned - quarter).norm() - (flat - quarter).norm()).abs() < 1e-15);
    Ok(())
}
