//! Abaqus input files: against the same meshes in other formats, by hand, and with what is wrong in them.

use fmc_contact::CellType;
use fmc_mesh_io::{Kind, Mesh};
use std::fs;
use std::path::Path;

fn data(name: &str) -> Mesh {
    Mesh::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)).expect("a mesh")
}

fn read(test: &str, text: &str) -> anyhow::Result<Mesh> {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{test}.inp"));
    fs::write(&path, text).unwrap();
    Mesh::read(&path)
}

/// Names of the groups of all cells, in their order.
fn groups(mesh: &Mesh) -> Vec<Option<&str>> {
    mesh.cells().map(|cell| cell.3.map(|group| mesh.group_names[&group].as_str())).collect()
}

#[test]
fn what_meshio_writes_is_the_mesh_it_wrote() {
    for (name, kind) in [("plane", Kind::Flat), ("solid", Kind::Solid)] {
        let [inp, gmsh] = [format!("{name}_meshio.inp"), format!("{name}_text.msh")].map(|name| data(&name));
        assert_eq!(inp.kind(), kind);
        let cells = |mesh: &Mesh| mesh.cells().map(|(kind, nodes, ..)| (kind, nodes.to_vec())).collect::<Vec<_>>();
        assert_eq!(cells(&inp), cells(&gmsh), "{name}");
        assert_eq!(groups(&inp), groups(&gmsh), "{name}");
        assert!(inp.instances.is_empty());
        for (x, y) in inp.points.iter().zip(&gmsh.points) {
            assert!((0..3).all(|axis| (x[axis] - y[axis]).abs() < 1e-15), "{name}: {x:?} {y:?}");
        }
    }
}

#[test]
fn instances_are_moved_then_turned() {
    let mesh = data("instances.inp");
    let cells: Vec<_> = mesh.cells().map(|(kind, nodes, tag, _)| (kind, nodes.to_vec(), tag)).collect();
    let expected = [
        (CellType::Hex8, (0..8).collect(), 5),
        (CellType::Hex8, (9..17).collect(), 5),
        (CellType::Tet4, (18..22).collect::<Vec<u32>>(), 5),
    ];
    assert_eq!(cells, expected);
    assert_eq!(groups(&mesh), [Some("Block-1"), Some("Block two"), Some("Tip-1")]);
    let names: Vec<_> = mesh.instances.iter().map(|i| (i.name.as_str(), i.nodes.clone())).collect();
    assert_eq!(names, [("Block-1", 0..9), ("Block two", 9..18), ("Tip-1", 18..22), ("assembly", 22..23)]);
    assert_eq!(mesh.points[6], [1.0, 2.0, 3.0]);
    assert_eq!(mesh.node_tags[6], 31);
    // (1, 2, 3) is moved to (11, 2, 3), then turned by 90° about the upright axis through (10, 0): exact, as right angles are.
    assert_eq!(mesh.points[15], [8.0, 1.0, 3.0]);
    assert_eq!(mesh.points[21], [0.0, 0.0, 6.0]);
}

/// A mesh in several files is the mesh in one.
#[test]
fn included_files_stand_in_their_places() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("included");
    fs::create_dir_all(folder.join("parts")).unwrap();
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
    let whole = read("whole", &format!("{PLANE}*ELSET, ELSET=TWO\n2\n")).unwrap();
    let (nodes, elements) = PLANE.split_at(PLANE.find("*ELEMENT").unwrap());
    write("parts/nodes.txt", nodes.strip_prefix("*NODE\n").unwrap());
    write("parts/elements.inp", &format!("** elements\n{elements}*include,\n input = \"sets.inp\"\n"));
    write("sets.inp", "*ELSET, ELSET=TWO\n2\n");
    write("main.inp", "*Heading\nin parts\n*NODE, INPUT=parts/nodes.txt\n*INCLUDE, INPUT=parts/elements.inp\n*STEP\n");
    let torn = Mesh::read(&folder.join("main.inp")).unwrap();
    assert_eq!((&torn.points, &torn.node_tags, &torn.blocks), (&whole.points, &whole.node_tags, &whole.blocks));
    assert_eq!(groups(&torn), groups(&whole));

    let said = || format!("{:#}", Mesh::read(&folder.join("main.inp")).unwrap_err());
    // What is wrong is told where it stands: in the file that was included, and behind it in the first.
    write("sets.inp", "*ELSET, ELSET=TWO\n\nNONE\n");
    assert!(
        said().contains("line 3 of ") && said().contains("sets.inp: no element set has been named 'NONE'"),
        "{}",
        said()
    );
    write("sets.inp", "*INCLUDE, INPUT=main.inp\n");
    assert!(said().contains("main.inp includes itself"), "{}", said());
    write("sets.inp", "*INCLUDE, INPUT=parts\n");
    assert!(said().contains("parts is not a file"), "{}", said());
    write("sets.inp", "*INCLUDE\n");
    assert!(said().contains("line 1 of ") && said().contains("*INCLUDE has no INPUT="), "{}", said());
    write("sets.inp", "** nothing\n");
    write("main.inp", "*INCLUDE, INPUT=parts/elements.inp\n*NODE\n1,x,0\n");
    assert!(said().contains("line 3: expected a number"), "{}", said());
    // A file of files of files.
    write("sets.inp", &"*INCLUDE, INPUT=more.inp\n".repeat(300));
    write("more.inp", &"*INCLUDE, INPUT=most.inp\n".repeat(300));
    write("most.inp", &"** nothing at all\n".repeat(300));
    assert!(said().contains("is included too often"), "{}", said());
}

/// Two triangles and a square in a row.
const PLANE: &str =
    "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,0\n60,2,1\n*ELEMENT,TYPE=CPS3,ELSET=ALL\n1,1,2,3\n2,1,3,4\n";

/// What editors and programs of Windows write: a mark of UTF-8, backslashes, and coordinates that are left empty.
#[test]
fn files_of_windows_are_read() {
    let plain = "*NODE\n1, 0., 0.\n2, 1., 0.\n3, 0., 1.\n*ELEMENT, TYPE=CPE3\n1, 1, 2, 3\n";
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("windows");
    fs::create_dir_all(folder.join("parts")).unwrap();
    fs::write(folder.join("parts/mesh.inp"), format!("\u{feff}{}", plain.replace("3, 0., 1.", "3, , 1."))).unwrap();
    fs::write(folder.join("main.inp"), "\u{feff}*INCLUDE, INPUT=parts\\mesh.inp\n").unwrap();
    let found = Mesh::read(&folder.join("main.inp")).unwrap();
    assert_eq!(found.points, read("windows-plain", plain).unwrap().points);
    assert_eq!(found.cell_count(), 1);
}

#[test]
fn cells_go_by_their_section_else_by_the_first_set() {
    let square = "*ELEMENT,TYPE=CAX4\n8,2,5,60,3\n";
    let sets = "*ELSET,ELSET=odd,GENERATE\n1,7,2\n*elset,elset=Both\nODD,8\n";
    let mesh = read("sets", &format!("{PLANE}{square}{sets}")).unwrap();
    assert_eq!(groups(&mesh), [Some("ALL"), Some("ALL"), Some("Both")]);
    assert_eq!(mesh.node_tags, [1, 2, 3, 4, 5, 60]);
    let section = "*SOLID SECTION, ELSET=both, MATERIAL=M\n1.,\n";
    let mesh = read("sets", &format!("{PLANE}{square}{sets}{section}")).unwrap();
    assert_eq!(groups(&mesh), [Some("Both"), Some("ALL"), Some("Both")]);
    assert_eq!(groups(&read("sets", &format!("{PLANE}*ELEMENT,TYPE=CPE4R\n3,2,5,60,3")).unwrap())[2], None);
}

#[test]
fn lines_and_points_are_left_out() {
    let mesh = read("slender", &format!("{PLANE}*ELEMENT,TYPE=T2D2\n9,1,2\n*ELEMENT,TYPE=MASS\n10,1\n")).unwrap();
    assert_eq!(mesh.cell_count(), 2);
    // Faces of solids, as Gmsh writes them beside these.
    let solid =
        "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT,TYPE=CPS3\n1,1,2,3\n*ELEMENT,TYPE=C3D4H\n2,1,2,3,4\n";
    let mesh = read("slender", solid).unwrap();
    assert_eq!((mesh.kind(), mesh.cell_count()), (Kind::Solid, 1));
    let mesh = read("slender", &solid.replace("C3D4H\n2,1,2,3,4", "S3R\n2,1,2,4")).unwrap();
    assert_eq!((mesh.kind(), mesh.cell_count()), (Kind::Surface, 2));
}

#[test]
fn what_is_wrong_is_named_with_its_line() {
    let part = "*PART,NAME=A\n*NODE\n1,0,0\n*END PART\n";
    for (text, expected) in [
        (format!("{PLANE}*ELEMENT,TYPE=CIN3D8\n"), "line 11: elements of type CIN3D8 are not supported, only CPS3"),
        (format!("{PLANE}*ELEMENT,TYPE=C3D15V\n"), "line 11: elements of type C3D15V are not supported"),
        (format!("{PLANE}*ELEMENT\n"), "line 11: *ELEMENT has no TYPE="),
        (format!("{PLANE}*ELEMENT TYPE=CPS3\n"), "line 11: *ELEMENT TYPE=CPS3 has no comma after its name"),
        (format!("{PLANE}2,1,2,3\n"), "line 11: element 2 is there twice"),
        (format!("{PLANE}3,1,2,7\n"), "line 11: element 3 names node 7, which does not exist"),
        (format!("{PLANE}3,1,2,3,4\n"), "line 11: element 3 has 4 nodes; Tri3 has 3"),
        (format!("{PLANE}3,1,\n"), "line 11: element 3 has 1 nodes; Tri3 has 3"),
        (format!("{PLANE}3,1,,2\n"), "line 11: expected a whole number above 0, found ''"),
        (format!("{PLANE}3,1,<n>,2\n"), "line 11: expected a whole number above 0, found '<n>'"),
        (format!("{PLANE}*NODE\n1,0,0\n"), "line 12: node 1 is there twice"),
        (format!("{PLANE}*NODE\n9,0,zero\n"), "line 12: expected a number, found 'zero' in field 3 of node 9"),
        (format!("{PLANE}*NODE\n9,0,nan\n"), "line 12: expected a finite number, found 'nan' in field 3 of node 9"),
        (format!("{PLANE}*NODE\n9,0,1e999\n"), "line 12: expected a finite number, found '1e999'"),
        (format!("{PLANE}*NODE, SYSTEM=C\n"), "line 11: nodes in the coordinates SYSTEM=C are not supported"),
        (format!("{PLANE}*NODE, INPUT=n.txt\n"), "line 11 includes 'n.txt'"),
        (format!("{PLANE}*Include, input=more.inp\n"), "line 11 includes 'more.inp'"),
        (format!("{PLANE}*NGEN\n1,9,1\n"), "line 11: *NGEN is not supported"),
        (format!("{PLANE}*ELSET,ELSET=X\nOTHER\n"), "line 12: no element set has been named 'OTHER'"),
        (format!("{PLANE}*ELSET,ELSET=X,GENERATE\n1\n"), "line 12: expected first, last and step"),
        (format!("{PLANE}*ELSET,ELSET=X,GENERATE\n1,5,0\n"), "line 12: expected a whole number above 0, found '0'"),
        (format!("{PLANE}*END PART\n"), "line 11: *END PART stands where none can be"),
        (format!("{part}{part}"), "line 5: part A is there twice"),
        ("*NODE\n1,0,0\n*PART,NAME=A\n".into(), "the file ends within the block that begins in line 3"),
        (format!("{part}*ASSEMBLY\n*INSTANCE,NAME=I,PART=B\n"), "line 6: there is no part 'B'"),
        (format!("{part}*ASSEMBLY\n*INSTANCE,NAME=I,PART=A\n0,0,0\n1,1,1,1,1,1,90\n"), "line 8: the two points"),
        (
            format!("{part}*ASSEMBLY\n*INSTANCE,NAME=I,PART=A\n*NODE\n"),
            "the file ends within the block that begins in line 6",
        ),
        (format!("{part}*ASSEMBLY\n*END ASSEMBLY\n"), "it has parts, but no *INSTANCE of any"),
        (format!("{PLANE}*ELEMENT,TYPE=R2D2\n9,1,2\n"), "line 11: elements of type R2D2 are rigid lines"),
        (
            "*NODE\n1,0,0\n2,1,0\n3,0,1\n4,0,0,1\n*ELEMENT,TYPE=R3D3\n8,1,2,3\n*ELEMENT,TYPE=C3D4\n9,1,2,3,4\n".into(),
            "line 7: element 8 is a shell in a mesh with solids, which is not supported: a tool",
        ),
    ] {
        let error = format!("{:#}", read("wrong", &text).expect_err(expected));
        assert!(error.contains(expected), "'{expected}' is not in: {error}");
    }
}

/// Instances are what a small file can have many of.
#[test]
fn instances_are_bounded() {
    let mut text = "*PART,NAME=A\n*NODE\n".to_owned();
    (1..=20_000).for_each(|node| text.push_str(&format!("{node},0\n")));
    text.push_str("*END PART\n*ASSEMBLY\n");
    (0..600).for_each(|k| text.push_str(&format!("*INSTANCE,NAME=I{k},PART=A\n*END INSTANCE\n")));
    text.push_str("*END ASSEMBLY\n");
    let error = format!("{:#}", read("bounded", &text).unwrap_err());
    assert!(error.contains("12000000 nodes of cells, too many for one mesh"), "{error}");
}

#[test]
fn files_cut_short_are_errors_or_shorter() {
    let whole = data("instances.inp");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/instances.inp");
    let text = std::fs::read_to_string(path).unwrap();
    let end = text.find("*End Assembly").unwrap();
    for length in 1..text.len() {
        // Only what has nothing to do with nodes and elements may be missing.
        if let Ok(mesh) = read("cut", &text[..length]) {
            assert!(length > end && mesh.blocks == whole.blocks, "{length}");
        }
    }
}
