//! Wilson's score interval of a share (Wilson 1927): `(p + z²/2n ± z sqrt(p(1-p)/n + z²/4n²)) / (1 + z²/n)`.

/// The normal's 97.5 % point.
const Z: f64 = 1.959_963_984_540_054;

/// The 95 % interval of `hits` of `n`; all that is possible for none.
pub fn wilson(hits: usize, n: usize) -> (f64, f64) {
    if n == 0 {
        return (0.0, 1.0);
    }
    let (count, share) = (n as f64, hits as f64 / n as f64);
    let middle = share + Z * Z / (2.0 * count);
    let half = Z * (share * (1.0 - share) / count + Z * Z / (4.0 * count * count)).sqrt();
    let below = 1.0 + Z * Z / count;
    let low = if hits == 0 { 0.0 } else { (middle - half) / below };
    let high = if hits == n { 1.0 } else { (middle + half) / below };
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Newcombe, Statistics in Medicine 17 (1998), 857-872, Table I, method 3 (the score method without correction).
    #[test]
    fn published_intervals_come_out_to_their_four_digits() {
        for (hits, n, low, high) in [
            (81, 263, 0.2553, 0.3662),
            (15, 148, 0.0624, 0.1605),
            (0, 20, 0.0, 0.1611),
            (1, 29, 0.0061, 0.1718),
        ] {
            let (l, h) = wilson(hits, n);
            assert!((l - low).abs() < 5e-5 && (h - high).abs() < 5e-5, "{hits}/{n}: {l} {h}");
        }
    }

    #[test]
    fn the_interval_of_the_complement_is_the_complement() {
        let ((l, h), (cl, ch)) = (wilson(7, 50), wilson(43, 50));
        assert!((l - (1.0 - ch)).abs() < 1e-15 && (h - (1.0 - cl)).abs() < 1e-15);
    }
}
