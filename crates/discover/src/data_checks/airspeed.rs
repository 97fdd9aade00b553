//! Runs whose airspeed is not what their label says: all loads, at rest and in motion, as at another dynamic pressure.

use super::defect::{Defect, DefectKind};
use super::record::Record;
use crate::rules::AirspeedRules;
use crate::statistics::{mean, median};
use coupling::Load;

/// See the module.
pub(super) fn wrong(rules: &AirspeedRules, records: &[Record]) -> Vec<Defect> {
    records
        .iter()
        .filter(|record| !record.steady)
        .filter_map(|record| wrong_in(rules, records, record))
        .collect()
}

/// Mean load over that of the simulation.
fn mean_ratio(rules: &AirspeedRules, record: &Record, c: Load) -> Option<f64> {
    let pair = record.channels[c].as_ref()?;
    let simulated = mean(&pair.simulated);
    (simulated.abs() > rules.visible_mean * record.sigma[c]).then(|| mean(&pair.measured) / simulated)
}

fn wrong_in(rules: &AirspeedRules, records: &[Record], record: &Record) -> Option<Defect> {
    if record.v_m_s == 0.0 {
        return blown(rules, records, record);
    }
    let like = |other: &&Record| {
        other.name != record.name && other.v_m_s > 0.0 && record.maneuver.same_kind(&other.maneuver)
    };
    let labelled: Vec<&Record> =
        records.iter().filter(like).filter(|other| other.v_m_s == record.v_m_s).collect();
    let (peers, least) = if labelled.len() >= rules.peers {
        (labelled, rules.least_ratio)
    } else {
        (records.iter().filter(like).collect(), rules.least_ratio_of_all)
    };
    if peers.len() < rules.peers {
        return None;
    }
    let ratios: Vec<f64> = Load::ALL
        .into_iter()
        .filter_map(|c| {
            let usual = median(peers.iter().filter_map(|peer| mean_ratio(rules, peer, c)).collect())?;
            Some(mean_ratio(rules, record, c)? / usual)
        })
        .collect();
    if ratios.len() < 2 || ratios.iter().any(|ratio| *ratio <= 0.0) {
        return None;
    }
    let change = mean(&ratios.iter().map(|ratio| ratio.ln()).collect::<Vec<f64>>());
    let alike = ratios.iter().all(|ratio| (ratio.ln() - change).abs() < rules.alike);
    let exponent = exponent(rules, records, record);
    let v_m_s = record.v_m_s * (change / exponent).exp();
    let far = change.abs() > least.ln() && (v_m_s / record.v_m_s - 1.0).abs() > rules.least_airspeed;
    (alike && far && moves_too(records, record, change)).then(|| Defect {
        kind: DefectKind::WrongAirspeed,
        run: Some(record.name.clone()),
        channel: None,
        sentence: format!(
            "the airspeed of {} is labelled {} m/s, but all its loads are as at {v_m_s:.1} m/s",
            record.name, record.v_m_s
        ),
    })
}

/// Power of the airspeed with which the simulated mean loads grow: less than two where zero lift moves with it.
fn exponent(rules: &AirspeedRules, records: &[Record], record: &Record) -> f64 {
    let near = |other: &&Record| {
        !other.steady
            && other.v_m_s > 0.0
            && (other.alpha_rad - record.alpha_rad).abs() < rules.near_angle_rad
    };
    let mut slopes = Vec::new();
    for c in Load::ALL {
        let points: Vec<(f64, f64)> = records
            .iter()
            .filter(near)
            .filter_map(|other| {
                let load = mean(&other.channels[c].as_ref()?.simulated).abs();
                (load > rules.visible_mean * other.sigma[c]).then(|| (other.v_m_s.ln(), load.ln()))
            })
            .collect();
        let [x, y] = [0, 1].map(|k| mean(&points.iter().map(|p| [p.0, p.1][k]).collect::<Vec<f64>>()));
        let spread: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
        if spread > 1e-3 {
            slopes.push(points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread);
        }
    }
    median(slopes).unwrap_or(2.0).clamp(0.5, 3.0)
}

/// Whether the motion's loads changed in the same sense as the means: at least by a third of it.
fn moves_too(records: &[Record], record: &Record, change: f64) -> bool {
    let gain = |r: &Record, c: Load| r.about_mean(c)?.gain(r.sigma[c]).filter(|gain| *gain > 0.0);
    let changes: Vec<f64> = Load::ALL
        .into_iter()
        .filter_map(|c| {
            let own = gain(record, c)?;
            let peers = records
                .iter()
                .filter(|r| r.name != record.name && r.v_m_s > 0.0 && r.maneuver == record.maneuver);
            Some((own / median(peers.filter_map(|r| gain(r, c)).collect())?).ln())
        })
        .collect();
    median(changes).is_none_or(|moved| moved / change > 1.0 / 3.0)
}

/// A run without wind that carries a mean load like those with wind.
fn blown(rules: &AirspeedRules, records: &[Record], record: &Record) -> Option<Defect> {
    let shares: Vec<f64> = Load::ALL
        .into_iter()
        .filter_map(|c| {
            let with = records.iter().filter(|other| !other.steady && other.v_m_s > 0.0);
            let loads = with.filter_map(|other| Some(mean(&other.channels[c].as_ref()?.measured).abs()));
            let pair = record.channels[c].as_ref()?;
            let own = (mean(&pair.measured) - mean(&pair.simulated)).abs();
            Some(own / median(loads.collect())?.max(rules.visible_mean * record.sigma[c]))
        })
        .collect();
    (shares.len() > 1 && shares.iter().all(|share| *share > rules.blown)).then(|| Defect {
        kind: DefectKind::WrongAirspeed,
        run: Some(record.name.clone()),
        channel: None,
        sentence: format!("{} is labelled wind-off, but carries mean loads as with wind", record.name),
    })
}
