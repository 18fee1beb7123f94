//! Whether a host says what a search takes it to say.

use super::attempt::LoadStep;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::conversation::Asking;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::outcome::{Found, Refusal, Way};
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{dot, largest, moved, norm};
use crate::contact::equilibrium::driver::bodies::layers;
use crate::contact::equilibrium::driver::bodies::motions::Motions;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::geometry::Vector;

/// Step of the differences, by the extent of the bodies: errors of rounding and of curvature are of one size.
const STEP: f64 = 1e-6;

/// Error of a derivative, by its size, below which it is right; above [`WRONG`] it is wrong.
const RIGHT: f64 = 1e-5;
const WRONG: f64 = 1e-2;

/// Unbalanced forces, by the magnitudes that add up to them, that are rounding.
const ROUNDED: f64 = 1e-9;

/// Checks the host at the start of a load step, and ends there, with a sentence for everything that was looked at.
pub(crate) async fn check_host<const D: usize>(asking: Asking<D>, step: LoadStep<D>) -> Result<Found<D>, Refusal> {
    let host = Host::new(asking, step.unknowns);
    match looked_at(&host, &step.x).await {
        Ok((warnings, reactions, contact)) => Ok(Found {
            x: step.x,
            contact,
            reactions,
            way: Way::Nearest,
            solves: 0,
            rigid_steps: 0,
            first_touches: 0,
            parts: 0,
            loose_count: 0,
            updates: 0,
            penetration: None,
            residuals: Vec::new(),
            free: Vec::new(),
            warnings,
        }),
        Err(trouble) => Err(Refusal::new(trouble, Vec::new(), 0)),
    }
}

type Report<const D: usize> = (Vec<String>, Vec<f64>, crate::contact::results::ContactForces<D>);

async fn looked_at<const D: usize>(host: &Host<D>, x: &[f64]) -> Result<Report<D>, Trouble> {
    let coords = host.unknowns.coords(x);
    let at = coords.clone();
    let assembly = host.contact(move |contact| Assembly::new(contact, &at)).await?;
    let mut said = vec![at_rest(host, x).await?];
    said.extend(derivative(host, &assembly, x).await?);
    said.extend(rigid(host, &assembly).await?);
    // Ties hold bodies with a stiffness that is found first.
    let layered = layers::complete(host, &assembly, x).await;
    let motions = Motions::loose(host, &assembly, &coords).await?;
    said.push(match motions.count() {
        0 => "supports: every body is held".to_owned(),
        count => format!("supports: {count} rigid motions are held by contact alone, or hardly held"),
    });
    if let Err(trouble) = layered {
        said.push(trouble.to_string());
        return Err(Trouble::Failed(said.join("; ")));
    }
    let start = host.contact(move |contact| match contact.slip().is_ok() || !contact.has_friction() {
        true => Ok(()),
        false => contact.begin_step(&coords),
    });
    start.await?;
    let state = State::at(host, x.to_vec(), true).await?;
    let pairs = state.contact.pairs.len();
    said.push(format!("contact: {pairs} pairs overlap here, by {:.3e} at most", state.contact.penetration));
    Ok((said, state.residual, state.contact))
}

async fn at_rest<const D: usize>(host: &Host<D>, x: &[f64]) -> Result<String, Trouble> {
    let (forces, _) = host.forces(x, true).await?;
    if let Some(unknown) = forces.iter().position(|force| !force.is_finite()) {
        return Err(Trouble::Failed(format!("residual: the force at unknown {unknown} is not finite")));
    }
    let free = host.unknowns.free.iter().filter(|free| **free).count();
    let size = norm(&forces);
    Ok(format!("residual: {} unknowns, {free} of them free; its norm is {size:.3e} here", forces.len()))
}

/// Unit numbers that look random, the same each time.
fn direction(count: usize, seed: u64) -> Vec<f64> {
    let number = |k: usize| {
        let mixed = (k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ seed.wrapping_mul(0xd1b5_4a32_d192_ed03);
        let mixed = (mixed ^ (mixed >> 31)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    (0..count).map(number).collect()
}

/// The matrix beside differences of the residual, its sign and its symmetry.
async fn derivative<const D: usize>(host: &Host<D>, assembly: &Assembly<D>, x: &[f64]) -> Result<Vec<String>, Trouble> {
    let [d, e] = [1, 2].map(|seed| direction(x.len(), seed));
    let step = STEP * assembly.size;
    let product = host.product(d.clone(), false).await?;
    let ahead = host.forces(&moved(x, step, &d), false).await?.0;
    let behind = host.forces(&moved(x, -step, &d), false).await?.0;
    let change: Vec<f64> = ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * step)).collect();
    // Rows of unknowns that are not free are those of the bodies too.
    let error =
        |sign: f64| norm(&moved(&change, -sign, &product)) / norm(&product).max(norm(&change)).max(f64::MIN_POSITIVE);
    let (right, turned) = (error(1.0), error(-1.0));
    let mut said = Vec::new();
    said.push(match () {
        () if norm(&change) == 0.0 && norm(&product) == 0.0 => {
            "matrix: WRONG: neither the residual nor the matrix depends on the unknowns".to_owned()
        }
        () if norm(&change) == 0.0 => "residual: WRONG: it does not depend on the unknowns".to_owned(),
        () if right < RIGHT => format!("matrix: it is the derivative of the residual, to {right:.1e}"),
        () if turned < WRONG => {
            "matrix: WRONG: it is minus the derivative of the residual; the residual is internal minus external \
             forces".to_owned()
        }
        () if right < WRONG => format!("matrix: it is the derivative of the residual to {right:.1e}, which slows \
            convergence"),
        () => {
            let part = dot(&change, &product) / dot(&product, &product).max(f64::MIN_POSITIVE);
            format!(
                "matrix: WRONG: it differs from the derivative of the residual by {right:.1e} of it (the derivative is {part:.3} \
                 of it): another order of unknowns, rows of supports changed, or another state"
            )
        }
    });
    let energy = dot(&d, &product);
    if energy < 0.0 {
        said.push(
            "sign: WRONG: the matrix pushes along a displacement, not against it: give internal minus external forces"
                .into(),
        );
    }
    let other = host.product(e.clone(), false).await?;
    let (one, two) = (dot(&e, &product), dot(&d, &other));
    let scale = norm(&product) * norm(&e);
    said.push(match (one - two).abs() <= ROUNDED * scale {
        true => "symmetry: the matrix is symmetric".to_owned(),
        false => format!("symmetry: the matrix is not symmetric, by {:.1e}", (one - two).abs() / scale),
    });
    Ok(said)
}

/// Forces by a translation and a rotation of all bodies as one.
async fn rigid<const D: usize>(host: &Host<D>, assembly: &Assembly<D>) -> Result<Vec<String>, Trouble> {
    let names = ["x", "y", "z"];
    let field = |motion: &dyn Fn(Vector<D>) -> Vector<D>| {
        let mut field = vec![0.0; host.unknowns.count];
        for (place, unknown) in host.unknowns.of_coordinate.iter().enumerate() {
            if let Some(unknown) = unknown {
                field[*unknown] = motion(assembly.position[place / D])[place % D];
            }
        }
        host.unknowns.subtract_weighted(&mut field);
        field
    };
    let mut motions: Vec<(String, Vec<f64>)> = Vec::new();
    for axis in 0..D {
        let unit = Vector::from_fn(|row, _| if row == axis { 1.0 } else { 0.0 });
        motions.push((format!("a translation along {}", names[axis]), field(&|_| unit)));
    }
    let turned = |x: Vector<D>| {
        Vector::from_fn(|row, _| match row {
            0 => -x[1],
            1 => x[0],
            _ => 0.0,
        })
    };
    motions.push(("a small rotation".into(), field(&turned)));
    let mut said = Vec::new();
    for (name, motion) in motions {
        let size = largest(&motion).max(f64::MIN_POSITIVE);
        let forces = norm(&host.product(motion.clone(), false).await?);
        let all = norm(&host.product(motion.iter().map(|entry| entry.abs()).collect(), true).await?);
        if forces > ROUNDED * all.max(f64::MIN_POSITIVE) * 1e3 {
            said.push(format!(
                "rigid motions: {name} of all bodies has forces, {:.1e} of their parts: springs to the ground, large numbers on the \
                 diagonal, stress, or rows of supports that were changed; size of the motion {size:.1e}",
                forces / all
            ));
        }
    }
    if said.is_empty() {
        said.push("rigid motions: none has forces".into());
    }
    Ok(said)
}
