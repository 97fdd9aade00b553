//! The virtual wind tunnel keeps its promises: seeds, noise, a truth that differs where it says and nowhere else.
#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{Corrections, Flow};
use coupling::ByLoad;
use coupling::{ElasticWing, SteadyCase};
use std::path::{Path, PathBuf};
use tunnel::{Campaign, StaticRow, Truth, TruthSettings, TunnelFile, campaign};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

/// The shipped file, measuring static cases only.
fn shipped() -> TunnelFile {
    let mut file = TunnelFile::read(&data("tunnel.ron")).unwrap();
    file.runs.clear();
    file
}

fn measured(file: &TunnelFile, seed: u64) -> Campaign {
    campaign(file, &Truth::build(file).unwrap(), seed).unwrap()
}

/// A truth without any difference, for tests of noise alone.
fn plain() -> TunnelFile {
    let mut file = shipped();
    file.truth = TruthSettings::default();
    file
}

#[test]
fn the_same_seed_gives_the_same_files_and_another_seed_others() {
    let file = plain();
    let [first, again, other] = [7, 7, 8].map(|seed| measured(&file, seed));
    assert_eq!(first.files, again.files);
    assert_ne!(first.files, other.files);
}

#[test]
fn a_truth_without_differences_is_the_wing_of_the_file() {
    let file = plain();
    let truth = Truth::build(&file).unwrap();
    let (_, wing) = ElasticWing::read(&data("wing_beam.ron")).unwrap();
    let flow = Flow { v_m_s: 34.0, rho_kg_m3: file.rho_kg_m3 };
    let alphas = [-0.05, 0.0, 0.07];
    let cases = alphas.map(|alpha| SteadyCase::new(flow, alpha));
    let expected = wing.at(flow, &Corrections::neutral(wing.correctable.len())).unwrap().solve(&cases);
    for (state, expected) in truth.states(34.0, &alphas).unwrap().iter().zip(&expected) {
        for (a, b) in state.loads.to_array().iter().zip(expected.root.to_array()) {
            assert!((a - b).abs() <= 1e-12 * b.abs(), "{a} {b}");
        }
        assert!((state.tip_z_m - expected.tip_z_m).abs() < 1e-13);
    }
}

#[test]
fn the_shipped_truth_differs_in_lattice_structure_and_sections() {
    let truth = Truth::build(&shipped()).unwrap();
    let (_, model) = ElasticWing::read(&data("wing_beam.ron")).unwrap();
    let shape = |wing: &ElasticWing| (wing.lattice.surfaces[0].chordwise, wing.lattice.surfaces[0].spanwise);
    assert_eq!((shape(&model), shape(&truth.wing)), ((12, 56), (16, 44)));
    let nodes = |wing: &ElasticWing| wing.structure.as_ref().unwrap().0.node_count();
    assert_ne!(nodes(&model), nodes(&truth.wing));
    let mass = |wing: &ElasticWing| wing.structure.as_ref().unwrap().0.mass_properties().mass_kg;
    let change = mass(&truth.wing) / mass(&model) - 1.0;
    assert!(change.abs() > 1e-3 && change.abs() < 0.05, "mass changed by {change}");
    assert!(!truth.corrections(30.0).is_neutral());
    assert_ne!(truth.corrections(18.0), truth.corrections(40.0));
}

#[test]
fn control_surfaces_keep_their_place_on_another_lattice() {
    let truth = Truth::build(&shipped()).unwrap();
    let (_, model) = ElasticWing::read(&data("wing_beam.ron")).unwrap();
    let area = |wing: &ElasticWing, control: usize| -> f64 {
        wing.controls[control].boxes.iter().map(|&j| wing.lattice.boxes[j].area_m2()).sum()
    };
    for control in 0..3 {
        let (a, b) = (area(&model, control), area(&truth.wing, control));
        assert!((a - b).abs() < 1e-12, "{}: {a} and {b} m2", model.controls[control].name);
    }
}

/// Rows of wind-on points.
fn wind_on(campaign: &Campaign) -> impl Iterator<Item = &StaticRow> {
    campaign.rows.iter().filter(|row| row.v_m_s > 0.0)
}

#[test]
fn the_scatter_of_replicates_is_the_declared_noise() {
    let mut file = plain();
    file.statics.blocks.replicates = vec![("only".to_owned(), 40)];
    let campaign = measured(&file, 3);
    let rows: Vec<&StaticRow> = wind_on(&campaign).collect();
    let cells = file.statics.airspeeds_m_s.len() * file.statics.angles_deg.len();
    assert_eq!(rows.len(), 40 * cells);
    for (c, sigma) in file.noise.static_point.to_array().into_iter().enumerate() {
        let mut squares = 0.0;
        for cell in 0..cells {
            let values: Vec<f64> = (0..40).map(|i| rows[i * cells + cell].loads.to_array()[c]).collect();
            let mean = values.iter().sum::<f64>() / 40.0;
            squares += values.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
        }
        // Chi-square over its degrees of freedom: mean 1, standard deviation sqrt(2/dof); four of them.
        let dof = (39 * cells) as f64;
        let ratio = squares / dof / sigma.powi(2);
        assert!((ratio - 1.0).abs() < 4.0 * (2.0 / dof).sqrt(), "channel {c}: {ratio}");
    }
}

#[test]
fn a_block_adds_one_offset_of_the_declared_size_to_all_its_airspeeds() {
    const BLOCKS: usize = 300;
    let mut file = plain();
    file.statics.airspeeds_m_s = vec![18.0, 40.0];
    file.statics.angles_deg = vec![0.0];
    file.statics.blocks.replicates = (0..BLOCKS).map(|i| (format!("b{i}"), 1)).collect();
    file.noise.static_point = ByLoad::from_array([1e-9; 3]);
    let campaign = measured(&file, 5);
    let truth = Truth::build(&file).unwrap();
    let clean = [18.0, 40.0].map(|v| truth.states(v, &[0.0]).unwrap()[0].loads.to_array());
    let rows: Vec<&StaticRow> = wind_on(&campaign).collect();
    for (c, sigma) in file.statics.blocks.offset_sigma.to_array().into_iter().enumerate() {
        let mut squares = 0.0;
        for pair in rows.chunks(2) {
            let offsets = [0, 1].map(|i| pair[i].loads.to_array()[c] - clean[i][c]);
            assert!((offsets[0] - offsets[1]).abs() < 2e-8, "{offsets:?}");
            squares += offsets[0].powi(2);
        }
        let ratio = squares / BLOCKS as f64 / sigma.powi(2);
        assert!((ratio - 1.0).abs() < 4.0 * (2.0 / BLOCKS as f64).sqrt(), "channel {c}: {ratio}");
    }
}

#[test]
fn weight_tares_hold_weight_alone() {
    let file = shipped();
    let campaign = measured(&file, 1);
    let sigma = file.noise.static_point.to_array();
    let tares: Vec<&StaticRow> = campaign.rows.iter().filter(|row| row.v_m_s == 0.0).collect();
    assert_eq!(tares.len(), file.statics.tilt_deg.len() * file.statics.blocks.replicates.len());
    for row in tares.iter().filter(|row| row.alpha_deg == 0.0) {
        for (load, sigma) in row.loads.to_array().iter().zip(sigma) {
            assert!(load.abs() < 5.0 * sigma, "{row:?}");
        }
    }
}

/// Largest distance of the truth's Fz from its own straight line in alpha over the shipped angles, N.
fn off_line(truth: &Truth, v_m_s: f64) -> f64 {
    let alphas = [-4.0_f64, -2.0, 0.0, 2.0, 4.0].map(f64::to_radians);
    let fz: Vec<f64> = truth.states(v_m_s, &alphas).unwrap().iter().map(|s| s.loads.fz_n).collect();
    let mean = fz.iter().sum::<f64>() / 5.0;
    let slope =
        fz.iter().zip(alphas).map(|(f, a)| f * a).sum::<f64>() / alphas.iter().map(|a| a * a).sum::<f64>();
    fz.iter().zip(alphas).map(|(f, a)| (f - mean - slope * a).abs()).fold(0.0, f64::max)
}

#[test]
fn only_sections_with_curvature_leave_the_straight_line() {
    let straight = Truth::build(&shipped()).unwrap();
    let curved = Truth::build(&TunnelFile::read(&data("tunnel_curved.ron")).unwrap()).unwrap();
    let noise = shipped().noise.static_point.fz;
    for v_m_s in [18.0, 30.0] {
        // What is left is the weight's 1 - cos(alpha).
        assert!(off_line(&straight, v_m_s) < noise);
        assert!(off_line(&curved, v_m_s) > 10.0 * noise);
    }
}

#[test]
fn curvature_without_a_share_of_the_polars_changes_nothing() {
    let mut file = shipped();
    if let Some(sections) = &mut file.truth.sections {
        sections.polar_share = 0.0;
    }
    let straight = Truth::build(&file).unwrap().states(22.0, &[0.05]).unwrap()[0];
    file.curvature = true;
    let curved = Truth::build(&file).unwrap().states(22.0, &[0.05]).unwrap()[0];
    assert!((straight.loads - curved.loads).fz_n.abs() < 1e-9);
    assert!((straight.tip_z_m - curved.tip_z_m).abs() < 1e-12);
}

#[test]
fn strips_that_do_not_fit_the_control_surfaces_are_refused() {
    let mut file = shipped();
    let mesh = file.truth.mesh.as_mut().unwrap();
    mesh.strips.pop();
    let message = Truth::build(&file).unwrap_err().to_string();
    assert!(message.contains("strips has 4 numbers, expected 5"), "{message}");
    let mesh = file.truth.mesh.as_mut().unwrap();
    mesh.strips.push(3);
    mesh.chordwise = 10;
    let message = Truth::build(&file).unwrap_err().to_string();
    assert!(message.contains("the hinge of inner is on no edge"), "{message}");
}
