//! From coordinates to overlaps.

use super::balance::{self, balance};
use super::candidate::Candidate;
use super::forces::ContactForces;
use super::options::Options;
use super::pair_energy::PairEnergy;
use super::partners::{Rigid, check_pose};
use super::tangent::{Tangent, TangentPart};
use crate::Error;
use crate::geometry::{Bodies, CellBlock, Obstacle, Pose, Surface};
use crate::overlap::{Estimator, FiberTrace, Overlap, Partner, Patches};

/// Contact between the bodies of one mesh, and with rigid obstacles.
///
/// It holds topology, obstacles and options, and nothing of any evaluation: two evaluations at the same coordinates give
/// the same bits, and [`contact_force`] gives the same bits as a `Contact` that is kept.
pub struct Contact<const D: usize> {
    pub(super) surface: Surface<D>,
    pub(super) obstacles: Vec<Rigid<D>>,
    pub(super) options: Options,
    pub(super) pool: Option<rayon::ThreadPool>,
    /// Patches of the fiber law that are kept, by pair.
    pub(super) kept: Vec<([Partner; 2], Patches<D>)>,
}

impl<const D: usize> Contact<D> {
    /// Contact between the bodies of `surface`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for an option out of its range; [`Error::Threads`].
    pub fn new(surface: Surface<D>, options: Options) -> Result<Self, Error> {
        options.check()?;
        Ok(Self { surface, obstacles: Vec::new(), options, pool: pool(options.threads)?, kept: Vec::new() })
    }

    /// Adds a rigid partner and returns its index.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::BadPose`]; for a polytope those of [`Surface::from_facets`].
    pub fn add_obstacle(&mut self, obstacle: Obstacle<D>) -> Result<usize, Error> {
        let index = self.obstacles.len();
        self.obstacles.push(Rigid::new(obstacle, index)?);
        Ok(index)
    }

    /// Moves an obstacle.
    ///
    /// # Errors
    /// [`Error::ObstacleOutOfRange`], [`Error::BadPose`].
    pub fn set_pose(&mut self, obstacle: usize, pose: Pose<D>) -> Result<(), Error> {
        check_pose(&pose, obstacle)?;
        let count = self.obstacles.len();
        let rigid = self.obstacles.get_mut(obstacle).ok_or(Error::ObstacleOutOfRange { obstacle, count })?;
        rigid.obstacle.pose = pose;
        Ok(())
    }

    /// Replaces the options. Patches that are kept stay so with another law, and are forgotten with another estimator.
    ///
    /// # Errors
    /// As [`Self::new`]; the old options then stay in force.
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        options.check()?;
        if options.threads != self.options.threads {
            self.pool = pool(options.threads)?;
        }
        if options.estimator != self.options.estimator {
            self.release_patches();
        }
        self.options = options;
        Ok(())
    }

    /// The options in force.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The surface.
    pub fn surface(&self) -> &Surface<D> {
        &self.surface
    }

    /// Number of obstacles.
    pub fn obstacle_count(&self) -> usize {
        self.obstacles.len()
    }

    /// Contact forces at `coords`, `[node_count, D]`.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`], [`Error::InvertedCell`], [`Error::ZeroMeasure`],
    /// [`Error::TooManyFibers`], [`Error::Unsupported`], [`Error::SignedDistance`], [`Error::Overflow`].
    pub fn evaluate(&self, coords: &[[f64; D]]) -> Result<ContactForces<D>, Error> {
        let law = &self.options.law;
        let pairs = if law.is_fiber() {
            let balanced = self.is_balanced();
            self.for_each_pair(coords, |candidate| {
                let spans = self.spans(candidate, false)?;
                Ok(spans.map(|spans| PairEnergy::of_spans(&spans, candidate.fibers.pair, law, balanced, coords)))
            })?
        } else {
            let overlaps = self.overlaps(coords)?;
            overlaps.into_iter().map(|overlap| PairEnergy::of_volume(overlap, law)).collect()
        };
        ContactForces::assemble(&self.surface, self.obstacles.len(), coords, &pairs)
    }

    /// Second derivative of the contact energy at `coords`.
    ///
    /// For the fiber law on kept patches and for the volume law with the exact estimator or consistent weights it is
    /// the derivative of the forces, with balance off; the correction of the balance, which is small, is not
    /// differentiated. With balance weights it is that of consistent ones. The exact volume law has no finite tangent
    /// where facets lie flat on one another.
    ///
    /// # Errors
    /// As [`Self::evaluate`]; [`Error::Unsupported`] for isotropic fibers, and for the exact volume law with a body
    /// against itself.
    pub fn tangent(&self, coords: &[[f64; D]], part: TangentPart) -> Result<Tangent<D>, Error> {
        let law = &self.options.law;
        let tangents = self.for_each_pair(coords, |candidate| {
            let Candidate { fibers, exact } = candidate;
            let pair = fibers.pair;
            let obstacle = if let Partner::Obstacle(obstacle) = pair.partners[1] { obstacle } else { 0 };
            let number = (coords.len() + obstacle) as u32;
            if law.is_fiber() {
                let spans = self.spans(candidate, part == TangentPart::Full)?;
                return Ok(spans.map(|spans| Tangent::of_spans(&spans, pair, law, part, number)));
            }
            if exact.is_none() && fibers.families.is_empty() {
                return Err(Error::Unsupported { what: "the tangent on isotropic fibers" });
            }
            let overlap = match exact {
                Some(exact) => exact.overlap()?,
                None => fibers.overlap()?,
            };
            let Some(overlap) = overlap.filter(|overlap| overlap.volume > 0.0) else { return Ok(None) };
            let blocks = match (part, exact) {
                (TangentPart::Semidefinite, _) => Vec::new(),
                (_, Some(exact)) => exact.hessian(number)?,
                _ => fibers.volume_spans()?.map_or(Vec::new(), |s| s.hessian(pair, LINEAR, false, number)),
            };
            Ok(Some(Tangent::of_volume(&overlap, blocks, law, number)))
        })?;
        let mut total = Tangent::default();
        tangents.into_iter().for_each(|tangent| total.extend(tangent));
        total.merge();
        Ok(total)
    }

    /// Overlaps of all pairs at `coords` that overlap, with their gradients, ordered by pair. With the fiber law they
    /// are measured along its lines.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    pub fn overlaps(&self, coords: &[[f64; D]]) -> Result<Vec<Overlap<D>>, Error> {
        self.for_each_pair(coords, |candidate| {
            let overlap = match &candidate.exact {
                _ if self.options.law.is_fiber() => {
                    self.spans(candidate, false)?.map(|spans| spans.overlap(candidate.fibers.pair))
                }
                Some(exact) => exact.overlap()?,
                None => candidate.fibers.overlap()?,
            };
            let mut overlap = overlap.filter(Overlap::has_content);
            let tolerance = if candidate.exact.is_some() { balance::ROUNDING } else { 0.0 };
            if let (Some(o), true) = (&mut overlap, self.is_balanced() || candidate.exact.is_some()) {
                balance(&o.nodes, &o.of_b, &mut o.gradient, &mut o.pose_gradient, coords, tolerance);
            }
            Ok(overlap)
        })
    }

    fn is_balanced(&self) -> bool {
        matches!(&self.options.estimator, Estimator::Fibers(fibers) if fibers.balance)
    }

    /// The fibers that cross an overlap, to look at; none for `exact`.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    pub fn trace(&self, coords: &[[f64; D]]) -> Result<Vec<FiberTrace<D>>, Error> {
        let traces = self.for_each_pair(coords, |Candidate { fibers, exact }| match exact {
            None => fibers.trace().map(Some),
            Some(_) => Ok(None),
        })?;
        Ok(traces.into_iter().flatten().collect())
    }
}

/// ψ = L, ψ' and ψ''.
const LINEAR: [&dyn Fn(f64) -> f64; 3] = [&|length| length, &|_| 1.0, &|_| 0.0];

/// Threads of one contact; none are started for one.
fn pool(threads: usize) -> Result<Option<rayon::ThreadPool>, Error> {
    if threads == 1 {
        return Ok(None);
    }
    let name = |index| format!("fmc-contact-{index}");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).thread_name(name).build();
    pool.map(Some).map_err(|_| Error::Threads { threads })
}

/// Contact forces between the bodies of a mesh, in one call.
///
/// # Errors
/// Those of [`Surface::from_cells`], [`Contact::new`] and [`Contact::evaluate`].
///
/// ```
/// use fmc_contact::{Bodies, CellBlock, CellType, EnergyLaw, Options, contact_force};
/// // Two unit squares, the second 0.1 deep in the first.
/// let coords = [[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0., 0.9], [1., 0.9], [1., 1.9], [0., 1.9]];
/// let blocks = [CellBlock { cell_type: CellType::Quad4, conn: &[0, 1, 2, 3, 4, 5, 6, 7] }];
/// let options = Options::new(EnergyLaw::volume(1000.0));
/// let contact = contact_force(&coords, &blocks, Bodies::Connected, &options)?;
/// assert!((contact.volume - 0.1).abs() < 0.01);
/// assert!(contact.bodies[1].force[1] > 0.0); // the upper square is pushed up
/// # Ok::<(), fmc_contact::Error>(())
/// ```
pub fn contact_force<const D: usize>(
    coords: &[[f64; D]],
    blocks: &[CellBlock],
    bodies: Bodies,
    options: &Options,
) -> Result<ContactForces<D>, Error> {
    Contact::new(Surface::from_cells(coords, blocks, bodies)?, *options)?.evaluate(coords)
}
