//! What every effect of the library keeps, whichever it is: without size it changes no bit; a planted size is found again by
//! least squares; it is not found where it is not; it reads back from a wing's file; and what becomes of it in flight is said.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::copy::{Copy, data};
use crate::common::flown::{Recording, plausible, points, rom, run, with};
use crate::common::wing_with;
use aero::Corrections;
use coupling::WingFile;
use coupling::wing_file::{DeflectionRow, DeflectionTable, OutsideAirspeeds};
use maneuver::effects::{Active, Effect, Flight, acting_deflection, carry, library, of_wing};
use std::path::Path;
use std::sync::Arc;

fn named(effect: &Arc<dyn Effect>) -> String {
    format!("{} {}", effect.spec().name, effect.form())
}

#[test]
fn an_effect_without_size_changes_no_bit_and_one_of_plausible_size_shows() {
    let rom = rom(34.0);
    let controls = rom.controls.len();
    let stimuli = [run(controls), points(controls)];
    let clean = stimuli.each_ref().map(|stimulus| with(&rom, &[], stimulus));
    for effect in library(&rom.controls) {
        let name = named(&effect);
        let none = Active::new(effect.clone(), &vec![0.0; effect.parameters().len()]);
        let zero = stimuli.each_ref().map(|stimulus| with(&rom, std::slice::from_ref(&none), stimulus));
        assert!(zero == clean, "{name} without size changes the loads");
        let sized = plausible(&effect, 1.0);
        let sized = stimuli.each_ref().map(|stimulus| with(&rom, std::slice::from_ref(&sized), stimulus));
        let change = sized.iter().zip(&clean).flat_map(|(a, b)| {
            let pairs = a.loads.iter().flatten().zip(b.loads.iter().flatten());
            pairs.map(|(x, y)| (x - y).abs()).collect::<Vec<f64>>()
        });
        let largest = change.fold(0.0, f64::max);
        assert!(largest.is_finite() && largest > 0.01, "{name} of plausible size: {largest} N or N m");
    }
}

/// The planted size is the effect's own start with a tenth off, or the plausible one. Fits begin with the start, or with half and
/// with one and a half of the plausible size, and the better one counts: what acts beyond a threshold only (a rate limit, a
/// filter near half the sampling rate) has no slope below it.
#[test]
fn a_planted_size_is_found_again_from_the_effect_s_own_start() {
    let recording = Recording::new();
    for effect in library(recording.controls()) {
        let (truth, starts) = match effect.starts().first() {
            Some(start) => {
                let less: Vec<f64> = start.iter().map(|value| 0.9 * value).collect();
                (Active::new(effect.clone(), &less), vec![start.clone()])
            }
            None => {
                (plausible(&effect, 1.0), [0.5, 1.5].map(|share| plausible(&effect, share).values).to_vec())
            }
        };
        let measured = recording.flown(std::slice::from_ref(&truth));
        let left = |found: &Active| -> f64 {
            let flown = recording.flown(std::slice::from_ref(found));
            measured.iter().zip(flown).map(|(a, b)| (a - b).powi(2)).sum()
        };
        let fits = starts.iter().map(|start| recording.fit(&effect, &measured, start));
        let found = fits.min_by(|a, b| left(a).total_cmp(&left(b))).unwrap();
        for ((found, truth), p) in found.values.iter().zip(&truth.values).zip(&effect.parameters()) {
            let off = (found - truth).abs() / p.plausible;
            assert!(off < 0.02, "{}: {} {found}, planted {truth}", named(&effect), p.name);
        }
    }
}

/// Noise alone: a fit of k parameters to it gains a chi square of k degrees of freedom, of which more than five standard
/// deviations above the mean is no chance; and the size of an effect of one parameter stays within what was plausible before.
#[test]
fn an_effect_is_not_found_where_it_is_not() {
    let recording = Recording::new();
    let clean = recording.flown(&[]);
    let noisy = recording.with_noise(&clean);
    let square = |loads: &[f64]| noisy.iter().zip(loads).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    for effect in library(recording.controls()) {
        let start = effect.starts().first().cloned().unwrap_or_else(|| plausible(&effect, 0.5).values);
        let found = recording.fit(&effect, &noisy, &start);
        let gain =
            recording.in_noise(square(&clean) - square(&recording.flown(std::slice::from_ref(&found))));
        let k = start.len() as f64;
        let name = named(&effect);
        assert!(gain < k + 5.0 * (2.0 * k).sqrt(), "{name}: chi square falls by {gain:.1} on noise alone");
        // beside a size of nearly zero the shape (how a limit follows the airspeed) is anything
        if effect.starts().is_empty() && start.len() == 1 {
            for (value, p) in found.values.iter().zip(&effect.parameters()) {
                assert!(value.abs() < p.plausible, "{name}: {} {value} on noise alone", p.name);
            }
        }
    }
}

#[test]
fn an_effect_reads_back_from_a_wing_s_file_bit_for_bit() {
    let file = WingFile::read(&data("wing_beam.ron")).unwrap();
    let (_, wing) = wing_with(|_| ());
    let controls = wing.control_names();
    for (i, effect) in library(&controls).iter().enumerate() {
        // a third: no number of few digits
        let active = plausible(effect, 1.0 / 3.0);
        let text = file.with_effects(vec![active.to_wing()]).unwrap().text;
        let read = Copy::new(&format!("contract{i}"), &text).read().unwrap();
        let back = of_wing(&read, &controls).unwrap();
        assert_eq!(back.len(), 1);
        assert_eq!(named(&back[0].effect), named(effect));
        let bits = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<u64>>();
        assert_eq!(bits(&back[0].values), bits(&active.values), "{}", named(effect));
    }
}

#[test]
fn an_effect_that_is_the_deflection_correction_s_physics_is_refused_beside_it_and_others_are_not() {
    let (mut file, wing) = wing_with(|_| ());
    let controls = wing.control_names();
    let (commanded_deg, factor) = (vec![10.0], Some(vec![0.9]));
    let row = DeflectionRow { v_m_s: 30.0, commanded_deg, equivalent_deg: None, factor };
    let outside = OutsideAirspeeds::Nearest;
    file.deflection =
        vec![DeflectionTable { control: controls[0].clone(), odd: true, outside, rows: vec![row] }];
    let mut excluded = 0;
    for effect in library(&controls) {
        file.effects = vec![plausible(&effect, 0.5).to_wing()];
        let refused = of_wing(&file, &controls).err().map(|error| error.message);
        let excludes = effect.excludes_deflection_correction();
        excluded += usize::from(excludes);
        assert_eq!(refused.is_some(), excludes, "{}: {refused:?}", named(&effect));
        assert!(refused.is_none_or(|message| message.contains("deflection correction")));
    }
    assert!(excluded > 0);
}

#[test]
fn what_becomes_of_an_effect_in_flight_is_what_it_does() {
    let (_, wing) = wing_with(|_| ());
    let (controls, v_m_s) = (wing.control_names(), 25.0);
    for effect in library(&controls) {
        let (name, travels, flight) = (named(&effect), effect.spec().side.travels(), effect.flight());
        let active = [plausible(&effect, 1.0)];
        let neutral = Corrections::neutral(wing.correctable.len());
        let mut corrections = neutral.clone();
        let told = carry(&active, &wing, v_m_s, &mut corrections);
        let delta = acting_deflection(&active, &controls, &controls[0], v_m_s, 0.3);
        let (air, surface) = (corrections != neutral, delta.to_bits() != 0.3_f64.to_bits());
        // acts through corrections, through deflections; is told as carried, tunnel, left
        let acts = (air, surface);
        let told = (told.carried.len(), told.tunnel.len(), told.left.len());
        let expected = match flight {
            _ if !travels => ((false, false), (0, 1, 0)),
            Flight::Corrections => ((true, false), (1, 0, 0)),
            Flight::Deflection => ((false, true), (1, 0, 0)),
            Flight::Left => ((false, false), (0, 0, 1)),
        };
        assert_eq!((acts, told), expected, "{name}: {flight:?}, travels: {travels}");
        let none = [Active::new(effect.clone(), &vec![0.0; active[0].values.len()])];
        let mut corrections = neutral.clone();
        let _ = carry(&none, &wing, v_m_s, &mut corrections);
        assert!(corrections == neutral, "{name} without size changes a flying wing's air");
    }
}

#[test]
fn an_effect_is_one_file_and_one_line_of_the_list() {
    let effects = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/effects");
    let list = std::fs::read_to_string(effects.join("library.rs")).unwrap();
    let files: Vec<(String, String)> = std::fs::read_dir(effects.join("library"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).unwrap()))
        .collect();
    let mut names: Vec<&str> = library(&["one".to_owned()]).iter().map(|e| e.spec().name).collect();
    names.dedup();
    assert_eq!(names.len(), files.len(), "files that no effect of the list comes from");
    for name in &names {
        let lines = list.lines().filter(|line| line.trim() == format!("{name},")).count();
        assert_eq!(lines, 1, "{name} stands {lines} times in the list");
        let declared = format!("name: \"{name}\"");
        let own: Vec<&str> = files
            .iter()
            .filter(|(_, text)| text.contains(&declared))
            .map(|(path, _)| path.as_str())
            .collect();
        assert!(own.len() == 1 && own[0].ends_with(&format!("/{name}.rs")), "{name}: {own:?}");
    }
}
