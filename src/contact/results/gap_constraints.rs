//! Gaps as constraints on the nodes, for augmented Lagrangians, interior points and preconditioners of others.

use crate::Error;
use crate::overlap::{NodalGap, Partner};

/// Weighted gaps and their derivatives, one row for every node that is within reach of a partner of its body.
///
/// Row r is the gap of a node of one body over the surface of one partner, g_r = ∫ N φ dA over what the facets of the node have
/// nearer than the reach and facing the partner, within 60° of the way to its nearest point: N is the shape function, φ the
/// distance from the partner's surface, negative inside. Contact is g_r ≥ 0.
/// Multipliers p_r (pressures) act with the nodal forces Σ_r p_r ∂g_r/∂x, which balance: partners that are bodies take the
/// opposite. With axisymmetry areas are those of rings, dA = 2πr ds, and radial forces need not balance. Both bodies of a pair have rows; a host that wants one side only takes the rows of one body.
///
/// With cells of second order a row is that of a point of their division ([`PointWeights`](crate::PointWeights)), and N its
/// straight shape function, which is nowhere negative; columns are nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GapConstraints<const D: usize> {
    /// Node of every row; with cells of second order the point.
    pub nodes: Vec<u32>,
    /// Its body and the partner, by row.
    pub partners: Vec<[Partner; 2]>,
    /// g, in length^D.
    pub gaps: Vec<f64>,
    /// ∫ N dA by row, over the same part: g divided by it is the mean gap at the node.
    pub areas: Vec<f64>,
    /// ∫ N ∇φ dA by row, over the same part: it points away from the partner.
    pub away: Vec<[f64; D]>,
    /// Entries of row r: `row_starts[r]..row_starts[r + 1]`.
    pub row_starts: Vec<usize>,
    /// Node of every entry, ascending within a row.
    pub columns: Vec<u32>,
    /// ∂g/∂x of that node.
    pub slopes: Vec<[f64; D]>,
}

impl<const D: usize> GapConstraints<D> {
    /// Joins the gaps of all pairs, in their order.
    pub(crate) fn assemble(pairs: Vec<([Partner; 2], Vec<NodalGap<D>>)>) -> Result<Self, Error> {
        let mut all = Self { row_starts: vec![0], ..Self::default() };
        for (partners, gaps) in pairs {
            for found in gaps {
                all.nodes.push(found.node);
                all.partners.push(if found.of_b { [partners[1], partners[0]] } else { partners });
                all.gaps.push(found.gap);
                all.areas.push(found.area);
                all.away.push(found.away.into());
                all.columns.extend(found.gradient.iter().map(|(node, _)| *node));
                all.slopes.extend(found.gradient.iter().map(|(_, slope)| <[f64; D]>::from(*slope)));
                all.row_starts.push(all.columns.len());
            }
        }
        let numbers = all.gaps.iter().chain(&all.areas).chain(all.slopes.iter().chain(&all.away).flatten());
        match numbers.copied().find(|x| !x.is_finite()) {
            Some(value) => Err(Error::Overflow { quantity: "gap of a node", value }),
            None => Ok(all),
        }
    }
}
