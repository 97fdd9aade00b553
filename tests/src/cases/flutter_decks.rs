//! Flutter of wings given by small decks (data/published/flutter__*.json).
//!
//! The cases' files name decks that they do not hold. What is needed of them, a few dozen numbers each, stands here with
//! its source; the decks are written anew from them.

use crate::registry::Case;
use crate::row::{Row, worst};
use crate::{list, number, numbers};
use aero::{DlmSettings, DoubletLattice, Flow, Lattice, MirrorPlane};
use coupling::Spline;
use faer::Mat;
use maneuver::flutter::{Aeroelastic, FlutterCurves, gaf_table};
use serde_json::Value;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use structure::{Model, System, normal_modes};

/// The cases of this file.
pub const CASES: &[Case] = &[Case { file: "flutter__swept15_d10023a", run: swept_beam }];

/// As Nastran's doublet lattice.
pub const NASTRAN: DlmSettings = DlmSettings::NASTRAN;

/// A structure from cards, its first modes, and how boxes move with them.
pub struct DeckWing {
    /// Boxes of its CAERO1.
    pub lattice: Lattice,
    /// Natural frequencies.
    pub omega_rad_s: Vec<f64>,
    /// Shapes of mass one at the boxes, two rows each.
    pub motion: Mat<f64>,
}

impl DeckWing {
    /// Boxes on a beam spline through all grids in their order.
    ///
    /// # Panics
    /// If the deck cannot be read or solved.
    pub fn new(deck: &str, modes: usize) -> Self {
        let bulk = nastran::parse_deck("a published case", deck).unwrap_or_else(|error| panic!("{error}"));
        let lattice = Lattice::from_bulk(&bulk).unwrap_or_else(|error| panic!("{error}"));
        let model = Model::from_bulk(&bulk).unwrap_or_else(|error| panic!("{error}"));
        let system = System::assemble(&model).unwrap_or_else(|error| panic!("{error}"));
        let found = normal_modes(&system, modes).unwrap_or_else(|error| panic!("{error}"));
        let nodes: Vec<usize> = (0..system.node_count()).collect();
        let spline = Spline::beam(&lattice, system.points(), &nodes);
        let shapes = system.expand(found.shapes.as_ref());
        Self { motion: spline.displace(shapes.as_ref()), lattice, omega_rad_s: found.omega_rad_s }
    }

    /// Roots of the first `modes` modes at airspeeds and a density, with a table at omega/V.
    ///
    /// # Panics
    /// If the lattice cannot be solved or a mode is lost.
    pub fn pk(
        &self,
        doublets: &DoubletLattice,
        modes: usize,
        kappa: &[f64],
        flows: &[Flow],
    ) -> FlutterCurves {
        let motion = self.motion.subcols(0, modes);
        let forces = gaf_table(&self.lattice, doublets, motion, None, kappa).expect("rising frequencies");
        let system = Aeroelastic::of_modes(&self.omega_rad_s[..modes], 0.0, &forces).expect("as many modes");
        system.pk(flows).unwrap_or_else(|error| panic!("{error}"))
    }
}

/// The swept plate as a beam of eleven grids along its axis, torsional inertia lumped: facts of NASA's demonstration
/// problem D10-02-3A (github.com/nasa/NASTRAN-95, inp/d10023a.inp, NASA Open Source Agreement), in, lb s²/in, s.
fn swept_beam_deck() -> String {
    let mut deck = String::from(
        "CORD2R,1,,0.,0.,0.,0.,0.,1.,+\n+,.96593,-.25882,0.\nMAT1,1,10.4+6,3.9+6,,2.61-4\nPARAM,COUPMASS,1\n\
         PBAR,1,1,7.175-2,9.83-6,9.83-6,36.8-6\nPAERO1,1\n\
         CAERO1,101,1,1,6,4,,,1,+\n+,-1.,-.26795,0.,2.0706,-1.,5.45205,0.,2.0706\n",
    );
    for i in 1_u32..=11 {
        let fixed = if i == 1 { "123456" } else { "126" };
        let _ = writeln!(deck, "GRID,{i},1,0.,{:?},0.,1,{fixed}", 0.572 * f64::from(i - 1));
        if i > 1 {
            let inertia = if i == 11 { 1.4e-6 } else { 2.8e-6 };
            let (before, mass) = (i - 1, i + 10);
            let _ = writeln!(deck, "CBAR,{before},1,{before},{i},0.,0.,1.\nCMASS2,{mass},{inertia:?},{i},5");
        }
    }
    deck
}

/// Six modes, the roots of three by p-k, and where the second flutters. The source tables k = .0001, .1 and .2 only and
/// extrapolates to .41, in a way that gives nearly what a table to .5 gives; a parabola through its three would not.
fn swept_beam(case: &Value) -> Vec<Row> {
    let (expected, tolerance) = (&case["expected"], |name: &str| &case["tolerance"][name]);
    let f = number(tolerance("f"));
    let wing = DeckWing::new(&swept_beam_deck(), 6);
    let mut rows = Vec::new();
    for (i, want) in numbers(&expected["modes_hz"]).into_iter().enumerate() {
        rows.push(Row::relative(format!("mode {} (Hz)", i + 1), wing.omega_rad_s[i] / TAU, want, f));
    }
    let mach = number(&case["inputs"]["mach"]);
    let doublets = DoubletLattice::new(&wing.lattice, MirrorPlane::None, mach, &NASTRAN).expect("one wing");
    let kappa: Vec<f64> =
        [0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.5].map(|k| k / (0.5 * 2.0706)).to_vec();
    let rho_kg_m3 = number(&expected["flutter"]["1"]["density_ratio"]) * 1.145e-7;
    let speeds = [1000.0, 2000.0, 3000.0, 4000.0, 5000.0, 5500.0, 5980.0, 6100.0, 6200.0];
    let flows = speeds.map(|v_m_s| Flow { v_m_s, rho_kg_m3 });
    let curves = wing.pk(&doublets, 3, &kappa, &flows);
    for (mode, branch) in curves.branches.iter().enumerate() {
        let [mut damping, mut frequency] = [Vec::new(), Vec::new()];
        for printed in list(&expected["flutter"][(mode + 1).to_string()]["rows"]) {
            // k, 1/k, airspeed, g, Hz
            let printed = numbers(printed);
            let place = speeds.iter().position(|v| *v == printed[2]).expect("an airspeed of the table");
            let (g, hz) = (branch[place].damping_g().unwrap_or(f64::NAN), branch[place].frequency_hz());
            let abs = tolerance("g").as_str().and_then(|text| text.split(' ').next()).unwrap_or_default();
            let abs: f64 = abs.parse().expect("a number and 'abs'");
            damping.push(Row::absolute(format!("at {} in/s", printed[2]), g, printed[3], abs));
            frequency.push(Row::relative(format!("at {} in/s (Hz)", printed[2]), hz, printed[4], f));
        }
        rows.push(worst(&format!("mode {} damping g", mode + 1), damping));
        rows.push(worst(&format!("mode {} frequency", mode + 1), frequency));
    }
    let want = numbers(&expected["flutter"]["2"]["zero_crossings_V_f"][0]);
    let flutter = curves.flutter().expect("the second mode flutters");
    let (v, hz) = (flutter.flow.v_m_s, flutter.omega_rad_s / TAU);
    rows.push(Row::relative("flutter speed (in/s)", v, want[0], number(tolerance("V"))));
    rows.push(Row::relative("flutter frequency (Hz)", hz, want[1], f));
    rows
}
