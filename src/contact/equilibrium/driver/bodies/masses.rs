//! How stiff the layers below surfaces are to a host that has masses and a time step, and no matrix.

use super::limit::check_lengths;
use crate::Error;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::evaluation::Contact;
use crate::contact::partners::LayerStiffness;

/// Layers from the nodes' masses and the largest step that the bodies allow by themselves. A pair has the stiffness with which the node
/// of the softer surface that has the least mass for its area swings at the host's own limit: its step becomes a tenth shorter. 4.5 times as
/// much would make it three tenths shorter, 0.46 times as much a twentieth. A mean over the surface would be that of its heavy nodes, as where
/// flat cells lie in layers below it: then the others swing faster than the host allows.
pub(in crate::contact::equilibrium) fn layers_of_masses<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    masses: &[f64],
    limit: f64,
) -> Result<LayerStiffness, Error> {
    check_lengths(contact, [("coords", coords.len()), ("masses", masses.len())])?;
    if !(limit.is_finite() && limit > 0.0) {
        return Err(Error::NotPositive { name: "limit", value: limit });
    }
    let assembly = Assembly::new(contact, coords)?;
    let mut bodies = Vec::with_capacity(assembly.rows.len());
    for rows in &assembly.rows {
        let mut least = f64::INFINITY;
        for &row in rows.iter().filter(|&&row| assembly.area_of_side[row] > 0.0) {
            let value = masses[row];
            if value.is_nan() || value <= 0.0 {
                return Err(Error::NotPositiveMass { node: row, value });
            }
            // Infinite masses are those of nodes that the host holds: they have no motion of their own.
            least = least.min(value / assembly.area_of_side[row]);
        }
        bodies.push(least / (limit * limit));
    }
    let softest = bodies.iter().copied().fold(f64::INFINITY, f64::min);
    if !softest.is_finite() {
        return Err(Error::Unsupported { what: "a stiffness from masses where the host holds every surface" });
    }
    bodies.iter_mut().for_each(|layer| *layer = if layer.is_finite() { *layer } else { softest });
    Ok(LayerStiffness::from_pairs(bodies))
}
