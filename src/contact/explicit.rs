//! The time step that the contact allows an explicit integration: `mass_scaled` (the tangent by the masses) · `lanczos` (a bound of
//! its largest eigenvalue)

mod lanczos;
mod mass_scaled;

pub(super) use mass_scaled::largest_step;
