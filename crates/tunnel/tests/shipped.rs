//! The shipped campaigns are what the shipped tunnel files give, and they say what they are.

use nastran::Table;
use std::path::{Path, PathBuf};
use tunnel::{Truth, TunnelFile, campaign};

const CAMPAIGNS: [(&str, &str); 2] = [("tunnel.ron", "measured"), ("tunnel_curved.ron", "measured_curved")];
/// The example of `wingroot new`.
const EXAMPLE: (&str, &str) = ("../own_wing/made_with/tunnel.ron", "../own_wing/campaign");

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

#[test]
fn the_shipped_campaigns_say_that_they_are_no_measurements() {
    for (file, folder) in CAMPAIGNS {
        let readme = nastran::read_text(&data(folder).join("README.md")).unwrap();
        assert!(readme.contains("THESE ARE NOT MEASUREMENTS"), "{folder}");
        assert!(readme.contains(&format!("--runs data/tuflex/{file}")), "{folder}");
    }
}

#[test]
fn the_shipped_static_cases_are_reproduced_to_their_last_digit() {
    for (name, folder) in CAMPAIGNS.into_iter().chain([EXAMPLE]) {
        let file = TunnelFile::read(&data(name)).unwrap();
        let file = TunnelFile { runs: Vec::new(), ..file };
        let made = campaign(&file, &Truth::build(&file).unwrap(), file.seed).unwrap();
        let text = &made.files.iter().find(|(name, _)| name == "static.csv").unwrap().1;
        let made = Table::parse("made", text).unwrap();
        let shipped = Table::read(&data(folder).join("static.csv")).unwrap();
        assert_eq!(made.len(), shipped.len());
        for column in ["V_m_s", "alpha_deg", "Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"] {
            for row in 0..made.len() {
                let (a, b) = (made.number(row, column).unwrap(), shipped.number(row, column).unwrap());
                // The mathematics library of another platform may turn a rounding by one unit.
                assert!((a - b).abs() < 1.01e-4, "{folder} row {row} {column}: {a} {b}");
            }
        }
    }
}
