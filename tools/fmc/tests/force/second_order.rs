//! Bodies in cells of second order.

use crate::command::{folder, force, json};
use fmc_contact::CellType;
use fmc_mesh_io::{VtkCell, VtuWriter, in_space, read_floats};
use fmc_shapes::{
    Diagonals, Mesh, cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6, rectangle_quad4, rectangle_tri3,
    second_order,
};

fn add<const D: usize>(writer: &mut VtuWriter, mesh: &Mesh<D>, cell_type: CellType) {
    let nodes: Vec<u64> = mesh.coords.iter().map(|x| writer.point(in_space(x))).collect();
    mesh.cells().for_each(|cell| writer.cell(VtkCell::Mesh(cell_type), cell.iter().map(|&n| nodes[n as usize])));
}

/// Runs the command on two bodies in one file, and gives the volume of the overlap, the resultant on the second along the
/// last axis, and the nodal forces of `forces.vtu` along it.
fn pressed<const D: usize>(name: &str, bodies: &[Mesh<D>; 2], cell_type: CellType) -> (f64, f64, Vec<f64>) {
    let mut writer = VtuWriter::default();
    bodies.iter().for_each(|mesh| add(&mut writer, mesh, cell_type));
    let path = folder(name).join("bodies.vtu");
    writer.write(&path).unwrap();
    let found = json(name, &format!("{} --stiffness 1e6 --law volume", path.display()));
    assert_eq!(found["bodies"].as_array().unwrap().len(), 2, "{found}");
    let forces = read_floats(&folder(name).join("out/forces.vtu"), "contact_force").unwrap();
    let pressures = read_floats(&folder(name).join("out/forces.vtu"), "contact_pressure").unwrap();
    let nodes = bodies[0].coords.len() + bodies[1].coords.len();
    assert_eq!((forces.len(), pressures.len()), (3 * nodes, nodes), "{cell_type:?}");
    let along = forces.chunks_exact(3).skip(bodies[0].coords.len()).map(|force| force[D - 1]).collect();
    (found["volume"].as_f64().unwrap(), found["bodies"][1]["force"][D - 1].as_f64().unwrap(), along)
}

/// The face of a block is 0.02 deep in another, all of it: K on each node of it times the integral of its shape function.
#[test]
fn forces_in_the_picture_are_those_of_the_shape_functions() {
    let box_of = |of: fn([f64; 3], [f64; 3], [usize; 3]) -> Mesh<3>, nodes: usize, parts: usize| {
        [([0.0; 3], [1.0; 3], 2), ([0.2, 0.3, 0.98], [0.7, 0.8, 1.98], parts)]
            .map(|(low, high, parts)| second_order(&of(low, high, [parts; 3]), nodes))
    };
    let solids = [
        // Integrals over the face at its corners, at the middles of its edges, in its middle.
        ("hex20", box_of(cuboid_hex8, 20, 1), CellType::Hex20, Some([-1.0 / 12.0, 1.0 / 3.0, 0.0])),
        ("hex27", box_of(cuboid_hex8, 27, 1), CellType::Hex27, Some([1.0 / 36.0, 1.0 / 9.0, 4.0 / 9.0])),
        ("pyramid13", box_of(cuboid_pyramid5, 13, 1), CellType::Pyramid13, Some([-1.0 / 12.0, 1.0 / 3.0, 0.0])),
        ("tet10", box_of(cuboid_tet4, 10, 2), CellType::Tet10, None),
        ("wedge15", box_of(cuboid_wedge6, 15, 2), CellType::Wedge15, None),
    ];
    for (name, bodies, cell_type, shares) in solids {
        let (volume, up, forces) = pressed(&format!("second_order_{name}"), &bodies, cell_type);
        assert!((volume / 0.005 - 1.0).abs() < 1e-9 && (up / 2.5e5 - 1.0).abs() < 1e-9, "{name}: {volume} {up}");
        assert!((forces.iter().sum::<f64>() / up - 1.0).abs() < 1e-12);
        for (x, force) in bodies[1].coords.iter().zip(&forces) {
            let Some(shares) = shares.filter(|_| x[2] < 0.99) else { continue };
            let middles = usize::from((x[0] - 0.45).abs() < 1e-9) + usize::from((x[1] - 0.55).abs() < 1e-9);
            assert!((force / 2.5e5 - shares[middles]).abs() < 1e-9, "{name} at {x:?}: {force}");
        }
    }
    let rectangles = |straight: [Mesh<2>; 2], nodes: usize| straight.map(|mesh| second_order(&mesh, nodes));
    let quads =
        || [([0.0; 2], [1.0; 2], [2; 2]), ([0.2, 0.98], [0.7, 1.98], [1; 2])].map(|(a, b, n)| rectangle_quad4(a, b, n));
    let triangles = [([0.0; 2], [1.0; 2], [2; 2]), ([0.2, 0.98], [0.7, 1.98], [1; 2])]
        .map(|(a, b, n)| rectangle_tri3(a, b, n, Diagonals::Same));
    let flat = [
        ("quad8", rectangles(quads(), 8), CellType::Quad8),
        ("quad9", rectangles(quads(), 9), CellType::Quad9),
        ("tri6", rectangles(triangles, 6), CellType::Tri6),
    ];
    for (name, bodies, cell_type) in flat {
        let (area, up, forces) = pressed(&format!("second_order_{name}"), &bodies, cell_type);
        assert!((area / 0.01 - 1.0).abs() < 1e-9 && (up / 5e5 - 1.0).abs() < 1e-9, "{name}: {area} {up}");
        for (x, force) in bodies[1].coords.iter().zip(&forces).filter(|(x, _)| x[1] < 0.99) {
            let share = if (x[0] - 0.45).abs() < 1e-9 { 2.0 / 3.0 } else { 1.0 / 6.0 };
            assert!((force / 5e5 - share).abs() < 1e-9, "{name} at {x:?}: {force}");
        }
    }
}

#[test]
fn what_does_not_fit_is_refused_in_the_numbers_of_the_file() {
    let refused = |name: &str, build: &dyn Fn(&mut VtuWriter)| {
        let mut writer = VtuWriter::default();
        build(&mut writer);
        let path = folder(name).join("refused.vtu");
        writer.write(&path).unwrap();
        let run = force(name, &format!("{} --stiffness 1", path.display()));
        assert_ne!(run.status, Some(0));
        run.stderr
    };
    let square = second_order(&rectangle_quad4([0.0; 2], [1.0; 2], [1, 1]), 8);
    let beside = refused("second_order_beside", &|writer| {
        add(writer, &square, CellType::Quad8);
        let [p, q] = [[2.0, 0.0, 0.0], [2.0, 1.0, 0.0]].map(|x| writer.point(x));
        let right = |y: f64| square.coords.iter().position(|x| *x == [1.0, y]).unwrap() as u64;
        writer.cell(VtkCell::Mesh(CellType::Quad4), [right(0.0), p, q, right(1.0)]);
    });
    assert!(beside.contains("cell 0 and cell 1 do not conform"), "{beside}");
    let open = refused("second_order_in_space", &|writer| {
        let points: Vec<u64> = square.coords.iter().map(|[x, y]| writer.point([*x, *y, x * y])).collect();
        writer.cell(VtkCell::Mesh(CellType::Quad8), points);
    });
    assert!(open.contains("cell 0 has no neighbour at the edge of nodes"), "{open}");
    let mixed = refused("second_order_surface_mixed", &|writer| {
        let block = second_order(&cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]), 20);
        let points: Vec<u64> = block.coords.iter().map(|x| writer.point(*x)).collect();
        for (number, facet) in block.boundary_faces().into_iter().enumerate() {
            let (cell_type, nodes) =
                if number == 5 { (CellType::Quad4, &facet[..4]) } else { (CellType::Quad8, &facet[..]) };
            writer.cell(VtkCell::Mesh(cell_type), nodes.iter().map(|&node| points[node as usize]));
        }
    });
    assert!(mixed.contains("do not conform") && mixed.contains("cell 5"), "{mixed}");
}

/// Bodies given by their skins, in a VTU file, have the volume, forces and pressures that their cells have.
#[test]
fn surfaces_of_second_order() {
    for (name, nodes, facet) in [("quad8", 20, CellType::Quad8), ("quad9", 27, CellType::Quad9)] {
        let bodies = [([0.0; 3], [1.0; 3], 2), ([0.2, 0.3, 0.98], [0.7, 0.8, 1.98], 1)]
            .map(|(low, high, parts)| second_order(&cuboid_hex8(low, high, [parts; 3]), nodes));
        let mut writer = VtuWriter::default();
        let mut count = 0;
        for mesh in &bodies {
            let points: Vec<u64> = mesh.coords.iter().map(|x| writer.point(*x)).collect();
            for face in mesh.boundary_faces() {
                writer.cell(VtkCell::Mesh(facet), face.iter().map(|&node| points[node as usize]));
                count += 1;
            }
        }
        assert_eq!(count, 24 + 6);
        let folder_name = format!("second_order_surface_{name}");
        let path = folder(&folder_name).join("bodies.vtu");
        writer.write(&path).unwrap();
        let found = json(&folder_name, &format!("{} --stiffness 1e6 --law volume", path.display()));
        let cells = pressed(
            &format!("{folder_name}_cells"),
            &bodies,
            if nodes == 20 { CellType::Hex20 } else { CellType::Hex27 },
        );
        let up = found["bodies"][1]["force"][2].as_f64().unwrap();
        assert!(
            (found["volume"].as_f64().unwrap() / cells.0 - 1.0).abs() < 1e-12 && (up / cells.1 - 1.0).abs() < 1e-12
        );
        let forces = read_floats(&folder(&folder_name).join("out/forces.vtu"), "contact_force").unwrap();
        let along = forces.chunks_exact(3).skip(bodies[0].coords.len()).map(|force| force[2]);
        for (one, other) in along.zip(&cells.2) {
            assert!((one - other).abs() < 1e-12 * cells.1, "{name}: {one} {other}");
        }
        let points = (0..bodies.len()).map(|body| found["bodies"][body]["nodes"].as_u64().unwrap()).sum::<u64>();
        assert!(points > 0, "{found}");
    }
}
