//! Blocks as text of an input file.

use std::fmt::Write;

/// Nodes and hexahedra `C3D8` of a block, labels from `first`; the sets `NAME` of elements, `NAME_NODES`, `NAME_LOW` and `NAME_HIGH` of nodes at its ends
/// along z, and surfaces `S_NAME_LOW` and `S_NAME_HIGH`.
pub(crate) fn block(name: &str, first: usize, cells: [usize; 3], ends: [[f64; 3]; 2]) -> String {
    block_with_wedges(name, first, cells, ends, 0)
}

/// The same with so many of the last columns along x in two upright wedges `C3D6` for each hexahedron, with labels from 5000 on.
pub(crate) fn block_with_wedges(
    name: &str,
    first: usize,
    cells: [usize; 3],
    [low, high]: [[f64; 3]; 2],
    columns: usize,
) -> String {
    let [nx, ny, nz] = cells;
    let node = |i: usize, j: usize, k: usize| first + i + (nx + 1) * (j + (ny + 1) * k);
    let all = |n: usize| 0..=n;
    let mut text = format!("*NODE, NSET={name}_NODES\n");
    for (k, j, i) in all(nz).flat_map(|k| all(ny).flat_map(move |j| all(nx).map(move |i| (k, j, i)))) {
        let at = |axis: usize, n: usize| low[axis] + (high[axis] - low[axis]) * n as f64 / cells[axis] as f64;
        writeln!(text, "{}, {}, {}, {}", node(i, j, k), at(0, i), at(1, j), at(2, k)).unwrap();
    }
    for (end, k) in [("LOW", 0), ("HIGH", nz)] {
        let (start, last) = (node(0, 0, k), node(nx, ny, k));
        writeln!(text, "*NSET, NSET={name}_{end}, GENERATE\n{start}, {last}").unwrap();
    }
    writeln!(text, "*ELEMENT, TYPE=C3D8, ELSET={name}").unwrap();
    let (mut label, mut wedges) = (first, String::new());
    let mut ends = [String::new(), String::new()];
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let ring = |k| [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)];
                let nodes: Vec<String> = [ring(k), ring(k + 1)].concat().iter().map(ToString::to_string).collect();
                let mut labels = vec![label];
                if i + columns < nx {
                    writeln!(text, "{label}, {}", nodes.join(", ")).unwrap();
                } else {
                    labels = vec![5000 + 2 * label, 5001 + 2 * label];
                    for (label, cut) in labels.iter().zip([[0, 1, 2, 4, 5, 6], [0, 2, 3, 4, 6, 7]]) {
                        writeln!(wedges, "{label}, {}", cut.map(|k| nodes[k].as_str()).join(", ")).unwrap();
                    }
                }
                for (end, face) in
                    [(0, "S1"), (1, "S2")].into_iter().filter(|(end, _)| k == if *end == 0 { 0 } else { nz - 1 })
                {
                    labels.iter().for_each(|label| writeln!(ends[end], "{label}, {face}").unwrap());
                }
                label += 1;
            }
        }
    }
    if !wedges.is_empty() {
        write!(text, "*ELEMENT, TYPE=C3D6, ELSET={name}\n{wedges}").unwrap();
    }
    let [low, high] = ends;
    text + &format!("*SURFACE, NAME=S_{name}_LOW\n{low}*SURFACE, NAME=S_{name}_HIGH\n{high}")
}

/// An elastic material and its sections.
pub(crate) fn elastic(sets: &[&str], young: f64, poisson: f64) -> String {
    let sections: String = sets.iter().map(|set| format!("*SOLID SECTION, ELSET={set}, MATERIAL=M\n")).collect();
    format!("*MATERIAL, NAME=M\n*ELASTIC\n{young}, {poisson}\n{sections}")
}
