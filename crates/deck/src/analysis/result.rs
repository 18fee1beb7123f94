//! What a step leaves.

use super::follow::{Borne, ReferenceResult};
use super::points::Point;
use super::ties::{self, TieResult};
use super::warnings::worded;
use fmc_contact::contact::{Adjustment, Interface, PairForces, PairOptions};
use fmc_contact::overlap::Partner;
use fmc_solid::statics::{Equilibrium, StaticsError};

/// A pair of bodies that touch or are tied.
#[derive(Clone, Debug, PartialEq)]
pub struct PairResult {
    /// Names of both.
    pub names: [String; 2],
    /// Whether they are tied.
    pub is_tied: bool,
    /// Force of the first on the second.
    pub force: [f64; 3],
    /// Area of contact.
    pub area: f64,
    /// Mean pressure.
    pub pressure: f64,
}

/// The end of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct StepResult {
    /// Its number, from 1.
    pub number: usize,
    /// Time since the first step began.
    pub time: f64,
    /// Linear systems solved, of all steps until then.
    pub iterations: usize,
    /// Norm of the forces that are not balanced.
    pub residual: f64,
    /// The largest norm of forces, of this step and those before it: what the residual is small against.
    pub largest_force: f64,
    /// What the start has closed and removed, if the file asks for it.
    pub adjustment: Option<Adjustment>,
    /// Sum of what holds the bodies.
    pub reaction: [f64; 3],
    /// Names of node sets whose reactions the file asks for, and the sum of each.
    pub sets: Vec<(String, [f64; 3])>,
    /// What holds every node of the model, and then every reference node that is none of the model.
    pub reactions: Vec<[f64; 3]>,
    /// What reference nodes bear.
    pub references: Vec<ReferenceResult>,
    /// Sum of the loads.
    pub load: [f64; 3],
    /// Thickness of bodies of the plane, which forces and areas are of.
    pub thickness: f64,
    /// Largest displacement of a node.
    pub displacement: f64,
    /// Pairs in contact.
    pub pairs: Vec<PairResult>,
    /// All ties.
    pub ties: Vec<TieResult>,
    /// Names of the bodies, and the force of contact and ties on each.
    pub bodies: Vec<(String, [f64; 3])>,
    /// What the library has to say.
    pub warnings: Vec<String>,
}

impl StepResult {
    /// Of a step that ends at a time; `sets` are points, by name, and `label` is that of a node in the file.
    ///
    /// # Errors
    /// Those of the contact.
    pub(super) fn new<const D: usize>(
        at: &Equilibrium<D>,
        (number, time): (usize, f64),
        largest_force: f64,
        sets: &[(String, Vec<Point>)],
        Borne { reactions, references, load }: Borne,
        label: &dyn Fn(usize) -> u64,
    ) -> Result<Self, StaticsError> {
        let (balance, model) = (at.balance(), at.model());
        let add = |sum: [f64; 3], force: &[f64; 3]| std::array::from_fn(|k| sum[k] + force[k]);
        let reaction = reactions.iter().fold([0.0; 3], add);
        let at_point = |point: &Point| match *point {
            Point::Node(node) => reactions[node],
            Point::Reference(number) => {
                references.iter().find(|result| result.number == number).map_or([0.0; 3], |result| result.force)
            }
            Point::Rotating(number) => {
                references.iter().find(|result| result.number == number).map_or([0.0; 3], |result| result.moment)
            }
        };
        let of_set = |points: &[Point]| points.iter().map(at_point).fold([0.0; 3], |sum, force| add(sum, &force));
        let sets = sets.iter().map(|(name, points)| (name.clone(), of_set(points))).collect();
        let in_space = |v: &[f64; D]| std::array::from_fn(|axis| v.get(axis).copied().unwrap_or(0.0));
        let name = |partner: &Partner| match partner {
            Partner::Body(body) => model.parts()[*body].name.clone(),
            Partner::Obstacle(obstacle) => format!("obstacle {obstacle}"),
        };
        let options = |pair: &PairForces| -> Option<PairOptions> {
            let (Partner::Body(a), Partner::Body(b)) = (pair.a, pair.b) else { return None };
            at.problem().pairs.iter().find(|(bodies, _)| *bodies == [a, b]).map(|(_, options)| *options)
        };
        // Of two rows of a pair the first is its contact, the last its tie.
        let is_last = |rows: &[PairForces], row: usize| {
            let same = |other: &PairForces| (other.a, other.b) == (rows[row].a, rows[row].b);
            !rows[row + 1..].iter().any(same)
        };
        let pair = |rows: &[PairForces], row: usize| {
            let pair = &rows[row];
            let is_held = options(pair).is_some_and(|options| options.interface != Interface::Contact);
            PairResult {
                names: [name(&pair.a), name(&pair.b)],
                is_tied: is_held && is_last(rows, row),
                force: pair.force,
                area: pair.contact_area,
                pressure: pair.pressure,
            }
        };
        let contact = &balance.contact;
        let names: Vec<String> = model.parts().iter().map(|part| part.name.clone()).collect();
        let warnings = worded(&contact.warnings, &at.warnings, &names, label);
        let squares = at.displacement().iter().map(|u| u.iter().map(|x| x * x).sum::<f64>());
        let bodies = contact.bodies.iter().zip(model.parts()).map(|(b, part)| (part.name.clone(), in_space(&b.force)));
        Ok(Self {
            number,
            time,
            iterations: at.iterations,
            residual: balance.norm,
            largest_force,
            adjustment: at.problem().adjust.map(|_| at.adjustment),
            reaction,
            sets,
            reactions,
            references,
            load,
            thickness: 1.0,
            displacement: squares.fold(0.0, f64::max).sqrt(),
            pairs: (0..contact.pairs.len()).map(|row| pair(&contact.pairs, row)).collect(),
            ties: ties::results(at)?,
            bodies: bodies.collect(),
            warnings,
        })
    }
}
