//! How contact is measured and pressed: `options`

mod options;

pub use options::Options;
