//! How stiff bodies are below their surfaces, from the host's own matrix.

use super::assembly::Assembly;
use super::host::Host;
use super::trouble::Trouble;
use super::unknowns::dot;
use crate::contact::partners::LayerStiffness;
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
pub(super) async fn complete<const D: usize>(
    host: &Host<D>,
    assembly: &Assembly<D>,
    x: &[f64],
) -> Result<bool, Trouble> {
    let known = host.contact(|contact| match contact.options().law.is_without_stiffness() {
        true => Some((contact.layer_stiffness().cloned().unwrap_or_default(), contact.history.stiffened)),
        false => None,
    });
    let Some((known, stiffened)) = known.await else { return Ok(false) };
    let near = neighbours(host, assembly, x).await?;
    let diagonal = host.diagonal().await?;
    let bodies = of_bodies(host, assembly, &diagonal).await?;
    let is_like = |(known, found): (&f64, &f64)| {
        let factor = known / (found * stiffened);
        (1.0 / ANOTHER..=ANOTHER).contains(&factor)
    };
    let is_known = known.bodies.len() == bodies.len() && near.keys().all(|pair| known.near.contains_key(pair));
    if is_known && known.bodies.iter().zip(&bodies).all(is_like) {
        return Ok(false);
    }
    let found = measured(host, assembly, (&diagonal, bodies), near).await?;
    host.contact(move |contact| contact.take_layer_stiffness(found.times(stiffened))).await?;
    Ok(true)
}

/// Of the whole surface of every body.
async fn of_bodies<const D: usize>(
    host: &Host<D>,
    assembly: &Assembly<D>,
    diagonal: &[f64],
) -> Result<Vec<f64>, Trouble> {
    let mut bodies = Vec::new();
    for rows in &assembly.rows {
        let surface: Vec<usize> = rows.iter().copied().filter(|&row| assembly.area[row] > 0.0).collect();
        bodies.push(layer(host, assembly, diagonal, &surface).await?);
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

async fn measured<const D: usize>(
    host: &Host<D>,
    assembly: &Assembly<D>,
    (diagonal, bodies): (&[f64], Vec<f64>),
    neighbours: Neighbours,
) -> Result<LayerStiffness, Trouble> {
    let mut near = BTreeMap::new();
    for ((body, partner), rows) in neighbours {
        let found = layer(host, assembly, diagonal, &rows).await?;
        near.insert((body, partner), if found > 0.0 { found } else { bodies[body] });
    }
    Ok(LayerStiffness { bodies, near })
}

/// v·K v by area, for the unit normals v of these rows.
async fn layer<const D: usize>(
    host: &Host<D>,
    assembly: &Assembly<D>,
    diagonal: &[f64],
    rows: &[usize],
) -> Result<f64, Trouble> {
    let own = |row: usize| {
        let unknowns = (0..D).filter_map(|axis| host.unknowns.of_coordinate[row * D + axis]);
        unknowns.map(|unknown| diagonal[unknown].abs()).fold(0.0, f64::max)
    };
    let mut stiffness: Vec<f64> = rows.iter().map(|&row| own(row)).collect();
    stiffness.sort_unstable_by(f64::total_cmp);
    let Some(&median) = stiffness.get(stiffness.len() / 2) else { return Ok(0.0) };
    let (mut v, mut area) = (vec![0.0; host.unknowns.count], 0.0);
    for &row in rows.iter().filter(|&&row| own(row) <= HELD * median) {
        area += assembly.area[row];
        for axis in 0..D {
            if let Some(unknown) = host.unknowns.of_coordinate[row * D + axis] {
                v[unknown] = assembly.normal[row][axis];
            }
        }
    }
    if area <= 0.0 {
        return Ok(0.0);
    }
    let product = host.product(v.clone(), false).await?;
    Ok(dot(&v, &product) / area)
}

type Neighbours = BTreeMap<(usize, Partner), Vec<usize>>;

/// Rows of every body that are near a partner.
async fn neighbours<const D: usize>(host: &Host<D>, assembly: &Assembly<D>, x: &[f64]) -> Result<Neighbours, Trouble> {
    let largest = assembly.facet_size.iter().copied().fold(0.0, f64::max);
    let coords = host.unknowns.coords(x);
    let gaps = host.contact(move |contact| contact.gap_constraints(&coords, NEAR * largest)).await?;
    let mut found: Neighbours = BTreeMap::new();
    for (&node, partners) in gaps.nodes.iter().zip(&gaps.partners) {
        if let Partner::Body(body) = partners[0]
            && assembly.area.get(node as usize).is_some_and(|area| *area > 0.0)
        {
            found.entry((body, partners[1])).or_default().push(node as usize);
        }
    }
    Ok(found)
}
