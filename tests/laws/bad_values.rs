//! Bad options, obstacles and poses never pass silently, and leave a contact as it was.

use crate::bad_meshes::refused;
use crate::scene::{Scene, exact, fibers, lines};
use fmc_contact::contact::TangentPart;
use fmc_contact::{
    Bodies, CellBlock, Contact, EnergyLaw, Error, Estimator, FiberOptions, FiberPattern, Obstacle, Options, Pose,
    Resolution, Shape, Surface,
};
use fmc_shapes::{cuboid_surface, cuboid_tet4, rectangle_quad4};
use std::sync::Arc;

fn square() -> Scene<2> {
    Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [2, 2])])
}

#[test]
fn options_out_of_range() {
    let refused = |options: Options, name: &'static str| {
        let Err(Error::NotPositive { name: found, .. }) = Contact::new(square().surface(), options) else {
            panic!("{name} is not checked")
        };
        assert_eq!(found, name);
        let mut contact = square().contact(exact());
        assert!(contact.set_options(options).is_err());
        assert_eq!(contact.options(), &exact());
    };
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(Options::new(EnergyLaw::volume(bad)), "stiffness");
        refused(lines(bad, 0), "spacing");
        let pattern = FiberPattern::Isotropic { length: Some(bad) };
        refused(fibers(FiberOptions { pattern, ..FiberOptions::default() }), "fiber_length");
    }
    for bad in [0.999, 0.0, f64::NAN, f64::INFINITY] {
        refused(Options::new(EnergyLaw::Volume { stiffness: 1.0, exponent: bad }), "exponent");
    }
    refused(fibers(FiberOptions { resolution: Resolution::Count(0), ..FiberOptions::default() }), "fiber_count");
    refused(Options { threads: 0, ..exact() }, "threads");
}

#[test]
fn obstacles_out_of_range() {
    let mut contact = Scene::of(&[&cuboid_tet4([0.0; 3], [1.0; 3], [1; 3])]).contact(exact());
    let pose = Pose::at([0.0; 3]);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let shapes = [
            ("radius", Shape::Ball { radius: bad }),
            ("radius", Shape::Cylinder { radius: bad, half_height: 1.0 }),
            ("half_height", Shape::Cylinder { radius: 1.0, half_height: bad }),
            ("radius", Shape::Cone { radius: bad, half_height: 1.0 }),
            ("half_height", Shape::Cone { radius: 1.0, half_height: bad }),
            ("radius", Shape::Capsule { radius: bad, half_height: 1.0 }),
            ("half_height", Shape::Capsule { radius: 1.0, half_height: bad }),
            ("half_extent", Shape::Cuboid { half_extents: [1.0, bad, 1.0] }),
        ];
        for (name, shape) in shapes {
            let Err(Error::NotPositive { name: found, value }) = contact.add_obstacle(Obstacle { shape, pose }) else {
                panic!("{name} is not checked")
            };
            assert!(found == name && value.to_bits() == bad.to_bits());
        }
        let bad_pose = Pose { scale: bad, ..pose };
        refused(
            contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: bad_pose }),
            Error::BadPose { obstacle: 0 },
            &["0"],
        );
    }
    let mesh = cuboid_surface([0.0; 3], [1.0; 3], [1; 3]);
    let mut facets = mesh.facets();
    facets.pop();
    let open = contact.add_obstacle(Obstacle { shape: Shape::Polytope { points: mesh.coords, facets }, pose });
    assert!(matches!(open, Err(Error::OpenSurface { .. })));
    assert_eq!(contact.obstacle_count(), 0);
}

#[test]
fn poses_that_are_no_poses() {
    let mut contact = square().contact(exact());
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) }).unwrap();
    let mirror = Pose { rotation: [[1.0, 0.0], [0.0, -1.0]], ..Pose::at([0.0; 2]) };
    let sheared = Pose { rotation: [[1.0, 1e-3], [0.0, 1.0]], ..Pose::at([0.0; 2]) };
    let nowhere = Pose::at([0.0, f64::NAN]);
    for pose in [mirror, sheared, nowhere] {
        refused(contact.set_pose(0, pose), Error::BadPose { obstacle: 0 }, &["obstacle 0"]);
    }
    let expected = Error::ObstacleOutOfRange { obstacle: 1, count: 1 };
    refused(contact.set_pose(1, Pose::at([0.0; 2])), expected, &["obstacle 1", "only 1"]);
}

#[test]
fn exact_overlap_with_what_is_not_flat() {
    let distance = |x: &[f64; 2]| (x[0].hypot(x[1]) - 1.0, *x);
    for shape in [
        Shape::Ball { radius: 1.0 },
        Shape::Cylinder { radius: 1.0, half_height: 1.0 },
        Shape::Capsule { radius: 1.0, half_height: 1.0 },
        Shape::Cone { radius: 1.0, half_height: 1.0 },
        Shape::SignedDistance(Arc::new(distance)),
    ] {
        let scene = square();
        let mut contact = scene.contact(exact());
        contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.0; 2]) }).unwrap();
        assert!(matches!(contact.evaluate(&scene.coords), Err(Error::Unsupported { .. })));
        contact.set_options(lines(0.1, 0)).unwrap();
        assert!(contact.evaluate(&scene.coords).is_ok());
    }
}

/// A distance that is no number left of x = 1/2.
#[test]
fn distances_that_fail() {
    struct Failing;
    impl fmc_contact::SignedDistance<2> for Failing {
        fn evaluate(&self, x: &[[f64; 2]], phi: &mut [f64], _: &mut [[f64; 2]]) -> Result<(), usize> {
            phi.fill(1.0);
            if x.is_empty() { Ok(()) } else { Err(x.len() - 1) }
        }
    }
    let half = |x: &[f64; 2]| (if x[0] < 0.5 { f64::NAN } else { x[1] - 0.5 }, [0.0, 1.0]);
    for shape in [Shape::SignedDistance(Arc::new(Failing)), Shape::SignedDistance(Arc::new(half))] {
        let scene = square();
        let mut contact = scene.contact(lines(0.1, 0));
        contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) }).unwrap();
        contact.add_obstacle(Obstacle { shape, pose: Pose::at([0.0; 2]) }).unwrap();
        assert!(matches!(contact.evaluate(&scene.coords), Err(Error::SignedDistance { obstacle: 1, .. })));
    }
}

#[test]
fn more_fibers_than_can_be_counted() {
    let scene =
        Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [1, 1]), &rectangle_quad4([0.5; 2], [1.5; 2], [1, 1])]);
    let isotropic = FiberOptions {
        pattern: FiberPattern::Isotropic { length: None },
        resolution: Resolution::Count(usize::MAX),
        ..FiberOptions::default()
    };
    for options in [lines(1e-12, 0), lines(1e-300, 0), fibers(isotropic)] {
        let Err(Error::TooManyFibers { needed, limit }) = scene.contact(options).evaluate(&scene.coords) else {
            panic!("{options:?} is not refused")
        };
        assert!(needed > limit);
    }
}

/// What a machine cannot do in a moment is refused at once, and so is what lies beyond the range of a double.
#[test]
fn threads_lines_and_lengths_have_limits() {
    let scene =
        Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [1, 1]), &rectangle_quad4([0.5; 2], [1.5; 2], [1, 1])]);
    for threads in [1025, 100_000, usize::MAX] {
        let refused = Contact::new(scene.surface(), Options { threads, ..exact() });
        assert!(matches!(refused, Err(Error::Threads { threads: found }) if found == threads));
    }
    let many = FiberOptions { resolution: Resolution::Count(900_000_000), ..FiberOptions::default() };
    assert!(matches!(scene.contact(fibers(many)).evaluate(&scene.coords), Err(Error::TooManyFibers { .. })));
    let pattern = FiberPattern::Isotropic { length: Some(1e300) };
    let long = FiberOptions { pattern, resolution: Resolution::Count(1000), ..FiberOptions::default() };
    assert!(matches!(scene.contact(fibers(long)).evaluate(&scene.coords), Err(Error::Overflow { .. })));
}

/// Two blocks in whatever unit: their overlap, or a word that a double does not hold it; never none.
#[test]
fn sizes_are_measured_or_refused() {
    fn at<const D: usize>(scene: &Scene<D>, law: EnergyLaw, power: i32) -> Option<f64> {
        let size = 10f64.powi(power);
        let coords: Vec<[f64; D]> = scene.coords.iter().map(|x| x.map(|x| x * size)).collect();
        let blocks: Vec<_> =
            scene.blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        let surface = Surface::from_cells(&coords, &blocks, Bodies::Ids(&scene.ids));
        let contact = surface.and_then(|surface| Contact::new(surface, Options::new(law)));
        let found = contact.and_then(|contact| contact.evaluate(&coords));
        match found {
            Ok(found) => Some(found.volume / size.powi(D as i32)),
            Err(Error::Overflow { .. } | Error::ZeroMeasure { .. }) => None,
            Err(other) => panic!("{power}: {other}"),
        }
    }
    let plane =
        Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [2, 2]), &rectangle_quad4([0.3, 0.9], [1.5; 2], [1, 1])]);
    let solid = Scene::of(&[&cuboid_tet4([0.0; 3], [1.0; 3], [1; 3]), &cuboid_tet4([0.3, 0.3, 0.9], [1.5; 3], [1; 3])]);
    for law in [EnergyLaw::depth(1.0), EnergyLaw::fiber(1.0), EnergyLaw::volume(1.0)] {
        let [flat, deep] = [at(&plane, law, 0), at(&solid, law, 0)].map(Option::unwrap);
        assert!(flat > 0.05 && deep > 0.03);
        let mut told = 0;
        for power in (60..308).step_by(3).flat_map(|power| [power, -power]) {
            for (found, expected) in [(at(&plane, law, power), flat), (at(&solid, law, power), deep)] {
                // Powers of ten are not powers of two: digits are rounded anew.
                assert!(found.is_none_or(|found| (found / expected - 1.0).abs() < 1e-9), "{law:?}, {power}: {found:?}");
                told += usize::from(found.is_none());
            }
        }
        assert!(told > 200, "{told}");
    }
}

#[test]
fn tangents_are_finite_or_refused() {
    let scene =
        Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [1, 1]), &rectangle_quad4([0.5; 2], [1.5; 2], [1, 1])]);
    // 3 k is a double, 6 k is none.
    let law = EnergyLaw::Volume { stiffness: 5e307, exponent: 3.0 };
    let contact = scene.contact(Options { law, ..lines(0.05, 1) });
    assert!(contact.evaluate(&scene.coords).is_ok());
    let refused = contact.tangent(&scene.coords, TangentPart::Full);
    assert!(matches!(refused, Err(Error::Overflow { quantity: "tangent", .. })));
}

/// After any error a contact is as it was before.
#[test]
fn errors_leave_no_trace() {
    let scene =
        Scene::of(&[&rectangle_quad4([0.0; 2], [1.0; 2], [2, 2]), &rectangle_quad4([0.5; 2], [1.5; 2], [2, 2])]);
    let mut contact = scene.contact(lines(0.05, 1));
    contact.add_obstacle(Obstacle { shape: Shape::Ball { radius: 0.3 }, pose: Pose::at([0.0; 2]) }).unwrap();
    let before = contact.evaluate(&scene.coords).unwrap();
    let mut coords = scene.coords.clone();
    coords[3] = [f64::NAN, 0.0];
    assert!(contact.evaluate(&coords).is_err());
    coords[3] = [9.0, 9.0];
    assert!(contact.evaluate(&coords).is_err());
    assert!(contact.evaluate(&coords[1..]).is_err());
    assert!(contact.trace(&coords).is_err());
    assert!(contact.set_pose(0, Pose::at([0.0, f64::INFINITY])).is_err());
    assert!(contact.set_pose(7, Pose::at([0.0; 2])).is_err());
    assert!(contact.add_obstacle(Obstacle { shape: Shape::Ball { radius: -1.0 }, pose: Pose::at([0.0; 2]) }).is_err());
    assert!(contact.set_options(Options { threads: 0, ..exact() }).is_err());
    contact.set_options(Options { estimator: Estimator::Exact, ..exact() }).unwrap();
    assert!(contact.evaluate(&scene.coords).is_err());
    contact.set_options(lines(0.05, 1)).unwrap();
    assert_eq!(contact.obstacle_count(), 1);
    assert_eq!(format!("{:?}", contact.evaluate(&scene.coords).unwrap()), format!("{before:?}"));
}
