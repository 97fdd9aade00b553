//! The columns of a model: one for each term, and for each block column its offsets, which sum to zero over its blocks, so
//! that the coefficients of the terms are those of the mean block.

use crate::data::{Blocking, Blocks, Data};
use crate::fault::Fault;
use crate::qr::Qr;
use crate::term::Term;

/// Columns with their names.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Columns {
    pub(crate) names: Vec<String>,
    pub(crate) values: Vec<Vec<f64>>,
}

impl Columns {
    /// Columns of terms.
    pub(crate) fn of_terms(data: &Data, terms: &[Term]) -> Result<Self, Fault> {
        let mut columns = Self::default();
        for (index, term) in terms.iter().enumerate() {
            if terms[..index].contains(term) {
                let others = format!("`{term}`");
                return Err(Fault::Aliased { term: term.to_string(), others });
            }
            columns.push(term.to_string(), data.column(term)?);
        }
        Ok(columns)
    }

    /// Columns of a model: its terms, and the offsets of fixed blocks.
    pub(crate) fn of_model(data: &Data, terms: &[Term], blocking: Blocking) -> Result<Self, Fault> {
        let columns = Self::of_terms(data, terms)?;
        Ok(if blocking == Blocking::Fixed { columns.with_blocks(data.blocks()) } else { columns })
    }

    /// These columns before others.
    pub(crate) fn before(mut self, others: &Self) -> Self {
        self.names.extend_from_slice(&others.names);
        self.values.extend_from_slice(&others.values);
        self
    }

    /// Orthogonalised in their order.
    pub(crate) fn orthogonalised(&self) -> Result<Qr, Fault> {
        Qr::new(&self.values, &self.names)
    }

    /// The same and the offsets of all blocks of block columns.
    pub(crate) fn with_blocks(mut self, columns: &[Blocks]) -> Self {
        for blocks in columns {
            self.add_offsets(blocks, &(0..blocks.labels.len()).collect::<Vec<_>>());
        }
        self
    }

    /// Offsets of some blocks of a column, by numbers of their labels: for each but the last, 1 in it and -1 in the last.
    pub(crate) fn add_offsets(&mut self, blocks: &Blocks, labels: &[usize]) {
        let Some((last, others)) = labels.split_last() else { return };
        for label in others {
            let code = |of: &usize| f64::from(i8::from(of == label) - i8::from(of == last));
            let values = blocks.of_point.iter().map(code).collect();
            self.push(format!("{} {}", blocks.name, blocks.labels[*label]), values);
        }
    }

    /// How many.
    pub(crate) fn len(&self) -> usize {
        self.values.len()
    }

    fn push(&mut self, name: String, values: Vec<f64>) {
        self.names.push(name);
        self.values.push(values);
    }
}
