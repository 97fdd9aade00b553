//! The wake: nodes a step apart first, linear between, then rows that grow longer and longer, the last one without end.

/// Nodes at 1, 2, ... steps behind the trailing edge, then rows between edges in steps.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rows {
    edges: Vec<usize>,
}

/// What a column of the wake's memory is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The strength at so many steps behind the edge.
    Node(usize),
    /// The mean between two.
    Mean(usize, usize),
    /// The strength at the beginning of the endless row.
    Endless(usize),
}

/// Number of nodes behind the trailing edge; the one at the edge is the present.
pub(crate) const NODES: usize = 6;
/// Pieces of a step between two nodes: the edge is near, so the first ones are short.
const PIECES: u32 = 10;

impl Rows {
    /// Rows that grow by a quarter each until so many steps.
    pub fn until(steps: usize) -> Self {
        let (mut edges, mut length) = (vec![NODES], 1);
        while edges[edges.len() - 1] < steps {
            length += 1 + length / 4;
            edges.push(edges[edges.len() - 1] + length);
        }
        Self { edges }
    }

    /// What is remembered, in the order of the columns.
    pub fn parts(&self) -> Vec<Part> {
        let nodes = (1..=NODES).map(Part::Node);
        let means = self.edges.windows(2).map(|pair| Part::Mean(pair[0], pair[1]));
        nodes.chain(means).chain([Part::Endless(self.depth())]).collect()
    }

    /// Steps that must be remembered.
    pub fn depth(&self) -> usize {
        self.edges[self.edges.len() - 1]
    }

    /// Pieces near the trailing edge, in steps: from, to, and the shares of the strength at the node before and after.
    pub(crate) fn pieces() -> Vec<(usize, f64, f64, f64)> {
        let piece = |node: usize, i: u32| {
            // crowded at the trailing edge
            let place = |i: u32| {
                let even = f64::from(i) / f64::from(PIECES);
                if node == 0 { even * even } else { even }
            };
            let (from, to) = (place(i), place(i + 1));
            (node, node as f64 + from, node as f64 + to, 0.5 * (from + to))
        };
        (0..NODES).flat_map(|node| (0..PIECES).map(move |i| piece(node, i))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_follow_each_other_without_a_gap() {
        let mut end = NODES;
        for part in Rows::until(300).parts() {
            match part {
                Part::Node(_) => {}
                Part::Mean(from, to) => {
                    assert_eq!(from, end);
                    end = to;
                }
                Part::Endless(from) => assert!(from == end && from >= 300),
            }
        }
    }
}
