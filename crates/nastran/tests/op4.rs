//! OUTPUT4 files in ASCII, line by line.

use nastran::op4_text;

#[test]
fn a_matrix_is_written_in_the_records_of_output4() {
    let text = op4_text("AB", &[vec![0.0, -1.5, 0.1], vec![0.0; 3], vec![1e-9, 0.0, 1e300]]);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "       3       3       1       2AB      1P,3E24.16");
    assert_eq!(lines[1], "       1       2       2");
    assert_eq!(lines[2], " -1.5000000000000000E+00  1.0000000000000001E-01");
    assert_eq!(lines[3], "       3       1       3");
    assert_eq!(lines[4], "  1.0000000000000001E-09  0.0000000000000000E+00 1.0000000000000001E+300");
    assert_eq!(lines[5], "       4       1       1");
    assert_eq!(lines[6], "  1.0000000000000000E+00");
}
