//! The smooth surface for which straight facets stand, from the normals of the facets around each vertex.
//!
//! An edge of length h between normals that differ by the angle h/R stands for an arc that rises h²/8R above it: a quarter of h times the
//! slope of the normal at an end. Of the two ends the smaller counts, so that a flat face beside a round one stays flat; where the
//! surface ends, at an edge of the body, the other one does.

use super::FacetSag;
use crate::geometry::boundary::facets_around::FacetsAround;
use crate::geometry::boundary::symmetry::AcrossPlanes;
use crate::geometry::{Surface, Vector};
use rustc_hash::FxHashMap;
use smallvec::SmallVec;

/// What is around the vertices of a surface.
pub(super) struct Smoothed<'a, const D: usize> {
    surface: &'a Surface<D>,
    points: &'a [Vector<D>],
    normals: &'a [Vector<D>],
    is_surface: Vec<bool>,
    /// Whether the faces of a body are curved themselves.
    is_curved: Vec<bool>,
    around: FacetsAround,
    /// Of every facet, the face of which it is a part.
    faces: Vec<[u32; 2]>,
    /// Cosine of the feature angle.
    smooth: f64,
}

/// A height that is smaller than this part of its edge is rounding.
const ROUNDING: f64 = 1e-9;

impl<'a, const D: usize> Smoothed<'a, D> {
    pub(super) fn new(
        surface: &'a Surface<D>,
        (points, normals): (&'a [Vector<D>], &'a [Vector<D>]),
        is_surface: &impl Fn(usize) -> bool,
        feature_angle: f64,
    ) -> Self {
        Self {
            surface,
            points,
            normals,
            is_surface: (0..surface.facets.len()).map(is_surface).collect(),
            is_curved: surface.are_curved(is_surface),
            around: FacetsAround::new(surface),
            faces: (0..surface.facets.len()).map(|facet| surface.on_face(facet, true).face).collect(),
            smooth: feature_angle.cos(),
        }
    }

    /// Has the facets of straight cells rise, and those of straight faces of second order.
    pub(super) fn add_to(&self, sags: &mut [FacetSag<D>]) {
        let mut of_faces: FxHashMap<[u32; 2], SmallVec<[f64; 4]>> = FxHashMap::default();
        for (number, sag) in sags.iter_mut().enumerate().filter(|(number, _)| self.is_straight(*number)) {
            let whole = self.surface.on_face(number, true);
            let rises = of_faces
                .entry(whole.face)
                .or_insert_with(|| whole.edges().map(|[i, j]| self.rise(number, i, j)).collect());
            *sag = whole.sag(rises);
        }
    }

    /// Whether the mesh does not say itself how the surface bends at a facet.
    fn is_straight(&self, facet: usize) -> bool {
        let cell = self.surface.facet_cell[facet] as usize;
        let is_first_order =
            || self.surface.division().and_then(|division| division.cell_type(cell)).is_none_or(|t| t.straight() == t);
        self.is_surface[facet] && (!self.is_curved[self.around.body(facet) as usize] || is_first_order())
    }

    /// How far the arc over an edge of a facet rises above it.
    fn rise(&self, facet: usize, i: u32, j: u32) -> f64 {
        let along = self.points[j as usize] - self.points[i as usize];
        let of_end = |vertex: u32, sign: f64| {
            let normal = self.normal_at(vertex, facet)?;
            Some(sign * 0.25 * along.dot(&normal))
        };
        let rise = match (of_end(i, -1.0), of_end(j, 1.0)) {
            (Some(p), Some(q)) if p * q > 0.0 => p.abs().min(q.abs()).copysign(p),
            (Some(_), Some(_)) | (None, None) => 0.0,
            (Some(one), None) | (None, Some(one)) => one,
        };
        if rise.abs() > ROUNDING * along.norm() { rise } else { 0.0 }
    }

    /// The normal of the surface at a vertex, as a facet sees it; `None` where no other facet goes on there smoothly.
    fn normal_at(&self, vertex: u32, facet: usize) -> Option<Vector<D>> {
        let (mut sum, mut ends) = (Vector::<D>::zeros(), AcrossPlanes::default());
        let others: SmallVec<[usize; 16]> = self.around.of_body(facet, vertex).collect();
        others.iter().filter(|&&other| !self.is_surface[other]).for_each(|&other| ends.add(&self.normals[other]));
        let face = self.face_at(facet, vertex, &others);
        face.iter().for_each(|&other| sum += self.normals[other] * self.weight(other, vertex));
        if ends.is_empty() && face.len() < 2 {
            return None;
        }
        // A body that goes on behind a plane of symmetry has the mirrored facet there, in a corner of planes behind each of them.
        ends.taken_from(sum).try_normalize(0.0)
    }

    /// The facets at a vertex in which the face of a facet goes on, from one to the next over edges at less than the feature angle: from the first
    /// to the last they may turn by more, as around a vertex of a coarse ball.
    fn face_at(&self, facet: usize, vertex: u32, around: &[usize]) -> SmallVec<[usize; 16]> {
        let corners = |of: usize| self.surface.facets[of].iter().filter(move |&&corner| corner != vertex);
        let mut face: SmallVec<[usize; 16]> = SmallVec::new();
        face.extend(around.iter().copied().filter(|&other| self.faces[other] == self.faces[facet]));
        let mut next = 0;
        while let Some(&one) = face.get(next) {
            for &other in around.iter().filter(|&&other| self.is_surface[other]) {
                let has_edge = D == 2 || corners(one).any(|v| corners(other).any(|w| v == w));
                if has_edge && !face.contains(&other) && self.normals[other].dot(&self.normals[one]) > self.smooth {
                    face.push(other);
                }
            }
            next += 1;
        }
        // Sums in one order, whichever facet asks.
        face.sort_unstable();
        face
    }

    /// With what part a facet counts at a vertex: by its angle there, in the plane by one over its length, so that three points on an arc
    /// have its normal.
    fn weight(&self, facet: usize, vertex: u32) -> f64 {
        let corners = match D {
            2 => self.surface.on_face(facet, self.is_straight(facet)).corners,
            _ => SmallVec::from_slice(&self.surface.facets[facet]),
        };
        let at = |k: usize| self.points[corners[k % D] as usize];
        let Some(k) = corners.iter().position(|v| *v == vertex) else { return 0.0 };
        if D == 2 {
            return 1.0 / (at(1) - at(0)).norm();
        }
        let (e, f) = (at(k + 1) - at(k), at(k + 2) - at(k));
        (e.dot(&f) / (e.norm() * f.norm())).clamp(-1.0, 1.0).acos()
    }
}
