//! Grids that follow an elastic line through others (RSPLINE).
//!
//! Beams of one tube join the grids in their order. What follows is where the beams would have it under the motions of all others:
//! `u_d = -K_dd⁻¹ K_di u_i`. Where the line is straight that is a cubic across it and a line along it, whatever the tube; around a corner
//! bending, twist and stretch would answer in a proportion that no manual gives, so lines that bend at grids that follow are refused.

use super::Dependent;
use crate::beam::{Beam, BeamPlacement};
use crate::element::Element;
use crate::model::Node;
use nalgebra::{DMatrix, Vector3};
use nastran::{BeamProperty, BeamStation, Expansion, InputError, Mat1, Rspline};

/// The most grids of one spline: its stiffness is a full matrix.
const MOST: usize = 300;
/// Sine of the largest angle by which a line may bend at a grid that follows.
const STRAIGHT: f64 = 1e-3;

/// The rows of an RSPLINE whose grids are at positions `grids` among the nodes, in their order.
///
/// # Errors
/// If it has more than 300 grids, its line bends at a grid that follows, or two grids are at one place.
pub(crate) fn spline(nodes: &[Node], card: &Rspline, grids: &[usize]) -> Result<Vec<Dependent>, InputError> {
    let owner = format!("RSPLINE {}", card.id);
    if grids.len() > MOST {
        let message = format!("{owner} has {} grids, more than {MOST}", grids.len());
        return Err(InputError::at(&card.span, message)
            .with_help("divide it at grids that are free, which changes nothing"));
    }
    let place = |at: usize| nodes[grids[at]].point;
    let segments: Vec<Vector3<f64>> = (1..grids.len()).map(|at| place(at) - place(at - 1)).collect();
    for (at, pair) in segments.windows(2).enumerate() {
        let bends = pair[0].cross(&pair[1]).norm() > STRAIGHT * pair[0].norm() * pair[1].norm()
            || pair[0].dot(&pair[1]) <= 0.0;
        let (grid, components) = &card.grids[at + 1];
        if bends && !components.is_empty() {
            let message = format!("{owner}: its line bends at GRID {grid}, which follows");
            return Err(InputError::at(&card.span, message)
                .with_help("let the grids at its corners be independent, or use RBE3"));
        }
    }
    let length_m: f64 = segments.iter().map(Vector3::norm).sum();
    let count = 6 * grids.len();
    let mut k = DMatrix::<f64>::zeros(count, count);
    for at in 1..grids.len() {
        let own = segment(card, [place(at - 1), place(at)], card.diameter * length_m)?;
        let mut block = k.view_mut((6 * at - 6, 6 * at - 6), (12, 12));
        block += own;
    }
    // From basic axes to those of each grid's displacements.
    let mut turn = DMatrix::<f64>::zeros(count, count);
    for (at, node) in grids.iter().enumerate() {
        for half in [0, 3] {
            turn.view_mut((6 * at + half, 6 * at + half), (3, 3)).copy_from(&nodes[*node].axes);
        }
    }
    let k = turn.transpose() * k * turn;
    let follows = |at: &usize| card.grids[at / 6].1.iter().any(|digit| usize::from(*digit) == at % 6 + 1);
    let (dependent, free): (Vec<usize>, Vec<usize>) = (0..count).partition(follows);
    let part = |columns: &[usize]| k.select_rows(&dependent).select_columns(columns);
    let held = part(&dependent).cholesky().ok_or_else(|| {
        InputError::at(&card.span, format!("{owner}: its grids do not determine what follows"))
    })?;
    let rows = -held.solve(&part(&free));
    let dof = |at: usize| 6 * grids[at / 6] + at % 6;
    let row = |(at, own): (usize, &usize)| {
        let factors = free.iter().enumerate().map(|(column, other)| (dof(*other), rows[(at, column)]));
        let row = factors.filter(|(_, factor)| factor.abs() > 1e-12).collect();
        Dependent { dof: dof(*own), row, owner: owner.clone(), span: card.span.clone() }
    };
    Ok(dependent.iter().enumerate().map(row).collect())
}

/// Stiffness of a thin tube between two places, in units of its bending stiffness.
fn segment(
    card: &Rspline,
    grids: [nalgebra::Point3<f64>; 2],
    diameter_m: f64,
) -> Result<DMatrix<f64>, InputError> {
    let span = card.span.clone();
    let station =
        BeamStation { area: 8.0 / diameter_m.powi(2), i1: 1.0, i2: 1.0, j: 2.0, ..BeamStation::default() };
    let property = BeamProperty {
        id: card.id,
        material: card.id,
        stations: vec![station],
        shear_factors: [0.0; 2],
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [[0.0; 2]; 2],
        is_beam: false,
        span: span.clone(),
    };
    let material =
        Mat1 { id: card.id, e: 1.0, g: 0.5, nu: 0.0, rho: 0.0, expansion: Expansion::default(), span };
    let along = grids[1] - grids[0];
    let orientation = if along.x.abs() < 0.9 * along.norm() { Vector3::x() } else { Vector3::y() };
    let placement =
        BeamPlacement { grids, offsets: [Vector3::zeros(); 2], orientation, pins: [Vec::new(), Vec::new()] };
    let beam = Beam::new(card.id, [0, 1], &placement, &property, &material, &card.span)?;
    Ok(beam.stiffness().map_or_else(|| DMatrix::zeros(12, 12), std::borrow::Cow::into_owned))
}
