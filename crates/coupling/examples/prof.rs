//! Timing.
use std::time::Instant;
fn main() {
    let f = coupling::WingFile::read(std::path::Path::new("data/tuflex/wing_shell.ron")).unwrap();
    let t = Instant::now();
    let bulk = f.bulk(coupling::Mount::Tunnel).unwrap();
    println!("bulk {:?}", t.elapsed());
    let t = Instant::now();
    let model = structure::Model::from_bulk(&bulk).unwrap();
    println!("model {:?}", t.elapsed());
    let t = Instant::now();
    let s = structure::System::assemble(&model).unwrap();
    println!("assemble {:?} nnz {}", t.elapsed(), s.stiffness().val().len());
    let t = Instant::now();
    let fl = structure::Flexibility::new(&s).unwrap();
    println!("flex {:?}", t.elapsed());
    let t = Instant::now();
    let z = faer::Mat::<f64>::zeros(s.free_count(), 28);
    let _ = fl.displacements(z.as_ref());
    println!("solve 28 {:?}", t.elapsed());
    let t = Instant::now();
    let m = structure::normal_modes(&s, 20).unwrap();
    println!("modes {:?} {:?}", t.elapsed(), m.omega_rad_s[0]);
}
