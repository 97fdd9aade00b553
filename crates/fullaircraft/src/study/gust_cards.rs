//! The gusts of a study as cards.
//!
//! ```text
//! w(t) = WG V f(t),   f = 1/2 [1 - cos(pi V t/H)] from 0 to 2 H/V
//! ```
//! for one minus cosine of the gradient H: half of a constant less half of a wave, two TLOAD2 whose transforms are exact.

use super::cards::{Asked, FIRST, blanks, label, real};
use super::fault::Fault;
use super::gusts::{Gusts, Wave};
use nastran::BulkData;
use std::fmt::Write as _;

/// Its frequencies, times and load without force, and the set of grids.
const FREQUENCIES: u32 = FIRST + 500_020;
const TIMES: u32 = FIRST + 500_021;
const NO_FORCE: u32 = FIRST + 500_022;
const GRIDS: u32 = 1;
/// First number of its gusts, and how many each takes: GUST, function, and two parts or a table.
const GUSTS: u32 = FIRST + 500_100;
const A_GUST: usize = 4;
/// Grids of a line of case control.
const A_LINE: usize = 8;

impl Gusts {
    /// What it asks for; `front_x` is where the gusts are at the time zero.
    pub(super) fn asked(&self, decks: &BulkData, front_x: f64) -> Result<Asked, Fault> {
        let mut asked = Asked::default();
        if let Some(name) = ["Q", "MACH"].into_iter().find(|name| decks.parameters.contains_key(*name)) {
            return Err(Fault::new("gusts", format!("the decks have a PARAM {name} of their own"))
                .with_help("take it out of the decks: the study gives the flow"));
        }
        asked.select("FREQUENCY", FREQUENCIES);
        asked.select("TSTEP", TIMES);
        asked.control += &self.responses(decks)?;
        let q = 0.5 * self.rho * self.v * self.v;
        asked.add("PARAM", &["Q".to_owned(), real(q)]);
        asked.add("PARAM", &["MACH".to_owned(), real(self.mach)]);
        if !decks.parameters.contains_key("GUSTAERO") {
            // Nastran computes the air forces of gusts where this asks for them.
            asked.add("PARAM", &["GUSTAERO".to_owned(), "-1".to_owned()]);
        }
        let (of, times) = (&self.frequencies, &self.times);
        let steps = format!("{:.0}", of.steps());
        asked.add("FREQ1", &[FREQUENCIES.to_string(), real(of.first_hz()), real(of.step_hz), steps]);
        let steps = format!("{:.0}", times.steps());
        asked.add("TSTEP", &[TIMES.to_string(), steps, real(times.step_s), "1".to_owned()]);
        // Other programs want a load that the functions multiply.
        if let Some(grid) = decks.grids.keys().next() {
            asked.add("DAREA", &[NO_FORCE.to_string(), grid.to_string(), "3".to_owned(), real(0.0)]);
        }
        for ((number, first), wave) in (1_u32..).zip((GUSTS..).step_by(A_GUST)).zip(&self.waves) {
            let name = label(&wave.name);
            let _ = writeln!(asked.control, "SUBCASE {number}\n  LABEL = {name}");
            asked.select("  GUST", first);
            asked.select("  DLOAD", first + 1);
            let scale = real(wave.amplitude / self.v);
            let [id, function] = [first, first + 1].map(|id| id.to_string());
            asked.add("GUST", &[id, function, scale, real(front_x), real(self.v)]);
            self.function(wave, first + 1, &mut asked);
        }
        Ok(asked)
    }

    /// The function of a gust over time, under a number and those behind it.
    fn function(&self, wave: &Wave, id: u32, asked: &mut Asked) {
        let [own, second, third] = [id, id + 1, id + 2].map(|id| id.to_string());
        let no_force = NO_FORCE.to_string();
        let Some(gradient) = wave.gradient else {
            let points = wave.points.iter().flat_map(|(t, f)| [real(*t), real(*f)]);
            let table = std::iter::once(second.clone()).chain(blanks(7)).chain(points);
            asked.add("TLOAD1", &[own, no_force, String::new(), String::new(), second]);
            asked.add("TABLED1", &table.chain(["ENDT".to_owned()]).collect::<Vec<_>>());
            return;
        };
        let length_s = 2.0 * gradient / self.v;
        let parts = [real(1.0), second.clone(), real(-1.0), third.clone()];
        asked.add("DLOAD", &[&[own, real(0.5)][..], &parts].concat());
        for (id, hz) in [(second, 0.0), (third, 1.0 / length_s)] {
            let [none, type_load] = [String::new(), String::new()];
            asked
                .add("TLOAD2", &[id, no_force.clone(), none, type_load, real(0.0), real(length_s), real(hz)]);
        }
    }

    /// The grids whose motions are asked for.
    fn responses(&self, decks: &BulkData) -> Result<String, Fault> {
        if let Some(grid) = self.grids.iter().find(|grid| !decks.grids.contains_key(grid)) {
            return Err(Fault::new("grids", format!("GRID {grid} is not in the decks")));
        }
        if self.grids.is_empty() {
            return Ok(String::new());
        }
        let lines = self.grids.chunks(A_LINE).map(|line| {
            let ids: Vec<String> = line.iter().map(ToString::to_string).collect();
            ids.join(", ")
        });
        let list = lines.collect::<Vec<_>>().join(",\n");
        Ok(format!("SET {GRIDS} = {list}\nDISPLACEMENT = {GRIDS}\n"))
    }
}
