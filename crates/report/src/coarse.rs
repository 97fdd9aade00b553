//! Surfaces of many faces, coarser for pictures: a page with hundreds of thousands of them does not turn.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Point3, Vector3};

/// Faces that a picture may have; the eye tells no more apart.
const FACES: usize = 6000;
/// Cells along the longest extent with which is begun, and by how many fewer there are at each further try.
const CELLS: f64 = 128.0;
const FEWER: f64 = 0.8;

/// The faces (corners are positions in `points`, m), or, of too many, as few as a picture takes: their corners drawn together in cubes, each at the node that is nearest to the
/// middle of its nodes (Rossignac and Borrel, *Multi-resolution 3D approximations for rendering complex scenes*, 1993). What then has no
/// area, or is there already, is left out.
pub fn coarse(points: &[Point3<f64>], faces: Vec<[usize; 4]>) -> Vec<[usize; 4]> {
    let mut cells = CELLS;
    let mut fewer = faces;
    while fewer.len() > FACES && cells > 1.0 {
        let drawn_to = drawn_together(points, &fewer, cells);
        let mut seen = BTreeSet::new();
        let moved = fewer.iter().map(|face| face.map(|node| drawn_to[&node]));
        let kept = moved.filter(|face| {
            let corners: BTreeSet<usize> = face.iter().copied().collect();
            corners.len() > 2 && seen.insert(corners)
        });
        fewer = kept.collect();
        cells *= FEWER;
    }
    fewer
}

/// For each node of the faces the one that stands for its cube.
fn drawn_together(points: &[Point3<f64>], faces: &[[usize; 4]], cells: f64) -> BTreeMap<usize, usize> {
    let nodes: BTreeSet<usize> = faces.iter().flatten().copied().collect();
    let bound = |axis: usize, pick: fn(f64, f64) -> f64, from: f64| {
        nodes.iter().map(|node| points[*node][axis]).fold(from, pick)
    };
    let low: [f64; 3] = std::array::from_fn(|axis| bound(axis, f64::min, f64::INFINITY));
    let extent = (0..3).map(|axis| bound(axis, f64::max, f64::NEG_INFINITY) - low[axis]).fold(0.0, f64::max);
    let cube = |node: usize| -> [i64; 3] {
        std::array::from_fn(|axis| {
            #[expect(clippy::cast_possible_truncation, reason = "at most as many as there are cells")]
            let at = ((points[node][axis] - low[axis]) / extent * cells).floor() as i64;
            at
        })
    };
    let mut of_cube: BTreeMap<[i64; 3], Vec<usize>> = BTreeMap::new();
    for node in &nodes {
        of_cube.entry(cube(*node)).or_default().push(*node);
    }
    let mut drawn_to = BTreeMap::new();
    for group in of_cube.values() {
        let sum = group.iter().fold(Vector3::zeros(), |sum, node| sum + points[*node].coords);
        let middle = Point3::from(sum / group.len() as f64);
        let away = |node: &usize| (points[*node] - middle).norm_squared();
        let nearest = group.iter().copied().min_by(|a, b| away(a).total_cmp(&away(b)));
        drawn_to.extend(group.iter().map(|node| (*node, nearest.unwrap_or(*node))));
    }
    drawn_to
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square sheet of `n` by `n` faces.
    fn sheet(n: usize) -> (Vec<Point3<f64>>, Vec<[usize; 4]>) {
        let at = |i: usize, j: usize| i * (n + 1) + j;
        let point = |k: usize| Point3::new((k / (n + 1)) as f64, (k % (n + 1)) as f64, 0.0);
        let face = |k: usize| {
            let (i, j) = (k / n, k % n);
            [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
        };
        ((0..(n + 1) * (n + 1)).map(point).collect(), (0..n * n).map(face).collect())
    }

    fn area(points: &[Point3<f64>], face: &[usize; 4]) -> f64 {
        let [a, b, c, d] = face.map(|node| points[node]);
        0.5 * (c - a).cross(&(d - b)).norm()
    }

    #[test]
    fn few_faces_stay_and_many_become_few_that_cover_the_same() {
        let (points, faces) = sheet(70);
        assert_eq!(coarse(&points, faces.clone()), faces);
        let (points, faces) = sheet(250);
        let fewer = coarse(&points, faces);
        assert!(fewer.len() <= FACES && fewer.len() > FACES / 4, "{}", fewer.len());
        let covered: f64 = fewer.iter().map(|face| area(&points, face)).sum();
        assert!((covered / (250.0 * 250.0) - 1.0).abs() < 0.05, "{covered}");
        let corners: BTreeSet<BTreeSet<usize>> =
            fewer.iter().map(|face| face.iter().copied().collect()).collect();
        assert_eq!(corners.len(), fewer.len(), "none twice");
        assert!(corners.iter().all(|face| face.len() > 2));
    }
}
