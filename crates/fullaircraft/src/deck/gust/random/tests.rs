//! Random answers: mean squares and crossings of densities made of straight lines.

use super::RandomAnswer;

#[test]
fn a_level_density_has_its_area_and_the_crossings_of_its_second_moment() {
    // S = 4 from 1 to 3 Hz: A² = 8, int f² S = 4 (27 - 1)/3
    let answer = RandomAnswer::new(&[1.0, 1.5, 3.0], vec![4.0; 3]);
    assert!((answer.rms - 8.0_f64.sqrt()).abs() < 1e-14);
    let law = (4.0 * 26.0 / 3.0 / 8.0_f64).sqrt();
    assert!((answer.n0_hz.expect("it moves") - law).abs() < 1e-14);
}

#[test]
fn a_density_that_rises_with_the_frequency_has_the_moments_of_its_powers() {
    // S = f from 1 to 2 Hz: A² = 3/2, int f³ = 15/4
    for hz in [vec![1.0, 2.0], vec![1.0, 1.2, 1.7, 2.0]] {
        let answer = RandomAnswer::new(&hz, hz.clone());
        assert!((answer.rms - 1.5_f64.sqrt()).abs() < 1e-14);
        assert!((answer.n0_hz.expect("it moves") - 2.5_f64.sqrt()).abs() < 1e-13);
    }
    let still = RandomAnswer::new(&[1.0, 2.0], vec![0.0; 2]);
    assert_eq!((still.rms, still.n0_hz), (0.0, None));
}
