//! The directions of one patch's lines.
//!
//! One, the mean normal, ∂V summed over the patch, so that L is the penetration depth. Where the contact wraps so far
//! around that lines along it would run flat along the surfaces, as a pin's in its hole, there are others at right
//! angles: axes, so that the opposite walls of a hole share theirs. Each facet then belongs to the axis to which its
//! normal is closest, and three serve any normal within 55°.

use crate::geometry::Vector;
use nalgebra::{Matrix3, Vector3};

/// Directions are rounded to this part of their length, unless they are kept: while a patch turns less, the lines stay
/// where they are and the forces are those of one energy. It makes L wrong by 2e-7 of itself.
const ROUNDING: f64 = 1.0 / 1024.0;

/// A resultant below this part of the contact area has no direction: one side swallows the other.
const CANCELLED: f64 = 1e-6;

/// A direction serves a span if the normal at one of its ends is within 60° of it.
const SERVED: f64 = 0.5;

/// A further direction is added if it serves more than this part of the patch.
const WORTHWHILE: f64 = 0.05;

/// Boundary at the two ends of one span: unit normals, outwards of the first side and into the second, and what they
/// stand for of either surface.
pub(crate) type Ends<const D: usize> = [(Vector<D>, f64); 2];

/// Sums over a patch.
#[derive(Clone)]
pub(crate) struct Resultant<const D: usize> {
    resultant: Vector<D>,
    /// Σ measure n nᵀ.
    moments: Matrix3<f64>,
    pub(crate) measure: f64,
}

impl<const D: usize> Resultant<D> {
    pub(crate) fn new() -> Self {
        Self { resultant: Vector::zeros(), moments: Matrix3::zeros(), measure: 0.0 }
    }

    pub(crate) fn add(&mut self, normal: &Vector<D>, measure: f64) {
        self.resultant += normal * measure;
        let n = Vector3::from_fn(|i, _| if i < D { normal[i] } else { 0.0 });
        self.moments += n * n.transpose() * measure;
        self.measure += measure;
    }

    /// That of the resultant, or, where that cancels, the direction to which most normals are parallel.
    fn direction(&self) -> Vector<D> {
        if self.resultant.norm() > CANCELLED * self.measure {
            return upright(self.resultant);
        }
        upright(self.axis())
    }

    fn axis(&self) -> Vector<D> {
        let eigen = self.moments.symmetric_eigen();
        let most = eigen.eigenvectors.column(eigen.eigenvalues.imax());
        Vector::from_fn(|i, _| most[i])
    }
}

/// Along the axis of `d`, with its largest component positive, so that it does not depend on the order of the sides.
fn upright<const D: usize>(d: Vector<D>) -> Vector<D> {
    (d / d[d.iamax()]).normalize()
}

/// Directions of a patch with these spans, the first of which is the mean normal. Of a body with itself (`is_own`) it is not
/// known which end is of the first side: both normals look outwards, and their sum is what is left where they cancel. It
/// is then the direction to which most of them are parallel.
pub(crate) fn directions<const D: usize>(spans: &[Ends<D>], is_own: bool, rounded: bool) -> Vec<Vector<D>> {
    let mut all = Resultant::new();
    spans.iter().flatten().for_each(|(normal, measure)| all.add(normal, *measure));
    let mut axes = vec![if is_own { upright(all.axis()) } else { all.direction() }];
    while axes.len() < D {
        let served = |normal: &Vector<D>| axes.iter().any(|d| normal.dot(d).abs() >= SERVED);
        let unserved = || spans.iter().filter(|ends| ends.iter().all(|(n, _)| !served(n))).flatten();
        if unserved().map(|(_, measure)| measure).sum::<f64>() <= WORTHWHILE * all.measure {
            break;
        }
        let mut beside = Resultant::new();
        for (normal, measure) in unserved() {
            beside.add(&axes.iter().fold(*normal, |rest, d| rest - d * rest.dot(d)), *measure);
        }
        let axis = beside.axis();
        // At right angles but for rounding of the sums.
        axes.push(upright(axes.iter().fold(axis, |rest, d| rest - d * rest.dot(d))));
    }
    if rounded {
        axes.iter_mut().for_each(|d| *d = (*d / d[d.iamax()]).map(|x| (x / ROUNDING).round() * ROUNDING).normalize());
    }
    axes
}

/// The axis to which a normal is closest.
pub(crate) fn nearest<const D: usize>(axes: &[Vector<D>], normal: &Vector<D>) -> usize {
    let mut best = 0;
    for (index, axis) in axes.iter().enumerate() {
        if normal.dot(axis).abs() > normal.dot(&axes[best]).abs() {
            best = index;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arc of normals about +y, `half` to either side, on both surfaces.
    fn arc(half: f64) -> Vec<Ends<2>> {
        let normal = |angle: f64| (Vector::<2>::new(angle.sin(), angle.cos()), 1.0);
        (-50..=50).map(|k| normal(f64::from(k) / 50.0 * half.to_radians())).map(|n| [n, n]).collect()
    }

    #[test]
    fn flat_contact_has_one_direction() {
        assert_eq!(directions(&arc(55.0), false, false).len(), 1);
        assert!((directions(&arc(55.0), false, false)[0] - Vector::<2>::new(0.0, 1.0)).norm() < 1e-12);
    }

    #[test]
    fn contact_that_wraps_around_has_two_at_right_angles() {
        for half in [80.0, 180.0] {
            let axes = directions(&arc(half), false, true);
            assert!(axes.len() == 2 && axes[0].dot(&axes[1]).abs() < 0.02, "{half}: {axes:?}");
        }
    }

    #[test]
    fn a_ball_in_its_socket_has_three() {
        let mut spans = Vec::new();
        for k in 0..400 {
            let (z, turn) = (f64::from(k) / 400.0, 2.4 * f64::from(k));
            let r = (1.0 - z * z).sqrt();
            let end = (Vector::<3>::new(r * turn.cos(), r * turn.sin(), z), 1.0);
            spans.push([end, end]);
        }
        let axes = directions(&spans, false, false);
        assert_eq!(axes.len(), 3);
        let worst = spans.iter().map(|s| axes.iter().map(|d| d.dot(&s[0].0).abs()).fold(0.0, f64::max));
        assert!(worst.fold(1.0, f64::min) > 0.5);
    }

    /// The two faces of a slit that closes by a small angle look away from one another.
    #[test]
    fn a_body_with_itself_has_the_direction_across_its_slit() {
        let ends = [(Vector::<2>::new(1e-3, 1.0).normalize(), 1.0), (Vector::<2>::new(0.0, -1.0), 1.0)];
        let axes = directions(&[ends; 4], true, false);
        assert!(axes.len() == 1 && (axes[0] - Vector::<2>::new(5e-4, 1.0)).norm() < 1e-6, "{axes:?}");
    }

    /// A wedge of steep flanks in a flat surface needs no more than the surface's normal.
    #[test]
    fn one_end_is_enough() {
        let flank = |sign: f64| [(Vector::<2>::new(sign * 0.97, 0.25), 4.0), (Vector::<2>::new(0.0, 1.0), 1.0)];
        assert_eq!(directions(&[flank(1.0), flank(-1.0)], false, false).len(), 1);
    }
}
