//! What is asked.

use super::conductance::Conductance;
use crate::Error;

/// Fields for whose flux a host asks.
#[derive(Clone, Copy, Debug)]
pub struct FluxRequest<'a> {
    /// Values of one or several fields, field after field, a value for every row of the coordinates.
    pub fields: &'a [f64],
    /// The same for every obstacle, removed ones included; `None`: nothing flows into obstacles.
    pub of_obstacles: Option<&'a [f64]>,
    /// How well contacts conduct.
    pub conductance: &'a Conductance,
}

impl FluxRequest<'_> {
    /// The number of fields.
    ///
    /// # Errors
    /// [`Error::Length`] where arrays are not of one number of fields; [`Error::BadEntry`].
    pub(crate) fn check(&self, nodes: usize, obstacles: usize) -> Result<usize, Error> {
        self.conductance.check()?;
        let fields = self.fields.len() / nodes.max(1);
        let array = |array: &'static str, values: &[f64], expected: usize| {
            if values.len() != expected {
                return Err(Error::Length { array, expected, found: values.len() });
            }
            match values.iter().position(|value| !value.is_finite()) {
                Some(entry) => Err(Error::BadEntry { array, entry, value: values[entry] }),
                None => Ok(()),
            }
        };
        array("fields", self.fields, fields * nodes)?;
        array("of_obstacles", self.of_obstacles.unwrap_or(&[]), self.of_obstacles.map_or(0, |_| fields * obstacles))?;
        Ok(fields)
    }
}
