//! The law on sampled lines, beside exact clipping.

use crate::depth;
use crate::derivatives::{in_plane, in_space};
use crate::scene::{Scene, cross, distance, norm, size_sum};
use fmc_contact::contact::{PairOptions, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Estimator, FiberOptions, LineWeights, Options, Resolution};
use fmc_shapes::{Diagonals, Splitmix, cuboid_tet4, rectangle_tri3};

const K: f64 = 30.0;

/// The law on lines.
fn lines(spacing: f64, seed: u64, weights: LineWeights) -> Options {
    let resolution = Resolution::Spacing(spacing);
    let fibers = FiberOptions { resolution, seed, weights, ..FiberOptions::default() };
    Options { estimator: Estimator::Fibers(fibers), ..depth(K) }
}

/// Root of the mean square, over the seeds, of the error of the energy and of that of the nodal forces, in parts of them.
fn errors<const D: usize>(contact: &mut Contact<D>, coords: &[[f64; D]], of: impl Fn(u64) -> Options) -> [f64; 2] {
    contact.set_options(depth(K)).expect("valid options");
    let exact = contact.evaluate(coords).expect("valid coordinates");
    let (mut energy, mut force) = (0.0, 0.0);
    const SEEDS: u64 = 6;
    for seed in 0..SEEDS {
        contact.set_options(of(seed)).expect("valid options");
        let found = contact.evaluate(coords).expect("valid coordinates");
        energy += (found.energy / exact.energy - 1.0).powi(2);
        force += (distance(&found.forces, &exact.forces) / norm(&exact.forces)).powi(2);
    }
    [energy, force].map(|sum| (sum / SEEDS as f64).sqrt())
}

/// At a quarter of the distance between lines in the plane, and a third in space, forces are at least twice as near. With
/// consistent weights the energy is as good; a crossing of a facet that is nearly along its line then has a force without bound.
#[test]
fn they_converge_to_what_is_exact() {
    let check = |[wide, narrow]: [[f64; 2]; 2], bound: f64, what: &str| {
        println!("{what}: energy {:.1e} to {:.1e}, forces {:.1e} to {:.1e}", wide[0], narrow[0], wide[1], narrow[1]);
        assert!(narrow[0] < 1e-3, "{what}: {narrow:?}");
        assert!(narrow[1] < bound && narrow[1] < 0.5 * wide[1], "{what}: {wide:?}, {narrow:?}");
    };
    in_plane(|mut contact, coords| {
        let mut of = |weights| [4e-3, 1e-3].map(|s| errors(&mut contact, &coords, |seed| lines(s, seed, weights)));
        check(of(LineWeights::Balance), 2e-3, "plane");
        let [_, [energy, force]] = of(LineWeights::Consistent);
        assert!(energy < 1e-3 && force < 0.2, "{energy}, {force}");
    });
    in_space(|mut contact, coords| {
        let weights = LineWeights::Balance;
        check([0.03, 0.01].map(|s| errors(&mut contact, &coords, |seed| lines(s, seed, weights))), 1e-2, "space");
    });
}

/// A thousand crossings, in the plane and in space: the energy is right to 1e-3, as the root of the mean square over seeds.
#[test]
fn a_thousand_crossings() {
    fn check<const D: usize>(mut contact: Contact<D>, coords: Vec<[f64; D]>) {
        let mut spacing = 0.1;
        loop {
            contact.set_options(lines(spacing, 0, LineWeights::Balance)).expect("valid options");
            let crossings = contact.overlaps(&coords).expect("valid coordinates")[0].crossing_count;
            let [energy, force] = errors(&mut contact, &coords, |seed| lines(spacing, seed, LineWeights::Balance));
            println!("{D}D, spacing {spacing:.1e}: {crossings} crossings, energy {energy:.1e}, forces {force:.1e}");
            if crossings > 1000 {
                assert!(energy < 1e-3);
                return;
            }
            spacing *= 0.7;
        }
    }
    in_plane(check);
    in_space(check);
}

/// Forces that balance to rounding, which lines fixed in space do not give by themselves.
#[test]
fn forces_balance() {
    fn check<const D: usize>(mut contact: Contact<D>, coords: Vec<[f64; D]>) {
        contact.set_options(lines(0.05, 1, LineWeights::Balance)).expect("valid options");
        let at = contact.evaluate(&coords).expect("valid coordinates");
        let sizes = size_sum(&at.forces);
        let force: [f64; D] = std::array::from_fn(|i| at.forces.iter().map(|f| f[i]).sum());
        let moment: [f64; 3] =
            std::array::from_fn(|i| coords.iter().zip(&at.forces).map(|(x, f)| cross(x, f)[i]).sum());
        assert!(norm(&[force]) < 1e-13 * sizes && norm(&[moment]) < 1e-13 * sizes, "{force:?}, {moment:?} of {sizes}");
    }
    in_plane(check);
    in_space(check);
}

/// Consistent weights on lines that stay where they are, uncorrected.
fn differentiable(spacing: f64) -> Options {
    let mut options = lines(spacing, 2, LineWeights::Consistent);
    let Estimator::Fibers(fibers) = &mut options.estimator else { unreachable!() };
    fibers.momentum_correction = false;
    options
}

/// Differences at a step of 1e-7: a line that finds or loses a facet within it has next to no part in the energy there, so
/// that 1e-5 of the forces is left of rounding, 1e-16 of the energy by the step, and of kinks.
#[test]
fn the_force_is_the_slope_of_the_energy_on_the_same_lines() {
    fn check<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) {
        let at = contact.evaluate(coords).expect("valid coordinates");
        let mut random = Splitmix::new(7);
        for _ in 0..6 {
            let direction: Vec<[f64; D]> =
                coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
            let energy = |h: f64| {
                let moved: Vec<[f64; D]> =
                    coords.iter().zip(&direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
                contact.evaluate(&moved).expect("valid coordinates").energy
            };
            let slope = (energy(1e-7) - energy(-1e-7)) / 2e-7;
            let along: f64 = at.forces.iter().flatten().zip(direction.iter().flatten()).map(|(f, d)| f * d).sum();
            assert!((along + slope).abs() < 1e-5 * size_sum(&at.forces), "{along} against {slope}");
        }
    }
    in_plane(|mut contact, coords| {
        contact.set_options(differentiable(0.01)).expect("valid options");
        check(&contact, &coords);
    });
    in_space(|mut contact, coords| {
        contact.set_options(differentiable(0.05)).expect("valid options");
        check(&contact, &coords);
    });
}

/// The second derivative is that of the exact sums at the crossings: its product with a motion is as near to the exact one as
/// the forces are.
#[test]
fn the_tangent_is_the_exact_one_but_for_noise() {
    fn check<const D: usize>(mut contact: Contact<D>, coords: Vec<[f64; D]>, spacing: f64) {
        let mut random = Splitmix::new(9);
        let direction: Vec<[f64; D]> =
            coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        for part in [TangentPart::Full, TangentPart::Semidefinite] {
            let mut product = |options: Options| {
                contact.set_options(options).expect("valid options");
                contact.tangent(&coords, part).expect("valid coordinates").product(&direction)
            };
            let exact = product(depth(K));
            let found = product(lines(spacing, 3, LineWeights::Balance));
            let error = distance(&found, &exact) / norm(&exact);
            assert!(error < 0.02, "{part:?}: {error}");
        }
    }
    in_plane(|contact, coords| check(contact, coords, 1e-3));
    in_space(|contact, coords| check(contact, coords, 0.01));
}

/// What is told beside the forces: as exact, but for noise. The contact may begin below the surface.
#[test]
fn points_fields_and_pairs() {
    let lower = rectangle_tri3([0.0, -1.0], [1.0, 0.0], [6, 4], Diagonals::Alternating);
    let upper = rectangle_tri3([0.2, -0.05], [0.8, 0.5], [4, 3], Diagonals::Same);
    for offset in [0.0, -0.01] {
        let scene = Scene::of(&[&lower, &upper]);
        let of = |options: Options| {
            let mut contact = scene.contact(options);
            contact
                .set_pair_options([Body(0), Body(1)], Some(PairOptions::with_gap_offset(offset)))
                .expect("an offset");
            let forces = contact.evaluate(&scene.coords).expect("valid coordinates");
            let pair = forces.pairs[0].clone();
            let nodal = contact.nodal_contact(&scene.coords).expect("valid coordinates");
            let points = contact.contact_points(&scene.coords).expect("valid coordinates");
            let area: f64 = points.iter().map(|point| point.area).sum();
            let pressure = nodal.pressure.iter().fold(0.0f64, |m, p| m.max(*p));
            [pair.volume, pair.contact_area, pair.pressure, pair.penetration, area, pressure, forces.energy]
        };
        let (exact, found) = (of(depth(K)), of(lines(1e-3, 1, LineWeights::Balance)));
        for (exact, found) in exact.iter().zip(found) {
            assert!(*exact > 0.0 && (found / exact - 1.0).abs() < 0.02, "{found} instead of {exact} with {offset}");
        }
    }
}

/// A body that overlaps itself has the energy of the two that it is made of, on the same lines.
#[test]
fn a_body_with_itself() {
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [3, 3, 3]).rotated([1.0, 2.0, 3.0], 0.1);
    let upper = cuboid_tet4([0.1, 0.2, -0.1], [0.8, 0.9, 0.6], [2, 3, 2]);
    let away = upper.clone().mapped(|x| x.map(|x| x + 5.0));
    let coords = Scene::of(&[&lower, &upper]).coords;
    let of = |scene: Scene<3>, options| scene.contact(options).evaluate(&coords).expect("valid coordinates");
    let options = differentiable(0.03);
    let two = of(Scene::of(&[&lower, &away]), options);
    let one = of(Scene::new().with(&lower, 0).with(&away, 0), Options { self_contact: true, ..options });
    assert!((one.volume / two.volume - 1.0).abs() < 1e-12 && (one.energy / two.energy - 1.0).abs() < 1e-12);
    assert!(distance(&one.forces, &two.forces) < 1e-12 * size_sum(&two.forces));
}

/// Rings that overlap in (r, z), beside exact ones.
#[test]
fn in_axisymmetry() {
    let lower = rectangle_tri3([0.5, -1.0], [1.5, 0.0], [5, 4], Diagonals::Alternating);
    let upper = rectangle_tri3([0.7, -0.06], [1.3, 0.5], [4, 3], Diagonals::Same).rotated(0.02);
    let scene = Scene::of(&[&lower, &upper]);
    let of = |options| scene.evaluate(Options { axisymmetric: true, ..options });
    let (exact, found) = (of(depth(K)), of(lines(1e-3, 1, LineWeights::Balance)));
    assert!((found.energy / exact.energy - 1.0).abs() < 2e-3, "{} instead of {}", found.energy, exact.energy);
    assert!(distance(&found.forces, &exact.forces) < 0.01 * norm(&exact.forces));
}

/// An obstacle has its own depth, and needs no line: the same bits.
#[test]
fn obstacles_need_no_lines() {
    use fmc_contact::{Obstacle, Pose, Shape};
    let scene = Scene::of(&[&rectangle_tri3([0.0, 0.0], [1.0, 1.0], [4, 4], Diagonals::Same)]);
    let of = |options: Options| {
        let mut contact = scene.contact(options);
        let shape = Shape::Ball { radius: 0.5 };
        contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.5, -0.4]) }).expect("an obstacle");
        contact.evaluate(&scene.coords).expect("valid coordinates")
    };
    let (exact, sampled) = (of(depth(K)), of(lines(0.01, 1, LineWeights::Balance)));
    assert!(exact.energy > 0.0);
    assert_eq!(exact, sampled);
}

#[test]
fn isotropic_fibers_are_refused() {
    use fmc_contact::{Error, FiberPattern};
    let scene = Scene::of(&[&rectangle_tri3([0.0, 0.0], [1.0, 1.0], [1, 1], Diagonals::Same)]);
    let pattern = FiberPattern::Isotropic { length: None };
    let estimator = Estimator::Fibers(FiberOptions { pattern, ..FiberOptions::default() });
    let options = Options { estimator, ..Options::new(EnergyLaw::depth(1.0)) };
    let refused = Contact::new(scene.surface(), options).map(drop);
    assert!(
        matches!(refused, Err(Error::Unsupported { what }) if what.contains("law depth on isotropic")),
        "{refused:?}"
    );
}
