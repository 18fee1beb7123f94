//! Derivatives by the slip at the start of a step, and of the slip at its end, against differences.

use crate::scene::Scene;
use crate::{STIFFNESS, in_plane, in_space, laws, slid};
use fmc_contact::contact::{FacetSlip, Friction, GradientRequest, PairGradient};
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::Splitmix;

/// A step: where it began, with what slip, and where it ends.
struct Case<'a, const D: usize> {
    scene: &'a Scene<D>,
    begin: Vec<[f64; D]>,
    slip: Vec<FacetSlip<D>>,
    end: Vec<[f64; D]>,
    /// Factors of the forces, and of the slip at the end.
    of_forces: Vec<[f64; D]>,
    of_slip: Vec<FacetSlip<D>>,
}

impl<'a, const D: usize> Case<'a, D> {
    /// The upper block slides on by `ways`.
    fn new(scene: &'a Scene<D>, options: Options, ways: [f64; 2]) -> Self {
        let mut random = Splitmix::new(7);
        let mut contact = scene.contact(options);
        contact.begin_step(&scene.coords).expect("coordinates");
        let begin = slid(scene, ways[0]);
        contact.commit_step(&begin).expect("a step");
        let mut end = slid(scene, ways[0] + ways[1]);
        end.iter_mut().flatten().for_each(|x| *x += 1e-5 * random.between(-1.0, 1.0));
        let of_forces: Vec<[f64; D]> = end.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let slip = contact.slip().expect("a step");
        contact.commit_step(&end).expect("a step");
        let mut of_slip = contact.slip().expect("a step");
        // Elastic slip is a force by k_T.
        of_slip.iter_mut().for_each(|one| one.slip = one.slip.map(|_| STIFFNESS * random.between(-1.0, 1.0)));
        Self { scene, begin, slip, end, of_forces, of_slip }
    }

    fn contact(&self, options: Options, slip: &[FacetSlip<D>]) -> Contact<D> {
        let mut contact = self.scene.contact(options);
        contact.begin_step(&self.begin).expect("coordinates");
        contact.set_slip(slip).expect("a slip");
        contact
    }

    fn value(&self, options: Options, slip: &[FacetSlip<D>]) -> f64 {
        let mut contact = self.contact(options, slip);
        let forces = contact.evaluate(&self.end).expect("forces").forces;
        let of_forces: f64 = forces.iter().flatten().zip(self.of_forces.iter().flatten()).map(|(f, a)| f * a).sum();
        contact.commit_step(&self.end).expect("a step");
        of_forces + product(&self.of_slip, &contact.slip().expect("a step"))
    }

    /// The largest difference of the derivatives by slip, stiffness and coefficient from differences, by the size of each; and the part of
    /// the area that slides.
    fn error(&self, options: Options, with_stiffness: impl Fn(Options, f64) -> Options) -> (f64, f64) {
        let mut request = GradientRequest::default();
        (request.slip, request.stiffness, request.friction) = (true, true, true);
        let contact = self.contact(options, &self.slip);
        let found =
            contact.vjp_of_step(&self.end, 0.0, Some(&self.of_forces), &self.of_slip, &request).expect("derivatives");
        let mut random = Splitmix::new(11);
        let mut along = self.slip.clone();
        along.iter_mut().for_each(|one| one.slip = one.slip.map(|_| random.between(-1.0, 1.0)));
        let moved = |by: f64| {
            let mut slip = self.slip.clone();
            slip.iter_mut().zip(&along).for_each(|(one, rate)| (0..D).for_each(|i| one.slip[i] += by * rate.slip[i]));
            self.value(options, &slip)
        };
        // Where all slides in the plane, nothing depends on the slip.
        let size = found.slip.iter().flat_map(|one| one.slip).map(|x| x * x).sum::<f64>().sqrt();
        let slope = |value: &dyn Fn(f64) -> f64, step: f64| (value(step) - value(-step)) / (2.0 * step);
        let mut error = if size > 0.0 {
            (product(&along, &found.slip) - slope(&moved, 1e-7)).abs() / size.max(0.01 * STIFFNESS)
        } else {
            0.0
        };
        let sum = |of: fn(&PairGradient) -> f64| found.pairs.iter().map(of).sum::<f64>();
        let by_stiffness = slope(&|by| self.value(with_stiffness(options, STIFFNESS + by), &self.slip), 1e-3);
        let by_coefficient = slope(
            &|by| {
                let friction = Friction { coefficient: options.friction.coefficient + by, ..options.friction };
                self.value(Options { friction, ..options }, &self.slip)
            },
            1e-6,
        );
        let totals = contact.evaluate(&self.end).expect("forces").friction;
        let part = totals.slip_area / (totals.slip_area + totals.stick_area);
        for (exact, slope) in [(sum(|pair| pair.stiffness), by_stiffness), (sum(|pair| pair.friction), by_coefficient)]
        {
            // What sticks does not depend on the coefficient.
            if slope != 0.0 || exact != 0.0 {
                error = error.max((exact - slope).abs() / exact.abs());
            }
        }
        (error, part)
    }
}

fn product<const D: usize>(factors: &[FacetSlip<D>], slip: &[FacetSlip<D>]) -> f64 {
    let same = |one: &FacetSlip<D>, other: &FacetSlip<D>| {
        (one.facet, one.partner, one.is_second) == (other.facet, other.partner, other.is_second)
    };
    let of_one = |one: &FacetSlip<D>| {
        slip.iter()
            .find(|other| same(one, other))
            .map_or(0.0, |other| (0..D).map(|i| one.slip[i] * other.slip[i]).sum())
    };
    factors.iter().map(of_one).sum()
}

fn of_law(options: Options, stiffness: f64) -> Options {
    let law = match options.law {
        EnergyLaw::Depth { .. } => EnergyLaw::depth(stiffness),
        _ => EnergyLaw::fiber(stiffness),
    };
    Options { law, ..options }
}

fn all<const D: usize>(scenes: &[Scene<D>; 2], ways: [f64; 2], is_part: impl Fn(f64) -> bool) {
    for scene in scenes {
        for law in laws(0.4) {
            let own = Friction { stiffness: Some(0.7 * STIFFNESS), ..law.friction };
            for options in [law, Options { friction: own, ..law }] {
                let (error, part) = Case::new(scene, options, ways).error(options, of_law);
                assert!(error < 1e-7 && is_part(part), "{error:e} {part} {options:?}");
            }
        }
    }
}

#[test]
fn of_what_sticks() {
    all(&in_plane(1e-2), [1e-3, 8e-4], |part| part < 0.5);
    all(&in_space(1e-2), [1e-3, 8e-4], |part| part < 0.5);
}

#[test]
fn of_what_slides() {
    all(&in_plane(1e-2), [3e-3, 4e-3], |part| part > 0.5);
    all(&in_space(1e-2), [3e-3, 4e-3], |part| part > 0.5);
}

#[test]
fn without_memory_nothing_depends_on_the_start() {
    for law in laws(0.4) {
        let options = Options { friction: Friction { memoryless_slip: Some(5e-3), ..law.friction }, ..law };
        let scene = &in_space(1e-2)[0];
        let case = Case::new(scene, options, [1e-3, 2e-3]);
        let (error, _) = case.error(options, of_law);
        assert!(error < 1e-7 && case.slip.is_empty(), "{error:e}");
    }
}
