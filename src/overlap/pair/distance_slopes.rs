//! How fast a host's signed distance grows: no faster than a distance, or contact would be missed where it is far from zero; and near its
//! surface no slower, or penetrations are measured too small.

use super::sides::ImplicitSide;
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::{SignedDistance, Vector};

/// A slope that is larger than 1 by more than this part is no rounding.
pub(crate) const STEEP: f64 = 1e-6;

/// Points nearer than this part of the region are not compared: their difference may be what is left of the digits of a table.
const NEAR: f64 = 1e-3;

/// Half of the way, as a part of the region, over which the slope at the surface is taken.
const HALF_WAY: f64 = 1e-4;

/// Steps towards the surface.
const STEPS: usize = 4;

/// A signed distance as it is called, in its own frame.
struct Probe<'a, const D: usize> {
    function: &'a dyn SignedDistance<D>,
    side: &'a ImplicitSide<'a, D>,
    /// The largest distance in the region.
    size: f64,
}

/// What was found at a point.
#[derive(Clone, Copy)]
struct Found<const D: usize> {
    x: Vector<D>,
    phi: f64,
    /// Direction of the gradient, zero where there is none.
    along: Vector<D>,
}

/// Compares values at the corners, in the middles and at the centre of a region with one another, and with those at the places to which they
/// lead.
///
/// # Errors
/// [`Error::SteepDistance`], [`Error::SignedDistance`].
pub(crate) fn check_slopes<const D: usize>(
    function: &dyn SignedDistance<D>,
    side: &ImplicitSide<D>,
    within: &Aabb<D>,
) -> Result<(), Error> {
    let probe = Probe::new(function, side, within);
    let grid = probe.grid(within)?;
    for (n, p) in grid.iter().enumerate() {
        grid[..n].iter().try_for_each(|q| probe.compare(p, q))?;
    }
    let next = probe.at(grid.iter().map(|p| p.x - p.along * p.phi).collect())?;
    grid.iter().zip(&next).try_for_each(|(p, q)| probe.compare(p, q))
}

/// The least and the largest slope along the gradient that were found at the surface in a region; `None` where there is none.
///
/// # Errors
/// [`Error::SignedDistance`].
pub(crate) fn slopes_at_surface<const D: usize>(
    function: &dyn SignedDistance<D>,
    side: &ImplicitSide<D>,
    within: &Aabb<D>,
) -> Result<Option<[f64; 2]>, Error> {
    let probe = Probe::new(function, side, within);
    let mut before = probe.grid(within)?;
    let mut now = probe.at(before.iter().map(|p| p.x - p.along * p.phi).collect())?;
    for _ in 1..STEPS {
        let next = before.iter().zip(&now).map(|(p, q)| {
            let slope = (p.phi - q.phi) / (p.x - q.x).norm();
            let step = q.phi / slope.abs();
            if step.abs() <= probe.size { q.x - q.along * step } else { q.x }
        });
        let mut next = probe.at(next.collect())?;
        // On the surface itself many functions have no gradient.
        for (p, q) in next.iter_mut().zip(&now).filter(|(p, _)| p.along.norm_squared() == 0.0) {
            p.along = q.along;
        }
        (before, now) = (now, next);
    }
    let half = HALF_WAY * probe.size;
    // Where the two meet at corners, little of the surface lies in the region itself.
    let around = within.inflated(0.5 * within.extent().norm());
    let is_near = |p: &&Found<D>| {
        let place = side.pose.place(&p.x);
        p.phi.abs() <= half && p.along.norm_squared() > 0.0 && around.contains(&Aabb { min: place, max: place })
    };
    let near: Vec<Found<D>> = now.iter().filter(is_near).copied().collect();
    let both = near.iter().flat_map(|p| [p.x - p.along * half, p.x + p.along * half]);
    let sides = probe.at(both.collect())?;
    // On one side of an edge another face may be nearer.
    let slope =
        |(p, sides): (&Found<D>, &[Found<D>])| (p.phi - sides[0].phi).abs().max((sides[1].phi - p.phi).abs()) / half;
    let slopes = near.iter().zip(sides.chunks_exact(2)).map(slope);
    Ok(slopes.fold(None, |found, slope| {
        let [least, largest] = found.unwrap_or([f64::INFINITY, 0.0f64]);
        Some([least.min(slope), largest.max(slope)])
    }))
}

impl<'a, const D: usize> Probe<'a, D> {
    fn new(function: &'a dyn SignedDistance<D>, side: &'a ImplicitSide<'a, D>, within: &Aabb<D>) -> Self {
        Self { function, side, size: within.extent().norm() / side.pose.scale }
    }

    /// Corners, middles and centre of the region.
    fn grid(&self, within: &Aabb<D>) -> Result<Vec<Found<D>>, Error> {
        let places = (0..3usize.pow(D as u32)).map(|number| {
            let part = |axis: usize| 0.5 * (number / 3usize.pow(axis as u32) % 3) as f64;
            let place = Vector::from_fn(|axis, _| within.min[axis] + part(axis) * within.extent()[axis]);
            self.side.pose.unplace(&place)
        });
        self.at(places.collect())
    }

    fn at(&self, places: Vec<Vector<D>>) -> Result<Vec<Found<D>>, Error> {
        let x: Vec<[f64; D]> = places.iter().map(|x| (*x).into()).collect();
        let (mut phi, mut gradient) = (vec![f64::NAN; x.len()], vec![[f64::NAN; D]; x.len()]);
        let failed = |point| Error::SignedDistance { obstacle: self.side.obstacle, point };
        self.function.evaluate(&x, &mut phi, &mut gradient).map_err(failed)?;
        if let Some(point) = phi.iter().position(|phi| !phi.is_finite()) {
            return Err(failed(point));
        }
        let found = places.into_iter().zip(phi).zip(gradient).map(|((x, phi), gradient)| {
            let along = Vector::from(gradient).try_normalize(0.0).filter(|n| n.iter().all(|n| n.is_finite()));
            Found { x, phi, along: along.unwrap_or_else(Vector::zeros) }
        });
        Ok(found.collect())
    }

    fn compare(&self, p: &Found<D>, q: &Found<D>) -> Result<(), Error> {
        let apart = (p.x - q.x).norm();
        if apart <= NEAR * self.size || (p.phi - q.phi).abs() <= apart * (1.0 + STEEP) {
            return Ok(());
        }
        let scale = self.side.pose.scale;
        let places = [p, q].map(|p| self.side.pose.place(&p.x));
        Err(steep(self.side.obstacle, places, [p.phi * scale, q.phi * scale]))
    }
}

/// The error that names two points.
pub(crate) fn steep<const D: usize>(obstacle: usize, places: [Vector<D>; 2], phi: [f64; 2]) -> Error {
    let in_space = |x: Vector<D>| std::array::from_fn(|i| if i < D { x[i] } else { 0.0 });
    Error::SteepDistance { obstacle, places: places.map(in_space), phi }
}
