//! The partners of a contact.

use super::bearing_rules::{BearingRule, BearingRules, MeshHashes};
use super::layers::{LayerLaws, LayerStiffness};
use super::obstacles::Obstacles;
use super::pair_options::PairOptions;
use super::pair_table::PairTable;
use super::parallel::Parallel;
use crate::Error;
use crate::contact::friction::{Friction, Orthotropy, OwnFriction};
use crate::contact::laws::{EnergyLaw, PairLaw};
use crate::contact::method::{Method, Options};
use crate::geometry::Pose;
use crate::geometry::shapes::ImplicitShape;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Obstacles, and the pairs that have options of their own.
pub(crate) struct Partners<const D: usize> {
    pub(crate) obstacles: Obstacles<D>,
    pub(crate) table: PairTable<D>,
    /// Laws of the host by which pairs slide, of those whose options say so.
    friction_laws: BTreeMap<[Partner; 2], OwnFriction>,
    /// Laws of the pairs that have no stiffness of their own, where the options have none either.
    layers: Option<LayerLaws<D>>,
}

impl<const D: usize> Partners<D> {
    pub(crate) fn new() -> Self {
        Self { obstacles: Obstacles::new(), table: PairTable::new(), friction_laws: BTreeMap::new(), layers: None }
    }

    /// Takes an obstacle out, with the options of its pairs.
    pub(crate) fn remove_obstacle(&mut self, obstacle: usize) -> Result<(), Error> {
        self.obstacles.remove(obstacle)?;
        self.table.forget(Partner::Obstacle(obstacle));
        self.friction_laws.retain(|pair, _| !pair.contains(&Partner::Obstacle(obstacle)));
        Ok(())
    }

    pub(crate) fn set_pose(&mut self, obstacle: usize, pose: Pose<D>) -> Result<(), Error> {
        if let Some(rescaled) = self.obstacles.set_pose(obstacle, pose)? {
            self.table.rescale(obstacle, rescaled);
        }
        Ok(())
    }

    /// Sets the options of a pair that was checked.
    pub(crate) fn set_pair_options(
        &mut self,
        pair: [Partner; 2],
        options: Option<PairOptions>,
        of_contact: &Options,
    ) -> Result<(), Error> {
        let parallel = match (options, pair[1]) {
            (Some(PairOptions { gap_offset, .. }), Partner::Obstacle(obstacle)) if gap_offset != 0.0 => {
                Some(Parallel::new(self.obstacles.rigid(obstacle)?, gap_offset))
            }
            _ => None,
        };
        self.table.set(pair, options, parallel, of_contact)
    }

    /// The partners in the order in which pairs have them: bodies before obstacles, each by index.
    pub(crate) fn checked_pair(&self, mut partners: [Partner; 2], body_count: usize) -> Result<[Partner; 2], Error> {
        for partner in partners {
            match partner {
                Partner::Body(body) if body >= body_count => {
                    return Err(Error::BodyOutOfRange { body, count: body_count });
                }
                Partner::Body(_) => {}
                Partner::Obstacle(obstacle) => drop(self.obstacles.rigid(obstacle)?),
            }
        }
        partners.sort_unstable();
        match partners {
            [Partner::Obstacle(_), _] => {
                Err(Error::Unsupported { what: "a pair of two obstacles: they do not act on one another" })
            }
            pair => Ok(pair),
        }
    }

    /// The law that a pair follows.
    pub(crate) fn law_of<'a>(&'a self, pair: &[Partner; 2], method: &'a Method<D>) -> &'a dyn PairLaw<D> {
        match (self.table.law(pair), &self.layers) {
            (Some(own), _) => own,
            (None, Some(layers)) if method.options().law.is_without_stiffness() => layers.law(pair),
            (None, _) => &*method.law,
        }
    }

    /// The stiffness k of the law that a pair follows.
    pub(crate) fn stiffness_of(&self, pair: &[Partner; 2], options: &Options) -> f64 {
        match (self.table.options(pair).and_then(|own| own.law), &self.layers) {
            (Some(own), _) => own.stiffness(),
            (None, Some(layers)) if options.law.is_without_stiffness() => layers.stiffness().of_pair(*pair),
            (None, _) => options.law.stiffness(),
        }
    }

    /// Whether pairs that follow the law of the options have a stiffness, given or found.
    pub(crate) fn has_stiffness(&self, options: &Options) -> bool {
        !options.law.is_without_stiffness() || self.layers.is_some()
    }

    /// Whether there are such pairs among those of so many bodies.
    pub(crate) fn need_stiffness(&self, options: &Options, body_count: usize) -> bool {
        let obstacles = self.obstacles.iter().flatten().count();
        let all = body_count * body_count.saturating_sub(1) / 2 + body_count * obstacles;
        options.self_contact || self.table.need_stiffness(all)
    }

    /// Stiffness of the layers below the surfaces, where it was set.
    pub(crate) fn layer_stiffness(&self) -> Option<&LayerStiffness> {
        self.layers.as_ref().map(LayerLaws::stiffness)
    }

    /// Sets it, or forgets it.
    pub(crate) fn set_layer_stiffness(
        &mut self,
        stiffness: Option<LayerStiffness>,
        body_count: usize,
        law: &EnergyLaw,
    ) -> Result<(), Error> {
        if let Some(near) = &stiffness {
            for (body, partner) in near.near.keys() {
                self.checked_pair([Partner::Body(*body), *partner], body_count)?;
            }
        }
        self.layers = stiffness.map(|stiffness| LayerLaws::new(stiffness, body_count, law)).transpose()?;
        Ok(())
    }

    /// Multiplies it.
    pub(crate) fn stiffen_layers(&mut self, factor: f64, law: &EnergyLaw) -> Result<(), Error> {
        let stiffened = self.layers.as_ref().map(|layers| layers.stiffness().times(factor));
        self.layers = stiffened.map(|layers| LayerLaws::new(layers.clone(), layers.bodies.len(), law)).transpose()?;
        Ok(())
    }

    /// Has the laws of layers follow a law of the options.
    pub(crate) fn take_law(&mut self, law: &EnergyLaw) -> Result<(), Error> {
        self.layers = self.layers.as_ref().map(|layers| layers.with_law(law)).transpose()?;
        Ok(())
    }

    /// The laws that pairs may follow.
    pub(crate) fn laws<'a>(&'a self, method: &'a Method<D>) -> impl Iterator<Item = &'a dyn PairLaw<D>> {
        let of_layers = self.layers.iter().flat_map(LayerLaws::laws);
        std::iter::once(&*method.law).chain(self.table.laws()).chain(of_layers)
    }

    /// Those that pairs of a body may follow.
    pub(crate) fn laws_of<'a>(
        &'a self,
        body: usize,
        method: &'a Method<D>,
    ) -> impl Iterator<Item = &'a dyn PairLaw<D>> {
        let of_layers = self.layers.iter().flat_map(move |layers| layers.laws_of(body));
        std::iter::once(&*method.law).chain(self.table.laws_of(body)).chain(of_layers)
    }

    /// What these laws are.
    pub(crate) fn energy_laws(&self, options: &Options) -> impl Iterator<Item = EnergyLaw> {
        std::iter::once(options.law).chain(self.table.own_laws())
    }

    /// The friction of a pair.
    pub(crate) fn friction_of(&self, pair: &[Partner; 2], options: &Options) -> Friction {
        self.table.friction(pair, options.friction)
    }

    /// By what the facets of a pair bear, of a mesh with these hashes; `None` without friction.
    pub(crate) fn bearing_rule(&self, pair: &[Partner; 2], options: &Options, mesh: MeshHashes) -> Option<BearingRule> {
        BearingRule::new(pair, self.table.options(pair), options, mesh)
    }

    /// The same of all pairs, to compare with later.
    pub(crate) fn bearing_rules(&self, options: &Options, mesh: MeshHashes) -> BearingRules {
        BearingRules { of_pairs: self.table.all_options(), options: *options, mesh }
    }

    /// Whether a pair adds to results.
    pub(crate) fn has(&self, pair: &[Partner; 2], options: &Options) -> bool {
        self.table.has(pair, pair[0] != pair[1] || options.self_contact)
    }

    /// The law of the host by which a pair slides, if it has one.
    pub(crate) fn friction_law(&self, pair: &[Partner; 2]) -> Option<&OwnFriction> {
        self.friction_laws.get(pair)
    }

    /// Sets it, or takes it out.
    pub(crate) fn set_friction_law(&mut self, pair: [Partner; 2], law: Option<OwnFriction>) {
        match law {
            Some(law) => drop(self.friction_laws.insert(pair, law)),
            None => drop(self.friction_laws.remove(&pair)),
        }
    }

    /// How its limits are by direction, where they are not the same in all.
    pub(crate) fn orthotropy_of(&self, pair: &[Partner; 2], options: &Options) -> Option<Orthotropy> {
        self.table.orthotropy(pair, options.friction)
    }

    /// Whether any pair has friction.
    pub(crate) fn has_friction(&self, options: &Options) -> bool {
        options.friction.is_active() || self.table.has_friction()
    }

    /// Whether the other side of a pair is a signed distance function.
    pub(crate) fn is_marched(&self, pair: &[Partner; 2]) -> bool {
        let shape = match (pair[1], self.table.parallel(pair)) {
            (Partner::Body(_), _) => None,
            (Partner::Obstacle(_), Some(parallel)) => Some(&parallel.shape),
            (Partner::Obstacle(obstacle), None) => {
                self.obstacles.get(obstacle).and_then(|rigid| rigid.solid().implicit())
            }
        };
        shape.is_some_and(ImplicitShape::is_function)
    }
}
