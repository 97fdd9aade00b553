//! `station_loads` of `fullaircraft --cases`: loads of all cases at all stations, a row each, as Parquet.

use fullaircraft::{Case, CaseResult};

use crate::commands::fullaircraft_cases_flown::Flying;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::partitioned::{Cell, Column, Kind, Partitioned};

/// Name of the table.
const TABLE: &str = "station_loads";
/// Its columns beside kind and mass.
const COLUMNS: [Column; 12] = [
    Column("case_number", Kind::Whole),
    Column("model", Kind::Words),
    Column("maneuver", Kind::Words),
    Column("V_m_s", Kind::Real("m/s")),
    Column("load_factor", Kind::Real("1")),
    Column("station", Kind::Words),
    Column("Fz_min_N", Kind::Real("N")),
    Column("Fz_max_N", Kind::Real("N")),
    Column("Mx_min_Nm", Kind::Real("N m")),
    Column("Mx_max_Nm", Kind::Real("N m")),
    Column("My_min_Nm", Kind::Real("N m")),
    Column("My_max_Nm", Kind::Real("N m")),
];

/// The table in the making.
pub(crate) struct LoadsTable {
    table: Partitioned<'static>,
    mass_kg: String,
}

impl LoadsTable {
    /// In a result folder.
    pub(crate) fn new(folder: &ResultFolder, flying: &Flying<'_>) -> Self {
        // with a point in any case: DuckDB takes whole numbers in names of folders for numbers, all others for words
        let mass_kg = format!("{:?}", flying.tools.aircraft.file.total.mass_kg);
        Self { table: Partitioned::new(folder.path(), TABLE, &COLUMNS), mass_kg }
    }

    /// Adds the rows of a case; one that could not be flown has none.
    pub(crate) fn add(&mut self, case: &Case, result: &CaseResult) -> Result<(), Failure> {
        for place in &result.loads {
            let loads = [place.fz_n, place.mx_nm, place.my_nm].into_iter().flatten().map(Cell::Real);
            let mut row = vec![
                Cell::Whole(result.number),
                Cell::Words(&result.model),
                Cell::Words(&result.maneuver),
                Cell::Real(result.v_m_s),
                Cell::Real(result.load_factor),
                Cell::Words(&place.station),
            ];
            row.extend(loads);
            self.table.push(&[("kind", case.kind()), ("mass_kg", &self.mass_kg)], &row)?;
        }
        Ok(())
    }

    /// Writes the ends of all files.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        self.table.finish()
    }
}
