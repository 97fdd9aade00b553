//! Displacements and frequencies that Nastran prints, of decks so coarse that each kind of element shows its own.

use crate::large::published;
use nalgebra::DMatrix;
use nastran::parse_deck;
use serde_json::Value;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use structure::{Flexibility, Model, System, loads_of, normal_modes};

/// Displacement of a component of a grid under load set 5.
fn displaced(deck: &str) -> impl Fn(u32, usize) -> f64 + use<> {
    let bulk = parse_deck("deck.bdf", deck).expect("a deck");
    let system = System::assemble(&Model::from_deck(&bulk, None).expect("a model")).expect("a structure");
    let loads = system.forces_of(&loads_of(&bulk, 5).expect("loads"));
    let held = Flexibility::new(&system).expect("it is held");
    let u = system.expand(held.displacements(system.reduce(loads.as_ref()).as_ref()).as_ref());
    move |grid, component| u[(6 * system.node_index(grid).expect("a grid") + component - 1, 0)]
}

/// Compares with prints of some components, `near` of the largest of each component.
fn assert_printed<const N: usize>(
    deck: &str,
    components: [usize; N],
    printed: &[(u32, [f64; N])],
    near: f64,
) {
    let ours = displaced(deck);
    for (at, component) in components.into_iter().enumerate() {
        let largest = printed.iter().map(|(_, row)| row[at].abs()).fold(0.0, f64::max);
        for (grid, row) in printed {
            let (ours, printed) = (ours(*grid, component), row[at]);
            assert!(
                (ours - printed).abs() < near * largest,
                "grid {grid}, {component}: {ours} beside {printed}"
            );
        }
    }
}

/// A grid of `columns` by `rows` elements of `sides`, numbered along x from 1 on, and its CQUAD4 of PSHELL 101.
fn meshed([columns, rows]: [u32; 2], sides: [f64; 2]) -> String {
    let mut deck = String::new();
    for at in 0..(columns + 1) * (rows + 1) {
        let [x, y] = [at % (columns + 1), at / (columns + 1)].map(f64::from);
        let _ = writeln!(deck, "GRID,{},,{:?},{:?},0.", at + 1, x * sides[0], y * sides[1]);
    }
    for at in 0..columns * rows {
        let first = at + at / columns + 1;
        let next = first + columns + 1;
        let _ = writeln!(deck, "CQUAD4,{},101,{first},{},{},{next}", at + 1, first + 1, next + 1);
    }
    deck
}

/// A plate of 4 by 3 CQUAD4, clamped along one side, hinged along two, pressed: MSC Nastran 2014.1 (example 2 of chapter 13 of MSC's *Getting Started*, printed
/// beside CoFE's `a7_gt13ex2`): w and the rotations about x and y, without the shear flexibility of MID3 and with it. Without the element's own
/// bending beyond bilinear rotations the displacements are 4.5 to 18 % off.
#[test]
fn a_coarse_plate_bends_as_msc_prints() {
    let plate = meshed([4, 3], [1.5, 1.0])
        + "SPC1,1,123456,16,THRU,20\nSPC1,1,1234,1,6,11,5,10,15\nSPC1,1,6,1,THRU,20\nPLOAD2,5,-.25,1,THRU,12\nMAT1,105,30.+6,,.3\n";
    let without = [
        (1, [0.0, 0.0, 2.019_264e-3]),
        (2, [-2.622_067e-3, 1.126_350e-3, 1.381_537e-3]),
        (3, [-3.673_454e-3, 1.584_569e-3, 0.0]),
        (6, [0.0, 0.0, 1.191_797e-3]),
        (7, [-1.538_831e-3, 1.037_089e-3, 7.966_723e-4]),
        (8, [-2.143_356e-3, 1.471_117e-3, 0.0]),
        (11, [0.0, 0.0, 4.122_254e-4]),
        (12, [-5.273_157e-4, 9.327_955e-4, 2.659_246e-4]),
        (13, [-7.271_923e-4, 1.285_540e-3, 0.0]),
    ];
    let with = [
        (1, [0.0, 0.0, 2.015_773e-3]),
        (2, [-2.634_148e-3, 1.128_535e-3, 1.379_105e-3]),
        (3, [-3.687_613e-3, 1.587_460e-3, 0.0]),
        (6, [0.0, 0.0, 1.191_799e-3]),
        (7, [-1.548_584e-3, 1.039_289e-3, 7.968_513e-4]),
        (8, [-2.154_623e-3, 1.473_592e-3, 0.0]),
        (11, [0.0, 0.0, 4.142_349e-4]),
        (12, [-5.330_284e-4, 9.344_257e-4, 2.678_075e-4]),
        (13, [-7.339_914e-4, 1.285_929e-3, 0.0]),
    ];
    for (shear, printed, near) in [("", without, 5e-6), (",,105", with, 4e-7)] {
        assert_printed(&format!("{plate}PSHELL,101,105,.05,105{shear}\n"), [3, 4, 5], &printed, near);
    }
}

/// 5 by 5 CQUAD4 pulled along x: MSC Nastran 2012 (pyNastran's `plate`): displacements and the rotations about the normal, which PARAM K6ROT (100 by default) ties to
/// the membrane's own at each corner, with the whole area.
#[test]
fn rotations_about_the_normal_of_a_pulled_plate_are_those_that_msc_prints() {
    let forces: Vec<String> = (1..=6).map(|row| format!("FORCE,5,{},,100.,1.,0.,0.\n", 6 * row)).collect();
    let plate = meshed([5, 5], [2.0, 2.0])
        + "SPC1,1,123456,1,7,13,19,25,31\nPSHELL,101,1,.3,1,,1\nMAT1,1,7.+7,,.3\n"
        + &forces.concat();
    let printed = [
        (2, [6.224_124e-6, 2.957_988e-6, 6.779_606e-7]),
        (3, [1.174_299e-5, 3.450_045e-6, 2.195_634e-7]),
        (6, [3.683_496e-5, 9.305_489e-6, 3.944_540e-6]),
        (8, [5.237_304e-6, 1.255_838e-6, 3.731_563e-7]),
        (9, [1.111_987e-5, 1.855_458e-6, 2.179_831e-7]),
        (12, [2.663_531e-5, 5.465_029e-6, 2.275_882e-6]),
        (14, [5.094_331e-6, 3.502_773e-7, 8.202_387e-8]),
        (18, [2.542_402e-5, 1.712_162e-6, 3.506_638e-7]),
    ];
    assert_printed(&plate, [1, 2, 6], &printed, 2e-5);
}

/// Two slender CTETRA of ten grids whose edges are not straight: Nastran's print of pyNastran's `simple_example` (`models/complex/tet10`).
#[test]
fn curved_tetrahedra_are_integrated_as_in_nastran() {
    let deck = "CTETRA,1,1,2154,2161,2191,2503,2136,2486\n,2487,2534,2259,2485\nCTETRA,2,1,2191,2161,2551,2503,2486,2260\n,2488,2485,2259,2128\n\
        FORCE,5,2154,,1.,1.,0.,0.\nMAT1,1,1.705+7,,.31\nPSOLID,1,1,0\nSPC1,1,123456,2128,2260,2488,2551\n\
        GRID,2128,,-.229769,.102652,11.95\nGRID,2136,,-.344288,.0727013,12.0375\nGRID,2154,,-.375018,-.071002,12.025\n\
        GRID,2161,,-.313558,.216405,12.05\nGRID,2191,,-.296663,.0035972,11.9893\nGRID,2259,,-.322793,.215361,12.\n\
        GRID,2260,,-.220535,.103696,12.\nGRID,2485,,-.314345,.108957,11.9696\nGRID,2486,,-.305111,.110001,12.0196\n\
        GRID,2487,,-.33584,-.033702,12.0071\nGRID,2488,,-.212087,-.002707,11.9696\nGRID,2503,,-.332027,.214316,11.95\n\
        GRID,2534,,-.360372,.0720874,11.9835\nGRID,2551,,-.127511,-.009012,11.95\n";
    let printed = [
        (2136, [1.258_036e-5, 7.695_964e-7, 1.294_139e-5]),
        (2154, [4.340_456e-5, -1.289_517e-5, 4.163_720e-5]),
        (2161, [1.790_950e-6, 3.298_141e-6, -2.531_172e-6]),
        (2191, [8.735_060e-6, -2.023_279e-6, 1.029_112e-5]),
        (2259, [-4.626_278e-8, -8.466_152e-7, -2.370_280e-6]),
        (2485, [-1.601_899e-6, -2.378_052e-6, 4.837_875e-6]),
        (2486, [4.112_244e-6, 1.731_911e-6, 4.172_349e-6]),
        (2487, [2.421_974e-5, -4.759_638e-6, 2.368_923e-5]),
        (2503, [-1.301_535e-6, -4.054_202e-6, -7.301_098e-7]),
        (2534, [3.151_078e-6, -6.841_077e-6, 1.593_433e-5]),
    ];
    assert_printed(deck, [1, 2, 3], &printed, 1e-6);
}

/// Membrane, bending, transverse shear and rotations about the normal of a square and a trapezoid, to the ten digits that MSC Nastran punches.
#[test]
fn the_stiffness_of_a_quadrilateral_is_that_which_msc_punches() {
    let case = published("fem__cquad4_stiffness");
    for shape in ["square", "trapezoid"] {
        let corners = case["inputs"][shape].as_array().expect("four corners");
        let grid = |(at, corner): (usize, &Value)| {
            let [x, y] = [0, 1].map(|axis| corner[axis].as_f64().expect("a number"));
            format!("GRID,{},,{x:?},{y:?},0.\n", at + 1)
        };
        let grids: String = corners.iter().enumerate().map(grid).collect();
        let deck =
            format!("{grids}CQUAD4,1,1,1,2,3,4\nPSHELL,1,1,.1,1,,1\nMAT1,1,2.+5,,.3\nPARAM,AUTOSPC,NO\n");
        let model = Model::from_deck(&parse_deck("t.bdf", &deck).expect("a deck"), None).expect("a model");
        let ours = model.elements().next().expect("one").stiffness().expect("stiff");
        let mut printed = DMatrix::zeros(24, 24);
        for entry in case["expected"][shape].as_array().expect("entries") {
            let [row, column] =
                [0, 1].map(|at| usize::try_from(entry[at].as_u64().expect("a number")).expect("small"));
            let value = entry[2].as_f64().expect("a number");
            (printed[(row, column)], printed[(column, row)]) = (value, value);
        }
        // Of the plate's entries and of the membrane's, which are a thousand times as large.
        let plate = |at: usize| (2..5).contains(&(at % 6));
        for is_plate in [true, false] {
            let part = |matrix: &DMatrix<f64>| {
                DMatrix::from_fn(24, 24, |i, j| {
                    if plate(i) == is_plate && plate(j) == is_plate { matrix[(i, j)] } else { 0.0 }
                })
            };
            let (ours, printed) = (part(&ours), part(&printed));
            let miss = (&ours - &printed).amax() / printed.amax();
            assert!(miss < 1e-9, "{shape}, plate {is_plate}: {miss:e}");
        }
    }
}

/// Lumped masses as MSC Nastran 2024.2 prints loads under GRAV (MYSTRAN_Validation, `gravity`): corners have none, each edge of a cube a twelfth.
#[test]
fn the_mass_of_solids_with_grids_on_all_edges_is_lumped_on_the_edges() {
    let corner =
        |at: u32| [[1, 2].contains(&(at % 4)), at % 4 > 1, at > 3].map(|far| f64::from(u8::from(far)));
    let pairs =
        [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 5], [2, 6], [3, 7], [4, 5], [5, 6], [6, 7], [7, 4]];
    let middles = pairs.map(|[a, b]| [0, 1, 2].map(|axis| 0.5 * (corner(a)[axis] + corner(b)[axis])));
    let places: Vec<[f64; 3]> = (0..8).map(corner).chain(middles).collect();
    let mut deck = "CHEXA,1,1,1,2,3,4,5,6\n,7,8,9,10,11,12,13,14\n,15,16,17,18,19,20\nPSOLID,1,1\nMAT1,1,1.+6,,.25,12.\n".to_owned();
    for (at, [x, y, z]) in places.iter().enumerate() {
        let _ = writeln!(deck, "GRID,{},,{x:?},{y:?},{z:?},,456", at + 1);
    }
    let model = Model::from_deck(&parse_deck("t.bdf", &deck).expect("a deck"), None).expect("a model");
    let masses =
        model.elements().next().and_then(structure::Element::lumped_mass).expect("has mass").diagonal();
    for (at, mass) in masses.iter().enumerate() {
        let expected = if at < 24 { 0.0 } else { 1.0 };
        assert!((mass - expected).abs() < 1e-12, "motion {at}: {mass}");
    }
}

/// Grid point forces of CPENTA 2 in Simcenter Nastran 8.5's print of pyNastran's `static_solid_shell_bar`, by the displacements beside them.
#[test]
fn a_wedge_has_the_forces_that_simcenter_prints() {
    let deck = "CPENTA,2,2,6,8,5,10,11,9\nPSOLID,2,1\nMAT1,1,2.9+7,1.1+7,.32\nGRID,5,,1.,1.,1.\nGRID,6,,0.,1.,1.\nGRID,8,,1.,0.,1.\nGRID,9,,1.,1.,2.\n\
        GRID,10,,0.,1.,2.\nGRID,11,,1.,0.,2.\n";
    let model = Model::from_deck(&parse_deck("t.bdf", deck).expect("a deck"), None).expect("a model");
    let displacements = [
        -1.644_998e-3,
        4.932_484e-5,
        1.155_541e-3,
        -1.671_170e-3,
        7.019_289e-5,
        1.664_137e-3,
        -1.724_734e-3,
        -3.605_000e-6,
        1.506_662e-3,
        -2.000_374e-3,
        -6.463_781e-5,
        1.574_006e-3,
        -2.290_081e-3,
        2.271_015e-4,
        2.082_603e-3,
        -2.228_714e-3,
        -2.720_734e-6,
        1.824_516e-3,
    ];
    let printed = [
        546.610_3, 82.104_28, -1359.122, 82.123_52, 527.583_3, -1359.122, 79.093_65, 98.139_91, -2282.299,
        373.307_0, -128.215_3, 2066.949, -128.234_6, 367.862_5, 2066.949, -952.899_9, -947.474_6, 866.644_2,
    ];
    let k = model.elements().next().expect("one").stiffness().expect("stiff").into_owned();
    let forces = k * nalgebra::DVector::from_column_slice(&displacements);
    for (ours, printed) in forces.iter().zip(printed) {
        // Seven digits of displacements leave five of their differences.
        assert!((ours - printed).abs() < 1e-5 * 2282.299, "{ours} beside {printed}");
    }
}

/// Grid point forces of CTRIA3 8 in the same print: in its plane, across it with the moments of bending, and about its normal (PARAM K6ROT 100).
#[test]
fn a_triangle_has_the_forces_that_simcenter_prints() {
    let deck = "CTRIA3,8,4,4,3,16\nPSHELL,4,1,.25,1,,1\nMAT1,1,2.9+7,1.1+7,.32\nGRID,3,,1.,1.,0.\nGRID,4,,0.,1.,0.\nGRID,16,,1.,1.,-1.\n";
    let model = Model::from_deck(&parse_deck("t.bdf", deck).expect("a deck"), None).expect("a model");
    let displacements = [
        -1.112_120e-3,
        -2.845_518e-5,
        7.399_668e-4,
        3.586_282e-5,
        -4.268_616e-4,
        -8.201_584e-6,
        -1.229_546e-3,
        -3.114_698e-5,
        1.249_150e-3,
        3.663_150e-5,
        -5.332_371e-4,
        -7.999_467e-6,
        -7.128_757e-4,
        -5.659_520e-7,
        8.929_982e-4,
        1.137_302e-6,
        -4.826_221e-4,
        -4.237_965e-7,
    ];
    let printed = [
        1.396_531e1,
        -6.897_006e-3,
        1.026_748e1,
        -3.541_889e-1,
        2.363_533e-2,
        2.312_085e-1,
        -2.425_918e1,
        -2.203_465e0,
        1.276_314e3,
        -5.763_794e-3,
        -5.577_622e-3,
        -3.267_507e-3,
        1.029_386e1,
        2.210_362e0,
        -1.286_582e3,
        -1.850_409e0,
        8.322_313e-3,
        -2.348_380e-1,
    ];
    let k = model.elements().next().expect("one").stiffness().expect("stiff").into_owned();
    let forces = k * nalgebra::DVector::from_column_slice(&displacements);
    for (at, (ours, printed)) in forces.iter().zip(printed).enumerate() {
        let near = match at % 6 {
            0 | 2 => 1e-5 * 1286.582,
            4 => 1e-3 * 2.363_533e-2,
            _ => 2e-5 * 2.210_362,
        };
        assert!((ours - printed).abs() < near, "{at}: {ours} beside {printed}");
    }
}

/// Frequencies (Hz) of a deck's structure, held as its SPC1 say.
fn frequencies_hz(deck: &str, count: usize) -> Vec<f64> {
    let bulk = parse_deck("deck.bdf", deck).expect("a deck");
    let system = System::assemble(&Model::from_deck(&bulk, None).expect("a model")).expect("a structure");
    normal_modes(&system, count).expect("modes").omega_rad_s.iter().map(|w| w / TAU).collect()
}

fn assert_frequencies(deck: &str, printed: &[f64], near: f64) {
    for (ours, printed) in frequencies_hz(deck, printed.len()).into_iter().zip(printed) {
        assert!((ours / printed - 1.0).abs() < near, "{ours} Hz beside {printed}");
    }
}

/// Beams along x between `elements + 1` grids of a metre, clamped; consistent mass, and bars that have twisting inertia.
fn cantilever(elements: u32) -> String {
    let mut deck =
        "NASTRAN BUFFSIZE=8193, BARMASS = 1\nSOL 103\nCEND\nSPC = 1\nBEGIN BULK\nPARAM,COUPMASS,1\n\
        MAT1,1,7.17+10,,.33,2810.\nSPC1,1,123456,1\n"
            .to_owned();
    for at in 0..=elements {
        let _ = writeln!(deck, "GRID,{},,{:?},0.,0.", at + 1, f64::from(at) / f64::from(elements));
    }
    deck
}

/// Fifty CBEAM that taper to half of a section of 6.25 by 25 mm, turned, off their grids, with neutral axis and other mass off the shear
/// centre: frequencies printed by Nastran (TACS, nastran_beam_compat, `cbeam_pbeam_taper_rotation_wa_n_nsm_m`; five digits of the sections). With
/// masses on lines that move with the section between the element's ends they are up to a hundredth off.
#[test]
fn beams_whose_masses_are_on_lines_of_their_own_have_the_printed_frequencies() {
    let mut deck = cantilever(50);
    let section = |at: u32| {
        let [thin, wide] = [0.00625, 0.025].map(|side| side * (1.0 - f64::from(at) / 100.0));
        let slender = thin / wide;
        let twisting = wide * thin.powi(3) * (1.0 / 3.0 - 0.21 * slender * (1.0 - slender.powi(4) / 12.0));
        let [i1, i2] = [wide * thin.powi(3) / 12.0, thin * wide.powi(3) / 12.0];
        format!("{:.4e},{i1:.4e},{i2:.4e},,{twisting:.4e},.4390625", thin * wide)
    };
    for at in 0..50 {
        let (id, next) = (at + 1, at + 2);
        let _ = writeln!(deck, "CBEAM,{id},{id},{id},{next},0.,.8660254,.5\n,,,,.0125,.05,,.0125,.05");
        let _ = writeln!(deck, "PBEAM,{id},1,{}\n,,,,,,,,", section(at));
        let _ = writeln!(deck, ",NO,1.,{}", section(at + 1));
        let _ = writeln!(deck, ",.8333333,.8333333\n,.00625,.025,,,.0125,.05");
    }
    let printed = [
        3.402_032_684_3,
        13.585_184_614,
        15.484_585_105,
        38.639_044_432,
        61.250_571_652,
        71.531_582_313,
        112.547_807_36,
        122.953_689_62,
        150.459_803_54,
        161.958_918_74,
        213.440_337_88,
        270.141_641_60,
    ];
    assert_frequencies(&deck, &printed, 2e-5);
}

/// Thirty CBAR, turned and off their grids, with other mass, of which BARMASS = 1 makes twisting inertia: printed by Nastran (the same source,
/// `cbar_pbar_rotation_wa_nsm`). The fourth is of torsion: without that inertia there is none.
#[test]
fn bars_twist_with_the_inertia_that_the_nastran_statement_gives_them() {
    let mut deck = cantilever(30) + "PBAR,1,1,.01,3.3333-5,2.0833-6,7.0213-6,28.1\n,\n,.8333333,.8333333\n";
    for id in 1..=30 {
        let _ = writeln!(deck, "CBAR,{id},1,{id},{},0.,.8660254,.5\n,,,,.4,.1,,.4,.1", id + 1);
    }
    let printed = [
        28.805_012_084,
        112.638_116_15,
        178.879_279_67,
        344.796_135_31,
        493.740_062_30,
        623.251_061_96,
        893.060_832_62,
        948.244_402_98,
        1_035.333_915_7,
        1_506.692_199_4,
    ];
    assert_frequencies(&deck, &printed, 2e-5);
}

/// A CTRIAR of slender thickness and a CQUADR, each held along a side and pushed at the other: tips as MSC Nastran 2005 prints them (pyNastran,
/// `models/sol200/d200obus`). Bending under a transverse force has 3/4 of the flexibility that the mean square of the arm gives.
#[test]
fn one_element_with_rotations_about_its_normal_bends_as_msc_prints() {
    let deck = "MAT1,1,1.,.8,.1\nCTRIAR,7051,7051,7051,7052,7053\nGRID,7051,,0.,0.,0.\nGRID,7052,,1.,0.,0.\n\
        GRID,7053,,.5,1.,0.\nSPC1,1,6,7053\nSPC1,1,12345,7051,7052\nFORCE,5,7053,,1.,0.,0.,1.\nPSHELL,7051,1,.1,1,1000.,1,1.\n\
        CQUADR,9901,9901,9901,9902,9903,9904\nGRID,9901,,0.,0.,0.\nGRID,9902,,1.,0.,0.\nGRID,9903,,1.,1.,0.\nGRID,9904,,0.,1.,0.\n\
        SPC1,1,125,9902,9903\nSPC1,1,12345,9901,9904\nFORCE,5,9902,,1.,0.,0.,1.\nFORCE,5,9903,,1.,0.,0.,1.\n\
        PSHELL,9901,1,1.,1,120.,1,1.\n";
    assert_printed(deck, [3], &[(7053, [31.93])], 2e-7);
    assert_printed(deck, [3], &[(9902, [2.512_375])], 2e-7);
}
