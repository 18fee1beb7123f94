//! Stiffness of pairs for which none is given: that of the layers of cells below both surfaces.

use crate::Error;
use crate::contact::laws::{EnergyLaw, PairLaw, pair_law};
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Stiffness of a pair by that of the softer of its two layers. By 7.5 a confined body of compression modulus M and cells of height h
/// has k = 7.5 M/h, which for ν = 0.3 are ten times E/h.
const BY_LAYER: f64 = 7.5;

/// How stiff the layer of cells below the surface of bodies is, a force by area and displacement (Pa/length): v·K v / A, where K is the
/// bodies' stiffness, v the outward unit normal at the nodes of the surface and zero elsewhere, and A the area that these nodes stand for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LayerStiffness {
    /// Of the whole surface, by body.
    pub bodies: Vec<f64>,
    /// Of the part of a body's surface that is near a partner.
    pub near: BTreeMap<(usize, Partner), f64>,
}

/// The laws of pairs, made from it.
pub(crate) struct LayerLaws<const D: usize> {
    stiffness: LayerStiffness,
    by_body: Vec<Box<dyn PairLaw<D>>>,
    by_pair: BTreeMap<[Partner; 2], Box<dyn PairLaw<D>>>,
}

impl LayerStiffness {
    fn check(&self, body_count: usize) -> Result<(), Error> {
        if self.bodies.len() != body_count {
            return Err(Error::Length { array: "bodies", expected: body_count, found: self.bodies.len() });
        }
        let all = self.bodies.iter().chain(self.near.values()).copied();
        match all.into_iter().find(|value| !(value.is_finite() && *value > 0.0)) {
            Some(value) => Err(Error::NotPositive { name: "layer stiffness", value }),
            None => Ok(()),
        }
    }

    /// Bodies of which a pair gets the softer one's value as its stiffness k.
    pub(crate) fn from_pairs(values: Vec<f64>) -> Self {
        let bodies = values.into_iter().map(|value| value / BY_LAYER).collect();
        Self { bodies, near: BTreeMap::new() }
    }

    pub(crate) fn times(&self, factor: f64) -> Self {
        let near = self.near.iter().map(|(key, value)| (*key, factor * value)).collect();
        Self { bodies: self.bodies.iter().map(|value| factor * value).collect(), near }
    }

    /// That of a body's layer towards a partner.
    fn towards(&self, body: usize, partner: Partner) -> f64 {
        self.near.get(&(body, partner)).copied().unwrap_or(self.bodies[body])
    }

    /// Stiffness k of a pair, pressure by penetration.
    pub fn of_pair(&self, pair: [Partner; 2]) -> f64 {
        let of = |one, other| match one {
            Partner::Body(body) => self.towards(body, other),
            Partner::Obstacle(_) => f64::INFINITY,
        };
        BY_LAYER * of(pair[0], pair[1]).min(of(pair[1], pair[0]))
    }
}

impl<const D: usize> LayerLaws<D> {
    pub(crate) fn new(stiffness: LayerStiffness, body_count: usize, law: &EnergyLaw) -> Result<Self, Error> {
        stiffness.check(body_count)?;
        let with = |k: f64| pair_law(&law.with_stiffness(k));
        let by_body = stiffness.bodies.iter().map(|layer| with(BY_LAYER * layer)).collect();
        let sorted = |(body, partner): &(usize, Partner)| {
            let mut pair = [Partner::Body(*body), *partner];
            pair.sort_unstable();
            pair
        };
        let by_pair = stiffness.near.keys().map(sorted).map(|pair| (pair, with(stiffness.of_pair(pair)))).collect();
        Ok(Self { stiffness, by_body, by_pair })
    }

    /// The same with another law.
    pub(crate) fn with_law(&self, law: &EnergyLaw) -> Result<Self, Error> {
        Self::new(self.stiffness.clone(), self.stiffness.bodies.len(), law)
    }

    pub(crate) fn stiffness(&self) -> &LayerStiffness {
        &self.stiffness
    }

    pub(crate) fn laws(&self) -> impl Iterator<Item = &dyn PairLaw<D>> {
        self.by_body.iter().chain(self.by_pair.values()).map(|law| &**law)
    }

    /// Those that pairs of a body may follow.
    pub(crate) fn laws_of(&self, body: usize) -> impl Iterator<Item = &dyn PairLaw<D>> {
        let of_pairs = self.by_pair.iter().filter(move |(pair, _)| pair.contains(&Partner::Body(body)));
        self.by_body.get(body).into_iter().chain(of_pairs.map(|(_, law)| law)).map(|law| &**law)
    }

    /// The law of a pair, sorted.
    pub(crate) fn law(&self, pair: &[Partner; 2]) -> &dyn PairLaw<D> {
        if let Some(law) = self.by_pair.get(pair) {
            return &**law;
        }
        let bodies = pair.iter().filter_map(|partner| match partner {
            Partner::Body(body) => Some(*body),
            Partner::Obstacle(_) => None,
        });
        let layers = &self.stiffness.bodies;
        let softest = bodies.min_by(|a, b| layers[*a].total_cmp(&layers[*b]).then(a.cmp(b)));
        &*self.by_body[softest.unwrap_or(0)]
    }
}
