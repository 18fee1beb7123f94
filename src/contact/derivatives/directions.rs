//! Along what energy and forces are differentiated.

use super::gradients::PairGradient;
use super::request::{GradientRequest, SlipSeeds};
use crate::Error;
use crate::contact::friction::FacetSlip;
use crate::overlap::Partner;

/// Rates of what energy and forces depend on, for [`Contact::jvp`](crate::Contact::jvp); all are summed. What is not given rests.
#[derive(Clone, Copy, Debug, Default)]
pub struct Directions<'a, const D: usize> {
    /// Of the coordinates, `[node_count, D]`.
    pub coords: Option<&'a [[f64; D]]>,
    /// Of the position of every obstacle, removed ones included.
    pub positions: Option<&'a [[f64; D]]>,
    /// Of a rotation vector of every obstacle about its position; in 2D the last entry counts.
    pub rotations: Option<&'a [[f64; 3]]>,
    /// Of the stiffness k of every pair that touches.
    pub stiffness: f64,
    /// Of the gap offset of every pair that touches.
    pub gap_offset: f64,
    /// Of the coefficient of friction of every pair that touches.
    pub friction: f64,
    /// Of single pairs, in addition. A pair that does not touch does nothing.
    pub pairs: &'a [PairGradient],
    /// Of the elastic slip carried into the step; its length slid is not read.
    pub slip: &'a [FacetSlip<D>],
}

/// The same with its dimension hidden.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Along<'a> {
    pub(crate) coords: Option<&'a [f64]>,
    pub(crate) positions: Option<&'a [f64]>,
    pub(crate) rotations: Option<&'a [[f64; 3]]>,
    /// Of stiffness, gap offset and coefficient of friction.
    pub(crate) of_all: [f64; 3],
    pub(crate) pairs: &'a [PairGradient],
    pub(crate) slip: &'a SlipSeeds,
}

impl<'a> Along<'a> {
    /// Of these rates, with the slip by slider.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteStiffness`] with the place; [`Error::NoSuchRow`] for a pair that there is not.
    pub(crate) fn new<const D: usize>(
        given: &Directions<'a, D>,
        slip: &'a SlipSeeds,
        (nodes, bodies, obstacles): (usize, usize, usize),
    ) -> Result<Self, Error> {
        let rows = |array, rows: Option<&'a [[f64; D]]>, expected| checked(array, rows, expected);
        let coords = rows("rates of coordinates", given.coords, nodes)?;
        let positions = rows("rates of positions", given.positions, obstacles)?;
        checked("rates of rotations", given.rotations, obstacles)?;
        let of_all = [given.stiffness, given.gap_offset, given.friction];
        finite("rates of stiffness, gap offset and friction", &of_all)?;
        for (row, pair) in given.pairs.iter().enumerate() {
            let refuse = |what| Err(Error::NoSuchRow { list: "pairs", row, what });
            let is_there = |partner: &Partner| match *partner {
                Partner::Body(index) => index < bodies,
                Partner::Obstacle(index) => index < obstacles,
            };
            if !pair.partners.iter().all(is_there) {
                return refuse("a partner that does not exist");
            }
            if pair.partners[0] > pair.partners[1] || matches!(pair.partners[0], Partner::Obstacle(_)) {
                return refuse("sides in another order than in the pairs");
            }
        }
        let of_pairs: Vec<f64> = given.pairs.iter().flat_map(rates).collect();
        finite("rates of pairs", &of_pairs)?;
        Ok(Self { coords, positions, rotations: given.rotations, of_all, pairs: given.pairs, slip })
    }

    /// Rates of the stiffness, the gap offset and the coefficient of friction of a pair.
    pub(crate) fn of_pair(&self, partners: &[Partner; 2]) -> [f64; 3] {
        let own = self.pairs.iter().filter(|pair| pair.partners == *partners).map(rates);
        own.fold(self.of_all, |sum, rates| std::array::from_fn(|i| sum[i] + rates[i]))
    }

    /// What is moved, as a request names it.
    pub(crate) fn request(&self) -> GradientRequest {
        let moves = |i: usize| self.of_all[i] != 0.0 || self.pairs.iter().any(|pair| rates(pair)[i] != 0.0);
        GradientRequest {
            coords: self.coords.is_some(),
            reference: false,
            stiffness: moves(0),
            gap_offsets: moves(1),
            friction: moves(2),
            positions: self.positions.is_some(),
            rotations: self.rotations.is_some(),
            slip: !self.slip.is_empty(),
        }
    }

    /// Motion of nodes, given that of the mesh's points, then of positions and of rotations as tangents have them.
    pub(crate) fn motion<const D: usize>(&self, nodes: Option<&[[f64; D]]>, counts: [usize; 2]) -> Vec<[f64; D]> {
        let [node_count, obstacle_count] = counts;
        let mut moved = vec![[0.0; D]; node_count + 2 * obstacle_count];
        if let Some(nodes) = nodes {
            moved[..node_count].copy_from_slice(nodes);
        }
        let (positions, rotations) = moved[node_count..].split_at_mut(obstacle_count);
        for (to, from) in positions.iter_mut().zip(self.positions.unwrap_or(&[]).chunks_exact(D)) {
            to.copy_from_slice(from);
        }
        for (to, from) in rotations.iter_mut().zip(self.rotations.unwrap_or(&[])) {
            match D {
                // In the plane the angle is the first entry.
                2 => to[0] = from[2],
                _ => (0..D).for_each(|i| to[i] = from[i]),
            }
        }
        moved
    }
}

fn rates(pair: &PairGradient) -> [f64; 3] {
    [pair.stiffness, pair.gap_offset, pair.friction]
}

fn checked<'a, const N: usize>(
    array: &'static str,
    rows: Option<&'a [[f64; N]]>,
    expected: usize,
) -> Result<Option<&'a [f64]>, Error> {
    let Some(rows) = rows else { return Ok(None) };
    if rows.len() != expected {
        return Err(Error::Length { array, expected, found: rows.len() });
    }
    finite(array, rows.as_flattened())?;
    Ok(Some(rows.as_flattened()))
}

fn finite(array: &'static str, numbers: &[f64]) -> Result<(), Error> {
    match numbers.iter().position(|x| !x.is_finite()) {
        Some(entry) => Err(Error::NonFiniteStiffness { array, entry }),
        None => Ok(()),
    }
}
