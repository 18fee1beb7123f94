//! From coordinates to forces.

use super::{ContactForces, Options};
use crate::Error;
use crate::geometry::{Bodies, CellBlock, Obstacle, Pose, Surface};
use crate::overlap::{FiberTrace, Overlap};

/// Contact between the bodies of one mesh, and with rigid obstacles.
pub struct Contact<const D: usize> {
    surface: Surface<D>,
    obstacles: Vec<Obstacle<D>>,
    options: Options,
}

impl<const D: usize> Contact<D> {
    /// Contact between the bodies of `surface`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for an option out of its range; [`Error::Threads`].
    pub fn new(surface: Surface<D>, options: Options) -> Result<Self, Error> {
        options.check()?;
        Ok(Self { surface, obstacles: Vec::new(), options })
    }

    /// Adds a rigid partner and returns its index.
    pub fn add_obstacle(&mut self, obstacle: Obstacle<D>) -> Result<usize, Error> {
        self.obstacles.push(obstacle);
        Ok(self.obstacles.len() - 1)
    }

    /// Moves an obstacle.
    pub fn set_pose(&mut self, obstacle: usize, pose: Pose<D>) -> Result<(), Error> {
        let _ = (obstacle, pose);
        todo!()
    }

    /// Replaces the options.
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        options.check()?;
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

    /// Contact forces at `coords`, `[node_count, D]`.
    pub fn evaluate(&self, coords: &[[f64; D]]) -> Result<ContactForces<D>, Error> {
        let _ = coords;
        todo!()
    }

    /// Overlaps of all pairs at `coords`, with their gradients.
    pub fn overlaps(&self, coords: &[[f64; D]]) -> Result<Vec<Overlap<D>>, Error> {
        let _ = coords;
        todo!()
    }

    /// The fibers that cross an overlap, to look at. Empty for `exact`.
    pub fn trace(&self, coords: &[[f64; D]]) -> Result<Vec<FiberTrace<D>>, Error> {
        let _ = coords;
        todo!()
    }
}

/// Contact forces between the bodies of a mesh, in one call.
pub fn contact_force<const D: usize>(
    coords: &[[f64; D]],
    blocks: &[CellBlock],
    bodies: Bodies,
    options: &Options,
) -> Result<ContactForces<D>, Error> {
    Contact::new(Surface::from_cells(coords, blocks, bodies)?, *options)?.evaluate(coords)
}
