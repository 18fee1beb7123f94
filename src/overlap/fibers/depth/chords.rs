//! Chords: the parts of lines inside the pieces of cells.

use crate::geometry::crossing::{Window, for_each_crossing};
use crate::overlap::depth::cell_pieces::CellPieces;
use crate::sampling::Family;

/// The part of a line inside a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord {
    /// Number of the line in its window.
    pub(super) line: u32,
    pub(super) of_b: bool,
    pub(super) piece: u32,
    /// Where it begins and ends along the line.
    pub(super) ends: [f64; 2],
}

impl Chord {
    /// Sorts chords by line and side, along the line.
    pub(super) fn sort(chords: &mut [Self]) {
        chords.sort_unstable_by(|p, q| {
            let place = |c: &Self| (c.line, c.of_b);
            place(p).cmp(&place(q)).then(p.ends[0].total_cmp(&q.ends[0])).then(p.piece.cmp(&q.piece))
        });
    }
}

/// The lines of a family that are of interest.
pub(super) struct Lines<'a, const D: usize> {
    pub(super) family: &'a Family<D>,
    pub(super) spacing: f64,
    pub(super) window: &'a Window,
}

impl<const D: usize> Lines<'_, D> {
    /// Adds the chords of all pieces of one side. Pieces that share a face are left and entered at the same place: a line is in
    /// one of them.
    pub(super) fn chords(&self, of: &CellPieces<D>, of_b: bool, chords: &mut Vec<Chord>) {
        let Self { family, spacing, window } = *self;
        let per_length = 1.0 / spacing;
        let (corner, far) = family.window_in_length(window, spacing);
        let mut crossed: Vec<(u32, f64)> = Vec::new();
        of.tree.visit(
            |aabb| {
                let [low, high] = family.view_box(aabb);
                (0..D - 1).all(|axis| low[axis] <= far[axis] && high[axis] >= corner[axis])
            },
            |piece| {
                let corners = &of.pieces[piece as usize].corners;
                let p = corners.map(|x| family.on_grid(&family.view(&x), per_length));
                crossed.clear();
                for face in 0..=D {
                    for_each_crossing::<D>(
                        std::array::from_fn(|k| &p[(face + 1 + k) % (D + 1)]),
                        window,
                        |i, j, t, _| crossed.push((window.line(i, j), t)),
                    );
                }
                crossed.sort_unstable_by(|p, q| p.0.cmp(&q.0).then(p.1.total_cmp(&q.1)));
                // A line crosses the faces of a simplex twice; rounding makes four of it where the simplex is flat.
                for on_line in crossed.chunk_by(|p, q| p.0 == q.0) {
                    let [(line, first), .., (_, last)] = *on_line else { continue };
                    if first < last {
                        chords.push(Chord { line, of_b, piece, ends: [first, last] });
                    }
                }
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::depth::DepthField;
    use crate::geometry::aabb::Aabb;
    use crate::geometry::tree::Tree;
    use crate::geometry::{Bodies, CellBlock, CellType, Surface, Weighting};

    /// The chords of a line through a cube fill its way through the cube, without gaps, with lines on a lattice that the
    /// mesh has too.
    #[test]
    fn chords_fill_a_line() {
        let mesh = fmc_shapes::cuboid_tet4([0.0; 3], [1.0; 3], [3, 3, 3]);
        let block = [CellBlock { cell_type: CellType::Tet4, conn: &mesh.conn }];
        let surface = Surface::from_cells(&mesh.coords, &block, Bodies::Connected).expect("a mesh");
        let field = DepthField::new(&surface, None, Weighting::Plain).expect("a field");
        let cells = surface.cells.as_ref().expect("cells");
        let mut pieces = Vec::new();
        (0..cells.len()).for_each(|cell| field.for_each_piece(cells, cell, &mesh.coords, |piece| pieces.push(piece)));
        let boxes: Vec<Aabb<3>> = pieces.iter().map(|piece| Aabb::of(&piece.corners)).collect();
        let of = CellPieces { tree: Tree::new(&boxes), pieces, boxes };
        for family in Family::<3>::all(3) {
            let spacing = 0.04;
            let (window, _) =
                family.window(&Aabb::of(&[[-0.1; 3].into(), [1.1; 3].into()]), 1.0 / spacing).expect("few");
            let mut chords = Vec::new();
            Lines { family: &family, spacing, window: &window }.chords(&of, false, &mut chords);
            Chord::sort(&mut chords);
            let mut lines = 0;
            for on_line in chords.chunk_by(|p, q| p.line == q.line) {
                lines += 1;
                for two in on_line.windows(2) {
                    assert!((two[0].ends[1] - two[1].ends[0]).abs() < 1e-14, "{two:?}");
                }
            }
            // The shadow of the cube, by the lines that meet it: half its surface projected.
            let shadow: f64 = family.direction().iter().map(|x| x.abs()).sum();
            assert!((f64::from(lines) * spacing * spacing / shadow - 1.0).abs() < 0.02, "{lines} lines");
            let length: f64 = chords.iter().map(|chord| chord.ends[1] - chord.ends[0]).sum();
            assert!((length * spacing * spacing - 1.0).abs() < 0.02, "{length}");
        }
    }
}
