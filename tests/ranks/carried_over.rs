//! What was begun, kept or frozen stays when other cells are gathered, and on another number of ranks.

use crate::communicator::on_ranks;
use crate::partition::{sliding, stripes};
use crate::parts::{Part, compare, of_whole, told};
use crate::same_bits::plane_blocks;
use crate::scene::{Scene, exact};
use fmc_contact::contact::Friction;
use fmc_contact::{CarriedSlip, Contact, EnergyLaw, Options, PartitionedContact};
use fmc_shapes::rectangle_quad4;

/// Kept patches and frozen friction stay where other cells are gathered, and so does a step that began elsewhere.
#[test]
fn what_was_kept_and_frozen_stays() {
    let a = rectangle_quad4([0.0, 0.0], [20.0, 1.0], [2000, 10]);
    let b = rectangle_quad4([0.2, 0.995], [0.7, 1.5], [47, 40]);
    let scene = Scene::of(&[&a, &b]);
    // In the end by some thirty cells, farther than what was gathered for where it began.
    let path = sliding(&scene, 0.2);
    for (law, commits) in
        [(EnergyLaw::fiber(30.0), true), (EnergyLaw::depth(50.0), true), (EnergyLaw::depth(5.0), false)]
    {
        let friction = Friction { coefficient: 0.4, stiffness: Some(20.0), ..Friction::default() };
        let options = Options { law, friction, ..exact() };
        let do_all = |contact: &mut Contact<2>, coords: &[[f64; 2]], number: usize| match number {
            0 => contact.begin_step(coords).unwrap(),
            1 => {
                if commits {
                    contact.commit_step(coords).unwrap();
                }
                contact.freeze_friction(coords).unwrap();
                contact.keep_patches(coords).map(drop).unwrap();
            }
            _ => {}
        };
        let mut whole = scene.contact(options);
        let mut expected = Vec::new();
        for (number, coords) in path.iter().enumerate() {
            do_all(&mut whole, coords, number);
            expected.push(of_whole(&whole, coords));
        }
        let found = on_ranks(3, None, |rank, own| {
            let part = Part::of(&scene, |cell, x| stripes(3, 20.0)(cell, x) == rank);
            let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.02).unwrap();
            let mut found = Vec::new();
            for (number, coords) in path.iter().enumerate() {
                parts.set_coords(&part.here(coords)).unwrap();
                let here = parts.coords().to_vec();
                do_all(parts.contact_mut(), &here, number);
                found.push(told(parts.contact(), &here, parts.node_numbers(), coords.len()));
            }
            assert!(parts.counts().gather_count > 2);
            found
        });
        for found in found {
            for (number, (found, expected)) in found.iter().zip(&expected).enumerate() {
                compare(found, expected, &format!("step {number}, {law:?}"));
            }
        }
    }
}

/// A run with friction on three ranks goes on with two, and ends with the bits of one.
#[test]
fn a_restart_on_another_number_of_ranks() {
    let scene = Scene::of(&plane_blocks().each_ref());
    let path = sliding(&scene, 7e-3);
    let friction = Friction { coefficient: 0.4, stiffness: Some(20.0), ..Friction::default() };
    let options = Options { law: EnergyLaw::depth(50.0), friction, ..exact() };
    let mut whole = scene.contact(options);
    whole.begin_step(&path[0]).unwrap();
    whole.commit_step(&path[1]).unwrap();
    whole.commit_step(&path[2]).unwrap();
    let expected = of_whole(&whole, &path[3]);
    let run = |size: usize, from: Option<&[CarriedSlip<2>]>, steps: &[usize]| {
        on_ranks(size, None, |rank, own| {
            let part = Part::of(&scene, |cell, x| stripes(size, 2.0)(cell, x) == rank);
            let mut parts = PartitionedContact::new(own, &part.given(&part.blocks()), options, 0.02).unwrap();
            for (number, &step) in steps.iter().enumerate() {
                parts.set_coords(&part.here(&path[step])).unwrap();
                let here = parts.coords().to_vec();
                match number {
                    0 => parts.contact_mut().begin_step(&here).unwrap(),
                    _ => parts.contact_mut().commit_step(&here).unwrap(),
                }
                if let (Some(slip), 0) = (from, number) {
                    parts.set_slip(slip).unwrap();
                }
            }
            parts.set_coords(&part.here(&path[3])).unwrap();
            let told = told(parts.contact(), parts.coords(), parts.node_numbers(), scene.coords.len());
            (parts.slip().unwrap(), told)
        })
    };
    let before = run(3, None, &[0, 1]);
    assert!(before[0].0.len() > 100 && before.iter().all(|(slip, _)| *slip == before[0].0));
    for (_, found) in run(2, Some(&before[0].0), &[1, 2]) {
        compare(&found, &expected, "after a restart");
    }
}
