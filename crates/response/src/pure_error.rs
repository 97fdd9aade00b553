//! Pure error from replicates, with and without the offsets of blocks, and the F test of lack of fit against it.
//! Replicates are points with the same factors. With blocks the saturated model is one mean for every distinct point and one
//! offset for every block, so replicates in different blocks count.

use std::collections::BTreeMap;

use crate::columns::Columns;
use crate::data::{Blocking, Data};
use crate::f_test::FTest;
use crate::fault::{Fault, list};
use crate::qr::{Qr, dot};
use crate::regression::Regression;

/// Scatter of replicates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PureError {
    /// Sum of squares, unit of the response squared.
    pub sum: f64,
    /// Its degrees of freedom.
    pub degrees_of_freedom: f64,
}

impl PureError {
    /// Variance of one reading, unit of the response squared.
    pub fn variance(&self) -> f64 {
        self.sum / self.degrees_of_freedom
    }
}

/// How much of the pure error blocks explain (claim M12).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BlockShare {
    /// Without looking at blocks.
    pub without: PureError,
    /// With an offset for every block.
    pub with: PureError,
}

impl BlockShare {
    /// Share of the variance of pure error that offsets of blocks remove; negative if they remove nothing.
    pub fn removed(&self) -> f64 {
        1.0 - self.with.variance() / self.without.variance()
    }

    /// F test of all offsets against the pure error that is left.
    pub fn test(&self) -> FTest {
        let above = self.without.degrees_of_freedom - self.with.degrees_of_freedom;
        FTest::new(self.without.sum - self.with.sum, above, self.with.sum, self.with.degrees_of_freedom)
    }
}

/// For each point the number of its distinct point, and how many of them there are.
pub(crate) fn distinct(data: &Data) -> (Vec<usize>, usize) {
    let mut known: BTreeMap<Vec<u64>, usize> = BTreeMap::new();
    let of = |i: usize| -> Vec<u64> {
        // + 0.0 makes -0 and 0 the same
        data.point(i).into_iter().map(|(_, value)| (value + 0.0).to_bits()).collect()
    };
    let numbers = (0..data.points()).map(|i| {
        let next = known.len();
        *known.entry(of(i)).or_insert(next)
    });
    let numbers: Vec<usize> = numbers.collect();
    let count = known.len();
    (numbers, count)
}

/// A column about the means of the distinct points.
fn about_means(column: &[f64], of_point: &[usize], count: usize) -> Vec<f64> {
    let (mut sums, mut sizes) = (vec![0.0; count], vec![0.0; count]);
    for (value, point) in column.iter().zip(of_point) {
        sums[*point] += value;
        sizes[*point] += 1.0;
    }
    column.iter().zip(of_point).map(|(value, point)| value - sums[*point] / sizes[*point]).collect()
}

/// What replicates leave at each point once means of distinct points (and offsets of blocks) are out.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scatter {
    pub(crate) rest: Vec<f64>,
    pub(crate) freedom: f64,
}

/// The pure error of a response. With fixed or random blocks the offsets of all block columns are taken out.
///
/// # Errors
/// If there is no such response, or no degree of freedom is left for the scatter of replicates.
pub fn pure_error(data: &Data, response: &str, blocking: Blocking) -> Result<PureError, Fault> {
    let Scatter { rest, freedom } = scatter(data, response, blocking)?;
    Ok(PureError { sum: dot(&rest, &rest), degrees_of_freedom: freedom })
}

/// The same point by point.
///
/// # Errors
/// As [`pure_error`].
pub(crate) fn scatter(data: &Data, response: &str, blocking: Blocking) -> Result<Scatter, Fault> {
    let (of_point, count) = distinct(data);
    let mut rest = about_means(data.response_values(response)?, &of_point, count);
    let mut parameters = count;
    if blocking != Blocking::Ignored {
        let columns = Columns::default().with_blocks(data.blocks());
        let values = columns.values.iter().map(|column| about_means(column, &of_point, count));
        let mut kept = Qr::new(&[], &[])?;
        for (column, name) in values.zip(&columns.names) {
            match kept.add(&column, name, &columns.names) {
                // offsets that the distinct points do not tell apart are means of points already
                Ok(()) | Err(Fault::Aliased { .. }) => {}
                Err(other) => return Err(other),
            }
        }
        rest = kept.remainder(&rest).0;
        parameters += kept.q.len();
    }
    if parameters >= data.points() {
        let why = match data.points() - count {
            0 => "no point is measured twice".to_string(),
            repeats => format!("{repeats} repeated points are no more than offsets of blocks"),
        };
        return Err(Fault::NoReplicates { why, factors: list(data.factor_names()) });
    }
    Ok(Scatter { rest, freedom: (data.points() - parameters) as f64 })
}

/// What blocks explain of the pure error.
///
/// # Errors
/// As [`pure_error`].
pub fn block_share(data: &Data, response: &str) -> Result<BlockShare, Fault> {
    let without = pure_error(data, response, Blocking::Ignored)?;
    Ok(BlockShare { without, with: pure_error(data, response, Blocking::Fixed)? })
}

/// F test of lack of fit: what the surface leaves beyond pure error, against pure error.
///
/// # Errors
/// As [`pure_error`]; if the surface leaves no degree of freedom beyond replicates; for random blocks, whose residual sum
/// is not of the same kind.
pub fn lack_of_fit(data: &Data, fitted: &Regression, blocking: Blocking) -> Result<FTest, Fault> {
    if blocking == Blocking::Random {
        let why = "lack of fit is tested with fixed blocks".to_string();
        return Err(Fault::Block { name: list(data.blocks().iter().map(|b| b.name.as_str())), why });
    }
    let pure = pure_error(data, &fitted.response, blocking)?;
    let freedom = fitted.degrees_of_freedom - pure.degrees_of_freedom;
    if freedom <= 0.0 {
        let points = distinct(data).1;
        let needs = " and a test of lack of fit";
        return Err(Fault::TooFewPoints { points, terms: fitted.coefficients.len(), needs });
    }
    Ok(FTest::new(fitted.residual_sum - pure.sum, freedom, pure.sum, pure.degrees_of_freedom))
}
