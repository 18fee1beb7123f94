//! From cells to polygons in the plane.

use super::{Cell, Patch};
use fmc_contact::CellType;
use std::collections::HashMap;

/// Where one looks from.
#[derive(Clone, Copy, Debug)]
pub(crate) enum View {
    /// Along z: bodies in the plane.
    Plane,
    /// From a direction, far away, with z upwards: the surface of bodies in space.
    Space([f64; 3]),
}

/// Faces of cells in space, as numbers of their nodes, in an order around the face.
const TET4: [&[usize]; 4] = [&[0, 1, 2], &[0, 1, 3], &[1, 2, 3], &[0, 2, 3]];
const HEX8: [&[usize]; 6] = [&[0, 1, 2, 3], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];

/// How dark a face is that looks away from the light.
const SHADE: f64 = 0.72;

impl View {
    /// A point in the plane of the picture.
    pub(crate) fn place(self, x: &[f64; 3]) -> [f64; 2] {
        match self {
            View::Plane => [x[0], x[1]],
            View::Space(from) => {
                let [right, up, _] = axes(from);
                [dot(&right, x), dot(&up, x)]
            }
        }
    }

    /// The cells that are seen, those in the back first; `color` is the fill of a cell by its number, `edge` makes the
    /// colour of its edges from its fill.
    pub(crate) fn patches(
        self,
        points: &[[f64; 3]],
        cells: &[Cell],
        color: impl Fn(usize) -> [u8; 4],
        edge: impl Fn([u8; 4]) -> [u8; 4],
    ) -> Vec<Patch> {
        let View::Space(from) = self else {
            let patch = |(number, cell): (usize, &Cell)| {
                let corners = cell.nodes.iter().map(|&node| self.place(&points[node as usize])).collect();
                let fill = color(number);
                Patch { corners, fill, edge: edge(fill) }
            };
            return cells.iter().enumerate().map(patch).collect();
        };
        let [_, _, towards] = axes(from);
        let light = unit([from[0] - 0.4 * from[1], from[1] + 0.4 * from[0], from[2] + 0.8 * norm(&from)]);
        let mut seen = Vec::new();
        for (number, nodes) in outer_faces(cells) {
            let corners: Vec<[f64; 3]> = nodes.iter().map(|&node| points[node as usize]).collect();
            let inside = centroid(cells[number].nodes.iter().map(|&node| &points[node as usize]));
            let middle = centroid(corners.iter());
            let normal = cross(&minus(&corners[1], &corners[0]), &minus(&corners[2], &corners[0]));
            // Of a cell that is turned inside out the outside is within; skipped, its faces would leave holes.
            let turned = is_turned(points, &cells[number]);
            let is_inward = (dot(&normal, &minus(&middle, &inside)) < 0.0) != turned;
            let outwards = if is_inward { normal.map(|x| -x) } else { normal };
            if dot(&outwards, &towards) <= 0.0 {
                continue;
            }
            let brightness = SHADE + (1.0 - SHADE) * dot(&unit(outwards), &light).max(0.0);
            let [r, g, b, a] = color(number);
            let [r, g, b] = [r, g, b].map(|c| (brightness * f64::from(c)).round() as u8);
            let corners = corners.iter().map(|x| self.place(x)).collect();
            seen.push((dot(&middle, &towards), Patch { corners, fill: [r, g, b, a], edge: edge([r, g, b, a]) }));
        }
        seen.sort_by(|p, q| p.0.total_cmp(&q.0));
        seen.into_iter().map(|(_, patch)| patch).collect()
    }
}

/// Faces that belong to one cell alone, with the number of the cell.
fn outer_faces(cells: &[Cell]) -> Vec<(usize, Vec<u32>)> {
    let mut owners: HashMap<Vec<u32>, usize> = HashMap::new();
    let faces = || {
        cells.iter().enumerate().flat_map(|(number, cell)| {
            let faces: &[&[usize]] = match cell.cell_type {
                CellType::Tet4 => &TET4,
                CellType::Hex8 => &HEX8,
                _ => &[],
            };
            faces.iter().map(move |face| (number, face.iter().map(|&k| cell.nodes[k]).collect::<Vec<u32>>()))
        })
    };
    let key = |nodes: &[u32]| {
        let mut sorted = nodes.to_vec();
        sorted.sort_unstable();
        sorted
    };
    for (_, nodes) in faces() {
        *owners.entry(key(&nodes)).or_insert(0) += 1;
    }
    faces().filter(|(_, nodes)| owners[&key(nodes)] == 1).collect()
}

/// Whether a cell has a negative volume, judged at its first corner.
fn is_turned(points: &[[f64; 3]], cell: &Cell) -> bool {
    let next: [usize; 3] = if cell.cell_type == CellType::Hex8 { [1, 3, 4] } else { [1, 2, 3] };
    let corner = points[cell.nodes[0] as usize];
    let [a, b, c] = next.map(|node| minus(&points[cell.nodes[node] as usize], &corner));
    dot(&cross(&a, &b), &c) < 0.0
}

/// To the right, up, and towards the one who looks.
fn axes(from: [f64; 3]) -> [[f64; 3]; 3] {
    let towards = unit(from);
    // Seen from straight above or below, y is up.
    let upwards = if towards[2].abs() > 0.999 { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] };
    let right = unit(cross(&upwards, &towards));
    [right, cross(&towards, &right), towards]
}

fn centroid<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> [f64; 3] {
    let (sum, count) =
        points.fold(([0.0; 3], 0.0), |(sum, count), x| ([sum[0] + x[0], sum[1] + x[1], sum[2] + x[2]], count + 1.0));
    sum.map(|x| x / count)
}

fn minus(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn norm(a: &[f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = norm(&a);
    a.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_faces_of_a_cube_are_seen_and_cover_its_shadow() {
        let points: Vec<[f64; 3]> =
            (0..8).map(|k| [[0, 1, 1, 0][k % 4], [0, 0, 1, 1][k % 4], k / 4].map(|x| x as f64)).collect();
        let cell = Cell { cell_type: CellType::Hex8, nodes: (0..8).collect(), value: 0.0 };
        let view = View::Space([1.0, 1.0, 1.0]);
        let patches = view.patches(&points, &[cell], |_| [255; 4], |c| c);
        assert_eq!(patches.len(), 3);
        let area = |corners: &[[f64; 2]]| {
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0])).sum::<f64>().abs()
        };
        // Along a diagonal the shadow of the unit cube is a hexagon of area √3.
        let shadow: f64 = patches.iter().map(|patch| area(&patch.corners)).sum();
        assert!((shadow - 3f64.sqrt()).abs() < 1e-12);
    }
    #[test]
    fn a_cell_turned_inside_out_shows_its_other_faces() {
        let points: Vec<[f64; 3]> =
            (0..8).map(|k| [[0, 1, 1, 0][k % 4], [0, 0, 1, 1][k % 4], k / 4].map(|x| x as f64)).collect();
        let view = View::Space([1.0, 0.5, 0.7]);
        let common = |points: &[[f64; 3]], node: usize| {
            let cell = Cell { cell_type: CellType::Hex8, nodes: (0..8).collect(), value: 0.0 };
            let patches = view.patches(points, &[cell], |_| [255; 4], |c| c);
            assert_eq!(patches.len(), 3);
            let at = view.place(&points[node]);
            patches.iter().all(|patch| patch.corners.contains(&at))
        };
        assert!(common(&points, 6));
        // Its upper side below its lower one: the corner at (0, 0, −1).
        let below: Vec<[f64; 3]> = points.iter().map(|x| [x[0], x[1], -x[2]]).collect();
        assert!(common(&below, 4));
    }
}
