//! What an evaluation returns.

use crate::Error;
use crate::contact::friction::{FrictionTotals, Tractions};
use crate::contact::laws::PairEnergy;
use crate::geometry::{Surface, Vector, moment};
use crate::overlap::{Partner, Warning};

/// Resultant on one body of the mesh or on one obstacle.
#[derive(Clone, Debug, PartialEq)]
pub struct Resultant<const D: usize> {
    /// Id of the body as given (or its number among the connected components); for an obstacle its index.
    pub id: i64,
    /// Sum of the contact forces on it. With axisymmetry its first entry is the sum of radial forces around the axis: for
    /// an obstacle, what resists a shift of its section away from the axis.
    pub force: [f64; D],
    /// Moment of the contact forces on it about the origin of space; in 2D only the last entry differs from zero, with
    /// axisymmetry none.
    pub moment: [f64; 3],
    /// The part of `force` that is friction.
    pub friction: [f64; D],
    /// Nodes of its surface; 0 for an obstacle.
    pub node_count: usize,
}

/// One overlapping pair.
#[derive(Clone, Debug, PartialEq)]
pub struct PairForces {
    /// First side.
    pub a: Partner,
    /// Second side; equal to `a` for a body that overlaps itself.
    pub b: Partner,
    /// Volume (2D: area) of what is inside both sides, each place once, with every law and estimator.
    pub volume: f64,
    /// Standard error of the volume.
    pub standard_error: f64,
    /// Energy w.
    pub energy: f64,
    /// Mean of the contact pressure over the contact: with the law `Volume` dw/dV, which is one for the whole pair;
    /// with `Fiber` ψ'(L), the mean over its lines; with `Depth` k times the depth of either surface below the
    /// other, the mean over both.
    pub pressure: f64,
    /// Area of contact (2D: length): half of the boundary of what is inside both sides, the strips of sunken side
    /// walls with it. The law `Fiber` does not see strips along its lines; with `Depth` and an obstacle it is the
    /// surface of the body that is inside. Facets that do not match gape between their nodes in hard contact; what
    /// gapes is not counted.
    pub contact_area: f64,
    /// How deep the sides reach into one another: with the law `Fiber` the longest of its lines, with `Depth` the
    /// largest depth of either surface below the other, with `Volume`, which knows no depth of a place, the extent
    /// of the overlap along its mean normal. The same where faces overlap flat. With `Fiber` and `Depth` k times it
    /// is the largest pressure.
    pub penetration: f64,
    /// Spacing of the fibers; 0 for `exact`. Given back as `Resolution::Spacing`, it keeps the pattern.
    pub spacing: f64,
    /// Force of the first side on the second, friction included; in 2D the last entry is 0. The second's on the first is its negative, up to what the estimator
    /// leaves unbalanced.
    pub force: [f64; 3],
    /// Moment of that force about the origin, as [`Resultant::moment`] has it.
    pub moment: [f64; 3],
    /// Its friction.
    pub friction: FrictionTotals,
}

/// Contact forces and what belongs to them.
///
/// Units follow from the coordinates and from k: with lengths in m and k in Pa (m = 1), forces are N in 3D and N/m (per
/// unit thickness) in 2D; with axisymmetry N, on whole rings, and volumes and areas are those of bodies of revolution.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactForces<const D: usize> {
    /// Force on every node, `[node_count, D]`, in the order of the coordinates: −∂w/∂x. It pushes bodies apart.
    pub forces: Vec<[f64; D]>,
    /// Volume (2D: area) of what is inside both sides, summed over the pairs.
    pub volume: f64,
    /// Standard error of that sum.
    pub standard_error: f64,
    /// Contact energy, summed over the pairs.
    pub energy: f64,
    /// Area of contact, summed over the pairs; see [`PairForces::contact_area`].
    pub contact_area: f64,
    /// Largest penetration of any pair; see [`PairForces::penetration`].
    pub penetration: f64,
    /// Fibers laid.
    pub fiber_count: usize,
    /// Crossings that bound an overlap.
    pub crossing_count: usize,
    /// Facets that bound an overlap.
    pub facet_count: usize,
    /// Resultants on the bodies, ordered by id.
    pub bodies: Vec<Resultant<D>>,
    /// Resultants on the obstacles.
    pub obstacles: Vec<Resultant<D>>,
    /// Friction, summed over the pairs.
    pub friction: FrictionTotals,
    /// The overlapping pairs.
    pub pairs: Vec<PairForces>,
    /// What the user should know.
    pub warnings: Vec<Warning>,
}

impl<const D: usize> ContactForces<D> {
    /// Sums up, in the order of the pairs; laws press at `coords`, friction acts at `places`.
    pub(crate) fn assemble(
        surface: &Surface<D>,
        obstacle_count: usize,
        (coords, places): (&[[f64; D]], &[[f64; D]]),
        pairs: &[PairEnergy<D>],
        tractions: &[Tractions<D>],
    ) -> Result<Self, Error> {
        let resultant = |id: i64, node_count: usize| Resultant {
            id,
            force: [0.0; D],
            moment: [0.0; 3],
            friction: [0.0; D],
            node_count,
        };
        let mut total = Self {
            forces: vec![[0.0; D]; coords.len()],
            volume: 0.0,
            standard_error: 0.0,
            energy: 0.0,
            contact_area: 0.0,
            penetration: 0.0,
            fiber_count: 0,
            crossing_count: 0,
            facet_count: 0,
            bodies: (surface.body_ids().iter().enumerate())
                .map(|(body, &id)| resultant(id, surface.surface_node_count(body)))
                .collect(),
            obstacles: (0..obstacle_count).map(|o| resultant(o as i64, 0)).collect(),
            friction: FrictionTotals::default(),
            pairs: Vec::with_capacity(pairs.len()),
            warnings: Vec::new(),
        };
        for pair in pairs {
            total.add(coords, pair);
        }
        for pair in tractions {
            total.add_friction(places, pair);
        }
        total.standard_error = total.standard_error.sqrt();
        total.check()?;
        Ok(total)
    }

    /// The same without moments, which cancel around an axis.
    pub(crate) fn without_moments(mut self) -> Self {
        self.bodies.iter_mut().chain(&mut self.obstacles).for_each(|resultant| resultant.moment = [0.0; 3]);
        self.pairs.iter_mut().for_each(|pair| pair.moment = [0.0; 3]);
        self
    }

    /// Checks that all numbers are finite; a force that is not shows in a resultant.
    fn check(&self) -> Result<(), Error> {
        let resultants = self.bodies.iter().chain(&self.obstacles);
        let force = resultants.flat_map(|r| r.force.iter().chain(&r.moment)).copied().find(|x| !x.is_finite());
        let quantities = [
            ("overlap volume", self.volume),
            ("standard error of the volume", self.standard_error),
            ("energy", self.energy),
            ("contact area", self.contact_area),
            ("penetration", self.penetration),
            ("energy of friction", self.friction.stored + self.friction.dissipated),
            ("resultant of a body", force.unwrap_or(0.0)),
        ];
        match quantities.into_iter().find(|(_, value)| !value.is_finite()) {
            Some((quantity, value)) => Err(Error::Overflow { quantity, value }),
            None => Ok(()),
        }
    }

    fn add(&mut self, coords: &[[f64; D]], pair: &PairEnergy<D>) {
        let overlap = &pair.overlap;
        let mut on_b = Resultant::none(0, 0);
        for ((&node, gradient), &of_b) in pair.nodes.iter().zip(&pair.gradient).zip(&pair.of_b) {
            let force = -gradient;
            for axis in 0..D {
                self.forces[node as usize][axis] += force[axis];
            }
            let x = Vector::from(coords[node as usize]);
            let moment = moment(&x, &force);
            self.resultant(if of_b { overlap.b } else { overlap.a }).add(&force, &moment);
            if of_b {
                on_b.add(&force, &moment);
            }
        }
        if let Some(pose) = &pair.pose_gradient {
            let (force, moment) = (-pose.position, pose.rotation.map(|m| -m));
            self.resultant(overlap.b).add(&force, &moment);
            on_b.add(&force, &moment);
        }
        let pair = PairForces {
            a: overlap.a,
            b: overlap.b,
            volume: overlap.volume,
            standard_error: overlap.standard_error,
            energy: pair.energy,
            pressure: pair.pressure,
            contact_area: overlap.contact_area,
            penetration: overlap.penetration,
            spacing: overlap.spacing,
            force: in_space(&on_b.force),
            moment: on_b.moment,
            friction: FrictionTotals::default(),
        };
        self.volume += pair.volume;
        self.standard_error += pair.standard_error * pair.standard_error;
        self.energy += pair.energy;
        self.contact_area += pair.contact_area;
        self.penetration = self.penetration.max(pair.penetration);
        self.fiber_count += overlap.fiber_count;
        self.crossing_count += overlap.crossing_count;
        self.facet_count += overlap.facet_count;
        self.pairs.push(pair);
        self.warnings.extend(overlap.warnings.iter().cloned());
    }

    fn add_friction(&mut self, coords: &[[f64; D]], pair: &Tractions<D>) {
        let [a, b] = pair.partners;
        let mut on_b = Resultant::none(0, 0);
        for ((&node, force), &of_b) in pair.nodes.iter().zip(&pair.forces).zip(&pair.of_b) {
            for axis in 0..D {
                self.forces[node as usize][axis] += force[axis];
            }
            let x = Vector::from(coords[node as usize]);
            let moment = moment(&x, force);
            self.resultant(if of_b { b } else { a }).add_friction(force, &moment);
            if of_b {
                on_b.add(force, &moment);
            }
        }
        let (force, moment) = &pair.on_obstacle;
        self.resultant(b).add_friction(force, moment);
        on_b.add(force, moment);
        self.friction = self.friction.plus(pair.totals);
        if let Some(found) = self.pairs.iter_mut().find(|found| (found.a, found.b) == (a, b)) {
            found.friction = pair.totals;
            let force = in_space(&on_b.force);
            found.force = std::array::from_fn(|axis| found.force[axis] + force[axis]);
            found.moment = std::array::from_fn(|axis| found.moment[axis] + on_b.moment[axis]);
        }
    }

    fn resultant(&mut self, partner: Partner) -> &mut Resultant<D> {
        match partner {
            Partner::Body(body) => &mut self.bodies[body],
            Partner::Obstacle(obstacle) => &mut self.obstacles[obstacle],
        }
    }
}

/// A vector as one in space.
fn in_space<const D: usize>(x: &[f64; D]) -> [f64; 3] {
    std::array::from_fn(|axis| x.get(axis).copied().unwrap_or(0.0))
}

impl<const D: usize> Resultant<D> {
    fn none(id: i64, node_count: usize) -> Self {
        Self { id, force: [0.0; D], moment: [0.0; 3], friction: [0.0; D], node_count }
    }

    fn add_friction(&mut self, force: &Vector<D>, moment: &[f64; 3]) {
        self.add(force, moment);
        for axis in 0..D {
            self.friction[axis] += force[axis];
        }
    }

    fn add(&mut self, force: &Vector<D>, moment: &[f64; 3]) {
        for axis in 0..D {
            self.force[axis] += force[axis];
        }
        for (sum, m) in self.moment.iter_mut().zip(moment) {
            *sum += m;
        }
    }
}
