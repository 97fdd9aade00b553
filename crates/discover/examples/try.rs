//! tmp
use calibrate::*;
use coupling::*;
use discover::analysis::Prepared;
use discover::bank::Thresholds;
use std::path::Path;
use std::time::Instant;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let (file, wing) = ElasticWing::read(Path::new(&args[1])).unwrap();
    let campaign = Campaign::read(Path::new(&args[2])).unwrap();
    let t = Instant::now();
    let calibration = calibrate(
        &wing,
        &Campaign::read(Path::new(args.get(3).unwrap_or(&args[2]))).unwrap(),
        &Settings::of_wing(&file.correction),
    )
    .unwrap();
    let sets = calibration
        .airspeeds
        .iter()
        .map(|a| CorrectionSet::new(a.data.v_m_s, a.corrections.clone()))
        .collect();
    let schedule = Schedule { wing: file.name.clone(), wing_hash: file.hash.clone(), sets };
    println!("calibrated {:?}", t.elapsed());
    let t = Instant::now();
    let prepared = Prepared::new(&file, &wing, &schedule, &campaign, args.get(3).is_none()).unwrap();
    println!("prepared {:?} noise {:?}", t.elapsed(), prepared.noise.offset);
    for (v, n) in prepared.data.airspeeds_m_s.iter().zip(&prepared.noise.run) {
        println!("{v} {n:?}");
    }
    let t = Instant::now();
    let mut limits = Thresholds::default();
    if std::env::var("BANK").is_ok() {
        limits = prepared.thresholds(7);
        println!("bank {:?} {limits:#?}", t.elapsed());
    }
    let t = Instant::now();
    let report = prepared.search(&limits, 1);
    println!("searched {:?} runs {}", t.elapsed(), report.model_runs);
    println!("misfit {:?} unexplained {}", report.outcome.misfit, report.outcome.unexplained);
    for l in &report.outcome.first_level {
        println!("  {l:?}");
    }
    for f in &report.outcome.found {
        println!(
            "FOUND {} {} {:?} sigma {:?} lnB {:.1} conf {:.2} {:?}",
            f.active.effect.spec().name,
            f.active.effect.form(),
            f.active.values,
            f.sigma,
            f.evidence,
            f.confidence,
            f.confused_with
        );
    }
    if let Some(n) = &report.outcome.next_best {
        println!(
            "next {} {} {:?} lnB {:.1}",
            n.name(),
            n.refit.active.effect.form(),
            n.refit.active.values,
            n.evidence
        );
    }
    println!("{:#?}", report.gaps.map(|g| g.map(|g| (g.all, g.by_channel, g.raw_percent))));

    let [train, _] = prepared.problems();
    let show = |r: &[f64]| {
        let w = report.level.shared.weighted(r);
        let mut all: Vec<(f64, usize, usize)> = train
            .segments
            .iter()
            .map(|s| (s.rows.clone().map(|i| r[i] * w[i]).sum::<f64>(), s.rows.len(), s.place))
            .collect();
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (c, n, p) in all.iter().take(14) {
            let name = p
                .checked_sub(prepared.data.statics.len())
                .map_or(format!("static {p}"), |i| prepared.data.runs[i].name.clone());
            println!("   {name} {c:.0} of {n}");
        }
    };
    show(&report.level.residual);
    if let Some(n) = &report.outcome.next_best {
        println!("with next");
        show(&n.refit.residual);
    }

    let [_, holdout] = prepared.problems();
    let models = prepared.simulator.models(&report.level.effects, None);
    let flown = prepared.simulator.fly(&models, &report.level.effects, &holdout.places());
    for (s, f) in holdout.segments.iter().zip(&flown) {
        let name = s
            .place
            .checked_sub(prepared.data.statics.len())
            .map_or(format!("static {}", s.place), |i| prepared.data.runs[i].name.clone());
        let Some(i) = s.place.checked_sub(prepared.data.statics.len()) else { continue };
        let m = &prepared.data.runs[i].measured;
        let g: Vec<(f64, f64)> = (0..3)
            .map(|c| {
                let d: Vec<f64> = m[c].iter().zip(&f.loads[c]).map(|(a, b)| a - b).collect();
                let mean = d.iter().sum::<f64>() / d.len() as f64;
                let sd = (d.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / d.len() as f64).sqrt();
                (mean, sd)
            })
            .collect();
        println!(
            "   {name} mean {:.2?} sd {:.2?}",
            g.iter().map(|x| x.0).collect::<Vec<_>>(),
            g.iter().map(|x| x.1).collect::<Vec<_>>()
        );
    }
}
