//! The direction in which most of the boundary in a region looks.

use crate::geometry::Vector;

/// Cosine of the angle within which facets look the same way: 30°.
const ALIKE: f64 = 0.87;

/// How often the mean of those that do is found anew.
const ROUNDS: usize = 2;

/// A mean normal, and how much of the boundary in the region looks that way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MainNormal<const D: usize> {
    /// Unit vector, out of the first side and into the second.
    pub(crate) normal: Vector<D>,
    /// Area of the boundary in the region whose normal is within 30° of it, and that of all else.
    pub(crate) alike: f64,
    pub(crate) other: f64,
}

impl<const D: usize> MainNormal<D> {
    /// First the mean of all normals, given with their areas, then that of those within 30° of it; `None` where they cancel.
    pub(super) fn of(areas: &[Vector<D>]) -> Option<Self> {
        let mut found = Self { normal: areas.iter().sum(), alike: 0.0, other: 0.0 };
        for _ in 0..ROUNDS {
            found.normal = found.normal.try_normalize(0.0)?;
            found.normal = areas.iter().filter(|area| found.normal.dot(area) > ALIKE * area.norm()).sum();
        }
        found.normal = found.normal.try_normalize(0.0)?;
        let area =
            |is_alike: bool| areas.iter().filter(|area| found.is_alike(area) == is_alike).map(Vector::norm).sum();
        (found.alike, found.other) = (area(true), area(false));
        Some(found)
    }

    /// Whether a normal, of any length and either sign, is within 30° of it.
    pub(crate) fn is_alike(&self, normal: &Vector<D>) -> bool {
        self.normal.dot(normal).abs() > ALIKE * normal.norm()
    }
}
