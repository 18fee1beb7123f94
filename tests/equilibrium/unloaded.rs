//! Bodies whose load is gone.

use super::bodies::{Block, Host};
use fmc_contact::contact::Contact;
use fmc_contact::contact::equilibrium::{DriverOptions, Equilibrium, Found, Next, Request};

pub(super) const WEIGHT: f64 = 1e3;

/// Two blocks one on the other, on a floor with friction, dragged along by a part of their weight.
pub(super) fn scene() -> Host {
    let mut host = Host::new(&[Block::unit(0.0, 0.0, 4), Block { low: [0.1, 1.0], high: [0.9, 2.0], cells: 3 }]);
    (0..2).for_each(|body| host.add_weight(body, [0.1 * WEIGHT, -WEIGHT]));
    host
}

/// The equilibrium from x with a part of the load, accepted.
pub(super) fn loaded(scene: &Host, part: f64, contact: &mut Contact<2>, x: &[f64]) -> Found<2> {
    let host = with_part(scene, part);
    let mut search = Equilibrium::new(contact, host.unknowns(), x, None, DriverOptions::default()).unwrap();
    let end = search.run(contact, |contact, request| host.answer(contact, request)).unwrap();
    let found = end.unwrap_or_else(|refusal| panic!("part {part}: {}", refusal.text)).clone();
    contact.commit_step(&moved(&host, &found.x)).unwrap();
    found
}

fn with_part(scene: &Host, part: f64) -> Host {
    let mut host = self::scene();
    host.load.iter_mut().zip(&scene.load).for_each(|(load, all)| *load = part * all);
    host
}

fn moved(host: &Host, x: &[f64]) -> Vec<[f64; 2]> {
    host.coords.iter().zip(x.chunks_exact(2)).map(|(at, by)| [at[0] + by[0], at[1] + by[1]]).collect()
}

/// Nothing presses, bodies are undeformed, in few solves, and have gone no farther than the load had moved them; pressed again, the floor
/// bears all.
#[test]
fn bodies_come_to_rest_undeformed() {
    let host = scene();
    let mut contact = host.contact(Some(0.0), 0.3);
    contact.begin_step(&host.coords).unwrap();
    let pressed = loaded(&host, 1.0, &mut contact, &vec![0.0; host.load.len()]);
    let far = |found: &Found<2>| found.x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let at_rest = loaded(&host, 0.0, &mut contact, &pressed.x);
    assert_eq!(at_rest.contact.forces.as_flattened().iter().fold(0.0, |most: f64, f| most.max(f.abs())), 0.0);
    assert!(at_rest.solves <= 6, "{} solves", at_rest.solves);
    assert!(far(&at_rest) <= 2.0 * far(&pressed), "{} of {}", far(&at_rest), far(&pressed));
    let again = loaded(&host, 1.0, &mut contact, &at_rest.x);
    let floor = again.contact.obstacles[0].force[1] / (-2.0 * WEIGHT);
    assert!((floor - 1.0).abs() < 1e-7, "{floor}");
}

/// A search that is left while bodies are relaxed as if apart leaves a contact that presses.
#[test]
fn a_search_that_is_left_leaves_the_contact_as_it_presses() {
    let host = scene();
    let mut contact = host.contact(Some(0.0), 0.3);
    contact.begin_step(&host.coords).unwrap();
    let pressed = loaded(&host, 1.0, &mut contact, &vec![0.0; host.load.len()]);
    let unloaded = with_part(&host, 0.0);
    let options = DriverOptions::default();
    let mut search = Equilibrium::new(&contact, unloaded.unknowns(), &pressed.x, None, options).unwrap();
    let mut answer = None;
    let at = loop {
        let Next::Asked(request) = search.next(&mut contact, answer.take()).unwrap() else { panic!("it has ended") };
        if let Request::Solve { x, .. } = request {
            break x.clone();
        }
        let request = request.clone();
        answer = Some(unloaded.answer(&contact, &request));
    };
    drop(search);
    // Sunk by a hair, so that it is another place, and everything presses.
    let mut coords = moved(&host, &at);
    coords.iter_mut().for_each(|x| x[1] -= 1e-5);
    let of = |contact: &Contact<2>| {
        let tangent = contact.tangent(&coords, Default::default()).unwrap();
        let motion: Vec<[f64; 2]> = coords.iter().map(|x| [x[1], -x[0]]).collect();
        (contact.evaluate(&coords).unwrap().forces, tangent.product(&motion))
    };
    let (forces, product) = of(&contact);
    assert!(forces.as_flattened().iter().any(|f| f.abs() > 1.0));
    assert!(product.as_flattened().iter().any(|f| f.abs() > 1.0));
}

/// A loose layer between a body that is held and a punch: pressed, left by the punch where nothing presses, and left farther. What is on it
/// then is rounding of its own forces, and drives it nowhere.
#[test]
fn a_layer_that_has_come_to_rest_stays() {
    let mut host = Host::new(&[
        Block { low: [0.0, 0.0], high: [2.0, 1.0], cells: 4 },
        Block { low: [0.0, 1.0], high: [2.0, 1.5], cells: 5 },
        Block { low: [0.5, 1.6], high: [1.5, 2.2], cells: 3 },
    ]);
    let top = |x: [f64; 2]| x[1] > 2.19;
    host.hold(1, |x| x[1] < 1e-9 || top(x));
    host.hold(0, |x| x[1] < 1e-9 || top(x));
    host.hold(0, |x| (1.0..1.51).contains(&x[1]) && x[0] == 0.0);
    let mut contact = host.contact(None, 0.0);
    let mut x = vec![0.0; host.load.len()];
    for down in [0.15, 0.05, 0.0] {
        let target: Vec<f64> = host.coords.iter().flat_map(|x| [0.0, if top(*x) { -down } else { 0.0 }]).collect();
        let mut search =
            Equilibrium::new(&contact, host.unknowns(), &x, Some(&target), DriverOptions::default()).unwrap();
        let end = search.run(&mut contact, |contact, request| host.answer(contact, request)).unwrap();
        x = end.unwrap_or_else(|refusal| panic!("{down}: {}", refusal.text)).x.clone();
    }
    assert!(contact.evaluate(&moved(&host, &x)).unwrap().contact_area < 1e-6);
}
