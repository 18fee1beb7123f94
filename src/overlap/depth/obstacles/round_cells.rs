//! The space beside a convex solid, divided by what of the solid is nearest: a face, an edge or a corner.
//!
//! A ball of radius r moved along the solid's surface sweeps a solid with round edges. Its part above a face is a prism, that
//! beside an edge a part of a cylinder, that beside a corner a part of a ball, each cut off by planes. In each the depth below
//! the swept surface is r less the distance from a plane, a line or a point.

use super::convex_solid::{ConvexSolid, Linear};
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::Piece;
use crate::geometry::shapes::{ConvexFaces, Ridge};

/// Least cosine between the lines along which a cell is summed and the normals at its border.
const STEEPEST: f64 = 1e-3;

/// Steps towards the direction that is nearest to all normals at a corner.
const STEPS: u32 = 200;

/// What is nearest to the points of a cell.
#[derive(Clone, Copy, Debug)]
pub(super) enum Nearest<const D: usize> {
    Face,
    /// In space, with this direction.
    Edge(Vector<D>),
    Corner,
}

/// A plane that bounds a cell: positive outside. What lies in it belongs to the cell, or to the one beside it.
#[derive(Clone, Copy)]
pub(super) struct Wall<const D: usize> {
    pub(super) height: Linear<D>,
    is_own: bool,
}

/// Where lines enter a cell.
pub(super) struct Floor<const D: usize> {
    pub(super) wall: Wall<D>,
    /// Not positive below it.
    sides: Vec<Linear<D>>,
}

/// The points for which one face, edge or corner is nearest.
pub(super) struct Cell<const D: usize> {
    pub(super) nearest: Nearest<D>,
    /// A point of what is nearest.
    pub(super) apex: Vector<D>,
    /// Lines along it enter through a floor and leave through the round surface.
    pub(super) up: Vector<D>,
    walls: Vec<Wall<D>>,
    pub(super) floors: Vec<Floor<D>>,
    /// A point in the middle of what of it is swept.
    pub(super) middle: Vector<D>,
    /// Around what of it is swept.
    pub(super) aabb: Aabb<D>,
}

impl<const D: usize> Cell<D> {
    /// Keeps of a facet what lies in the cell; false if nothing does.
    pub(super) fn cut(&self, corners: &[Vector<D>; D], piece: &mut Piece<D>) -> bool {
        piece.reset();
        self.walls.iter().all(|wall| {
            let at = corners.each_ref().map(|x| wall.height.at(x));
            if at.iter().all(|at| *at == 0.0) { wall.is_own } else { cut(&at, piece) }
        })
    }

    /// The way to a point from what is nearest.
    pub(super) fn away(&self, x: &Vector<D>) -> Vector<D> {
        let from = x - self.apex;
        match &self.nearest {
            Nearest::Face => self.up * self.up.dot(&from),
            Nearest::Edge(direction) => from - direction * direction.dot(&from),
            Nearest::Corner => from,
        }
    }

    /// Whether lines through a box may meet the cell.
    pub(super) fn is_below(&self, floor: &Floor<D>, aabb: &Aabb<D>, radius: f64) -> bool {
        let away = self.away(&aabb.center());
        let across = (away - self.up * self.up.dot(&away)).norm();
        across <= radius + aabb.extent().norm()
            && floor.wall.height.largest(aabb) >= 0.0
            && floor.sides.iter().all(|side| side.least(aabb) <= 0.0)
    }
}

impl<const D: usize> Floor<D> {
    /// Keeps of a facet what lies below the floor; false if nothing does.
    pub(super) fn cut(&self, corners: &[Vector<D>; D], piece: &mut Piece<D>) -> bool {
        piece.reset();
        let at = corners.each_ref().map(|x| -self.wall.height.at(x));
        if at.iter().all(|at| *at == 0.0) && self.wall.is_own {
            return false;
        }
        cut(&at, piece) && self.sides.iter().all(|side| cut(&corners.each_ref().map(|x| side.at(x)), piece))
    }
}

fn cut<const D: usize>(at: &[f64; D], piece: &mut Piece<D>) -> bool {
    at.iter().all(|at| *at <= 0.0) || at.iter().any(|at| *at < 0.0) && piece.cut(at)
}

/// All cells; `None` for a solid that is as sharp as a needle, whose corners no line along one direction leaves.
pub(super) fn cells<const D: usize>(
    solid: &ConvexSolid<D>,
    faces: &ConvexFaces,
    side: &FacetSide<D>,
    radius: f64,
) -> Option<Vec<Cell<D>>> {
    let place = |corner: u32| side.points[corner as usize];
    let normal = |face: u32| solid.heights[face as usize].slope;
    let mut walls: Vec<Vec<Wall<D>>> = vec![Vec::new(); faces.corners.len()];
    let (mut edges, mut corners) = (Vec::new(), Vec::new());
    // By ridge, the planes across it at its ends, positive beyond them.
    let mut ends: Vec<[Linear<D>; 2]> = Vec::with_capacity(faces.ridges.ridges.len());
    for ridge in &faces.ridges.ridges {
        let at = ridge.ends.map(place);
        let direction = (at[1] - at[0]).try_normalize(0.0).unwrap_or_else(Vector::zeros);
        let outwards = ridge.faces.map(|face| {
            let middle = mean(&faces.corners[face as usize].iter().map(|corner| place(*corner)).collect::<Vec<_>>());
            let across = across(&normal(face), &direction);
            let sign = if across.dot(&(middle - at[0])) > 0.0 { -1.0 } else { 1.0 };
            through(&at[0], across * sign)
        });
        for (face, height) in ridge.faces.iter().zip(&outwards) {
            walls[*face as usize].push(Wall { height: *height, is_own: true });
        }
        ends.push([through(&at[0], -direction), through(&at[1], direction)]);
        edges.push(beside_ridge(ridge, at, outwards, ridge.faces.map(normal), ends[ends.len() - 1], radius)?);
    }
    for (corner, at_corner) in faces.ridges.corners.iter().filter(|(_, ridges)| ridges.len() > 2) {
        let there: Vec<(Wall<D>, [Vector<D>; 2])> = at_corner
            .iter()
            .map(|&number| {
                let ridge = &faces.ridges.ridges[number as usize];
                let height = ends[number as usize][usize::from(ridge.ends[1] == *corner)].negated();
                (Wall { height, is_own: false }, ridge.faces.map(normal))
            })
            .collect();
        corners.push(beside_corner(&place(*corner), &there, radius)?);
    }
    let mut cells: Vec<Cell<D>> = walls
        .into_iter()
        .enumerate()
        .map(|(face, walls)| {
            let height = solid.heights[face];
            let at: Vec<Vector<D>> = faces.corners[face].iter().map(|corner| place(*corner)).collect();
            let of_face = Aabb::of(&at);
            let out = height.slope * radius;
            let floor = Wall { height: height.negated(), is_own: true };
            let sides = walls.iter().map(|wall| wall.height).collect();
            Cell {
                nearest: Nearest::Face,
                apex: at[0],
                middle: mean(&at) + out * 0.5,
                up: height.slope,
                walls: walls.into_iter().chain([floor]).collect(),
                floors: vec![Floor { wall: floor, sides }],
                aabb: of_face.union(&Aabb { min: of_face.min + out, max: of_face.max + out }),
            }
        })
        .collect();
    cells.append(&mut edges);
    cells.append(&mut corners);
    Some(cells)
}

/// The cell of an edge; in 2D of a corner.
fn beside_ridge<const D: usize>(
    ridge: &Ridge,
    at: [Vector<D>; 2],
    outwards: [Linear<D>; 2],
    normals: [Vector<D>; 2],
    ends: [Linear<D>; 2],
    radius: f64,
) -> Option<Cell<D>> {
    let up = (normals[0] + normals[1]).try_normalize(0.0)?;
    if up.dot(&normals[0]) < STEEPEST {
        return None;
    }
    let is_edge = D == 3 && ridge.ends[0] != ridge.ends[1];
    let across: Vec<Wall<D>> = outwards.iter().map(|out| Wall { height: out.negated(), is_own: false }).collect();
    let along: Vec<Wall<D>> = ends.iter().filter(|_| is_edge).map(|end| Wall { height: *end, is_own: true }).collect();
    let floors = across.iter().zip(&normals).map(|(wall, normal)| {
        // The half on the side of this normal.
        let side = (normal - up * up.dot(normal)).try_normalize(0.0).map(|beside| through(&at[0], -beside));
        Floor { wall: *wall, sides: along.iter().map(|wall| wall.height).chain(side).collect() }
    });
    Some(Cell {
        nearest: if is_edge { Nearest::Edge((at[1] - at[0]).normalize()) } else { Nearest::Corner },
        apex: at[0],
        middle: mean(&at) + up * (0.5 * radius),
        up,
        floors: floors.collect(),
        aabb: Aabb::of(&at).inflated(radius),
        walls: across.into_iter().chain(along).collect(),
    })
}

/// The cell of a corner in space, given the planes across the edges that end there, and the normals at each.
fn beside_corner<const D: usize>(
    apex: &Vector<D>,
    at_edges: &[(Wall<D>, [Vector<D>; 2])],
    radius: f64,
) -> Option<Cell<D>> {
    let normals = || at_edges.iter().flat_map(|(_, normals)| normals);
    let mut up = normals().fold(Vector::zeros(), |sum, normal| sum + normal);
    let mut count = normals().count() as f64;
    for _ in 0..STEPS {
        // Towards the middle of the smallest ball around all of them.
        let farthest = normals().min_by(|p, q| p.dot(&up).total_cmp(&q.dot(&up)))?;
        if farthest.dot(&up) > 0.3 * up.norm() {
            break;
        }
        up += farthest;
        count += 1.0;
    }
    let up = (up / count).try_normalize(0.0)?;
    if normals().any(|normal| normal.dot(&up) < STEEPEST) {
        return None;
    }
    let floor = |(wall, [first, second]): &(Wall<D>, [Vector<D>; 2])| {
        let [p, q] = [across(&up, first), across(&up, second)];
        let sign = if p.dot(second) > 0.0 { -1.0 } else { 1.0 };
        let sides = [p * sign, q * -sign].map(|slope| through(apex, slope));
        Floor { wall: *wall, sides: sides.to_vec() }
    };
    Some(Cell {
        nearest: Nearest::Corner,
        apex: *apex,
        middle: apex + up * (0.5 * radius),
        up,
        walls: at_edges.iter().map(|(wall, _)| *wall).collect(),
        floors: at_edges.iter().map(floor).collect(),
        aabb: Aabb { min: *apex, max: *apex }.inflated(radius),
    })
}

fn mean<const D: usize>(points: &[Vector<D>]) -> Vector<D> {
    points.iter().fold(Vector::zeros(), |sum, x| sum + x) / points.len() as f64
}

fn through<const D: usize>(x: &Vector<D>, slope: Vector<D>) -> Linear<D> {
    Linear { slope, constant: -slope.dot(x) }
}

/// The vector product; in 2D the first vector, turned by a right angle.
pub(super) fn across<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> Vector<D> {
    let mut product = Vector::zeros();
    if D == 2 {
        (product[0], product[1]) = (-a[1], a[0]);
        return product;
    }
    for i in 0..D {
        let (j, k) = ((i + 1) % D, (i + 2) % D);
        product[i] = a[j] * b[k] - a[k] * b[j];
    }
    product
}
