//! A campaign's folder: `campaign.ron`, `static.csv`, a table a record, and `maneuvers` with what was flown.

use super::design::RHO_KG_M3;
use super::{Measured, Planned, Record, StaticPoint};
use std::fmt::Write as _;
use std::io;
use std::path::Path;

/// Files by name, relative to the folder.
#[derive(Debug, Clone, PartialEq)]
pub struct Files(pub Vec<(String, String)>);

impl Files {
    /// The files of a campaign.
    pub fn of(measured: &Measured, planned: &[Planned], controls: &[String]) -> Self {
        let mut files = vec![
            ("campaign.ron".to_owned(), entry(&measured.records)),
            ("static.csv".to_owned(), statics(&measured.statics)),
        ];
        files.extend(measured.records.iter().map(|record| (record.file.clone(), table(record, controls))));
        let maneuver = |run: &Planned| (format!("maneuvers/{}.ron", run.name), run.maneuver.text());
        files.extend(planned.iter().map(maneuver));
        Self(files)
    }

    /// The files of the campaign without any effect, which has static points alone.
    pub fn of_reference(measured: &Measured) -> Self {
        Self(vec![
            ("campaign.ron".to_owned(), entry(&[])),
            ("static.csv".to_owned(), statics(&measured.reference)),
        ])
    }

    /// Writes all into a folder.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(&self, folder: &Path) -> io::Result<()> {
        for (name, text) in &self.0 {
            let path = folder.join(name);
            if let Some(above) = path.parent() {
                std::fs::create_dir_all(above)?;
            }
            std::fs::write(path, text)?;
        }
        Ok(())
    }
}

fn entry(records: &[Record]) -> String {
    let mut text = format!(
        "Campaign(\n    name: \"a wing in the tunnel of another program\",\n    rho_kg_m3: {RHO_KG_M3:?},\n    noise: None,\n    static_cases: \"static.csv\",\n    runs: [\n"
    );
    for record in records {
        let usage = if record.train { "Train" } else { "Holdout" };
        let _ = write!(
            text,
            "        (file: {:?}, use: {usage}, block: \"block_{}\", start_s: {:?}",
            record.file,
            record.block + 1,
            record.start_s
        );
        if let Some(of) = &record.repeat_of {
            let _ = write!(text, ", repeat_of: {of:?}");
        }
        text.push_str(if record.v_m_s == 0.0 { ", wind_off: true),\n" } else { "),\n" });
    }
    text.push_str("    ],\n)\n");
    text
}

fn statics(points: &[StaticPoint]) -> String {
    let mut text = String::from("V_m_s,alpha_deg,Fz_N,Mx_Nm,My_Nm,block,tip_z_m\n");
    for point in points {
        let [fz, mx, my] = point.loads;
        let (v, alpha, tip) = (point.v_m_s, point.alpha_deg, point.tip_z_m);
        let _ =
            writeln!(text, "{v:.2},{alpha:.3},{fz:.4},{mx:.4},{my:.4},block_{},{tip:.5}", point.block + 1);
    }
    text
}

fn table(record: &Record, controls: &[String]) -> String {
    let mut text = String::from("t_s,V_m_s,alpha_deg,Fz_N,Mx_Nm,My_Nm,tip_z_m");
    if let Some((control, _)) = &record.command {
        let _ = write!(text, ",delta_{}_deg", controls[*control]);
    }
    text.push('\n');
    for i in 0..record.alpha_deg.len() {
        let [fz, mx, my] = [0, 1, 2].map(|channel| record.loads[channel][i]);
        let (t_s, v, alpha) = (i as f64 / record.rate_hz, record.v_m_s, record.alpha_deg[i]);
        let tip = record.tip_z_m[i];
        let _ = write!(text, "{t_s:.4},{v:.2},{alpha:.4},{fz:.4},{mx:.4},{my:.4},{tip:.5}");
        if let Some((_, command)) = &record.command {
            let _ = write!(text, ",{:.4}", command[i]);
        }
        text.push('\n');
    }
    text
}
