//! Derivatives from what the laws and friction answer for every pair.

use super::gradients::{Gradients, PairGradient};
use super::obstacle_row::add_transposed;
use super::request::{GradientRequest, Seeds};
use crate::Error;
use crate::contact::friction::Tractions;
use crate::contact::laws::Answer;
use crate::contact::method::Method;
use crate::contact::partners::Partners;
use crate::geometry::primitives::plane::Plane;
use crate::geometry::shapes::ImplicitShape;
use crate::geometry::{Vector, moment};
use crate::overlap::{Estimator, LineWeights, Partner};

/// What decides whether a tangent is the derivative of forces.
pub(crate) struct State<'a> {
    /// Whether the patches of a pair are kept.
    pub(crate) is_kept: &'a dyn Fn(&[Partner; 2]) -> bool,
    /// Whether friction is frozen.
    pub(crate) is_frozen: bool,
    /// Whether faces may be measured as curved ones.
    pub(crate) may_be_curved: bool,
}

/// Adds what all pairs have, to lists that are as long as they must be.
///
/// # Errors
/// [`Error::Unsupported`] for what is no derivative, or is not known.
pub(crate) fn add_answers<const D: usize>(
    (partners, method): (&Partners<D>, &Method<D>),
    (answers, tractions): (&[Answer<D>], &[Tractions<D>]),
    (seeds, request, state): (&Seeds<D>, &GradientRequest, &State),
    gradients: &mut Gradients<D>,
) -> Result<(), Error> {
    let node_count = gradients.coords.len();
    let obstacle_count = partners.obstacles.count();
    let mut sums = vec![[0.0; D]; node_count + 2 * obstacle_count];
    let a = seeds.forces.unwrap_or(&[]);
    for answer in answers {
        let Some(energy) = &answer.energy else { continue };
        let pair = [energy.overlap.a, energy.overlap.b];
        // Friction is no part of the energy, but of the forces.
        let rubs = partners.friction_of(&pair, method.options()).is_active();
        if request.needs_tangent() {
            check_smooth(pair, energy.overlap.fiber_count > 0, (partners, method), state, !a.is_empty())?;
        }
        let mut of_pair = PairGradient::new(pair);
        for (&node, g) in energy.nodes.iter().zip(&energy.gradient) {
            (0..D).for_each(|i| sums[node as usize][i] += seeds.energy * g[i]);
        }
        let mut here = vec![[0.0; D]; sums.len()];
        if let Some(tangent) = &answer.tangent {
            add_transposed(tangent, a, -1.0, &mut here);
            sums.iter_mut().zip(&here).for_each(|(sum, x)| (0..D).for_each(|i| sum[i] += x[i]));
        }
        if let (Partner::Obstacle(o), Some(motion)) = (pair[1], &energy.pose_gradient) {
            let by_position = motion.position * seeds.energy;
            (0..D).for_each(|i| sums[node_count + o][i] += by_position[i]);
            if request.gap_offsets {
                let normal = normal_of_half_space(partners, o, rubs && !a.is_empty())?;
                of_pair.gap_offset = normal.dot(&(by_position + Vector::from(here[node_count + o])));
            }
            if request.rotations {
                let position = Vector::from(partners.obstacles.rigid(o)?.obstacle.pose.position);
                let about = moment(&position, &motion.position);
                (0..3).for_each(|i| gradients.rotations[o][i] += seeds.energy * (motion.rotation[i] - about[i]));
            }
        } else if request.gap_offsets {
            return Err(Error::Unsupported { what: "the derivative by the gap offset between bodies" });
        }
        if request.stiffness {
            check_stiffness(rubs && seeds.reaches_friction(), state)?;
            let moved = energy.nodes.iter().zip(&energy.gradient);
            let along: f64 =
                moved.map(|(&node, g)| a.get(node as usize).map_or(0.0, |a| g.dot(&Vector::from(*a)))).sum();
            of_pair.stiffness = (seeds.energy * energy.energy - along) / partners.stiffness_of(&pair, method.options());
        }
        if request.friction {
            of_pair.friction = by_coefficient(&pair, (partners, method), tractions, seeds)?;
        }
        gradients.pairs.push(of_pair);
    }
    for traction in tractions {
        add_transposed(&traction.tangent, a, -1.0, &mut sums);
    }
    gradients.coords.copy_from_slice(&sums[..node_count]);
    let of_obstacles = &sums[node_count..];
    gradients.positions.iter_mut().zip(of_obstacles).for_each(|(to, from)| *to = *from);
    for (to, from) in gradients.rotations.iter_mut().zip(&of_obstacles[obstacle_count..]) {
        match D {
            2 => to[2] += from[0],
            _ => (0..D).for_each(|i| to[i] += from[i]),
        }
    }
    Ok(())
}

/// The derivative of what frictional forces do along `a` by the coefficient of a pair: limits are the coefficient times the pressure.
fn by_coefficient<const D: usize>(
    pair: &[Partner; 2],
    (partners, method): (&Partners<D>, &Method<D>),
    tractions: &[Tractions<D>],
    seeds: &Seeds<D>,
) -> Result<f64, Error> {
    let a = seeds.forces.unwrap_or(&[]);
    if !seeds.reaches_friction() {
        return Ok(0.0);
    }
    let coefficient = check_coefficient(pair, (partners, method))?;
    let limited = tractions.iter().filter(|traction| traction.partners == *pair).flat_map(|traction| &traction.limited);
    let along = limited.filter_map(|(node, force)| Some(force.dot(&Vector::from(*a.get(*node as usize)?))));
    Ok(along.sum::<f64>() / coefficient)
}

/// The coefficient of a pair, to which the limits of its friction are in proportion.
pub(super) fn check_coefficient<const D: usize>(
    pair: &[Partner; 2],
    (partners, method): (&Partners<D>, &Method<D>),
) -> Result<f64, Error> {
    let (friction, refused) = (partners.friction_of(pair, method.options()), |what| Err(Error::Unsupported { what }));
    if partners.friction_law(pair).is_some() {
        return refused("the derivative by a coefficient of friction of your own law of friction");
    }
    if friction.coefficient.is_infinite() {
        return refused("the derivative by an infinite coefficient of friction");
    }
    if friction.coefficient <= 0.0 {
        return refused("the derivative by a coefficient of friction of 0, at which the slip of the step is not known");
    }
    if partners.orthotropy_of(pair, method.options()).is_some() {
        return refused("the derivative by a coefficient of friction along a direction");
    }
    if friction.at_rest.is_some() || friction.cohesion != 0.0 || friction.shear_limit.is_finite() {
        return refused(
            "the derivative by the coefficient of friction with static friction, cohesion or a shear limit",
        );
    }
    Ok(friction.coefficient)
}

/// What friction adds by the stiffness of a pair comes from its sliders, of which there are none while it is frozen.
pub(super) fn check_stiffness(rubs: bool, state: &State) -> Result<(), Error> {
    if rubs && state.is_frozen {
        let what = "the derivative of frictional forces by the stiffness of a pair while friction is frozen";
        return Err(Error::Unsupported { what });
    }
    Ok(())
}

/// Refuses a pair whose forces are not the gradient of its energy, and, where forces are differentiated, one whose tangent is not their
/// derivative.
pub(super) fn check_smooth<const D: usize>(
    pair: [Partner; 2],
    is_sampled: bool,
    (partners, method): (&Partners<D>, &Method<D>),
    state: &State,
    has_forces: bool,
) -> Result<(), Error> {
    let (law, refused) = (partners.law_of(&pair, method), |what| Err(Error::Unsupported { what }));
    if law.is_local() && !(state.is_kept)(&pair) {
        return refused("derivatives with the law fiber, unless its patches are kept");
    }
    if has_forces && is_sampled {
        return refused("the derivative of sampled forces by coordinates and poses");
    }
    if has_forces && !state.is_frozen && partners.friction_of(&pair, method.options()).is_active() {
        return refused("the derivative of frictional forces by coordinates and poses, unless friction is frozen");
    }
    // Known up to a quadrature.
    if has_forces && D == 3 && state.may_be_curved && law.needs_depth() && matches!(pair[1], Partner::Body(_)) {
        return refused("the derivative of forces between curved faces in 3D by coordinates and poses");
    }
    let (Estimator::Fibers(options) | Estimator::Auto(options)) = method.options().estimator else { return Ok(()) };
    if is_sampled && (options.momentum_correction || options.weights != LineWeights::Consistent) {
        return refused(
            "derivatives of sampled results, unless their weights are consistent and momentum_correction is off",
        );
    }
    Ok(())
}

/// The direction in which the surface of a half-space moves as a gap offset grows.
pub(super) fn normal_of_half_space<const D: usize>(
    partners: &Partners<D>,
    obstacle: usize,
    is_rubbed: bool,
) -> Result<Vector<D>, Error> {
    let rigid = partners.obstacles.rigid(obstacle)?;
    if !rigid.solid().implicit().is_some_and(ImplicitShape::is_half_space) {
        return Err(Error::Unsupported {
            what: "the derivative by the gap offset of an obstacle that is no half-space",
        });
    }
    if is_rubbed {
        return Err(Error::Unsupported { what: "the derivative of frictional forces by a gap offset" });
    }
    Ok(Plane::of(&rigid.obstacle.pose).normal)
}
