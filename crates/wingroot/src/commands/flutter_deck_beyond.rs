//! What `flutter --deck` says of roots beyond the reduced frequencies of MKAERO1 and MKAERO2.

use fullaircraft::{FlutterDeck, FlutterPoints};
use maneuver::flutter::{CompleteCurves, Crossing};

/// The sentence, if there are such roots: which, where, what is assumed of them, and what would compute them.
pub(super) fn remark(deck: &FlutterDeck, group: &FlutterPoints, curves: &CompleteCurves) -> Option<String> {
    let k = |omega_rad_s: f64, v_m_s: f64| omega_rad_s / v_m_s / deck.modal.kappa(1.0);
    let (mut branches, mut speeds, mut ks) = (Vec::new(), Range::new(), Range::new());
    for (at, branch) in curves.branches.iter().enumerate() {
        for (root, flow) in
            branch.roots.iter().zip(&curves.flows[branch.first..]).filter(|(root, _)| root.beyond_table)
        {
            if branches.last() != Some(&(at + 1)) {
                branches.push(at + 1);
            }
            speeds.reach(flow.v_m_s);
            ks.reach(k(root.p.im, flow.v_m_s));
        }
    }
    let changes: Vec<&Crossing> = curves.crossings.iter().filter(|crossing| crossing.beyond_table).collect();
    for crossing in &changes {
        speeds.reach(crossing.flow.v_m_s);
        ks.reach(k(crossing.omega_rad_s, crossing.flow.v_m_s));
        if !branches.contains(&(crossing.branch + 1)) {
            branches.push(crossing.branch + 1);
            branches.sort_unstable();
        }
    }
    if branches.is_empty() {
        return None;
    }
    let mut listed = Range::new();
    group.machs().into_iter().for_each(|mach| listed.reach(deck.highest_k(mach)));
    let one = |crossing: &&Crossing| {
        let (v, branch) = (crossing.flow.v_m_s, crossing.branch + 1);
        format!("{v:.4} (branch {branch}, k = {:.3})", k(crossing.omega_rad_s, v))
    };
    let rests = changes.iter().map(one).collect::<Vec<_>>().join(" and at ");
    // few and low k may hide a flutter as well as move it: what was not found is no comfort
    let advice = if changes.is_empty() {
        "a flutter among them may be missed: list higher k in MKAERO1 or MKAERO2".to_owned()
    } else {
        format!("the change of stability at {rests} rests on it: list higher k in MKAERO1 or MKAERO2")
    };
    Some(format!(
        "{} beyond the reduced frequencies of MKAERO1 and MKAERO2 (highest k: {}), up to k = {:.3}, at velocities {}: the air there is \
         assumed to have Re Q and Im Q/k of the last k, and roots are a hint only; {advice}",
        named(&branches),
        listed.text(),
        ks.high,
        speeds.text(),
    ))
}

/// Numbers from the lowest to the highest.
struct Range {
    low: f64,
    high: f64,
}

impl Range {
    fn new() -> Self {
        Self { low: f64::INFINITY, high: f64::NEG_INFINITY }
    }

    fn reach(&mut self, value: f64) {
        self.low = self.low.min(value);
        self.high = self.high.max(value);
    }

    fn text(&self) -> String {
        let short = |value: f64| {
            let text = format!("{value:.4}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        };
        let [low, high] = [self.low, self.high].map(short);
        if low == high { low } else { format!("{low} to {high}") }
    }
}

/// Branches with the runs among them shortened.
fn named(branches: &[usize]) -> String {
    let runs: Vec<String> = branches
        .chunk_by(|a, b| a + 1 == *b)
        .map(|run| match run {
            [one] => one.to_string(),
            [first, second] => format!("{first} and {second}"),
            run => format!("{} to {}", run[0], run[run.len() - 1]),
        })
        .collect();
    let (what, go) = if branches.len() == 1 { ("branch", "goes") } else { ("branches", "go") };
    format!("{what} {} {go}", runs.join(", "))
}
