//! How an element turns with a structure that bends far: the frame in which its displacements stay small.

/// What an element turns with when its nodes turn far; its matrices stay those of the undeformed place.
#[derive(Debug, Clone, PartialEq)]
pub enum Corotation {
    /// With the rotation that fits the places of its nodes best; where these are in one line, their rotations
    /// have a say about it. For every element that a rigid motion leaves without force.
    Fit,
    /// With one of its nodes, by its place in [`crate::Element::nodes`].
    Node(usize),
    /// It stands on the ground and does not turn; rotations of its nodes stay below half a turn.
    Ground,
    /// It acts along motions in fixed axes. Over displacements that is exact; if it joins rotations, they must stay
    /// small, and the element is named where they do not.
    Axes,
    /// Nothing tells how it turns; why.
    Refused(String),
}
