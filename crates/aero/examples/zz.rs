use aero::*;
use faer::{Mat, c64};
use std::time::Instant;
fn aircraft() -> Lattice {
    let t = |id, a, c, b, d, n| Lattice::trapezoid(id, a, c, b, d, n).unwrap();
    let tip_x_m = 0.075 + 1.8 * 20_f64.to_radians().tan() - 0.0375;
    let wing = t(10_001, [0.0; 3], 0.30, [tip_x_m, 1.8, 0.0], 0.15, [12, 56]);
    let tail = t(30_001, [1.45, 0.0, 0.4], 0.18, [1.6, 0.45, 0.4], 0.11, [8, 12]);
    let fin = t(50_001, [1.25, 0.0, 0.0505], 0.28, [1.43, 0.0, 0.3995], 0.2, [9, 15]);
    let flat = t(60_001, [-0.9, -0.05, 0.0], 0.85, [-0.9, 0.05, 0.0], 0.85, [20, 4]);
    let upright = t(70_001, [-0.9, 0.0, -0.05], 0.85, [-0.9, 0.0, 0.05], 0.85, [20, 4]);
    let mut all = wing.clone();
    for p in [
        &wing.mirrored(0.0).0.renumbered(10_000).unwrap(),
        &tail,
        &tail.mirrored(0.0).0.renumbered(10_000).unwrap(),
        &fin,
        &flat,
        &upright,
    ] {
        all = all.joined(p).unwrap();
    }
    all
}
fn main() {
    let l = aircraft();
    println!("{} boxes", l.len());
    for mach in [0.0, 0.1] {
        let t = Instant::now();
        let d = DoubletLattice::new(&l, MirrorPlane::None, mach, &DlmSettings::default()).unwrap();
        println!("setup {:?}", t.elapsed());
        let t = Instant::now();
        let m = d.influence(0.5).unwrap();
        println!("influence {:?} {}", t.elapsed(), m[(3, 4)]);
        let t = Instant::now();
        let a = d.at(0.5).unwrap();
        println!("with lu {:?}", t.elapsed());
        let w = Mat::from_fn(l.len(), 70, |i, j| c64::new((i * j) as f64, 1.0));
        let t = Instant::now();
        let p = a.pressures(w.as_ref());
        println!("solve {:?} {}", t.elapsed(), p[(0, 0)]);
    }
}
