//! Curved shells' geometry.

use super::*;

/// A flat shell without grids on its sides.
fn flat(corners: &[[f64; 3]]) -> CurvedShell {
    let section = ShellSection::laminate(&[], 1.0, crate::laminate::ShearModel::Factor(1.0));
    let place = CurvedPlace {
        nodes: (0..corners.len()).collect(),
        points: corners.iter().copied().map(Point3::from).collect(),
        sides: Vec::new(),
        offset_m: 0.0,
    };
    let axis = SectionAxis::Angle(0.0);
    CurvedShell::new(1, place, Arc::new(section), axis, &Span::generated("test")).expect("a possible shell")
}

#[test]
fn at_the_middle_all_corners_count_alike() {
    let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    for corners in [&square[..3], &square[..]] {
        let shell = flat(corners);
        let values = shell.functions(shell.middle()).values;
        let expected = 1.0 / corners.len() as f64;
        assert!(values.iter().all(|value| (value - expected).abs() < 1e-15), "{values:?}");
    }
}
