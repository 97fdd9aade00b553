//! A campaign folder of a case, in memory: the records of all runs, static points, and the reference campaign without
//! effects that a calibration may use.

use crate::at_speed::AtSpeed;
use crate::decimate::decimated;
use crate::design::{
    CYCLE_S, HELD_OUT_AIRSPEEDS_M_S, Planned, RHO_KG_M3, SAMPLE_RATE_HZ, STATIC_AIRSPEEDS_M_S,
    STATIC_ANGLES_DEG, TILT_DEG,
};
use crate::noise;
use crate::random::{Random, Stream};
use crate::simulate::{Commands, TrueWing};
use std::fmt::Write as _;
use std::io;
use std::path::Path;

/// Blocks, in each of which every run is flown once and every static point measured once.
pub(crate) const BLOCKS: usize = 2;

/// One record of a run as it is written; angles in degrees.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// File name.
    pub file: String,
    /// Block, from 0.
    pub block: usize,
    /// Clock time of its beginning, s.
    pub start_s: f64,
    /// Airspeed as written, m/s.
    pub v_m_s: f64,
    /// Whether it may be learnt from.
    pub train: bool,
    /// File of which it is a repetition.
    pub repeat_of: Option<String>,
    /// Measured angle of attack, degrees.
    pub alpha_deg: Vec<f64>,
    /// Fz, Mx, My.
    pub loads: [Vec<f64>; 3],
    /// Height of the tip, m.
    pub tip_z_m: Vec<f64>,
    /// The control that moves, and its command, degrees.
    pub command: Option<(usize, Vec<f64>)>,
}

/// One static point as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticPoint {
    /// Airspeed, m/s; zero is a weight tare.
    pub v_m_s: f64,
    /// Angle of attack, degrees.
    pub alpha_deg: f64,
    /// Fz, Mx, My.
    pub loads: [f64; 3],
    /// Height of the tip, m.
    pub tip_z_m: f64,
    /// Block, from 0.
    pub block: usize,
}

/// Records and static points of a campaign, before they are texts.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Records, in the order of the design.
    pub records: Vec<Record>,
    /// Static points of the case.
    pub statics: Vec<StaticPoint>,
    /// Static points of the same wing without any effect.
    pub reference: Vec<StaticPoint>,
}

/// The files of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct CampaignFiles {
    /// The campaign: `campaign.ron`, `static.csv` and the runs.
    pub measured: Vec<(String, String)>,
    /// The reference campaign: `campaign.ron` and `static.csv`, measured without the effect.
    pub reference: Vec<(String, String)>,
}

impl CampaignFiles {
    /// Writes the campaign to `folder/measured` and the reference to `folder/reference`.
    ///
    /// # Errors
    /// If a folder or file cannot be written.
    pub fn write(&self, folder: &Path) -> io::Result<()> {
        for (name, files) in [("measured", &self.measured), ("reference", &self.reference)] {
            let folder = folder.join(name);
            std::fs::create_dir_all(&folder)?;
            for (file, text) in files {
                std::fs::write(folder.join(file), text)?;
            }
        }
        Ok(())
    }
}

/// Offsets of the blocks.
fn block_offsets(seed: u64) -> [[f64; 3]; BLOCKS] {
    let mut random = Random::new(seed, Stream::Offsets);
    std::array::from_fn(|_| noise::channels(&mut random, noise::BLOCK))
}

/// Clock time of every record, s, by block and run: in every block another random order.
fn start_times(seed: u64, runs: usize) -> Vec<Vec<f64>> {
    let mut random = Random::new(seed, Stream::Order);
    let of_block = |block: usize| {
        let mut times = vec![0.0; runs];
        for (place, run) in random.order(runs).into_iter().enumerate() {
            times[run] = CYCLE_S * (block * runs + place) as f64;
        }
        times
    };
    (0..BLOCKS).map(of_block).collect()
}

/// All records of a wing, with noise.
pub(crate) fn records(wing: &TrueWing<'_>, plan: &[Planned], speeds: &[&AtSpeed], seed: u64) -> Vec<Record> {
    let controls = wing.parts.air.controls;
    let offsets = block_offsets(seed);
    let times = start_times(seed, plan.len());
    let mut all = Vec::with_capacity(BLOCKS * plan.len());
    for (run, planned) in plan.iter().enumerate() {
        let Some(at) = speeds.iter().find(|at| at.v_m_s == planned.v_m_s) else { continue };
        let commands = Commands::of(planned, controls);
        let flown = wing.fly(at, &commands);
        for block in 0..BLOCKS {
            let number = (block * plan.len() + run) as u64;
            let here = TrueWing::here(at, &commands, (times[block][run], number));
            let mut measured = flown.clone();
            wing.measure(&here, &mut measured);
            let mut random = Random::new(seed, Stream::Record(number));
            let samples = planned.samples();
            let errors = noise::of_record(&mut random, here.q_pa, samples);
            let own = noise::channels(&mut random, noise::RECORD);
            let loads = std::array::from_fn(|channel| {
                // zeros are taken without wind
                let day = if here.v_m_s > 0.0 { offsets[block][channel] } else { 0.0 };
                let offset = day + own[channel];
                let clean = decimated(&measured.loads[channel]);
                clean.iter().zip(&errors[channel]).map(|(load, error)| load + offset + error).collect()
            });
            let mut noisy = |values: &[f64], sigma: f64| -> Vec<f64> {
                decimated(values).iter().map(|value| value + random.normal(sigma)).collect()
            };
            let mut reading: Vec<f64> = commands.alpha[0].iter().map(|angle| angle.to_degrees()).collect();
            for effect in wing.effects {
                (effect.kind.reading)(&effect.values, &mut reading);
            }
            let degrees =
                |values: &[f64]| values.iter().map(|value| value.to_degrees()).collect::<Vec<f64>>();
            all.push(Record {
                file: file_name(planned, block),
                block,
                start_s: times[block][run],
                v_m_s: planned.v_m_s,
                train: planned.train,
                repeat_of: (block > 0).then(|| file_name(planned, 0)),
                alpha_deg: noisy(&reading, noise::ALPHA_DEG),
                tip_z_m: noisy(&measured.tip_z_m, noise::TIP_M),
                loads,
                command: planned
                    .control()
                    .map(|control| (control, decimated(&degrees(&commands.controls[control])))),
            });
        }
    }
    all
}

fn file_name(planned: &Planned, block: usize) -> String {
    if block == 0 { format!("{}.csv", planned.name) } else { format!("{}_again.csv", planned.name) }
}

/// All static points of a wing, with noise from a stream.
pub(crate) fn static_points(
    wing: &TrueWing<'_>,
    speeds: &[AtSpeed],
    still: &AtSpeed,
    (seed, stream): (u64, Stream),
) -> Vec<StaticPoint> {
    let mut random = Random::new(seed, stream);
    let mut all = Vec::new();
    for (block, day) in block_offsets(seed).into_iter().enumerate() {
        let tares = TILT_DEG.iter().map(|alpha| (still, *alpha));
        let tested = speeds.iter().flat_map(|at| STATIC_ANGLES_DEG.iter().map(move |alpha| (at, *alpha)));
        for (at, alpha_deg) in tares.chain(tested) {
            let commands = Commands::steady(alpha_deg.to_radians(), wing.parts.air.controls);
            let mut flown = wing.fly(at, &commands);
            // zeros are taken at the beginning of a block
            let here = TrueWing::here(at, &commands, (0.0, u64::MAX));
            wing.measure(&here, &mut flown);
            let error = noise::channels(&mut random, noise::STATIC_POINT);
            let offset = if at.v_m_s > 0.0 { day } else { [0.0; 3] };
            let loads = std::array::from_fn(|c| flown.loads[c][0] + offset[c] + error[c]);
            let tip_z_m = flown.tip_z_m[0] + random.normal(noise::TIP_M);
            let mut reading = [alpha_deg];
            wing.effects.iter().for_each(|effect| (effect.kind.reading)(&effect.values, &mut reading));
            all.push(StaticPoint { v_m_s: at.v_m_s, alpha_deg: reading[0], loads, tip_z_m, block });
        }
    }
    all
}

/// Airspeeds that are simulated.
pub(crate) fn airspeeds_m_s() -> [f64; 5] {
    STATIC_AIRSPEEDS_M_S
}

/// The measurements as texts; `noise_known` states the noise, as a campaign without replicates must.
pub(crate) fn texts(measured: &Measured, controls: &[String], noise_known: bool) -> CampaignFiles {
    let mut files = vec![
        ("campaign.ron".to_owned(), entry(&measured.records, noise_known)),
        ("static.csv".to_owned(), static_csv(&measured.statics)),
    ];
    files.extend(measured.records.iter().map(|record| (record.file.clone(), run_csv(record, controls))));
    let reference = vec![
        ("campaign.ron".to_owned(), entry(&[], noise_known)),
        ("static.csv".to_owned(), static_csv(&measured.reference)),
    ];
    CampaignFiles { measured: files, reference }
}

fn entry(records: &[Record], noise_known: bool) -> String {
    let mut text = format!("Campaign(\n    name: \"blind benchmark\",\n    rho_kg_m3: {RHO_KG_M3:?},\n");
    if noise_known {
        let of = |s: [f64; 3]| format!("(fz_N: {:?}, mx_Nm: {:?}, my_Nm: {:?})", s[0], s[1], s[2]);
        let (sample, point) = (of(noise::SAMPLE), of(noise::STATIC_POINT));
        let _ = writeln!(text, "    noise: Some((sample: {sample}, static_point: {point})),");
    } else {
        text.push_str("    noise: None,\n");
    }
    text.push_str("    static_cases: \"static.csv\",\n    runs: [\n");
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

fn static_csv(points: &[StaticPoint]) -> String {
    let mut text = String::from("V_m_s,alpha_deg,Fz_N,Mx_Nm,My_Nm,block,tip_z_m\n");
    for point in points {
        let [fz, mx, my] = point.loads.map(tidy);
        let (v, alpha, tip) = (point.v_m_s, point.alpha_deg, tidy(point.tip_z_m));
        let _ =
            writeln!(text, "{v:.2},{alpha:.3},{fz:.4},{mx:.4},{my:.4},block_{},{tip:.5}", point.block + 1);
    }
    text
}

fn run_csv(record: &Record, controls: &[String]) -> String {
    let mut text = String::from("t_s,V_m_s,alpha_deg,Fz_N,Mx_Nm,My_Nm,tip_z_m");
    if let Some((control, _)) = &record.command {
        let _ = write!(text, ",delta_{}_deg", controls[*control]);
    }
    text.push('\n');
    for i in 0..record.alpha_deg.len() {
        let t_s = i as f64 / SAMPLE_RATE_HZ as f64;
        let [fz, mx, my] = [0, 1, 2].map(|channel| tidy(record.loads[channel][i]));
        let (v, alpha, tip) = (record.v_m_s, record.alpha_deg[i], tidy(record.tip_z_m[i]));
        let _ = write!(text, "{t_s:.4},{v:.2},{alpha:.4},{fz:.4},{mx:.4},{my:.4},{tip:.5}");
        if let Some((_, command)) = &record.command {
            let _ = write!(text, ",{:.4}", tidy(command[i]));
        }
        text.push('\n');
    }
    text
}

/// Numbers that print as "-0.0000" print as "0.0000".
fn tidy(value: f64) -> f64 {
    if value.abs() < 5e-6 { 0.0 } else { value }
}

/// Whether an airspeed is held out (its static rows are in the file all the same).
pub fn is_held_out(v_m_s: f64) -> bool {
    HELD_OUT_AIRSPEEDS_M_S.contains(&v_m_s)
}
