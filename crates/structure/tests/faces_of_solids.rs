//! Pressures on the faces of solids of every kind: they push against the face's outer normal, whichever sense the
//! grids run in, and a
//! closed surface carries no resultant.

use nalgebra::Vector3;
use nastran::{BulkData, parse_deck};
use structure::nonlinear::{Following, LargeDeflection, Loads, State};
use structure::{Model, loads_of};

/// A solid: its corners, the edges' ends in the order of the card, its faces with the grids that PLOAD4 names, G1 and
/// G3.
struct Kind {
    name: &'static str,
    corners: Vec<[f64; 3]>,
    edges: &'static [[usize; 2]],
    /// Corners of a face, then G1 and G3 (from one).
    faces: Vec<(Vec<usize>, usize, Option<usize>)>,
}

fn kinds() -> [Kind; 3] {
    let layers = |flat: &[[f64; 2]]| -> Vec<[f64; 3]> {
        let at = |(z, [x, y]): (f64, [f64; 2])| [x + 0.3 * z, y - 0.2 * z, z + 0.1 * x];
        [0.0, 1.5].iter().flat_map(|z| flat.iter().map(move |own| at((*z, *own)))).collect()
    };
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
    [
        Kind {
            name: "CTETRA",
            corners: vec![[0.1, 0.2, 0.3], [1.3, 0.1, 0.4], [0.2, 0.9, 0.2], [0.4, 0.3, 1.5]],
            edges: crate::meshed::TETRA,
            faces: vec![
                (vec![0, 1, 2], 1, Some(4)),
                (vec![0, 1, 3], 2, Some(3)),
                (vec![1, 2, 3], 4, Some(1)),
                (vec![0, 2, 3], 3, Some(2)),
            ],
        },
        Kind {
            name: "CPENTA",
            corners: layers(&[square[0], square[1], square[3]]),
            edges: crate::meshed::WEDGE,
            faces: vec![
                (vec![0, 1, 2], 2, None),
                (vec![3, 4, 5], 4, None),
                (vec![0, 1, 4, 3], 1, Some(5)),
                (vec![1, 2, 5, 4], 6, Some(2)),
                (vec![2, 0, 3, 5], 4, Some(3)),
            ],
        },
        Kind {
            name: "CHEXA",
            corners: layers(&square),
            edges: crate::meshed::HEXA,
            faces: vec![
                (vec![0, 1, 2, 3], 1, Some(3)),
                (vec![4, 5, 6, 7], 6, Some(8)),
                (vec![0, 1, 5, 4], 5, Some(2)),
                (vec![1, 2, 6, 5], 2, Some(7)),
                (vec![2, 3, 7, 6], 8, Some(3)),
                (vec![3, 0, 4, 7], 4, Some(5)),
            ],
        },
    ]
}

/// A deck of one solid, its second layer of grids first if it is reversed, with grids on its edges or not.
fn deck(kind: &Kind, order: &[usize], with_edges: bool, loads: &str) -> BulkData {
    let middles = kind.edges.iter().map(|[a, b]| {
        let (a, b) = (Vector3::from(kind.corners[order[*a]]), Vector3::from(kind.corners[order[*b]]));
        (a + b) * 0.5
    });
    let corners = order.iter().map(|at| Vector3::from(kind.corners[*at]));
    let places: Vec<Vector3<f64>> =
        if with_edges { corners.chain(middles).collect() } else { corners.collect() };
    let grid = |(at, p): (usize, &Vector3<f64>)| {
        format!("GRID*,{},,{:.12},{:.12}\n*,{:.12}\n", at + 1, p.x, p.y, p.z)
    };
    let grids: String = places.iter().enumerate().map(grid).collect();
    let ids: Vec<String> = [1, 1].into_iter().chain(1..=places.len()).map(|id| id.to_string()).collect();
    let lines: Vec<String> = ids.chunks(8).map(|line| line.join(",")).collect();
    let text = format!("{grids}{},{}\nPSOLID,1,1\nMAT1,1,7.+10,,.3\n{loads}", kind.name, lines.join("\n,"));
    parse_deck("test.bdf", &text).unwrap_or_else(|error| panic!("{error}"))
}

/// Half the sum of cross products around: a face's area along its normal.
fn area(corners: &[Vector3<f64>]) -> Vector3<f64> {
    let n = corners.len();
    (0..n).map(|at| corners[at].cross(&corners[(at + 1) % n])).sum::<Vector3<f64>>() * 0.5
}

#[test]
fn pressures_push_into_solids_of_every_kind_and_sense() {
    for kind in kinds() {
        let n = kind.corners.len();
        let same: Vec<usize> = (0..n).collect();
        // The upper layer first, or two corners of a tetrahedron exchanged: the other sense.
        let other: Vec<usize> =
            if n == 4 { vec![1, 0, 2, 3] } else { (0..n).map(|at| (at + n / 2) % n).collect() };
        for (order, with_edges) in [(&same, false), (&other, false), (&same, true), (&other, true)] {
            let what = format!("{} {order:?} {with_edges}", kind.name);
            let mut sum = (Vector3::zeros(), Vector3::zeros());
            for (face, corner, opposite) in &kind.faces {
                let third = opposite.map_or(String::new(), |grid| grid.to_string());
                let bulk = deck(&kind, order, with_edges, &format!("PLOAD4,1,1,8.,,,,{corner},{third}\n"));
                let loads = loads_of(&bulk, 1).unwrap_or_else(|error| panic!("{what}: {error}"));
                let wing =
                    LargeDeflection::new(&Model::from_bulk(&bulk).expect("a model")).expect("a structure");
                let state = wing.undeformed();
                let forces = wing.load_forces(&state, &loads);
                let at = |node: usize| Vector3::from_column_slice(&forces[6 * node..6 * node + 3]);
                let whole: Vector3<f64> = (0..state.places.len()).map(at).sum();
                let corners: Vec<Vector3<f64>> = face.iter().map(|node| state.places[*node]).collect();
                let middle = corners.iter().sum::<Vector3<f64>>() / corners.len() as f64;
                let out = middle - state.places[..n].iter().sum::<Vector3<f64>>() / n as f64;
                let normal = area(&corners);
                let expected = normal * (-8.0 * normal.dot(&out).signum());
                assert!((whole - expected).norm() < 1e-9, "{what}, face {face:?}: {whole} for {expected}");
                let pushed = (0..n).filter(|node| !face.contains(node)).map(|node| at(node).norm());
                assert!(pushed.fold(0.0, f64::max) < 1e-12, "{what}: no other corner");
                sum.0 += whole;
                sum.1 += (0..state.places.len())
                    .map(|node| state.places[node].cross(&at(node)))
                    .sum::<Vector3<f64>>();
            }
            assert!(sum.0.norm() < 1e-9 && sum.1.norm() < 1e-9, "{what}: {} {}", sum.0, sum.1);
        }
    }
}

#[test]
fn grids_that_name_no_face_are_refused() {
    let [tetra, penta, hexa] = kinds();
    for (kind, grids) in [
        (&tetra, "1,1"),
        (&tetra, "1,9"),
        (&penta, "1,2"),
        (&penta, "1,4"),
        (&hexa, "1,2"),
        (&hexa, "1,7"),
        (&hexa, "1"),
        (&hexa, "9,1"),
    ] {
        let order: Vec<usize> = (0..kind.corners.len()).collect();
        let bulk = deck(kind, &order, false, &format!("GRID,9\nPLOAD4,1,1,8.,,,,{grids}\n"));
        let error = loads_of(&bulk, 1).expect_err("refused").to_string();
        assert!(error.contains("name no face of a solid 1"), "{} {grids}: {error}", kind.name);
    }
}

/// A state of as many nodes as places.
fn state(places: &[Vector3<f64>]) -> State {
    State { places: places.to_vec(), rotations: vec![nalgebra::Rotation3::identity(); places.len()] }
}

/// The resultant of a uniform pressure hangs on the rim alone: the integral of r x dr / 2 around it, of sides of
/// second degree by
/// Simpson's rule.
#[test]
fn pressure_on_a_curved_face_has_the_resultant_of_its_rim() {
    let deck = "GRID,1\nGRID,2,,1.\nCROD,1,1,1,2\nPROD,1,1,1.\nMAT1,1,1.,,.3\n";
    let wing = LargeDeflection::new(
        &Model::from_bulk(&parse_deck("t.bdf", deck).expect("a deck")).expect("a model"),
    );
    let wing = wing.expect("a structure");
    let corners = [[0.0, 0.0, 0.1], [2.0, 0.1, 0.0], [2.2, 1.4, 0.3], [0.1, 1.2, 0.0]].map(Vector3::from);
    for count in [4, 3] {
        let corners = &corners[..count];
        let bulge = |at: usize| Vector3::new(0.05 * at as f64, -0.1, 0.2 - 0.05 * at as f64);
        let middle = |at: usize| (corners[at] + corners[(at + 1) % count]) * 0.5 + bulge(at);
        let places: Vec<Vector3<f64>> = corners.iter().copied().chain((0..count).map(middle)).collect();
        let rim: Vector3<f64> = (0..count)
            .map(|at| {
                let [a, m, b] = [places[at], places[count + at], places[(at + 1) % count]];
                // Slopes of the parabola through a, m and b at its ends and its middle, over 0 to 1.
                let slopes = [m * 4.0 - a * 3.0 - b, b - a, b * 3.0 + a - m * 4.0];
                (a.cross(&slopes[0]) + m.cross(&slopes[1]) * 4.0 + b.cross(&slopes[2])) / 12.0
            })
            .sum();
        let face: Vec<usize> = (0..2 * count).collect();
        let loads = |pascal: Vec<f64>| Loads {
            following: vec![Following::Pressure { face: face.clone(), pascal }],
            ..Loads::default()
        };
        let forces = wing.load_forces(&state(&places), &loads(vec![5.0; count]));
        let whole: Vector3<f64> =
            forces.chunks_exact(6).map(|six| Vector3::from_column_slice(&six[..3])).sum();
        assert!((whole - rim * 5.0).norm() < 1e-12, "{count} corners: {whole} for {}", rim * 5.0);
        // Twice the load, and two loads.
        let twice = wing.load_forces(&state(&places), &loads(vec![5.0; count]).times(2.0));
        let both = wing.load_forces(&state(&places), &loads(vec![2.0; count]).and(&loads(vec![8.0; count])));
        for (one, (twice, both)) in forces.iter().zip(twice.iter().zip(&both)) {
            assert!((2.0 * one - twice).abs() < 1e-12 && (2.0 * one - both).abs() < 1e-12);
        }
    }
}

/// On flat faces with grids on their sides: a twelfth of the load against it at corners and a third at sides; of a
/// triangle a third at sides.
#[test]
fn flat_faces_share_a_pressure_as_their_functions_integrate() {
    let deck = "GRID,1\nGRID,2,,1.\nCROD,1,1,1,2\nPROD,1,1,1.\nMAT1,1,1.,,.3\n";
    let wing = LargeDeflection::new(
        &Model::from_bulk(&parse_deck("t.bdf", deck).expect("a deck")).expect("a model"),
    );
    let wing = wing.expect("a structure");
    let square =
        [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0], [1.5, 0.0], [3.0, 1.0], [1.5, 2.0], [0.0, 1.0]];
    let triangle = [[0.0, 0.0], [3.0, 0.0], [0.0, 2.0], [1.5, 0.0], [1.5, 1.0], [0.0, 1.0]];
    let shares = |places: &[[f64; 2]], pascal: &[f64]| -> Vec<f64> {
        let places: Vec<Vector3<f64>> = places.iter().map(|[x, y]| Vector3::new(*x, *y, 0.4)).collect();
        let following =
            vec![Following::Pressure { face: (0..places.len()).collect(), pascal: pascal.to_vec() }];
        let forces = wing.load_forces(&state(&places), &Loads { following, ..Loads::default() });
        forces.chunks_exact(6).map(|six| six[2]).collect()
    };
    let near = |own: Vec<f64>, expected: &[f64]| {
        assert!(own.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{own:?} for {expected:?}");
    };
    near(shares(&square, &[2.0; 4]), &[[-1.0; 4], [4.0; 4]].concat());
    near(shares(&triangle, &[2.0; 3]), &[0.0, 0.0, 0.0, 2.0, 2.0, 2.0]);
    near(shares(&square[..4], &[2.0; 4]), &[3.0; 4]);
    near(shares(&triangle[..3], &[2.0; 3]), &[2.0; 3]);
    // Linear: 6 to 0 along x on 3 by 2, in sixths and thirds of the sides.
    near(shares(&square[..4], &[6.0, 0.0, 0.0, 6.0]), &[6.0, 3.0, 3.0, 6.0]);
    // On a triangle of the area 3 with p at one corner: A p / 6 there and A p / 12 at the others.
    near(shares(&triangle[..3], &[4.0, 0.0, 0.0]), &[2.0, 1.0, 1.0]);
}
