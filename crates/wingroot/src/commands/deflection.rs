//! `deflection`: the deflection correction of paper 1, Eq. 10 from measured doublets, a wing with it, and what it is worth on
//! doublets that were held out.

use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Instant;

use aero::Flow;
use calibrate::Campaign;
use calibrate::campaign::Use;
use coupling::ByLoad;
use coupling::wing_file::DeflectionTable;
use maneuver::deflection_fit::{change_rms, doublet_of, fit_doublet, noise_gap, pooled, tables};
use maneuver::{
    DeflectionAt, DeflectionCorrection, Rig, RigModel, RigSettings, Run, Simulated, simulate_commanded,
};
use nastran::InputError;

use crate::args::{Common, Given};
use crate::commands::deflection_results::{Found, Judged, Measured};
use crate::commands::result_parts::as_json;
use crate::commands::simulate::settings;
use crate::commands::{deflection_figures, deflection_results};
use crate::corrections::{CorrectedWing, as_given, corrected_wing};
use crate::ensemble::write_corrections;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Options of `deflection`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot deflection
  wingroot deflection --campaign my_campaign --wing my_wing.ron --out out/my_deflection
  wingroot simulate --wing out/deflection/wing.ron --corrections out/deflection/corrections.ron

Runs that are doublets of one control surface are fitted if they are marked `use: Train` or not marked at all; those
marked Holdout only judge.
Writes wing.ron (the given wing with the correction), corrections.ron (the given ones, for that wing), deflection.csv,
equivalent.svg, factors.svg and result.json. The factor is linear between measured deflections and airspeeds, kept
below the smallest and above the largest deflection, and refused beyond the measured airspeeds.")]
pub struct DeflectionArgs {
    /// Wing, measurements, corrections.
    #[command(flatten)]
    pub(crate) given: Given,
}

/// Runs the command.
pub(crate) fn run(args: &DeflectionArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let folder = args.given.measured.campaign_path()?;
    let campaign = Campaign::read(&folder)?;
    let corrected = corrected_wing(&args.given)?;
    as_given(&corrected.schedule);
    let settings = settings(&corrected);
    let (doublets, models) = doublets(&campaign, &settings, &corrected)?;
    let sigma = campaign.noise.and_then(|noise| {
        let [fz, mx, my, _] = noise.sample.to_array();
        (fz > 0.0 && mx > 0.0 && my > 0.0).then_some(ByLoad { fz, mx, my })
    });
    let train = doublets.iter().filter(|doublet| doublet.usage == Use::Train);
    let fits = train
        .map(|doublet| {
            let model = &models[doublet.model];
            Ok((doublet, fit_doublet(&doublet.run, model, sigma, &doublet.file)?))
        })
        .collect::<Result<Vec<_>, InputError>>()?;
    let Some((first, _)) = fits.first() else {
        return Err(InputError::in_file(&folder, "no run for training is a doublet of one control surface")
            .with_help("a doublet goes to one height and to its negative; mark such runs `use: Train`")
            .into());
    };
    let noise_gap = noise_gap(first.run.time_step_s, settings.cutoff_hz);
    let factors = pooled(&fits.iter().map(|(_, fit)| fit.clone()).collect::<Vec<_>>());
    let tables = tables(&factors)?;
    let (judged, remarks) = judge(&doublets, &models, &tables, settings.cutoff_hz)?;
    let found = Found { corrected: &corrected, fits, factors, tables, judged, sigma, noise_gap, remarks };
    for remark in &found.remarks {
        show::note(remark);
    }
    let seconds = start.elapsed().as_secs_f64();
    let out = write(&common.out("deflection"), &found, seconds)?;
    show::summary(common, &deflection_results::summary(&found, &out, seconds));
    show::json(common, &as_json(&deflection_results::result(&found, seconds))?)
}

/// The campaign's doublets, and one model for each airspeed among them.
fn doublets(
    campaign: &Campaign,
    settings: &RigSettings,
    corrected: &CorrectedWing,
) -> Result<(Vec<Measured>, Vec<RigModel>), Failure> {
    let mut doublets = Vec::new();
    let mut speeds: Vec<f64> = Vec::new();
    for entry in campaign.runs.iter().filter(|entry| !entry.wind_off) {
        let file = nastran::named_file(&campaign.path, &entry.file)?;
        let run = Run::read_named(&file, &campaign.columns)?;
        if run.loads.is_none() || doublet_of(&run).is_none() {
            continue;
        }
        let known = speeds.iter().position(|speed| (speed - run.v_m_s).abs() < 1e-6 * speed);
        let model = known.unwrap_or(speeds.len());
        if known.is_none() {
            speeds.push(run.v_m_s);
        }
        // What is not marked is used to fit: there is nothing to judge by in a campaign without a split.
        doublets.push(Measured { file, run, usage: entry.usage.unwrap_or(Use::Train), model });
    }
    let rig = Rig::new(&corrected.wing, settings.clone())?;
    let model = |(number, v_m_s): (usize, &f64)| -> Result<RigModel, Failure> {
        let corrections = corrected.schedule.at(*v_m_s).map_err(|refused| {
            let file = doublets.iter().find(|doublet| doublet.model == number).map(|doublet| &doublet.file);
            InputError::in_file(file.unwrap_or(&campaign.path), refused.message)
                .with_help("calibrate at this airspeed, or take the run out of the campaign")
        })?;
        Ok(rig.at(Flow { v_m_s: *v_m_s, rho_kg_m3: campaign.rho_kg_m3 }, &corrections)?)
    };
    let models = speeds.iter().enumerate().map(model).collect::<Result<_, _>>()?;
    Ok((doublets, models))
}

/// Flies the held-out doublets with and without the correction; remarks on those it cannot fly.
fn judge(
    doublets: &[Measured],
    models: &[RigModel],
    tables: &[DeflectionTable],
    cutoff_hz: f64,
) -> Result<(Vec<Judged>, Vec<String>), Failure> {
    let correction = DeflectionCorrection::new(tables.to_vec());
    let (mut judged, mut remarks) = (Vec::new(), Vec::new());
    for doublet in doublets.iter().filter(|doublet| doublet.usage == Use::Holdout) {
        let (run, model) = (&doublet.run, &models[doublet.model]);
        let at = match correction.at(run.v_m_s) {
            Ok(at) => at,
            Err(refused) => {
                remarks.push(format!("{} is not judged: {}", run.name, refused.message));
                continue;
            }
        };
        for (control, commanded) in &run.controls_rad {
            remarks.extend(at.beyond(control, commanded).map(|beyond| format!("{}: {beyond}", run.name)));
        }
        let before = simulate_commanded(run, model, &DeflectionAt::default(), &doublet.file)?;
        let after = simulate_commanded(run, model, &at, &doublet.file)?;
        let change = |simulated: &Simulated| change_rms(run, &simulated.history, cutoff_hz);
        if let (Some(loads), Some(changes)) = (
            before.residual_rms.zip(after.residual_rms).map(<[_; 2]>::from),
            change(&before).zip(change(&after)).map(<[_; 2]>::from),
        ) {
            judged.push(Judged { name: run.name.clone(), samples: run.len(), loads, changes });
        }
    }
    Ok((judged, remarks))
}

fn write(out: &Path, found: &Found<'_>, seconds: f64) -> Result<PathBuf, Failure> {
    let folder = ResultFolder::begin(out)?;
    found.corrected.note_inputs(&folder)?;
    if let Some(runs) = found.fits.first().and_then(|(measured, _)| measured.file.parent()) {
        folder.input("campaign", runs)?;
    }
    let rewritten = found.corrected.file.with_deflection(found.tables.clone())?;
    let name = found.corrected.file.written_name();
    folder.write_text(name, &rewritten.text)?;
    for (name, from) in &rewritten.beside {
        folder.write_text(name, &nastran::read_text(from)?)?;
    }
    // The corrections of the loads are the same; they carry the new file's hash, so that commands take both together.
    let rewritten = coupling::WingFile::read(&folder.path().join(name))?;
    // effects that are the same physics may not stand beside the correction
    maneuver::effects::of_wing(&rewritten, &found.corrected.wing.control_names())?;
    let wing_hash = rewritten.hash;
    let schedule = calibrate::Schedule { wing_hash, ..found.corrected.schedule.clone() };
    let measured: Vec<String> = found.tables.iter().map(|table| table.control.clone()).collect();
    write_corrections(&folder, found.corrected, schedule, &measured)?;
    folder.write_text("deflection.csv", &deflection_results::csv(&found.factors))?;
    for (name, caption, figure) in [
        ("equivalent", "Figure 15 of the paper.", deflection_figures::equivalents(&found.factors)),
        ("factors", "Figure 16 of the paper.", deflection_figures::factors(&found.factors)),
    ] {
        folder.write_figure(name, caption, figure)?;
    }
    folder.write_json("result.json", &as_json(&deflection_results::result(found, seconds))?)?;
    folder.commit()
}
