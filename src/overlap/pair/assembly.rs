//! From crossings, or clipped pieces, to the gradient on nodes and poses.

use crate::configuration::FacetSide;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::{area_vector, moment};
use crate::geometry::{Pose, Surface, Vector};
use crate::overlap::pair::overlap::PoseGradient;
use crate::ranks::packed;
use rustc_hash::FxHashMap;

/// Share of one facet in ∂V/∂x: `shares[a]` times the facet's unit normal belongs to its corner a.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FacetShare<const D: usize> {
    pub(crate) facet: u32,
    pub(crate) of_b: bool,
    pub(crate) shares: [f64; D],
}

/// Share of a point on an implicit shape: `share` times the unit outward `normal`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointShare<const D: usize> {
    pub(crate) point: Vector<D>,
    pub(crate) normal: Vector<D>,
    pub(crate) share: f64,
}

packed!(FacetShare<D> { facet, of_b, shares });
packed!(PointShare<D> { point, normal, share });

/// Sums shares in the order in which they come.
pub(crate) struct Assembly<const D: usize> {
    /// Slots in the order in which they came, and the gradient on them. A slot is twice a vertex, and one more for the
    /// second side: a node may belong to both.
    touched: Vec<u32>,
    values: Vec<Vector<D>>,
    /// Where among these a slot is. Never iterated over: its order is not ours.
    place: FxHashMap<u32, u32>,
    pose: PoseGradient<D>,
    /// Sum of the shares of each side; apart, so that a swap of the sides changes no bit.
    resultants: [Vector<D>; 2],
    share_count: usize,
    /// Points of the overlap's boundary.
    points: Vec<Vector<D>>,
    facets: Vec<(bool, u32)>,
    /// Boundary measure by side.
    area_of: [f64; 2],
}

impl<const D: usize> Assembly<D> {
    pub(crate) fn new() -> Self {
        Self {
            touched: Vec::new(),
            values: Vec::new(),
            place: FxHashMap::default(),
            pose: PoseGradient { position: Vector::zeros(), rotation: [0.0; 3], scale: 0.0 },
            resultants: [Vector::zeros(); 2],
            share_count: 0,
            points: Vec::new(),
            facets: Vec::new(),
            area_of: [0.0; 2],
        }
    }

    /// Adds a share of a facet of `side`; where that is an obstacle, its `pose` is moved instead of nodes.
    pub(crate) fn add_facet(&mut self, side: &FacetSide<D>, share: &FacetShare<D>, pose: Option<&Pose<D>>) {
        let corners = side.corners(share.facet as usize);
        let Some(normal) = area_vector(&corners).try_normalize(0.0) else { return };
        let total: f64 = share.shares.iter().sum();
        if total <= 0.0 {
            return;
        }
        let point = (0..D).fold(Vector::zeros(), |x, a| x + corners[a] * (share.shares[a] / total));
        self.facets.push((share.of_b, share.facet));
        match pose {
            Some(pose) => self.add_point(&PointShare { point, normal, share: total }, pose),
            None => {
                for a in 0..D {
                    let vertex = side.facets[share.facet as usize][a];
                    self.add_to(2 * vertex + u32::from(share.of_b), normal * share.shares[a]);
                }
                self.bound(share.of_b, point, normal, total);
            }
        }
    }

    /// Adds a force at a point of a facet of `side`, which is no share of its boundary.
    pub(crate) fn add_force(
        &mut self,
        side: &FacetSide<D>,
        (of_b, facet): (bool, u32),
        weights: &[f64; D],
        force: &Vector<D>,
        pose: Option<&Pose<D>>,
    ) {
        match pose {
            Some(pose) => {
                let corners = side.corners(facet as usize);
                let point = (0..D).fold(Vector::zeros(), |x, a| x + corners[a] * weights[a]);
                self.pull(&point, force, pose);
            }
            None => {
                for (vertex, weight) in side.facets[facet as usize].iter().zip(weights) {
                    self.add_to(2 * vertex + u32::from(of_b), force * *weight);
                }
            }
        }
    }

    /// Adds a force on a vertex at `point`, which is no share of the boundary.
    pub(crate) fn add_to_vertex(
        &mut self,
        of_b: bool,
        vertex: u32,
        point: &Vector<D>,
        force: &Vector<D>,
        pose: Option<&Pose<D>>,
    ) {
        match pose {
            Some(pose) => self.pull(point, force, pose),
            None => self.add_to(2 * vertex + u32::from(of_b), *force),
        }
    }

    /// Adds a share of a point that moves with `pose`.
    pub(crate) fn add_point(&mut self, share: &PointShare<D>, pose: &Pose<D>) {
        self.pull(&share.point, &(share.normal * share.share), pose);
        self.bound(true, share.point, share.normal, share.share);
    }

    /// Adds a force at a point that moves with `pose`, which is no share of the boundary.
    pub(crate) fn pull(&mut self, point: &Vector<D>, g: &Vector<D>, pose: &Pose<D>) {
        let lever = point - Vector::from(pose.position);
        self.pose.position += g;
        for (sum, m) in self.pose.rotation.iter_mut().zip(moment(point, g)) {
            *sum += m;
        }
        self.pose.scale += g.dot(&lever) / pose.scale;
    }

    /// Adds what the plane of a half-space must carry so that the sums of forces and moments vanish: exact, since the
    /// overlap does not change when both sides move together, but by `as_one` where it has a weight.
    pub(crate) fn add_reaction(&mut self, normal: &Vector<D>, points: &[Vector<D>], as_one: &Vector<D>) {
        let mut force = Vector::zeros();
        for (&slot, g) in self.touched.iter().zip(&self.values) {
            force += g;
            for (sum, m) in self.pose.rotation.iter_mut().zip(moment(&points[slot as usize / 2], g)) {
                *sum -= m;
            }
        }
        force -= as_one;
        self.pose.position -= force;
        self.area_of[1] += (-force.dot(normal)).max(0.0);
    }

    fn bound(&mut self, of_b: bool, point: Vector<D>, normal: Vector<D>, share: f64) {
        self.area_of[usize::from(of_b)] += share;
        self.resultants[usize::from(of_b)] += normal * share;
        self.share_count += 1;
        self.points.push(point);
    }

    /// Adds corners of the overlap, where they are known, so that its extent is theirs.
    pub(crate) fn extend_to(&mut self, corners: &[Vector<D>]) {
        self.points.extend_from_slice(corners);
    }

    /// Half of the boundary's measure.
    pub(crate) fn contact_area(&self) -> f64 {
        0.5 * (self.area_of[0] + self.area_of[1])
    }

    /// Boundary measure that each side contributes.
    pub(crate) fn side_areas(&self) -> [f64; 2] {
        self.area_of
    }

    /// Number of shares.
    pub(crate) fn share_count(&self) -> usize {
        self.share_count
    }

    /// Number of different facets.
    pub(crate) fn facet_count(&mut self) -> usize {
        self.facets.sort_unstable();
        self.facets.dedup();
        self.facets.len()
    }

    /// Gradient with respect to the pose. What lies wholly inside a body moves freely there: the body has no boundary in
    /// the overlap, and what a sum over lines leaves of the derivative is noise that no node would bear.
    pub(crate) fn pose_gradient(&self) -> PoseGradient<D> {
        let is_swallowed = self.area_of[0] == 0.0 && self.area_of[1] > 0.0;
        match is_swallowed {
            true => PoseGradient { position: Vector::zeros(), rotation: [0.0; 3], ..self.pose },
            false => self.pose,
        }
    }

    /// Extent of the boundary along the mean normal; where the normals cancel, the smallest extent along an axis.
    pub(crate) fn penetration(&self) -> f64 {
        if self.points.is_empty() {
            return 0.0;
        }
        let resultant = self.resultants[0] - self.resultants[1];
        if resultant.norm() <= 1e-6 * (self.area_of[0] + self.area_of[1]) {
            return Aabb::of(&self.points).extent().min();
        }
        let normal = resultant.normalize();
        let (low, high) = self.points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            let s = x.dot(&normal);
            (low.min(s), high.max(s))
        });
        high - low
    }

    fn add_to(&mut self, slot: u32, g: Vector<D>) {
        let place = *self.place.entry(slot).or_insert_with(|| {
            self.touched.push(slot);
            self.values.push(Vector::zeros());
            self.touched.len() as u32 - 1
        });
        self.values[place as usize] += g;
    }

    /// Nodes, ascending, the gradient on them, and whether they are of the second side; shares of a face centroid go to
    /// the face's four nodes.
    pub(crate) fn into_nodes(mut self, surface: &Surface<D>) -> (Vec<u32>, Vec<Vector<D>>, Vec<bool>) {
        let of_node = |slot: u32| ((slot / 2) as usize) < surface.nodes.len();
        let mut centroids: Vec<(u32, u32)> =
            (self.touched.iter().copied().zip(0..)).filter(|(slot, _)| !of_node(*slot)).collect();
        centroids.sort_unstable();
        for (slot, place) in centroids {
            let quarter = self.values[place as usize] * 0.25;
            for vertex in surface.centroids[(slot / 2) as usize - surface.nodes.len()] {
                self.add_to(2 * vertex + slot % 2, quarter);
            }
        }
        let mut order: Vec<(u32, u32)> =
            self.touched.iter().copied().zip(0..).filter(|(slot, _)| of_node(*slot)).collect();
        order.sort_unstable();
        let nodes = order.iter().map(|&(slot, _)| surface.nodes[(slot / 2) as usize]).collect();
        let values = order.iter().map(|&(_, place)| self.values[place as usize]).collect();
        (nodes, values, order.iter().map(|&(slot, _)| slot % 2 == 1).collect())
    }
}
