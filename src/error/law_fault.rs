//! What is wrong with a law of the host.

/// A law of the host that failed, or answered with a number that is not finite.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LawFault {
    /// Both bodies of the interface, by index.
    pub bodies: [usize; 2],
    /// Point, counted within the pair, where it is one.
    pub point: Option<usize>,
    /// What the law said, or what it answered.
    pub cause: String,
}

/// A law of friction of the host that failed, or answered with what is no limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrictionFault {
    /// Both sides of the pair, each `"body"` or `"obstacle"` with its index.
    pub sides: [(&'static str, usize); 2],
    /// Boundary facet, where it is one.
    pub facet: Option<usize>,
    /// What the law said, or what it answered.
    pub cause: String,
}
