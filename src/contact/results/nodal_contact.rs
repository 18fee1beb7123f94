//! Pressure, gap, area and normal at the nodes.

use crate::Error;
use crate::contact::friction::NodalFriction;
use crate::contact::laws::PairEnergy;
use crate::geometry::Vector;
use crate::overlap::NodalSum;

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
/// the resultant. The law `depth` has forces on inner nodes too, which come at the nearest points of the surface first. With cells of
/// second order a node has what is at the point of their division that stands for it, with that
/// point's straight shape function; the sum is then the resultant only with those of the points that are no nodes, which
/// are not told.
#[derive(Clone, Debug, PartialEq)]
pub struct NodalContact<const D: usize> {
    /// Contact pressure: the mean of that of the law over the part of the facets in contact, weighted with the node's
    /// shape function (∫ N p dA / ∫ N dA). With the law `volume` that of the pair.
    pub pressure: Vec<f64>,
    /// Minus the penetration, the mean over the same part; with the law `volume` minus the mean of the pair, V by its
    /// area of contact. Never positive: distances of what is apart are not measured.
    pub gap: Vec<f64>,
    /// Area (2D: length) on which the pressure acts: ∫ N dA over the part in contact, up to the curvature of the surface.
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

/// NodeTotals at one node.
#[derive(Clone, Copy)]
struct NodeTotals<const D: usize> {
    force: Vector<D>,
    area: f64,
    pressure: f64,
    penetration: f64,
    /// Pressure of the pair, for nodes that carry force at edges alone.
    of_pair: f64,
    touches: bool,
    /// ∫ N q dA, and the areas over which friction acts and slides.
    friction: Vector<D>,
    rubbed: f64,
    sliding: f64,
}

/// A pair's energy, its sums at the nodes, where its law acts at contact points, and its friction.
pub(crate) type NodalParts<const D: usize> = (PairEnergy<D>, Option<Vec<NodalSum>>, Vec<NodalFriction<D>>);

impl<const D: usize> NodalContact<D> {
    /// What is at the first `count` nodes.
    pub(crate) fn truncated(mut self, count: usize) -> Self {
        let Self { pressure, gap, area, normal, friction, sliding, status } = &mut self;
        for field in [pressure, gap, area, sliding] {
            field.truncate(count);
        }
        normal.truncate(count);
        friction.truncate(count);
        status.truncate(count);
        self
    }

    /// NodeTotals up, in the order of the pairs; pairs whose law does not act at contact points come without sums.
    pub(crate) fn assemble(node_count: usize, pairs: &[NodalParts<D>]) -> Result<Self, Error> {
        let mut nodes = vec![NodeTotals::new(); node_count];
        for (energy, sums, friction) in pairs {
            let depth = energy.overlap.volume / energy.overlap.contact_area.max(f64::MIN_POSITIVE);
            for (&node, gradient) in energy.nodes.iter().zip(&energy.gradient) {
                let sum = &mut nodes[node as usize];
                sum.force -= gradient;
                sum.of_pair = sum.of_pair.max(energy.pressure);
                let size = gradient.norm();
                if size > 0.0 && sums.is_none() && energy.pressure > 0.0 {
                    let area = size / energy.pressure;
                    sum.add(area, size, area * depth);
                }
            }
            for found in sums.iter().flatten() {
                nodes[found.node as usize].add(found.area, found.pressure, found.penetration);
            }
            for found in friction {
                nodes[found.node as usize].add_friction(found);
            }
        }
        let field = Self {
            pressure: nodes.iter().map(NodeTotals::pressure).collect(),
            gap: nodes.iter().map(|sum| if sum.area > 0.0 { -sum.penetration / sum.area } else { 0.0 }).collect(),
            area: nodes.iter().map(|sum| quotient(sum.force.norm(), sum.pressure())).collect(),
            normal: nodes
                .iter()
                .map(|sum| (-sum.force).try_normalize(0.0).unwrap_or_else(Vector::zeros).into())
                .collect(),
            friction: nodes.iter().map(|sum| (sum.friction / sum.rubbed.max(f64::MIN_POSITIVE)).into()).collect(),
            sliding: nodes.iter().map(|sum| quotient(sum.sliding, sum.rubbed)).collect(),
            status: nodes.iter().map(NodeTotals::status).collect(),
        };
        let numbers = (field.pressure.iter().chain(&field.gap).chain(&field.area)).chain(field.friction.as_flattened());
        match numbers.copied().find(|x| !x.is_finite()) {
            Some(value) => Err(Error::Overflow { quantity: "contact at a node", value }),
            None => Ok(field),
        }
    }
}

impl<const D: usize> NodeTotals<D> {
    fn new() -> Self {
        let (force, friction) = (Vector::zeros(), Vector::zeros());
        Self {
            force,
            area: 0.0,
            pressure: 0.0,
            penetration: 0.0,
            of_pair: 0.0,
            touches: false,
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

    fn pressure(&self) -> f64 {
        match quotient(self.pressure, self.area) {
            0.0 if self.force.norm() > 0.0 => self.of_pair,
            mean => mean,
        }
    }
}

/// a / b, 0 where b is not positive.
fn quotient(a: f64, b: f64) -> f64 {
    if b > 0.0 { a / b } else { 0.0 }
}
