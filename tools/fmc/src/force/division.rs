//! Which cells make a body.

use super::assembly::Assembly;
use super::components::components;
use super::explain::explain;
use anyhow::{Result, bail};
use clap::ValueEnum;
use fmc_contact::Surface;
use fmc_mesh_io::{Kind, Mesh};
use std::collections::BTreeMap;

/// Definition of a body.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DivideBy {
    /// Each file is a body
    #[value(alias = "files")]
    File,
    /// Each connected part is a body
    #[value(alias = "components")]
    Component,
    /// Each physical group of each file is a body; of an Abaqus file without parts each element set
    Physical,
    /// Each instance of a part is a body (Abaqus), and each file without parts
    Instance,
}

impl DivideBy {
    /// Default definition of a body: parts of the files, else each file, or each connected component of a single one.
    pub(super) fn default_of(meshes: &[Mesh]) -> Self {
        match meshes {
            _ if meshes.iter().any(|mesh| !mesh.instances.is_empty()) => Self::Instance,
            [_] => Self::Component,
            _ => Self::File,
        }
    }
}

/// The bodies, in the order of the files.
pub(super) struct Division {
    /// Body of every cell.
    pub(super) cell_bodies: Vec<i64>,
    /// Name of every body.
    pub(super) names: Vec<String>,
}

impl Division {
    /// Divides the cells and finds the surface of the bodies.
    pub(super) fn new<const D: usize>(assembly: &Assembly<D>, by: DivideBy) -> Result<(Surface<D>, Self)> {
        let mut division = match by {
            DivideBy::File => by_file(assembly),
            DivideBy::Physical => by_group(assembly)?,
            DivideBy::Instance => by_instance(assembly),
            // Which cavity lies in which body is for the module to find out.
            DivideBy::Component if assembly.kind == Kind::Surface => {
                let surface = assembly.surface(None).map_err(|error| explain(&error, assembly, &[]))?;
                let division = by_surface(assembly, &surface);
                return Ok((surface, division));
            }
            DivideBy::Component => Self { cell_bodies: components(assembly.cells()), names: Vec::new() },
        };
        if by == DivideBy::Component {
            division.name_parts(assembly);
        }
        let surface = assembly.surface(Some(&division.cell_bodies));
        Ok((surface.map_err(|error| explain(&error, assembly, &division.names))?, division))
    }

    /// Names bodies by their file, and by their place in it if it has several.
    fn name_parts<const D: usize>(&mut self, assembly: &Assembly<D>) {
        let count = self.cell_bodies.iter().max().map_or(0, |&last| last as usize + 1);
        let mut files = vec![0; count];
        let cells = assembly.meshes.iter().enumerate().flat_map(|(mesh, m)| std::iter::repeat_n(mesh, m.cell_count()));
        for (mesh, &body) in cells.zip(&self.cell_bodies) {
            files[body as usize] = mesh;
        }
        self.names = (0..count)
            .map(|body| {
                let siblings: Vec<usize> = (0..count).filter(|&other| files[other] == files[body]).collect();
                let place = siblings.partition_point(|&other| other < body) + 1;
                let file = mesh_name(assembly, files[body]);
                if siblings.len() == 1 { file } else { format!("{file}, part {place}") }
            })
            .collect();
    }
}

fn by_file<const D: usize>(assembly: &Assembly<D>) -> Division {
    let meshes = assembly.meshes.iter().enumerate();
    Division {
        cell_bodies: meshes.flat_map(|(mesh, m)| std::iter::repeat_n(mesh as i64, m.cell_count())).collect(),
        names: (0..assembly.meshes.len()).map(|mesh| mesh_name(assembly, mesh)).collect(),
    }
}

fn by_group<const D: usize>(assembly: &Assembly<D>) -> Result<Division> {
    let mut keys = Vec::new();
    for (mesh, contents) in assembly.meshes.iter().enumerate() {
        for (_, _, tag, group) in contents.cells() {
            match group {
                Some(group) => keys.push((mesh, Some(group))),
                None => bail!("{}: cell {tag} belongs to no physical group", contents.file),
            }
        }
    }
    Ok(by_keys(assembly, &keys, "group "))
}

fn by_instance<const D: usize>(assembly: &Assembly<D>) -> Division {
    let meshes = assembly.meshes.iter().enumerate();
    let keys: Vec<Key> = meshes
        .flat_map(|(mesh, m)| m.cells().map(move |cell| (mesh, cell.3.filter(|_| !m.instances.is_empty()))))
        .collect();
    by_keys(assembly, &keys, "")
}

/// A file, and the group of it that is a body, where not all of it is.
type Key = (usize, Option<i64>);

/// Bodies by the keys of their cells; `kind` stands before the names of groups.
fn by_keys<const D: usize>(assembly: &Assembly<D>, keys: &[Key], kind: &str) -> Division {
    let mut bodies: BTreeMap<Key, i64> = keys.iter().map(|&key| (key, 0)).collect();
    let mut names = Vec::new();
    for (body, (&(mesh, group), number)) in bodies.iter_mut().enumerate() {
        *number = body as i64;
        let file = mesh_name(assembly, mesh);
        names.push(match group.map(|group| (group, assembly.meshes[mesh].group_names.get(&group))) {
            Some((_, Some(name))) => format!("{file}, {kind}{name}"),
            Some((group, None)) => format!("{file}, {kind}{group}"),
            None => file,
        });
    }
    Division { cell_bodies: keys.iter().map(|key| bodies[key]).collect(), names }
}

/// Reads off a surface which body the facets of every cell belong to.
fn by_surface<const D: usize>(assembly: &Assembly<D>, surface: &Surface<D>) -> Division {
    let mut node_bodies = vec![0; assembly.coords.len()];
    for (body, nodes) in surface.faces() {
        for node in nodes {
            node_bodies[node as usize] = body as i64;
        }
    }
    let cell_bodies = assembly.cells().map(|(_, nodes)| node_bodies[nodes[0] as usize]).collect();
    let mut division = Division { cell_bodies, names: Vec::new() };
    division.name_parts(assembly);
    division
}

/// Name of a mesh in the report: its file name, with its place if another mesh has the same.
fn mesh_name<const D: usize>(assembly: &Assembly<D>, mesh: usize) -> String {
    let name = |mesh: usize| {
        let path = std::path::Path::new(&assembly.meshes[mesh].file);
        path.file_name().map_or_else(|| assembly.meshes[mesh].file.clone(), |name| name.to_string_lossy().into_owned())
    };
    let same = (0..assembly.meshes.len()).filter(|&other| name(other) == name(mesh)).count();
    if same == 1 { name(mesh) } else { format!("{} (mesh {})", name(mesh), mesh + 1) }
}
