//! What is worn off a facet at a point, for a restart.

use crate::Error;

/// What is worn off a boundary facet at one of the points that move it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WornFacet {
    /// The facet, by its place in [`Contact::boundary_facets`](crate::Contact::boundary_facets).
    pub facet: usize,
    /// The node; with cells of second order the point ([`PointWeights`](crate::PointWeights)).
    pub point: u32,
    /// How far the surface lies farther in there, against the normal of the facet; at least 0, a length.
    pub depth: f64,
    /// What was worn off, at least 0: a volume, in 2D by unit of thickness, with axisymmetry that of rings.
    pub volume: f64,
}

/// Checks a list against the points of facets.
///
/// # Errors
/// [`Error::NoSuchRow`], [`Error::BadEntry`], both naming the row.
pub(super) fn check<I: IntoIterator<Item = u32>>(
    list: &[WornFacet],
    points_of: impl Fn(usize) -> Option<I>,
) -> Result<(), Error> {
    let mut known = std::collections::BTreeSet::new();
    for (row, one) in list.iter().enumerate() {
        let refuse = |what| Err(Error::NoSuchRow { list: "worn facets", row, what });
        let Some(points) = points_of(one.facet) else { return refuse("a facet that does not exist") };
        if !points.into_iter().any(|point| point == one.point) {
            return refuse("a point that does not move the facet");
        }
        if let Some(&value) = [one.depth, one.volume].iter().find(|x| !(x.is_finite() && **x >= 0.0)) {
            return Err(Error::BadEntry { array: "depths and volumes of worn facets", entry: row, value });
        }
        if !known.insert((one.facet, one.point)) {
            return refuse("a facet and a point that an earlier row names");
        }
    }
    Ok(())
}
