//! From coordinates to overlaps.

use super::balance::balance;
use super::forces::ContactForces;
use super::options::Options;
use super::partners::{Rigid, check_pose};
use crate::Error;
use crate::geometry::{Bodies, CellBlock, Obstacle, Pose, Surface};
use crate::overlap::{
    Estimator, ExactPair, FacetSide, FiberPair, FiberTrace, ImplicitSide, Opponent, Overlap, Pair, Partner, Views,
};
use crate::sampling::{Family, FiberPattern};

/// Contact between the bodies of one mesh, and with rigid obstacles.
///
/// It holds topology, obstacles and options, and nothing of any evaluation: two evaluations at the same coordinates give
/// the same bits, and [`contact_force`] gives the same bits as a `Contact` that is kept.
pub struct Contact<const D: usize> {
    surface: Surface<D>,
    obstacles: Vec<Rigid<D>>,
    options: Options,
    pool: Option<rayon::ThreadPool>,
}

impl<const D: usize> Contact<D> {
    /// Contact between the bodies of `surface`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for an option out of its range; [`Error::Threads`].
    pub fn new(surface: Surface<D>, options: Options) -> Result<Self, Error> {
        options.check()?;
        Ok(Self { surface, obstacles: Vec::new(), options, pool: pool(options.threads)? })
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

    /// Replaces the options.
    ///
    /// # Errors
    /// As [`Self::new`]; the old options then stay in force.
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        options.check()?;
        if options.threads != self.options.threads {
            self.pool = pool(options.threads)?;
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
        let overlaps = self.overlaps(coords)?;
        ContactForces::assemble(&self.surface, self.obstacles.len(), coords, &self.options.law, &overlaps)
    }

    /// Overlaps of all pairs at `coords` that overlap, with their gradients, ordered by pair.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    pub fn overlaps(&self, coords: &[[f64; D]]) -> Result<Vec<Overlap<D>>, Error> {
        self.for_each_pair(coords, |pair| match (&self.options.estimator, pair) {
            (Estimator::Exact, PairOf::Exact(pair)) => Ok(pair.overlap()?.filter(Overlap::is_worth_telling)),
            (Estimator::Fibers(fibers), PairOf::Fibers(pair)) => {
                let mut overlap = pair.overlap()?.filter(Overlap::is_worth_telling);
                if let (Some(overlap), true) = (&mut overlap, fibers.balance) {
                    balance(overlap, coords);
                }
                Ok(overlap)
            }
            _ => Ok(None),
        })
    }

    /// The fibers that cross an overlap, to look at; none for `exact`.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    pub fn trace(&self, coords: &[[f64; D]]) -> Result<Vec<FiberTrace<D>>, Error> {
        let traces = self.for_each_pair(coords, |pair| match pair {
            PairOf::Fibers(pair) => pair.trace().map(Some),
            PairOf::Exact(_) => Ok(None),
        })?;
        Ok(traces.into_iter().flatten().collect())
    }

    /// Runs through all pairs whose boxes meet, in the order of their indices, on the threads of the options.
    fn for_each_pair<T: Send>(
        &self,
        coords: &[[f64; D]],
        work: impl Fn(PairOf<D>) -> Result<Option<T>, Error> + Sync,
    ) -> Result<Vec<T>, Error> {
        match &self.pool {
            Some(pool) => pool.install(|| self.surface.check(coords, self.options.check_cells, true)),
            None => self.surface.check(coords, self.options.check_cells, false),
        }?;
        let families = match &self.options.estimator {
            Estimator::Fibers(f) if f.pattern == FiberPattern::Lines => Family::all(f.seed),
            _ => Vec::new(),
        };
        let exact = matches!(self.options.estimator, Estimator::Exact);
        let views = Views::new(self.surface.points(coords), &families);
        let placed: Vec<Option<PlacedFacets<D>>> = (self.obstacles.iter())
            .map(|rigid| rigid.placed_facets(exact).map(|(facets, points)| (facets, Views::new(points, &families))))
            .collect();
        let body = |body: usize| {
            let facets = &self.surface.facets[self.surface.ranges[body].clone()];
            FacetSide::new(facets, self.surface.vertices[body].iter().copied(), &views)
        };
        let bodies: Vec<FacetSide<D>> = (0..self.surface.body_count()).map(body).collect();

        let parallel = self.pool.is_some();
        let measure = |partners: [Partner; 2], a: FacetSide<D>, opponent: Opponent<D>, pose: Option<&Pose<D>>| {
            let pair = Pair { partners, a, opponent, pose, surface: &self.surface, parallel };
            let pair = match &self.options.estimator {
                Estimator::Exact => PairOf::Exact(ExactPair { pair, coords }),
                Estimator::Fibers(options) => PairOf::Fibers(FiberPair { pair, families: &families, options }),
            };
            match &self.pool {
                // A signed distance function belongs to the host and is called on the calling thread.
                Some(pool) if !opponent.is_marched() => pool.install(|| work(pair)),
                _ => work(pair),
            }
        };
        let mut results = Vec::new();
        for (i, &a) in bodies.iter().enumerate() {
            if self.options.self_contact {
                results.extend(measure([Partner::Body(i); 2], a, Opponent::Itself, None)?);
            }
            for (j, b) in bodies.iter().enumerate().skip(i + 1) {
                if a.aabb.meets(&b.aabb) {
                    results.extend(measure([Partner::Body(i), Partner::Body(j)], a, Opponent::Facets(*b), None)?);
                }
            }
            for (obstacle, (rigid, placed)) in self.obstacles.iter().zip(&placed).enumerate() {
                let pose = &rigid.obstacle.pose;
                let opponent = match placed {
                    Some((facets, views)) => {
                        Opponent::Facets(FacetSide::new(facets, 0..views.points.len() as u32, views))
                    }
                    None => Opponent::Implicit(ImplicitSide { obstacle, shape: &rigid.obstacle.shape, pose }),
                };
                results.extend(measure([Partner::Body(i), Partner::Obstacle(obstacle)], a, opponent, Some(pose))?);
            }
        }
        Ok(results)
    }
}

/// Facets of an obstacle and where their corners are.
type PlacedFacets<'a, const D: usize> = (&'a [[u32; D]], Views<D>);

/// A pair, for the estimator that is to measure it.
enum PairOf<'a, const D: usize> {
    Exact(ExactPair<'a, D>),
    Fibers(FiberPair<'a, D>),
}

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
