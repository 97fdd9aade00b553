#![doc = include_str!("../README.md")]

mod analysis;
pub mod asymmetry;
mod candidates;
mod choice;
mod columns;
mod cross_validation;
mod data;
pub mod design;
mod distributions;
mod effects;
mod fault;
mod lenth;
pub mod mav;
pub mod missing;
mod predict;
mod pure_error;
mod qr;
mod regression;
mod reml;
mod study;
mod term;
mod total_sum;

pub use analysis::{Analysis, analyse};
pub use candidates::{Candidates, candidates, told_apart};
pub use choice::{Choice, Criteria, ErrorRule, Rules, Search, Step, choose};
pub use cross_validation::cross_validation;
pub use data::{Blocks, Data};
pub use effects::{Effect, EffectTest, Effects, effects};
pub use fault::Fault;
pub use lenth::{Lenth, PlotPoint, half_normal_plot, normal_plot};
pub use predict::{Prediction, Slope};
pub use pure_error::{BlockShare, FTest, PureError, block_share, lack_of_fit, pure_error};
pub use regression::{BlockOffset, Blocking, Coefficient, Regression};
pub use study::{EffectsStudy, Study, TableAnalysis, TableStudy};
pub use term::Term;
