//! Options of `flutter`.

use std::path::PathBuf;

use clap::Args;

/// Options of `flutter`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask flutter
  cargo xtask flutter --wing my_wing/wing.ron --campaign my_wing/campaign --to 60")]
pub struct FlutterArgs {
    /// The wing [default: data/tuflex/wing.ron]
    #[arg(long, value_name = "FILE")]
    pub wing: Option<PathBuf>,
    /// Corrections from `calibrate` [default: out/calibrate's if of the same wing, else calibrated first]
    #[arg(long, value_name = "FILE")]
    pub corrections: Option<PathBuf>,
    /// The folder of measurements, for its air density [default: data/tuflex/measured]
    #[arg(long, value_name = "DIR")]
    pub campaign: Option<PathBuf>,
    /// Highest airspeed looked at, m/s [default: 100, up to which air is nearly incompressible]
    #[arg(long, value_name = "V", value_parser = airspeed)]
    pub to: Option<f64>,
}

fn airspeed(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(v_m_s) if v_m_s > 0.0 && v_m_s <= 300.0 => Ok(v_m_s),
        _ => Err("expected an airspeed above 0 and up to 300 m/s".into()),
    }
}
