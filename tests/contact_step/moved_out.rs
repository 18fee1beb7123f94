//! As little penetration as is wanted, by surfaces that are moved out between a host's own iterations.

use crate::equilibrium::{K, Scene, scene};
use crate::springs::square;
use fmc_contact::contact::{Friction, Multiplier};
use fmc_contact::overlap::Partner;
use fmc_contact::{EnergyLaw, EnergyProfile, Error, Estimator, FiberOptions, Options, PenetrationLaw};
use nalgebra::DVector;

/// The tip of a fan presses less than a facet: there a law that is stiffer leaves no mean penetration by itself.
#[test]
fn a_law_that_is_made_stiffer_needs_fewer_updates() {
    for k in [3.0 * K, 10.0 * K] {
        let run = |is_stiffened: bool| {
            let mut scene = scene(EnergyLaw::depth(k), 0.0);
            let (start, by_law) = scene.newton(DVector::zeros(scene.length()));
            let found = series(&mut scene, start, is_stiffened);
            balances(&scene, &found.at);
            (found.updates, found.iterations, by_law)
        };
        let (plain, stiffened) = (run(false), run(true));
        println!("k {k:e}: updates, iterations, by the law: {plain:?}, stiffened {stiffened:?}");
        assert!(stiffened.0 < plain.0 && stiffened.1 <= 5 * stiffened.2, "{stiffened:?}, {plain:?}");
    }
}

/// Updates until no node penetrates, in the mean over its part of the surface, by more than 1e-9.
pub(crate) struct Series {
    pub(crate) at: DVector<f64>,
    pub(crate) iterations: usize,
    pub(crate) updates: usize,
    pub(crate) count: usize,
}

pub(crate) fn series(scene: &mut Scene, mut at: DVector<f64>, is_stiffened: bool) -> Series {
    let (mut iterations, mut updates, mut last, mut raised) = (0, 0, f64::INFINITY, 1.0);
    loop {
        let found = scene.contact.augment(&scene.at(&at), 0.1, 1e-9).unwrap();
        println!("penetration {:.1e}, change {:.1e}, {} multipliers", found.penetration, found.change, found.count);
        if found.is_enough {
            assert!(found.penetration <= 1e-9);
            return Series { at, iterations, updates, count: found.count };
        }
        updates += 1;
        // As the drivers do.
        if is_stiffened && found.change > 0.25 * last && raised < 16.0 {
            scene.contact.stiffen(4.0).unwrap();
            (last, raised) = (f64::INFINITY, 4.0 * raised);
        } else {
            last = found.change;
        }
        let (next, more) = scene.newton(at);
        (at, iterations) = (next, iterations + more);
    }
}

/// What the contact presses with is what the bodies bear, and balances with the obstacle's.
pub(crate) fn balances(scene: &Scene, at: &DVector<f64>) {
    let forces = scene.contact.evaluate(&scene.at(at)).unwrap();
    let pressed = DVector::from_column_slice(forces.forces.as_flattened());
    assert!((&pressed - scene.pressed(at)).amax() < 1e-9 * pressed.amax());
    let of_obstacle = forces.obstacles[0].force;
    let sums: [f64; 2] = std::array::from_fn(|axis| forces.forces.iter().map(|f| f[axis]).sum());
    assert!((0..2).all(|axis| (sums[axis] + of_obstacle[axis]).abs() < 1e-10 * pressed.amax()));
}

/// A square pressed on a plane by a height of 0.01: moved out by what it penetrates, it presses twice as much where it is, and is let go
/// where it has come off.
#[test]
fn shifts_grow_by_the_penetration_and_shrink_by_the_gap() {
    let (coords, mut contact) = square(-0.01);
    let force =
        |contact: &fmc_contact::Contact<2>, coords: &[[f64; 2]]| contact.evaluate(coords).unwrap().bodies[0].force[1];
    let before = force(&contact, &coords);
    let found = contact.augment(&coords, 0.0, 1e-6).unwrap();
    assert!((found.penetration - 0.01).abs() < 1e-15 && (found.change - 0.01).abs() < 1e-15 && !found.is_enough);
    assert!((force(&contact, &coords) - 2.0 * before).abs() < 1e-9 * before);
    // The true surfaces are where they were.
    assert_eq!(contact.evaluate_true(&coords).unwrap().bodies[0].force[1], before);
    assert!((contact.nodal_penetration(&coords, 0.0).unwrap() - 0.01).abs() < 1e-15);
    for one in contact.multipliers() {
        assert_eq!(one.partners, [Partner::Body(0), Partner::Obstacle(0)]);
        assert!((one.shift - 0.01).abs() < 1e-15 && (one.towards[1] + 1.0).abs() < 1e-12, "{one:?}");
    }
    // Where it just touches the shift bears all, and stays.
    let (touching, _) = square(0.0);
    assert!((force(&contact, &touching) - before).abs() < 1e-9 * before);
    assert!(contact.augment(&touching, 0.0, 1e-9).unwrap().is_enough);
    let (apart, _) = square(0.004);
    contact.augment(&apart, 0.0, 1e-9).unwrap();
    assert!(contact.multipliers().iter().all(|one| (one.shift - 0.006).abs() < 1e-15));
    contact.augment(&apart, 0.0, 1e-9).unwrap();
    contact.augment(&apart, 0.0, 1e-9).unwrap();
    assert!(contact.multipliers().is_empty() && force(&contact, &coords) == before);
}

/// Out of reach of any gap they are let go, too.
#[test]
fn what_is_far_apart_has_none() {
    let (coords, mut contact) = square(-0.01);
    contact.augment(&coords, 0.0, 1e-6).unwrap();
    let (far, _) = square(5.0);
    let found = contact.augment(&far, 0.0, 1e-6).unwrap();
    assert!((found.change - 0.01).abs() < 1e-15 && found.count == 0 && found.penetration == 0.0, "{found:?}");
}

#[test]
fn they_are_set_again_after_a_step_that_is_thrown_away() {
    let (coords, mut contact) = square(-0.01);
    contact.augment(&coords, 0.0, 1e-6).unwrap();
    let (kept, forces) = (contact.multipliers(), contact.evaluate(&coords).unwrap());
    contact.augment(&coords, 0.0, 1e-6).unwrap();
    assert_ne!(contact.multipliers(), kept);
    contact.set_multipliers(&kept).unwrap();
    assert_eq!(contact.evaluate(&coords).unwrap(), forces);
    contact.set_multipliers(&[]).unwrap();
    assert_eq!(contact.evaluate(&coords).unwrap(), square(-0.01).1.evaluate(&coords).unwrap());
}

#[test]
fn what_cannot_be_is_refused() {
    let (coords, mut contact) = square(-0.01);
    let mut refused = |options: Options| {
        contact.set_options(options).unwrap();
        let error = contact.augment(&coords, 0.0, 1e-6).unwrap_err();
        assert!(matches!(error, Error::Unsupported { what } if what.contains("penetration")), "{error}");
    };
    let itself = Options { self_contact: true, ..Options::new(EnergyLaw::depth(1.0)) };
    let volume = Options::new(EnergyLaw::volume(1.0));
    // What a shift presses with would not stay when the law is made stiffer, and never comes to more than the law's k.
    let profile = EnergyProfile::Linear { smoothing_length: 1e-3 };
    let estimator = Estimator::Fibers(FiberOptions::default());
    let fiber = Options { estimator, ..Options::new(EnergyLaw::Fiber(PenetrationLaw { stiffness: 1.0, profile })) };
    for options in [itself, volume, fiber] {
        refused(options);
    }
    let law = Options::new(EnergyLaw::fiber(1.0));
    contact.set_options(law).unwrap();
    for (reach, enough) in [(-1.0, 1.0), (f64::NAN, 1.0), (1.0, -1.0), (1.0, f64::INFINITY)] {
        assert!(matches!(contact.augment(&coords, reach, enough), Err(Error::NotPositive { .. })));
    }
    contact.augment(&coords, 0.0, 1e-6).unwrap();
    let kept = contact.multipliers();
    for options in [itself, volume, fiber] {
        assert!(matches!(contact.set_options(options), Err(Error::Unsupported { .. })));
    }
    let with = |change: fn(&mut Multiplier<2>)| {
        let mut list = kept.clone();
        change(&mut list[0]);
        list
    };
    assert!(matches!(contact.set_multipliers(&with(|one| one.node = 4)), Err(Error::NodeOutOfRange { cell: 0, .. })));
    assert!(matches!(contact.set_multipliers(&with(|one| one.shift = 0.0)), Err(Error::NotPositive { .. })));
    assert!(matches!(contact.set_multipliers(&with(|one| one.towards = [0.0; 2])), Err(Error::NotPositive { .. })));
    let unknown = with(|one| one.partners[1] = Partner::Obstacle(7));
    assert!(matches!(contact.set_multipliers(&unknown), Err(Error::ObstacleOutOfRange { .. })));
    assert_eq!(contact.multipliers(), kept);
}

/// A block that slides is held by the coefficient times the pressure of the surfaces moved out; one that sticks by as much after its law
/// was made stiffer as before, and back again to the bit.
#[test]
fn friction_has_the_pressure_of_surfaces_moved_out() {
    let (coords, mut contact) = square(-0.01);
    let friction = Friction::coulomb(0.3);
    contact.set_options(Options { friction, ..Options::new(EnergyLaw::depth(crate::springs::K)) }).unwrap();
    contact.begin_step(&coords).unwrap();
    let by_law = contact.evaluate(&coords).unwrap().bodies[0].force[1];
    contact.augment(&coords, 0.0, 1e-6).unwrap();
    let moved = |by: f64| -> Vec<[f64; 2]> { coords.iter().map(|x| [x[0] + by, x[1]]).collect() };
    let of = |contact: &fmc_contact::Contact<2>, by: f64| contact.evaluate(&moved(by)).unwrap().bodies[0].force;
    let sliding = of(&contact, 0.1);
    println!("{by_law:e} {sliding:?}");
    // At its rims a contact bears less than k times the penetration, by a part of the order of 0.01.
    assert!((sliding[1] - 2.0 * by_law).abs() < 0.02 * by_law && (sliding[0] + 0.3 * sliding[1]).abs() < 0.01 * by_law);
    contact.commit_step(&moved(1e-3)).unwrap();
    let (before, kept) = (of(&contact, 1e-3), contact.slip().unwrap());
    contact.stiffen(4.0).unwrap();
    assert!((of(&contact, 1e-3)[0] - before[0]).abs() < 1e-12 * by_law && before[0] < 0.0);
    contact.stiffen(0.25).unwrap();
    assert_eq!((of(&contact, 1e-3), contact.slip().unwrap()), (before, kept));
}

/// What surfaces that just touch press with stays, and what they penetrate is resisted more.
#[test]
fn a_law_is_stiffened_with_the_same_pressures() {
    let (coords, mut contact) = square(-0.01);
    let force =
        |contact: &fmc_contact::Contact<2>, coords: &[[f64; 2]]| contact.evaluate(coords).unwrap().bodies[0].force[1];
    contact.augment(&coords, 0.0, 1e-6).unwrap();
    let (touching, _) = square(0.0);
    let [deep, light] = [force(&contact, &coords), force(&contact, &touching)];
    contact.stiffen(4.0).unwrap();
    assert_eq!(contact.options().law, EnergyLaw::fiber(4.0 * crate::springs::K));
    assert!((force(&contact, &touching) - light).abs() < 1e-9 * light);
    assert!((force(&contact, &coords) - light - 4.0 * (deep - light)).abs() < 1e-9 * deep);
    for factor in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e308] {
        assert!(matches!(contact.stiffen(factor), Err(Error::NotPositive { .. })), "{factor}");
    }
}
