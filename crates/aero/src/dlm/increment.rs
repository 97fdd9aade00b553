//! What oscillation adds to the influence matrix: one strip's doublets on all strips after the other.
//!
//! Columns belong to sending boxes; strips of columns are worked on in parallel, each by one thread and in the same
//! order always, so that the numbers do not depend on the threads.

use crate::dlm::numerators::{Coefficients, Pairs, Stream};
use crate::dlm::span_fit::{Cores, LOGARITHM_CORE, MOST_POINTS, PLANAR, SpanFit, Weights, weights};
use crate::dlm::strips::Strip;
use faer::{Mat, c64};
use pulp::Arch;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Sending and receiving strips, and how the line is integrated.
#[derive(Debug, Clone)]
pub(super) struct Increment {
    pub(super) receivers: Vec<Strip>,
    pub(super) senders: Vec<Strip>,
    pub(super) fit: SpanFit,
}

/// Distances and weights of one strip seen from another, at each point of the fit: r in m, weights in 1/m.
#[derive(Debug, Clone, Copy, Default)]
struct Across {
    r: [f64; MOST_POINTS],
    weights: [[f64; 2]; MOST_POINTS],
}

impl Increment {
    /// Adds the incidence per unit `cp` that oscillation adds; rows are receiving boxes, columns sending ones.
    pub(super) fn add_to(&self, matrix: &mut Mat<c64>, stream: &Stream) {
        let mut columns = matrix.col_iter_mut();
        let mut blocks = Vec::with_capacity(self.senders.len());
        for strip in &self.senders {
            blocks.push((strip, columns.by_ref().take(strip.lines.len()).collect::<Vec<_>>()));
        }
        let arch = Arch::new();
        blocks.into_par_iter().for_each(|(sender, block)| {
            // Columns of a matrix of our own making are contiguous.
            let block =
                block.into_iter().filter_map(|column| Some(column.try_as_col_major_mut()?.as_slice_mut()));
            self.columns(arch, stream, sender, &mut block.collect::<Vec<_>>());
        });
    }

    /// Columns of the boxes of one strip.
    fn columns(&self, arch: Arch, stream: &Stream, sender: &Strip, out: &mut [&mut [c64]]) {
        let (mut pairs, mut at) = (Pairs::default(), Coefficients::default());
        let turn = |x: f64| c64::new((stream.kappa * x).cos(), -(stream.kappa * x).sin());
        let points = self.fit.points();
        // exp(-i kappa x) of a distance is the product of two: one of the receiver, one of the point of the line.
        let sent: Vec<c64> = points
            .iter()
            .flat_map(|point| sender.lines.iter().map(move |line| turn(line.x + point * line.sweep).conj()))
            .collect();
        let mut received = Vec::new();
        for receiver in &self.receivers {
            let across = across(self.fit, receiver, sender);
            let count = receiver.lines.len();
            received.clear();
            received.extend(receiver.lines.iter().map(|line| turn(line.receiver_x)));
            pairs.reset(count * sender.lines.len());
            for (p, point) in points.iter().enumerate() {
                for (j, line) in sender.lines.iter().enumerate() {
                    let (x, sent) = (line.x + point * line.sweep, sent[p * sender.lines.len() + j]);
                    for (i, receiver) in receiver.lines.iter().enumerate() {
                        pairs.x[j * count + i] = receiver.receiver_x - x;
                        let shift = received[i] * sent;
                        pairs.shift[0][j * count + i] = shift.re;
                        pairs.shift[1][j * count + i] = shift.im;
                    }
                }
                at.set(stream, across.r[p], across.weights[p]);
                pairs.add(arch, stream, &at);
            }
            for (j, (line, column)) in sender.lines.iter().zip(out.iter_mut()).enumerate() {
                let factor = -line.chord / (8.0 * PI);
                for (i, value) in column[receiver.boxes.clone()].iter_mut().enumerate() {
                    let sum = c64::new(pairs.sum[0][j * count + i], pairs.sum[1][j * count + i]);
                    *value += sum * factor;
                }
            }
        }
    }
}

/// One strip seen from another: what does not depend on x.
fn across(fit: SpanFit, receiver: &Strip, sender: &Strip) -> Across {
    let offset = receiver.receiver - sender.middle;
    let e = sender.half_width_m;
    let (y, z) = (offset.dot(&sender.along), offset.dot(&sender.normal()));
    let cores = Cores {
        pole: receiver.core_m().min(sender.core_m()) / e,
        logarithm: LOGARITHM_CORE * receiver.half_width_m.min(e) / e,
    };
    let Weights([first, second]) = weights(fit, y / e, z / e, cores);
    // Component of the incidence: along the receiver's normal, in the sender's axes.
    let (parallel, beside) = (receiver.normal().dot(&sender.normal()), receiver.normal().dot(&sender.along));
    let mut across = Across::default();
    for (i, point) in fit.points().iter().enumerate() {
        let eta = point * e;
        // On the line's own extension r is 0, where the numerators have limits but their formulas have not.
        across.r[i] = (y - eta).hypot(z).max(1e-9 * e);
        let tilt = if z.abs() <= PLANAR * e { 0.0 } else { z * (z * parallel + (y - eta) * beside) };
        across.weights[i] = [first[i] * parallel / e, second[i] * tilt / (e * e * e)];
    }
    across
}
