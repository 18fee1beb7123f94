//! Derivatives of what sliders do: of their forces on nodes, and of the elastic slip s₁ that they carry on.
//!
//! With coordinates held, areas, directions and the slip of the step are. What is left is one traction q for each slider, a function
//! of its trial slip s and its limit τ:
//!
//! ```text
//! J = a · F + b · s₁ = Σ w_F · q + w_s · q / k_T        w_F = −A Σ B a, over the nodes that move it; w_s = ± b
//! s = c R e + …      e: slip carried into the step, R: turned along with its facet, c: part of it that stays
//! ∂J/∂e = c Rᵀ (∂q/∂s)ᵀ (w_F + w_s / k_T)
//! ```
//!
//! By the stiffness k of a law: limits grow with it, and k_T where that is k. Then q is k times a function of s, and s₁ does not change.

use super::directions::Along;
use super::gradients::Gradients;
use super::request::{GradientRequest, Seeds};
use crate::Error;
use crate::contact::friction::{
    CarriedSlip, SliderName, SlipFacet, SlipFacets, Stick, Traction, carried_slip, list_slip,
};
use crate::contact::method::Method;
use crate::contact::partners::Partners;
use crate::geometry::Vector;
use crate::overlap::Partner;

/// Adds what the sliders of all pairs have to the derivatives by what was carried into the step, and by what pairs have.
///
/// # Errors
/// [`Error::Unsupported`] for what is not known.
pub(crate) fn add_sliders<const D: usize>(
    (partners, method): (&Partners<D>, &Method<D>),
    pairs: &[SlipFacets<D>],
    (seeds, request): (&Seeds<D>, &GradientRequest),
    gradients: &mut Gradients<D>,
) -> Result<(), Error> {
    let mut by_slip = CarriedSlip::new();
    for pair in pairs {
        let by_stiffness = request.stiffness && seeds.reaches_friction();
        let is_of_law =
            check_pair(&pair.partners, (partners, method), request.slip || !seeds.slip.is_empty(), by_stiffness)?;
        let (mut stiffness, mut friction) = (0.0, 0.0);
        for (facet, rows, traction) in pair.tractions() {
            let name: SliderName = (pair.partners, facet.of_b, facet.facet);
            let sign = if facet.of_b { -1.0 } else { 1.0 };
            let mut of_force = Vector::<D>::zeros();
            for row in rows.iter().filter(|row| !row.mover.turns) {
                if let Some(a) = seeds.forces.and_then(|a| a.get(row.mover.node as usize)) {
                    of_force -= row.slip * Vector::from(*a) * facet.area;
                }
            }
            let of_slip = match (facet.slider.stick, seeds.slip.get(&name)) {
                (Stick::Spring(stiffness), Some(b)) => Vector::from_fn(|i, _| sign * b[i] / stiffness),
                _ => Vector::zeros(),
            };
            let limited = limited(facet, &traction);
            stiffness += match grows_as_law(facet, is_of_law) {
                true => of_force.dot(&traction.value),
                false => (of_force + of_slip).dot(&limited),
            };
            friction += of_slip.dot(&limited);
            if request.slip {
                by_slip.insert(
                    name,
                    carried_slip(facet.by_carried(&(traction.stiffness.transpose() * (of_force + of_slip)))),
                );
            }
        }
        if let Some(to) = gradients.pairs.iter_mut().find(|to| to.partners == pair.partners) {
            if by_stiffness {
                to.stiffness += stiffness / partners.stiffness_of(&pair.partners, method.options());
            }
            if request.friction && !seeds.slip.is_empty() {
                to.friction += friction / partners.friction_of(&pair.partners, method.options()).coefficient;
            }
        }
    }
    gradients.slip = list_slip(&by_slip);
    Ok(())
}

/// Adds rates of the forces of all sliders along rates of the slip carried into the step and of stiffnesses.
///
/// # Errors
/// As [`add_sliders`].
pub(crate) fn add_slider_slopes<const D: usize>(
    (partners, method): (&Partners<D>, &Method<D>),
    pairs: &[SlipFacets<D>],
    along: &Along,
    forces: &mut [[f64; D]],
) -> Result<(), Error> {
    for pair in pairs {
        let [of_stiffness, ..] = along.of_pair(&pair.partners);
        let is_of_law = check_pair(&pair.partners, (partners, method), !along.slip.is_empty(), of_stiffness != 0.0)?;
        let part = of_stiffness / partners.stiffness_of(&pair.partners, method.options());
        for (facet, rows, traction) in pair.tractions() {
            let mut rate = match grows_as_law(facet, is_of_law) {
                _ if of_stiffness == 0.0 => Vector::zeros(),
                true => traction.value * part,
                false => limited(facet, &traction) * part,
            };
            let name: SliderName = (pair.partners, facet.of_b, facet.facet);
            if let Some(carried) = along.slip.get(&name) {
                rate += traction.stiffness * facet.of_carried(&Vector::from_fn(|i, _| carried[i]));
            }
            for row in rows.iter().filter(|row| !row.mover.turns) {
                if let Some(force) = forces.get_mut(row.mover.node as usize) {
                    let added = row.slip.transpose() * (rate * facet.area);
                    (0..D).for_each(|i| force[i] -= added[i]);
                }
            }
        }
    }
    Ok(())
}

/// What a traction has by its limit, times that; an infinite limit is met by nothing.
fn limited<const D: usize>(facet: &SlipFacet<D>, traction: &Traction<D>) -> Vector<D> {
    match traction.slides || !is_spring(facet.slider.stick) {
        true => traction.by_limit * facet.slider.limit,
        false => Vector::zeros(),
    }
}

/// Whether all of a traction is in proportion to the stiffness of the law, not its limit alone.
fn grows_as_law<const D: usize>(facet: &SlipFacet<D>, is_of_law: bool) -> bool {
    is_of_law || !is_spring(facet.slider.stick)
}

fn is_spring(stick: Stick) -> bool {
    matches!(stick, Stick::Spring(_))
}

/// Whether the stick of a pair is as stiff as its law.
///
/// # Errors
/// [`Error::Unsupported`] for friction that carries more than slip, and for limits that do not grow with the stiffness alone.
fn check_pair<const D: usize>(
    pair: &[Partner; 2],
    (partners, method): (&Partners<D>, &Method<D>),
    by_slip: bool,
    by_stiffness: bool,
) -> Result<bool, Error> {
    let friction = partners.friction_of(pair, method.options());
    if (by_slip || by_stiffness) && partners.friction_law(pair).is_some() {
        let what = "derivatives by the stiffness, and by and of the slip between steps, with your own law of friction";
        return Err(Error::Unsupported { what });
    }
    if by_slip && friction.at_rest.is_some() {
        let what = "derivatives by and of the slip between steps with static friction, which carries more than slip";
        return Err(Error::Unsupported { what });
    }
    if by_stiffness && (friction.cohesion != 0.0 || friction.shear_limit.is_finite()) {
        let what = "the derivative of frictional forces by the stiffness of a pair with cohesion or a shear limit";
        return Err(Error::Unsupported { what });
    }
    Ok(friction.has_stiffness_of_law())
}
