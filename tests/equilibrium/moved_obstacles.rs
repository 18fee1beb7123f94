//! Obstacles that move between the start of a step and its search, where the search finds the stiffness.

use super::bodies::{Block, Host};
use fmc_contact::contact::Contact;
use fmc_contact::contact::equilibrium::{DriverOptions, Equilibrium};
use fmc_contact::{Obstacle, Pose, Shape};

const MU: f64 = 0.2;

/// What a search may leave of the penetration, and with it of the pressure that friction follows.
const LEFT: f64 = 1e-3;

struct Pressed {
    host: Host,
    contact: Contact<2>,
    x: Vec<f64>,
}

impl Pressed {
    /// A block that is held at its top, on a floor.
    fn new() -> Self {
        let mut host = Host::new(&[Block::unit(0.0, 0.0, 3)]);
        (0..2).for_each(|axis| host.hold(axis, |x| x[1] > 0.99));
        let (contact, x) = (host.contact(Some(0.0), MU), vec![0.0; host.load.len()]);
        Self { host, contact, x }
    }

    fn placed(&self) -> Vec<[f64; 2]> {
        let moved = self.x.as_chunks::<2>().0;
        self.host.coords.iter().zip(moved).map(|(x, u)| [x[0] + u[0], x[1] + u[1]]).collect()
    }

    /// The next equilibrium, accepted: shear by pressure, and what presses.
    fn step(&mut self) -> (f64, f64) {
        let (host, start) = (&self.host, self.x.clone());
        let mut search =
            Equilibrium::new(&self.contact, host.unknowns(), &start, None, DriverOptions::default()).unwrap();
        let found = search.run(&mut self.contact, |contact, request| host.answer(contact, request)).unwrap().unwrap();
        let force =
            found.contact.obstacles.iter().fold([0.0; 2], |sum, one| [sum[0] + one.force[0], sum[1] + one.force[1]]);
        self.x = found.x.clone();
        let placed = self.placed();
        self.contact.commit_step(&placed).unwrap();
        (force[0] / force[1], -force[1])
    }
}

/// A floor that is pressed in and drawn sideways slides: μ N, whatever the first search has yet to measure.
#[test]
fn what_has_begun_counts_from_where_obstacles_stood() {
    let mut pressed = Pressed::new();
    let coords = pressed.placed();
    pressed.contact.begin_step(&coords).unwrap();
    pressed.contact.set_pose(0, Pose::at([0.02, 0.01])).unwrap();
    let (ratio, _) = pressed.step();
    assert!((ratio.abs() / MU - 1.0).abs() < LEFT, "{ratio}");
}

/// The same where bodies have become another number of times as stiff, and where another obstacle comes near, below the first.
#[test]
fn what_is_measured_again_moves_no_obstacle() {
    for factor in [0.05, 1.0, 3.0, 6.0, 20.0] {
        for comes_another in [false, true] {
            let mut pressed = Pressed::new();
            pressed.contact.set_pose(0, Pose::at([0.0, 0.01])).unwrap();
            let (_, before) = pressed.step();
            pressed.host.stiffness *= factor;
            pressed.contact.set_pose(0, Pose::at([0.02, 0.01])).unwrap();
            if comes_another {
                let pose = Pose::at([0.0, 0.005]);
                pressed.contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).unwrap();
            }
            let (ratio, normal) = pressed.step();
            assert!((ratio.abs() / MU - 1.0).abs() < LEFT, "{factor}, {comes_another}: {ratio}");
            // Shear tilts what presses, and changes its sum by little: less than a multiplier that was lost would, 15 %.
            assert!(
                (normal / (factor * before) - 1.0).abs() < 0.02,
                "{factor}, {comes_another}: {normal} for {before}"
            );
        }
    }
}
