//! Steps of a contact with friction, with an interface that breaks, or with bodies that slide and do not separate: what is carried from one to
//! the next.

use crate::Error;
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::friction::{
    CarriedSlip, FacetSlip, FrozenFriction, PastPoints, SlipFacets, Step, list_slip, slip_of_list,
};
use crate::contact::history::{Bearings, Begun};

/// Begins a step at these coordinates. On an error nothing has changed.
pub(crate) fn begin<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.mesh.check_brought(coords)?;
    contact.mesh.surface.check_coords(&contact.mesh.points(coords)?, true)?;
    let glides = contact.glides.moved_on(&contact.mesh, contact.method.weighting(), &contact.mesh.points(coords)?)?;
    let before = contact.history.step.take();
    let slip = before.as_ref().map_or_else(CarriedSlip::new, |step| step.slip.clone());
    let begun = step_at(contact, coords, slip)?;
    contact.history.step = Some(begun.clone());
    match bearings(contact, || kernels::slip_facets(contact, coords)) {
        Ok(bearings) => contact.history.begin(begun, bearings),
        Err(error) => {
            contact.history.step = before;
            return Err(error);
        }
    }
    contact.glides = glides;
    Ok(())
}

/// Accepts the step that ends here, and begins the next. On an error nothing has changed.
pub(crate) fn commit<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.history.step()?;
    contact.mesh.check_brought(coords)?;
    let pairs = kernels::slip_facets(contact, coords)?;
    let points = contact.mesh.points(coords)?;
    let damage = contact.cohesions.damaged(&points, &contact.history.damage)?;
    let glides = contact.glides.moved_on(&contact.mesh, contact.method.weighting(), &points)?;
    let slip = pairs.iter().flat_map(SlipFacets::carried).collect();
    let next = step_at(contact, coords, slip)?;
    let bearings = bearings(contact, || Ok(pairs))?;
    contact.history.begin(next, bearings);
    contact.history.damage = damage;
    contact.glides = glides;
    Ok(())
}

/// The elastic slip that was carried into the step.
pub(crate) fn slip<const D: usize>(contact: &Contact<D>) -> Result<Vec<FacetSlip<D>>, Error> {
    Ok(list_slip(&contact.history.step()?.slip))
}

/// Sets it. On an error nothing has changed.
pub(crate) fn set_slip<const D: usize>(contact: &mut Contact<D>, slip: &[FacetSlip<D>]) -> Result<(), Error> {
    contact.history.step()?;
    let Contact { mesh, partners, .. } = contact;
    let ranges = &mesh.surface.ranges;
    let body_of = |facet: usize| ranges.iter().position(|range| range.contains(&facet));
    let carried = slip_of_list(slip, body_of, [ranges.len(), partners.obstacles.count()])?;
    contact.history.set_slip(carried)
}

/// Goes on with a step that was laid aside.
pub(crate) fn take_up<const D: usize>(contact: &mut Contact<D>, begun: Begun<D>) {
    let is_slip_of_law = contact.method.options().friction.has_stiffness_of_law();
    contact.history.take_up(begun, is_slip_of_law);
}

/// Freezes the facets on which friction acts and their pressure. On an error what was frozen before stays.
pub(crate) fn freeze<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.history.step()?;
    let pairs = kernels::slip_facets(contact, coords)?;
    contact.mesh.check_brought(coords)?;
    let (points, poses) = (past_points(contact, coords)?, contact.partners.obstacles.poses());
    contact.history.frozen = Some(FrozenFriction::new(pairs, points, poses, contact.mesh.epoch()));
    Ok(())
}

/// A step that begins here.
fn step_at<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], slip: CarriedSlip<D>) -> Result<Step<D>, Error> {
    let Contact { mesh, partners, .. } = contact;
    Ok(Step::new(&mesh.surface, past_points(contact, coords)?, partners.obstacles.poses(), slip, mesh.epoch()))
}

/// Points of the mesh to remember.
fn past_points<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<PastPoints<D>, Error> {
    let mesh = &contact.mesh;
    Ok(PastPoints::new(mesh.surface.mesh_points(coords)?.into_owned(), |points| mesh.placed(points.into())))
}

/// How all facets bear, where any pair has friction; without a stiffness nothing bears yet.
fn bearings<const D: usize>(
    contact: &Contact<D>,
    pairs: impl FnOnce() -> Result<Vec<SlipFacets<D>>, Error>,
) -> Result<Option<Bearings>, Error> {
    let Contact { mesh, partners, method, .. } = contact;
    let options = method.options();
    if !partners.has_friction(options) || partners.check_stiffness(options).is_err() {
        return Ok(None);
    }
    let rules = partners.bearing_rules(options, mesh.hashes());
    Ok(Some(Bearings::new(&pairs()?, rules, partners.obstacles.count())))
}
