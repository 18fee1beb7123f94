//! Cases carried out.
