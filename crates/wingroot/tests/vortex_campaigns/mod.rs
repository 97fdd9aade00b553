//! Campaigns of the vortex lattice, searched.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use coupling::ElasticWing;
use discover::analysis::{Prepared, Rigs};
use discover::finding::Finding;
use discover::null_distribution::NullDistribution;
use discover::result::DiscoverResult;
use discover::rules::Rules;
use hidden::plan::Hidden;
use hidden::{Bench, CasePlan, Class, Fineness, Mix, TrueServos, cases};
use wingroot::blind::read;

fn wing_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron")
}

fn bench() -> &'static Bench {
    static BENCH: OnceLock<Bench> = OnceLock::new();
    BENCH.get_or_init(|| {
        let bench = Bench::new(&wing_file(), Fineness::TEST).expect("the shipped wing");
        bench.with_vortices(&wing_file()).expect("the shipped wing")
    })
}

/// Gaps of training and held-out runs of such campaigns where nothing is missing.
pub(crate) const FLOORS: [f64; 2] = [2.2, 2.4];

/// Searches a campaign of a wing with these servos, and with what else is hidden. Thresholds are as if null campaigns had found
/// nothing, where model form accounts for what it does in the blind benchmark; where nothing is missing, campaigns of the vortex
/// lattice have a misfit of about one and gaps of [`FLOORS`].
pub(crate) fn searched(
    name: &str,
    servos: TrueServos,
    effects: Vec<Hidden>,
) -> (DiscoverResult, Vec<String>) {
    let plan = cases(43, 1, &Mix::only(Class::Null)).remove(0);
    let plan = CasePlan { servos, effects, ..plan };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("vortices_{name}"));
    bench().case(&plan).files.write(&folder).expect("a generated case");
    let (file, elastic) = ElasticWing::read(&wing_file()).expect("the shipped wing");
    let rigs = Rigs::new(&file, &elastic, None, Rules::default()).expect("the shipped wing");
    let prepared: Prepared = read(&rigs, &folder, false, None).expect("a generated case").prepared;
    let library = maneuver::effects::library(&["any".to_owned()]);
    let bare = NullDistribution::bare(&library, 85.0);
    let nulls = NullDistribution { misfit: 1.0, misfit_limit: 1.4, floor: FLOORS, ..bare };
    let finding = Finding::search(&prepared, &nulls, plan.seed);
    let result = finding.result(&discover::finding::Sources::default(), false, 0.0);
    let mut trace = finding.report.outcome.trace.clone();
    let first = finding.report.outcome.first_ranking.iter().take(8);
    trace.extend(
        first.map(|one| format!("{} {:.0} {:?}", one.label(), one.evidence, one.refit.active.values)),
    );
    (result, trace)
}
