//! Runs drawn from the published models, as the paper's measurements are not public: at its test points, with scatter,
//! an offset for every block, and forces read in the balance's steps. Everything about errors is assumed but for that
//! resolution, 0.03 N. Nothing that analyses data may call this: what it adds is what an analysis has to find.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use super::factor::Condition;
use super::model::{Model, NoValue, Rules};
use super::points::{BALANCE_RESOLUTION_N, ROOT_CHORD_M, Series, TestPoint, WING_AREA_M2};
use super::published::Published;
use super::runs::Runs;

/// Standard deviations of one response, in its unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// From point to point within a block.
    pub point: f64,
    /// From block to block.
    pub block: f64,
}

/// The errors of runs. The default is what the shipped runs have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// Propeller speed, krpm.
    pub n_krpm: Spread,
    /// Lift coefficient.
    pub lift: Spread,
    /// Drag coefficient.
    pub drag: Spread,
    /// Pitching moment coefficient.
    pub moment: Spread,
    /// How the forces are read; `None` leaves the balance out.
    pub balance: Option<Balance>,
}

/// A point is the mean of readings, each scattered and rounded to a step of the balance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// Step of a force, N.
    pub resolution_n: f64,
    /// Step of a moment, N m.
    pub resolution_nm: f64,
    /// Standard deviation of one reading, in steps.
    pub reading_steps: f64,
    /// Readings of a point.
    pub readings: u32,
}

impl Default for Balance {
    /// The published step of a force; that of the moment is assumed to be it at a quarter of the root chord.
    fn default() -> Self {
        Self {
            resolution_n: BALANCE_RESOLUTION_N,
            resolution_nm: BALANCE_RESOLUTION_N * 0.25 * ROOT_CHORD_M,
            reading_steps: 1.0,
            readings: 400,
        }
    }
}

impl Default for Errors {
    fn default() -> Self {
        Self {
            n_krpm: Spread { point: 0.05, block: 0.08 },
            lift: Spread { point: 0.008, block: 0.012 },
            drag: Spread { point: 0.003, block: 0.0045 },
            moment: Spread { point: 0.003, block: 0.0045 },
            balance: Some(Balance::default()),
        }
    }
}

impl Errors {
    /// No error at all: the models' own values.
    pub const NONE: Self = {
        let none = Spread { point: 0.0, block: 0.0 };
        Self { n_krpm: none, lift: none, drag: none, moment: none, balance: None }
    };

    /// Of the response with this name.
    pub fn spread(&self, response: &str) -> Spread {
        match response {
            "n_krpm" => self.n_krpm,
            "CL" => self.lift,
            "CD" => self.drag,
            _ => self.moment,
        }
    }
}

/// Draws a series. The same seed gives the same runs everywhere. Terms without published coefficient are left out.
/// Offsets of the blocks add up to zero: what all blocks share no data could tell from the constant term.
///
/// # Errors
/// If the series' equations are not all there, or do not hold at its points.
pub fn draw(published: &Published, series: Series, errors: &Errors, seed: u64) -> Result<Runs, NoValue> {
    let (equations, wing) = series.equations();
    let models: Vec<&Model> =
        equations.iter().map(|&equation| published.given(equation, wing)).collect::<Result<_, _>>()?;
    let points = with_speed(published, series, &models)?;
    let mut random = Source::new(seed, series);
    let offsets: Vec<Vec<f64>> = models
        .iter()
        .map(|model| random.offsets(series.blocks(), errors.spread(&model.response).block))
        .collect();
    let mut runs = Runs::new(series, models.iter().map(|model| model.response.clone()).collect());
    for block in 0..series.blocks() {
        for point in &points {
            let mut values = Vec::new();
            for (model, offsets) in models.iter().zip(&offsets) {
                let truth = published.value(model, &point.condition, rules())?;
                let scatter = random.normal(errors.spread(&model.response).point);
                let value = truth + offsets[block] + scatter;
                values.push(random.read(value, &model.response, &point.condition, errors.balance));
            }
            runs.push(block, point, values);
        }
    }
    Ok(runs)
}

/// Seed of the shipped runs.
pub const SHIPPED_SEED: u64 = 2008;

/// The shipped files: name and content, a series each.
///
/// # Errors
/// As [`draw`].
pub fn shipped_files(published: &Published) -> Result<Vec<(String, String)>, NoValue> {
    let file = |series: Series| {
        let runs = draw(published, series, &Errors::default(), SHIPPED_SEED)?;
        Ok((format!("{}.csv", series.name()), runs.csv()))
    };
    Series::ALL.into_iter().map(file).collect()
}

/// What the series' points give without any error, in the order of [`Series::points`]; one list a response.
///
/// # Errors
/// As [`draw`].
pub fn truth(published: &Published, series: Series) -> Result<Runs, NoValue> {
    draw(published, series, &Errors::NONE, 0)
}

fn rules() -> Rules {
    Rules::STRICT.leaving_out_missing()
}

/// The points, with the propeller speed of Eq. 4 of paper 2 to the revolution where the models need it.
fn with_speed(published: &Published, series: Series, models: &[&Model]) -> Result<Vec<TestPoint>, NoValue> {
    let needed = models.iter().any(|model| model.needs_propeller_speed());
    let mut points = series.points();
    for point in points.iter_mut().filter(|_| needed) {
        let n_krpm = published.propeller_speed_krpm(&point.condition, Rules::STRICT)?;
        point.condition.n_krpm = Some((n_krpm * 1e3).round() / 1e3);
    }
    Ok(points)
}

/// Random numbers that are the same on every platform, with one stream a series.
struct Source(ChaCha8Rng);

impl Source {
    fn new(seed: u64, series: Series) -> Self {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        generator.set_stream(1 + series as u64);
        Self(generator)
    }

    fn normal(&mut self, sigma: f64) -> f64 {
        let unit: f64 = StandardNormal.sample(&mut self.0);
        sigma * unit
    }

    fn offsets(&mut self, blocks: usize, sigma: f64) -> Vec<f64> {
        let offsets: Vec<f64> = (0..blocks).map(|_| self.normal(sigma)).collect();
        let mean = offsets.iter().sum::<f64>() / blocks as f64;
        offsets.iter().map(|offset| offset - mean).collect()
    }

    /// A coefficient as the balance reports it.
    fn read(&mut self, value: f64, response: &str, condition: &Condition, balance: Option<Balance>) -> f64 {
        let Some(balance) = balance.filter(|_| response != "n_krpm") else { return value };
        let force_n = condition.q_pa * WING_AREA_M2;
        let step = if response == "Cm" {
            balance.resolution_nm / (force_n * ROOT_CHORD_M)
        } else {
            balance.resolution_n / force_n
        };
        let sum: f64 = (0..balance.readings.max(1))
            .map(|_| (value / step + self.normal(balance.reading_steps)).round())
            .sum();
        step * sum / f64::from(balance.readings.max(1))
    }
}
