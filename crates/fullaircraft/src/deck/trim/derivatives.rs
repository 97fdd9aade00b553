//! Derivatives of a user's deck: rigid, splined, restrained and unrestrained, as Nastran prints them.

use super::{Elastic, TrimDeck};
use crate::deck::variables::ANTISYMMETRIC;
use faer::Mat;
use nastran::Trim;
use std::collections::BTreeMap;

impl TrimDeck {
    /// Force and moment coefficients (`CX`, `CY`, `CZ`, `Cl`, `Cm`, `Cn` in the reference axes, about their origin) per unit of each variable; of
    /// an antisymmetric half those that its other half cancels are zero. Of the elastic aircraft the air on free motions is counted: what reaches
    /// a motion that SPC or AUTOSPC holds is the ground's.
    pub fn derivatives(&self, q: f64, elastic: Elastic) -> BTreeMap<String, [f64; 6]> {
        self.coefficients((q, 1.0), elastic, self.counted(elastic))
    }

    /// As [`TrimDeck::derivatives`], for a TRIM card, whose AEQR says what deformations count.
    pub fn derivatives_of_card(&self, card: &Trim, elastic: Elastic) -> BTreeMap<String, [f64; 6]> {
        self.coefficients((card.q, card.elastic_share), elastic, self.counted(elastic))
    }

    /// Those of the rigid aircraft by the air on free motions alone, as the elastic aircraft has it ("splined" in Nastran's prints).
    pub fn splined_derivatives(&self) -> BTreeMap<String, [f64; 6]> {
        self.coefficients((0.0, 1.0), Elastic::Rigid, &self.carried_axes)
    }

    /// What sums the air up.
    fn counted(&self, elastic: Elastic) -> &Mat<f64> {
        if elastic == Elastic::Rigid { &self.axes } else { &self.carried_axes }
    }

    fn coefficients(
        &self,
        (q, share): (f64, f64),
        elastic: Elastic,
        axes: &Mat<f64>,
    ) -> BTreeMap<String, [f64; 6]> {
        let sag = Some(&self.sag).filter(|_| elastic == Elastic::Restrained);
        let cp = self.pressures(q, elastic, sag, share);
        let sums = axes.transpose() * self.loads(&cp);
        let (b, c) = (self.aeros.span_length, self.aeros.chord);
        let lengths = [1.0, 1.0, 1.0, b, c, b].map(|length| length * self.aeros.area);
        let cancels = |i: usize| self.aeros.symmetry == ANTISYMMETRIC && i.is_multiple_of(2);
        let of = |j: usize| std::array::from_fn(|i| if cancels(i) { 0.0 } else { sums[(i, j)] / lengths[i] });
        self.variables.iter().enumerate().map(|(j, name)| (name.clone(), of(j))).collect()
    }

    /// Neutral point by derivatives: x in the axes of the stream (ACSID) about which the moment does not follow the angle of attack; nothing without ANGLEA.
    pub fn neutral_point_x(&self, derivatives: &BTreeMap<String, [f64; 6]>) -> Option<f64> {
        let alpha = derivatives.get("ANGLEA")?;
        Some(self.origin.x + self.aeros.chord * alpha[4] / alpha[2])
    }
}
