//! Steps of a contact with friction, with an interface that breaks, or with bodies that slide and do not separate: what is carried from one to
//! the next.

use crate::Error;
use crate::contact::changes::poses::with_poses;
use crate::contact::evaluation::{Contact, kernels, moved_out};
use crate::contact::friction::{
    CarriedSlip, Duals, FacetSlip, FrozenFriction, MovedOut, PastPoints, SliderName, SlipFacets, Step, in_order,
    list_slip, slip_of_list,
};
use crate::contact::history::{Bearings, Begun};
use crate::contact::wear::{Worn, WornFacet};
use crate::geometry::Vector;
use crate::overlap::Partner;
use std::collections::{BTreeMap, BTreeSet};

/// Begins a step at these coordinates. On an error nothing has changed.
pub(crate) fn begin<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.mesh.check_brought(coords)?;
    contact.mesh.surface.check_coords(&contact.mesh.points(coords)?, true)?;
    let points = contact.mesh.points(coords)?;
    let glides = contact.glides.moved_on(&contact.mesh, contact.method.weighting(), &points)?;
    let slip = contact.history.step.as_ref().map_or_else(CarriedSlip::new, |step| step.slip.clone());
    let worn = contact.history.worn.clone().at(&contact.mesh.surface, &points);
    begin_worn(contact, coords, slip, worn)?;
    contact.glides = glides;
    Ok(())
}

/// The same with what is carried into the step, and with what is worn off. On an error nothing has changed.
fn begin_worn<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    slip: CarriedSlip<D>,
    worn: Worn<D>,
) -> Result<(), Error> {
    let before = (contact.history.step.take(), std::mem::replace(&mut contact.history.worn, worn));
    let measure = || {
        let begun = step_at(contact, coords, slip)?;
        contact.history.step = Some(begun.clone());
        Ok((begun, bearings(contact, || kernels::slip_facets(contact, coords))?))
    };
    match measure() {
        Ok((begun, bearings)) => contact.history.begin(begun, bearings),
        Err(error) => {
            (contact.history.step, contact.history.worn) = before;
            return Err(error);
        }
    }
    Ok(())
}

/// Has the slip of pairs that were apart count from here; `is_first`: they touch here, and all others are apart. On an error nothing has changed.
pub(crate) fn touch_first<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    pairs: &BTreeSet<[Partner; 2]>,
    is_first: bool,
) -> Result<(), Error> {
    let moved_out = contact.history.step()?.moved_out.clone();
    let step = step_at(contact, coords, CarriedSlip::new())?.with_moved_out(moved_out);
    contact.history.first_touches.add(pairs, step, is_first);
    contact.history.release_friction();
    Ok(())
}

/// Measures anew how facets bore where the step began, for pairs that press with another stiffness now. The step stays the one that has begun:
/// its coordinates, the poses of its obstacles, its slip. On an error nothing has changed.
pub(crate) fn bear_anew<const D: usize>(contact: &mut Contact<D>) -> Result<(), Error> {
    let step = contact.history.step()?;
    let (coords, poses) = (step.coords.given(), step.poses.clone());
    let found = with_poses(contact, &poses, |contact| bearings(contact, || kernels::slip_facets(contact, &coords)))?;
    contact.history.bear(found);
    Ok(())
}

/// Accepts the step that ends here, and begins the next. On an error nothing has changed.
pub(crate) fn commit<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    contact.history.step()?;
    contact.mesh.check_brought(coords)?;
    let pairs = kernels::slip_facets(contact, coords)?;
    let points = contact.mesh.points(coords)?;
    let damage = contact.at_points(&points, |at| contact.cohesions.damaged(at))?;
    let of_laws = contact.at_points(&points, |at| contact.governed.gone_on(at))?;
    let glides = contact.glides.moved_on(&contact.mesh, contact.method.weighting(), &points)?;
    let slip = pairs.iter().flat_map(SlipFacets::carried).collect();
    let worn_off = if contact.partners.table.has_wear() { kernels::worn_off(contact, coords)? } else { Vec::new() };
    let (surface, worn) = (&contact.mesh.surface, contact.history.worn.clone());
    let worn = worn.grown(surface, &points, contact.method.weighting(), worn_off)?;
    if worn.is_empty() {
        let next = step_at(contact, coords, slip)?;
        let bearings = bearings(contact, || Ok(pairs))?;
        contact.history.begin(next, bearings);
    } else {
        // Facets bear on surfaces that lie elsewhere now, as at the start of a step that begins here.
        begin_worn(contact, coords, slip, worn)?;
    }
    (contact.history.damage, contact.history.of_laws) = (damage, of_laws);
    contact.glides = glides;
    Ok(())
}

/// The elastic slip that was carried into the step.
pub(crate) fn slip<const D: usize>(contact: &Contact<D>) -> Result<Vec<FacetSlip<D>>, Error> {
    Ok(list_slip(&contact.history.step()?.slip))
}

/// Sets it. On an error nothing has changed.
pub(crate) fn set_slip<const D: usize>(contact: &mut Contact<D>, slip: &[FacetSlip<D>]) -> Result<(), Error> {
    let carried = carried_of(contact, slip)?;
    contact.history.set_slip(carried)
}

/// What laws of friction keep, in the order of the slip.
pub(crate) fn friction_history<const D: usize>(contact: &Contact<D>) -> Result<Vec<f64>, Error> {
    let carried = &contact.history.step()?.slip;
    let mut list = Vec::new();
    for name in in_order(carried) {
        let count = history_count(contact, &name);
        let known = &carried[&name].history;
        list.extend((0..count).map(|at| known.get(at).copied().unwrap_or(0.0)));
    }
    Ok(list)
}

/// Sets it. On an error nothing has changed.
pub(crate) fn set_friction_history<const D: usize>(contact: &mut Contact<D>, history: &[f64]) -> Result<(), Error> {
    let mut carried = contact.history.step()?.slip.clone();
    let (mut rest, mut expected) = (history, 0);
    for name in in_order(&carried) {
        let count = history_count(contact, &name);
        let (own, others) = rest.split_at(count.min(rest.len()));
        if let Some(carried) = carried.get_mut(&name) {
            carried.history = own.to_vec();
        }
        (rest, expected) = (others, expected + count);
    }
    if history.len() != expected {
        return Err(Error::Length { array: "history", expected, found: history.len() });
    }
    if let Some(entry) = history.iter().position(|x| !x.is_finite()) {
        return Err(Error::BadEntry { array: "history", entry, value: history[entry] });
    }
    contact.history.set_slip(carried)
}

fn history_count<const D: usize>(contact: &Contact<D>, (pair, ..): &SliderName) -> usize {
    contact.partners.friction_law(pair).map_or(0, |own| own.count)
}

/// A list by slider.
pub(crate) fn carried_of<const D: usize>(contact: &Contact<D>, slip: &[FacetSlip<D>]) -> Result<CarriedSlip<D>, Error> {
    contact.history.step()?;
    let Contact { mesh, partners, .. } = contact;
    let ranges = &mesh.surface.ranges;
    let body_of = |facet: usize| ranges.iter().position(|range| range.contains(&facet));
    slip_of_list(slip, body_of, [ranges.len(), partners.obstacles.count()])
}

/// Sets what is worn off. On an error nothing has changed.
pub(crate) fn set_worn<const D: usize>(contact: &mut Contact<D>, list: &[WornFacet]) -> Result<(), Error> {
    let Contact { mesh, history, .. } = contact;
    if !list.is_empty() {
        mesh.surface.refuse_submesh("worn facets of a mesh in parts")?;
    }
    let worn = Worn::of_list(list, &mesh.surface)?;
    history.worn = match &history.step {
        Some(step) => worn.at(&mesh.surface, step.coords.placed()),
        None => worn,
    };
    history.release_friction();
    Ok(())
}

/// Goes on with a step that was laid aside.
pub(crate) fn take_up<const D: usize>(contact: &mut Contact<D>, begun: Begun<D>) {
    let is_slip_of_law = contact.method.options().friction.has_stiffness_of_law();
    contact.history.take_up(begun, is_slip_of_law);
}

/// Freezes the facets on which friction acts and their pressure. On an error what was frozen before stays.
pub(crate) fn freeze<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    freeze_after(contact, coords, &mut Duals::default(), false)
}

/// The same where a step of an iteration has led to, with the tractions that it asked for, or as if it were the first.
pub(crate) fn freeze_after<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    duals: &mut Duals<D>,
    is_used: bool,
) -> Result<(), Error> {
    contact.history.step()?;
    let mut pairs = kernels::slip_facets(contact, coords)?;
    contact.mesh.check_brought(coords)?;
    duals.take(&mut pairs, is_used);
    let (points, poses) = (past_points(contact, coords)?, contact.partners.obstacles.poses());
    contact.history.frozen = Some(FrozenFriction::new(pairs, points, poses, contact.mesh.epoch()));
    Ok(())
}

/// Has all facets with memory stick here, whatever their limits are, until friction is released. On an error nothing has changed.
pub(crate) fn hold<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]]) -> Result<(), Error> {
    let pairs = kernels::slip_facets(contact, coords)?;
    hold_some(contact, coords, pairs, |_| true)
}

/// What is known of the facets from the last step of an iteration.
#[derive(Clone, Default)]
pub(crate) struct Slid<const D: usize> {
    /// Which way they slid.
    ways: BTreeMap<SliderName, Vector<D>>,
    /// Those that stuck as the one between two ways.
    between: BTreeSet<SliderName>,
}

impl<const D: usize> Slid<D> {
    /// The facets that have to stick: those that slide the other way than before, and of a pair that slides two ways at once, and sticks nowhere,
    /// that which has slid least.
    fn next(&mut self, pairs: &[SlipFacets<D>], is_loose: bool) -> BTreeSet<SliderName> {
        let (before, mut held) = (std::mem::take(&mut self.ways), BTreeSet::new());
        for pair in pairs {
            let (mut least, mut is_everywhere, mut way) = (None, true, None);
            let mut is_two_ways = false;
            for (facet, _, traction) in pair.tractions() {
                let name = (pair.partners, facet.of_b, facet.facet);
                let has_turned = before.get(&name).is_some_and(|way| way.dot(&traction.value) < 0.0);
                if !traction.slides || has_turned {
                    is_everywhere = false;
                    held.extend(has_turned.then_some(name));
                    continue;
                }
                self.ways.insert(name, traction.value);
                is_two_ways |= way.get_or_insert(traction.value).dot(&traction.value) < 0.0;
                let slid = (facet.trial - traction.elastic).norm();
                if !self.between.contains(&name) && least.is_none_or(|(least, _)| slid < least) {
                    least = Some((slid, name));
                }
            }
            if let Some((_, name)) = least.filter(|_| is_loose && is_everywhere && is_two_ways) {
                self.ways.remove(&name);
                self.between.insert(name);
                held.insert(name);
            }
        }
        held
    }
}

/// Has facets stick that have to, until friction is released; whether there is any. `is_loose`: whether bodies are held by
/// friction alone. On an error nothing has changed.
pub(crate) fn hold_turned<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    slid: &mut Slid<D>,
    is_loose: bool,
) -> Result<bool, Error> {
    let pairs = kernels::slip_facets(contact, coords)?;
    let held = slid.next(&pairs, is_loose);
    if !held.is_empty() {
        hold_some(contact, coords, pairs, |name| held.contains(name))?;
    }
    Ok(!held.is_empty())
}

fn hold_some<const D: usize>(
    contact: &mut Contact<D>,
    coords: &[[f64; D]],
    pairs: Vec<SlipFacets<D>>,
    is_held: impl Fn(&SliderName) -> bool,
) -> Result<(), Error> {
    let at = (past_points(contact, coords)?, contact.partners.obstacles.poses(), contact.mesh.epoch());
    contact.history.frozen = Some(FrozenFriction::holding(pairs, at, is_held));
    Ok(())
}

/// A step that begins here.
fn step_at<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], slip: CarriedSlip<D>) -> Result<Step<D>, Error> {
    let Contact { mesh, partners, .. } = contact;
    let points = mesh.points(coords)?;
    let moved = moved_out(contact, &points).map(|moved| MovedOut::new(&mesh.surface, &points, &moved));
    let step = Step::new(&mesh.surface, past_points(contact, coords)?, partners.obstacles.poses(), slip, mesh.epoch());
    Ok(step.with_moved_out(moved))
}

/// Points of the mesh to remember.
fn past_points<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<PastPoints<D>, Error> {
    let mesh = &contact.mesh;
    Ok(PastPoints::new(coords, mesh.surface.mesh_points(coords)?, |points| mesh.placed(points.into())))
}

/// How all facets bear, where any pair has friction; without a stiffness nothing bears yet.
fn bearings<const D: usize>(
    contact: &Contact<D>,
    pairs: impl FnOnce() -> Result<Vec<SlipFacets<D>>, Error>,
) -> Result<Option<Bearings>, Error> {
    let Contact { mesh, partners, method, history, .. } = contact;
    let options = method.options();
    if !partners.has_friction(options) || contact.check_stiffness().is_err() {
        return Ok(None);
    }
    let rules = partners.bearing_rules(options, mesh.hashes());
    let stiffness = (|pair: &[Partner; 2]| partners.stiffness_of(pair, options), history.stiffened);
    Ok(Some(Bearings::new(&pairs()?, stiffness, rules, partners.obstacles.count())))
}
