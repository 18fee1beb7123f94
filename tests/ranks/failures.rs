//! What goes wrong on one rank is told on all, and no rank waits for ever.

use crate::communicator::on_ranks;
use crate::scene::{Scene, exact};
use fmc_contact::{Communicator, Contact, EnergyLaw, Error, Options};
use fmc_shapes::rectangle_quad4;

fn scene() -> Scene<2> {
    let a = rectangle_quad4([0.0, 0.0], [2.0, 1.0], [200, 2]);
    Scene::of(&[&a, &rectangle_quad4([0.2, 0.99], [1.7, 1.9], [170, 2])])
}

fn shared(scene: &Scene<2>, options: Options, communicator: Box<dyn Communicator>) -> Contact<2> {
    let mut contact = scene.contact(options);
    contact.set_communicator(Some(communicator)).unwrap();
    contact
}

/// Of every rank: what it is told, and that the next evaluation is right again.
fn told(size: usize, change: impl Fn(usize, &mut Scene<2>, &mut Options) + Sync) -> Vec<Error> {
    let scene = scene();
    let options = Options { law: EnergyLaw::volume(2.0), ..exact() };
    let right = scene.evaluate(options);
    on_ranks(size, None, |rank, own| {
        let (mut mine, mut other) = (scene.clone(), options);
        change(rank, &mut mine, &mut other);
        let mut contact = shared(&scene, other, own);
        let error = contact.evaluate(&mine.coords).unwrap_err();
        contact.set_options(options).unwrap();
        assert_eq!(contact.evaluate(&scene.coords).unwrap(), right);
        error
    })
}

#[test]
fn an_error_on_one_rank_is_told_on_all() {
    let errors = told(3, |rank, scene, _| {
        if rank == 1 {
            scene.coords[5][0] = f64::NAN;
        }
    });
    assert_eq!(errors[1], Error::NonFiniteCoordinate { node: 5, axis: 0 });
    assert_eq!([&errors[0], &errors[2]], [&Error::OnOtherRank { rank: 1 }; 2]);
}

#[test]
fn other_coordinates_or_options_are_found_out() {
    for error in told(3, |rank, scene, _| scene.coords[7][1] += if rank == 2 { 1e-15 } else { 0.0 }) {
        assert_eq!(error, Error::RanksDiffer { rank: 2 });
    }
    for error in told(2, |rank, _, options| options.law = EnergyLaw::volume(if rank == 0 { 1.0 } else { 2.0 })) {
        assert_eq!(error, Error::RanksDiffer { rank: 1 });
    }
}

#[test]
fn ranks_that_ask_for_different_things_are_found_out() {
    let scene = scene();
    let options = Options { law: EnergyLaw::volume(2.0), ..exact() };
    let found = on_ranks(2, None, |rank, own| {
        let contact = shared(&scene, options, own);
        match rank {
            0 => contact.evaluate(&scene.coords).map(|_| ()),
            _ => contact.gap_constraints(&scene.coords, 0.1).map(|_| ()),
        }
    });
    assert!(
        found.iter().all(|found| matches!(found, Err(Error::RanksDiffer { .. } | Error::OnOtherRank { .. }))),
        "{found:?}"
    );
}

#[test]
fn a_communicator_that_fails_ends_the_evaluation() {
    let scene = scene();
    for call in 1..=4 {
        let found =
            on_ranks(1, Some((0, call)), |_, own| shared(&scene, exact(), own).evaluate(&scene.coords).map(|_| ()));
        let expected = if call < 3 { Err(Error::Communication { code: 7 }) } else { Ok(()) };
        assert_eq!(found[0], expected, "call {call}");
    }
}

#[test]
fn a_rank_that_is_none_is_refused() {
    struct Nobody;
    impl Communicator for Nobody {
        fn rank(&self) -> usize {
            3
        }
        fn size(&self) -> usize {
            3
        }
        fn all_gather(&self, _: &[u8], _: &[usize], _: &mut [u8]) -> Result<(), i32> {
            Ok(())
        }
    }
    let refused = scene().contact(exact()).set_communicator(Some(Box::new(Nobody)));
    assert_eq!(refused, Err(Error::BadRank { rank: 3, size: 3 }));
}
