//! Half-discs whose cells are small about the point where they will be pressed.
//!
//! ```text
//!   O-----------S      flat side, y = R
//!   | . . . . . /
//!   |. . . . . /       rings about the tip B: circles there, the flat side at last; each is an arc that starts level on
//!   |.......  /        the axis and ends on the circle
//!   |))))))).'
//!   B'''''            tip at the origin
//! ```

use crate::Mesh;

/// The part x ≥ 0 of [`graded_half_disc_tri3`].
pub fn graded_quarter_disc_tri3(radius: f64, finest: f64, fine_to: f64, growth: f64) -> Mesh<2> {
    assert!(finest > 0.0 && growth > 0.0 && finest < radius && fine_to < radius, "cells of {finest} to {fine_to}");
    let end = radius * 2f64.sqrt();
    let size = |r: f64| finest + growth * (r - fine_to).max(0.0);
    let mut radii = vec![0.0];
    while radii[radii.len() - 1] < end {
        let r = radii[radii.len() - 1];
        radii.push(r + size(r));
    }
    // The last ring goes where it belongs; those of the fine zone stay.
    let (last, before) = (radii[radii.len() - 1], radii[radii.len() - 2]);
    if last - end > 0.5 * (last - before) && radii.len() > 2 {
        radii.pop();
    }
    let stretch = (end - fine_to) / (radii[radii.len() - 1] - fine_to);
    radii.iter_mut().filter(|r| **r > fine_to).for_each(|r| *r = fine_to + stretch * (*r - fine_to));

    let mut mesh = Mesh { coords: Vec::new(), conn: Vec::new(), nodes_per_cell: 3 };
    let mut before: Option<(u32, usize)> = None;
    for &r in &radii {
        let edges = if r == 0.0 { 0 } else { ((arc(radius, r).2 / size(r)).round() as usize).max(1) };
        let first = mesh.coords.len() as u32;
        mesh.coords
            .extend((0..=edges).map(|k| on_ring(radius, r, if edges == 0 { 0.0 } else { k as f64 / edges as f64 })));
        if let Some(inner) = before {
            join(inner, (first, edges), &mut mesh.conn);
        }
        before = Some((first, edges));
    }
    mesh
}

/// Half-disc in triangles: its tip at the origin, its flat side at y = `radius`. Cells are about `finest` wide as far as
/// `fine_to` from the tip, and grow from there on by `growth` times the way.
pub fn graded_half_disc_tri3(radius: f64, finest: f64, fine_to: f64, growth: f64) -> Mesh<2> {
    let mut mesh = graded_quarter_disc_tri3(radius, finest, fine_to, growth);
    let mut mirrored = mesh.clone().mapped(|x| [-x[0], x[1]]);
    mirrored.conn.chunks_exact_mut(3).for_each(|cell| cell.swap(1, 2));
    mesh.append(&mirrored);
    mesh.welded(1e-6 * finest)
}

/// Start of a ring on the axis, inclination of its chord and its length. The ring ends on the circle, `r` from the tip.
fn arc(radius: f64, r: f64) -> (f64, f64, f64) {
    // r at the tip, `radius` where r is √2 `radius`.
    let height = r * (1.0 - (1.0 - 0.5f64.sqrt()) * (r / radius).powi(2) / 2.0);
    let turn = r / (2.0 * radius);
    let end = [r * (1.0 - turn * turn).max(0.0).sqrt(), r * turn];
    let slope = (end[1] - height).atan2(end[0]);
    let chord = end[0].hypot(end[1] - height);
    (height, slope, if slope == 0.0 { chord } else { chord * slope / slope.sin() })
}

/// Point of a ring at a part of its length.
pub(crate) fn on_ring(radius: f64, r: f64, part: f64) -> [f64; 2] {
    let (height, slope, length) = arc(radius, r);
    // Chord from the start to the point: an arc that starts level has turned by twice the chord's inclination.
    let inclination = slope * part;
    let chord = length * part * if inclination == 0.0 { 1.0 } else { inclination.sin() / inclination };
    [chord * inclination.cos(), height + chord * inclination.sin()]
}

/// Triangles between a ring (first node, edges) and the next, advancing on the one that lags behind.
fn join(inner: (u32, usize), outer: (u32, usize), conn: &mut Vec<u32>) {
    let (mut i, mut k) = (0, 0);
    let node = |ring: (u32, usize), at: usize| ring.0 + at as u32;
    while i < inner.1 || k < outer.1 {
        let outer_first = (2 * k + 1) * inner.1.max(1) <= (2 * i + 1) * outer.1;
        if k < outer.1 && (i == inner.1 || outer_first) {
            conn.extend([node(inner, i), node(outer, k + 1), node(outer, k)]);
            k += 1;
        } else {
            conn.extend([node(inner, i), node(inner, i + 1), node(outer, k)]);
            i += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn graded_discs_are_fine_at_the_tip_and_round() {
        let (radius, finest) = (8.0, 0.1);
        let quarter = graded_quarter_disc_tri3(radius, finest, 1.0, 0.15);
        let half = graded_half_disc_tri3(radius, finest, 1.0, 0.15);
        for (mesh, area) in [(&quarter, 0.25), (&half, 0.5)] {
            let area = area * std::f64::consts::PI * radius * radius;
            assert!(mesh.smallest_jacobian() > 0.0);
            assert_eq!(mesh.euler_characteristic(), 1);
            assert!((mesh.measure() / area - 1.0).abs() < 4e-3, "{} of {area}", mesh.measure());
        }
        let mut round = 0;
        for face in half.boundary_faces() {
            let [p, q] = [face[0], face[1]].map(|node| half.coords[node as usize]);
            if p[1].min(q[1]) > radius - 1e-9 {
                continue;
            }
            round += 1;
            for x in [p, q] {
                assert!((x[0].hypot(x[1] - radius) - radius).abs() < 1e-12 * radius, "{x:?}");
            }
            let size = (p[0] - q[0]).hypot(p[1] - q[1]);
            assert!(p[0].abs().max(q[0].abs()) > 1.0 || (size / finest - 1.0).abs() < 0.01, "{size} at {p:?}");
        }
        assert!(round > 30 && half.cell_count() < 4000, "{round} facets, {} cells", half.cell_count());
    }
}
