//! Arguments of the mesh generators.

use super::super::{CellKind, Key, MeshSource};
use super::Check;

impl Check<'_> {
    pub(super) fn mesh(&mut self, key: &Key, mesh: &MeshSource) {
        let dimension = self.case.dimension;
        if let Some(own) = mesh.dimension().filter(|own| *own != dimension) {
            self.flaw(key, format!("it is a {own}D mesh in a {dimension}D case"));
        }
        let mut cell_is = |cell: CellKind, right: &[CellKind]| {
            if !right.contains(&cell.straight()) {
                let names: Vec<String> = right.iter().map(|kind| format!("{kind:?}").to_lowercase()).collect();
                self.flaw(&key.then("cell"), format!("it must be {} for this shape", names.join(" or ")));
            }
        };
        match *mesh {
            MeshSource::Rectangle { cell, min, max, cells } => {
                cell_is(cell, &[CellKind::Tri3, CellKind::Quad4]);
                self.box_shape(key, &min, &max, &cells);
            }
            MeshSource::Cuboid { cell, min, max, cells } => {
                cell_is(cell, &[CellKind::Tet4, CellKind::Hex8]);
                self.box_shape(key, &min, &max, &cells);
            }
            MeshSource::Quadrilateral { cell, corners, cells } => {
                cell_is(cell, &[CellKind::Quad4]);
                self.quadrilateral(key, corners, &cells);
            }
            MeshSource::Quadrilaterals { cell, ref parts } => {
                cell_is(cell, &[CellKind::Quad4]);
                if parts.is_empty() {
                    self.flaw(&key.then("parts"), "it must have at least one quadrilateral".into());
                }
                for (index, part) in parts.iter().enumerate() {
                    self.quadrilateral(&key.then("parts").then(index), part.corners, &part.cells);
                }
            }
            MeshSource::Tetrahedron { cell, corners, edges } => {
                cell_is(cell, &[CellKind::Tet4]);
                self.counts(&key.then("edges"), &[edges]);
                let [u, v, w] = [1, 2, 3].map(|k| [0, 1, 2].map(|i| corners[k][i] - corners[0][i]));
                let volume = u[0] * (v[1] * w[2] - v[2] * w[1])
                    + u[1] * (v[2] * w[0] - v[0] * w[2])
                    + u[2] * (v[0] * w[1] - v[1] * w[0]);
                if !(volume.is_finite() && volume != 0.0) {
                    self.flaw(&key.then("corners"), "they must not lie in a plane".into());
                }
            }
            MeshSource::Star { cell, tips, outer, inner, side_edges, half_width } => {
                cell_is(cell, &[CellKind::Tri3, CellKind::Quad4]);
                self.positive(&key.then("inner"), inner);
                if tips < 3 {
                    self.flaw(&key.then("tips"), format!("it must be at least 3, not {tips}"));
                } else if !(outer.is_finite() && outer > inner) {
                    self.flaw(&key.then("outer"), format!("it must be larger than inner = {inner}, not {outer}"));
                }
                if half_width == 0 || side_edges <= 2 * half_width {
                    let message = "it must be more than twice half_width, and half_width at least 1".into();
                    self.flaw(&key.then("side_edges"), message);
                }
            }
            MeshSource::Disc { cell, radius, edges } => {
                cell_is(cell, &[CellKind::Tri3, CellKind::Quad4]);
                self.positive(&key.then("radius"), radius);
                if edges < 3 || cell.straight() == CellKind::Quad4 && !edges.is_multiple_of(4) {
                    self.flaw(&key.then("edges"), "it must be at least 3, and a multiple of 4 for quad4".into());
                }
            }
            MeshSource::GradedHalfDisc { cell, radius, finest, fine_to, growth } => {
                cell_is(cell, &[CellKind::Tri3, CellKind::Quad4]);
                let lengths = [("radius", radius), ("finest", finest), ("fine_to", fine_to), ("growth", growth)];
                lengths.into_iter().for_each(|(name, length)| self.positive(&key.then(name), length));
                for (name, length) in [("finest", finest), ("fine_to", fine_to)] {
                    if length >= radius {
                        self.flaw(&key.then(name), format!("it must be less than the radius, not {length}"));
                    }
                }
            }
            MeshSource::GradedBlock { cell, ref size, fine, cells, shells } => {
                let flat = dimension == 2;
                let right = if flat { [CellKind::Tri3, CellKind::Quad4] } else { [CellKind::Tet4, CellKind::Hex8] };
                cell_is(cell, &right);
                self.positive(&key.then("fine"), fine);
                self.counts(&key.then("cells"), &[cells, shells]);
                if size.len() != dimension || size.iter().any(|size| !(size.is_finite() && *size > fine)) {
                    let message = format!("it must have {dimension} numbers, all larger than fine = {fine}");
                    self.flaw(&key.then("size"), message);
                }
            }
            MeshSource::GradedHalfBall { cell, radius, finest, edges } => {
                cell_is(cell, &[CellKind::Tet4]);
                self.positive(&key.then("radius"), radius);
                self.positive(&key.then("finest"), finest);
                if edges < 2 || finest >= radius {
                    self.flaw(key, "edges must be at least 2, and finest less than the radius".into());
                }
            }
            MeshSource::Ball { cell, radius, layers, .. } => {
                cell_is(cell, &[CellKind::Tet4]);
                self.positive(&key.then("radius"), radius);
                self.counts(&key.then("layers"), &[layers]);
            }
            MeshSource::File { .. } => {}
        }
    }

    fn quadrilateral(&mut self, key: &Key, corners: [[f64; 2]; 4], cells: &[usize]) {
        let turn = |k: usize| {
            let [a, b, c] = [0, 1, 2].map(|step| corners[(k + step) % 4]);
            (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
        };
        if !(0..4).all(|k| turn(k) > 0.0 && turn(k).is_finite()) {
            let message = "they must make a convex quadrilateral, counter-clockwise".into();
            self.flaw(&key.then("corners"), message);
        }
        self.counts(&key.then("cells"), cells);
    }

    fn box_shape(&mut self, key: &Key, min: &[f64], max: &[f64], cells: &[usize]) {
        if !min.iter().zip(max).all(|(low, high)| low.is_finite() && high.is_finite() && low < high) {
            self.flaw(&key.then("max"), "it must be larger than min along every axis".into());
        }
        self.counts(&key.then("cells"), cells);
    }

    fn counts(&mut self, key: &Key, counts: &[usize]) {
        if counts.contains(&0) {
            self.flaw(key, "it must be at least 1".into());
        }
    }
}
