//! Rates of energy and forces along a direction: against differences, and against the derivatives of which they are the transpose.

#[path = "../scene/scene.rs"]
mod scene;

mod of_bodies;
mod of_friction;
mod of_obstacles;
mod refused;

use fmc_contact::contact::{Directions, FacetSlip, GradientRequest};
use fmc_contact::{Contact, ContactForces};
use fmc_shapes::Splitmix;

/// By their size, between central differences and rates: of forces rounded to 1e-16 by a step of 1e-6 or 1e-7 of the size of the bodies,
/// on facets of a tenth of it. Of two steps the better one, since slopes jump where a facet passes an edge within a step.
const WITHIN: f64 = 1e-7;

fn random_rows<const D: usize>(count: usize, seed: u64) -> Vec<[f64; D]> {
    let mut random = Splitmix::new(seed);
    (0..count).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect()
}

fn moved<const D: usize>(x: &[[f64; D]], by: f64, along: &[[f64; D]]) -> Vec<[f64; D]> {
    x.iter().zip(along).map(|(x, v)| std::array::from_fn(|i| x[i] + by * v[i])).collect()
}

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum()
}

/// Rates are those of differences of `at`, and the transpose of `vjp`.
fn agrees<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    along: &Directions<D>,
    at: impl FnMut(f64) -> ContactForces<D>,
) {
    is_slope(contact, coords, along, at, WITHIN);
    is_transpose(contact, coords, along);
}

fn is_slope<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    along: &Directions<D>,
    mut at: impl FnMut(f64) -> ContactForces<D>,
    within: f64,
) {
    let found = contact.jvp(coords, along).expect("rates");
    let size = found.forces.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    assert!(size > 0.0, "nothing moves: {along:?}");
    let mut error = |h: f64| {
        let (up, down) = (at(h), at(-h));
        let of_energy = ((up.energy - down.energy) / (2.0 * h) - found.energy).abs();
        let ends = up.forces.iter().flatten().zip(down.forces.iter().flatten());
        let of_forces = ends.map(|(up, down)| (up - down) / (2.0 * h)).zip(found.forces.iter().flatten());
        let worst = of_forces.map(|(slope, rate)| (slope - rate).abs()).fold(0.0, f64::max);
        // Energies are forces by lengths of the size of one.
        (worst / size).max(of_energy / found.energy.abs().max(size))
    };
    let off = error(1e-6).min(error(1e-7));
    assert!(off < within, "{off:e}: {along:?}");
}

/// adjoint · (J d) = (Jᵀ adjoint) · d, but for rounding: of sums of some thousand terms.
fn is_transpose<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], along: &Directions<D>) {
    let found = contact.jvp(coords, along).expect("rates");
    let (adjoint, of_energy) = (random_rows::<D>(coords.len(), 91), 0.7);
    let moves = |of_all: f64, of_one: fn(&fmc_contact::contact::PairGradient) -> f64| {
        of_all != 0.0 || along.pairs.iter().any(|pair| of_one(pair) != 0.0)
    };
    let request = GradientRequest {
        coords: along.coords.is_some(),
        positions: along.positions.is_some(),
        rotations: along.rotations.is_some(),
        stiffness: moves(along.stiffness, |pair| pair.stiffness),
        gap_offsets: moves(along.gap_offset, |pair| pair.gap_offset),
        friction: moves(along.friction, |pair| pair.friction),
        slip: !along.slip.is_empty(),
        ..GradientRequest::default()
    };
    let back = contact.vjp(coords, of_energy, Some(&adjoint), &request).expect("derivatives");
    let mut terms = vec![
        dot(&back.coords, along.coords.unwrap_or(&[])),
        dot(&back.positions, along.positions.unwrap_or(&[])),
        dot(&back.rotations, along.rotations.unwrap_or(&[])),
        product(&back.slip, along.slip),
    ];
    for pair in &back.pairs {
        let own = |of: fn(&fmc_contact::contact::PairGradient) -> f64| {
            along.pairs.iter().filter(|rates| rates.partners == pair.partners).map(of).sum::<f64>()
        };
        terms.push(pair.stiffness * (along.stiffness + own(|rates| rates.stiffness)));
        terms.push(pair.gap_offset * (along.gap_offset + own(|rates| rates.gap_offset)));
        terms.push(pair.friction * (along.friction + own(|rates| rates.friction)));
    }
    let (there, here) = (terms.iter().sum::<f64>(), of_energy * found.energy + dot(&adjoint, &found.forces));
    let size: f64 = adjoint.iter().flatten().zip(found.forces.iter().flatten()).map(|(a, f)| (a * f).abs()).sum();
    assert!(size > 0.0 && (here - there).abs() < 1e-12 * size, "{here} {there} {along:?}");
}

fn product<const D: usize>(factors: &[FacetSlip<D>], slip: &[FacetSlip<D>]) -> f64 {
    let same = |one: &FacetSlip<D>, other: &FacetSlip<D>| {
        (one.facet, one.partner, one.is_second) == (other.facet, other.partner, other.is_second)
    };
    let of_one = |one: &FacetSlip<D>| {
        let other = slip.iter().find(|other| same(one, other));
        other.map_or(0.0, |other| (0..D).map(|i| one.slip[i] * other.slip[i]).sum())
    };
    factors.iter().map(of_one).sum()
}
