//! Where the residual sits: candidates by family, each tested together against pure error, alone and beside all other
//! families (a family that others explain as well has a small second F).

use super::evidence::{Beyond, Candidate};
use super::noise::Base;
use crate::data::Data;
use crate::f_test::FTest;
use crate::fault::Fault;
use crate::qr::dot;

/// A family of regressors on what the model leaves.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    /// `powers of alpha`, `q with delta`, `offsets of run`.
    pub name: String,
    /// Its candidates.
    pub members: Vec<String>,
    /// Share of the residual sum of squares that it explains.
    pub share: f64,
    /// F test of all of it against pure error: the mean square in units of pure error.
    pub alone: FTest,
    /// The same for what it explains beyond all other families; none if they explain all that it does.
    pub beside_others: Option<FTest>,
}

/// The family of a candidate: which factors it has.
fn family(candidate: &Candidate) -> String {
    match candidate {
        Candidate::Blocks(name) => format!("offsets of {name}"),
        Candidate::Term(term) => {
            let mut factors: Vec<&str> = term.powers().map(|(factor, _)| factor).collect();
            factors.sort_unstable();
            match factors.as_slice() {
                [] => "the constant".into(),
                [one] => format!("powers of {one}"),
                several => several.join(" with "),
            }
        }
    }
}

/// All families, the one with most of the residual first.
pub(super) fn families(base: &Base, data: &Data, candidates: &[Candidate]) -> Result<Vec<Family>, Fault> {
    let mut groups: Vec<(String, Vec<usize>)> = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        let name = family(candidate);
        match groups.iter_mut().find(|(known, _)| *known == name) {
            Some((_, members)) => members.push(index),
            None => groups.push((name, vec![index])),
        }
    }
    let columns = candidates.iter().map(|c| c.columns(data)).collect::<Result<Vec<_>, _>>()?;
    let explained = |wanted: &dyn Fn(usize) -> bool| -> Result<(f64, f64), Fault> {
        let taken = columns.iter().enumerate().filter(|(index, _)| wanted(*index));
        let taken: Vec<Vec<f64>> = taken.flat_map(|(_, columns)| columns.iter().cloned()).collect();
        let beyond = Beyond::of(&base.fitted, &taken)?;
        Ok((beyond.explained(&base.fitted.residuals), beyond.basis.len() as f64))
    };
    let all = explained(&|_| true)?;
    let total = dot(&base.fitted.residuals, &base.fitted.residuals);
    let test = |sum: f64, above: f64| {
        FTest::new(sum, above, base.noise.variance * base.noise.freedom, base.noise.freedom)
    };
    let mut found = Vec::new();
    for (name, members) in groups {
        let (own, freedom) = explained(&|index| members.contains(&index))?;
        if freedom == 0.0 {
            continue;
        }
        let others = explained(&|index| !members.contains(&index))?;
        let beside = all.1 - others.1;
        found.push(Family {
            name,
            members: members.iter().map(|index| candidates[*index].name()).collect(),
            share: own / total,
            alone: test(own, freedom),
            beside_others: (beside > 0.0).then(|| test(all.0 - others.0, beside)),
        });
    }
    found.sort_by(|a, b| b.share.total_cmp(&a.share));
    Ok(found)
}
