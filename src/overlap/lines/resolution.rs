//! From the facets in contact to the spacing of the fibers.

use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::overlap::pair::options::{LineWeights, Resolution};
use crate::sampling::Family;

/// Spacing by facet size in 2D and 3D. Measured on meshes with an exact answer: 1/16 in 2D and 1/3 in 3D keep the error
/// of nodal forces near 1 %; the error then falls almost with the number of fibers.
const FACET_PART: [f64; 2] = [1.0 / 16.0, 1.0 / 3.0];

/// The same for consistent weights, by what is right for balance weights: a crossing of a facet that is nearly along its
/// line weighs without bound. Two balls of 8 cells have errors of 8 % at balance weights' spacing, 1.2 % at an eighth.
const CONSISTENT_PART: [f64; 2] = [1.0, 1.0 / 8.0];

/// Lines of a family that the region of contact should meet at least, in 2D and 3D, since a tip may be smaller than a
/// facet. A ten-point star over coarse facets has 1 % error in its nodal forces with 600, and 8 % with 50.
const FEWEST_LINES: [f64; 2] = [512.0, 1024.0];

/// Most lines of one pair that are laid unasked: a second's work. Beyond it the lines are further apart than the facets
/// want, and a warning says so where they are further apart than the facets are wide.
const MOST_AUTOMATIC: f64 = 4e6;

/// Most fibers of one pair. Ten times what the finest study needs; it takes some ten seconds.
pub(crate) const MOST_FIBERS: f64 = 1e8;

/// Fewer fibers in an overlap than this are reported as not resolving it.
pub(crate) const FEWEST_FIBERS: usize = 8;

/// Mean size of some facets of `side`: the root of their mean measure; infinite without facets.
pub(crate) fn facet_size<const D: usize>(side: &FacetSide<D>, facets: &[u32]) -> f64 {
    let total: f64 = facets.iter().map(|&f| area_vector(&side.corners(f as usize)).norm()).sum();
    if facets.is_empty() { f64::INFINITY } else { root::<D>(total / facets.len() as f64) }
}

/// The length whose (D − 1)th power is `measure`.
fn root<const D: usize>(measure: f64) -> f64 {
    if D == 2 { measure } else { measure.sqrt() }
}

/// Largest power of √2 that does not exceed `x`, from the exponent of x² alone: the same on every machine.
fn round_down_to_power(x: f64) -> f64 {
    let squared = f64::from_bits((x * x).to_bits() & 0x7ff0_0000_0000_0000);
    if squared > 0.0 && squared.is_finite() { squared.sqrt() } else { x }
}

/// Spacing of the lines of every family.
pub(crate) fn line_spacing<const D: usize>(
    resolution: Resolution,
    families: &[Family<D>],
    region: &Aabb<D>,
    facet_size: f64,
    weights: LineWeights,
) -> Result<f64, Error> {
    let widths = || families.iter().map(|f| f.widths(region));
    // A region as long and narrow as a needle has hardly any area; its lines are counted along it.
    let spread_over = |lines: f64, widths: &mut dyn Iterator<Item = [f64; 2]>| {
        let (area, length) = widths
            .fold((0.0, 0.0), |(area, length), [u, v]| (area + if D == 2 { u } else { u * v }, length + u.max(v)));
        root::<D>(area / lines).max(length / lines)
    };
    let spacing = match resolution {
        Resolution::Spacing(spacing) => spacing,
        Resolution::Count(count) => spread_over(count as f64, &mut widths()),
        Resolution::Auto => {
            let of_one = widths().map(|of_one| spread_over(FEWEST_LINES[D - 2], &mut [of_one].into_iter()));
            let wanted = (FACET_PART[D - 2] * facet_size).min(of_one.fold(0.0, f64::max));
            let wanted = match weights {
                LineWeights::Balance => wanted,
                LineWeights::Consistent => CONSISTENT_PART[D - 2] * wanted,
            };
            // Rounding down may still double the number.
            round_down_to_power(wanted.max(spread_over(MOST_AUTOMATIC / 2.0, &mut widths())))
        }
    };
    let rows = |width: f64| width / spacing + 1.0;
    let needed: f64 = widths().map(|[u, v]| if D == 2 { rows(u) } else { rows(u) * rows(v) }).sum();
    if needed < MOST_FIBERS { Ok(spacing) } else { Err(Error::TooManyFibers { needed, limit: MOST_FIBERS }) }
}

/// Number of isotropic segments that start in `region`.
pub(crate) fn segment_count<const D: usize>(
    resolution: Resolution,
    region: &Aabb<D>,
    facet_size: f64,
) -> Result<u64, Error> {
    let needed = match resolution {
        Resolution::Count(count) => count as f64,
        Resolution::Spacing(spacing) => region.volume() / spacing.powi(D as i32),
        Resolution::Auto => (region.volume() / (FACET_PART[D - 2] * facet_size).powi(D as i32)).clamp(1e3, 1e6),
    };
    if needed < MOST_FIBERS {
        Ok(needed.max(1.0) as u64)
    } else {
        Err(Error::TooManyFibers { needed, limit: MOST_FIBERS })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;

    /// Lines laid in a region of this size with a corner at `x`.
    fn lines(resolution: Resolution, x: f64, size: [f64; 3]) -> usize {
        let families = Family::<3>::all(0);
        let min = Vector::<3>::repeat(x);
        let region = Aabb { min, max: min + Vector::from(size) };
        let spacing = line_spacing(resolution, &families, &region, 0.1, LineWeights::Balance).expect("lines");
        families.iter().map(|f| f.window(&region, 1.0 / spacing).expect("a window").0.line_count()).sum()
    }

    /// Lines asked for by number are about as many in any region, however narrow, and however small at its place.
    #[test]
    fn needles_and_specks_take_no_more_lines_than_other_regions() {
        for (resolution, most) in [(Resolution::Count(300), 900), (Resolution::Auto, 40_000)] {
            for small in [1.0, 1e-3, 1e-6, 1e-10, 1e-13] {
                let needle = lines(resolution, 0.0, [small, 1.0, small]);
                let speck = lines(resolution, 1.0, [small; 3]);
                assert!(needle <= most && speck <= most, "{small:e}, {resolution:?}: {needle} and {speck} lines");
            }
        }
    }
}
