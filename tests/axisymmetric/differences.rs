//! Force and tangent against differences, and the balance along the axis.

use crate::scene::size_sum;
use fmc_contact::Contact;
use fmc_contact::contact::TangentPart;
use fmc_shapes::Splitmix;

pub(crate) fn moved(coords: &[[f64; 2]], direction: &[[f64; 2]], h: f64) -> Vec<[f64; 2]> {
    coords.iter().zip(direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect()
}

/// Displacements that leave the axis where it is.
pub(crate) fn direction(coords: &[[f64; 2]], random: &mut Splitmix) -> Vec<[f64; 2]> {
    let of = |x: &[f64; 2]| [if x[0] == 0.0 { 0.0 } else { random.between(-1.0, 1.0) }, random.between(-1.0, 1.0)];
    coords.iter().map(of).collect()
}

/// Central differences with a step of 1e-5: 1e-10 by truncation, 1e-11 by rounding; a facet that passes a face within the
/// step adds a jump of the second derivative times it. `tolerance` is in parts of the sum of the forces' sizes.
pub(crate) fn force_is_the_slope_of_the_energy(contact: &Contact<2>, coords: &[[f64; 2]], tolerance: f64) {
    force_is_the_slope_at_a_step(contact, coords, (1e-5, tolerance));
}

pub(crate) fn force_is_the_slope_at_a_step(contact: &Contact<2>, coords: &[[f64; 2]], (step, tolerance): (f64, f64)) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    assert!(at.volume > 1e-3, "{}", at.volume);
    let mut random = Splitmix::new(7);
    for _ in 0..6 {
        let direction = direction(coords, &mut random);
        let energy = |h: f64| contact.evaluate(&moved(coords, &direction, h)).expect("valid coordinates").energy;
        let slope = (energy(step) - energy(-step)) / (2.0 * step);
        let along: f64 = at.forces.iter().flatten().zip(direction.iter().flatten()).map(|(f, d)| f * d).sum();
        let sizes = size_sum(&at.forces);
        assert!((along + slope).abs() < tolerance * sizes, "{along} against {slope} of {sizes}");
    }
}

/// Differences of the force. A node on the axis is held there: what acts on it across does no work.
pub(crate) fn tangent_is_the_slope_of_the_force(contact: &Contact<2>, coords: &[[f64; 2]]) {
    let tangent = contact.tangent(coords, TangentPart::Full).expect("valid coordinates");
    let mut random = Splitmix::new(8);
    for _ in 0..4 {
        let direction = direction(coords, &mut random);
        let forces = |h: f64| contact.evaluate(&moved(coords, &direction, h)).expect("valid coordinates").forces;
        let product = tangent.product(&direction);
        let error = |h: f64| {
            let (plus, minus) = (forces(h), forces(-h));
            let slopes = plus.iter().flatten().zip(minus.iter().flatten()).map(|(p, m)| (m - p) / (2.0 * h));
            let errors = slopes.zip(product.iter().flatten()).map(|(s, p)| (s - p).abs());
            let is_held = |index: usize| index.is_multiple_of(2) && coords[index / 2][0] == 0.0;
            errors.enumerate().filter(|(index, _)| !is_held(*index)).fold(0.0, |m, (_, e)| f64::max(m, e))
        };
        let largest = product.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let found = error(1e-6).min(error(1e-7));
        assert!(found < 1e-6 * largest, "{found} of {largest}");
    }
}

/// What an obstacle feels is the slope of the energy as it moves, and its row in the tangent that of its force.
pub(crate) fn obstacle_is_pushed_by_the_slope(mut contact: Contact<2>, coords: &[[f64; 2]], tolerance: f64) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    let tangent = contact.tangent(coords, TangentPart::Full).expect("valid coordinates");
    let pose = contact.obstacle(0).expect("an obstacle").pose;
    let mut by_differences = [[0.0; 2]; 2];
    for axis in 0..2 {
        let mut moved = |h: f64| {
            let mut to = pose;
            to.position[axis] += h;
            contact.set_pose(0, to).expect("a pose");
            contact.evaluate(coords).expect("valid coordinates")
        };
        let (plus, minus) = (moved(1e-5), moved(-1e-5));
        let slope = (plus.energy - minus.energy) / 2e-5;
        let sizes = size_sum(&at.forces);
        let force = at.obstacles[0].force[axis];
        assert!((force + slope).abs() < tolerance * sizes, "axis {axis}: {force} against {slope} of {sizes}");
        let (plus, minus) = (moved(1e-6), moved(-1e-6));
        by_differences[axis] =
            std::array::from_fn(|i| (minus.obstacles[0].force[i] - plus.obstacles[0].force[i]) / 2e-6);
        let mut unit = vec![[0.0; 2]; coords.len() + 1];
        unit[coords.len()][axis] = 1.0;
        let product = tangent.product(&unit);
        // Nothing changes as a plane across the axis moves sideways.
        let largest = product.iter().flatten().fold(sizes, |m, x| m.max(x.abs()));
        for (node, row) in product[..coords.len()].iter().enumerate() {
            for i in 0..2 {
                let slope = (minus.forces[node][i] - plus.forces[node][i]) / 2e-6;
                assert!((row[i] - slope).abs() < 1e-5 * largest, "{} against {slope} of {largest}", row[i]);
            }
        }
        for i in 0..2 {
            let (row, slope) = (product[coords.len()][i], by_differences[axis][i]);
            assert!((row - slope).abs() < 1e-5 * largest, "axis {axis}: {row} against {slope} of {largest}");
        }
    }
}

/// Along the axis alone: radial forces are those of hoops.
pub(crate) fn axial_forces_balance(contact: &Contact<2>, coords: &[[f64; 2]]) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    let sum: f64 = at.forces.iter().map(|f| f[1]).sum::<f64>()
        + at.obstacles.iter().map(|obstacle| obstacle.force[1]).sum::<f64>();
    assert!(sum.abs() < 1e-12 * size_sum(&at.forces), "{sum} of {}", size_sum(&at.forces));
    assert!(at.warnings.is_empty(), "{:?}", at.warnings);
}
