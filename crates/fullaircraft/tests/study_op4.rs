//! Mass matrices of OP4 files in all their forms, written here as Nastran's OUTPUT4 lays them out, and by pyNastran (`data/README.md`).

use fullaircraft::study::{MassTerms, read_terms};
use nastran::op4_text;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Reads bytes as a file of a name of its own.
fn read(name: &str, bytes: &[u8]) -> Result<MassTerms, String> {
    let path = std::env::temp_dir().join(format!("wingroot_{}_{name}.op4", std::process::id()));
    std::fs::write(&path, bytes).expect("a file");
    let found = read_terms(&path).map_err(|error| error.to_string());
    std::fs::remove_file(&path).expect("our own file");
    found
}

/// Four rows: (0, 0) 2.5, (1, 1) -3, (2, 1) 0.5, (1, 2) 0.5, (3, 3) 100.
fn expected() -> MassTerms {
    let terms = vec![(0, 0, 2.5), (1, 1, -3.0), (2, 1, 0.5), (1, 2, 0.5), (3, 3, 100.0)];
    MassTerms::Rows { count: 4, terms }
}

/// Row of the first number and numbers of each string, a list a column.
fn strings() -> [Vec<(usize, Vec<f64>)>; 4] {
    [vec![(1, vec![2.5])], vec![(2, vec![-3.0, 0.5])], vec![(2, vec![0.5])], vec![(4, vec![100.0])]]
}

const END: &str = "       5       1       1\n 1.000000000E+00\n";

/// Dense columns of 5E16.9: three numbers of the second lie side by side, a blank only before those above zero.
fn dense(name: &str) -> String {
    format!(
        "       4       4       6       2{name:<8}1P,5E16.9\n       1       1       1\n 2.500000000E+00\n       2       2       2\n\
         -3.000000000E+00 5.000000000E-01\n       3       2       1\n 5.000000000E-01\n       4       4       1\n 1.000000000E+02\n{END}"
    )
}

#[test]
fn dense_columns_in_ascii_are_read_by_their_format() {
    assert_eq!(read("dense", dense("MGG").as_bytes()), Ok(expected()));
    let d = dense("MGG").replace("E+", "D+").replace("E-", "D-").replace("5E16.9", "5D16.9");
    assert_eq!(read("d", d.as_bytes()), Ok(expected()));
    // from blanks on, where the head has no format
    let bare = dense("MGG").replace("MGG     1P,5E16.9", "MGG");
    assert_eq!(read("bare", bare.as_bytes()), Ok(expected()));
    // sixteen columns a number
    let long = dense("MGG").replacen(
        "       4       4       6       2MGG     1P,5E16.9",
        &format!("{:16}{:16}{:16}{:16}MGG     1P,5E16.9|I16", 4, 4, 6, 2),
        1,
    );
    assert_eq!(read("long", long.as_bytes()), Ok(expected()));
    // what wingroot writes itself, which pyNastran reads (tests/peers/read_op4.py)
    let mut columns = vec![vec![0.0; 4]; 4];
    for (column, strings) in columns.iter_mut().zip(strings()) {
        for (row, values) in strings {
            column[row - 1..row - 1 + values.len()].copy_from_slice(&values);
        }
    }
    assert_eq!(read("own", op4_text("M", &columns).as_bytes()), Ok(expected()));
}

#[test]
fn a_column_with_zeros_between_and_over_several_lines_has_what_is_not_zero() {
    let text = "       7       7       1       1M       1P,3E23.16\n       2       1       7\n 1.0000000000000000E+00 0.0000000000000000E+00\
                 0.0000000000000000E+00\n-2.0000000000000000E+00 0.0000000000000000E+00 0.0000000000000000E+00\n 3.0000000000000000E-10\n\
                \x20      8       1       1\n 1.0000000000000000E+00\n";
    let terms = vec![(0, 1, 1.0), (3, 1, -2.0), (6, 1, 3e-10)];
    assert_eq!(read("lines", text.as_bytes()), Ok(MassTerms::Rows { count: 7, terms }));
}

/// Strings in ASCII: a number of double precision has two words, and a string's head one (two of BIGMAT).
fn of_strings(is_big: bool, kind: usize) -> String {
    let words = if kind == 2 { 2 } else { 1 };
    let rows = if is_big { -4 } else { 4 };
    let mut text = format!("{:8}{rows:8}{:8}{kind:8}MGG     1P,5E16.9\n", 4, 6);
    for (column, strings) in (1..).zip(strings()) {
        let length: usize =
            strings.iter().map(|(_, values)| words * values.len() + if is_big { 2 } else { 1 }).sum();
        let _ = writeln!(text, "{column:8}{:8}{length:8}", 0);
        for (row, values) in strings {
            let longer = words * values.len() + 1;
            let _ = if is_big {
                writeln!(text, "{longer:8}{row:8}")
            } else {
                writeln!(text, "{:8}", row + 65_536 * longer)
            };
            let numbers: Vec<String> =
                values.iter().map(|value| format!("{:>16}", exponential(*value))).collect();
            let _ = writeln!(text, "{}", numbers.concat());
        }
    }
    text + END
}

/// 5E16.9: `-3.000000000E+00`.
fn exponential(value: f64) -> String {
    let text = format!("{value:.9E}");
    let (digits, power) = text.split_once('E').expect("an exponent");
    let power: i32 = power.parse().expect("a whole number");
    format!("{digits}E{}{:02}", if power < 0 { '-' } else { '+' }, power.abs())
}

#[test]
fn strings_in_ascii_are_read_with_both_heads() {
    for kind in [1, 2] {
        for is_big in [false, true] {
            let text = of_strings(is_big, kind);
            assert_eq!(read("strings", text.as_bytes()), Ok(expected()), "{text}");
        }
    }
    // two strings of one column: rows 1 and 3 of three
    let two = "       3      -3       6       2M       1P,5E16.9\n       1       0       8\n       3       1\n 7.000000000E+00\n       3       3\n\
               \x208.000000000E+00\n       4       1       1\n 1.000000000E+00\n";
    let terms = vec![(0, 0, 7.0), (2, 0, 8.0)];
    assert_eq!(read("two", two.as_bytes()), Ok(MassTerms::Rows { count: 3, terms }));
}

/// How a binary file is written.
#[derive(Debug, Clone, Copy)]
struct Form {
    is_big_endian: bool,
    is_long: bool,
    kind: i64,
    /// Dense, strings, BIGMAT.
    strings: Option<bool>,
}

impl Form {
    fn ordered<const N: usize>(self, bytes: [u8; N]) -> Vec<u8> {
        let mut bytes = bytes.to_vec();
        if self.is_big_endian {
            bytes.reverse();
        }
        bytes
    }

    fn whole(self, value: i64) -> Vec<u8> {
        if self.is_long {
            return self.ordered(value.to_le_bytes());
        }
        self.ordered(i32::try_from(value).expect("small").to_le_bytes())
    }

    /// Numbers, and how many words they have.
    fn reals(self, values: &[f64]) -> (Vec<u8>, usize) {
        #[expect(clippy::cast_possible_truncation, reason = "numbers that single precision has")]
        let bytes = |value: &f64| {
            if self.kind == 1 && !self.is_long {
                self.ordered((*value as f32).to_le_bytes())
            } else {
                self.ordered(value.to_le_bytes())
            }
        };
        let all: Vec<u8> = values.iter().flat_map(bytes).collect();
        let words = all.len() / if self.is_long { 8 } else { 4 };
        (all, words)
    }

    fn record(self, parts: &[Vec<u8>]) -> Vec<u8> {
        let inside = parts.concat();
        let length = self.ordered(u32::try_from(inside.len()).expect("small").to_le_bytes());
        [length.clone(), inside, length].concat()
    }

    fn head(self, name: &str, rows: i64, columns: i64) -> Vec<u8> {
        let width = if self.is_long { 16 } else { 8 };
        let rows = if self.strings == Some(true) { -rows } else { rows };
        let numbers = [columns, rows, 6, self.kind].map(|value| self.whole(value)).concat();
        self.record(&[numbers, format!("{name:<width$}").into_bytes()])
    }

    fn column(self, column: i64, strings: &[(usize, Vec<f64>)]) -> Vec<u8> {
        let word = |count: usize| self.whole(i64::try_from(count).expect("small"));
        if self.strings.is_none() {
            let (row, values) = &strings[0];
            let (bytes, words) = self.reals(values);
            return self.record(&[self.whole(column), word(*row), word(words), bytes]);
        }
        let is_big = self.strings == Some(true);
        let mut inside = Vec::new();
        for (row, values) in strings {
            let (bytes, words) = self.reals(values);
            if is_big {
                inside.extend([word(words + 1), word(*row)].concat());
            } else {
                inside.extend(word(row + 65_536 * (words + 1)));
            }
            inside.extend(bytes);
        }
        let length = inside.len() / if self.is_long { 8 } else { 4 };
        self.record(&[self.whole(column), word(0), word(length), inside])
    }

    fn end(self, columns: i64) -> Vec<u8> {
        let (bytes, words) = self.reals(&[1.0]);
        let words = i64::try_from(words).expect("small");
        self.record(&[self.whole(columns + 1), self.whole(1), self.whole(words), bytes])
    }

    fn file(self, name: &str) -> Vec<u8> {
        let columns = (1..).zip(strings()).flat_map(|(at, strings)| self.column(at, &strings));
        [self.head(name, 4, 4), columns.collect(), self.end(4)].concat()
    }
}

const PLAIN: Form = Form { is_big_endian: false, is_long: false, kind: 2, strings: None };

#[test]
fn binary_files_are_read_in_all_their_forms() {
    for is_big_endian in [false, true] {
        for is_long in [false, true] {
            for kind in [1, 2] {
                for strings in [None, Some(false), Some(true)] {
                    let form = Form { is_big_endian, is_long, kind, strings };
                    assert_eq!(read("binary", &form.file("MGG")), Ok(expected()), "{form:?}");
                }
            }
        }
    }
}

#[test]
fn mgg_is_taken_among_several_and_others_are_passed_over() {
    let stiffness = |text: &str| text.replace("2.500000000E+00", "9.000000000E+00");
    let texts = [stiffness(&dense("KGG")), dense("MGG"), stiffness(&dense("BGG"))];
    assert_eq!(read("several", texts.concat().as_bytes()), Ok(expected()));
    // a complex one, whose numbers come in pairs, before it
    let complex = "       4       4       2       4C       1P,5E16.9\n       2       3       4\n 1.000000000E+00 0.000000000E+00 2.000000000E+00\
                   \x200.000000000E+00\n";
    assert_eq!(read("complex", [complex, END, &dense("MGG")].concat().as_bytes()), Ok(expected()));
    let binary = [PLAIN.file("KGG"), PLAIN.file("MGG"), PLAIN.file("X")].concat();
    assert_eq!(read("binaries", &binary), Ok(expected()));
    let none = read("none", [dense("KGG"), dense("BGG")].concat().as_bytes()).expect_err("no MGG");
    assert!(none.contains("2 matrices, KGG, BGG, and none is called MGG"), "{none}");
    let twice =
        read("twice", [dense("MGG"), dense("KGG"), dense("MGG")].concat().as_bytes()).expect_err("two");
    assert!(twice.contains("several matrices called MGG: MGG, KGG, MGG"), "{twice}");
    let alone = read("alone", [complex, END].concat().as_bytes()).expect_err("complex");
    assert!(alone.contains("C is complex (type 4), which is no mass matrix"), "{alone}");
}

#[test]
fn what_is_no_matrix_in_ascii_is_refused_at_its_line() {
    let right = dense("MGG");
    for (from, to, line, said) in [
        (
            "       4       4       6       2MGG",
            "       4       x       6       2MGG",
            1,
            "no head of a matrix",
        ),
        (
            "       4       4       6       2MGG",
            "       0       0       6       2MGG",
            1,
            "no head of a matrix",
        ),
        (
            "       4       4       6       2MGG",
            "       4       4       6       7MGG",
            1,
            "no head of a matrix",
        ),
        ("1P,5E16.9", "1P,5F16", 1, "no head of a matrix"),
        (
            "       2       2       2\n",
            "       2       2\n",
            4,
            "a column with its first row and length is expected",
        ),
        ("       2       2       2\n", "       0       2       2\n", 4, "a record of column 0"),
        ("       2       2       2\n", "       2      -2       2\n", 4, "a record of column 2 from row -2"),
        (
            "       2       2       2\n",
            "       2       4       2\n",
            5,
            "2 numbers from row 4 on, and MGG has 4 rows",
        ),
        (
            "       2       2       2\n",
            "       2       2       9\n",
            5,
            "where a real number of 16 columns is expected",
        ),
        ("-3.000000000E+00", "-3.0000000x0E+00", 5, "`-3.0000000x0E+00` where a real number"),
        ("-3.000000000E+00", "             NaN", 5, "`NaN` where a real number"),
        (END, "", 9, "the file ends where a column"),
    ] {
        let text = right.replacen(from, to, 1);
        assert_ne!(text, right, "{from}");
        let error = read("wrong", text.as_bytes()).expect_err(said);
        assert!(error.contains(&format!(".op4:{line}:1")) && error.contains(said), "{line} {said}: {error}");
    }
}

#[test]
fn what_is_no_mass_matrix_or_no_string_in_ascii_is_refused() {
    let right = dense("MGG");
    for (from, to, said) in [
        ("       4       4       6", "       4       5       6", "MGG has 5 rows, 4 columns and the form 6"),
        ("       4       4       6", "       4       4       3", "the form 3, which is no mass matrix"),
    ] {
        let error = read("shape", right.replacen(from, to, 1).as_bytes()).expect_err(said);
        assert!(error.contains(said), "{error}");
    }
    assert!(read("empty", b"").expect_err("empty").contains("no matrix in this OP4 file"));
    for (to, said) in [
        ("  999999", "a string of 14 words in 5 that are left"),
        ("       7", "a string of 0 words from row 7"),
        ("       x", "a string with its length and first row in one is expected"),
    ] {
        let text = of_strings(false, 2).replacen("  327682", to, 1);
        let error = read("string", text.as_bytes()).expect_err(said);
        assert!(error.contains(said) && error.contains(".op4:6:1"), "{said}: {error}");
    }
}

#[test]
fn binary_files_that_are_cut_or_lie_are_refused_without_more_memory_than_they_have() {
    for form in
        [PLAIN, Form { is_long: true, strings: Some(true), ..PLAIN }, Form { strings: Some(false), ..PLAIN }]
    {
        let right = form.file("MGG");
        for end in 0..right.len() {
            assert!(read("cut", &right[..end]).is_err(), "{form:?}: {end} of {} bytes", right.len());
        }
        // every word as large and as small as it can be: an error or another matrix, and no more
        for at in (0..right.len()).step_by(4) {
            for lie in [[0xFF; 4], [0, 0, 0, 0x80], [0xFF, 0xFF, 0xFF, 0x7F]] {
                let mut wrong = right.clone();
                wrong[at..at + 4].copy_from_slice(&lie);
                let _ = read("lie", &wrong);
            }
        }
    }
    // the length of the first column, behind the head of 32 bytes, the record's length, column and row
    let mut longer = PLAIN.file("MGG");
    longer[44] = 6;
    let error = read("longer", &longer).expect_err("six words");
    assert!(error.contains("3 numbers in a record that has 1 left"), "{error}");
    let mut infinite = PLAIN.file("MGG");
    let at = infinite.windows(8).position(|bytes| bytes == 2.5_f64.to_le_bytes()).expect("the first term");
    infinite[at..at + 8].copy_from_slice(&f64::INFINITY.to_le_bytes());
    assert!(read("infinite", &infinite).expect_err("infinite").contains("inf is not a finite number"));
    let long = PLAIN.record(&[vec![0; 12]]);
    let error = read("short", &[PLAIN.head("MGG", 4, 4), long].concat()).expect_err("a record of column 0");
    assert!(error.contains("a record of column 0") && error.contains("(byte "), "{error}");
}

/// Mass of a body of 4 whose centre lies .09375 behind its grid, and of a scalar point: `MGG`, in most files behind another matrix.
#[test]
fn files_of_other_programs_are_read() {
    let lumps = [4.0, 4.0, 4.0, 0.5, 1.25, 1.5, 0.125];
    let products = [(1, 5, 0.375), (5, 1, 0.375), (2, 4, -0.375), (4, 2, -0.375)];
    let mut expected: Vec<(usize, usize, f64)> =
        lumps.into_iter().enumerate().map(|(i, value)| (i, i, value)).chain(products).collect();
    expected.sort_by_key(|(row, column, _)| (*column, *row));
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/op4");
    let files: Vec<PathBuf> =
        std::fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.path()).collect();
    assert_eq!(files.len(), 9);
    for path in files {
        let terms = read_terms(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(terms, MassTerms::Rows { count: 7, terms: expected.clone() }, "{}", path.display());
    }
}
