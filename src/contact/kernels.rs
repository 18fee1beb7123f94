//! The evaluations, each compiled here for the plane and for space: see [`crate::dimension`].

use super::Contact;
use super::fields::{NodalContact, PointOfContact, points_of_contact, points_of_depth};
use super::forces::ContactForces;
use super::gap_constraints::GapConstraints;
use super::laws::{self, EnergyLaw, Measured, PairLaw};
use super::mass_scaled::largest_step;
use super::options::Options;
use super::tangent::{Tangent, TangentPart};
use crate::Error;
use crate::dimension::{recast, rows};
use crate::overlap::{self, FiberTrace, Overlap, OverlapEstimator, Partner, Patches, Reach};
use std::any::Any;

/// Patches by pair.
pub(super) type PatchesByPair<const D: usize> = Vec<([Partner; 2], Patches<D>)>;

/// Hands `$public` over to `$work`, at D = 2 or 3.
macro_rules! kernel {
    ($(#[$doc:meta])* $public:ident = $work:ident ( $($name:ident : $kind:ty),* ) -> $result:ident) => {
        $(#[$doc])*
        pub(super) fn $public<const D: usize>(
            contact: &Contact<D>,
            coords: &[[f64; D]],
            $($name: $kind,)*
        ) -> Result<$result!(D), Error> {
            fn in_plane(contact: &Contact<2>, coords: &[[f64; 2]], $($name: $kind,)*) -> Result<$result!(2), Error> {
                $work(contact, coords, $($name,)*)
            }
            fn in_space(contact: &Contact<3>, coords: &[[f64; 3]], $($name: $kind,)*) -> Result<$result!(3), Error> {
                $work(contact, coords, $($name,)*)
            }
            let any: &dyn Any = contact;
            if let Some(contact) = any.downcast_ref() {
                return recast(in_plane(contact, rows(coords), $($name,)*)?);
            }
            match any.downcast_ref() {
                Some(contact) => recast(in_space(contact, rows(coords), $($name,)*)?),
                None => recast(()),
            }
        }
    };
}

macro_rules! forces { ($d:expr) => { ContactForces<$d> }; }
macro_rules! tangents { ($d:expr) => { Tangent<$d> }; }
macro_rules! both { ($d:expr) => { (ContactForces<$d>, Tangent<$d>) }; }
macro_rules! numbers {
    ($d:expr) => {
        f64
    };
}
macro_rules! overlap_list { ($d:expr) => { Vec<Overlap<$d>> }; }
macro_rules! traces { ($d:expr) => { Vec<FiberTrace<$d>> }; }
macro_rules! nodal { ($d:expr) => { NodalContact<$d> }; }
macro_rules! point_list { ($d:expr) => { Vec<PointOfContact<$d>> }; }
macro_rules! constraint_rows { ($d:expr) => { GapConstraints<$d> }; }
macro_rules! patch_list { ($d:expr) => { PatchesByPair<$d> }; }

kernel! { /// Forces.
evaluate = evaluate_in() -> forces }
kernel! { /// Second derivative of the energy.
tangent = tangent_in(part: TangentPart) -> tangents }
kernel! { /// Forces and second derivative of the energy.
evaluate_with_tangent = evaluate_with_tangent_in(part: TangentPart) -> both }
kernel! { /// Time step.
stable_step = stable_step_in(masses: &[f64]) -> numbers }
kernel! { /// Overlaps of all pairs.
overlaps = overlaps_in() -> overlap_list }
kernel! { /// Lines that cross an overlap.
trace = trace_in() -> traces }
kernel! { /// The contact at the nodes.
nodal_contact = nodal_contact_in() -> nodal }
kernel! { /// The contact points.
contact_points = contact_points_in() -> point_list }
kernel! { /// Gaps of the nodes within reach.
gap_constraints = gap_constraints_in(reach: f64) -> constraint_rows }
kernel! { /// Patches of all pairs, for all facets.
patches = patches_in() -> patch_list }

fn evaluate_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<ContactForces<D>, Error> {
    let pairs = contact.for_each_pair(coords, |measured| measured.law.energy(measured))?;
    ContactForces::assemble(&contact.surface, contact.obstacles.len(), coords, &pairs)
}

fn tangent_in<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    part: TangentPart,
) -> Result<Tangent<D>, Error> {
    let tangents =
        contact.for_each_pair(coords, |measured| measured.law.tangent(measured, part, obstacle_node(measured)))?;
    Tangent::sum(tangents).checked()
}

/// Number of the translation of the pair's obstacle, if it has one, in the tangent.
fn obstacle_node<const D: usize>(measured: &Measured<D>) -> u32 {
    let obstacle = if let Partner::Obstacle(obstacle) = measured.pair.partners[1] { obstacle } else { 0 };
    (measured.pair.coords.len() + obstacle) as u32
}

fn evaluate_with_tangent_in<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    part: TangentPart,
) -> Result<(ContactForces<D>, Tangent<D>), Error> {
    let found = contact.for_each_pair(coords, |measured| {
        let found = measured.law.energy_and_tangent(measured, part, obstacle_node(measured))?;
        Ok((found.0.is_some() || found.1.is_some()).then_some(found))
    })?;
    let (energies, tangents): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    let energies: Vec<_> = energies.into_iter().flatten().collect();
    let forces = ContactForces::assemble(&contact.surface, contact.obstacles.len(), coords, &energies)?;
    Ok((forces, Tangent::sum(tangents.into_iter().flatten().collect()).checked()?))
}

fn stable_step_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], masses: &[f64]) -> Result<f64, Error> {
    largest_step(&tangent_in(contact, coords, TangentPart::Full)?, masses)
}

fn overlaps_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<Vec<Overlap<D>>, Error> {
    contact.for_each_pair(coords, |measured| measured.law.overlap(measured))
}

fn trace_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<Vec<FiberTrace<D>>, Error> {
    let traces = contact.for_each_pair(coords, |measured| match measured.law.is_local() {
        true => Ok(measured.contact_points(false)?.map(|points| points.trace(measured.pair))),
        false => measured.estimator.trace(measured.pair).map(Some),
    })?;
    Ok(traces.into_iter().flatten().collect())
}

fn nodal_contact_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<NodalContact<D>, Error> {
    let pairs = contact.for_each_pair(coords, |measured| measured.law.energy_and_nodal_sums(measured))?;
    NodalContact::assemble(coords.len(), &pairs)
}

fn contact_points_in<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
) -> Result<Vec<PointOfContact<D>>, Error> {
    let points = contact.for_each_pair(coords, |measured| {
        let (law, pair) = (measured.law, measured.pair);
        let pressure = |penetration: f64| law.pressure_at(penetration);
        Ok(match () {
            () if law.is_local() => {
                measured.contact_points(false)?.map(|found| points_of_contact(&found, pair, pressure))
            }
            () if law.needs_depth() => Some(points_of_depth(&measured.estimator.depth_points(pair)?, pair, pressure)),
            () => None,
        })
    })?;
    Ok(points.into_iter().flatten().collect())
}

fn gap_constraints_in<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    reach: f64,
) -> Result<GapConstraints<D>, Error> {
    let gaps = contact.for_each_pair_within(coords, reach, |measured| {
        let gaps = overlap::nodal_gaps(measured.pair, reach)?;
        Ok((!gaps.is_empty()).then_some((measured.pair.partners, gaps)))
    })?;
    GapConstraints::assemble(gaps)
}

fn patches_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<PatchesByPair<D>, Error> {
    if !contact.laws().any(|law| law.is_local()) {
        return Ok(Vec::new());
    }
    contact.for_each_pair(coords, |measured| {
        if !measured.law.is_local() {
            return Ok(None);
        }
        let Some(mut patches) = measured.patches(Reach::Everywhere)? else { return Ok(None) };
        patches.spacing = measured.estimator.spacing(measured.pair, &patches)?;
        Ok(Some((measured.pair.partners, patches)))
    })
}

/// The estimator that the options name.
pub(super) fn estimator<const D: usize>(options: &Options) -> Result<Box<dyn OverlapEstimator<D>>, Error> {
    fn in_plane(options: &Options) -> Box<dyn OverlapEstimator<2>> {
        overlap::estimator(&options.estimator)
    }
    fn in_space(options: &Options) -> Box<dyn OverlapEstimator<3>> {
        overlap::estimator(&options.estimator)
    }
    if D == 2 { recast(in_plane(options)) } else { recast(in_space(options)) }
}

/// The law as pairs follow it.
pub(super) fn pair_law<const D: usize>(law: &EnergyLaw) -> Result<Box<dyn PairLaw<D>>, Error> {
    fn in_plane(law: &EnergyLaw) -> Box<dyn PairLaw<2>> {
        laws::pair_law(law)
    }
    fn in_space(law: &EnergyLaw) -> Box<dyn PairLaw<3>> {
        laws::pair_law(law)
    }
    if D == 2 { recast(in_plane(law)) } else { recast(in_space(law)) }
}
