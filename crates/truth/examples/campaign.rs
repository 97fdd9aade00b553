//! A campaign of a true wing without anything hidden: `cargo run -p wingroot-truth --example campaign -- OUT [SEED] [WING]`.

use std::path::Path;
use truth::campaign::Files;
use truth::{Order, Tunnel};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |place: usize| words.get(place).and_then(|word| word.parse().ok());
    let out = words.first().map_or("out/campaign", String::as_str);
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
    let tunnel = Tunnel::new(&data.join("wing_beam.ron"), &data.join("e214_neuralfoil_polars.csv"))?;
    let order = Order {
        seed: number(1).unwrap_or(1),
        wing: number(2),
        effects: Vec::new(),
        servo: None,
        wind_off: true,
    };
    let measured = tunnel.measure(&order);
    Files::of(&measured, &tunnel.planned(&order), &tunnel.controls)
        .write(&Path::new(out).join("measured"))?;
    Files::of_reference(&measured).write(&Path::new(out).join("reference"))?;
    Ok(())
}
