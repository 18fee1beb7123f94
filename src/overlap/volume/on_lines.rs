//! The sampled estimator (paper, section 2.3 and appendices): V ≈ Σ ω L, ∂V/∂x_a ≈ Σ ω N_a n / |d·n|.
//!
//! Guarantees: every crossing of every fiber is counted, so the estimate is unbiased under a random shift. Lines with
//! consistent weights give the exact gradient of the estimated volume; with balance weights a crossing with normal n
//! weighs n / Σ_k ρ_k |d_k·n|, which is bounded, and the gradient is unbiased but not that of one number.

use crate::Error;
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::crossing::weights_at;
use crate::geometry::primitives::facet::area_vector;
use crate::overlap::lines::bundle::Bundle;
use crate::overlap::lines::layout::{FiberPair, Layout};
use crate::overlap::lines::resolution::FEWEST_FIBERS;
use crate::overlap::lines::sweep::sweep;
use crate::overlap::pair::assembly::{Assembly, FacetShare, PointShare};
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::Counterpart;
use crate::overlap::pair::warning::Warning;
use crate::overlap::pair::warning::swallowed;
use crate::ranks::packed;
use crate::sampling::FiberPattern;

/// What one bundle measured.
struct BundleSum<const D: usize> {
    /// Σ L and Σ L² over its fibers.
    length: f64,
    square: f64,
    fibers_met: usize,
    facet_shares: Vec<FacetShare<D>>,
    point_shares: Vec<PointShare<D>>,
}

packed!(BundleSum<D> { length, square, fibers_met, facet_shares, point_shares });

impl<const D: usize> FiberPair<'_, D> {
    /// The overlap, or `None` where the sides are apart.
    pub(crate) fn overlap(&self) -> Result<Option<Overlap<D>>, Error> {
        self.with_layout(1.0, |layout| {
            let sums = self.for_each_bundle(layout, |bundle| self.measure(bundle, layout))?;
            Ok(self.assemble(layout, sums))
        })
    }

    fn measure(&self, bundle: &Bundle<D>, layout: &Layout<D>) -> Result<BundleSum<D>, Error> {
        let mut sum =
            BundleSum { length: 0.0, square: 0.0, fibers_met: 0, facet_shares: Vec::new(), point_shares: Vec::new() };
        let (mut facet_shares, mut point_shares) = (Vec::new(), Vec::new());
        self.visit_fibers(bundle, layout, |fiber, start, events, hits| {
            let (origin, direction) = bundle.ray(fiber);
            let weighting = self.pair.weighting;
            // ∫ of the weight along the line, by its crossings.
            let mut weighted = 0.0;
            let length =
                sweep(start, events, self.pair.is_own(), bundle.length(), layout.tolerance, |event, coefficient| {
                    if !weighting.is_plain() {
                        let middle = origin + direction * (0.5 * event.t);
                        weighted += coefficient * event.t * weighting.at(&middle);
                    }
                    let side = match (&self.pair.counterpart, event.of_b) {
                        (Counterpart::Facets(b), true) => b,
                        (Counterpart::Implicit(_), true) => {
                            let hit = &hits[event.source as usize].hit;
                            let point = origin + direction * hit.t;
                            let share = coefficient.abs() * self.weight(layout, &direction, &hit.normal);
                            let share = share * weighting.at(&point);
                            point_shares.push(PointShare { point, normal: hit.normal, share });
                            return;
                        }
                        _ => &self.pair.a,
                    };
                    let facet = event.source as usize;
                    let corners = side.corners(facet);
                    let Some(normal) = area_vector(&corners).try_normalize(0.0) else { return };
                    let p = bundle.project(side, facet, fiber);
                    let (i, j) = bundle.grid_point(fiber);
                    let (weights, _) = weights_at::<D>(std::array::from_fn(|k| &p[k]), i as f64, j as f64);
                    let share = coefficient.abs() * self.weight(layout, &direction, &normal);
                    let share = share * weighting.at(&place(&corners, &weights));
                    facet_shares.push(FacetShare {
                        facet: event.source,
                        of_b: event.of_b,
                        shares: weights.map(|w| w * share),
                    });
                });
            let length = if weighting.is_plain() { length } else { weighted };
            sum.length += length;
            sum.square += length * length;
            sum.fibers_met += usize::from(length > 0.0);
        })?;
        (sum.facet_shares, sum.point_shares) = (facet_shares, point_shares);
        Ok(sum)
    }

    fn assemble(&self, layout: &Layout<D>, sums: Vec<BundleSum<D>>) -> Overlap<D> {
        let (volume, standard_error) = self.volume(layout, &sums);
        let mut assembly = Assembly::new();
        for sum in &sums {
            for share in &sum.facet_shares {
                match (&self.pair.counterpart, share.of_b) {
                    (Counterpart::Facets(b), true) => assembly.add_facet(b, share, self.pair.pose),
                    _ => assembly.add_facet(&self.pair.a, share, None),
                }
            }
            if let Some(pose) = self.pair.pose {
                sum.point_shares.iter().for_each(|share| assembly.add_point(share, pose));
            }
        }
        let fibers_met: usize = sums.iter().map(|t| t.fibers_met).sum();
        let warnings = self.warnings(layout, &assembly, fibers_met, volume);
        let mut overlap = Overlap {
            a: self.pair.partners[0],
            b: self.pair.partners[1],
            // Coordinates that span more than rounding allows can leave a line with more exits than entries.
            volume: volume.max(0.0),
            standard_error,
            nodes: Vec::new(),
            gradient: Vec::new(),
            of_b: Vec::new(),
            pose_gradient: self.pair.pose.map(|_| assembly.pose_gradient().in_weighting(self.pair.weighting)),
            contact_area: assembly.contact_area(),
            penetration: assembly.penetration(),
            fiber_count: layout.bundles.iter().map(Bundle::fiber_count).sum(),
            crossing_count: assembly.share_count(),
            facet_count: assembly.facet_count(),
            spacing: layout.spacing,
            warnings,
        };
        (overlap.nodes, overlap.gradient, overlap.of_b) = assembly.into_nodes(self.pair.surface);
        overlap
    }

    /// Volume and its standard error: from the spread of the families, each shifted at random by itself, or of the
    /// independent segments.
    fn volume(&self, layout: &Layout<D>, sums: &[BundleSum<D>]) -> (f64, f64) {
        let (mut sum, mut squares, mut count) = (0.0, 0.0, 0.0);
        for (bundle, of_bundle) in layout.bundles.iter().zip(sums) {
            if let Bundle::Segments { .. } = bundle {
                sum += of_bundle.length;
                squares += of_bundle.square;
                count += bundle.fiber_count() as f64;
            }
        }
        if count > 0.0 {
            let variance = (squares - sum * sum / count).max(0.0) * count / (count - 1.0).max(1.0);
            return (sum * layout.volume_per_length, variance.sqrt() * layout.volume_per_length);
        }
        let of_bundles = layout.bundles.iter().zip(sums);
        self.spread(layout, of_bundles.map(|(bundle, sum)| (bundle.family_index(), sum.length)))
    }

    /// Mean over the families, and the standard error of it, of the volumes that lines of these lengths measure, each of a
    /// family.
    pub(crate) fn spread(&self, layout: &Layout<D>, lengths: impl Iterator<Item = (usize, f64)>) -> (f64, f64) {
        let mut of_family = vec![0.0; self.families.len()];
        lengths.for_each(|(family, length)| of_family[family] += length * layout.volume_per_length);
        let families = of_family.len() as f64;
        let mean = of_family.iter().sum::<f64>() / families;
        let spread: f64 = of_family.iter().map(|v| (v - mean).powi(2)).sum();
        (mean, (spread / (families * (families - 1.0))).sqrt())
    }

    fn warnings(&self, layout: &Layout<D>, assembly: &Assembly<D>, fibers: usize, volume: f64) -> Vec<Warning> {
        let [a, b] = self.pair.partners;
        let mut warnings = self.of_resolution(layout, fibers, volume);
        warnings.extend(swallowed(a, b, assembly.side_areas()));
        warnings
    }

    /// Warnings of too few fibers, given how many meet the overlap.
    pub(crate) fn of_resolution(&self, layout: &Layout<D>, fibers: usize, volume: f64) -> Vec<Warning> {
        let [a, b] = self.pair.partners;
        let mut warnings = Vec::new();
        if matches!(self.options.pattern, FiberPattern::Lines) && layout.spacing > layout.facet_size && volume > 0.0 {
            let Layout { spacing, facet_size, .. } = *layout;
            warnings.push(Warning::CoarseFibers { a, b, spacing, facet_size });
        }
        // Bodies that are near but apart have many lines and no span; a region met by few lines says nothing.
        let laid: usize = layout.bundles.iter().map(Bundle::fiber_count).sum();
        if fibers < FEWEST_FIBERS && (fibers > 0 || laid < FEWEST_FIBERS) {
            warnings.push(Warning::UnresolvedOverlap { a, b, fibers });
        }
        warnings
    }
}
