//! Surfaces that are moved out, node by node, so that they press without penetration.
//!
//! Under a law whose pressure is k times the penetration, a surface that lies s farther out presses with k s where it just
//! touches: λ = k s is the multiplier of an augmented Lagrangian, and what it adds to the law is a shift of the surface (Powell
//! 1969, who found the method so). Forces stay those of one energy, with the law's own tangent.

use crate::Error;
use crate::contact::laws::{EnergyLaw, EnergyProfile, PenetrationLaw};
use crate::geometry::Vector;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// How far the surface lies farther out at a node, against one partner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier<const D: usize> {
    /// The node; with cells of second order the point ([`PointWeights`](crate::PointWeights)).
    pub node: u32,
    /// Its body and the partner.
    pub partners: [Partner; 2],
    /// How far, a positive length; by the law's stiffness the pressure without penetration.
    pub shift: f64,
    /// Unit vector towards the partner.
    pub towards: [f64; D],
}

/// The node, its body and the partner.
pub(crate) type Row = (u32, [Partner; 2]);

/// Largest factor of a gap by which a surface is moved out.
const MOST_PACE: f64 = 4.0;

/// Refuses what does not go with multipliers: a shift stands for a pressure, whatever the stiffness is raised to, only where pressure is
/// stiffness times penetration.
pub(crate) fn check_law(law: &EnergyLaw, is_own: bool) -> Result<(), Error> {
    let what = match law {
        _ if is_own => "a penetration tolerance with self-contact",
        EnergyLaw::Fiber(PenetrationLaw { profile: EnergyProfile::Quadratic, .. }) | EnergyLaw::Depth { .. } => {
            return Ok(());
        }
        _ => "a penetration tolerance with a law whose pressure is not a stiffness times the penetration",
    };
    Err(Error::Unsupported { what })
}

/// Those of all nodes that have any.
#[derive(Clone, Debug, Default)]
pub(crate) struct Multipliers<const D: usize> {
    rows: BTreeMap<Row, (f64, Vector<D>)>,
    /// Shift and mean gap at the last update of the same series.
    past: BTreeMap<Row, (f64, f64)>,
    /// Of two bodies, whether the second has them, also while none has any: on another side the equilibrium is another one, by the
    /// size of the facets.
    sides: BTreeMap<[Partner; 2], bool>,
}

impl<const D: usize> Multipliers<D> {
    pub(crate) fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Refuses what does not go with them, where there are some.
    pub(crate) fn check(&self, law: &EnergyLaw, is_own: bool) -> Result<(), Error> {
        if self.is_empty() { Ok(()) } else { check_law(law, is_own) }
    }

    /// Moves points out.
    pub(crate) fn add_to(&self, points: &mut [[f64; D]]) {
        for ((node, _), (shift, towards)) in &self.rows {
            if let Some(point) = points.get_mut(*node as usize) {
                (0..D).for_each(|axis| point[axis] += shift * towards[axis]);
            }
        }
    }

    /// How far a node is moved out against a partner.
    pub(crate) fn shift(&self, node: u32, partners: [Partner; 2]) -> f64 {
        self.rows.get(&(node, partners)).map_or(0.0, |(shift, _)| *shift)
    }

    /// By how much of its gap a surface is moved out: all of it, or more where the last time the gap has changed by less than the
    /// shift, since a part alone of the facets about the node is pressed.
    pub(crate) fn pace(&self, node: u32, partners: [Partner; 2], mean: f64) -> f64 {
        let row = (node, partners);
        let Some((shift, gap)) = self.past.get(&row) else { return 1.0 };
        let (moved, closed) = (self.shift(node, partners) - shift, mean - gap);
        if moved * closed > 0.0 { (moved / closed).clamp(1.0, MOST_PACE) } else { 1.0 }
    }

    /// What an update was made of.
    pub(crate) fn remember(&mut self, past: Vec<(Row, (f64, f64))>, sides: BTreeMap<[Partner; 2], bool>) {
        (self.past, self.sides) = (past.into_iter().collect(), sides);
    }

    /// A series of updates has ended.
    pub(crate) fn end_series(&mut self) {
        self.past.clear();
    }

    /// Of two bodies, whether the second has them; those that are known.
    pub(crate) fn known_sides(&self) -> BTreeMap<[Partner; 2], bool> {
        self.sides.clone()
    }

    /// The same pressures by a stiffness that is higher by a factor.
    pub(crate) fn stiffen(&mut self, factor: f64) {
        self.scale(1.0 / factor);
    }

    /// Surfaces are moved out by a part of what they were.
    pub(crate) fn scale(&mut self, part: f64) {
        self.rows.values_mut().for_each(|(shift, _)| *shift *= part);
        self.rows.retain(|_, (shift, _)| *shift > 0.0);
        self.end_series();
    }

    /// Takes those of the pairs of which this holds out, bodies before obstacles, each by index.
    pub(crate) fn forget(&mut self, is_gone: impl Fn(&[Partner; 2]) -> bool) {
        self.sides.retain(|pair, _| !is_gone(pair));
        self.rows.retain(|(_, partners), _| !is_gone(&sorted(*partners)));
        self.past.retain(|(_, partners), _| !is_gone(&sorted(*partners)));
    }

    /// In ascending order.
    pub(crate) fn list(&self) -> Vec<Multiplier<D>> {
        let one = |(&(node, partners), &(shift, towards)): (&Row, &(f64, Vector<D>))| Multiplier {
            node,
            partners,
            shift,
            towards: towards.into(),
        };
        self.rows.iter().map(one).collect()
    }
}

impl<const D: usize> FromIterator<Multiplier<D>> for Multipliers<D> {
    fn from_iter<T: IntoIterator<Item = Multiplier<D>>>(list: T) -> Self {
        let row = |one: Multiplier<D>| ((one.node, one.partners), (one.shift, Vector::from(one.towards)));
        let rows: BTreeMap<_, _> = list.into_iter().map(row).collect();
        let of_bodies = |(_, [body, partner]): &Row| match (body, partner) {
            (Partner::Body(_), Partner::Body(_)) => Some((sorted([*body, *partner]), body > partner)),
            _ => None,
        };
        let sides = rows.keys().filter_map(of_bodies).collect();
        Self { rows, past: BTreeMap::new(), sides }
    }
}

pub(crate) fn sorted([p, q]: [Partner; 2]) -> [Partner; 2] {
    if p < q { [p, q] } else { [q, p] }
}
