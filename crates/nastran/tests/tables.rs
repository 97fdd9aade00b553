//! CSV tables, and the names somebody probably meant.

use nastran::Table;

const TABLE: &str =
    "# measured\nV_m_s, alpha_deg,note\n\n18,  1.5,\"a, \"\"b\"\"\"\n# between\n22,,none\nnan,x1,\n";

fn message(error: &nastran::InputError) -> String {
    error.to_string()
}

#[test]
fn cells_are_found_by_row_and_column_name() {
    let table = Table::parse("t.csv", TABLE).expect("a good table");
    assert_eq!(table.columns().collect::<Vec<_>>(), ["V_m_s", "alpha_deg", "note"]);
    assert_eq!((table.len(), table.is_empty(), table.has("note"), table.has("x")), (3, false, true, false));
    assert_eq!(table.number(0, "alpha_deg"), Ok(1.5));
    assert_eq!(table.text(0, "note"), Ok("a, \"b\""));
    assert_eq!(table.span(0, "alpha_deg").to_string(), "t.csv:4:6");
    assert_eq!(
        Table::parse("t.csv", "a\r\n1\r\n2\r\n").and_then(|table| table.numbers("a")),
        Ok(vec![1.0, 2.0])
    );
}

#[test]
fn cells_that_are_no_numbers_are_refused_with_their_place() {
    let table = Table::parse("t.csv", TABLE).expect("a good table");
    let number = |row, column| message(&table.number(row, column).expect_err("must be refused"));
    assert_eq!(
        number(1, "alpha_deg"),
        "t.csv:6:4: column `alpha_deg` is empty here; expected a number (hint: fill the cell, or take the row out)"
    );
    assert_eq!(
        number(2, "V_m_s"),
        "t.csv:7:1: `nan` in column `V_m_s` is not a finite number (hint: write a number such as 1.5 or -2e-3, or take the row out)"
    );
    assert_eq!(
        number(2, "alpha_deg"),
        "t.csv:7:5: `x1` in column `alpha_deg` is not a finite number (hint: write a number such as 1.5 or -2e-3, or take the row out)"
    );
    assert_eq!(number(3, "V_m_s"), "t.csv: the table has 3 rows; row 4 is wanted");
}

#[test]
fn misspelt_columns_are_named_with_what_was_meant() {
    let table = Table::parse("t.csv", "V_ms,alpha_deg\n1,2\n").expect("a good table");
    assert_eq!(
        message(&table.require(&["alpha_deg", "V_m_s"]).unwrap_err()),
        "t.csv:1: the column `V_m_s` is missing (hint: is `V_ms` meant to be `V_m_s`?)"
    );
    assert_eq!(
        message(&table.require(&["mass_kg"]).unwrap_err()),
        "t.csv:1: the column `mass_kg` is missing (hint: the columns here are V_ms, alpha_deg)"
    );
    let known = |name: &str| ["V_m_s", "alpha_deg"].contains(&name);
    assert_eq!(
        message(&table.allow_only(known, "`V_m_s`, `alpha_deg`").unwrap_err()),
        "t.csv:1:1: unknown column `V_ms`; expected `V_m_s`, `alpha_deg` (hint: did you mean `V_m_s`?)"
    );
}

const OURS: [&str; 7] = ["V_m_s", "alpha_deg", "Fz_N", "Mx_Nm", "tip_z_m", "t_s", "delta_NAME_deg"];

/// What is said of a column of this name where only [`OURS`] may stand.
fn hint(header: &str) -> String {
    let table = Table::parse("t.csv", &format!("{header}\n")).expect("a header");
    let error = table.allow_only(|name| OURS.contains(&name), &OURS.join(", ")).expect_err(header);
    assert!(error.message.starts_with(&format!("unknown column `{header}`; expected V_m_s, ")), "{error}");
    error.help.expect("a hint")
}

#[test]
fn spellings_of_a_column_lead_to_it() {
    for (header, name) in [
        ("V [m/s]", "V_m_s"),
        ("v_M_S", "V_m_s"),
        ("Vms", "V_m_s"),
        ("alpha (°)", "alpha_deg"),
        ("Alpha deg", "alpha_deg"),
        ("Mx [N m]", "Mx_Nm"),
        ("MX (Nm)", "Mx_Nm"),
        ("tip z / m", "tip_z_m"),
        ("t(s)", "t_s"),
        ("alhpa_deg", "alpha_deg"),
    ] {
        assert_eq!(hint(header), format!("did you mean `{name}`?"), "{header}");
    }
}

#[test]
fn another_unit_is_no_spelling() {
    for (header, name) in [
        ("V [km/h]", "V_m_s"),
        ("alpha_rad", "alpha_deg"),
        ("tip z (mm)", "tip_z_m"),
        ("t_ms", "t_s"),
        ("Mx_N", "Mx_Nm"),
    ] {
        let hint = hint(header);
        assert!(hint.starts_with(&format!("did you mean `{name}`?")) && hint.contains("convert"), "{hint}");
    }
    assert_eq!(hint("temperature"), "take the column out, or give it the name of what it holds");
}

#[test]
fn tables_of_the_wrong_shape_are_refused() {
    let error = |text: &str| message(&Table::parse("t.csv", text).expect_err("must be refused"));
    assert_eq!(
        error("# only this\n"),
        "t.csv: the table is empty (hint: the first line must name the columns)"
    );
    assert_eq!(
        error("a,b\n1\n"),
        "t.csv:2: this row has 1 cells, the header has 2 (hint: empty cells still need their commas)"
    );
    assert_eq!(error("a,b,a\n"), "t.csv:1:5: the column `a` occurs twice (hint: take one of them out)");
    assert!(error("a,,b\n").starts_with("t.csv:1:3: this column has no name"));
    assert!(error("a,b\n1,5,2,5\n").contains("decimal commas need semicolons or tabs"));
    assert_eq!(
        error("a,b\n1,\"2\n"),
        "t.csv:2:3: a quoted cell does not end on its line (hint: add the closing \")"
    );
}

#[test]
fn semicolons_and_tabs_part_cells_and_then_commas_are_decimal() {
    for text in [
        "\u{feff}V_m_s;alpha_deg;block\r\n# ;\r\n18,5;-1;a,b\r\n20;2e-1;\r\n",
        "sep=;\r\nV_m_s;alpha_deg;block\r\n\r\n18,5;-1;\"a,b\"\r\n20;0,2;\r\n",
        "V_m_s\talpha_deg\tblock\n\n18,5\t-1\ta,b\n20\t0,2\t\n",
    ] {
        let table = Table::parse("t.csv", text).expect("a good table");
        assert_eq!(table.numbers("V_m_s"), Ok(vec![18.5, 20.0]), "{text}");
        assert_eq!(table.numbers("alpha_deg"), Ok(vec![-1.0, 0.2]), "{text}");
        assert_eq!(table.text(0, "block"), Ok("a,b"));
        assert_eq!(table.span(0, "alpha_deg").to_string().rsplit(':').next(), Some("6"), "{text}");
    }
    let points = Table::parse("t.csv", "a;b\n1.5;2.5\n").expect("a good table");
    assert_eq!(points.numbers("b"), Ok(vec![2.5]));
    let mixed = Table::parse("t.csv", "a;b\n1,5;2\n1.234;2\n").expect("a good table");
    assert_eq!(
        message(&mixed.numbers("a").unwrap_err()),
        "t.csv:3:1: `1.234` in column `a` has a point, and line 2 a decimal comma (hint: a file has decimal points or \
         decimal commas, and nothing between thousands)"
    );
    let quoted = Table::parse("t.csv", "a,b\n\"1,234\",2\n").expect("a good table");
    assert!(quoted.number(0, "a").is_err(), "a comma between commas may part thousands");
}

#[test]
fn columns_of_other_names_are_taken_and_named_both_ways() {
    let folder = std::env::temp_dir().join(format!("wingroot-columns-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let path = folder.join("t.csv");
    std::fs::write(&path, "speed [m/s],alpha_deg\n1,2\nx,3\n").expect("a temporary file");
    let theirs = |name: &str| std::iter::once(("V_m_s".to_owned(), name.to_owned())).collect();
    let table = Table::read_named(&path, &theirs("speed [m/s]")).expect("a good table");
    assert_eq!(table.number(0, "V_m_s"), Ok(1.0));
    let said = message(&table.numbers("V_m_s").unwrap_err());
    assert!(said.contains("t.csv:3:1: `x` in column `V_m_s` (here `speed [m/s]`)"), "{said}");
    let table = Table::read_named(&path, &theirs("speed")).expect("a table");
    let said = message(&table.require(&["V_m_s"]).unwrap_err());
    assert!(said.contains("the column `V_m_s` (here `speed`) is missing"), "{said}");
    std::fs::remove_dir_all(&folder).expect("the temporary folder");
}

#[test]
fn only_near_names_are_suggested() {
    use nastran::suggest::{distance, nearest};
    assert_eq!((distance("kitten", "sitting"), distance("", "abc"), distance("Wing", "wing")), (3, 3, 0));
    assert_eq!(nearest("chrod", ["span", "chord"]), Some("chord"));
    assert_eq!(nearest("mass", ["span", "chord"]), None);
}
