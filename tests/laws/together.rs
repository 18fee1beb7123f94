//! Forces and tangent in one call are those of two calls, to the bit.

use crate::pairs::{plane_scene, solid_scene};
use crate::scene::Scene;
use crate::scene::table::{exactly, laws, uncorrected};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, Error, FiberOptions, Obstacle, Options, Pose, Shape};

fn check<const D: usize>(scene: &Scene<D>, options: Options) {
    let contact = || {
        let mut contact = scene.contact(options);
        let pose = Pose::at([0.4; D]);
        contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).unwrap();
        contact
    };
    for part in [TangentPart::Full, TangentPart::Semidefinite] {
        let (forces, tangent) = contact().evaluate_tangent(&scene.coords, part).unwrap();
        assert!(forces.pairs.len() == 3 && !(tangent.blocks.is_empty() && tangent.rank_one.is_empty()), "{options:?}");
        assert_eq!(forces, contact().evaluate(&scene.coords).unwrap(), "{options:?}");
        assert_eq!(tangent, contact().tangent(&scene.coords, part).unwrap(), "{options:?}");
    }
}

#[test]
fn one_call_has_the_bits_of_two() {
    for law in laws(1.0) {
        let sampled = Options { law, ..crate::scene::fibers(FiberOptions::default()) };
        for options in [exactly(law), uncorrected(law, 0.02, 1), sampled, Options { threads: 3, ..sampled }] {
            // Of a volume with exponent 1 the semidefinite part is nothing.
            let options = match law {
                EnergyLaw::Volume { stiffness, .. } => {
                    Options { law: EnergyLaw::Volume { stiffness, exponent: 2.0 }, ..options }
                }
                _ => options,
            };
            check(&plane_scene(2), options);
            check(&solid_scene(1), options);
        }
    }
}

#[test]
fn what_has_no_tangent_is_refused() {
    let scene = plane_scene(2);
    let refused =
        scene.contact(crate::scene::isotropic(0.3, 100, 1)).evaluate_tangent(&scene.coords, TangentPart::Full);
    assert!(matches!(refused, Err(Error::Unsupported { .. })), "{refused:?}");
}
