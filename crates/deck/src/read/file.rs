//! A file, from its text to its mesh with rigid faces.

use super::deck::Deck;
use super::rigid_faces;
use crate::Fault;
use fmc_mesh_io::Mesh;
use fmc_mesh_io::inp::Expanded;
use std::path::Path;

impl Deck {
    /// Reads a file, with those that it includes.
    ///
    /// # Errors
    /// A sentence that begins with the file, and the line if it is about one.
    pub fn read(path: &Path) -> Result<Self, String> {
        let named = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let bytes = std::fs::read(path).map_err(|error| named(&error))?;
        let input =
            Expanded::new(&String::from_utf8_lossy(&bytes), Some(path)).map_err(|e| named(&format!("{e:#}")))?;
        let located = |input: &Expanded, fault: Fault| format!("{}: {}", input.source(fault.line), fault.message);
        let mesh = Mesh::of_input(&input).map_err(|error| located(&input, error.into()))?;
        let text = input.text.clone();
        let mut deck = Self::empty(mesh, input);
        match deck.take(&text).and_then(|rigid| rigid_faces::add(&mut deck, &rigid)) {
            Ok(()) => Ok(deck),
            Err(fault) => Err(deck.located(&fault)),
        }
    }
}
