//! Forces, energy and overlap.

use crate::judge::{Answer, stiffness};
use crate::scene::table::exactly;
use crate::scene::{Scene, cross, distance, size_sum};
use fmc_contact::EnergyLaw;
use fmc_shapes::{Splitmix, random_rotation};

type Verdict = Result<(), String>;

fn centre<const D: usize>(coords: &[[f64; D]]) -> [f64; D] {
    std::array::from_fn(|i| coords.iter().map(|x| x[i]).sum::<f64>() / coords.len() as f64)
}

/// Forces and moments sum to nothing, and energy, volume and warnings say the same as they.
pub(crate) fn balance<const D: usize>(answer: &Answer<D>) -> Verdict {
    let (forces, coords) = (answer.forces, &answer.drawn.coords);
    let middle = centre(coords);
    let (mut sum, mut moment) = ([0.0; D], [0.0; 3]);
    for (x, f) in coords.iter().zip(&forces.forces) {
        let turn = cross(&std::array::from_fn(|i| x[i] - middle[i]), f);
        (0..D).for_each(|i| sum[i] += f[i]);
        (0..3).for_each(|i| moment[i] += turn[i]);
    }
    let largest = |values: &[f64]| values.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    // Where walls are flush but for a part δ of the size, rounding is ε/δ. Moments have arms that are rounded.
    let bound = 1e-10 * answer.size + 0.1 * answer.rounding;
    let of_arms = (bound + 10.0 * answer.drawn.rounding * answer.size) * 3.0 * answer.drawn.size;
    if largest(&sum) > bound || largest(&moment) > of_arms {
        return Err(format!("ΣF {sum:?}, ΣM {moment:?} of {:e}", answer.size));
    }
    if !(forces.energy >= 0.0 && forces.volume >= 0.0 && forces.energy.is_finite()) {
        return Err(format!("energy {}, volume {}", forces.energy, forces.volume));
    }
    // An overlap beyond rounding presses, or a warning says why it does not.
    let seen = 1e3 * answer.drawn.rounding * answer.drawn.size.powi(D as i32);
    if forces.volume > seen && answer.size == 0.0 && forces.warnings.is_empty() {
        return Err(format!("volume {:e} without force or warning", forces.volume));
    }
    Ok(())
}

/// The volume is what clipping cells by cells finds.
pub(crate) fn overlap<const D: usize>(answer: &Answer<D>) -> Verdict {
    let drawn = answer.drawn;
    // Straight parts of curved cells are another volume.
    if !drawn.is_straight {
        return Ok(());
    }
    let clipped = drawn.scene.contact(exactly(EnergyLaw::volume(1.0))).evaluate(&drawn.coords);
    let clipped = clipped.map_err(|error| format!("refused by the law volume: {error}"))?.volume;
    let bound = 1e-9 * clipped + 30.0 * drawn.rounding * drawn.size.powi(D as i32);
    match (answer.forces.volume - clipped).abs() <= bound {
        true => Ok(()),
        false => Err(format!("{:e} for {clipped:e}", answer.forces.volume)),
    }
}

/// The force is minus the slope of the energy; central differences, whose error is a jump of the pressure's slope times the step.
pub(crate) fn slope<const D: usize>(answer: &Answer<D>) -> Verdict {
    let drawn = answer.drawn;
    let mut random = Splitmix::new(11);
    let way: Vec<[f64; D]> = drawn.coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
    let step = 1e-6 * drawn.size * (drawn.rounding / f64::EPSILON).cbrt();
    let energy = |h: f64| {
        let moved: Vec<[f64; D]> =
            drawn.coords.iter().zip(&way).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
        answer.contact.evaluate(&moved).map(|forces| forces.energy).map_err(|error| error.to_string())
    };
    let found = (energy(-step)? - energy(step)?) / (2.0 * step);
    let told: f64 = answer.forces.forces.iter().flatten().zip(way.iter().flatten()).map(|(f, d)| f * d).sum();
    let area = drawn.size.powi(D as i32 - 1);
    let bound = 1e-5 * answer.size + 20.0 * area * step / drawn.size + 1e3 * answer.rounding;
    match (found - told).abs() <= bound {
        true => Ok(()),
        false => Err(format!("{told:e} for {found:e}, bound {bound:e}")),
    }
}

fn same<const D: usize>(answer: &Answer<D>, other: &[[f64; D]], far: f64) -> Verdict {
    let off = distance(&answer.forces.forces, other);
    // Points on curved faces in space lie as parts of facets are divided, which is a matter of their numbers and of rounding.
    let bent = if D == 3 && !answer.drawn.is_straight { 1e-3 * answer.drawn.size.powi(D as i32 - 1) } else { 0.0 };
    match off <= 1e-9 * answer.size + bent + 100.0 * far * answer.rounding {
        true => Ok(()),
        false => Err(format!("{off:e} of {:e}, rounding {:e}", answer.size, answer.rounding)),
    }
}

/// Bodies given the other way round have the same forces.
pub(crate) fn other_order<const D: usize>(answer: &Answer<D>) -> Verdict {
    let drawn = answer.drawn;
    let swapped = Scene { ids: drawn.scene.ids.iter().map(|id| 1 - id).collect(), ..drawn.scene.clone() };
    let contact = swapped.contact(exactly(EnergyLaw::depth(stiffness(drawn))));
    let other = contact.evaluate(&drawn.coords).map_err(|error| format!("refused: {error}"))?;
    same(answer, &other.forces, 1.0)
}

/// Everything turned, moved and in another unit has forces that are so too.
pub(crate) fn moved_as_one<const D: usize>(answer: &Answer<D>) -> Verdict {
    let drawn = answer.drawn;
    let (turn, scale, middle) = (random_rotation::<D>(5), 7.0, centre(&drawn.coords));
    let put = |x: [f64; D]| -> [f64; D] {
        std::array::from_fn(|i| scale * (0..D).map(|j| turn[i][j] * (x[j] - middle[j])).sum::<f64>())
    };
    let scene = drawn.scene.clone().mapped(put);
    let coords: Vec<[f64; D]> = drawn.coords.iter().map(|&x| put(x)).collect();
    let contact = scene.contact(exactly(EnergyLaw::depth(stiffness(drawn) / scale)));
    let other = contact.evaluate(&coords).map_err(|error| format!("refused: {error}"))?;
    // Pressure is the stiffness times a length, and does not change; areas do.
    let back: Vec<[f64; D]> = other
        .forces
        .iter()
        .map(|f| std::array::from_fn(|j| (0..D).map(|i| turn[i][j] * f[i]).sum::<f64>() / scale.powi(D as i32 - 1)))
        .collect();
    debug_assert!(size_sum(&back).is_finite());
    same(answer, &back, 10.0)
}
