//! Bad usage and bad files: a sentence with the file and what is wrong, exit status 2, never a panic.

use crate::command::{folder, force};

/// Gmsh mesh of one entity of `dimension`, with node tags from 11 and element tags from 101.
fn msh(dimension: usize, nodes: &[&str], kind: usize, elements: &[&str]) -> String {
    let tagged = |start: usize, lines: &[&str]| -> String {
        lines.iter().enumerate().map(|(k, line)| format!("{} {line}\n", start + k)).collect()
    };
    let (n, e) = (nodes.len(), elements.len());
    let tags: String = (0..n).map(|k| format!("{}\n", 11 + k)).collect();
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {n} 11 {}\n{dimension} 1 0 {n}\n{tags}{}\n$EndNodes\n\
         $Elements\n1 {e} 101 {}\n{dimension} 1 {kind} {e}\n{}$EndElements\n",
        10 + n,
        nodes.join("\n"),
        100 + e,
        tagged(101, elements)
    )
}

const CORNERS: [&str; 4] = ["0 0 0", "1 0 0", "1 1 0", "0 1 0"];
const TETRAHEDRON: [&str; 4] = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"];

fn assert_refused(test: &str, words: &str, parts: &[&str]) {
    let run = force(test, words);
    assert_eq!(run.status, Some(2), "{words}: {}{}", run.stdout, run.stderr);
    assert_eq!(run.stdout, "", "{words}");
    assert!(run.stderr.starts_with("error: ") && !run.stderr.contains("panicked"), "{words}: {}", run.stderr);
    for part in parts {
        assert!(run.stderr.contains(part), "{words}: '{part}' is not in: {}", run.stderr);
    }
}

/// A file with this content is refused with a sentence that names the file and holds `parts`.
fn assert_file_refused(name: &str, content: &str, parts: &[&str]) {
    std::fs::write(folder("refusals").join(name), content).unwrap();
    assert_refused("refusals", &format!("{{}}/{name} --stiffness 1"), &[&[name], parts].concat());
}

#[test]
fn files_that_are_no_meshes() {
    assert_refused("refusals", "{}/missing.msh --stiffness 1", &["missing.msh cannot be read"]);
    assert_refused("refusals", "Cargo.toml --stiffness 1", &["Cargo.toml", "neither a Gmsh mesh"]);
    assert_file_refused("empty.msh", "", &["neither a Gmsh mesh"]);
    assert_file_refused("other.msh", "$Other\n$EndOther\n", &["$Other stands before $MeshFormat"]);
    assert_file_refused("page.vtu", "<html></html>", &["not a VTK file"]);
    assert_file_refused("broken.vtu", "<VTKFile><", &["not well-formed XML"]);
    assert_file_refused("image.vtu", "<VTKFile type=\"ImageData\"/>", &["ImageData", "unstructured grid"]);
}

#[test]
fn gmsh_files_that_cannot_be_used() {
    let square = msh(2, &CORNERS, 3, &["11 12 13 14"]);
    assert_file_refused("old.msh", "$MeshFormat\n4 0 8\n$EndMeshFormat\n", &["version 4;", "save it as version 4.1"]);
    assert_file_refused("new.msh", "$MeshFormat\n5 0 8\n$EndMeshFormat\n", &["version 5", "save it as version 4.1"]);
    assert_file_refused("cut.msh", &square[..square.len() - 30], &["ends"]);
    assert_file_refused("bare.msh", square.split("$Elements").next().unwrap(), &["no $Elements"]);
    assert_file_refused("word.msh", &square.replace("1 1 0\n", "1 one 0\n"), &["line 13", "found 'one'"]);
    assert_file_refused("id.msh", &msh(2, &CORNERS, 3, &["11 12 13 99"]), &["cell 101", "node 99", "does not exist"]);
    assert_file_refused(
        "order.msh",
        &msh(2, &CORNERS, 21, &["11 12 13 14 11 12 13 14 11 12"]),
        &["Tri10", "second order"],
    );
    assert_file_refused("type.msh", &msh(2, &CORNERS, 777, &[]), &["element type 777"]);
    assert_file_refused("lines.msh", &msh(1, &CORNERS, 1, &["11 12", "12 13"]), &["no triangles, quadrilaterals"]);
    let (format, rest) = square.split_at(square.find("$Nodes").unwrap());
    assert_file_refused("twice.msh", &format!("{format}{}", rest.replacen("12\n", "11\n", 1)), &["node 11", "twice"]);
}

#[test]
fn vtu_files_that_cannot_be_used() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ball.vtu")).unwrap();
    let start = text.find("Name=\"connectivity\"").unwrap();
    let (head, cells) = text.split_at(start + text[start..].find('\n').unwrap() + 1);
    let renamed = |node: &str| format!("{head}{node}{}", &cells[cells.find(' ').unwrap()..]);
    assert_file_refused("id.vtu", &renamed("643"), &["cell 0", "node 643", "there are 643 nodes"]);
    assert_file_refused("negative.vtu", &renamed("-1"), &["cell 0", "node -1"]);
    assert_file_refused("word.vtu", &renamed("one"), &["'connectivity'", "'one'"]);
    assert_file_refused("cut.vtu", &text[..text.len() / 2], &["not well-formed"]);
    assert_file_refused(
        "type.vtu",
        &text.replace(
            "UInt8\" Name=\"types\" NumberOfComponents=\"1\" format=\"ascii\">\n10",
            "UInt8\" Name=\"types\">\n71",
        ),
        &["Lagrange tetrahedron", "second order"],
    );
    let lzma = text.replacen("format=\"ascii\"", "format=\"binary\"", 1);
    let lzma = lzma.replacen("byte_order", "compressor=\"vtkLZMADataCompressor\" byte_order", 1);
    assert_file_refused("points.vtu", &lzma, &["'Points'", "base64"]);
}

#[test]
fn meshes_that_cannot_be_bodies() {
    assert_file_refused(
        "nan.msh",
        &msh(2, &["0 0 0", "1 0 0", "1 nan 0", "0 1 0"], 3, &["11 12 13 14"]),
        &["coordinate y of node 13 is not finite"],
    );
    assert_file_refused("double.msh", &msh(2, &CORNERS, 3, &["11 12 11 13"]), &["cell 101 names node 11 twice"]);
    assert_file_refused("thin.msh", &msh(2, &["0 0 0", "1 0 0", "2 0 0"], 2, &["11 12 13"]), &["cell 101 has no area"]);
    let tie = msh(2, &CORNERS, 3, &["11 12 14 13"]);
    assert_file_refused("tie.msh", &tie, &["cell 101 is inverted", "bow tie"]);
    let twice = msh(2, &CORNERS, 3, &["11 12 13 14", "12 13 14 11"]);
    assert_file_refused("twice.msh", &twice, &["cells 101 and 102 have the same nodes"]);
    let dart = msh(2, &["0 0 0", "1 0 0", "0.1 0.1 0", "0 1 0"], 3, &["11 12 13 14"]);
    assert_file_refused("dart.msh", &dart, &["cell 101 is inverted"]);
    let fan = msh(2, &["0 0 0", "1 0 0", "0 1 0", "0 -1 0", "1 1 0"], 2, &["11 12 13", "12 11 14", "11 12 15"]);
    assert_file_refused("fan.msh", &fan, &["the third to meet at the edge of nodes 11 and 12"]);
    let open = msh(2, &TETRAHEDRON, 2, &["11 13 12", "11 12 14", "12 13 14"]);
    assert_file_refused(
        "open.msh",
        &open,
        &["neither flat", "nor a closed surface", "cell 101 has no neighbour at the edge of nodes 11 and 13"],
    );
    let inwards = msh(2, &TETRAHEDRON, 2, &["11 12 13", "11 14 12", "12 14 13", "11 13 14"]);
    assert_file_refused("inwards.msh", &inwards, &["point inwards"]);
    let mixed = msh(2, &TETRAHEDRON, 2, &["11 13 12", "11 12 14", "12 13 14", "11 13 14"]);
    assert_file_refused("mixed.msh", &mixed, &["have opposite orientations"]);
    assert_refused(
        "refusals",
        "crates/mesh-io/tests/data/shell_text.msh --bodies physical --stiffness 1",
        &["shell_text.msh", "no physical group"],
    );
    assert_refused(
        "refusals",
        "examples/star.msh examples/plate.msh --stiffness 1",
        &["examples/star.msh is a 2D mesh", "examples/plate.msh has volume cells"],
    );
}

#[test]
fn usage_that_makes_no_sense() {
    let star = |words: &str| format!("examples/star.msh examples/block.msh {words}");
    for (words, parts) in [
        ("", ["--stiffness"].as_slice()),
        ("--stiffness -1", &["positive"]),
        ("--stiffness inf", &["positive and finite"]),
        ("--stiffness 1 --m 0.5", &["at least 1"]),
        ("--stiffness 1 --fibers 0", &["at least 1"]),
        ("--stiffness 1 --fibers 10 --spacing 0.1", &["cannot be used with"]),
        ("--stiffness 1 --law fiber --estimator fibers --spacing 1e-300", &["spacing is too small"]),
        ("--stiffness 1 --fibers 10 --estimator exact", &["--fibers has an effect with --estimator fibers only"]),
        ("--stiffness 1 --fiber-length 1", &["--pattern isotropic"]),
        ("--stiffness 1 --law volume --pattern isotropic", &["--pattern isotropic needs --estimator fibers"]),
        ("--stiffness 1 --law fiber --estimator fibers --pattern isotropic", &["isotropic fibers"]),
        ("--stiffness 1 --fibers 10", &["--fibers has an effect with --estimator fibers only"]),
        ("--stiffness 1 --law depth --m 2", &["--m has an effect with --law volume only"]),
        ("--stiffness 1 --threads 0", &["at least 1"]),
        ("--stiffness 1 --translate 3=0,1", &["no mesh 3"]),
        ("--stiffness 1 --translate 1=0", &["2 or 3 numbers"]),
        ("--stiffness 1 --translate 1=0,0,1", &["without a z"]),
        ("--stiffness 1 --rotate 1=0,0,1,30", &["the angle only"]),
        ("--stiffness 1 --obstacle wedge", &["'wedge' is not one of half-space"]),
        ("--stiffness 1 --obstacle ball", &["ball needs radius"]),
        ("--stiffness 1 --json Cargo.toml/x.json", &["Cargo.toml/x.json cannot be written"]),
    ] {
        let run = force("usage", &star(words));
        assert_eq!(run.status, Some(2), "{words}: {}", run.stderr);
        for part in parts {
            assert!(run.stderr.contains(part), "{words}: '{part}' is not in: {}", run.stderr);
        }
    }
}
