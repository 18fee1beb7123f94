//! Gmsh's format 2.2 as Gmsh itself writes it: one header for each binary element, elements once for each group.

use fmc_contact::CellType;
use fmc_mesh_io::Mesh;

fn read(name: &str, bytes: &[u8]) -> anyhow::Result<Mesh> {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).unwrap();
    Mesh::read(&path)
}

/// A square of two triangles beside a unit square, with a line and numbers that leave gaps.
fn text(elements: &str) -> String {
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 4 \"left half\"\n2 6 \"right\"\n$EndPhysicalNames\n\
         $Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n40 0 1 0\n5 2 0 0\n6 2 1 0\n$EndNodes\n$Elements\n{elements}$EndElements\n"
    )
}

#[test]
fn an_element_of_several_groups_is_there_once() {
    let rows = "5\n1 1 2 9 1 1 2\n7 2 2 4 1 1 2 3\n8 2 3 4 1 0 1 3 40\n8 2 2 6 1 1 3 40\n9 3 2 0 1 2 5 6 3\n";
    let mesh = read("groups_22.msh", text(rows).as_bytes()).unwrap();
    let cells: Vec<_> = mesh.cells().map(|(kind, nodes, tag, group)| (kind, nodes.to_vec(), tag, group)).collect();
    let expected = [
        (CellType::Tri3, vec![0, 1, 2], 7, Some(4)),
        (CellType::Tri3, vec![0, 2, 3], 8, Some(4)),
        (CellType::Quad4, vec![1, 4, 5, 2], 9, None),
    ];
    assert_eq!(cells, expected);
    assert_eq!(mesh.group_names[&4], "left half");
    // What is there twice in one group is for the library to name.
    let mesh = read("twice_22.msh", text("2\n7 2 2 4 1 1 2 3\n8 2 2 4 1 1 2 3\n").as_bytes()).unwrap();
    assert_eq!(mesh.cell_count(), 2);
}

#[test]
fn binary_in_either_byte_order() {
    for big in [false, true] {
        let int = |n: i32| if big { n.to_be_bytes() } else { n.to_le_bytes() };
        let double = |x: f64| if big { x.to_be_bytes() } else { x.to_le_bytes() };
        let mut bytes = b"$MeshFormat\n2.2 1 8\n".to_vec();
        bytes.extend(int(1));
        bytes.extend(b"\n$EndMeshFormat\n$Nodes\n4\n");
        for (tag, [x, y]) in [(3, [0.0, 0.0]), (5, [1.0, 0.0]), (7, [1.0, 1.0]), (10, [0.0, 1.0])] {
            bytes.extend(int(tag));
            [x, y, 0.0].iter().for_each(|&x| bytes.extend(double(x)));
        }
        bytes.extend(b"\n$EndNodes\n$Elements\n2\n");
        for row in [[2, 1, 2, 11, 4, 1, 3, 5, 7], [2, 1, 2, 12, 4, 1, 3, 7, 10]] {
            row.iter().for_each(|&n| bytes.extend(int(n)));
        }
        bytes.extend(b"\n$EndElements\n");
        let mesh = read(&format!("big_{big}.msh"), &bytes).unwrap();
        assert_eq!(mesh.points[2], [1.0, 1.0, 0.0]);
        let [block] = &mesh.blocks[..] else { panic!("{:?}", mesh.blocks) };
        assert_eq!((&block.conn[..], &block.tags[..]), (&[0, 1, 2, 0, 2, 3][..], &[11, 12][..]));
    }
}

#[test]
fn what_is_wrong_is_named_with_its_line() {
    for (rows, expected) in [
        ("9999999999\n7 2 2 4 1 1 2 3\n", "line 19: the file ends before the 9999999999 entries"),
        ("1\n7 77 2 4 1 1 2 3\n", "line 20: element type 77 is not known"),
        ("1\n7 2 2 4 1 1 2 -3\n", "line 20: expected a whole number of at least 0, found '-3'"),
        ("1\n7 2 2 4 1 1 2 8\n", "cell 7 names node 8, which does not exist"),
        ("2\n7 2 2 4 1 1 2 3\n", "line 21: expected a whole number of at least 0, found '$EndElements'"),
        ("1\n7 2 2 4 1 1 2 3\n8 2 2 4 1 1 2 3\n", "line 21: expected $EndElements, found"),
    ] {
        let error = format!("{:#}", read("wrong_22.msh", text(rows).as_bytes()).unwrap_err());
        assert!(error.contains(expected), "{error}");
    }
}
