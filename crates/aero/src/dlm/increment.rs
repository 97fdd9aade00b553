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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dlm::exponentials::KernelIntegral;
    use crate::dlm::kernel::{Separation, numerators};
    use crate::{AeroBox, Lattice};

    const MACH: f64 = 0.5;
    const KAPPA: f64 = 1.2;

    /// Two boxes behind each other, swept and tapered, rolled about their inner edge.
    fn pair(place: [f64; 3], width: f64, sweep: f64, roll: f64) -> Vec<AeroBox> {
        let tip = [place[0] + sweep, place[1] + width * roll.cos(), place[2] + width * roll.sin()];
        Lattice::trapezoid(1, place, 0.5, tip, 0.4, [2, 1]).expect("boxes").boxes
    }

    /// Of all pairs, by the program.
    fn matrix(fit: SpanFit, receivers: &[AeroBox], senders: &[AeroBox]) -> Mat<c64> {
        let strips = |boxes| Strip::all(boxes).expect("boxes");
        let increment = Increment { receivers: strips(receivers), senders: strips(senders), fit };
        let mut all = Mat::zeros(receivers.len(), senders.len());
        increment.add_to(&mut all, &Stream::new(MACH, KAPPA, KernelIntegral::Fine));
        all
    }

    /// The integral of N1 T1/r^2 + N2 T2/r^4 along a doublet line (AFFDL-TR-71-5, eqs. 4 to 8) by Simpson's
    /// rule; T1 = n.m and T2 = (r.n) (r.m) of both normals, all across the stream.
    fn by_quadrature(receiver: &AeroBox, sender: &AeroBox) -> c64 {
        let [from, to] = sender.bound_vortex();
        let (point, n, m) = (receiver.three_quarter_point(), sender.normal().yz(), receiver.normal().yz());
        let parts = 400_u32;
        let one = |i: u32| {
            let weight = if i == 0 || i == parts { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
            let r = point - (from + (to - from) * (f64::from(i) / f64::from(parts)));
            let (x_m, r) = (r.x, r.yz());
            let at = Separation { x_m, r_m: r.norm() };
            let [first, second] = numerators(at, MACH, KAPPA, KernelIntegral::Fine);
            let (parallel, tilt) = (n.dot(&m), r.dot(&n) * r.dot(&m));
            (first * (parallel / r.norm_squared()) + second * (tilt / r.norm_squared().powi(2))) * weight
        };
        let step = (to - from).yz().norm() / f64::from(parts);
        (0..=parts).map(one).sum::<c64>() * (-sender.chord_m() / (8.0 * PI) * step / 3.0)
    }

    #[test]
    fn incidences_of_rolled_and_swept_strips_are_integrals_along_their_lines() {
        let sender = pair([0.0, 0.0, 0.0], 0.4, 0.25, 0.3);
        for (fit, tolerance) in [(SpanFit::Quartic, 3e-4), (SpanFit::Parabolic, 5e-3)] {
            for (place, roll) in [
                ([0.3, 1.0, 0.2], -0.7),
                ([-0.4, 0.9, -0.6], 1.1),
                ([0.5, -0.9, 0.5], 2.4),
                ([1.3, 0.3, 0.9], 0.0),
                ([0.8, -0.2, -0.7], 1.5),
            ] {
                let receiver = pair(place, 0.3, -0.2, roll);
                let got = matrix(fit, &receiver, &sender);
                let want = Mat::from_fn(2, 2, |i, j| by_quadrature(&receiver[i], &sender[j]));
                let off = (&got - &want).norm_max() / want.norm_max();
                assert!(off < tolerance, "{fit:?} at {place:?}: {got:?} instead of {want:?}");
            }
        }
    }

    /// Powers of two in lengths are exact: distances grow with them and weights fall, to the last bit, also
    /// next to the plane.
    #[test]
    fn what_strips_share_has_the_dimension_of_its_size() {
        let strips = |place: [f64; 3], roll: f64, size: f64| {
            let scaled = |boxes: Vec<AeroBox>| {
                let lattice = Lattice { boxes, ..Lattice::default() }.scaled(size);
                Strip::all(&lattice.boxes).expect("boxes").remove(0)
            };
            (scaled(pair(place, 0.3, -0.2, roll)), scaled(pair([0.0, 0.0, 0.0], 0.5, 0.25, 0.0)))
        };
        for (place, roll) in [
            ([0.3, 0.8, 0.002], 0.0),
            ([0.3, 0.8, -0.01], 0.4),
            ([0.3, 0.8, 1e-4], 0.0),
            ([0.3, 0.1, 0.3], 0.7),
            ([0.3, -0.15, 0.0], 0.0),
            ([0.3, 0.351, 0.0], 0.0),
            ([0.3, 0.3505, 0.0], 0.0),
        ] {
            let (receiver, sender) = strips(place, roll, 1.0);
            let plain = across(SpanFit::Quartic, &receiver, &sender);
            for size in [0.015_625, 64.0] {
                let (receiver, sender) = strips(place, roll, size);
                let other = across(SpanFit::Quartic, &receiver, &sender);
                for i in 0..MOST_POINTS {
                    let r = other.r[i] / size;
                    assert!((r / plain.r[i] - 1.0).abs() < 1e-14, "{place:?}, size {size}: {r}");
                    for (a, b) in other.weights[i].iter().zip(plain.weights[i]) {
                        assert!((a * size - b).abs() <= 1e-12 * b.abs(), "{place:?}, size {size}: {a} {b}");
                    }
                }
            }
        }
    }

    /// By hand: a strip 1 m wide of 2 m chord beside one of 0.4 m by 0.1 m, the sender first the one and then
    /// the other.
    #[test]
    fn cores_are_those_of_the_smaller_strip_and_distances_are_across_the_stream() {
        let strip = |y: f64, width: f64, chord: f64| {
            let lattice = Lattice::trapezoid(1, [0.0, y, 0.0], chord, [0.0, y + width, 0.0], chord, [1, 1]);
            Strip::all(&lattice.expect("a box").boxes).expect("a box").remove(0)
        };
        let fit = SpanFit::Quartic;
        // The small strip's middle is 0.0004 m beyond the large one's end, within both cores; then the other
        // way round.
        let (large, small) = (strip(0.0, 1.0, 2.0), strip(0.8004, 0.4, 0.1));
        let (other_large, other_small) = (strip(0.0, 1.0, 2.0), strip(0.5004, 0.4, 0.1));
        for (receiver, sender, e, y) in
            [(small, large, 0.5, 0.5004), (other_large, other_small, 0.2, 0.5 - 0.7004)]
        {
            let cores = Cores { pole: 0.001 / e, logarithm: 0.02 / e };
            let Weights([want, _]) = weights(fit, y / e, 0.0, cores);
            let got = across(fit, &receiver, &sender);
            for (i, point) in fit.points().iter().enumerate() {
                let r = (y - point * e).abs();
                assert!((got.r[i] - r).abs() < 1e-14, "{} {r}", got.r[i]);
                assert!(
                    (got.weights[i][0] * e / want[i] - 1.0).abs() < 1e-9,
                    "{} {}",
                    got.weights[i][0],
                    want[i]
                );
                assert!(got.weights[i][1] == 0.0);
            }
        }
        // In line with a point of the line r is next to nothing.
        let (a, b) = (strip(0.0, 1.0, 1.0), strip(0.25, 0.5, 1.0));
        assert!((across(fit, &b, &a).r[2] / 0.5e-9 - 1.0).abs() < 1e-12);
    }
}
