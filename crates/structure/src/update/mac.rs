//! The modal assurance criterion: how alike two shapes are, whatever their scale (Allemang and Brown 1982).

/// (a b)^2 / (a a)(b b): 1 for the same shape, 0 for orthogonal ones. Zero if one of them is zero.
///
/// # Panics
/// If they have different lengths.
pub fn modal_assurance(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "two shapes at the same places");
    let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    let size = dot(a, a) * dot(b, b);
    if size > 0.0 { dot(a, b).powi(2) / size } else { 0.0 }
}

/// Pairs rows (measured) with columns (model), the best agreement first; each column once, none below `least`.
/// `fixed` are pairs that are given.
pub(super) fn pair(assurance: &[Vec<f64>], fixed: &[Option<usize>], least: f64) -> Vec<Option<usize>> {
    let mut pairs = fixed.to_vec();
    let mut candidates = Vec::new();
    for (row, values) in assurance.iter().enumerate().filter(|(row, _)| fixed[*row].is_none()) {
        candidates.extend(values.iter().enumerate().map(|(column, value)| (*value, row, column)));
    }
    // Stable: of equal agreement the first pair.
    candidates.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (value, row, column) in candidates {
        if value >= least && pairs[row].is_none() && !pairs.contains(&Some(column)) {
            pairs[row] = Some(column);
        }
    }
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_agrees_with_itself_in_any_scale_and_not_with_an_orthogonal_one() {
        let (a, b) = ([1.0, 2.0, -0.5], [2.0, -1.0, 0.0]);
        assert!((modal_assurance(&a, &a.map(|v| -3.0 * v)) - 1.0).abs() < 1e-15);
        assert!(modal_assurance(&a, &b).abs() < 1e-30);
        assert!(modal_assurance(&a, &[0.0; 3]).abs() < 1e-30);
    }

    #[test]
    fn swapped_modes_are_paired_by_their_shapes() {
        let assurance = vec![vec![0.1, 0.95, 0.3], vec![0.9, 0.92, 0.0], vec![0.0, 0.1, 0.4], vec![]];
        let pairs = pair(&assurance, &[None, None, None, Some(2)], 0.6);
        assert_eq!(pairs, [Some(1), Some(0), None, Some(2)]);
    }
}
