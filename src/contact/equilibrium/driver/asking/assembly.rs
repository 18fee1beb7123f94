//! The bodies as the search sees them: which body a coordinate belongs to, how thick bodies are, and where their surfaces look.

use crate::Error;
use crate::contact::evaluation::Contact;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{PointWeights, Vector};
use crate::overlap::Partner;

/// Bodies at some coordinates.
pub(crate) struct Assembly<const D: usize> {
    /// Body of every row of coordinates, where it has one.
    pub(crate) body: Vec<Option<usize>>,
    /// Rows of every body.
    pub(crate) rows: Vec<Vec<usize>>,
    /// Area that every row stands for on the surface; with axisymmetry that of rings, as in the host's matrix.
    pub(crate) area: Vec<f64>,
    /// The same of the side of its surface that is largest there: at the corner of a cube the area of one face.
    pub(crate) area_of_side: Vec<f64>,
    /// Mean outward unit normal at every row on the surface, else zero.
    pub(crate) normal: Vec<Vector<D>>,
    /// Positions of the rows.
    pub(crate) position: Vec<Vector<D>>,
    /// Twice the volume by the surface: the thickness of a plate.
    pub(crate) thickness: Vec<f64>,
    /// Size of a facet, by body.
    pub(crate) facet_size: Vec<f64>,
    /// Ids of the bodies, as the host gave them.
    ids: Vec<i64>,
    /// Whether a body is tied to others.
    is_tied: Vec<bool>,
    /// Largest extent of all.
    pub(crate) size: f64,
}

impl<const D: usize> Assembly<D> {
    pub(crate) fn new(contact: &Contact<D>, coords: &[[f64; D]]) -> Result<Self, Error> {
        let surface = contact.surface();
        let points: Vec<Vector<D>> = surface.mesh_points(coords)?.iter().map(|x| Vector::from(*x)).collect();
        let body_count = surface.body_count();
        let mut of_point = vec![None; points.len()];
        if let Some(cells) = &surface.cells {
            for cell in 0..cells.len() {
                cells.nodes(cell).iter().for_each(|&n| of_point[n as usize] = Some(cells.body[cell] as usize));
            }
        }
        let (mut area_of, mut normal_of) = (vec![0.0; points.len()], vec![Vector::<D>::zeros(); points.len()]);
        let (mut surfaces, mut volumes) = (vec![0.0; body_count], vec![0.0; body_count]);
        let mut sizes = vec![Vec::new(); body_count];
        let (mut parts, mut seen) = (Vec::new(), vec![Vector::<D>::zeros(); points.len()]);
        let (facets, weighting) = (contact.boundary_facets(), contact.method.weighting());
        let origin = facets.first().map_or_else(Vector::zeros, |facet| points[facet.nodes[0] as usize]);
        for facet in &facets {
            let nodes: Vec<usize> = facet.nodes.iter().map(|&n| n as usize).collect();
            // A quadrilateral face is four facets, each the triangle of two of its nodes and its centre.
            let is_quarter = nodes.len() > D;
            let centre = nodes.iter().fold(Vector::<D>::zeros(), |sum, &n| sum + points[n]) / nodes.len() as f64;
            let corner = |k: usize| if is_quarter && k == D - 1 { centre } else { points[nodes[k]] };
            let along = area_vector(&std::array::from_fn(corner));
            let area = along.norm();
            let of_rings = area * weighting.at(&centre);
            let share = if is_quarter { &nodes[..2] } else { &nodes[..] };
            for &n in share {
                area_of[n] += of_rings / share.len() as f64;
                normal_of[n] += along;
                if let Some(normal) = along.try_normalize(0.0) {
                    seen[n] += normal * (of_rings / share.len() as f64);
                    parts.push((n, normal));
                }
                of_point[n].get_or_insert(facet.body);
            }
            surfaces[facet.body] += area;
            volumes[facet.body] += along.dot(&(points[nodes[0]] - origin)) / D as f64;
            let face = area * if is_quarter { 4.0 } else { (D - 1) as f64 };
            sizes[facet.body].push(face.powf(1.0 / (D as f64 - 1.0)));
        }
        let mut side_of = vec![0.0f64; points.len()];
        parts.into_iter().for_each(|(n, normal)| side_of[n] = side_of[n].max(normal.dot(&seen[n])));
        let used = points.iter().zip(&of_point).filter(|(_, body)| body.is_some()).map(|(x, _)| x);
        let row_count = coords.len();
        let mut found = Self {
            body: vec![None; row_count],
            rows: vec![Vec::new(); body_count],
            area: vec![0.0; row_count],
            area_of_side: vec![0.0; row_count],
            normal: vec![Vector::zeros(); row_count],
            position: vec![Vector::zeros(); row_count],
            thickness: volumes.iter().zip(&surfaces).map(|(volume, area)| 2.0 * volume.abs() / area).collect(),
            facet_size: sizes.into_iter().map(median).collect(),
            ids: surface.body_ids().to_vec(),
            is_tied: contact.ties.tied_bodies(body_count),
            size: Aabb::of(used).extent().max(),
        };
        found.bring_to_rows(&surface.point_weights(), &of_point, (&points, [&area_of, &side_of], &normal_of));
        for (row, body) in found.body.iter().enumerate() {
            if let Some(body) = body {
                found.rows[*body].push(row);
            }
        }
        Ok(found)
    }

    /// Rows that are no points themselves have the mean of the points that they move, by weight.
    fn bring_to_rows(
        &mut self,
        weights: &PointWeights,
        of_point: &[Option<usize>],
        (points, [areas, sides], normals): (&[Vector<D>], [&[f64]; 2], &[Vector<D>]),
    ) {
        let mut sums = vec![0.0; self.body.len()];
        for point in (0..weights.point_count()).filter(|&point| of_point[point].is_some()) {
            let unit = if normals[point].norm() > 0.0 { normals[point].normalize() } else { normals[point] };
            for (row, weight) in weights.row(point) {
                let row = row as usize;
                sums[row] += weight;
                self.position[row] += weight * points[point];
                self.area[row] += weight * areas[point];
                self.area_of_side[row] += weight * sides[point];
                self.normal[row] += weight * unit;
                self.body[row] = self.body[row].or(of_point[point]);
            }
        }
        for (row, sum) in sums.iter().enumerate().filter(|(_, sum)| sum.abs() > 0.1) {
            self.position[row] /= *sum;
            let length = self.normal[row].norm();
            self.normal[row] = if length > 0.0 { self.normal[row] / length } else { Vector::zeros() };
        }
    }

    /// The thinnest body.
    pub(crate) fn thinnest(&self) -> f64 {
        self.thickness.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Size of the smallest facets.
    pub(crate) fn finest(&self) -> f64 {
        self.facet_size.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// A body by its id, an obstacle by its index.
    pub(crate) fn name(&self, partner: Partner) -> String {
        match partner {
            Partner::Body(body) => format!("body {}", self.id(body)),
            Partner::Obstacle(obstacle) => format!("obstacle {obstacle}"),
        }
    }

    /// Id of a body, as the host gave it.
    pub(crate) fn id(&self, body: usize) -> i64 {
        self.ids[body]
    }

    /// Body that moves most by a motion of the rows, how far, and how: its mean motion, unless it turns rather than moves.
    pub(crate) fn mover(&self, motion: &[[f64; D]]) -> Option<Mover<D>> {
        let way = |rows: &[usize]| rows.iter().map(|&row| Vector::<D>::from(motion[row]).amax()).fold(0.0, f64::max);
        let (body, rows) = self.rows.iter().enumerate().max_by(|a, b| way(a.1).total_cmp(&way(b.1)))?;
        let sum = rows.iter().fold(Vector::<D>::zeros(), |sum, &row| sum + Vector::from(motion[row]));
        let mean = sum / rows.len().max(1) as f64;
        let rest = rows.iter().map(|&row| (Vector::<D>::from(motion[row]) - mean).amax()).fold(0.0, f64::max);
        let is_rotation = mean.amax() < 0.5 * rest || mean.norm() == 0.0;
        let direction = if is_rotation { Vector::zeros() } else { mean.normalize() };
        Some(Mover { id: self.ids[body], body, is_tied: self.is_tied[body], direction, is_rotation, way: way(rows) })
    }
}

impl<const D: usize> Mover<D> {
    /// The same, driven by these forces of the rows: along their mean where it does not turn.
    pub(crate) fn driven(mut self, assembly: &Assembly<D>, forces: &[[f64; D]]) -> Self {
        let sum =
            assembly.rows[self.body].iter().fold(Vector::<D>::zeros(), |sum, &row| sum + Vector::from(forces[row]));
        if let Some(direction) = sum.try_normalize(0.0).filter(|_| !self.is_rotation) {
            self.direction = direction;
        }
        self
    }
}

/// A body that moves.
#[derive(Clone, Debug)]
pub(crate) struct Mover<const D: usize> {
    pub(crate) id: i64,
    body: usize,
    is_tied: bool,
    pub(crate) direction: Vector<D>,
    pub(crate) is_rotation: bool,
    pub(crate) way: f64,
}

impl<const D: usize> std::fmt::Display for Mover<D> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "body {}{}", self.id, if self.is_tied { " with the bodies tied to it" } else { "" })?;
        if self.is_rotation {
            return f.write_str(" in rotation");
        }
        // Without the sign of a zero.
        let parts: Vec<_> =
            self.direction.iter().map(|part| format!("{:.2}", (part * 100.0).round() / 100.0 + 0.0)).collect();
        write!(f, " along ({})", parts.join(", "))
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{EnergyLaw, Options};
    use crate::geometry::{Bodies, CellBlock, CellType, Surface};

    /// A body that sinks by more than it slides is driven sideways, where its load is.
    #[test]
    fn a_body_is_driven_along_its_load() {
        let coords = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let blocks = [CellBlock { cell_type: CellType::Quad4, conn: &[0, 1, 2, 3] }];
        let surface = Surface::from_cells(&coords, &blocks, Bodies::Connected).unwrap();
        let contact = Contact::new(surface, Options::new(EnergyLaw::depth(1.0))).unwrap();
        let assembly = Assembly::new(&contact, &coords).unwrap();
        let mover = assembly.mover(&[[0.1, -0.5]; 4]).unwrap();
        assert_eq!(mover.to_string(), "body 0 along (0.20, -0.98)");
        let loads = [[2.0, 1.0], [1.0, -1.0], [0.0, 0.5], [0.0, -0.5]];
        assert_eq!(mover.clone().driven(&assembly, &loads).to_string(), "body 0 along (1.00, 0.00)");
        assert_eq!(mover.driven(&assembly, &[[0.0; 2]; 4]).to_string(), "body 0 along (0.20, -0.98)");
        let turned = assembly.mover(&[[0.5, -0.5], [0.5, 0.5], [-0.5, 0.5], [-0.5, -0.5]]).unwrap();
        assert_eq!(turned.driven(&assembly, &loads).to_string(), "body 0 in rotation");
    }
}
