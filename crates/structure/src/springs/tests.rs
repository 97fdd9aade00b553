//! Springs, bushes, rods and general elements: energies of motions worked out by hand, and which matrices turn with
//! their grids.

use super::*;
use crate::model::Model;
use nalgebra::Rotation3;
use nastran::Span;

fn span() -> Span {
    Span::generated("test")
}

fn node(id: u32, point: [f64; 3], axes: Matrix3<f64>) -> Node {
    Node { id, point: point.into(), axes, is_scalar: false }
}

fn turned() -> Matrix3<f64> {
    *Rotation3::from_scaled_axis(Vector3::new(0.4, -1.1, 0.7)).matrix()
}

/// Two grids with axes of their own and one in basic axes.
fn nodes() -> Vec<Node> {
    vec![
        node(1, [0.3, -0.2, 0.1], turned()),
        node(2, [1.5, 0.6, -0.4], Matrix3::identity()),
        node(3, [0.2, 1.1, 0.9], turned().transpose()),
    ]
}

/// A motion of three nodes, six each.
fn moved() -> Vec<f64> {
    (0..18).map(|at| (1.7 * f64::from(at) + 0.3).sin()).collect()
}

fn energy(dofs: &[usize], k: &DMatrix<f64>, motion: &[f64]) -> f64 {
    let own = DVector::from_iterator(dofs.len(), dofs.iter().map(|dof| motion[*dof]));
    own.dot(&(k * &own))
}

fn of(motion: &[f64], node: usize, first: usize) -> Vector3<f64> {
    Vector3::from_column_slice(&motion[6 * node + first..6 * node + first + 3])
}

#[test]
fn a_scalar_spring_stretches_by_the_difference_along_the_grids_own_axes() {
    let (nodes, motion) = (nodes(), moved());
    let along = |node: usize, component: usize| {
        nodes[node].axes.column(component % 3).dot(&of(&motion, node, component - component % 3))
    };
    for (ends, stretch) in [
        ([Some((0, 1)), Some((2, 5))], along(0, 1) - along(2, 5)),
        ([Some((1, 4)), None], along(1, 4)),
        ([None, Some((0, 2))], -along(0, 2)),
        ([Some((2, 0)), Some((2, 2))], along(2, 0) - along(2, 2)),
        ([Some((2, 3)), Some((2, 0))], along(2, 3) - along(2, 0)),
    ] {
        let (dofs, k) = scalar(&nodes, ends, 5.0);
        let (own, expected) = (energy(&dofs, &k, &motion), 5.0 * stretch * stretch);
        assert!((own - expected).abs() < 1e-12 * (1.0 + expected), "{ends:?}: {own} for {expected}");
        let mut different = dofs.clone();
        different.sort_unstable();
        different.dedup();
        assert_eq!(different.len(), dofs.len(), "each motion once");
    }
}

#[test]
fn a_bush_feels_how_its_ends_move_apart_at_its_place() {
    let (nodes, motion, axes) = (nodes(), moved(), turned() * turned());
    let stiffness = [5.0, 4.0, 3.0, 2.0, 1.5, 0.5];
    let property = Pbush { id: 1, stiffness, damping: [0.0; 6], mass: 0.0, span: span() };
    let place = Point3::new(0.7, 0.1, -0.3);
    // Displacement of a node's end of the spring, u + theta x r, and its rotation.
    let end = |node: usize| {
        let turn = of(&motion, node, 3);
        (of(&motion, node, 0) + turn.cross(&(place - nodes[node].point)), turn)
    };
    for (ends, turning) in [
        ((2, Some(0)), Corotation::Node(1)),
        ((0, Some(1)), Corotation::Node(0)),
        ((1, None), Corotation::Ground),
    ] {
        let element = BushPlace { ends, point: place, axes, mass_at_b: 0.5 }.element(7, &nodes, &property);
        let none = (Vector3::zeros(), Vector3::zeros());
        let (a, b) = (end(ends.0), ends.1.map_or(none, end));
        let (apart, twist) = (axes.transpose() * (b.0 - a.0), axes.transpose() * (b.1 - a.1));
        let squares = apart.iter().chain(twist.iter()).map(|part| part * part);
        let expected: f64 = squares.zip(property.stiffness).map(|(square, k)| square * k).sum();
        let own = energy(&element.dofs(), &element.stiffness().expect("stiff"), &motion);
        assert!((own - expected).abs() < 1e-12 * expected, "{ends:?}: {own} for {expected}");
        assert_eq!(element.corotation(), turning);
    }
}

#[test]
fn a_rod_stretches_twists_and_weighs_along_its_line() {
    let (nodes, motion) = (nodes(), moved());
    let material = Mat1 {
        id: 1,
        e: 70.0,
        g: 27.0,
        nu: 0.3,
        rho: 3.0,
        expansion: nastran::Expansion::default(),
        span: span(),
    };
    let card = Crod { id: 3, property: 1, grids: [1, 3], span: span() };
    let section = |area: f64, j: f64| Prod { id: 1, material: 1, area, j, nsm: 0.7, span: span() };
    let along = nodes[2].point - nodes[0].point;
    let length = along.norm();
    let apart = |first: usize| (of(&motion, 2, first) - of(&motion, 0, first)).dot(&along) / length;
    for (area, j) in [(0.2, 0.05), (0.2, 0.0), (0.0, 0.05)] {
        let rod = rod(&card, &nodes, [0, 2], &section(area, j), &material).expect("it has a length");
        let expected = (70.0 * area * apart(0).powi(2) + 27.0 * j * apart(3).powi(2)) / length;
        let own = energy(&rod.dofs(), &rod.stiffness().expect("stiff"), &motion);
        assert!((own - expected).abs() < 1e-12 * expected, "{area} {j}: {own} for {expected}");
        // Displacements linear along the rod: thirds of the squares and of the product.
        let (a, b) = (of(&motion, 0, 0), of(&motion, 2, 0));
        let mass = (3.0 * area + 0.7) * length;
        let expected = mass / 3.0 * (a.norm_squared() + b.norm_squared() + a.dot(&b));
        let own = energy(&rod.dofs(), &rod.mass().expect("massive"), &motion);
        assert!((own - expected).abs() < 1e-12 * expected, "{area} {j}: mass {own} for {expected}");
        let rotations = rod.dofs().iter().any(|dof| dof % 6 > 2);
        assert_eq!(rotations, j > 0.0, "rotations only where they meet stiffness");
    }
    let same = [node(1, [1e3, 0.0, 0.0], turned()), node(3, [1e3, 0.0, 1e-10], turned())];
    let error = rod(&card, &same, [0, 1], &section(1.0, 1.0), &material).expect_err("no length").to_string();
    assert!(error.contains("CROD 3 has no length"), "{error}");
    let near = [node(1, [1e3, 0.0, 0.0], turned()), node(3, [1e3, 0.0, 1e-8], turned())];
    assert!(rod(&card, &near, [0, 1], &section(1.0, 1.0), &material).is_ok());
}

#[test]
fn axes_of_a_line_are_right_handed_with_y_towards_the_orientation() {
    let along = Vector3::new(2.0, -1.0, 0.5);
    let towards = Vector3::new(0.3, 0.8, -0.4);
    let axes = line_axes(&along, Some(&towards)).expect("determined");
    assert!((axes.transpose() * axes - Matrix3::identity()).amax() < 1e-14 && axes.determinant() > 0.0);
    assert!((axes.column(0) - along.normalize()).norm() < 1e-14);
    assert!(axes.column(2).dot(&towards).abs() < 1e-14 && axes.column(1).dot(&towards) > 0.1);
    for along in [Vector3::x() * 3.0, Vector3::y(), Vector3::new(0.95, 0.1, 0.0), Vector3::new(0.5, 1.0, 2.0)]
    {
        let axes = line_axes(&along, None).expect("any");
        assert!((axes.transpose() * axes - Matrix3::identity()).amax() < 1e-14 && axes.determinant() > 0.0);
        assert!((axes.column(0) - along.normalize()).norm() < 1e-14);
    }
    assert_eq!(line_axes(&Vector3::zeros(), Some(&towards)), None);
    assert_eq!(line_axes(&along, Some(&(along * -2.0))), None);
    assert_eq!(line_axes(&along, Some(&Vector3::zeros())), None);
}

#[test]
fn a_mass_matrix_moves_along_its_own_axes() {
    let mass = std::array::from_fn(|i| std::array::from_fn(|j| 1.0 + (i.min(j) + 2 * i.max(j)) as f64));
    let card = Conm1 { id: 4, grid: 1, cid: 0, mass, span: span() };
    let (axes, motion) = (turned(), moved());
    let element = mass_matrix(&card, 2, &axes);
    let (u, t) = (axes.transpose() * of(&motion, 2, 0), axes.transpose() * of(&motion, 2, 3));
    let own = DVector::from_iterator(6, u.iter().chain(t.iter()).copied());
    let expected = own.dot(&(DMatrix::from_fn(6, 6, |i, j| mass[i][j]) * &own));
    let energy = energy(&element.dofs(), &element.mass().expect("massive"), &motion);
    assert!((energy - expected).abs() < 1e-12 * expected.abs(), "{energy} for {expected}");
    assert!(element.stiffness().is_none());
}

/// A triangle of three bars and its stiffness; `size` scales it, with the same section modulus by length.
fn frame(size: f64) -> (Vec<Node>, DMatrix<f64>) {
    let mut deck = format!(
        "PBAR,1,1,{:.6E},{:.6E},{:.6E},{:.6E}\nMAT1,1,1.,.4\nCBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\n\
        CBAR,3,1,3,1,0.,0.,1.\n",
        0.01 * size * size,
        0.01 * size.powi(4),
        0.02 * size.powi(4),
        0.03 * size.powi(4)
    );
    for (id, [x, y, z]) in [[0.1, 0.0, 0.0], [1.0, 0.0, 0.3], [0.2, 0.9, 0.1]].into_iter().enumerate() {
        deck = format!("{deck}GRID*,{},,{:.12E},{:.12E}\n*,{:.12E}\n", id + 1, size * x, size * y, size * z);
    }
    let model = Model::from_bulk(&nastran::parse_deck("t.bdf", &deck).expect("a deck")).expect("a model");
    let mut k = DMatrix::zeros(18, 18);
    for element in model.elements() {
        let (own, dofs) = (element.stiffness().expect("stiff"), element.dofs());
        for (i, j) in (0..144).map(|at| (at / 12, at % 12)) {
            k[(dofs[i], dofs[j])] += own[(i, j)];
        }
    }
    (model.nodes, k)
}

#[test]
fn a_matrix_turns_with_its_grids_if_a_rigid_motion_meets_no_force_in_any_units() {
    let all: Vec<usize> = (0..18).collect();
    for size in [1e-3, 1.0, 1e3] {
        let (nodes, k) = frame(size);
        let turns = |k: &DMatrix<f64>| turns_with_its_grids(&MatrixElement::spring(1, &all, k), &nodes);
        assert!(turns(&k), "size {size}");
        // Rotations in units of the size of the group, as seen from its first grid.
        let arms = [1, 2].map(|at: usize| nodes[at].point - nodes[0].point);
        let spread: Matrix3<f64> = arms.iter().map(|arm| arm * arm.transpose()).sum();
        let unit = spread.symmetric_eigenvalues().max().sqrt();
        let scale = |dof: usize| if dof % 6 < 3 { 1.0 } else { 1.0 / unit };
        let largest = DMatrix::from_fn(18, 18, |i, j| scale(i) * k[(i, j)] * scale(j)).amax();
        // A spring to the ground at a motion: a rigid motion that moves there by one meets its stiffness.
        for dof in [1, 4, 14, 17] {
            let with = |share: f64| {
                let mut held = k.clone();
                held[(dof, dof)] += share * largest / scale(dof).powi(2);
                turns(&held)
            };
            assert!(with(5e-7) && !with(4e-6), "size {size}, motion {dof}");
        }
    }
}

#[test]
fn grids_in_a_line_do_not_tell_how_a_matrix_turns() {
    // Rods between all three grids: no rigid motion stretches them.
    let of = |b: f64, size: f64| {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, b, 0.0]].map(|p| Vector3::from(p) * size);
        let nodes: Vec<Node> = (0..3).map(|at| node(1, points[at].into(), Matrix3::identity())).collect();
        let mut k = DMatrix::zeros(9, 9);
        for [i, j] in [[0, 1], [1, 2], [2, 0]] {
            let along = (points[j] - points[i]).normalize();
            let mut stretch = DVector::zeros(9);
            stretch.fixed_rows_mut::<3>(3 * i).copy_from(&-along);
            stretch.fixed_rows_mut::<3>(3 * j).copy_from(&along);
            k += &stretch * stretch.transpose();
        }
        let dofs: Vec<usize> = [0, 1, 2].iter().flat_map(|node| (0..3).map(move |c| 6 * node + c)).collect();
        turns_with_its_grids(&MatrixElement::spring(1, &dofs, &k), &nodes)
    };
    // From the first grid: about 1.25 along, b^2 (1 - 0.25 / 1.25) across, a millionth of it at b = 1.25e-3.
    for size in [1e-2, 1.0, 1e3] {
        assert!(of(1.4e-3, size) && !of(1.1e-3, size), "size {size}");
    }
    let mass = MatrixElement::mass(1, &[0, 6], &DMatrix::identity(2, 2));
    assert!(!turns_with_its_grids(&mass, &nodes()), "nothing stiff");
}

/// A beam with one end as the support of the other: flexibility of that end, and what the support's motion carries
/// along.
#[test]
fn a_general_element_with_a_beams_flexibility_is_the_beam() {
    for axes in ["", ",5"] {
        let deck = format!(
            "CORD2R,5,,0.,0.,0.,0.,1.,0.,\n,0.,0.,1.\nGRID,1,,.1,.2,.3{axes}\nGRID,2,,1.1,.7,-.2{axes}\n\
            GRID,3,,1.1,.2,1.3\n\
             CBAR,1,1,1,2,0.,0.,1.\nPBAR,1,1,.1,.02,.03,.04\nMAT1,1,70.,27.\n"
        );
        let model = Model::from_bulk(&nastran::parse_deck("t.bdf", &deck).expect("a deck")).expect("a model");
        let beam = model.elements[0].stiffness().expect("stiff").into_owned();
        // In the grids' own axes, end B first.
        let own = |end: usize| -> [DVector<f64>; 6] {
            std::array::from_fn(|component| {
                let mut unit = DVector::zeros(12);
                for (dof, factor) in motion(&model.nodes, end, component) {
                    unit[dof] = factor;
                }
                unit
            })
        };
        let (a, b) = (own(0), own(1));
        let between = |left: &[DVector<f64>; 6], right: &[DVector<f64>; 6]| {
            DMatrix::from_fn(6, 6, |i, j| left[i].dot(&(&beam * &right[j])))
        };
        let z = between(&b, &b).try_inverse().expect("it is held");
        let s = -&z * between(&b, &a);
        let rows =
            |m: &DMatrix<f64>| (0..6).map(|i| m.row(i).iter().copied().collect()).collect::<Vec<Vec<f64>>>();
        let card = |s: Vec<Vec<f64>>, matrix: Vec<Vec<f64>>, is_flexibility: bool| Genel {
            id: 9,
            ui: Vec::new(),
            ud: Vec::new(),
            is_flexibility,
            matrix,
            s,
            span: span(),
        };
        let all = |end: usize| -> Vec<(usize, usize)> { (0..6).map(|component| (end, component)).collect() };
        for (matrix, is_flexibility) in [(rows(&z), true), (rows(&between(&b, &b)), false)] {
            let made = |s: Vec<Vec<f64>>, ud: &[(usize, usize)]| {
                general(&card(s, matrix.clone(), is_flexibility), &model.nodes, &all(1), ud)
            };
            // Without S the rigid motions of the support are carried along, and a beam has no other S.
            for s in [rows(&s), Vec::new()] {
                let made = made(s, &all(0)).expect("sound");
                let k = made.stiffness().expect("stiff");
                assert_eq!(made.dofs(), (0..12).collect::<Vec<_>>());
                assert!((&*k - &beam).amax() < 1e-10 * beam.amax(), "{axes}: {}", &*k - &beam);
                // Two grids are in one line.
                assert!(matches!(made.corotation(), Corotation::Refused(why) if why.contains("GENEL 9")));
            }
            let said = made(Vec::new(), &all(0)[1..]).expect_err("five motions").to_string();
            assert!(said.contains("GENEL 9: without S, UD has six motions"), "{said}");
            // Without a support k is over ui alone.
            let held = made(Vec::new(), &[]).expect("sound");
            assert_eq!(held.dofs(), (6..12).collect::<Vec<_>>());
            let end = beam.view((6, 6), (6, 6));
            assert!((&*held.stiffness().expect("stiff") - end).amax() < 1e-10 * beam.amax());
        }
        let loose = card(Vec::new(), vec![vec![1.0, 2.0], vec![2.0, 1.0]], true);
        let error = general(&loose, &model.nodes, &all(1)[..2], &[]).expect_err("not positive").to_string();
        assert!(error.contains("GENEL 9: its flexibility Z is not positive definite"), "{error}");
    }
}
