//! Between which facets of two bodies something holds them together.

use std::sync::Arc;

/// Two bodies, and what of their surfaces is looked at.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Between {
    pub(crate) bodies: [usize; 2],
    /// Facets of either body, by number in the surface, ascending; `None` for all.
    pub(crate) facets: Option<[Arc<[usize]>; 2]>,
    /// How far apart facets may be, or how far they may overlap; 0: a tenth of the mean facet of the body with the larger facets.
    pub(crate) reach: f64,
    /// What brings the named facets of the second body to those of the first; in 2D the last is 0.
    pub(crate) period: [f64; 3],
}

/// Facets of both bodies that are held together, by number in the surface, each ascending.
pub(crate) type HeldFacets = [Vec<usize>; 2];

/// Sorts what was found of them, in which the side of the pieces comes first.
pub(super) fn held_facets(found: impl IntoIterator<Item = [usize; 2]>, is_second: bool) -> HeldFacets {
    let (mut here, mut there): (Vec<_>, Vec<_>) = found.into_iter().map(|[here, there]| (here, there)).unzip();
    for list in [&mut here, &mut there] {
        list.sort_unstable();
        list.dedup();
    }
    if is_second { [there, here] } else { [here, there] }
}
