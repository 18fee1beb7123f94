//! Pictures of a few panels side by side, as PNG and SVG.

use std::path::Path;

mod axis;
#[cfg(feature = "plots")]
mod plot;
mod series;

pub use axis::Axis;
#[cfg(feature = "plots")]
pub(crate) use plot::use_font;
pub use series::{Mark, Series, Sign};

/// One coordinate system.
pub struct Panel {
    /// Axis to the right.
    pub x: Axis,
    /// Axis upwards.
    pub y: Axis,
    /// What is drawn; the legend is that of the first panel.
    pub series: Vec<Series>,
}

/// Writes `DIR/NAME.svg` and `DIR/NAME.png`; nothing without the feature `plots`.
///
/// # Errors
/// If a file cannot be written.
pub fn draw(directory: &Path, name: &str, title: &str, panels: &[Panel]) -> anyhow::Result<()> {
    #[cfg(feature = "plots")]
    plot::draw(directory, name, title, panels)?;
    #[cfg(not(feature = "plots"))]
    let _ = (directory, name, title, panels);
    Ok(())
}
