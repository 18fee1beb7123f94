//! From a case to the bodies, supports and loads of a model.

use super::body::{Body, CellKind, MaterialLaw, MeshSource};
use super::{Case, Obstacle, Place};
use anyhow::{Context, Result, anyhow, bail, ensure};
use fmc_contact::CellType;
use fmc_mesh_io as mesh;
use fmc_shapes::{
    Diagonals, Mesh, ball_tet4, cuboid_hex8, cuboid_tet4, disc_quad4, disc_tri3, graded_block_hex8, graded_block_quad4,
    graded_block_tet4, graded_block_tri3, graded_half_disc_tri3, graded_quarter_half_ball_tet4, quadrilateral_quad4,
    quadrilaterals_quad4, rectangle_quad4, rectangle_tri3, second_order, star_quad4, star_tri3, tetrahedron_tet4,
};
use fmc_solid::dynamics::{Setup, Step};
use fmc_solid::fem::{self, Constraints, Face, Model, Part};
use fmc_solid::statics::{Linearised, Problem};
use std::collections::BTreeMap;
use std::path::Path;

impl Case {
    /// The bodies as meshes with their materials; `folder` is where mesh files are looked for.
    ///
    /// # Errors
    /// If a mesh file cannot be read, or does not fit.
    pub fn parts<const D: usize>(&self, folder: &Path) -> Result<Vec<Part<D>>> {
        self.bodies.iter().map(|body| body.part(folder)).collect()
    }

    /// The case as the start of a simulation, on `threads` threads, with the step of the case or the stable one.
    ///
    /// # Errors
    /// Those of [`Self::parts`], of the model, and supports or loads that meet no node or face.
    pub fn setup<const D: usize>(&self, folder: &Path, threads: usize) -> Result<Setup<D>> {
        let model = Model::new(self.parts(folder)?)?.with_threads(threads)?;
        let supports = self.constraints(&model, 0)?;
        let load = self.load(&model)?;
        let mut velocity = vec![[0.0; D]; model.node_count()];
        for (part, body) in self.bodies.iter().enumerate() {
            velocity[model.nodes_of(part)].fill(vector(body.initial_velocity.as_ref())?);
        }
        Ok(Setup {
            obstacles: self.partners()?,
            supports,
            load,
            velocity,
            step: self.time.step.map_or(Step::Auto, Step::Fixed),
            damping: self.time.damping.unwrap_or(0.0),
            contact_substeps: self.time.contact_substeps,
            new_fibers_every_step: self.contact.new_fibers_every_step,
            ..Setup::new(model, self.contact.options(threads))
        })
    }

    /// The case as a problem of statics, on `threads` threads.
    ///
    /// # Errors
    /// Those of [`Self::parts`], of the model, and supports or loads that meet no node or face.
    pub fn problem<const D: usize>(&self, folder: &Path, threads: usize) -> Result<Problem<D>> {
        let model = Model::new(self.parts(folder)?)?.with_threads(threads)?;
        let (supports, load) = (self.constraints(&model, 0)?, self.load(&model)?);
        let obstacles = self.partners()?;
        let linearised = match self.contact.linearised {
            true => Some(
                Linearised::new(&model, &obstacles)
                    .context("linearised contact needs polygons in 2D, and cells of first order")?,
            ),
            false => None,
        };
        Ok(Problem { supports, load, obstacles, linearised, ..Problem::new(model, self.contact.options(threads)) })
    }

    fn partners<const D: usize>(&self) -> Result<Vec<fmc_contact::Obstacle<D>>> {
        let build = |o: &Obstacle| o.build().with_context(|| format!("obstacle '{}' lacks a measure", o.name));
        self.obstacles.iter().map(build).collect()
    }

    /// Prescribed displacements at the end of a stage of the load steps, from 0.
    ///
    /// # Errors
    /// If a support meets no node.
    pub fn constraints<const D: usize>(&self, model: &Model<D>, stage: usize) -> Result<Constraints<D>> {
        let mut constraints = Constraints::default();
        for support in &self.supports {
            let part = self.body(&support.body).context("a support names no body")?;
            let inside = membership(model, part, &support.place)?;
            let nodes = model.nodes_where(part, inside);
            ensure!(!nodes.is_empty(), "a support of '{}' meets none of its nodes", support.body);
            for (index, axis) in support.components.iter().enumerate() {
                let later = stage.checked_sub(1).and_then(|stage| support.then.get(stage));
                let value = later.or(support.values.as_ref()).map_or(0.0, |values| values[index]);
                constraints.prescribe(nodes.iter().copied(), axis.index(), value);
            }
        }
        Ok(constraints)
    }

    /// Nodal forces of all loads; empty for none.
    fn load<const D: usize>(&self, model: &Model<D>) -> Result<Vec<[f64; D]>> {
        let mut sum = if self.loads.is_empty() { Vec::new() } else { vec![[0.0; D]; model.node_count()] };
        for load in &self.loads {
            let part = self.body(&load.body).context("a load names no body")?;
            let faces = |place: &Place| -> Result<Vec<Face>> {
                let faces = model.faces_where(part, membership(model, part, place)?);
                ensure!(!faces.is_empty(), "a load of '{}' meets none of its faces", load.body);
                Ok(faces)
            };
            let place = || load.place.as_ref().context("a load has no place");
            let forces = match load.pressure {
                Some(pressure) => model.surface_load(&faces(place()?)?, |_, normal| normal.map(|n| -pressure * n)),
                None if load.traction.is_some() => {
                    let traction = vector(load.traction.as_ref())?;
                    model.surface_load(&faces(place()?)?, |_, _| traction)
                }
                None => model.body_load(part, vector(load.body_force.as_ref())?),
            };
            for (sum, force) in sum.iter_mut().zip(forces) {
                (0..D).for_each(|axis| sum[axis] += force[axis]);
            }
        }
        Ok(sum)
    }
}

impl Body {
    fn part<const D: usize>(&self, folder: &Path) -> Result<Part<D>> {
        let (cell_type, mesh) =
            self.mesh.generate::<D>(folder).with_context(|| format!("the mesh of body '{}'", self.name))?;
        let mesh = if self.skew == 0.0 { mesh } else { mesh.skewed(self.skew) };
        let (cell_type, mesh) = self.mesh.raised(cell_type, mesh);
        let (sine, cosine) = self.rotation.to_radians().sin_cos();
        let offset: [f64; D] = vector(self.position.as_ref())?;
        let place = |x: [f64; D]| -> [f64; D] {
            let mut y = x;
            if self.rotation != 0.0 {
                y[0] = cosine * x[0] - sine * x[1];
                y[1] = sine * x[0] + cosine * x[1];
            }
            std::array::from_fn(|axis| y[axis] + offset[axis])
        };
        let material = fem::Material {
            law: match self.material.law {
                MaterialLaw::LinearElastic => fem::Law::LinearElastic,
                MaterialLaw::NeoHookean => fem::Law::NeoHookean,
            },
            young: self.material.young,
            poisson: self.material.poisson,
            density: self.material.density,
        };
        Ok(Part { name: self.name.clone(), cell_type, mesh: mesh.mapped(place), material })
    }
}

impl MeshSource {
    /// Type of the cells and the mesh, of first order but for files.
    fn generate<const D: usize>(&self, folder: &Path) -> Result<(CellType, Mesh<D>)> {
        use CellKind::{Hex8, Quad4, Tet4, Tri3};
        let mesh = match &self.of_first_order() {
            &MeshSource::Rectangle { cell: Quad4, min, max, cells } => Made::Flat(rectangle_quad4(min, max, cells)),
            &MeshSource::Rectangle { cell: Tri3, min, max, cells } => {
                Made::Flat(rectangle_tri3(min, max, cells, Diagonals::Alternating))
            }
            &MeshSource::Quadrilateral { cell: Quad4, corners, cells } => {
                Made::Flat(quadrilateral_quad4(corners, cells))
            }
            MeshSource::Quadrilaterals { cell: Quad4, parts } => {
                let parts: Vec<_> = parts.iter().map(|part| (part.corners, part.cells)).collect();
                Made::Flat(quadrilaterals_quad4(&parts))
            }
            &MeshSource::Star { cell: Quad4, tips, outer, inner, side_edges, half_width } => {
                Made::Flat(star_quad4(tips, outer, inner, side_edges, half_width))
            }
            &MeshSource::Star { cell: Tri3, tips, outer, inner, side_edges, half_width } => {
                Made::Flat(star_tri3(tips, outer, inner, side_edges, half_width))
            }
            &MeshSource::Disc { cell: Quad4, radius, edges } => Made::Flat(disc_quad4(radius, edges)),
            &MeshSource::Disc { cell: Tri3, radius, edges } => Made::Flat(disc_tri3(radius, edges)),
            &MeshSource::GradedHalfDisc { cell: Tri3, radius, finest, fine_to, growth } => {
                Made::Flat(graded_half_disc_tri3(radius, finest, fine_to, growth))
            }
            &MeshSource::GradedHalfDisc { cell: Quad4, radius, finest, fine_to, growth } => {
                let triangles = graded_half_disc_tri3(radius, 2.0 * finest, fine_to, growth);
                Made::Flat(second_order(&triangles, 6).rounded([0.0, radius], radius).quadrangulated())
            }
            &MeshSource::Cuboid { cell: Hex8, min, max, cells } => Made::Solid(cuboid_hex8(min, max, cells)),
            &MeshSource::Cuboid { cell: Tet4, min, max, cells } => Made::Solid(cuboid_tet4(min, max, cells)),
            &MeshSource::Tetrahedron { cell: Tet4, corners, edges } => Made::Solid(tetrahedron_tet4(corners, edges)),
            &MeshSource::Ball { cell: Tet4, radius, level, layers } => Made::Solid(ball_tet4(radius, level, layers)),
            &MeshSource::GradedHalfBall { cell: Tet4, radius, finest, edges } => {
                Made::Solid(graded_quarter_half_ball_tet4(radius, finest, edges))
            }
            &MeshSource::GradedBlock { cell, ref size, fine, cells, shells } => match (cell, &size[..]) {
                (Tri3, &[x, y]) => Made::Flat(graded_block_tri3([x, y], fine, cells, shells)),
                (Quad4, &[x, y]) => Made::Flat(graded_block_quad4([x, y], fine, cells, shells)),
                (Tet4, &[x, y, z]) => Made::Solid(graded_block_tet4([x, y, z], fine, cells, shells)),
                (Hex8, &[x, y, z]) => Made::Solid(graded_block_hex8([x, y, z], fine, cells, shells)),
                _ => bail!("this shape cannot be made of such cells"),
            },
            MeshSource::File { path, group } => return read(&folder.join(path), group.as_deref()),
            _ => bail!("this shape cannot be made of such cells"),
        };
        // One of the two has as many dimensions as are asked for, and is that type: a change of name only.
        let (coords, conn, nodes_per_cell) = match mesh {
            Made::Flat(mesh) => (same_dimension(&mesh.coords)?, mesh.conn, mesh.nodes_per_cell),
            Made::Solid(mesh) => (same_dimension(&mesh.coords)?, mesh.conn, mesh.nodes_per_cell),
        };
        let cell_type = match (D, nodes_per_cell) {
            (2, 3) => CellType::Tri3,
            (2, 4) => CellType::Quad4,
            (3, 4) => CellType::Tet4,
            _ => CellType::Hex8,
        };
        Ok((cell_type, Mesh { coords, conn, nodes_per_cell }))
    }
}

impl MeshSource {
    /// The same with cells of first order.
    fn of_first_order(&self) -> Self {
        let mut of_first_order = self.clone();
        if let Some(cell) = of_first_order.cell_mut() {
            *cell = cell.straight();
        }
        of_first_order
    }

    /// A generated mesh with the nodes in the middle of its cells' edges that its kind of cells has.
    fn raised<const D: usize>(&self, cell_type: CellType, mesh: Mesh<D>) -> (CellType, Mesh<D>) {
        let Some(cell) = self.cell().filter(|cell| *cell != cell.straight()) else { return (cell_type, mesh) };
        let raised = second_order(&mesh, cell.cell_type().node_count());
        let on_axis = |height: f64| std::array::from_fn(|axis| if axis + 1 == D { height } else { 0.0 });
        let mesh = match *self {
            MeshSource::Disc { radius, .. } | MeshSource::Ball { radius, .. } => raised.rounded([0.0; D], radius),
            MeshSource::GradedHalfDisc { radius, .. } | MeshSource::GradedHalfBall { radius, .. } => {
                raised.rounded(on_axis(radius), radius)
            }
            _ => raised,
        };
        (cell.cell_type(), mesh)
    }
}

/// A mesh of the one dimension or the other.
enum Made {
    Flat(Mesh<2>),
    Solid(Mesh<3>),
}

fn same_dimension<const E: usize, const D: usize>(coords: &[[f64; E]]) -> Result<Vec<[f64; D]>> {
    ensure!(E == D, "it is a {E}D mesh in a {D}D case");
    Ok(coords.iter().map(|x| std::array::from_fn(|axis| x[axis])).collect())
}

/// The cells of a file, or of one of its physical groups; all must be of one type.
fn read<const D: usize>(path: &Path, group: Option<&str>) -> Result<(CellType, Mesh<D>)> {
    let file = mesh::Mesh::read(path)?;
    let flat = file.kind() == mesh::Kind::Flat;
    ensure!(file.kind() == mesh::Kind::Solid || flat, "{} is a surface, not a body", file.file);
    ensure!(flat == (D == 2), "{} is a {}D mesh in a {D}D case", file.file, if flat { 2 } else { 3 });
    let number = match group {
        None => None,
        Some(name) => {
            let by_name = file.group_names.iter().find(|(_, known)| known.as_str() == name).map(|(number, _)| *number);
            let known = || file.group_names.values().cloned().collect::<Vec<_>>().join(", ");
            let number = by_name.or(name.parse().ok());
            Some(number.with_context(|| format!("{} has no group '{name}'; it has {}", file.file, known()))?)
        }
    };
    let mut node_of = BTreeMap::new();
    let mut found: Option<CellType> = None;
    let (mut coords, mut conn) = (Vec::new(), Vec::new());
    for (cell_type, nodes, ..) in file.cells().filter(|cell| number.is_none() || cell.3 == number) {
        ensure!(
            found.is_none_or(|first| first == cell_type),
            "{}: cells of several types ({:?}, {cell_type:?}) in one body; give each a group and a body",
            file.file,
            found.unwrap_or(cell_type)
        );
        found = Some(cell_type);
        for &node in nodes {
            conn.push(*node_of.entry(node).or_insert_with(|| {
                coords.push(std::array::from_fn(|axis| file.points[node as usize][axis]));
                coords.len() as u32 - 1
            }));
        }
    }
    let cell_type =
        found.ok_or_else(|| anyhow!("{}: group '{}' has no cells", file.file, group.unwrap_or_default()))?;
    Ok((cell_type, Mesh { coords, conn, nodes_per_cell: cell_type.node_count() }.oriented()))
}

/// Whether a node of a part belongs to a place.
fn membership<'a, const D: usize>(
    model: &Model<D>,
    part: usize,
    place: &'a Place,
) -> Result<impl Fn(&[f64; D]) -> bool + 'a> {
    let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
    for x in &model.coords()[model.nodes_of(part)] {
        for axis in 0..D {
            low[axis] = low[axis].min(x[axis]);
            high[axis] = high[axis].max(x[axis]);
        }
    }
    ensure!(place.holds(&low, &low, &high).is_some(), "a place is no side, no plane and no box");
    Ok(move |x: &[f64; D]| place.holds(x, &low, &high) == Some(true))
}

/// A list as a vector; zero if absent.
fn vector<const D: usize>(list: Option<&Vec<f64>>) -> Result<[f64; D]> {
    let Some(list) = list else { return Ok([0.0; D]) };
    list[..].try_into().map_err(|_| anyhow!("{} numbers for a vector in {D}D", list.len()))
}
