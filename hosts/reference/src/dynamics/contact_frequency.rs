//! How stiff the contact is, as the leapfrog scheme feels it: a bound of ω_c, ω_c² the largest eigenvalue of M⁻¹K_c.
//!
//! **w = k Vᵐ.** K_c = w''(V) g gᵀ + w'(V) ∂²V, g = ∂V/∂x, per pair. The first part has rank one, and M⁻¹ w'' g gᵀ has
//! the single eigenvalue w'' Σ_i |g_i|²/m_i with w'' = k m (m − 1) V^(m−2). Several pairs add up at most. The second
//! part comes from the edge of the contact area, which moves; it has no bound (facets that come to lie in one plane
//! enter the overlap at once), but the force that can jump there is at most w' times a facet, and w' goes to zero with
//! V where m > 1. It is left out, and the total energy shows its effect. For 1 ≤ m < 2 the first part has no bound
//! either: at V = 0 the traction jumps (m = 1) or rises with a vertical slope.
//!
//! Before bodies meet, V and g are not known. For m = 2, w'' = 2k whatever V, and |g_i| is at most the area A_i that
//! node i has on the surface, since g_i = ∫ N_i n dA over the part of the surface inside the other body. So
//! ω_c² ≤ 2k Σ A_i²/m_i over all surface nodes of both bodies, which is safe, and by a factor too large.
//!
//! **w = Σ ω ψ(L).** A line that leaves two facets at barycentric N_a, N_b, tilted by c = |d·n|, adds the blocks
//! ω ψ'' ∇_aL ∇_bLᵀ with |∇_aL| = N_a/c. The sum of a row's blocks bounds the eigenvalues (Gershgorin, by blocks): with
//! Σ_b |∇_bL| = 1/c + 1/c' over both sides and Σ ω N_a/c = A_a, the area of surface of node a,
//! ω_c² ≤ max_a (1/c + 1/c') ψ'' A_a / m_a: 2 k A_a/m_a between two bodies and k A_a/m_a against an obstacle where the
//! lines run along the normals, as they are made to. It needs no more than the mesh. The part ψ' ∂²L is smaller by
//! L over the size of a facet and left out.
//!
//! **Friction.** The stick is a spring k_T across the normal: of the blocks k n nᵀ + k_T (I − n nᵀ) the stiffer counts.
//!
//! **w = k/2 ∫ (g_A + g_B) dx.** Where flat faces meet, each side has half of k by the facets of the other: the sum of a row's
//! blocks is 2 k A_a/m_a, as with lines along the normal. Deep in a body its inner nodes bear a part, whose share of
//! surface is that of the partner and not known beforehand. So the bound is raised to what the tangent has where there is
//! contact, which the depth law has in closed form without a step.

use super::surface_area::surface_areas;
use fmc_contact::contact::{EnergyProfile, PenetrationLaw};
use fmc_contact::{Contact, EnergyLaw, Error};

/// Bound of ω_c whatever the bodies do; `None` where the law has none.
pub(super) fn before_contact<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    inverse_mass: &[[f64; D]],
) -> Option<f64> {
    match contact.options().law {
        EnergyLaw::Volume { stiffness: k, exponent: 2.0 } => {
            let areas = surface_areas(contact.surface(), coords);
            let mobility: f64 = areas.iter().zip(inverse_mass).map(|(a, w)| a * a * largest(w)).sum();
            Some((2.0 * k * partner_count(contact) * mobility).sqrt())
        }
        EnergyLaw::Depth { stiffness: k } => Some(by_area(contact, coords, inverse_mass, k)),
        EnergyLaw::Fiber(PenetrationLaw { stiffness: k, profile }) => {
            let steepest = match profile {
                EnergyProfile::Linear { smoothing_length } => k / smoothing_length,
                _ => k,
            };
            Some(by_area(contact, coords, inverse_mass, steepest))
        }
        _ => None,
    }
}

/// Bound for a pressure that grows with the penetration by `steepest` at most.
fn by_area<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], inverse_mass: &[[f64; D]], steepest: f64) -> f64 {
    let meets_bodies = contact.surface().body_count() > 1 || contact.options().self_contact;
    let sides = if meets_bodies { 2.0 } else { 1.0 };
    let friction = contact.options().friction;
    let stick = friction.stiffness.filter(|_| friction.is_active()).unwrap_or(0.0);
    let steepest = steepest.max(stick);
    let areas = surface_areas(contact.surface(), coords);
    let mobility = areas.iter().zip(inverse_mass).map(|(a, w)| a * largest(w)).fold(0.0, f64::max);
    (sides * steepest * mobility).sqrt()
}

/// Pairs that a body can be in.
fn partner_count<const D: usize>(contact: &Contact<D>) -> f64 {
    let itself = usize::from(contact.options().self_contact);
    (contact.surface().body_count() - 1 + contact.obstacle_count() + itself) as f64
}

fn largest<const D: usize>(weights: &[f64; D]) -> f64 {
    weights.iter().copied().fold(0.0, f64::max)
}

/// Bound of ω_c at `coords`; `None` where the law has none.
pub(super) fn in_contact<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    inverse_mass: &[[f64; D]],
) -> Result<Option<f64>, Error> {
    let (k, m) = match contact.options().law {
        EnergyLaw::Volume { stiffness: k, exponent: m } if m >= 2.0 => (k, m),
        EnergyLaw::Volume { .. } => return Ok(None),
        EnergyLaw::Depth { .. } => {
            let masses: Vec<f64> = inverse_mass.iter().map(|weights| 1.0 / largest(weights)).collect();
            let of_tangent = 2.0 / contact.stable_step(coords, &masses)?;
            let beforehand = before_contact(contact, coords, inverse_mass);
            return Ok(beforehand.map(|bound| bound.max(of_tangent)));
        }
        _ => return Ok(before_contact(contact, coords, inverse_mass)),
    };
    let mut squared = 0.0;
    for overlap in contact.overlaps(coords)? {
        if overlap.volume <= 0.0 {
            continue;
        }
        let mut mobility = 0.0;
        // A node that both sides share appears twice, one after the other; its gradient is the sum.
        let entries: Vec<_> = overlap.nodes.iter().zip(&overlap.gradient).collect();
        for same in entries.chunk_by(|a, b| a.0 == b.0) {
            let weights = inverse_mass[*same[0].0 as usize];
            for axis in 0..D {
                let g: f64 = same.iter().map(|(_, gradient)| gradient[axis]).sum();
                mobility += g * g * weights[axis];
            }
        }
        squared += k * m * (m - 1.0) * overlap.volume.powf(m - 2.0) * mobility;
    }
    Ok(Some(squared.sqrt()))
}
