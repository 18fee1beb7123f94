//! Bodies of all shapes and obstacles of all kinds have, in parts, the bits of the whole.

use crate::communicator::on_ranks;
use crate::partition::{same_in_parts, sliding, stripes};
use crate::parts::{Part, compare, of_whole, told};
use crate::same_bits::solid_blocks;
use crate::scene::{Scene, consistent_lines, exact};
use fmc_contact::{EnergyLaw, Obstacle, Options, PartitionedContact, Pose, Shape, SignedDistance};
use fmc_shapes::{ball_tet4, disc_tri3, rectangle_quad4};
use std::sync::Arc;

/// A distance that a host gives: of a bar with waves, nowhere larger than the distance.
#[derive(Debug)]
struct Bar;

impl SignedDistance<2> for Bar {
    fn evaluate(&self, x: &[[f64; 2]], phi: &mut [f64], gradient: &mut [[f64; 2]]) -> Result<(), usize> {
        for ((x, phi), gradient) in x.iter().zip(phi).zip(gradient) {
            let steepest = 0.3f64.hypot(1.0);
            *phi = (x[1] + 0.1 * (3.0 * x[0]).sin()) / steepest;
            *gradient = [0.3 * (3.0 * x[0]).cos() / steepest, 1.0 / steepest];
        }
        Ok(())
    }
}

#[test]
fn with_obstacles_and_a_body_that_may_touch_itself() {
    let [a, b] = solid_blocks();
    let scene = Scene::of(&[&a, &b]);
    let path = [scene.coords.clone()];
    let obstacles = [
        Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0, 0.01]) },
        Obstacle { shape: Shape::Ball { radius: 0.8 }, pose: Pose::at([1.0, 1.0, -0.78]) },
        Obstacle { shape: Shape::Cuboid { half_extents: [0.6, 0.7, 0.2] }, pose: Pose::at([0.9, 0.8, 1.49]) },
    ];
    for self_contact in [false, true] {
        for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
            let options = Options { self_contact, ..Options::new(law) };
            same_in_parts(&scene, &path, options, &obstacles, 3, stripes(3, 2.0));
        }
    }
}

/// A body inside another, whose depth is measured from facets that are nowhere near.
#[test]
fn swallowed() {
    let a = rectangle_quad4([0.0, 0.0], [2.0, 2.0], [80, 80]);
    let b = rectangle_quad4([0.9, 0.8], [1.13, 1.04], [7, 6]).rotated(0.01);
    let scene = Scene::of(&[&a, &b]);
    for law in [EnergyLaw::volume(40.0), EnergyLaw::depth(50.0)] {
        let options = Options { law, ..exact() };
        same_in_parts(&scene, std::slice::from_ref(&scene.coords), options, &[], 4, |_, x| {
            usize::from(x[0] > 0.3) * 2 + usize::from(x[1] > 1.7)
        });
    }
}

/// Faces in a plane of symmetry, from which no depth is measured, and an axis.
#[test]
fn symmetry_and_an_axis() {
    let a = rectangle_quad4([0.0, 0.0], [2.0, 1.0], [40, 10]);
    let b = rectangle_quad4([0.0, 0.98], [0.5, 1.5], [11, 9]);
    let scene = Scene::of(&[&a, &b]);
    let in_plane = |x: &[f64; 2]| x[0] == 0.0;
    let nodes =
        |coords: &[[f64; 2]]| (0..coords.len() as u32).filter(|&n| in_plane(&coords[n as usize])).collect::<Vec<_>>();
    let plane = [[[0.0, 3.0], [-2.0, 0.0]]];
    for (axisymmetric, by_plane) in [(false, false), (false, true), (true, false)] {
        let options = Options { law: EnergyLaw::depth(50.0), axisymmetric, ..exact() };
        let mut whole = scene.contact(options);
        whole.set_symmetry_nodes(&nodes(&scene.coords)).unwrap();
        let expected = of_whole(&whole, &scene.coords);
        let found = on_ranks(3, None, |rank, own| {
            let part = Part::of(&scene, |cell, _| cell % 3 == rank);
            let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.02).unwrap();
            match by_plane {
                true => parts.set_symmetry_planes(&plane).unwrap(),
                false => parts.set_symmetry_nodes(&nodes(&part.coords)).unwrap(),
            }
            parts.set_coords(&part.coords).unwrap();
            told(parts.contact(), parts.coords(), parts.node_numbers(), scene.coords.len())
        });
        found.iter().for_each(|found| compare(found, &expected, "symmetry"));
    }
}

/// Round bodies, whose boxes meet beside the contact, apart and together; lines whose spacing follows from the boxes; and
/// depth below a ball, which is summed over all facets that are seen through it from the middle of the body.
#[test]
fn round_bodies() {
    let a = disc_tri3(1.0, 160);
    let b = disc_tri3(0.8, 130).translated([0.3, 1.75]);
    let scene = Scene::of(&[&a, &b]);
    let ball = Obstacle { shape: Shape::Ball { radius: 0.5 }, pose: Pose::at([-1.3, 0.65]) };
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        for options in [exact(), Options::new(law), consistent_lines(1e-3, 5)] {
            let options = Options { law, ..options };
            same_in_parts(&scene, &sliding(&scene, 0.01), options, std::slice::from_ref(&ball), 3, stripes(3, 1.5));
        }
    }
    let [a, b] = [ball_tet4(1.0, 3, 6), ball_tet4(0.7, 3, 5).translated([0.3, 0.2, 1.6])];
    let scene = Scene::of(&[&a, &b]);
    for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
        same_in_parts(&scene, &sliding(&scene, 0.01)[..1], Options { law, ..exact() }, &[], 3, |cell, _| cell % 3);
    }
}

/// A tall body, of which little is gathered, on obstacles of all kinds one by one.
#[test]
fn a_tall_body_on_obstacles() {
    let scene = Scene::of(&[&rectangle_quad4([0.0, 0.0], [2.0, 5.0], [40, 100]).rotated(0.01)]);
    let pentagon = (0..5).map(|k| f64::from(k) * std::f64::consts::TAU / 5.0).map(|a| [0.5 * a.cos(), 0.5 * a.sin()]);
    let shapes = [
        (Shape::HalfSpace, [0.0, 0.03]),
        (Shape::Cuboid { half_extents: [0.4, 0.2] }, [1.0, -0.16]),
        (Shape::Cuboid { half_extents: [3.0, 0.2] }, [1.0, -0.16]),
        (Shape::ConvexHull { points: pentagon.collect() }, [1.0, -0.42]),
        (Shape::Ball { radius: 0.5 }, [1.0, -0.45]),
        (Shape::Capsule { radius: 0.3, half_height: 0.4 }, [1.0, -0.65]),
        (Shape::SignedDistance(Arc::new(Bar)), [0.0, 0.03]),
    ];
    for (shape, at) in shapes {
        let obstacle = [Obstacle { shape, pose: Pose::at(at) }];
        for law in [EnergyLaw::volume(40.0), EnergyLaw::fiber(30.0), EnergyLaw::depth(50.0)] {
            for options in [exact(), Options::new(law)] {
                let options = Options { law, ..options };
                same_in_parts(&scene, std::slice::from_ref(&scene.coords), options, &obstacle, 3, |_, x| {
                    usize::from(x[1] > 0.07) + usize::from(x[1] > 2.0)
                });
            }
        }
    }
}
