//! Tables as people have them give the results of the shipped ones, to the last bit.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A copy of the example of `new`, removed at the end.
struct Copy(PathBuf);

impl Copy {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-tables-{name}-{}", std::process::id()));
        let copy = Self(folder);
        let parent = copy.0.parent().expect("a temporary folder");
        copy.run(parent, &["new", &copy.0.display().to_string()]);
        copy
    }

    fn run(&self, from: &Path, arguments: &[&str]) {
        let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
            .args(arguments)
            .arg("--quiet")
            .current_dir(from)
            .output()
            .expect("it starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {said}", self.0.display());
    }

    /// Rewrites the static cases and the runs.
    fn rewrite(&self, how: impl Fn(&str) -> Vec<u8>) {
        for name in ["static", "pitch_1hz_20"] {
            let path = self.0.join(format!("campaign/{name}.csv"));
            let text = std::fs::read_to_string(&path).expect("a shipped file");
            std::fs::write(path, how(&text)).expect("a temporary file");
        }
    }

    /// Corrections, and a run simulated with them.
    fn results(&self) -> [String; 2] {
        self.run(&self.0, &["calibrate"]);
        self.run(&self.0, &["simulate", "--run", "campaign/pitch_1hz_20.csv"]);
        ["calibrate/corrections.ron", "simulate/pitch_1hz_20.csv"]
            .map(|name| std::fs::read_to_string(self.0.join("out").join(name)).expect("a result"))
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn spreadsheets_and_other_names_change_nothing() {
    let shipped = Copy::new("shipped").results();

    let sheet = Copy::new("sheet");
    sheet.rewrite(|text| {
        let text = text.replace(',', ";").replace('.', ",").replace('\n', "\r\n");
        std::iter::once(0xFEFF).chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect()
    });
    assert_eq!(sheet.results(), shipped, "semicolons, decimal commas, CRLF, UTF-16");

    let named = Copy::new("named");
    named.rewrite(|text| {
        let text = text.replacen("V_m_s", "speed [m/s]", 1).replacen("alpha_deg", "\"AoA, °\"", 1);
        format!("\u{feff}{}", text.replacen("t_s", "time", 1)).into_bytes()
    });
    let path = named.0.join("campaign/campaign.ron");
    let text = std::fs::read_to_string(&path).expect("a shipped file");
    let columns = "columns: {\"V_m_s\": \"speed [m/s]\", \"alpha_deg\": \"AoA, °\", \"t_s\": \"time\"},";
    let text = text.replacen("    runs: [\n", &format!("    {columns}\n    runs: [\n"), 1);
    std::fs::write(path, text).expect("a temporary file");
    assert_eq!(named.results(), shipped, "other names");
}
