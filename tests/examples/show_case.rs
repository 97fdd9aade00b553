fn main() {
    for name in std::env::args().skip(1) {
        let case = validation::registry::cases().find(|c| c.file == name).unwrap();
        let start = std::time::Instant::now();
        for row in (case.run)(&validation::published(&name)) {
            println!(
                "{:60} {:>14.7} {:>14.7} {:+.3e} {} {}",
                row.quantity,
                row.ours,
                row.reference,
                row.ours / row.reference - 1.0,
                row.tolerance_text(),
                row.verdict()
            );
        }
        println!("{name} {:?}", start.elapsed());
    }
}
