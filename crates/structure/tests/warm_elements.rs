//! Elements that are warmed: the forces are those that their free expansion, worked out by tensors, needs. Whatever
//! their attitude,
//! offset and material axes.

use nalgebra::{DVector, Matrix2, Point3, Rotation3, Vector2, Vector3};
use nastran::{BulkData, parse_deck};
use structure::{Model, thermal_loads};

fn deck_of(text: &str) -> BulkData {
    parse_deck("test.bdf", text).unwrap_or_else(|error| panic!("{error}"))
}

/// A grid card of full precision.
fn grid(id: usize, place: Point3<f64>) -> String {
    format!("GRID*,{id},,{:.14E},{:.14E}\n*,{:.14E}\n", place.x, place.y, place.z)
}

fn attitude() -> Rotation3<f64> {
    Rotation3::from_scaled_axis(Vector3::new(0.7, -1.1, 0.4))
}

/// Whether the forces of temperatures of set 1 are the stiffness of the only element times a free motion (six a node).
#[track_caller]
fn frees(text: &str, initial: Option<u32>, free: &[f64], what: &str) {
    let bulk = deck_of(text);
    let forces = thermal_loads(&bulk, 1, initial).unwrap_or_else(|error| panic!("{error}"));
    let model = Model::from_bulk(&bulk).unwrap_or_else(|error| panic!("{error}"));
    let element = &model.elements[0];
    let dofs = element.dofs();
    let u = DVector::from_iterator(dofs.len(), dofs.iter().map(|dof| free[*dof]));
    let expected = &*element.stiffness().expect("stiff") * u;
    let size = expected.amax();
    assert!(size > 1.0, "{what}: it pushes");
    for (dof, expected) in dofs.iter().zip(expected.iter()) {
        assert!(
            (forces[*dof] - expected).abs() < 1e-8 * size,
            "{what}, motion {dof}: {} {expected}",
            forces[*dof]
        );
    }
    let others = (0..forces.len()).filter(|dof| !dofs.contains(dof));
    assert!(others.map(|dof| forces[dof].abs()).fold(0.0, f64::max) == 0.0, "{what}: nothing elsewhere");
}

/// A bar from A to B in its own axes: it grows by A T L, and bends by -A dT/dy over its height.
#[test]
fn a_bar_off_its_grids_grows_and_bends_as_its_length_says() {
    let (turn, length) = (attitude(), 1.7);
    let place =
        |x: f64, y: f64, z: f64| Point3::from(turn * Vector3::new(x, y, z) + Vector3::new(3.0, 1.0, -2.0));
    let offsets = [Vector3::new(0.05, 0.1, -0.2), Vector3::new(-0.15, 0.3, 0.25)];
    let ends = [Vector3::zeros(), Vector3::new(length, 0.0, 0.0)];
    let grids = [0, 1].map(|end: usize| ends[end] - offsets[end]).map(|at| place(at.x, at.y, at.z));
    let vector = |own: Vector3<f64>| {
        let v = turn * own;
        [v.x, v.y, v.z].map(|part| format!("{part:.13}")).join(",")
    };
    let card = |name: &str| {
        format!(
            "{name},1,1,1,2,{}\n,,,{},{}\n",
            vector(Vector3::new(0.3, 1.0, 0.0)),
            vector(offsets[0]),
            vector(offsets[1])
        )
    };
    let section = "PBAR,1,1,1.-2,2.-6,3.-6,4.-6\nMAT1,1,7.+10,,.3,,2.-5,15.\n";
    // Means of 25 at the ends, from TREF on or from the grids' mean before; gradients along y and z at A and at B.
    let warm = "TEMPRB,1,1,20.,30.,100.,70.,10.,20.\nTEMP,2,1,4.,2,10.\n";
    for (initial, rise) in [(None, 10.0), (Some(2), 18.0)] {
        let (alpha, at_a, at_b) = (2e-5, [100.0, 10.0], [70.0, 20.0]);
        // Slope and deflection of w'' = -A (a + (b - a) x / L).
        let slope = |plane: usize| -alpha * length * (at_a[plane] + at_b[plane]) / 2.0;
        let sag = |plane: usize| -alpha * length * length * (2.0 * at_a[plane] + at_b[plane]) / 6.0;
        let end = Vector3::new(alpha * rise * length, sag(0), sag(1));
        let spin = Vector3::new(0.0, -slope(1), slope(0));
        let at_grid = turn * (end - spin.cross(&offsets[1]));
        let spin = turn * spin;
        let free: Vec<f64> =
            [0.0; 6].into_iter().chain(at_grid.iter().copied()).chain(spin.iter().copied()).collect();
        let grids = grid(1, grids[0]) + &grid(2, grids[1]);
        frees(&format!("{grids}{}{section}{warm}", card("CBAR")), initial, &free, "a bar");
    }
    // The temperatures of its grids bend nothing: means of 35 and 55 less TREF.
    let free: Vec<f64> = [0.0; 6]
        .into_iter()
        .chain((turn * Vector3::new(2e-5 * 30.0 * length, 0.0, 0.0)).iter().copied())
        .chain([0.0; 3])
        .collect();
    let grids = grid(1, grids[0]) + &grid(2, grids[1]);
    frees(&format!("{grids}{}{section}TEMP,1,1,35.,2,55.\n", card("CBAR")), None, &free, "by its grids");
}

#[test]
fn rods_of_every_kind_grow_along_themselves() {
    let (a, b) = (Point3::new(0.3, 0.2, -0.4), Point3::new(1.5, -0.4, 0.9));
    let grids = grid(1, a) + &grid(2, b);
    let longer = (b - a) * (2e-5 * 34.0);
    let free = [[0.0; 6], [longer.x, longer.y, longer.z, 0.0, 0.0, 0.0]].concat();
    for card in
        ["CROD,1,2,1,2\nPROD,2,1,3.-3,1.-6\n", "CONROD,1,1,2,1,3.-3\n", "CTUBE,1,2,1,2\nPTUBE,2,1,.05,.004\n"]
    {
        // A mean of 51, from 17 on, the mean of 11 and 23.
        let warm = "TEMPRB,1,1,44.,58.\nTEMP,2,1,11.,2,23.\nMAT1,1,7.+10,,.3,,2.-5\n";
        frees(&format!("{grids}{card}{warm}"), Some(2), &free, card);
    }
}

/// Corners of a flat quadrilateral without parallel sides in its own plane.
const CORNERS: [[f64; 2]; 4] = [[0.0, 0.0], [1.3, 0.0], [1.1, 0.9], [-0.1, 0.7]];

/// The free motion of grids at CORNERS that strains by T (e + z k) with z from the reference surface, `offset` above
/// the grids.
fn plate(count: usize, strain: Matrix2<f64>, curvature: Matrix2<f64>, offset: f64) -> Vec<f64> {
    let turn = attitude();
    let one = |corner: &[f64; 2]| {
        let r = Vector2::from(*corner);
        let (flat, bent) = (strain * r, curvature * r);
        // A fibre at z moves by z times the turn; the grids are at -offset.
        let moved = flat - bent * offset;
        let moved = turn * Vector3::new(moved.x, moved.y, -0.5 * r.dot(&bent));
        let spun = turn * Vector3::new(-bent.y, bent.x, 0.0);
        [moved.x, moved.y, moved.z, spun.x, spun.y, spun.z]
    };
    CORNERS[..count].iter().flat_map(one).collect()
}

/// Expansions along and across a direction, as a tensor.
fn tensor([along, across]: [f64; 2], degrees: f64) -> Matrix2<f64> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let turn = Matrix2::new(cos, -sin, sin, cos);
    turn * Matrix2::new(along, 0.0, 0.0, across) * turn.transpose()
}

fn shell(count: usize, direction: &str, offset: f64) -> String {
    let grids: String = CORNERS[..count]
        .iter()
        .enumerate()
        .map(|(at, [x, y])| {
            grid(at + 1, (attitude() * Vector3::new(*x, *y, 0.0) + Vector3::new(1.0, 2.0, 3.0)).into())
        })
        .collect();
    let name = if count == 4 { "CQUAD4,1,1,1,2,3,4" } else { "CTRIA3,1,1,1,2,3" };
    format!("{grids}{name},{direction},{offset:?}\n")
}

const PLY: &str = "MAT8,2,2.+11,1.+10,.3,5.+9,4.+9,3.+9,0.\n,1.-5,3.-5,20.\n";

#[test]
fn plates_expand_and_bend_along_their_materials_axes_off_their_grids() {
    for count in [4, 3] {
        for (degrees, offset) in [(0.0, 0.0), (35.0, 0.0), (35.0, 0.08), (-60.0, -0.03)] {
            let what = format!("{count} corners, {degrees} degrees, offset {offset}");
            let expansion = tensor([1e-5, 3e-5], degrees);
            let property = "PSHELL,1,2,.05,2,,2\n";
            let card = shell(count, &format!("{degrees:?}"), offset);
            // Mean 70 from 20 on, gradient 400 a metre.
            let free = plate(count, expansion * 50.0, expansion * 400.0, offset);
            let warm = "TEMPP1,1,1,70.,400.\n";
            frees(&format!("{card}{property}{PLY}{warm}"), None, &free, &what);
            // From the grids' mean before.
            let free = plate(count, expansion * 64.0, expansion * 400.0, offset);
            frees(&format!("{card}{property}{PLY}{warm}TEMPD,2,6.\n"), Some(2), &free, &what);
            // Without a gradient, from the mean of the grids' temperatures.
            let free = plate(count, expansion * 25.0, Matrix2::zeros(), offset);
            let grids = if count == 4 {
                "TEMP,1,1,30.,2,40.,3,50.\nTEMP,1,4,60.\n"
            } else {
                "TEMP,1,1,30.,2,40.,3,65.\n"
            };
            frees(&format!("{card}{property}{PLY}{grids}"), None, &free, &what);
        }
    }
}

#[test]
fn an_isotropic_plate_grows_alike_in_all_directions_and_bends_with_its_bending_material() {
    let (flat, bent) = (Matrix2::identity() * 1e-5, Matrix2::identity() * 4e-5);
    let materials = "MAT1,2,7.+10,,.3,,1.-5,20.\nMAT1,3,7.+10,,.3,,4.-5,90.\nMAT1,4,7.+10,,.3\n";
    let card = shell(4, "25.", 0.04);
    let with = |property: &str, temperatures: &str| format!("{card}{property}{materials}{temperatures}");
    let free = plate(4, flat * 50.0, Matrix2::zeros(), 0.04);
    frees(&with("PSHELL,1,2,.05,3,,2\n", "TEMPP1,1,1,70.,0.\n"), None, &free, "the membrane's");
    let free = plate(4, flat * 50.0, bent * 300.0, 0.04);
    frees(&with("PSHELL,1,2,.05,3,,2\n", "TEMPP1,1,1,70.,300.\n"), None, &free, "both");
    // Colder above: it bends the other way.
    let free = plate(4, flat * 50.0, bent * -300.0, 0.04);
    frees(&with("PSHELL,1,2,.05,3,,2\n", "TEMPP1,1,1,70.,-300.\n"), None, &free, "the other way");
    // A membrane that does not expand, a plate that does, and the other way round.
    let free = plate(4, Matrix2::zeros(), bent * 300.0, 0.04);
    frees(&with("PSHELL,1,4,.05,3,,2\n", "TEMPP1,1,1,70.,300.\n"), None, &free, "bending alone");
    let free = plate(4, flat * 50.0, Matrix2::zeros(), 0.04);
    frees(&with("PSHELL,1,2,.05,4,,2\n", "TEMPP1,1,1,70.,300.\n"), None, &free, "the membrane alone");
    frees(&with("PSHELL,1,2,.05\n", "TEMPP1,1,1,70.,0.\n"), None, &free, "a membrane");
    // Nothing that expands asks for no temperature.
    let cold = thermal_loads(&deck_of(&with("PSHELL,1,4,.05,4,,4\n", "TEMP,1,77,3.\n")), 1, None);
    assert!(cold.expect("no forces").iter().all(|force| *force == 0.0));
}

/// Layers of one material turned alike expand as one layer does, whatever their heights.
#[test]
fn layers_of_one_material_expand_as_one_layer_at_any_height() {
    for (layers, z0) in
        [(",2,.05,30.\n", ""), (",2,.05,30.\n", ",-.01"), (",2,.01,30.,,2,.025,30.\n,2,.015,30.\n", ",.02")]
    {
        for offset in [0.0, 0.07] {
            let expansion = tensor([1e-5, 3e-5], 30.0 - 50.0);
            let free = plate(4, expansion * 40.0, expansion * 400.0, offset);
            let card = shell(4, "-50.", offset);
            // From the laminate's own temperature on.
            let property =
                if z0.is_empty() { "PCOMP,1,,,,,30.\n".to_owned() } else { format!("PCOMP,1{z0},,,,30.\n") };
            let text = format!("{card}{property}{layers}{PLY}TEMPP1,1,1,70.,400.\n");
            frees(&text, None, &free, &format!("{layers} {z0} {offset}"));
        }
    }
}

/// Two layers of one stiffness, of which one expands: strain and curvature are those of the balance of forces and
/// moments, A T / 2 and
/// 3 A T / 2 h with h the height of both.
#[test]
fn a_layer_that_expands_alone_bends_the_laminate() {
    let h = 0.04;
    let text = |upper: u32| {
        let (below, above) = if upper == 2 { (3, 2) } else { (2, 3) };
        format!(
            "{}PCOMP,1,,,,,30.\n,{below},.02,0.,,{above},.02,0.\nMAT1,2,7.+10,,.3,,1.-5\nMAT1,3,7.+10,,.3\n\
            TEMPP1,1,1,70.,0.\n",
            shell(4, "0.", 0.0)
        )
    };
    let strain = Matrix2::identity() * (1e-5 * 40.0 / 2.0);
    for (upper, sign) in [(2, 1.0), (3, -1.0)] {
        let curvature = Matrix2::identity() * (sign * 1.5 * 1e-5 * 40.0 / h);
        frees(&text(upper), None, &plate(4, strain, curvature, 0.0), "one of two");
    }
    let uneven = "a shell with grids on its sides is refused where it is warmed unevenly";
    let eight = format!(
        "GRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nGRID,3,,2.,2.,0.\nGRID,4,,0.,2.,0.\nGRID,5,,1.,0.,0.\nGRID,6,,2.,1.,0.\n\
         GRID,7,,1.,2.,0.\nGRID,8,,0.,1.,0.\nCQUAD8,1,1,1,2,3,4,5,6\n,7,8\n{PLY}MAT1,3,7.+10,,.3,,1.-5\n"
    );
    let warm =
        |rest: &str| thermal_loads(&deck_of(&format!("{eight}{rest}")), 1, None).map_err(|e| e.to_string());
    for rest in ["PSHELL,1,2,.05,2,,2\nTEMPD,1,50.\n", "PSHELL,1,3,.05,3,,3\nTEMPP1,1,1,50.,10.\n"] {
        let error = warm(rest).expect_err(uneven);
        assert!(error.contains("with grids on its sides is warmed unevenly"), "{error}");
    }
    // Alike in all directions and through its height it grows.
    let forces = warm("PSHELL,1,3,.05,3,,3\nTEMPD,1,50.\n").expect("it grows");
    let bulk = deck_of(&format!("{eight}PSHELL,1,3,.05,3,,3\n"));
    let model = Model::from_bulk(&bulk).expect("a model");
    let grown = model.nodes.iter().flat_map(|node| {
        let moved = node.point.coords * 5e-4;
        [moved.x, moved.y, moved.z, 0.0, 0.0, 0.0]
    });
    let expected = &*model.elements[0].stiffness().expect("stiff") * DVector::from_iterator(48, grown);
    assert!((expected.clone() - DVector::from_vec(forces)).amax() < 1e-9 * expected.amax());
}
