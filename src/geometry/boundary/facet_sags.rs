//! The surface for which a straight facet stands, as a height above it.
//!
//! `curved_faces` (of second order) · `smoothed` (of faces around a vertex) · `agreement` (of facets that meet)

mod agreement;
mod curved_faces;
mod smoothed;

use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::facet_slopes::slopes;
use crate::geometry::{Surface, Vector};
use nalgebra::SMatrix;
use smoothed::Smoothed;
use std::ops::Range;

/// How far a surface lies outside of a straight facet, along the facet's normal and without deformation: a quadratic function of the
/// facet's barycentric coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FacetSag<const D: usize> {
    /// At the corners.
    pub(crate) at_corners: [f64; D],
    /// In the middle of the edge from a corner to the next one, above the mean of both; in 2D the first is that of the facet itself.
    pub(crate) at_edges: [f64; D],
}

impl<const D: usize> FacetSag<D> {
    /// No height.
    pub(crate) const FLAT: Self = Self { at_corners: [0.0; D], at_edges: [0.0; D] };

    /// The height at a place of the facet.
    pub(crate) fn at(&self, weights: &[f64; D]) -> f64 {
        let corners = weights.iter().zip(&self.at_corners).map(|(w, s)| w * s).sum::<f64>();
        let edges = self.at_edges.iter().enumerate().map(|(k, s)| 4.0 * s * weights[k] * weights[(k + 1) % D]);
        corners + edges.sum::<f64>()
    }

    /// Its derivatives by the barycentric coordinates of the place, as if each changed alone.
    pub(crate) fn slopes(&self, weights: &[f64; D]) -> [f64; D] {
        let mut slopes = self.at_corners;
        for (k, s) in self.at_edges.iter().enumerate().take(edge_count(D)) {
            let next = (k + 1) % D;
            slopes[k] += 4.0 * s * weights[next];
            slopes[next] += 4.0 * s * weights[k];
        }
        slopes
    }

    pub(crate) fn is_flat(&self) -> bool {
        *self == Self::FLAT
    }

    /// The larger principal curvature over a facet with these corners: positive outwards.
    pub(crate) fn curvature(&self, corners: &[Vector<D>; D]) -> f64 {
        let normal = area_vector(corners).try_normalize(0.0);
        let Some((_, along)) = normal.and_then(|normal| slopes(corners, &normal)) else { return 0.0 };
        let mut second = SMatrix::<f64, D, D>::zeros();
        for (k, s) in self.at_edges.iter().enumerate().take(edge_count(D)) {
            let (p, q) = (along[k], along[(k + 1) % D]);
            second -= (p * q.transpose() + q * p.transpose()) * (4.0 * s);
        }
        // Of the two principal curvatures the sum and, from the squares of both, the difference.
        let sum = second.trace();
        let difference = (2.0 * second.norm_squared() - sum * sum).max(0.0).sqrt();
        0.5 * (sum + difference.copysign(sum))
    }

    /// No smaller than the height is anywhere, apart from its sign.
    pub(crate) fn largest(&self) -> f64 {
        let largest = |all: &[f64; D]| all.iter().fold(0.0f64, |most, s| most.max(s.abs()));
        largest(&self.at_corners) + largest(&self.at_edges)
    }
}

/// To which side a face bends: that of a pin outwards, that of its hole inwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bend {
    None,
    Outwards,
    Inwards,
}

/// Faces conform where the curvature of one is at least this part of that of the other: that of a flat face is rounding.
const CONFORMS: f64 = 0.1;

impl Bend {
    /// Of a face of this curvature, beside others of one as large.
    pub(crate) fn new(curvature: f64, largest: f64) -> Self {
        match curvature.abs() >= CONFORMS * largest && curvature != 0.0 {
            false => Self::None,
            true if curvature > 0.0 => Self::Outwards,
            true => Self::Inwards,
        }
    }

    pub(crate) const ALL: [Self; 3] = [Self::None, Self::Outwards, Self::Inwards];

    /// Whether faces that bend so may conform.
    pub(crate) fn fits(self, other: Self) -> bool {
        matches!((self, other), (Self::Outwards, Self::Inwards) | (Self::Inwards, Self::Outwards))
    }
}

/// How high the curved faces of a body are above straight ones, how far they bend, and how far faces of second order rise by the lengths of
/// their edges, at most.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct MostCurved {
    pub(crate) height: f64,
    pub(crate) curvature: f64,
    pub(crate) rise: f64,
}

impl MostCurved {
    pub(crate) fn max(self, other: Self) -> Self {
        Self {
            height: self.height.max(other.height),
            curvature: self.curvature.max(other.curvature),
            rise: self.rise.max(other.rise),
        }
    }
}

/// An edge that rises by less than this part of its length is straight: it turns by no more than some 1e-5, and coordinates in a file of single
/// precision are no better.
const STRAIGHT: f64 = 1e-6;

/// Heights of all facets, and the largest of every body.
pub(crate) struct FacetSags<const D: usize> {
    pub(crate) sags: Vec<FacetSag<D>>,
    pub(crate) of_bodies: Vec<MostCurved>,
}

/// How many edges a facet of D corners has.
pub(crate) const fn edge_count(dimension: usize) -> usize {
    if dimension == 2 { 1 } else { 3 }
}

impl<const D: usize> Surface<D> {
    /// Of every facet of a face of second order the height of that face, and with a feature angle, in radians, of all others the height of
    /// the surface whose normals are those of the facets around each vertex, as of bodies whose faces of second order are all straight;
    /// `None` where all faces are flat. Where the surface is smooth, facets that meet agree on it.
    pub(crate) fn facet_sags(
        &self,
        is_surface: impl Fn(usize) -> bool,
        feature_angle: Option<f64>,
    ) -> Option<FacetSags<D>> {
        let (mut sags, normals) = self.own_sags(&is_surface, feature_angle);
        let of_bodies = match &self.submesh {
            Some(submesh) => submesh.most_curved.clone(),
            None => self.most_curved_of(&sags),
        };
        if of_bodies.iter().all(|body| body.height == 0.0) {
            return None;
        }
        self.agree(&mut sags, &normals, is_surface);
        Some(FacetSags { sags, of_bodies })
    }

    /// How curved the faces of every body are at most, each by itself.
    pub(crate) fn most_curved(&self) -> Vec<MostCurved> {
        let is_surface = |facet: usize| self.is_surface_facet(facet);
        let rises = self.rises(is_surface);
        let bodies = self.most_curved_of(&self.own_sags(is_surface, None).0);
        bodies.into_iter().zip(rises).map(|(body, rise)| MostCurved { rise, ..body }).collect()
    }

    /// Whether faces of second order say themselves how a body bends, by body: the edges of some rise above their chords.
    pub(super) fn are_curved(&self, is_surface: impl Fn(usize) -> bool) -> Vec<bool> {
        let rises = match &self.submesh {
            Some(submesh) => submesh.most_curved.iter().map(|body| body.rise).collect(),
            None => self.rises(is_surface),
        };
        rises.into_iter().map(|rise| rise > STRAIGHT).collect()
    }

    fn most_curved_of(&self, sags: &[FacetSag<D>]) -> Vec<MostCurved> {
        let points = self.points(self.reference());
        let of_facet = |facet: usize| {
            let corners = self.facets[facet].map(|vertex| points[vertex as usize]);
            MostCurved { height: sags[facet].largest(), curvature: sags[facet].curvature(&corners).abs(), rise: 0.0 }
        };
        let of_body = |range: &Range<usize>| range.clone().map(of_facet).fold(MostCurved::default(), MostCurved::max);
        self.ranges.iter().map(of_body).collect()
    }

    /// The heights as every facet has them, and the normals of the facets.
    fn own_sags(
        &self,
        is_surface: impl Fn(usize) -> bool,
        feature_angle: Option<f64>,
    ) -> (Vec<FacetSag<D>>, Vec<Vector<D>>) {
        let points = self.points(self.reference());
        let mut sags = vec![FacetSag::FLAT; self.facets.len()];
        if self.curved().is_empty() && feature_angle.is_none() {
            // A part of a mesh may have none of the curved cells of the whole.
            return (sags, vec![Vector::zeros(); self.facets.len()]);
        }
        let normal = |facet: &[u32; D]| {
            let area = area_vector(&facet.map(|vertex| points[vertex as usize]));
            area.try_normalize(0.0).unwrap_or_else(Vector::zeros)
        };
        let normals: Vec<Vector<D>> = self.facets.iter().map(normal).collect();
        self.add_second_order(&points, &normals, &is_surface, &mut sags);
        if let Some(angle) = feature_angle {
            Smoothed::new(self, (&points, &normals), &is_surface, angle).add_to(&mut sags);
        }
        (sags, normals)
    }
}
