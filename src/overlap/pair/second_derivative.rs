//! How much of a second derivative is wanted.

/// Which second derivatives are asked for beside the gradient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SecondDerivative {
    /// None.
    No,
    /// A positive semidefinite part.
    Semidefinite,
    /// All of it.
    Full,
}
