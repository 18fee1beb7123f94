//! How bodies are deformed.

use super::projected::projected;
use crate::Error;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::asking::unknowns::{Unknowns, largest};
use crate::contact::evaluation::Contact;
use crate::geometry::{PointWeights, Surface, Vector};
use nalgebra::DMatrix;

/// The unknowns without the rigid motions of bodies, and the largest entry of any displacement; all of them, and no bound, where those are
/// not known.
pub(crate) async fn deformed<const D: usize>(host: &Host<D>, x: &[f64]) -> Result<(Vec<f64>, f64), Trouble> {
    let coords = host.unknowns.coords(x);
    let Some(Elastic { points, weights }) = host.contact(move |contact| elastic_displacement(contact, &coords)).await?
    else {
        return Ok((x.to_vec(), f64::INFINITY));
    };
    let farthest = points.iter().flatten().map(|point| largest(point)).fold(0.0, f64::max);
    let rows = match weights {
        Some(weights) => {
            let unknowns = host.unknowns.of_coordinate.chunks_exact(D);
            let is_moved: Vec<[bool; D]> =
                unknowns.map(|row| std::array::from_fn(|axis| row[axis].is_some())).collect();
            projected(&weights, &points, &is_moved)
        }
        // The middle of a face without a node is none.
        None => points.into_iter().take(host.unknowns.base.len()).map(|point| point.unwrap_or([0.0; D])).collect(),
    };
    Ok((host.unknowns.gathered(&rows), farthest))
}

/// The unknowns where no body is deformed or moved, but those that are not free where they are; `None` where that is not known.
pub(crate) async fn undeformed<const D: usize>(host: &Host<D>, x: &[f64]) -> Option<Vec<f64>> {
    let reference =
        host.contact(|contact| nodes_with_cells(contact).map(|surface| surface.reference().to_vec())).await?;
    let Unknowns { base, free, .. } = &host.unknowns;
    if reference.len() != base.len() {
        return None;
    }
    let rows: Vec<[f64; D]> =
        reference.iter().zip(base).map(|(there, base)| (Vector::from(*there) - Vector::from(*base)).into()).collect();
    let all = host.unknowns.gathered(&rows);
    Some((0..all.len()).map(|k| if free[k] { all[k] } else { x[k] }).collect())
}

/// The surface where its rows of coordinates are the nodes of cells, whose undeformed place is known.
fn nodes_with_cells<const D: usize>(contact: &Contact<D>) -> Option<&Surface<D>> {
    Some(contact.surface()).filter(|surface| surface.cells.is_some() && !has_basis(surface))
}

/// Whether unknowns of the host move the nodes.
pub(crate) fn has_basis<const D: usize>(surface: &Surface<D>) -> bool {
    surface.division().is_some_and(|division| division.has_basis())
}

/// Displacements beyond the rigid motions of bodies.
struct Elastic<const D: usize> {
    /// By point; `None` for what is of no cell.
    points: Vec<Option<[f64; D]>>,
    /// How rows of coordinates move the points, where these are not rows themselves.
    weights: Option<PointWeights>,
}

/// Displacement of every point beyond the rigid motion of its body; `None` without cells, whose undeformed place is not known.
fn elastic_displacement<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
) -> Result<Option<Elastic<D>>, Error> {
    let surface = contact.surface();
    let points = surface.mesh_points(coords)?;
    let Some(cells) = surface.cells.as_ref() else { return Ok(None) };
    let mut of_body: Vec<Vec<usize>> = vec![Vec::new(); surface.body_count()];
    for cell in 0..cells.len() {
        of_body[cells.body[cell] as usize].extend(cells.nodes(cell).iter().map(|&n| n as usize));
    }
    let mut found = vec![None; points.len()];
    for mut nodes in of_body {
        nodes.sort_unstable();
        nodes.dedup();
        let here: Vec<Vector<D>> = nodes.iter().map(|&n| Vector::from(points[n])).collect();
        let there: Vec<Vector<D>> = nodes.iter().map(|&n| Vector::from(surface.reference()[n])).collect();
        for (&node, displacement) in nodes.iter().zip(beyond_rigid(&there, &here)) {
            found[node] = Some(displacement.into());
        }
    }
    // Nodes that are one with others move as these.
    for nodes in surface.division().map_or(&[][..], |division| division.welds()) {
        let of_first = found[nodes[0] as usize];
        nodes[1..].iter().for_each(|&node| found[node as usize] = of_first);
    }
    let weights = has_basis(surface).then(|| surface.point_weights());
    Ok(Some(Elastic { points: found, weights }))
}

/// How far points are from where the rigid motion nearest to theirs would have brought them.
fn beyond_rigid<const D: usize>(before: &[Vector<D>], now: &[Vector<D>]) -> Vec<Vector<D>> {
    let mean =
        |points: &[Vector<D>]| points.iter().fold(Vector::<D>::zeros(), |sum, x| sum + x) / points.len().max(1) as f64;
    let (from, to) = (mean(before), mean(now));
    let mut spread = DMatrix::<f64>::zeros(D, D);
    for (a, b) in before.iter().zip(now) {
        let (a, b) = (a - from, b - to);
        (0..D).for_each(|i| (0..D).for_each(|j| spread[(i, j)] += b[i] * a[j]));
    }
    let svd = spread.svd(true, true);
    let turn = match (svd.u, svd.v_t) {
        (Some(left), Some(right)) => left * right,
        _ => DMatrix::identity(D, D),
    };
    let distance = |(a, b): (&Vector<D>, &Vector<D>)| {
        let (a, b) = (a - from, b - to);
        Vector::<D>::from_fn(|i, _| b[i] - (0..D).map(|j| turn[(i, j)] * a[j]).sum::<f64>())
    };
    before.iter().zip(now).map(distance).collect()
}
