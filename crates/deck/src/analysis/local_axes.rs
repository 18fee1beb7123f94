//! Nodes with axes of their own, by `*TRANSFORM`: each has a point beside the model whose displacements are its components along these axes,
//!
//! ```text
//! e_i · u − v_i = 0
//! ```
//!
//! so that to hold or load a component is to hold or load v_i.

use super::Bodies;
use super::references::{Reference, Way};
use super::shares::cross;
use crate::Fault;
use crate::read::{Deck, Kind, TransformRow};

/// Part of 1 up to which a component of an axis is rounding.
const ROUNDED: f64 = 1e-12;

/// Adds the points of all nodes that have axes of their own.
pub(super) fn add_local<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    references: &mut Vec<Reference<D>>,
) -> Result<(), Fault> {
    let first = references.len();
    for row in &deck.transforms {
        for instance in deck.names.instances_of(&row.scope) {
            for node in deck.names.find(Kind::Node, instance, &row.set, row.line)? {
                let label = deck.mesh.node_tags[node];
                // Nodes of no element move by equations alone, along the axes of the space.
                let Some(own) = bodies.places.node_of[node] else { continue };
                let refused = |message: String| Err(Fault::new(row.line, message));
                let (rigid, local) = references.split_at(first);
                let follows = |reference: &&Reference<D>| {
                    let is_led =
                        matches!(reference.way, Way::Follows(_)) && reference.nodes.binary_search(&own).is_ok();
                    is_led || reference.node == node
                };
                if let Some(other) = rigid.iter().find(follows) {
                    return refused(format!("node {label} belongs to {}, and has no local axes", other.name()));
                }
                let axes = axes::<D>(row, &deck.mesh.points[node]);
                let axes = axes.map_err(|text| Fault::new(row.line, format!("node {label} {text}")))?;
                match local.iter().find(|other| other.node == node) {
                    Some(other) if other.way == Way::Local(axes) => {}
                    Some(other) => {
                        return refused(format!("node {label} has other axes by line {} already", other.line));
                    }
                    None => references.push(Reference::local((deck, row.line), (node, own), axes)),
                }
            }
        }
    }
    Ok(())
}

/// The axes at a place, each a unit vector; or what is wrong with them.
fn axes<const D: usize>(row: &TransformRow, place: &[f64; 3]) -> Result<[[f64; D]; D], String> {
    let [a, b] = row.points;
    let all = if row.is_cylindrical {
        let axis = unit(minus(b, a)).ok_or("has an axis of *TRANSFORM whose points are one")?;
        let arm = minus(*place, a);
        let along = dot(arm, axis);
        let radial = std::array::from_fn(|k| arm[k] - along * axis[k]);
        let size = dot(arm, arm).sqrt();
        let is_off = dot(radial, radial).sqrt() > ROUNDED * size;
        let radial =
            unit(radial).filter(|_| is_off).ok_or("lies on the axis of *TRANSFORM, and has no radial direction")?;
        [radial, cross(axis, radial), axis]
    } else {
        let x = unit(a).ok_or("has axes by a *TRANSFORM whose first point is the origin")?;
        let along = dot(b, x);
        let y = std::array::from_fn(|k| b[k] - along * x[k]);
        let is_off = dot(y, y).sqrt() > ROUNDED * dot(b, b).sqrt();
        let y = unit(y)
            .filter(|_| is_off)
            .ok_or("has axes by a *TRANSFORM whose points lie on one line through the origin")?;
        [x, y, cross(x, y)]
    };
    let all = all.map(snapped);
    if D == 2 && (all[0][2] != 0.0 || all[1][2] != 0.0) {
        return Err("has axes by a *TRANSFORM that leave the plane".to_owned());
    }
    Ok(std::array::from_fn(|i| std::array::from_fn(|k| all[i][k])))
}

/// A unit vector without components of rounding: axes of the space are these exactly.
fn snapped(v: [f64; 3]) -> [f64; 3] {
    let rounded = v.map(|x| if x.abs() < ROUNDED { 0.0 } else { x });
    unit(rounded).unwrap_or(v)
}

fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(v, v).sqrt();
    (length > 0.0).then(|| v.map(|x| x / length))
}

fn minus(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| p[k] - q[k])
}

fn dot(p: [f64; 3], q: [f64; 3]) -> f64 {
    (0..3).map(|k| p[k] * q[k]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read::Scope;

    fn row(is_cylindrical: bool, points: [[f64; 3]; 2]) -> TransformRow {
        TransformRow { line: 1, scope: Scope::Model, set: "S".to_owned(), is_cylindrical, points }
    }

    /// Axes by hand; tolerance: rounding.
    #[test]
    fn axes_are_those_of_the_manuals() {
        let near = |found: [f64; 3], known: [f64; 3]| (0..3).all(|k| (found[k] - known[k]).abs() < 1e-15);
        let h = 0.5_f64.sqrt();
        let [x, y, z] = axes::<3>(&row(false, [[2.0, 2.0, 0.0], [0.0, 3.0, 0.0]]), &[9.0; 3]).unwrap();
        assert!(near(x, [h, h, 0.0]) && near(y, [-h, h, 0.0]) && near(z, [0.0, 0.0, 1.0]), "{x:?} {y:?} {z:?}");
        let about_z = row(true, [[1.0, 0.0, 0.0], [1.0, 0.0, 5.0]]);
        let [r, t, a] = axes::<3>(&about_z, &[1.0, -2.0, 7.0]).unwrap();
        assert!(near(r, [0.0, -1.0, 0.0]) && near(t, [1.0, 0.0, 0.0]) && near(a, [0.0, 0.0, 1.0]), "{r:?} {t:?} {a:?}");
        assert!(axes::<3>(&about_z, &[1.0, 0.0, 3.0]).unwrap_err().contains("lies on the axis"));
        assert!(axes::<2>(&row(false, [[1.0, 0.0, 1.0], [0.0, 1.0, 0.0]]), &[0.0; 3]).unwrap_err().contains("plane"));
        assert!(axes::<3>(&row(false, [[1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]), &[0.0; 3]).is_err());
    }
}
