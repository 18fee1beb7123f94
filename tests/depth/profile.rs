//! A profile that is not quadratic: ψ = k (√(s² + ε²) − ε), on sampled lines.

use crate::derivatives::{in_plane, in_space};
use crate::scene::{Scene, distance, norm, size_sum};
use fmc_contact::contact::{PairOptions, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{
    Contact, EnergyLaw, Error, Estimator, FiberOptions, FiberProfile, LineWeights, Obstacle, Options, Pose, Resolution,
    Shape,
};
use fmc_shapes::{Diagonals, Splitmix, cuboid_tet4, rectangle_quad4, rectangle_tri3};

fn linear(stiffness: f64, smoothing_length: f64) -> EnergyLaw {
    EnergyLaw::Depth { stiffness, profile: FiberProfile::Linear { smoothing_length } }
}

/// Lines that stay where they are, uncorrected, whose force is the gradient of their energy.
fn lines(law: EnergyLaw, spacing: f64) -> Options {
    let fibers = FiberOptions {
        resolution: Resolution::Spacing(spacing),
        weights: LineWeights::Consistent,
        momentum_correction: false,
        ..FiberOptions::default()
    };
    Options { estimator: Estimator::Fibers(fibers), ..Options::new(law) }
}

/// Two flat blocks whose walls go on: ψ of the penetration by area, k δ / √(δ² + ε²) of pressure; by `auto`.
#[test]
fn flat_faces() {
    let (k, delta) = (2.0, 0.01);
    let lower = rectangle_quad4([0.0, -1.0], [1.0, 0.0], [8, 8]);
    let upper = rectangle_quad4([0.0, -delta], [1.0, 1.0 - delta], [6, 6]);
    let scene = Scene::of(&[&lower, &upper]);
    for epsilon in [0.1 * delta, delta, 20.0 * delta] {
        let mut contact = scene.contact(Options::new(linear(k, epsilon)));
        let walls: Vec<usize> = (0..scene.coords.len()).filter(|&n| [0.0, 1.0].contains(&scene.coords[n][0])).collect();
        contact.set_symmetry_nodes(&walls.iter().map(|&n| n as u32).collect::<Vec<_>>()).expect("nodes");
        let found = contact.evaluate(&scene.coords).expect("valid coordinates");
        let energy = k * (delta.hypot(epsilon) - epsilon);
        let pressure = k * delta / delta.hypot(epsilon);
        assert!((found.energy / energy - 1.0).abs() < 5e-3, "{} instead of {energy}", found.energy);
        assert!((found.bodies[1].force[1] / pressure - 1.0).abs() < 5e-3, "{:?}", found.bodies[1]);
        assert!((found.pairs[0].pressure / pressure - 1.0).abs() < 1e-2, "{}", found.pairs[0].pressure);
        let nodal = contact.nodal_contact(&scene.coords).expect("valid coordinates");
        let most = nodal.pressure.iter().fold(0.0f64, |m, p| m.max(*p));
        assert!((most / pressure - 1.0).abs() < 1e-2, "{most} instead of {pressure}");
    }
}

/// Far below ε it is quadratic with the stiffness k/ε, far above it is k times the volume: on the same lines, to what is left of
/// the series.
#[test]
fn limits() {
    in_plane(|mut contact, coords| {
        let mut of = |law| {
            contact.set_options(lines(law, 0.01)).expect("valid options");
            contact.evaluate(&coords).expect("valid coordinates")
        };
        let (quadratic, long) = (of(EnergyLaw::depth(3.0)), of(linear(3e4, 1e4)));
        assert!((long.energy / quadratic.energy - 1.0).abs() < 1e-6);
        assert!(distance(&long.forces, &quadratic.forces) < 1e-6 * norm(&quadratic.forces));
        let (volume, short) = (of(EnergyLaw::volume(3.0)), of(linear(3.0, 1e-6)));
        assert!((short.energy / volume.energy - 1.0).abs() < 1e-3, "{} {}", short.energy, volume.energy);
    });
}

fn moved<const D: usize>(coords: &[[f64; D]], direction: &[[f64; D]], h: f64) -> Vec<[f64; D]> {
    coords.iter().zip(direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect()
}

fn directions<const D: usize>(coords: &[[f64; D]], random: &mut Splitmix) -> Vec<[f64; D]> {
    coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect()
}

fn dot<const D: usize>(x: &[[f64; D]], y: &[[f64; D]]) -> f64 {
    x.iter().flatten().zip(y.iter().flatten()).map(|(x, y)| x * y).sum()
}

/// On the same lines, but for three points a chord: where a chord is much longer than ε its energy is known to some 1e-4.
#[test]
fn the_force_is_the_slope_of_the_energy() {
    fn check<const D: usize>(mut contact: Contact<D>, coords: Vec<[f64; D]>, spacing: f64) {
        let mut random = Splitmix::new(7);
        contact.set_options(lines(linear(3.0, 0.1), spacing)).expect("valid options");
        let at = contact.evaluate(&coords).expect("valid coordinates");
        for _ in 0..4 {
            let direction = directions(&coords, &mut random);
            let energy = |h: f64| contact.evaluate(&moved(&coords, &direction, h)).expect("valid coordinates").energy;
            let slope = (energy(1e-7) - energy(-1e-7)) / 2e-7;
            let along = dot(&at.forces, &direction);
            assert!((along + slope).abs() < 1e-4 * size_sum(&at.forces), "{along} against {slope}");
        }
    }
    in_plane(|contact, coords| check(contact, coords, 1e-2));
    in_space(|contact, coords| check(contact, coords, 0.05));
}

/// Second differences of the energy on lines that are so dense that it is smooth within the step, but where a corner is all of
/// the overlap: to half a percent. In space, where it is not, the limit of the quadratic profile is checked.
#[test]
fn the_tangent() {
    let options = |law, spacing, weights| {
        let mut options = lines(law, spacing);
        if let Estimator::Fibers(fibers) = &mut options.estimator {
            fibers.weights = weights;
        }
        options
    };
    let mut scene = 0;
    in_plane(|mut contact, coords| {
        scene += 1;
        if scene == 2 {
            return;
        }
        let mut random = Splitmix::new(7);
        contact.set_options(options(linear(3.0, 0.1), 1e-3, LineWeights::Balance)).expect("valid options");
        let tangent = contact.tangent(&coords, TangentPart::Full).expect("valid coordinates");
        for _ in 0..4 {
            let direction = directions(&coords, &mut random);
            let energy = |h: f64| contact.evaluate(&moved(&coords, &direction, h)).expect("valid coordinates").energy;
            let step = 4e-3;
            let expected = (energy(step) - 2.0 * energy(0.0) + energy(-step)) / (step * step);
            let product = tangent.product(&direction);
            let (found, size) = (dot(&product, &direction), norm(&product) * norm(&direction));
            assert!((found - expected).abs() < 5e-3 * size, "{found} against {expected} of {size}");
        }
    });
    in_space(|mut contact, coords| {
        let direction = directions(&coords, &mut Splitmix::new(7));
        let mut product = |law| {
            contact.set_options(options(law, 0.05, LineWeights::Balance)).expect("valid options");
            contact.tangent(&coords, TangentPart::Full).expect("valid coordinates").product(&direction)
        };
        let (quadratic, long) = (product(EnergyLaw::depth(3.0)), product(linear(3e4, 1e4)));
        assert!(distance(&quadratic, &long) < 1e-6 * norm(&quadratic));
        // Semidefinite where pressures grow with depth.
        let tangent = contact.tangent(&coords, TangentPart::Semidefinite).expect("valid coordinates");
        assert!(dot(&tangent.product(&direction), &direction) > 0.0);
    });
}

#[test]
fn what_it_cannot_is_refused() {
    let refused = |result: Result<(), Error>, text: &str| {
        let error = result.expect_err(text);
        assert!(matches!(error, Error::Unsupported { what } if what.contains(text)), "{error:?}");
    };
    let lower = rectangle_tri3([0.0, -1.0], [1.0, 0.0], [2, 2], Diagonals::Same);
    let upper = rectangle_tri3([0.2, -0.05], [0.8, 0.5], [2, 2], Diagonals::Same);
    let scene = Scene::of(&[&lower, &upper]);
    let law = linear(1.0, 0.01);
    let exact = Options { estimator: Estimator::Exact, ..Options::new(law) };
    refused(Contact::new(scene.surface(), exact).map(drop), "smoothing_length, exactly");
    let axisymmetric = Options { axisymmetric: true, ..Options::new(law) };
    refused(Contact::new(scene.surface(), axisymmetric).map(drop), "axisymmetry");
    let mut contact = scene.contact(Options::new(law));
    contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::with_gap_offset(-0.01))).expect("an offset");
    refused(contact.evaluate(&scene.coords).map(drop), "gap_offset");
    let cube = Scene::of(&[&cuboid_tet4([0.0; 3], [1.0; 3], [2; 3])]);
    let mut contact = cube.contact(Options::new(law));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0, 0.1]) }).expect("an obstacle");
    refused(contact.evaluate(&cube.coords).map(drop), "obstacle");
}
