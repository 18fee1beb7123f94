//! Questions and answers.

use super::bodies::{Block, Host};
use fmc_contact::Error;
use fmc_contact::contact::equilibrium::{Answer, DriverOptions, Equilibrium, Next, Request, Unknowns};

fn scene() -> Host {
    let mut host = Host::new(&[Block::unit(0.0, 1e-3, 2)]);
    host.add_weight(0, [0.0, -1.0]);
    host
}

#[test]
fn a_question_stays_until_it_is_answered() {
    let host = scene();
    let mut contact = host.contact(Some(0.0), 0.0);
    let start = vec![0.0; host.load.len()];
    let mut search = Equilibrium::new(&contact, host.unknowns(), &start, None, DriverOptions::default()).unwrap();
    assert!(search.now().is_none());
    let Next::Asked(first) = search.next(&mut contact, None).unwrap() else { panic!("nothing was asked") };
    let first = first.clone();
    assert!(matches!(&first, Request::Forces { x, matrix: true } if *x == start));
    for _ in 0..3 {
        let Next::Asked(again) = search.next(&mut contact, None).unwrap() else { panic!("it has ended") };
        assert_eq!(*again, first);
    }
    // Of another length, and of another kind.
    let short = Answer::Forces { forces: vec![0.0; 3], energy: None };
    assert!(matches!(search.next(&mut contact, Some(short)), Err(Error::Length { expected: 18, found: 3, .. })));
    assert!(matches!(search.next(&mut contact, Some(Answer::Vector(start.clone()))), Err(Error::Unsupported { .. })));
    let Next::Asked(again) = search.next(&mut contact, None).unwrap() else { panic!("it has ended") };
    assert_eq!(*again, first);
    search.run(&mut contact, |contact, request| host.answer(contact, request)).unwrap().unwrap();
    // The end stays, whatever is answered.
    assert!(matches!(search.next(&mut contact, Some(Answer::Vector(start))).unwrap(), Next::Found(_)));
}

#[test]
fn a_host_that_refuses_is_told_of() {
    let host = scene();
    let mut contact = host.contact(Some(0.0), 0.0);
    let start = vec![0.0; host.load.len()];
    let mut search = Equilibrium::new(&contact, host.unknowns(), &start, None, DriverOptions::default()).unwrap();
    let end = search.run(&mut contact, |_, _| Answer::Refused("no memory".into())).unwrap();
    assert_eq!(end.unwrap_err().text, "no memory");
}

#[test]
fn wrong_problems_are_refused_by_name() {
    let host = scene();
    let contact = host.contact(None, 0.0);
    let (start, good) = (vec![0.0; host.load.len()], host.unknowns());
    let new = |unknowns: Unknowns<2>, x: &[f64], prescribed: Option<&[f64]>, options: DriverOptions| {
        Equilibrium::new(&contact, unknowns, x, prescribed, options).map(drop).unwrap_err()
    };
    let usual = DriverOptions::default();
    assert!(matches!(new(good.clone(), &start[1..], None, usual), Error::Length { array: "x", .. }));
    assert!(matches!(new(good.clone(), &start, Some(&start[2..]), usual), Error::Length { array: "prescribed", .. }));
    let free = Unknowns { free: vec![true; 3], ..good.clone() };
    assert!(matches!(new(free, &start, None, usual), Error::Length { array: "free", .. }));
    let mut far = good.clone();
    far.of_coordinate[7] = Some(99);
    assert!(matches!(new(far, &start, None, usual), Error::UnknownOutOfRange { row: 3, unknown: 99, count: 18 }));
    let mut lost = good.clone();
    lost.base[4][1] = f64::NAN;
    assert!(matches!(new(lost, &start, None, usual), Error::NonFiniteCoordinate { node: 4, axis: 1 }));
    for options in [
        DriverOptions { tolerance: 0.0, ..usual },
        DriverOptions { max_solves: 0, ..usual },
        DriverOptions { penetration: -1.0, ..usual },
    ] {
        assert!(matches!(new(good.clone(), &start, None, options), Error::NotPositive { .. }));
    }
}

/// A contact without a stiffness says so where it is evaluated before any was found.
#[test]
fn no_stiffness_is_told() {
    let host = scene();
    let contact = host.contact(Some(0.0), 0.0);
    assert_eq!(contact.evaluate(&host.coords).unwrap_err(), Error::NoStiffness);
    assert_eq!(contact.tangent(&host.coords, Default::default()).unwrap_err(), Error::NoStiffness);
    contact.gap_constraints(&host.coords, 0.1).unwrap();
}

/// Given up after any answer, a search leaves the forces of before, to the bit, and has ended. It rubs, moves surfaces out, and makes the
/// contact stiffer on the way.
#[test]
fn a_search_that_is_given_up_leaves_nothing_behind() {
    let mut host = Host::new(&[Block::unit(0.0, 0.0, 4), Block::unit(0.2, 1.0, 3)]);
    host.hold(0, |x| x[1] < 1e-9);
    host.hold(1, |x| x[1] < 1e-9);
    host.add_weight(1, [0.2, -1.0]);
    let mut contact = host.contact(None, 0.5);
    let first = host.solved(&mut contact, None).unwrap();
    let placed: Vec<[f64; 2]> =
        host.coords.iter().zip(first.x.as_chunks::<2>().0).map(|(x, u)| [x[0] + u[0], x[1] + u[1]]).collect();
    contact.commit_step(&placed).unwrap();
    // Another load: nothing is taken up.
    host.add_weight(1, [0.1, -1.0]);
    let options = DriverOptions { penetration: 1e-11, ..DriverOptions::default() };
    let wanted = (contact.evaluate(&placed).unwrap(), contact.multipliers());
    for answers in 0.. {
        let start = first.x.clone();
        let mut search = Equilibrium::new(&contact, host.unknowns(), &start, None, options).unwrap();
        let mut answer = None;
        for _ in 0..=answers {
            let Next::Asked(request) = search.next(&mut contact, answer).unwrap() else { break };
            let request = request.clone();
            answer = Some(host.answer(&contact, &request));
        }
        if let Some(Next::Found(_)) = search.now() {
            assert!(answers > 50, "it has ended after {answers} answers");
            search.abandon(&mut contact);
            assert!(matches!(search.now(), Some(Next::Found(_))), "what has ended stays");
            assert_ne!(contact.multipliers(), wanted.1, "nothing has happened");
            return;
        }
        search.abandon(&mut contact);
        assert!(matches!(search.next(&mut contact, None), Ok(Next::Refused(why)) if why.text.contains("abandoned")));
        assert_eq!((contact.evaluate(&placed).unwrap(), contact.multipliers()), wanted, "after {answers} answers");
    }
}
