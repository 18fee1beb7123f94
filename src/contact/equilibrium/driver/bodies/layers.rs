//! How stiff bodies are below their surfaces, from the host's own matrix.

use super::elastic::has_basis;
use super::joined::{joined, own_diagonal};
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::dot;
use crate::contact::evaluation::Contact;
use crate::contact::partners::LayerStiffness;
use crate::geometry::PointWeights;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Nodes nearer to a partner than so many facets are its neighbours.
const NEAR: f64 = 2.0;

/// An unknown whose own stiffness exceeds that of the median so much is held by the host, not by its body.
const HELD: f64 = 1e4;

/// Factor between a stiffness that is known and that of the matrix at hand beyond which another host model is before the contact: below
/// it, as where a material softens, the known one presses as well.
const ANOTHER: f64 = 4.0;

/// Measures the layers where the law has no stiffness and none are known, a pair meets that was not near before, or the bodies are others
/// than those that were measured: whether it did. The host has the matrix of x.
pub(crate) async fn complete<const D: usize>(
    host: &Host<D>,
    assembly: &Assembly<D>,
    x: &[f64],
) -> Result<bool, Trouble> {
    let known = host.contact(|contact| match contact.options().law.is_without_stiffness() {
        true => Some((contact.layer_stiffness().cloned().unwrap_or_default(), contact.history.stiffened)),
        false => None,
    });
    let Some((known, stiffened)) = known.await else { return Ok(false) };
    let moving = host.contact(|contact| Moving::new(contact)).await;
    let near = neighbours(host, assembly, &moving, x).await?;
    // Springs that join nodes that are one hold none of them.
    let diagonal = own_diagonal(host, &host.diagonal().await?).await?;
    let layers = Layers { host, assembly, moving, diagonal };
    let bodies = layers.of_bodies().await?;
    let is_like = |(known, found): (&f64, &f64)| {
        let factor = known / (found * stiffened);
        (1.0 / ANOTHER..=ANOTHER).contains(&factor)
    };
    let is_known = known.bodies.len() == bodies.len() && near.keys().all(|pair| known.near.contains_key(pair));
    if is_known && known.bodies.iter().zip(&bodies).all(is_like) {
        return Ok(false);
    }
    let near = layers.of_neighbours(near, &bodies).await?;
    let found = LayerStiffness { bodies, near }.times(stiffened);
    host.contact(move |contact| contact.take_layer_stiffness(found)).await?;
    Ok(true)
}

/// What layers are measured with.
struct Layers<'a, const D: usize> {
    host: &'a Host<D>,
    assembly: &'a Assembly<D>,
    moving: Moving,
    diagonal: Vec<f64>,
}

impl<const D: usize> Layers<'_, D> {
    /// Of the whole surface of every body.
    async fn of_bodies(&self) -> Result<Vec<f64>, Trouble> {
        let mut bodies = Vec::new();
        for rows in &self.assembly.rows {
            let surface: Vec<usize> = rows.iter().copied().filter(|&row| self.assembly.area[row] > 0.0).collect();
            bodies.push(self.layer(&surface).await?);
        }
        // A body that resists no motion of its surface has the stiffness of the softest that does.
        let softest = bodies.iter().copied().filter(|layer| *layer > 0.0).fold(f64::INFINITY, f64::min);
        if !softest.is_finite() {
            let text =
                "the bodies' matrix resists no motion of any surface: no stiffness of the contact can be found from it";
            return Err(Trouble::Failed(text.into()));
        }
        bodies.iter_mut().for_each(|layer| *layer = if *layer > 0.0 { *layer } else { softest });
        Ok(bodies)
    }

    /// Of the parts that are near a partner.
    async fn of_neighbours(
        &self,
        neighbours: Neighbours,
        bodies: &[f64],
    ) -> Result<BTreeMap<(usize, Partner), f64>, Trouble> {
        let mut near = BTreeMap::new();
        for ((body, partner), rows) in neighbours {
            let found = self.layer(&rows).await?;
            near.insert((body, partner), if found > 0.0 { found } else { bodies[body] });
        }
        Ok(near)
    }

    /// v·K v by area, for the unit normals v of these rows.
    async fn layer(&self, rows: &[usize]) -> Result<f64, Trouble> {
        let own = |row: usize| {
            let unknowns = self.unknowns(row).iter().filter_map(|unknown| *unknown);
            unknowns.map(|unknown| self.diagonal[unknown].abs()).fold(0.0, f64::max)
        };
        let mut stiffness: Vec<f64> = rows.iter().map(|&row| own(row)).collect();
        stiffness.sort_unstable_by(f64::total_cmp);
        let Some(&median) = stiffness.get(stiffness.len() / 2) else { return Ok(0.0) };
        let (mut v, mut area) = (vec![0.0; self.host.unknowns.count], 0.0);
        for &row in rows.iter().filter(|&&row| own(row) <= HELD * median) {
            // A row of a basis that never moves is none of its surface.
            let is_still = self.moving.has_basis && self.unknowns(row).iter().all(Option::is_none);
            area += if is_still { 0.0 } else { self.assembly.area[row] };
            for (unknown, along) in self.unknowns(row).iter().zip(self.assembly.normal[row].iter()) {
                if let Some(unknown) = *unknown {
                    v[unknown] = *along;
                }
            }
        }
        if area <= 0.0 {
            return Ok(0.0);
        }
        self.host.unknowns.subtract_weighted(&mut v);
        let product = self.host.product(v.clone(), false).await?;
        Ok(dot(&v, &product) / area)
    }

    fn unknowns(&self, row: usize) -> &[Option<usize>] {
        &self.host.unknowns.of_coordinate[row * D..(row + 1) * D]
    }
}

/// Which rows of coordinates move points.
struct Moving {
    /// `None` where points are rows, or what no row of that number moves has no part in this.
    weights: Option<PointWeights>,
    has_basis: bool,
    /// Whether a node is one with others; empty where none is.
    is_welded: Vec<bool>,
}

impl Moving {
    fn new<const D: usize>(contact: &Contact<D>) -> Self {
        let surface = contact.surface();
        let (has_basis, mut is_welded) = (has_basis(surface), Vec::new());
        let welds = joined(contact);
        if !welds.is_empty() {
            is_welded.resize(surface.unknown_count(), false);
            welds.iter().flatten().for_each(|&node| is_welded[node as usize] = true);
        }
        let weights = (has_basis || !is_welded.is_empty()).then(|| surface.point_weights());
        Self { weights, has_basis, is_welded }
    }

    fn is_welded(&self, row: usize) -> bool {
        self.is_welded.get(row).is_some_and(|is_welded| *is_welded)
    }

    /// Rows that move a point with others, or the row of its number.
    fn rows(&self, point: usize) -> Vec<usize> {
        match &self.weights {
            Some(weights) if self.has_basis || self.is_welded(point) => {
                weights.row(point).filter(|(_, weight)| *weight != 0.0).map(|(row, _)| row as usize).collect()
            }
            _ => vec![point],
        }
    }
}

type Neighbours = BTreeMap<(usize, Partner), Vec<usize>>;

/// Rows of every body that are near a partner.
async fn neighbours<const D: usize>(
    host: &Host<D>,
    assembly: &Assembly<D>,
    moving: &Moving,
    x: &[f64],
) -> Result<Neighbours, Trouble> {
    let largest = assembly.facet_size.iter().copied().fold(0.0, f64::max);
    let coords = host.unknowns.coords(x);
    let gaps = host.contact(move |contact| contact.gap_constraints(&coords, NEAR * largest)).await?;
    let mut found: Neighbours = BTreeMap::new();
    for (&node, partners) in gaps.nodes.iter().zip(&gaps.partners) {
        let Partner::Body(body) = partners[0] else { continue };
        for row in moving.rows(node as usize) {
            if assembly.area.get(row).is_some_and(|area| *area > 0.0) {
                found.entry((body, partners[1])).or_default().push(row);
            }
        }
    }
    if moving.weights.is_some() {
        found.values_mut().for_each(|rows| {
            rows.sort_unstable();
            rows.dedup();
        });
    }
    Ok(found)
}
