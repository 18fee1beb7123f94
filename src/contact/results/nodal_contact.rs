//! Pressure, gap, area and normal at the nodes.

use crate::Error;
use crate::contact::friction::NodalFriction;
use crate::contact::laws::PairEnergy;
use crate::geometry::Vector;
use crate::overlap::NodalSums;

/// Whether a node is in contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum NodeStatus {
    /// No facet at the node is in contact.
    #[default]
    Apart,
    /// A facet at the node is in contact, without friction.
    Touching,
    /// More of the contact at the node sticks than slides, by area.
    Sticking,
    /// At least half of it slides.
    Sliding,
}

/// The contact at every node of the mesh, in the order of the coordinates; zero where nothing touches.
///
/// Pressure, area and normal are those of the nodal force without friction: F = −p A n, to rounding, so that their sum is
/// the resultant. The area is that of the geometry, and the pressure follows from the force: the mortar pressure. The law `depth` has forces on inner nodes too, which come at the nearest points of the surface first. With cells of
/// second order a node has what is at the point of their division that stands for it, with that
/// point's straight shape function; the sum is then the resultant only with those of the points that are no nodes, which
/// are not told.
#[derive(Clone, Debug, PartialEq)]
pub struct NodalContact<const D: usize> {
    /// Contact pressure: the nodal force by the area on which it acts, |F| / ∫ N dA.
    pub pressure: Vec<f64>,
    /// The mean of the pressure of the law over the part of the facets in contact, weighted with the node's shape function
    /// (∫ N p dA / ∫ N dA); with the law `volume` that of the pair. On curved surfaces it scatters more than [`Self::pressure`].
    pub local_pressure: Vec<f64>,
    /// Minus the penetration, the mean over the same part; with the law `volume` minus the mean of the pair, V by its
    /// area of contact. Never positive: distances of what is apart are not measured.
    pub gap: Vec<f64>,
    /// Area (2D: length) on which the pressure acts: ∫ N dA over the part of the facets in contact, N being the node's shape
    /// function. Never larger than ∫ N dA over all of the node's facets, but for the error of counting by lines; not so small that the
    /// pressure would be larger than that of the law anywhere, or than both twice that on the node's facets and the mean of the pair.
    pub area: Vec<f64>,
    /// Unit normal, outwards of the node's body, against the nodal force.
    pub normal: Vec<[f64; D]>,
    /// Traction of friction on the node's body: the mean of that of the facets over the part in contact, weighted with
    /// the node's shape function.
    pub friction: Vec<[f64; D]>,
    /// Part of the contact at the node that slides, of its area: between 0 and 1.
    pub sliding: Vec<f64>,
    /// Whether there is contact, and whether it sticks.
    pub status: Vec<NodeStatus>,
}

/// The pressure of the nodal force by that of the law on the node's facets, at most: by more where facets of the other side press the cell and
/// those of the node hardly touch. Where both touch, the two differ by some tenths.
const SPIKE: f64 = 2.0;

/// NodeTotals at one node.
#[derive(Clone, Copy)]
struct NodeTotals<const D: usize> {
    force: Vector<D>,
    /// ∫ N dA over all of the node's facets.
    share: f64,
    /// The same over what touches of them.
    area: f64,
    pressure: f64,
    penetration: f64,
    /// The largest mean pressure of the pairs that press the node, and the largest pressure.
    typical: f64,
    largest: f64,
    touches: bool,
    /// Whether some areas were not measured exactly, but counted by lines or found from the pressure of a pair.
    is_counted: bool,
    /// ∫ N q dA, and the areas over which friction acts and slides.
    friction: Vector<D>,
    rubbed: f64,
    sliding: f64,
}

/// A pair's energy, its sums at the nodes, where its law acts at contact points, and its friction.
pub(crate) type NodalParts<const D: usize> = (PairEnergy<D>, Option<NodalSums>, Vec<NodalFriction<D>>);

impl<const D: usize> NodalContact<D> {
    /// What is at the first `count` nodes.
    pub(crate) fn truncated(mut self, count: usize) -> Self {
        let Self { pressure, local_pressure, gap, area, normal, friction, sliding, status } = &mut self;
        for field in [pressure, local_pressure, gap, area, sliding] {
            field.truncate(count);
        }
        normal.truncate(count);
        friction.truncate(count);
        status.truncate(count);
        self
    }

    /// Has nodes that are one share what is at the first: parts of its area, and all else as it is.
    pub(crate) fn share(&mut self, nodes: &[u32]) {
        let first = nodes[0] as usize;
        self.area[first] /= nodes.len() as f64;
        for &node in &nodes[1..] {
            let Self { pressure, local_pressure, gap, area, normal, friction, sliding, status } = &mut *self;
            for field in [pressure, local_pressure, gap, area, sliding] {
                field[node as usize] = field[first];
            }
            normal[node as usize] = normal[first];
            friction[node as usize] = friction[first];
            status[node as usize] = status[first];
        }
    }

    /// Adds up in the order of the pairs; pairs whose law does not act at contact points come without sums. `shares` is the area of
    /// the surface that belongs to each node.
    pub(crate) fn assemble(shares: &[f64], pairs: &[NodalParts<D>]) -> Result<Self, Error> {
        let mut nodes: Vec<NodeTotals<D>> = shares.iter().map(|share| NodeTotals::new(*share)).collect();
        for (energy, sums, friction) in pairs {
            let depth = energy.overlap.volume / energy.overlap.contact_area.max(f64::MIN_POSITIVE);
            let largest = sums.as_ref().map_or(energy.pressure, |sums| sums.largest_pressure);
            for (&node, gradient) in energy.nodes.iter().zip(&energy.gradient) {
                let sum = &mut nodes[node as usize];
                sum.force -= gradient;
                let size = gradient.norm();
                if size > 0.0 {
                    sum.typical = sum.typical.max(energy.pressure);
                    sum.largest = sum.largest.max(largest);
                    sum.is_counted |= sums.as_ref().is_none_or(|sums| !sums.is_exact);
                }
                if size > 0.0 && sums.is_none() && energy.pressure > 0.0 {
                    let area = size / energy.pressure;
                    sum.add(area, size, area * depth);
                }
            }
            for found in sums.iter().flat_map(|sums| &sums.sums) {
                nodes[found.node as usize].add(found.area, found.pressure, found.penetration);
            }
            for found in friction {
                nodes[found.node as usize].add_friction(found);
            }
        }
        let field = Self {
            pressure: nodes.iter().map(|sum| quotient(sum.force.norm(), sum.pressed_area())).collect(),
            local_pressure: nodes.iter().map(|sum| sum.mean(sum.pressure).min(sum.largest)).collect(),
            gap: nodes.iter().map(|sum| 0.0 - sum.mean(sum.penetration)).collect(),
            area: nodes.iter().map(NodeTotals::pressed_area).collect(),
            normal: nodes
                .iter()
                .map(|sum| (-sum.force).try_normalize(0.0).unwrap_or_else(Vector::zeros).into())
                .collect(),
            friction: nodes.iter().map(|sum| (sum.friction / sum.rubbed.max(f64::MIN_POSITIVE)).into()).collect(),
            sliding: nodes.iter().map(|sum| quotient(sum.sliding, sum.rubbed)).collect(),
            status: nodes.iter().map(NodeTotals::status).collect(),
        };
        let numbers = [&field.pressure, &field.local_pressure, &field.gap, &field.area].into_iter().flatten();
        let numbers = numbers.chain(field.friction.as_flattened());
        let strange = numbers.copied().find(|x| !x.is_finite());
        match strange {
            Some(value) => Err(Error::Overflow { quantity: "contact at a node", value }),
            None => Ok(field),
        }
    }
}

impl<const D: usize> NodeTotals<D> {
    fn new(share: f64) -> Self {
        let (force, friction) = (Vector::zeros(), Vector::zeros());
        Self {
            force,
            area: 0.0,
            pressure: 0.0,
            penetration: 0.0,
            share,
            typical: 0.0,
            largest: 0.0,
            touches: false,
            is_counted: false,
            friction,
            rubbed: 0.0,
            sliding: 0.0,
        }
    }

    fn add_friction(&mut self, found: &NodalFriction<D>) {
        self.friction += found.force;
        self.rubbed += found.area;
        self.sliding += found.sliding;
        self.touches |= found.area > 0.0;
    }

    fn status(&self) -> NodeStatus {
        match () {
            () if !self.touches => NodeStatus::Apart,
            () if self.rubbed <= 0.0 => NodeStatus::Touching,
            () if 2.0 * self.sliding < self.rubbed => NodeStatus::Sticking,
            () => NodeStatus::Sliding,
        }
    }

    fn add(&mut self, area: f64, pressure: f64, penetration: f64) {
        self.area += area;
        self.pressure += pressure;
        self.penetration += penetration;
        self.touches |= area > 0.0;
    }

    /// The area on which the force acts. Other sides press nodes whose own facets hardly touch: then it is larger, so that the pressure is that of
    /// the law there, or the mean of the pair.
    fn pressed_area(&self) -> f64 {
        let force = self.force.norm();
        let there = match (SPIKE * self.mean(self.pressure)).max(self.typical) {
            pressure if pressure > 0.0 => pressure.min(self.largest),
            _ => self.largest,
        };
        match force > 0.0 {
            true if self.share <= 0.0 || self.is_counted => self.area.max(quotient(force, self.largest)),
            true => self.area.max(quotient(force, there)).min(self.share),
            false => self.area.clamp(0.0, self.share.max(0.0)),
        }
    }

    /// A mean over what touches, never negative.
    fn mean(&self, sum: f64) -> f64 {
        quotient(sum, self.area).max(0.0)
    }
}

/// a / b, 0 where b is not positive.
fn quotient(a: f64, b: f64) -> f64 {
    if b > 0.0 { a / b } else { 0.0 }
}
