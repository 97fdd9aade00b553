//! Parities of permutations.

use super::permutation_is_odd;

#[test]
fn a_permutation_is_odd_by_the_number_of_its_exchanges() {
    for (permutation, odd) in [
        (&[][..], false),
        (&[0], false),
        (&[0, 1, 2], false),
        (&[1, 0], true),
        (&[1, 0, 2], true),
        (&[0, 2, 1, 3], true),
        (&[1, 2, 0], false),
        (&[1, 0, 3, 2], false),
        (&[1, 2, 3, 0], true),
        (&[1, 2, 0, 4, 3], true),
        (&[3, 0, 1, 2, 5, 4], false),
    ] {
        assert_eq!(permutation_is_odd(permutation), odd, "{permutation:?}");
        // One exchange more turns it.
        if permutation.len() > 1 {
            let mut exchanged = permutation.to_vec();
            exchanged.swap(0, permutation.len() - 1);
            assert_eq!(permutation_is_odd(&exchanged), !odd, "{exchanged:?}");
        }
    }
}
