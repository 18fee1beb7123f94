//! With friction: by stiffness, coefficient and the slip at the start of the step, and by coordinates while it is frozen.

use crate::scene::{Scene, table::exactly};
use crate::{agrees, moved, random_rows};
use fmc_contact::contact::{Directions, FacetSlip, Friction};
use fmc_contact::{Contact, ContactForces, EnergyLaw, Options};
use fmc_shapes::{Diagonals, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

const STIFFNESS: f64 = 1e3;

/// A block on a larger one, which has been dragged and then is dragged on.
struct Step<const D: usize> {
    scene: Scene<D>,
    begin: Vec<[f64; D]>,
    slip: Vec<FacetSlip<D>>,
    end: Vec<[f64; D]>,
}

impl<const D: usize> Step<D> {
    fn new(scene: Scene<D>, options: Options, ways: [f64; 2]) -> Self {
        let dragged = |by: f64| {
            let mut coords = scene.coords.clone();
            scene.nodes_of(1).for_each(|node| coords[node][0] += by);
            coords
        };
        let (begin, end) =
            (dragged(ways[0]), moved(&dragged(ways[0] + ways[1]), 1e-5, &random_rows(scene.coords.len(), 7)));
        let mut contact = scene.contact(options);
        contact.begin_step(&scene.coords).expect("coordinates");
        contact.commit_step(&begin).expect("a step");
        let slip = contact.slip().expect("a step");
        Self { scene, begin, slip, end }
    }

    fn begun(&self, options: Options, slip: &[FacetSlip<D>]) -> Contact<D> {
        let mut contact = self.scene.contact(options);
        contact.begin_step(&self.begin).expect("coordinates");
        contact.set_slip(slip).expect("a slip");
        contact
    }

    fn at(&self, options: Options, slip: &[FacetSlip<D>]) -> ContactForces<D> {
        self.begun(options, slip).evaluate(&self.end).expect("forces")
    }
}

fn of_step<const D: usize>(scene: &Scene<D>, ways: [f64; 2], slides: bool) {
    for law in [EnergyLaw::depth, EnergyLaw::fiber] {
        let at = |k: f64, coefficient: f64, own: Option<f64>| {
            let friction = Friction { stiffness: own, ..Friction::coulomb(coefficient) };
            Options { friction, ..exactly(law(k)) }
        };
        for own in [None, Some(0.7 * STIFFNESS)] {
            let options = at(STIFFNESS, 0.4, own);
            let step = Step::new(scene.clone(), options, ways);
            let contact = step.begun(options, &step.slip);
            let totals = step.at(options, &step.slip).friction;
            assert_eq!(totals.slip_area > totals.stick_area, slides, "{totals:?}");
            let along = Directions { stiffness: 1e3, ..Directions::default() };
            agrees(&contact, &step.end, &along, |by| step.at(at(STIFFNESS + 1e3 * by, 0.4, own), &step.slip));
            // Limits are in proportion to the coefficient, of which a step may be as large as 1e-4; what sticks knows none.
            let along = Directions { friction: 1e2, ..Directions::default() };
            if slides {
                agrees(&contact, &step.end, &along, |by| step.at(at(STIFFNESS, 0.4 + 1e2 * by, own), &step.slip));
            }
            let mut rates = step.slip.clone();
            let rows = random_rows::<D>(rates.len(), 3);
            rates.iter_mut().zip(&rows).for_each(|(rate, row)| (rate.slip, rate.slid) = (*row, 0.0));
            let along = Directions { slip: &rates, ..Directions::default() };
            // In the plane what slides knows no slip.
            if D == 3 || !slides {
                agrees(&contact, &step.end, &along, |by| {
                    let mut slip = step.slip.clone();
                    let pairs = slip.iter_mut().zip(&rates);
                    pairs.for_each(|(one, rate)| (0..D).for_each(|i| one.slip[i] += by * rate.slip[i]));
                    step.at(options, &slip)
                });
            }
        }
    }
}

#[test]
fn in_the_plane() {
    let (below, above) = (([-1.0, -0.6], [1.2, 0.0]), ([-0.5, -0.01], [0.5, 0.69]));
    let lower = rectangle_tri3(below.0, below.1, [7, 2], Diagonals::Alternating);
    let scene = Scene::of(&[&lower, &rectangle_quad4(above.0, above.1, [4, 2])]);
    of_step(&scene, [1e-3, 8e-4], false);
    of_step(&scene, [3e-3, 4e-3], true);
}

#[test]
fn in_space() {
    let (below, above) = (([-1.0, -0.9, -0.6], [1.2, 0.8, 0.0]), ([-0.5, -0.4, -0.01], [0.5, 0.4, 0.69]));
    let lower = cuboid_tet4(below.0, below.1, [4, 3, 2]);
    let scene = Scene::of(&[&lower, &cuboid_hex8(above.0, above.1, [2, 3, 1])]);
    of_step(&scene, [1e-3, 8e-4], false);
    of_step(&scene, [3e-3, 4e-3], true);
}

/// While it is frozen there is a derivative by coordinates.
#[test]
fn frozen() {
    let (below, above) = (([-1.0, -0.6], [1.2, 0.0]), ([-0.5, -0.01], [0.5, 0.69]));
    let lower = rectangle_tri3(below.0, below.1, [7, 2], Diagonals::Alternating);
    let scene = Scene::of(&[&lower, &rectangle_quad4(above.0, above.1, [4, 2])]);
    let options = Options { friction: Friction::coulomb(0.4), ..exactly(EnergyLaw::depth(STIFFNESS)) };
    let step = Step::new(scene, options, [1e-3, 8e-4]);
    let mut contact = step.begun(options, &step.slip);
    contact.freeze_friction(&step.end).expect("friction");
    let rates = random_rows(step.end.len(), 13);
    let along = Directions { coords: Some(&rates), ..Directions::default() };
    agrees(&contact, &step.end, &along, |by| contact.evaluate(&moved(&step.end, by, &rates)).expect("forces"));
}
