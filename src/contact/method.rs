//! How contact is measured and how it presses: `options` · `chosen` (the law and the estimator that they name)

mod chosen;
mod options;

pub(super) use chosen::Method;
pub use options::Options;
