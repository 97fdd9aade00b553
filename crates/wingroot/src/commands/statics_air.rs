//! `statics --wing`: a wing in steady air over airspeed, small beside large deflections.

use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use aero::{Corrections, Flow};
use calibrate::Schedule;
use coupling::{CouplingError, ElasticWing, Geometry, LargeWing, SteadyCase, WingFile};
use nastran::InputError;
use report::{Figure, Panel, Series, Style, Table};

use crate::args::{Common, airspeed};
use crate::commands::result_parts::as_json;
use crate::commands::statics_air_result::{AirPoint, Bent, StaticsAirResult};
use crate::corrections::as_given;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Options of `statics` for a wing in steady air.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct AirArgs {
    /// A wing in steady air, with its own weight
    #[arg(long, value_name = "FILE", conflicts_with = "deck")]
    pub(crate) wing: Option<PathBuf>,
    /// Airspeeds, m/s
    #[arg(long, value_name = "V,V", value_delimiter = ',', value_parser = airspeed, requires = "wing")]
    pub(crate) airspeeds: Vec<f64>,
    /// Angle of attack of the root, deg [default: 5]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true, requires = "wing")]
    pub(crate) alpha: Option<f64>,
    /// Density of the air, kg/m3 [default: 1.225]
    #[arg(long, value_name = "RHO", requires = "wing")]
    pub(crate) density: Option<f64>,
    /// Corrections of this wing from `calibrate` [default: none]
    #[arg(long, value_name = "FILE", requires = "wing")]
    pub(crate) corrections: Option<PathBuf>,
}

/// Airspeeds if none are named, m/s.
const AIRSPEEDS: [f64; 5] = [10.0, 20.0, 30.0, 40.0, 50.0];
/// Angle of attack if nothing is said, degrees.
const ALPHA_DEG: f64 = 5.0;
/// Beyond, the stream is no longer along the wing, degrees.
const STEEPEST_DEG: f64 = 45.0;
/// Of the standard atmosphere at sea level, kg/m3.
const DENSITY: f64 = 1.225;

const CAPTION: &str = "The wing over airspeed: its tip, the twist of the tip's section and the loads on the balance. Dashed what linear \
                       theory says, whose lines end at its divergence.";

/// What is asked for.
struct Task {
    file: WingFile,
    cases: Vec<SteadyCase>,
    corrections: Vec<Corrections>,
    alpha_deg: f64,
    rho_kg_m3: f64,
}

/// Runs the command.
pub(super) fn run(args: &AirArgs, nonlinear: bool, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let path = crate::paths::wing(args.wing.as_deref())?;
    let is_large = nonlinear || WingFile::read(&path)?.geometry == Geometry::Nonlinear;
    let (task, points) = if is_large {
        let (file, wing) = LargeWing::read(&path)?;
        let task = Task::of(args, file, wing.elastic.correctable.len())?;
        let points = task.points(&wing.elastic, Some(&wing))?;
        (task, points)
    } else {
        let (file, wing) = ElasticWing::read(&path)?;
        let task = Task::of(args, file, wing.correctable.len())?;
        let points = task.points(&wing, None)?;
        (task, points)
    };
    let result = StaticsAirResult {
        command: "statics",
        wing: task.file.name.clone(),
        large_deflections: is_large,
        alpha_deg: task.alpha_deg,
        rho_kg_m3: task.rho_kg_m3,
        points,
        seconds: start.elapsed().as_secs_f64(),
    };
    let folder = ResultFolder::begin(&common.out("statics"))?;
    folder.input("wing", &path)?;
    if let Some(corrections) = &args.corrections {
        folder.input("corrections", corrections)?;
    }
    folder.write_text("airspeeds.csv", &csv(&result.points))?;
    folder.write_figure("tip_over_airspeed", CAPTION, figure(&result))?;
    let json = as_json(&result)?;
    folder.write_json("result.json", &json)?;
    let out = folder.commit()?;
    let mut text = summary(&result);
    let _ = write!(text, "written to {} in {:.1} s", out.display(), result.seconds);
    show::summary(common, &text);
    show::json(common, &json)
}

impl Task {
    fn of(args: &AirArgs, file: WingFile, boxes: usize) -> Result<Self, Failure> {
        let alpha_deg = args.alpha.unwrap_or(ALPHA_DEG);
        let rho_kg_m3 = args.density.unwrap_or(DENSITY);
        if !(-STEEPEST_DEG..=STEEPEST_DEG).contains(&alpha_deg) {
            let message =
                format!("--alpha is {alpha_deg}, expected degrees from -{STEEPEST_DEG} to {STEEPEST_DEG}");
            return Err(InputError::general(message).into());
        }
        if !(rho_kg_m3 > 0.0 && rho_kg_m3 <= 100.0) {
            let message = format!("--density is {rho_kg_m3}, expected a density above 0 and up to 100 kg/m3");
            return Err(InputError::general(message).into());
        }
        let mut airspeeds =
            if args.airspeeds.is_empty() { AIRSPEEDS.to_vec() } else { args.airspeeds.clone() };
        airspeeds.sort_by(f64::total_cmp);
        let case = |v_m_s: &f64| SteadyCase::new(Flow { v_m_s: *v_m_s, rho_kg_m3 }, alpha_deg.to_radians());
        let cases: Vec<SteadyCase> = airspeeds.iter().map(case).collect();
        let corrections = match &args.corrections {
            None => vec![Corrections::neutral(boxes); cases.len()],
            Some(path) => {
                let schedule = Schedule::read(path)?;
                if schedule.wing_hash != file.hash {
                    let message =
                        format!("these corrections belong to another wing than {}", file.path.display());
                    let help = "corrections hold for the wing they were found with";
                    return Err(InputError::in_file(path, message).with_help(help).into());
                }
                as_given(&schedule);
                airspeeds.iter().map(|v| schedule.at(*v)).collect::<Result<_, _>>()?
            }
        };
        Ok(Self { file, cases, corrections, alpha_deg, rho_kg_m3 })
    }

    fn points(&self, elastic: &ElasticWing, large: Option<&LargeWing>) -> Result<Vec<AirPoint>, Failure> {
        let bent = match large {
            Some(wing) => wing.solve_with(&self.cases, &self.corrections)?.into_iter().map(Some).collect(),
            None => vec![None; self.cases.len()],
        };
        let mut points = Vec::with_capacity(self.cases.len());
        for ((case, corrections), state) in self.cases.iter().zip(&self.corrections).zip(bent) {
            let linear = match elastic.at(case.flow, corrections) {
                Ok(operator) => {
                    let state = operator.solve(std::slice::from_ref(case)).remove(0);
                    let twist_rad = elastic.tip_twist_rad(&state.displacement);
                    Some(Bent {
                        tip_z_m: state.tip_z_m,
                        tip_y_m: 0.0,
                        tip_twist_deg: twist_rad.to_degrees(),
                        root: state.root.into(),
                    })
                }
                Err(CouplingError::Diverged { .. }) => None,
                Err(error) => return Err(error.into()),
            };
            points.push(AirPoint {
                v_m_s: case.flow.v_m_s,
                linear,
                iterations: state.as_ref().map(|state| state.iterations),
                divergence_gain: state.as_ref().map(|state| state.gain),
                large: state.map(|state| Bent {
                    tip_z_m: state.tip_m.z,
                    tip_y_m: state.tip_m.y,
                    tip_twist_deg: state.twist_rad.to_degrees(),
                    root: state.root.into(),
                }),
            });
        }
        Ok(points)
    }
}

/// Values of a wing as it stands, in the order of tables.
fn values(bent: &Bent) -> [f64; 6] {
    let [fz, mx, my] = bent.root.to_array();
    [bent.tip_z_m, bent.tip_y_m, bent.tip_twist_deg, fz, mx, my]
}

fn csv(points: &[AirPoint]) -> String {
    let names = ["tip_z_m", "tip_y_m", "tip_twist_deg", "Fz_N", "Mx_Nm", "My_Nm"];
    let mut text = String::from("V_m_s");
    for which in ["linear", "large"] {
        for name in names {
            let _ = write!(text, ",{which}_{name}");
        }
    }
    text.push('\n');
    for point in points {
        let _ = write!(text, "{}", point.v_m_s);
        for bent in [&point.linear, &point.large] {
            match bent {
                Some(bent) => {
                    for value in values(bent) {
                        let _ = write!(text, ",{value:.9e}");
                    }
                }
                None => text.push_str(",,,,,,"),
            }
        }
        text.push('\n');
    }
    text
}

fn figure(result: &StaticsAirResult) -> Figure {
    let panel = |(title, label, of): (&str, &str, usize)| {
        let line = |name: &str, which: &dyn Fn(&AirPoint) -> Option<Bent>, style: Style| {
            let known =
                result.points.iter().filter_map(|point| Some((point.v_m_s, values(&which(point)?)[of])));
            let (x, y): (Vec<f64>, Vec<f64>) = known.unzip();
            (!x.is_empty()).then(|| Series::new(name, x, y, style))
        };
        let lines = [
            line("linear", &|point| point.linear, Style::DashedLine),
            line("large deflections", &|point| point.large, Style::Line),
        ];
        Panel::new(title, "airspeed (m/s)", label, lines.into_iter().flatten().collect())
    };
    let panels = [
        ("rise of the tip", "tip z (m)", 0),
        ("twist of the tip", "twist (deg)", 2),
        ("force", "Fz (N)", 3),
        ("bending moment", "Mx (N m)", 4),
    ];
    let title = format!("{} at {} degrees", result.wing, result.alpha_deg);
    Figure::new(title, panels.map(panel).into(), 2)
}

fn summary(result: &StaticsAirResult) -> String {
    let mut text = format!(
        "{} at {} degrees, {} kg/m3, {} deflections\n",
        result.wing,
        result.alpha_deg,
        result.rho_kg_m3,
        if result.large_deflections { "large (linear theory beside)" } else { "small" },
    );
    let head =
        ["V (m/s)", "tip z (m)", "linear", "twist (deg)", "linear", "Fz (N)", "linear", "Mx (N m)", "linear"];
    let wanted: Vec<usize> =
        (0..9).filter(|column| result.large_deflections || matches!(column, 0 | 1 | 3 | 5 | 7)).collect();
    let mut table = Table::new(&wanted.iter().map(|column| head[*column]).collect::<Vec<_>>());
    for point in &result.points {
        let cell = |bent: Option<&Bent>, of: usize, digits: usize| {
            bent.map_or_else(|| "diverged".to_owned(), |bent| format!("{:.digits$}", values(bent)[of]))
        };
        let mut row = vec![format!("{}", point.v_m_s)];
        for (of, digits) in [(0, 4), (2, 3), (3, 2), (4, 3)] {
            if point.large.is_some() {
                row.push(cell(point.large.as_ref(), of, digits));
            }
            row.push(cell(point.linear.as_ref(), of, digits));
        }
        table.row(row);
    }
    let _ = writeln!(text, "{table}");
    text
}
