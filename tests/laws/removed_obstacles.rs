//! Without a removed obstacle everything is as if it had never been there, but for the numbers of the others.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::table::exactly;
use crate::scene::{Scene, isotropic, lines};
use fmc_contact::contact::{PairOptions, TangentPart};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use std::sync::Arc;

/// A plane, a box that is to go, and a ball or, for the exact estimator, another box.
fn obstacles<const D: usize>(has_ball: bool) -> [Obstacle<D>; 3] {
    let last = if has_ball { Shape::Ball { radius: 0.4 } } else { Shape::Cuboid { half_extents: [0.3; D] } };
    let at = |shape, x: f64| Obstacle { shape, pose: Pose::at([x; D]) };
    [at(Shape::HalfSpace, 0.1), at(Shape::Cuboid { half_extents: [0.5; D] }, 0.5), at(last, 0.3)]
}

fn as_if_never_there<const D: usize>(scene: &Scene<D>, options: Options) {
    let given = obstacles::<D>(options.estimator != fmc_contact::Estimator::Exact);
    let [mut contact, mut fewer] = [options; 2].map(|options| scene.contact(options));
    for (index, obstacle) in given.iter().enumerate() {
        assert_eq!(contact.add_obstacle(obstacle.clone()).unwrap(), index);
    }
    fewer.add_obstacle(given[0].clone()).unwrap();
    fewer.add_obstacle(given[2].clone()).unwrap();
    contact.keep_patches(&scene.coords).unwrap();
    fewer.keep_patches(&scene.coords).unwrap();
    let with_it = contact.evaluate(&scene.coords).unwrap();
    contact.remove_obstacle(1).unwrap();
    assert_eq!(contact.obstacle_count(), 3);

    let (found, expected) = (contact.evaluate(&scene.coords).unwrap(), fewer.evaluate(&scene.coords).unwrap());
    assert!(with_it.energy > found.energy && found.pairs.len() >= 3);
    assert_eq!((&found.forces, found.energy, found.volume), (&expected.forces, expected.energy, expected.volume));
    assert_eq!(found.obstacles.len(), 3);
    assert_eq!([found.obstacles[0].force, found.obstacles[2].force], [0, 1].map(|o| expected.obstacles[o].force));
    assert_eq!((found.obstacles[1].force, found.obstacles[1].moment), ([0.0; D], [0.0; 3]));
    // The force of a pair is that on its second side: those on an obstacle add up to all that acts on it.
    let mut sums = vec![[0.0; D]; found.obstacles.len()];
    for pair in &found.pairs {
        if let Rigid(obstacle) = pair.b {
            (0..D).for_each(|axis| sums[obstacle][axis] += pair.force[axis]);
        }
    }
    let largest = sums.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    for (resultant, sum) in found.obstacles.iter().zip(&sums) {
        assert!(
            (0..D).all(|axis| (resultant.force[axis] - sum[axis]).abs() <= 1e-12 * largest),
            "{resultant:?} {sum:?}"
        );
    }
    let sides =
        |pairs: &[fmc_contact::contact::PairForces]| pairs.iter().map(|pair| (pair.a, pair.b)).collect::<Vec<_>>();
    let renumbered = sides(&expected.pairs).into_iter().map(|(a, b)| (a, if b == Rigid(1) { Rigid(2) } else { b }));
    assert_eq!(sides(&found.pairs), renumbered.collect::<Vec<_>>());

    // In the tangent its number stays, without entries.
    let part = TangentPart::Semidefinite;
    let (found, expected) =
        (contact.tangent(&scene.coords, part).unwrap(), fewer.tangent(&scene.coords, part).unwrap());
    let n = scene.coords.len() as u32;
    let number = |node: u32| if node == n + 1 { n + 2 } else { node };
    let places = expected.blocks.iter().map(|block| (number(block.row), number(block.col), block.value));
    assert!(found.blocks.iter().map(|block| (block.row, block.col, block.value)).eq(places));
    let nodes = expected.rank_one.iter().map(|part| part.nodes.iter().map(|&node| number(node)).collect::<Vec<_>>());
    assert!(found.rank_one.iter().map(|part| part.nodes.clone()).eq(nodes));
}

#[test]
fn what_was_removed_might_never_have_been_there() {
    for law in [EnergyLaw::Volume { stiffness: 2.0, exponent: 2.0 }, EnergyLaw::fiber(3.0)] {
        for threads in [1, 3] {
            for options in [exactly(law), Options { law, ..lines(0.05, 2) }] {
                as_if_never_there(&plane_scene(2), Options { threads, ..options });
                as_if_never_there(&solid_scene(1), Options { threads, ..options });
            }
        }
    }
    as_if_never_there(&plane_scene(2), exactly(EnergyLaw::depth(2.0)));
}

#[test]
fn its_number_is_an_error_and_is_not_given_again() {
    let scene = plane_scene(2);
    let mut contact = scene.contact(lines(0.05, 2));
    let distance = Arc::new(|x: &[f64; 2]| (x[1], [0.0, 1.0]));
    let kept = Arc::downgrade(&distance);
    let pose = Pose::at([9.0; 2]);
    contact.add_obstacle(Obstacle { shape: Shape::SignedDistance(distance), pose }).unwrap();
    let [wall, ..] = obstacles(false);
    let wall = contact.add_obstacle(wall).unwrap();
    let own = Some(PairOptions::with_law(EnergyLaw::volume(5.0)));
    contact.set_pair_options([Rigid(0), Body(0)], own).unwrap();
    contact.set_pair_options([Rigid(wall), Body(0)], own).unwrap();
    contact.remove_obstacle(0).unwrap();
    // What the host gave is let go.
    assert!(kept.upgrade().is_none());

    let before = format!("{:?}", contact.evaluate(&scene.coords).unwrap());
    let removed = Error::ObstacleRemoved { obstacle: 0 };
    assert_eq!(removed.to_string(), "obstacle 0 was removed");
    assert_eq!(contact.remove_obstacle(0), Err(removed.clone()));
    assert_eq!(contact.set_pose(0, pose), Err(removed.clone()));
    assert_eq!(contact.obstacle(0).err(), Some(removed.clone()));
    assert_eq!(contact.set_pair_options([Body(0), Rigid(0)], None), Err(removed.clone()));
    assert_eq!(contact.pair_options([Body(0), Rigid(0)]), Err(removed));
    assert_eq!(contact.remove_obstacle(2), Err(Error::ObstacleOutOfRange { obstacle: 2, count: 2 }));
    assert_eq!(contact.obstacle(2).err(), Some(Error::ObstacleOutOfRange { obstacle: 2, count: 2 }));
    assert_eq!(contact.pair_options([Body(0), Rigid(wall)]).unwrap(), own);
    assert_eq!(format!("{:?}", contact.evaluate(&scene.coords).unwrap()), before);

    let [_, cuboid, _] = obstacles(false);
    assert_eq!(contact.add_obstacle(cuboid).unwrap(), 2);
    contact.set_pose(2, pose).unwrap();
    let found = contact.obstacle(2).unwrap();
    assert!(matches!(found.shape, Shape::Cuboid { half_extents: [0.5, 0.5] }) && found.pose == pose);
}

/// The law of a pair stands in the way of an estimator; that of a pair that is gone does not.
#[test]
fn the_options_of_its_pairs_go_with_it() {
    let scene = plane_scene(2);
    let mut contact = scene.contact(exactly(EnergyLaw::fiber(1.0)));
    let [wall, ..] = obstacles(false);
    let wall = contact.add_obstacle(wall).unwrap();
    contact.set_pair_options([Rigid(wall), Body(0)], Some(PairOptions::with_law(EnergyLaw::fiber(2.0)))).unwrap();
    let by_segments = isotropic(0.3, 500, 2);
    assert!(matches!(contact.set_options(by_segments), Err(Error::OfPair { .. })));
    contact.remove_obstacle(wall).unwrap();
    contact.set_options(by_segments).unwrap();
}
