//! Abaqus input files: instances as bodies, against closed forms and against the same mesh as VTU.

use crate::command::{folder, force, json};
use fmc_contact::CellType;
use fmc_mesh_io::{VtkCell, VtuWriter};
use fmc_shapes::{cuboid_hex8, cuboid_tet4};
use serde_json::Value;
use std::fmt::Write;

/// A part of cells of one type, its labels from 5 in steps of 3.
fn part<const N: usize>(name: &str, of_type: &str, coords: &[[f64; N]], cells: &[&[u32]]) -> String {
    let mut text = format!("*Part, name={name}\n*Node\n");
    for (node, x) in coords.iter().enumerate() {
        writeln!(text, "{}, {}", 5 + 3 * node, x.map(|x| x.to_string()).join(", ")).unwrap();
    }
    writeln!(text, "*Element, type={of_type}").unwrap();
    for (cell, nodes) in (1..).zip(cells) {
        let nodes: Vec<String> = nodes.iter().map(|node| (5 + 3 * node).to_string()).collect();
        writeln!(text, "{cell}, {}", nodes.join(", ")).unwrap();
    }
    text + "*End Part\n"
}

fn force_on(found: &Value, body: usize) -> Vec<f64> {
    found["bodies"][body]["force"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// A block on its side on another, 0.02 deep over 0.5 × 0.5, and the same two blocks as arrays.
#[test]
fn instances_are_bodies() {
    let lower = cuboid_hex8([0.0; 3], [1.0; 3], [3, 2, 4]);
    let upper = cuboid_tet4([0.0; 3], [0.5, 0.25, 0.5], [3, 2, 2]);
    let cells = |mesh: &fmc_shapes::Mesh<3>| mesh.cells().map(<[u32]>::to_vec).collect::<Vec<_>>();
    let rows = [cells(&lower), cells(&upper)];
    let [of_lower, of_upper] = [0, 1].map(|k| rows[k].iter().map(Vec::as_slice).collect::<Vec<_>>());
    let mut deck = part("Lower", "C3D8R", &lower.coords, &of_lower) + &part("Upper", "C3D4", &upper.coords, &of_upper);
    // Turned about x, its y is z: from z = 0.98 to 1.23, and y from 0.2 to 0.7 as the axis is at y = 0.7.
    deck.push_str(
        "*Assembly, name=A\n*Instance, name=Lower-1, part=Lower\n*End Instance\n*Instance, name=Upper-1, part=Upper\n\
         0.3, 0.7, 0.98\n0., 0.7, 0.98, 1., 0.7, 0.98, 90.\n*End Instance\n*End Assembly\n",
    );
    let folder = folder("instances_are_bodies");
    std::fs::write(folder.join("two.inp"), deck).unwrap();
    let mut writer = VtuWriter::default();
    for (number, (mesh, rows)) in [&lower, &upper].into_iter().zip(&rows).enumerate() {
        let place = |&[x, y, z]: &[f64; 3]| if number == 0 { [x, y, z] } else { [x + 0.3, 0.7 - z, 0.98 + y] };
        let nodes: Vec<u64> = mesh.coords.iter().map(|x| writer.point(place(x))).collect();
        let of_type = VtkCell::Mesh([CellType::Hex8, CellType::Tet4][number]);
        rows.iter().for_each(|cell| writer.cell(of_type, cell.iter().map(|&n| nodes[n as usize])));
    }
    writer.write(&folder.join("two.vtu")).unwrap();
    let [of_deck, of_arrays] = ["inp", "vtu"]
        .map(|kind| json("instances_are_bodies", &format!("{{}}/two.{kind} --stiffness 1e6 --law volume")));
    assert_eq!(of_deck["bodies"][1]["name"], "two.inp, Upper-1");
    assert!((of_deck["volume"].as_f64().unwrap() / 0.005 - 1.0).abs() < 1e-12, "{of_deck}");
    assert!((force_on(&of_deck, 1)[2] / 2.5e5 - 1.0).abs() < 1e-12, "{of_deck}");
    for body in 0..2 {
        for (f, g) in force_on(&of_deck, body).iter().zip(force_on(&of_arrays, body)) {
            assert!((f - g).abs() <= 1e-12 * 2.5e5, "{of_deck} {of_arrays}");
        }
    }
}

/// Tetrahedra as hexahedra, and as surfaces in which a triangle is a quadrilateral, are tetrahedra.
#[test]
fn collapsed_cells_are_what_they_are() {
    let nodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n5,0,0,.9\n6,1,0,.9\n7,0,1,.9\n8,0,0,1.9\n";
    let decks = [
        "*ELEMENT,TYPE=C3D4\n1,1,2,3,4\n2,5,6,7,8\n",
        "*ELEMENT,TYPE=C3D8I\n1,1,2,3,3,4,4,4,4\n*ELEMENT,TYPE=C3D6\n2,5,6,7,8,8,8\n",
        "*ELEMENT,TYPE=R3D3\n1,1,3,2\n2,1,2,4\n3,2,3,4\n*ELEMENT,TYPE=S4\n4,1,4,3,1\n5,5,7,6,6\n6,5,5,6,8\n7,6,7,7,8\n8,7,5,8,8\n",
    ];
    let found = decks.map(|deck| {
        std::fs::write(folder("collapsed_cells").join("tets.inp"), format!("{nodes}{deck}")).unwrap();
        json("collapsed_cells", "{}/tets.inp --stiffness 1e6 --law volume --estimator exact")
    });
    let forces = found.each_ref().map(|found| [force_on(found, 0), force_on(found, 1)].concat());
    assert!(forces[0][2] < -1.0);
    for others in &forces[1..] {
        for (f, g) in others.iter().zip(&forces[0]) {
            assert!((f - g).abs() <= 1e-12 * forces[0][2].abs(), "{forces:?}");
        }
    }
}

/// Two squares in a row whose nodes were not merged, under a third: told with the labels of the file.
#[test]
fn nodes_that_were_not_merged_are_told() {
    let nodes = "*NODE\n11,0,0\n12,1,0\n13,1,1\n14,0,1\n21,1,0\n22,2,0\n23,2,1\n24,1,1\n31,.5,.99\n32,1.5,.99\n33,1.5,2\n34,.5,2\n";
    let cells =
        "*ELEMENT,TYPE=CPS4,ELSET=LOW\n1,11,12,13,14\n2,21,22,23,24\n*ELEMENT,TYPE=CPS4,ELSET=UP\n3,31,32,33,34\n";
    std::fs::write(folder("not_merged").join("torn.inp"), format!("{nodes}{cells}")).unwrap();
    let found = json("not_merged", "{}/torn.inp --stiffness 1e6 --bodies physical");
    let text = found["warnings"].to_string();
    assert!(text.contains("an area of 1.000e0") && text.contains("4 in all: 12, 13, 21, 24"), "{found}");
}

/// Labels are those of a part: an error says which of its instances it means.
#[test]
fn errors_name_the_instance() {
    let cell: &[u32] = &[0, 1, 2, 3];
    let coords = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, 0.3, 0.0]];
    let deck = part("Flat", "C3D4", &coords, &[cell])
        + "*Assembly\n*Instance, name=First, part=Flat\n*End Instance\n*End Assembly\n";
    std::fs::write(folder("errors_name_the_instance").join("flat.inp"), deck).unwrap();
    let run = force("errors_name_the_instance", "{}/flat.inp --stiffness 1");
    assert_eq!(run.status, Some(2));
    assert!(run.stderr.contains("flat.inp, First: cell 1 has no area or volume"), "{}", run.stderr);
}
