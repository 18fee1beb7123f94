//! What a search says of obstacles and nodes that were moved before it.

use super::bodies::{Block, Host};
use fmc_contact::contact::Contact;
use fmc_contact::contact::equilibrium::{DriverOptions, Equilibrium};
use fmc_contact::{Obstacle, Pose, Shape};
use std::f64::consts::PI;

/// Bodies with a contact, step by step.
struct Driven {
    host: Host,
    contact: Contact<2>,
    x: Vec<f64>,
    has_steps: bool,
}

impl Driven {
    /// A block that is held at its bottom, and an obstacle where it is added.
    fn new(block: Block, friction: f64, shape: Shape<2>, at: [f64; 2], has_steps: bool) -> Self {
        let mut host = Host::new(&[block]);
        (0..2).for_each(|axis| host.hold(axis, |x| x[1] < block.low[1] + 1e-9));
        let (mut contact, x) = (host.contact(None, friction), vec![0.0; host.load.len()]);
        contact.add_obstacle(Obstacle { shape, pose: Pose::at(at) }).unwrap();
        if has_steps {
            contact.begin_step(&host.coords).unwrap();
        }
        Self { host, contact, x, has_steps }
    }

    /// The warnings of the next search.
    fn search(&mut self) -> Vec<String> {
        let mut search =
            Equilibrium::new(&self.contact, self.host.unknowns(), &self.x, None, DriverOptions::default()).unwrap();
        let host = &self.host;
        let end = search.run(&mut self.contact, |contact, request| host.answer(contact, request)).unwrap();
        let found = end.unwrap_or_else(|refusal| panic!("{}", refusal.text)).clone();
        self.x = found.x;
        if self.has_steps {
            let placed =
                self.host.coords.iter().zip(self.x.as_chunks::<2>().0).map(|(x, u)| [x[0] + u[0], x[1] + u[1]]);
            self.contact.commit_step(&placed.collect::<Vec<_>>()).unwrap();
        }
        found.warnings
    }

    fn moved_to(&mut self, pose: Pose<2>) -> Vec<String> {
        self.contact.set_pose(0, pose).unwrap();
        self.search()
    }
}

fn overlaps(warnings: &[String]) -> Vec<&String> {
    warnings.iter().filter(|text| text.contains("at the start")).collect()
}

fn cuboid() -> Shape<2> {
    Shape::Cuboid { half_extents: [0.3, 0.5] }
}

/// An obstacle that is driven, and one that is lifted, overlaps by what it was moved by, which nobody has to be told.
#[test]
fn an_overlap_by_the_motion_of_an_obstacle_is_meant() {
    for (friction, has_steps) in [(0.0, false), (0.0, true), (0.3, true)] {
        let mut driven = Driven::new(Block::unit(0.0, 0.0, 4), friction, cuboid(), [0.52, 1.5], has_steps);
        driven.search();
        for (x, y) in [(0.52, 1.48), (0.52, 1.45), (0.54, 1.45), (0.56, 1.45), (0.56, 1.48), (0.56, 1.5), (0.56, 1.47)]
        {
            let warnings = driven.moved_to(Pose::at([x, y]));
            assert!(overlaps(&warnings).is_empty(), "{friction} {has_steps} {x} {y}: {warnings:?}");
        }
    }
}

/// The first step as well, once it has begun; and what overlaps where it began is told with its depth there, which is not that of the motion.
#[test]
fn an_overlap_from_before_the_first_step_is_told() {
    for friction in [0.0, 0.3] {
        let driven = |y: f64| Driven::new(Block::unit(0.0, 0.0, 4), friction, cuboid(), [0.52, y], true);
        let warnings = driven(1.5).moved_to(Pose::at([0.52, 1.47]));
        assert!(overlaps(&warnings).is_empty(), "{warnings:?}");
        let mut deep = driven(1.48);
        let warnings = deep.moved_to(Pose::at([0.52, 1.47]));
        assert!(overlaps(&warnings).len() == 1 && warnings[0].contains("overlap by 2.0e-2"), "{warnings:?}");
        // Once it was in equilibrium, it is what presses; another obstacle that is added where it overlaps is told.
        assert!(overlaps(&deep.moved_to(Pose::at([0.52, 1.46]))).is_empty());
        let pose = Pose::at([1.09, 0.5]);
        deep.contact.add_obstacle(Obstacle { shape: Shape::Ball { radius: 0.1 }, pose }).unwrap();
        let warnings = deep.search();
        let told = overlaps(&warnings);
        assert!(told.len() == 1 && told[0].contains("obstacle 1"), "{warnings:?}");
    }
}

/// Nodes that are not free are moved by whoever writes them: what they overlap by is meant too.
#[test]
fn an_overlap_by_nodes_that_were_moved_is_meant() {
    let mut host = Host::new(&[Block::unit(0.0, 0.0, 3), Block { low: [0.2, 1.0], high: [0.9, 1.5], cells: 2 }]);
    (0..2).for_each(|axis| host.hold(axis, |x| x[1] < 1e-9));
    let first = 2 * 16;
    host.free[first..].fill(false);
    let (contact, x) = (host.contact(None, 0.0), vec![0.0; host.load.len()]);
    let mut driven = Driven { host, contact, x, has_steps: false };
    driven.search();
    for depth in [0.01, 0.03, 0.06] {
        driven.x[first..].as_chunks_mut::<2>().0.iter_mut().for_each(|u| u[1] = -depth);
        let warnings = driven.search();
        assert!(overlaps(&warnings).is_empty(), "{depth}: {warnings:?}");
    }
}

/// A tool that is moved through a strip in one step is named, with the strip and how far it went; in short steps it presses.
#[test]
fn an_obstacle_that_is_moved_through_a_body_is_told() {
    let strip = Block { low: [-1.0, -0.4], high: [1.0, 0.0], cells: 8 };
    for (has_steps, since) in [(false, "since it was added"), (true, "in this step")] {
        for (shape, to) in [(Shape::Ball { radius: 0.5 }, -1.0), (Shape::Cuboid { half_extents: [0.3, 0.5] }, -1.0)] {
            let mut driven = Driven::new(strip, 0.0, shape.clone(), [0.01, 0.5], has_steps);
            let warnings = driven.moved_to(Pose::at([0.01, to]));
            let told = format!("obstacle 0 was moved by 1.5e0 {since}, straight through body 0");
            assert!(warnings.iter().any(|text| text.contains(&told)), "{warnings:?}");
            let mut pressed = Driven::new(strip, 0.0, shape, [0.01, 0.5], has_steps);
            for y in [0.45, 0.4, 0.7] {
                let warnings = pressed.moved_to(Pose::at([0.01, y]));
                assert!(!warnings.iter().any(|text| text.contains("through")), "{y}: {warnings:?}");
            }
            let warnings = pressed.moved_to(Pose::at([0.01, to]));
            assert!(warnings.iter().any(|text| text.contains("in this step, straight through body 0")), "{warnings:?}");
        }
    }
}

/// Nothing tells half a turn from one the other way round.
#[test]
fn half_a_turn_in_a_step_is_told_where_there_is_friction() {
    for (friction, angle, is_told) in [(0.3, PI, true), (0.3, 0.5 * PI, false), (0.0, PI, false)] {
        let block = Block::unit(0.0, 0.0, 4);
        let mut driven = Driven::new(block, friction, Shape::Ball { radius: 0.5 }, [0.52, 1.5], true);
        driven.moved_to(Pose::at([0.52, 1.49]));
        let warnings = driven.moved_to(Pose::at([0.52, 1.49]).turned(angle));
        let told = warnings.iter().any(|text| text.contains("obstacle 0 was turned by 180 degrees"));
        assert_eq!(told, is_told, "{friction} {angle}: {warnings:?}");
    }
}
