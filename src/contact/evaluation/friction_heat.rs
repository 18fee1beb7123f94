//! Where friction heats the bodies.

use super::parts::Contact;
use super::points::Points;
use super::sliding::{check_ready, released, sliding};
use super::walk::for_each_pair;
use crate::Error;
use crate::contact::friction::{SlipFacets, heat_of_released};
use crate::contact::laws::Asked;
use crate::contact::results::FrictionHeat;
use crate::overlap::Partner;

/// By points of the mesh. `effusivities` are those of bodies, then of obstacles; without them both sides of a pair take half.
pub(super) fn friction_heat_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    effusivities: Option<&[f64]>,
) -> Result<FrictionHeat, Error> {
    check_ready(contact)?;
    let mut facets = for_each_pair(contact, coords, |measured| {
        let slides = if contact.history.frozen.is_none() { sliding(contact, coords, measured)? } else { None };
        let Some(sliding) = slides else { return Ok(None) };
        let asked = Asked { slides: true, ..Asked::default() };
        let answer = measured.law.measure(measured, &asked)?;
        answer.map(|answer| SlipFacets::new(measured, &sliding, &answer.points)).transpose()
    })?;
    facets.extend(contact.history.frozen_at(coords.unshifted, &contact.partners.obstacles.poses()));
    let (bodies, obstacles) = (contact.mesh.surface.body_count(), contact.partners.obstacles.count());
    let of_first = |pair: [Partner; 2]| {
        let of = |partner| match partner {
            Partner::Body(body) => effusivities.map_or(1.0, |all| all[body]),
            Partner::Obstacle(obstacle) => effusivities.map_or(1.0, |all| all[bodies + obstacle]),
        };
        let [a, b] = pair.map(of);
        if a + b > 0.0 { a / (a + b) } else { 0.5 }
    };
    let mut heat = vec![0.0; coords.len() + obstacles];
    let mut add = |node: u32, energy: f64| heat[node as usize] += energy;
    facets.iter().for_each(|pair| pair.heat(of_first(pair.partners), &mut add));
    let found: Vec<[Partner; 2]> = facets.iter().map(|pair| pair.partners).collect();
    if let Some(step) = &contact.history.step {
        let without_facets =
            facets.iter().filter(|pair| pair.facets.is_empty()).map(|pair| (pair.partners, pair.released()));
        let all = released(contact, &found)?.into_iter().chain(without_facets);
        for gone in all.filter(|(_, energy)| *energy > 0.0) {
            heat_of_released(gone, &step.slip, &contact.mesh.surface, &mut add);
        }
    }
    let of_obstacles = heat.split_off(coords.len());
    Ok(FrictionHeat { nodes: heat, of_obstacles })
}
