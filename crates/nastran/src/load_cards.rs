//! Loads at grids out: FORCE and MOMENT in the basic system, in 16-character fields always, so that numbers keep ten digits.

use crate::real;
use std::fmt::Write as _;

/// What is not above this share of the largest number of its kind is zero: at 1e-12 the moments left out of a wing of shells, alike in sign, move
/// its tip by 1e-9.
const NOTHING: f64 = 1e-13;
/// Width of a field.
const WIDTH: usize = 16;

/// FORCE* and MOMENT* of loads at grids: `loads` has six numbers a grid (forces, then moments, along the basic axes).
///
/// Forces and moments up to 1e-13 of the largest force or moment are left out.
pub fn load_cards(set: u32, grids: &[u32], loads: &[f64]) -> String {
    let largest = |from: usize| {
        let of = loads.chunks_exact(6).flat_map(|six| &six[from..from + 3]);
        of.fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    let mut text = String::new();
    for (name, from, largest) in [("FORCE*", 0, largest(0)), ("MOMENT*", 3, largest(3))] {
        for (grid, six) in grids.iter().zip(loads.chunks_exact(6)) {
            let kept = |value: &f64| if value.abs() > NOTHING * largest { *value } else { 0.0 };
            let vector: Vec<f64> = six[from..from + 3].iter().map(kept).collect();
            if vector.iter().all(|value| *value == 0.0) {
                continue;
            }
            let [x, y, z] = [0, 1, 2].map(|axis| real::format(vector[axis], WIDTH));
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{name:<8}{set:>16}{grid:>16}{:>16}{:>16}", 0, "1.");
            let _ = writeln!(text, "*       {x:>16}{y:>16}{z:>16}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::load_cards;
    use crate::parse_deck;

    #[test]
    fn numbers_of_any_size_keep_ten_digits_and_nothing_is_nothing() {
        // near powers of ten, very large, very small beside others of their kind
        let forces = [-1.5e10, 999.999_999_949_9, 0.1, 1.000_000_000_1, -0.099_999_999_99, 123.456_789_012_3];
        for (place, &force) in forces.iter().enumerate() {
            for scale in [1.0, 1e-12, 1e-5, 1e7] {
                let mut loads = vec![0.0; 12];
                (loads[place % 3], loads[6 + 3 + place % 3]) = (force * scale, -force * scale);
                let deck = parse_deck("cards", &load_cards(7, &[11, 12], &loads)).unwrap();
                assert_eq!(deck.point_loads.len(), 2, "one force, one moment");
                for card in &deck.point_loads {
                    assert_eq!((card.set, card.grid, card.cid), (7, if card.is_moment { 12 } else { 11 }, 0));
                    let sign = if card.is_moment { -1.0 } else { 1.0 };
                    let (read, written) = (card.vector[place % 3], sign * force * scale);
                    assert!((read - written).abs() <= 5e-11 * written.abs(), "{read} for {written}");
                }
            }
        }
        let text = load_cards(1, &[1, 2], &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-13, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(text.matches("FORCE*").count(), 1, "beside 1 N, 1e-13 N is nothing: {text}");
    }

    #[test]
    fn cards_are_in_fields_of_sixteen_characters() {
        let text =
            load_cards(99_999_999, &[12_345_678], &[-1.0 / 3.0, 2.0e-4 / 3.0, 0.0, 0.0, 0.0, 1.0e11 / 3.0]);
        for line in text.lines() {
            assert!(line.len() <= 72 && line.is_char_boundary(8), "{line}");
            assert_eq!((line.len() - 8) % 16, 0, "{line}");
        }
        assert!(text.starts_with("FORCE*          99999999        12345678"), "{text}");
    }
}
