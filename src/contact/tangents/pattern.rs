//! Where a matrix of blocks has entries.

/// Places (row, column) of blocks, each once, sorted by row and column.
///
/// A host that allocates its matrix once adds the places of every tangent it meets ([`Tangent::places`]). The pattern
/// only grows, so as long as [`Self::len`] stays the same, so does the pattern, and with it a symbolic factorisation.
///
/// [`Tangent::places`]: super::Tangent::places
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pattern {
    places: Vec<(u32, u32)>,
}

impl Pattern {
    /// Adds places, in any order; those that are there already stay once.
    pub fn add(&mut self, places: impl IntoIterator<Item = (u32, u32)>) {
        self.places.extend(places);
        // Two runs that are sorted already: this sort finds them and merges.
        self.places.sort();
        self.places.dedup();
    }

    /// The places, sorted by row and column.
    pub fn places(&self) -> &[(u32, u32)] {
        &self.places
    }

    /// Number of places.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }
}
