//! As little penetration as is wanted, whatever iterates the bodies: the method of multipliers.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::glides::Glides;
use crate::contact::history::{Multiplier, Multipliers, check_law, sorted};
use crate::contact::method::Options;
use crate::contact::results::GapConstraints;
use crate::contact::ties::{Supports, TieChange, TieMultipliers};
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Reach of the gaps, by the bodies' extent: what is farther apart is taken for open.
const REACH: f64 = 0.05;

/// What an update of the multipliers says of the coordinates it was made at.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Augmentation {
    /// Largest mean penetration of a node over its part of the surface, of the side of each pair that has the multipliers, or the largest
    /// mean jump of a tie.
    pub penetration: f64,
    /// Largest change that the gaps ask of a multiplier, by the law's stiffness: how far a node that is pressed is from the partner,
    /// inside or outside.
    pub change: f64,
    /// Mean of the changes by the pressures, also of those that are to go: what forces are wrong by is the work on it.
    pub mean_change: f64,
    /// Whether the penetration and the change are no more than what was enough: the multipliers have then stayed.
    pub is_enough: bool,
    /// Number of multipliers.
    pub count: usize,
}

/// Multipliers of contact and ties, and what slides with its own.
pub(crate) type AllMultipliers<const D: usize> = (Vec<Multiplier<D>>, TieMultipliers<D>, Glides<D>);

impl<const D: usize> Contact<D> {
    /// Moves surfaces out so that at the next equilibrium they press with less penetration: at every node by its mean gap
    /// ([`Self::gap_constraints`]) at `coords`, up to four times as far where the last update of a series has closed less than it moved
    /// out, and back where it has opened. Call it where the bodies are in equilibrium, or nearly, solve again, and so on until
    /// [`Augmentation::is_enough`]; the law's stiffness may be any, but a low one takes more updates. All that is asked of the contact
    /// afterwards, forces, tangents, steps, is that of the surfaces moved out, whose penetration is pressure by stiffness;
    /// [`Self::gap_constraints`] and [`Self::evaluate_true`] are those of the true ones. What is moved out stays for the next load
    /// step; [`Self::set_multipliers`] with none moves it back.
    ///
    /// Of two bodies the one with more nodes near the other when they meet has the multipliers, of equals the first.
    ///
    /// `reach`: how far from a partner gaps are measured, 0 for a twentieth of the bodies' extent. `enough`: the penetration and the
    /// change that are left alone.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a reach or a penetration that is negative or no number; [`Error::Unsupported`] with
    /// self-contact, a law whose pressure is not a stiffness times the penetration, and a mesh in parts; else as [`Self::evaluate`]. The
    /// multipliers have then stayed.
    #[inline(never)]
    pub fn augment(&mut self, coords: &[[f64; D]], reach: f64, enough: f64) -> Result<Augmentation, Error> {
        Error::check_not_negative("penetration", enough)?;
        self.augment_unless(coords, reach, &Supports::default(), |found, _| {
            [found.penetration.max(found.change) <= enough; 2]
        })
    }

    /// The same, unless what is found is enough: of contact, whose multipliers stay where that alone is, and of ties.
    pub(crate) fn augment_unless(
        &mut self,
        coords: &[[f64; D]],
        reach: f64,
        supports: &Supports,
        is_enough: impl FnOnce(&Augmentation, &TieChange) -> [bool; 2],
    ) -> Result<Augmentation, Error> {
        let (next, mut found) = self.measured(coords, reach)?;
        let (of_ties, next_of_ties) = self.change_of_ties(coords, supports)?;
        let (of_glides, next_glides) = self.change_of_glides(coords, supports)?;
        let of_interfaces = of_ties.and(of_glides);
        found.penetration = found.penetration.max(of_interfaces.largest);
        found.change = found.change.max(of_interfaces.largest);
        let [is_of_contact, is_of_ties] = is_enough(&found, &of_interfaces);
        found.mean_change = found.mean_change.max(of_interfaces.mean());
        found.is_enough = is_of_contact && is_of_ties;
        match found.is_enough {
            true => self.history.multipliers.end_series(),
            false => {
                if !is_of_contact {
                    self.history.multipliers = next;
                }
                self.ties.put_back(next_of_ties);
                self.glides = next_glides;
            }
        }
        found.count = self.history.multipliers.list().len();
        Ok(found)
    }

    /// The largest mean penetration of a node over its part of the surface at `coords`, of the side of each pair that has the
    /// multipliers, or would have them; or the largest mean jump of a tie.
    ///
    /// # Errors
    /// As [`Self::augment`].
    #[inline(never)]
    pub fn nodal_penetration(&self, coords: &[[f64; D]], reach: f64) -> Result<f64, Error> {
        Ok(self.left_of_penetration(coords, reach, &Supports::default())?.0.penetration)
    }

    /// What an update would say, without one.
    pub(crate) fn left_of_penetration(
        &self,
        coords: &[[f64; D]],
        reach: f64,
        supports: &Supports,
    ) -> Result<(Augmentation, TieChange), Error> {
        let of_interfaces = self.change_of_ties(coords, supports)?.0.and(self.change_of_glides(coords, supports)?.0);
        let mut found = self.measured(coords, reach)?.1;
        found.penetration = found.penetration.max(of_interfaces.largest);
        Ok((found, of_interfaces))
    }

    fn change_of_ties(
        &self,
        coords: &[[f64; D]],
        supports: &Supports,
    ) -> Result<(TieChange, TieMultipliers<D>), Error> {
        self.ties.change(
            &self.mesh.points(coords)?,
            |pair| (self.stiffness_of_tie(pair), self.is_tie_stiffness_given(pair)),
            |point, axis| supports.hold(&self.mesh.surface, point, axis),
        )
    }

    /// What slides and does not separate: with points that are found anew where bodies have moved to.
    fn change_of_glides(&self, coords: &[[f64; D]], supports: &Supports) -> Result<(TieChange, Glides<D>), Error> {
        let points = self.mesh.points(coords)?;
        let found = self.glides.moved_on(&self.mesh, self.method.weighting(), &points)?;
        found.updated(
            &points,
            |pair| (self.stiffness_of_tie(pair), self.is_tie_stiffness_given(pair)),
            |point, axis| supports.hold(&self.mesh.surface, point, axis),
        )
    }

    /// Those of contact and interfaces, to be put back.
    pub(crate) fn all_multipliers(&self) -> AllMultipliers<D> {
        (self.multipliers(), self.ties.multipliers(), self.glides.clone())
    }

    /// Puts back what was there before.
    pub(crate) fn put_back_multipliers(&mut self, (of_contact, of_ties, glides): AllMultipliers<D>) {
        // They were accepted then, and are now.
        let _ = self.set_multipliers(&of_contact);
        self.ties.put_back(of_ties);
        self.glides = glides;
    }

    /// Leaves a part of what the multipliers press and pull with: a guess for another load.
    pub(crate) fn scale_multipliers(&mut self, part: f64) {
        self.history.multipliers.scale(part);
        self.ties.scale_multipliers(part);
        self.glides.scale_multipliers(part);
    }

    /// The next multipliers.
    fn measured(&self, coords: &[[f64; D]], reach: f64) -> Result<(Multipliers<D>, Augmentation), Error> {
        self.check_multipliers()?;
        Error::check_not_negative("reach", reach)?;
        let mut extent = Aabb::empty();
        self.mesh.surface.mesh_points(coords)?.iter().for_each(|x| extent.include(&Vector::from(*x)));
        let reach = if reach > 0.0 { reach } else { REACH * extent.extent().max() };
        Ok(self.history.multipliers.moved_out(&kernels::gap_constraints(self, coords, reach)?))
    }

    /// How far surfaces are moved out, ascending by node and partner: with the coordinates all that a restart needs, or a load step
    /// that is tried again.
    pub fn multipliers(&self) -> Vec<Multiplier<D>> {
        self.history.multipliers.list()
    }

    /// Moves surfaces out as said, `&[]`: back. Ties are without multipliers then, until the next update.
    ///
    /// # Errors
    /// As [`Self::augment`]; [`Error::NodeOutOfRange`], naming the place in the list as its cell; [`Error::BodyOutOfRange`],
    /// [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`]; [`Error::NotPositive`] for a shift or a direction that is none. What
    /// was moved out then stays.
    #[inline(never)]
    pub fn set_multipliers(&mut self, multipliers: &[Multiplier<D>]) -> Result<(), Error> {
        if !multipliers.is_empty() {
            self.check_multipliers()?;
        }
        let node_count = self.mesh.surface.point_weights().point_count();
        for (cell, one) in multipliers.iter().enumerate() {
            if one.node as usize >= node_count {
                return Err(Error::NodeOutOfRange { cell, node: one.node.into(), node_count });
            }
            self.partners.checked_pair(one.partners, self.mesh.surface.body_count())?;
            let length = Vector::from(one.towards).norm();
            for (name, value) in [("shift", one.shift), ("length of a direction", length)] {
                if !(value.is_finite() && value > 0.0) {
                    return Err(Error::NotPositive { name, value });
                }
            }
        }
        self.history.multipliers = multipliers.iter().copied().collect();
        self.ties.put_back(TieMultipliers::new());
        self.glides.release_multipliers();
        Ok(())
    }

    /// Multiplies the stiffness of the law, and of those that pairs have of their own, by a factor; what surfaces that are moved out
    /// press with where they just touch stays, and so does what elastic slip that is carried pulls with. Where an update of the
    /// multipliers leaves more than a part of the penetration, this helps more than another one.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a factor that is not, or a stiffness that would not be; nothing has then changed.
    #[inline(never)]
    pub fn stiffen(&mut self, factor: f64) -> Result<(), Error> {
        if !(factor.is_finite() && factor > 0.0) {
            return Err(Error::NotPositive { name: "factor", value: factor });
        }
        let options = Options { law: self.method.options().law.stiffened(factor), ..*self.method.options() };
        let of_pairs = self.partners.table.own_laws().map(|law| law.stiffened(factor));
        Options { law: options.law, ..options }.check()?;
        of_pairs.into_iter().try_for_each(|law| law.check())?;
        self.partners.table.stiffen(factor);
        changes::options::set(self, options)?;
        self.partners.stiffen_layers(factor, &options.law)?;
        self.history.stiffen(factor, options.friction.has_stiffness_of_law());
        Ok(())
    }

    /// Refuses what surfaces are not moved out with.
    pub(super) fn check_multipliers(&self) -> Result<(), Error> {
        self.mesh.surface.refuse_submesh("multipliers of a part of a mesh")?;
        let options = self.method.options();
        self.partners.energy_laws(options).try_for_each(|law| check_law(&law, options.self_contact))
    }
}

impl<const D: usize> Multipliers<D> {
    /// Those after an update.
    fn moved_out(&self, gaps: &GapConstraints<D>) -> (Self, Augmentation) {
        let sides = self.sides(gaps);
        let (mut next, mut past, mut found) = (Vec::new(), Vec::new(), Augmentation::default());
        let (mut work, mut force) = (0.0, 0.0);
        let mut open: BTreeMap<_, f64> = self.list().iter().map(|one| ((one.node, one.partners), one.shift)).collect();
        for row in 0..gaps.gaps.len() {
            let (node, partners, area) = (gaps.nodes[row], gaps.partners[row], gaps.areas[row]);
            let is_mine = sides.get(&sorted(partners)).is_none_or(|second| *second == (partners[0] > partners[1]));
            let away = Vector::from(gaps.away[row]);
            if !(area > 0.0 && is_mine && away.norm() > 0.0) {
                continue;
            }
            let (mean, before) = (gaps.gaps[row] / area, self.shift(node, partners));
            found.penetration = found.penetration.max(-mean);
            found.change = found.change.max(((before - mean).max(0.0) - before).abs());
            let shift = (before - self.pace(node, partners, mean) * mean).max(0.0);
            if before > 0.0 || shift > 0.0 {
                past.push(((node, partners), (before, mean)));
            }
            open.remove(&(node, partners));
            let (pressure, change) = (before.max(shift) * area, ((before - mean).max(0.0) - before).abs());
            (work, force) = (work + pressure * change, force + pressure);
            if shift > 0.0 {
                next.push(Multiplier { node, partners, shift, towards: (-away.normalize()).into() });
            }
        }
        found.mean_change = if force > 0.0 { work / force } else { 0.0 };
        found.mean_change = open.values().copied().fold(found.mean_change, f64::max);
        // What is out of reach has opened.
        found.change = open.into_values().fold(found.change, f64::max);
        let mut next: Self = next.into_iter().collect();
        next.remember(past, sides);
        (next, found)
    }

    /// Of two bodies, whether the second has the multipliers: as before, or the one with more nodes there, of equals the first.
    fn sides(&self, gaps: &GapConstraints<D>) -> BTreeMap<[Partner; 2], bool> {
        let mut counts: BTreeMap<[Partner; 2], [usize; 2]> = BTreeMap::new();
        for (partners, _) in gaps.partners.iter().zip(&gaps.areas).filter(|(_, area)| **area > 0.0) {
            if let [Partner::Body(_), Partner::Body(_)] = partners {
                counts.entry(sorted(*partners)).or_default()[usize::from(partners[0] > partners[1])] += 1;
            }
        }
        let mut sides = self.known_sides();
        for (pair, [first, second]) in counts {
            sides.entry(pair).or_insert(second > first);
        }
        sides
    }
}
