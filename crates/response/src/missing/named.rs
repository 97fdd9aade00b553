//! What was named, with its coefficients, its evidence and what it is not told from.

/// A coefficient or an offset.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The term, or the label of the block.
    pub name: String,
    /// Unit of the response over that of the term.
    pub value: f64,
    /// Its standard error; none for offsets of blocks.
    pub sigma: Option<f64>,
}

/// A missing term, or missing offsets of blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct Named {
    /// The term, or the column of blocks.
    pub name: String,
    /// True for offsets of blocks.
    pub is_block: bool,
    /// Candidates that explain the data about as well (a log Bayes factor within 5 of its own), best first.
    pub confused_with: Vec<String>,
    /// Their correlation with it once the model's terms are out; 1 if the points cannot tell them apart at all.
    pub correlation: Vec<f64>,
    /// Log Bayes factor against the model without it, all else that was named in it.
    pub log_bayes_factor: f64,
    /// What it needed.
    pub threshold: f64,
    /// Its weight among all candidates: 1 if no other explains the data, 1/2 if one does as well.
    pub confidence: f64,
    /// Its share of the lack of fit of the model as given.
    pub share: f64,
    /// Coefficients from the training points, with everything else that was named.
    pub parameters: Vec<Parameter>,
}
