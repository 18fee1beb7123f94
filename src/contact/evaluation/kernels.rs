//! The evaluations.

use super::flux::flux_in;
use super::friction_heat::friction_heat_in;
use super::gradients::gradients_in;
use super::measured::measured_pairs;
use super::parts::Contact;
use super::points::{Points, measured_at};
use super::sliding::{check_ready, sliding};
use super::slip_facets::slip_facets_in;
use super::slopes::slopes_in;
use super::walk::{for_each_pair, for_each_pair_within};
use super::worn_off::{large_wear, worn_off_in};
use crate::Error;
use crate::contact::derivatives::{Along, GradientRequest, Gradients, SlipSeeds, Slopes};
use crate::contact::explicit::largest_step;
use crate::contact::flux::FluxRequest;
use crate::contact::friction::{SlipFacets, Tractions, Undirected};
use crate::contact::laws::{Asked, PairEnergy};
use crate::contact::results::{
    ContactForces, FrictionHeat, GapConstraints, NodalContact, OntoNodes, PairForces, PointOfContact, points_of_contact,
};
use crate::contact::tangents::{Tangent, TangentPart};
use crate::contact::wear::WornOff;
use crate::overlap::normal_lines::estimate as normal_lines;
use crate::overlap::{self, Block, FiberTrace, Overlap, Partner, Patches, Reach, Warning};

/// Facets with friction by pair.
pub(crate) type SlipFacetsByPair<const D: usize> = Vec<SlipFacets<D>>;

/// Patches by pair.
pub(crate) type PatchesByPair<const D: usize> = Vec<([Partner; 2], Patches<D>)>;

/// Which surfaces are measured, all as they are worn.
#[derive(Clone, Copy, PartialEq)]
enum Surfaces {
    /// Where they are.
    True,
    /// Moved out by the multipliers, if there are any.
    Shifted,
}

/// What `work` finds at the points of the straight mesh, as the host's nodes have it.
fn on_points<const D: usize, T: OntoNodes>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    surfaces: Surfaces,
    work: impl FnOnce(&Points<D>) -> Result<T, Error>,
) -> Result<T, Error> {
    contact.history.check_worn()?;
    let unshifted = contact.mesh.points(coords)?;
    let shifted = measured_at(contact, &unshifted, surfaces == Surfaces::Shifted);
    let partners = &contact.partners;
    let slides = partners.has_friction(contact.method.options()) || partners.table.has_wear();
    let slides = shifted.is_some() && slides;
    let vertices = if slides { contact.mesh.surface.points(&unshifted) } else { Vec::new() };
    let found = work(&Points { measured: shifted.as_deref().unwrap_or(&unshifted), unshifted: &unshifted, vertices });
    let Some(division) = contact.mesh.surface.division() else { return found };
    Ok(found.map_err(|error| division.in_host_numbers(error))?.onto_nodes(division))
}

/// What `$work` finds at the points, as the host's nodes have it.
macro_rules! kernel {
    ($(#[$doc:meta])* $public:ident = $work:ident ( $($name:ident : $kind:ty),* ) -> $result:ty, at $at:ident) => {
        $(#[$doc])*
        pub(crate) fn $public<const D: usize>(
            contact: &Contact<D>,
            coords: &[[f64; D]],
            $($name: $kind,)*
        ) -> Result<$result, Error> {
            on_points(contact, coords, Surfaces::$at, |points| $work(contact, points, $($name,)*))
        }
    };
}

kernel! { /// Forces.
evaluate = evaluate_in() -> ContactForces<D>, at Shifted }
kernel! { /// Forces without multipliers.
evaluate_true = evaluate_in() -> ContactForces<D>, at True }
kernel! { /// Forces of interfaces alone.
evaluate_apart = evaluate_apart_in() -> ContactForces<D>, at Shifted }
kernel! { /// Second derivative of the energy.
tangent = tangent_in(part: TangentPart) -> Tangent<D>, at Shifted }
kernel! { /// Forces and second derivative of the energy.
evaluate_tangent = evaluate_tangent_in(part: TangentPart) -> (ContactForces<D>, Tangent<D>), at Shifted }
kernel! { /// Derivatives of energy and forces.
gradients = gradients_in(energy: f64, adjoint: &[f64], slip: &SlipSeeds, request: &GradientRequest) -> Gradients<D>, at Shifted }
kernel! { /// Rates of energy and forces.
slopes = slopes_in(along: &Along) -> Slopes<D>, at Shifted }
kernel! { /// Time step.
stable_step = stable_step_in(masses: &[f64]) -> f64, at Shifted }
kernel! { /// Overlaps of all pairs.
overlaps = overlaps_in() -> Vec<Overlap<D>>, at Shifted }
kernel! { /// Lines that cross an overlap.
trace = trace_in() -> Vec<FiberTrace<D>>, at Shifted }
kernel! { /// The contact at the nodes.
nodal_contact = nodal_contact_in() -> NodalContact<D>, at Shifted }
kernel! { /// The contact points.
contact_points = contact_points_in() -> Vec<PointOfContact<D>>, at Shifted }
kernel! { /// Gaps of the nodes within reach.
gap_constraints = gap_constraints_in(reach: f64) -> GapConstraints<D>, at True }
kernel! { /// Conduction by points.
flux = flux_in(request: &FluxRequest) -> Vec<Block<1>>, at Shifted }
kernel! { /// Heat of friction.
friction_heat = friction_heat_in(effusivities: Option<&[f64]>) -> FrictionHeat, at Shifted }
kernel! { /// What sliding wears off.
worn_off = worn_off_in() -> Vec<WornOff>, at Shifted }
kernel! { /// Facets on which friction acts.
slip_facets = slip_facets_in() -> SlipFacetsByPair<D>, at Shifted }
kernel! { /// Patches of all pairs, for all facets.
patches = patches_in() -> PatchesByPair<D>, at Shifted }

fn evaluate_in<const D: usize>(contact: &Contact<D>, coords: &Points<D>) -> Result<ContactForces<D>, Error> {
    evaluate_with(contact, coords, false)
}

fn evaluate_apart_in<const D: usize>(contact: &Contact<D>, coords: &Points<D>) -> Result<ContactForces<D>, Error> {
    evaluate_with(contact, coords, true)
}

fn evaluate_with<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    apart: bool,
) -> Result<ContactForces<D>, Error> {
    let asked = Asked { energy: true, apart, ..Asked::default() };
    let (answers, tractions) = measured_pairs(contact, coords, &asked)?;
    forces_of(contact, coords, answers.into_iter().filter_map(|answer| answer.energy), &tractions)
}

fn forces_of<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    energies: impl Iterator<Item = PairEnergy<D>>,
    tractions: &[Tractions<D>],
) -> Result<ContactForces<D>, Error> {
    let mut energies: Vec<_> = energies.collect();
    if contact.has_held() {
        energies.sort_by_key(|energy| (energy.overlap.a, energy.overlap.b));
    }
    let mut forces = ContactForces::assemble(
        &contact.mesh.surface,
        contact.partners.obstacles.count(),
        (coords.measured, coords.unshifted),
        &energies,
        tractions,
    )?;
    forces.warnings.extend(contact.mesh.coinciding_faces().iter().map(|found| Warning::CoincidingFaces {
        body: Partner::Body(found.body),
        area: found.area,
        nodes: found.nodes.iter().map(|&node| node as usize).collect(),
    }));
    forces.warnings.extend(unused_smoothing(contact, &forces.pairs));
    forces.warnings.extend(tractions.iter().filter_map(without_direction));
    forces.warnings.extend(tractions.iter().filter_map(|tractions| large_wear(contact, tractions)));
    Ok(if contact.method.options().axisymmetric { forces.without_moments() } else { forces })
}

/// Pairs of two bodies for which the smoothing of surfaces is set, and whose law does not read it.
fn unused_smoothing<const D: usize>(contact: &Contact<D>, pairs: &[PairForces]) -> Vec<Warning> {
    let (Contact { mesh, partners, method, .. }, mut found) = (contact, Vec::new());
    for &PairForces { a, b, .. } in pairs.iter().filter(|_| mesh.is_smoothed()) {
        if a != b && matches!(b, Partner::Body(_)) && !partners.law_of(&[a, b], method).needs_depth() {
            found.push(Warning::UnusedSmoothing { a, b });
        }
    }
    found
}

/// Told of a pair whose friction has a direction that is perpendicular to facets that bear more than walls beside a contact do.
fn without_direction<const D: usize>(tractions: &Tractions<D>) -> Option<Warning> {
    let Undirected { facet, part } = tractions.undirected.filter(|found| found.part > 0.01)?;
    let [a, b] = tractions.partners;
    Some(Warning::NoFrictionDirection { a, b, facet, part })
}

fn tangent_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    part: TangentPart,
) -> Result<Tangent<D>, Error> {
    tangent_with(contact, coords, part, rotates_obstacles(contact))
}

/// Whether the next tangent has the rotations of the obstacles.
fn rotates_obstacles<const D: usize>(contact: &Contact<D>) -> bool {
    let Contact { method, partners, .. } = contact;
    method.obstacle_rotations && !method.options().axisymmetric && partners.obstacles.count() > 0
}

fn tangent_with<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    part: TangentPart,
    rotations: bool,
) -> Result<Tangent<D>, Error> {
    let apart = contact.history.apart_at.as_deref() == Some(coords.unshifted);
    let asked = Asked { tangent: Some(part), rotations, apart, ..Asked::default() };
    let (answers, tractions) = measured_pairs(contact, coords, &asked)?;
    tangent_of(answers.into_iter().filter_map(|answer| answer.tangent), tractions)
}

fn tangent_of<const D: usize>(
    of_laws: impl Iterator<Item = Tangent<D>>,
    tractions: Vec<Tractions<D>>,
) -> Result<Tangent<D>, Error> {
    Tangent::sum(of_laws.chain(tractions.into_iter().map(|tractions| tractions.tangent)).collect()).checked()
}

fn evaluate_tangent_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
    part: TangentPart,
) -> Result<(ContactForces<D>, Tangent<D>), Error> {
    let rotations = rotates_obstacles(contact);
    let asked = Asked { energy: true, tangent: Some(part), rotations, ..Asked::default() };
    let (answers, tractions) = measured_pairs(contact, coords, &asked)?;
    let (energies, tangents): (Vec<_>, Vec<_>) =
        answers.into_iter().map(|answer| (answer.energy, answer.tangent)).unzip();
    let forces = forces_of(contact, coords, energies.into_iter().flatten(), &tractions)?;
    Ok((forces, tangent_of(tangents.into_iter().flatten(), tractions)?))
}

fn stable_step_in<const D: usize>(contact: &Contact<D>, coords: &Points<D>, masses: &[f64]) -> Result<f64, Error> {
    let expected = contact.mesh.surface.unknown_count();
    if masses.len() != expected {
        return Err(Error::Length { array: "masses", expected, found: masses.len() });
    }
    let tangent = tangent_with(contact, coords, TangentPart::Symmetric, false)?;
    let on_nodes = match contact.mesh.surface.division() {
        Some(division) => tangent.onto_nodes(division),
        None => tangent,
    };
    largest_step(&on_nodes, masses)
}

fn overlaps_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<Vec<Overlap<D>>, Error> {
    for_each_pair(contact, coords, |measured| measured.law.overlap(measured))
}

fn trace_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<Vec<FiberTrace<D>>, Error> {
    let traces = for_each_pair(contact, coords, |measured| match measured.law.is_local() {
        true => Ok(measured.contact_points(false)?.map(|points| points.trace(measured.pair))),
        false => measured.estimator.trace(measured.pair).map(Some),
    })?;
    Ok(traces.into_iter().flatten().collect())
}

fn nodal_contact_in<const D: usize>(contact: &Contact<D>, coords: &Points<D>) -> Result<NodalContact<D>, Error> {
    check_ready(contact)?;
    let pairs = for_each_pair(contact, coords, |measured| {
        let sliding = sliding(contact, coords, measured)?;
        let asked = Asked { energy: true, nodal_sums: true, slides: sliding.is_some(), ..Asked::default() };
        let Some(answer) = measured.law.measure(measured, &asked)? else { return Ok(None) };
        let facets = sliding.map(|sliding| SlipFacets::new(measured, &sliding, &answer.points)).transpose()?;
        let friction = facets.map_or_else(Vec::new, |facets| facets.at_nodes(measured.pair, &answer.points));
        Ok(answer.energy.map(|energy| (energy, answer.nodal_sums, friction)))
    })?;
    let surface = &contact.mesh.surface;
    NodalContact::assemble(&surface.shares(coords, contact.method.weighting()), &pairs)
}

fn contact_points_in<const D: usize>(
    contact: &Contact<D>,
    coords: &Points<D>,
) -> Result<Vec<PointOfContact<D>>, Error> {
    check_ready(contact)?;
    let points = for_each_pair(contact, coords, |measured| {
        let sliding = sliding(contact, coords, measured)?;
        let asked = Asked { points: true, slides: sliding.is_some(), ..Asked::default() };
        let Some(answer) = measured.law.measure(measured, &asked)? else { return Ok(None) };
        let facets = sliding.map(|sliding| SlipFacets::new(measured, &sliding, &answer.points)).transpose()?;
        let friction = facets.map(|facets| facets.at_points(measured.pair, &answer.points));
        Ok(Some(points_of_contact(&answer.points, friction.as_deref(), measured.pair)))
    })?;
    Ok(points.into_iter().flatten().collect())
}

fn gap_constraints_in<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    reach: f64,
) -> Result<GapConstraints<D>, Error> {
    if !(reach.is_finite() && reach > 0.0) {
        return Err(Error::NotPositive { name: "reach", value: reach });
    }
    contact.mesh.check_reach(reach)?;
    let gaps = for_each_pair_within(contact, coords, reach, |measured| {
        let gaps = overlap::nodal_gaps(measured.pair, reach)?;
        Ok((!gaps.is_empty()).then_some((measured.pair.partners, gaps)))
    })?;
    GapConstraints::assemble(gaps)
}

fn patches_in<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<PatchesByPair<D>, Error> {
    if !contact.partners.laws(&contact.method).any(|law| law.is_local()) {
        return Ok(Vec::new());
    }
    for_each_pair(contact, coords, |measured| {
        if !measured.law.is_local() {
            return Ok(None);
        }
        let Some(mut patches) = measured.patches(Reach::Everywhere)? else { return Ok(None) };
        patches.spacing = normal_lines::spacing(measured.estimator, measured.pair, &patches)?;
        Ok(Some((measured.pair.partners, patches)))
    })
}
