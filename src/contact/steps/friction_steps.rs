//! Steps of a contact with friction: what is carried from one to the next.

use crate::Error;
use crate::contact::evaluation::kernels;
use crate::contact::friction::{Bearings, Friction, FrozenFriction, Sliding, SlipFacets, Step, Stick};
use crate::contact::interface::Contact;
use crate::contact::laws::Measured;
use crate::geometry::{Pose, Vector};
use crate::overlap::Partner;

impl<const D: usize> Contact<D> {
    /// Begins a step with friction at `coords`, with obstacles where they are: slip is counted from here. The elastic slip
    /// that was carried so far stays, none at first; [`Self::commit_step`] begins the next step by itself. To try a step
    /// again nothing has to be undone.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`]; with friction, of which what bears is measured here, as
    /// [`Self::evaluate`]. Nothing has then changed.
    pub fn begin_step(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        self.check_brought(coords)?;
        let points = self.surface.mesh_points(coords)?;
        self.surface.check_coords(&points, true)?;
        let before = self.step.take();
        let none = || vec![[0.0; D]; self.surface.facets.len()];
        let slip = before.as_ref().map_or_else(none, |step| step.slip.clone());
        let mut begun = Step::new(&self.surface, &points, self.poses(), slip);
        if self.has_friction() {
            self.step = Some(begun.clone());
            match kernels::slip_facets(self, coords) {
                Ok(pairs) => begun.bearings = Some(bearings(&pairs)),
                Err(error) => {
                    self.step = before;
                    return Err(error);
                }
            }
        }
        self.step = Some(begun);
        self.frozen = None;
        Ok(())
    }

    /// Accepts the step that ends at `coords`: the elastic slip there is carried into the next step, which begins here.
    /// Frozen friction is released. On an error nothing has changed.
    ///
    /// # Errors
    /// [`Error::NoStep`]; else as [`Self::evaluate`].
    pub fn commit_step(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        self.step.as_ref().ok_or(Error::NoStep)?;
        self.check_brought(coords)?;
        let mut sums = vec![(0.0, Vector::<D>::zeros()); self.surface.facets.len()];
        let pairs = kernels::slip_facets(self, coords)?;
        for pair in &pairs {
            pair.for_each_elastic_slip(|facet, area, slip| {
                sums[facet].0 += area;
                sums[facet].1 += slip * area;
            });
        }
        // A facet that faces several partners carries the mean.
        let slip = sums.iter().map(|(area, sum)| if *area > 0.0 { (sum / *area).into() } else { [0.0; D] });
        let mut next = Step::new(&self.surface, &self.surface.mesh_points(coords)?, self.poses(), slip.collect());
        next.bearings = self.has_friction().then(|| bearings(&pairs));
        self.step = Some(next);
        self.frozen = None;
        Ok(())
    }

    /// The elastic slip that was carried into the step, a vector for every facet of the surface, in the order of
    /// [`Self::boundary_facets`]: that of the facet against what it faces. With the coordinates at which the step began it is all that a restart needs.
    ///
    /// # Errors
    /// [`Error::NoStep`].
    pub fn slip(&self) -> Result<&[[f64; D]], Error> {
        Ok(&self.step.as_ref().ok_or(Error::NoStep)?.slip)
    }

    /// Sets the elastic slip that was carried into the step that has begun, after [`Self::begin_step`] at the coordinates
    /// of that time.
    ///
    /// # Errors
    /// [`Error::NoStep`], [`Error::Length`], [`Error::NonFiniteSlip`]; the old one then stays.
    pub fn set_slip(&mut self, slip: &[[f64; D]]) -> Result<(), Error> {
        let expected = self.surface.facets.len();
        if slip.len() != expected {
            return Err(Error::Length { array: "slip", expected, found: slip.len() });
        }
        if let Some(facet) = slip.iter().position(|vector| !vector.iter().all(|x| x.is_finite())) {
            return Err(Error::NonFiniteSlip { facet });
        }
        let step = self.step.as_mut().ok_or(Error::NoStep)?;
        step.slip = slip.to_vec();
        self.frozen = None;
        Ok(())
    }

    /// Freezes the facets on which friction acts and their pressure as they are at `coords`, until the step ends or
    /// [`Self::release_friction`]: the forces of friction are then minus the gradient of a convex potential, and their
    /// tangent is symmetric and positive semidefinite. Repeated at what was found until nothing changes, this leads to the
    /// solution with the current pressure.
    ///
    /// # Errors
    /// [`Error::NoStep`]; else as [`Self::evaluate`]. What was frozen before then stays.
    pub fn freeze_friction(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        self.step.as_ref().ok_or(Error::NoStep)?;
        let pairs = kernels::slip_facets(self, coords)?;
        self.check_brought(coords)?;
        self.frozen = Some(FrozenFriction::new(pairs, &self.surface.mesh_points(coords)?, self.poses()));
        self.turns.frozen = self.turn();
        Ok(())
    }

    /// Takes the pressure of the coordinates at hand again.
    pub fn release_friction(&mut self) {
        self.frozen = None;
    }

    /// Where the obstacles are; `None` for one that was removed.
    pub(crate) fn poses(&self) -> Vec<Option<Pose<D>>> {
        self.obstacles.iter().map(|rigid| rigid.as_ref().map(|rigid| rigid.obstacle.pose)).collect()
    }

    /// Refuses friction before a step has begun.
    pub(crate) fn check_step(&self) -> Result<(), Error> {
        if self.has_friction() && self.step.is_none() { Err(Error::NoStep) } else { Ok(()) }
    }

    /// Whether any pair has friction.
    pub(crate) fn has_friction(&self) -> bool {
        self.options.friction.is_active() || self.pair_table.has_friction()
    }

    /// Forgets how facets bore when the step began, where other pairs than then have friction, or bear in another way: the
    /// slip of this step is then counted from its start.
    pub(crate) fn forget_bearings(&mut self) {
        if let Some(step) = &mut self.step {
            step.bearings = None;
        }
    }

    /// How a pair slides, `None` for one without friction.
    pub(crate) fn sliding<'a>(&'a self, measured: &Measured<D>) -> Result<Option<Sliding<'a, D>>, Error> {
        let friction = self.friction_of(&measured.pair.partners);
        let Some(step) = self.step.as_ref().filter(|_| friction.is_active()) else { return Ok(None) };
        let what = "friction with a law that has no stiffness of its own: set the friction's";
        let stick = match friction.memoryless_slip {
            Some(slip) => Stick::Memoryless(slip),
            None => Stick::Spring(
                friction.stiffness.or(measured.law.initial_stiffness()).ok_or(Error::Unsupported { what })?,
            ),
        };
        Ok(Some(Sliding { friction, stick, step }))
    }

    pub(crate) fn friction_of(&self, partners: &[Partner; 2]) -> Friction {
        self.pair_table.friction(partners, self.options.friction)
    }

    /// The frozen friction at these coordinates.
    pub(crate) fn frozen_at(&self, coords: &[[f64; D]]) -> Vec<SlipFacets<D>> {
        self.frozen.as_ref().map_or_else(Vec::new, |frozen| frozen.at(coords, &self.poses()))
    }
}

/// How all facets bear.
fn bearings<const D: usize>(pairs: &[SlipFacets<D>]) -> Bearings {
    let mut found = Bearings::new();
    pairs.iter().for_each(|pair| pair.add_bearings(&mut found));
    found
}
