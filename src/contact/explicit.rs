//! The time step that the contact allows an explicit integration: `mass_scaled` (the tangent by the masses) · `lanczos` (its largest
//! eigenvalue; for hosts too)

mod lanczos;
mod mass_scaled;

pub use lanczos::{Accuracy, largest_eigenvalue};
pub(super) use mass_scaled::largest_step;
