//! The pieces of a body's cells that reach into a region.

use crate::depth_field::{DepthField, DepthPiece};
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::{Surface, Vector};
use crate::overlap::pair::bounds::Bounds;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::sides::Pair;
use rustc_hash::FxHashSet;

/// Least part of the height of a piece that is taken for one that rounding may bring about; and how many times the rounding of a
/// coordinate.
const NEAR: f64 = 1e-9;
const DIGITS: f64 = 4.0;

/// Cells whose pieces one thread finds at a time.
const CHUNK: usize = 256;

/// Pieces on which the depth of a body is linear, to be found by place.
pub(crate) struct CellPieces<const D: usize> {
    pub(crate) pieces: Vec<DepthPiece<D>>,
    pub(crate) boxes: Vec<Aabb<D>>,
    pub(crate) tree: Tree<D>,
    /// Barycentric coordinates of each that are no more than this may be rounding.
    pub(crate) near: Vec<f64>,
}

impl<const D: usize> CellPieces<D> {
    /// The pieces of one body of a pair that meet its `region`; `facets` are those of its facets that do. The boxes are those of
    /// the part of each within the bounds, if there are some. Depths are those below where the contact begins.
    pub(crate) fn new(
        pair: &Pair<D>,
        cells: &Cells,
        field: &DepthField<D>,
        body: usize,
        (facets, region): (&[u32], &Aabb<D>),
        bounds: Option<&Bounds<D>>,
        clearance: f64,
    ) -> Self {
        let (surface, coords, rounding) = (pair.surface, pair.coords, region.rounding());
        let which = usize::from(pair.partners[0] != Partner::Body(body));
        let layer = pair.tied.map(|tied| &tied.layers[which]);
        let of_cells = |some: &[u32]| {
            let mut found = Vec::new();
            for &cell in some {
                let mut add = |piece: DepthPiece<D>| {
                    let corners = &piece.corners[..=D];
                    let mut aabb = Aabb::of(corners);
                    if let (Some(bounds), true) = (bounds, aabb.meets(region)) {
                        aabb = bounds.box_of_part(corners);
                    }
                    if aabb.meets(region) && !aabb.is_empty() {
                        let piece = piece.lowered(clearance);
                        found.push((near(&piece, rounding), aabb, piece));
                    }
                };
                field.for_each_piece(cells, cell as usize, coords, |piece| match layer {
                    Some(layer) => layer.for_each_part(piece, cells, &mut add),
                    None => add(piece),
                });
            }
            found
        };
        let all = cells_in(surface, cells, field, coords, body, (facets, region), bounds);
        let found = pair.on_threads(&all, CHUNK, of_cells);
        let count = found.iter().map(Vec::len).sum();
        let mut all = Self {
            pieces: Vec::with_capacity(count),
            boxes: Vec::with_capacity(count),
            tree: Tree::new(&[]),
            near: Vec::with_capacity(count),
        };
        for (near, aabb, piece) in found.into_iter().flatten() {
            all.near.push(near);
            all.boxes.push(aabb);
            all.pieces.push(piece);
        }
        all.tree = Tree::new(&all.boxes);
        all
    }
}

/// Barycentric coordinates of a piece that may be rounding.
fn near<const D: usize>(piece: &DepthPiece<D>, rounding: f64) -> f64 {
    let steepest = piece.slopes[..=D].iter().fold(0.0f64, |most, slope| most.max(slope.norm_squared()));
    (DIGITS * rounding * steepest.sqrt()).max(NEAR)
}

/// Cells of one body whose boxes meet `region` and that the bounds may hold a part of, ascending.
///
/// The part of a body that hangs together within a box either reaches the surface there, or is all of the box. So the
/// cells behind the facets in the region lead to all others through the faces between them, where the body hangs
/// together; where it has no facet in the region, or falls apart, all cells are looked at.
fn cells_in<const D: usize>(
    surface: &Surface<D>,
    cells: &Cells,
    field: &DepthField<D>,
    coords: &[[f64; D]],
    body: usize,
    (facets, region): (&[u32], &Aabb<D>),
    bounds: Option<&Bounds<D>>,
) -> Vec<u32> {
    let meets = |cell: u32| {
        let points = cells.nodes(cell as usize).iter().map(|&n| Vector::from(coords[n as usize]));
        let mut aabb = Aabb::empty();
        points.clone().for_each(|x| aabb.include(&x));
        aabb.meets(region) && bounds.is_none_or(|bounds| bounds.may_hold(points))
    };
    if facets.is_empty() || !field.is_connected(body) {
        let own = (0..cells.len() as u32).filter(|&cell| cells.body[cell as usize] as usize == body);
        return own.filter(|&cell| meets(cell)).collect();
    }
    let facet_cell = &surface.facet_cell[surface.ranges[body].clone()];
    let mut seen = FxHashSet::default();
    let mut found: Vec<u32> = Vec::new();
    for &facet in facets {
        let cell = facet_cell[facet as usize];
        if seen.insert(cell) && meets(cell) {
            found.push(cell);
        }
    }
    let mut next = 0;
    while next < found.len() {
        for &cell in cells.neighbours(found[next] as usize) {
            if seen.insert(cell) && meets(cell) {
                found.push(cell);
            }
        }
        next += 1;
    }
    found.sort_unstable();
    found
}
