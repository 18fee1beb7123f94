//! Scenes: several meshes as one node array with bodies, as a host would hand them over.
//!
//! Shared by the test binaries, none of which needs all of it.
#![allow(dead_code)]

pub(crate) mod energy_gradient;
pub(crate) mod table;

use fmc_contact::{
    Bodies, CellBlock, CellType, Contact, ContactForces, EnergyLaw, Estimator, FiberOptions, FiberPattern, LineWeights,
    Options, Resolution, Surface,
};
use fmc_shapes::Mesh;

/// Meshes of cells, or of facets, in one node array. Bodies carry the ids given.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scene<const D: usize> {
    pub(crate) coords: Vec<[f64; D]>,
    pub(crate) blocks: Vec<(CellType, Vec<u32>)>,
    pub(crate) facets: Vec<[u32; D]>,
    /// One per cell, or one per facet.
    pub(crate) ids: Vec<i64>,
    /// First node of every mesh added.
    pub(crate) first_node: Vec<usize>,
}

impl<const D: usize> Scene<D> {
    pub(crate) fn new() -> Self {
        Self { coords: Vec::new(), blocks: Vec::new(), facets: Vec::new(), ids: Vec::new(), first_node: Vec::new() }
    }

    /// Bodies 0, 1, … in this order.
    pub(crate) fn of(meshes: &[&Mesh<D>]) -> Self {
        meshes.iter().enumerate().fold(Self::new(), |scene, (id, mesh)| scene.with(mesh, id as i64))
    }

    /// Adds a mesh as (part of) body `id`.
    pub(crate) fn with(mut self, mesh: &Mesh<D>, id: i64) -> Self {
        let first = self.coords.len() as u32;
        self.first_node.push(first as usize);
        self.coords.extend_from_slice(&mesh.coords);
        self.ids.extend(std::iter::repeat_n(id, mesh.cell_count()));
        let conn = mesh.conn.iter().map(|node| node + first);
        match cell_type(D, mesh.nodes_per_cell) {
            Some(cell_type) => self.blocks.push((cell_type, conn.collect())),
            None => self.facets.extend(mesh.facets().iter().map(|f| f.map(|node| node + first))),
        }
        assert!(self.blocks.is_empty() || self.facets.is_empty(), "a scene is of cells or of facets");
        self
    }

    /// Adds meshes of several types on the same nodes as (part of) body `id`.
    pub(crate) fn with_mixed(mut self, meshes: &[Mesh<D>], id: i64) -> Self {
        let Some(mesh) = meshes.first() else { return self };
        let first = self.coords.len() as u32;
        self.first_node.push(first as usize);
        self.coords.extend_from_slice(&mesh.coords);
        for mesh in meshes {
            let cell_type = cell_type(D, mesh.nodes_per_cell).expect("cells");
            self.ids.extend(std::iter::repeat_n(id, mesh.cell_count()));
            self.blocks.push((cell_type, mesh.conn.iter().map(|node| node + first).collect()));
        }
        self
    }

    /// Nodes of the mesh added as number `mesh`.
    pub(crate) fn nodes_of(&self, mesh: usize) -> std::ops::Range<usize> {
        self.first_node[mesh]..self.first_node.get(mesh + 1).copied().unwrap_or(self.coords.len())
    }

    pub(crate) fn surface(&self) -> Surface<D> {
        let surface = if self.facets.is_empty() {
            let blocks: Vec<CellBlock> =
                self.blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
            Surface::from_cells(&self.coords, &blocks, Bodies::Ids(&self.ids))
        } else {
            Surface::from_facets(&self.coords, &self.facets, Bodies::Ids(&self.ids))
        };
        surface.expect("a scene is a valid mesh")
    }

    pub(crate) fn contact(&self, options: Options) -> Contact<D> {
        Contact::new(self.surface(), options).expect("options of a test are valid")
    }

    pub(crate) fn evaluate(&self, options: Options) -> ContactForces<D> {
        self.contact(options).evaluate(&self.coords).expect("a valid scene has an answer")
    }

    /// Every node moved to `f(x)`.
    pub(crate) fn mapped(mut self, f: impl Fn([f64; D]) -> [f64; D]) -> Self {
        self.coords.iter_mut().for_each(|x| *x = f(*x));
        self
    }
}

fn cell_type(dimension: usize, nodes_per_cell: usize) -> Option<CellType> {
    match (dimension, nodes_per_cell) {
        (2, 3) => Some(CellType::Tri3),
        (2, 4) => Some(CellType::Quad4),
        (3, 4) => Some(CellType::Tet4),
        (3, 6) => Some(CellType::Wedge6),
        (3, 5) => Some(CellType::Pyramid5),
        (3, 8) => Some(CellType::Hex8),
        (2, 6) => Some(CellType::Tri6),
        (2, 8) => Some(CellType::Quad8),
        (2, 9) => Some(CellType::Quad9),
        (3, 10) => Some(CellType::Tet10),
        (3, 13) => Some(CellType::Pyramid13),
        (3, 15) => Some(CellType::Wedge15),
        (3, 20) => Some(CellType::Hex20),
        (3, 27) => Some(CellType::Hex27),
        _ => None,
    }
}

/// k = 1, m = 1: forces are −∂V/∂x, energy is V.
pub(crate) fn exact() -> Options {
    Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::volume(1.0)) }
}

/// The same by fibers.
pub(crate) fn fibers(options: FiberOptions) -> Options {
    Options { estimator: Estimator::Fibers(options), ..Options::new(EnergyLaw::volume(1.0)) }
}

/// A law on lines with the default options.
pub(crate) fn by_lines(law: EnergyLaw) -> Options {
    Options { law, ..fibers(FiberOptions::default()) }
}

/// The default lines, this far apart.
pub(crate) fn lines(spacing: f64, seed: u64) -> Options {
    fibers(FiberOptions { resolution: Resolution::Spacing(spacing), seed, ..FiberOptions::default() })
}

/// Lines whose force is the exact gradient of their energy.
pub(crate) fn consistent_lines(spacing: f64, seed: u64) -> Options {
    fibers(FiberOptions {
        weights: LineWeights::Consistent,
        resolution: Resolution::Spacing(spacing),
        seed,
        momentum_correction: false,
        ..FiberOptions::default()
    })
}

/// `count` isotropic segments.
pub(crate) fn isotropic(length: f64, count: usize, seed: u64) -> Options {
    fibers(FiberOptions {
        pattern: FiberPattern::Isotropic { length: Some(length) },
        resolution: Resolution::Count(count),
        seed,
        ..FiberOptions::default()
    })
}

/// Root of the sum of squares of all components.
pub(crate) fn norm<const D: usize>(x: &[[f64; D]]) -> f64 {
    x.iter().flatten().map(|x| x * x).sum::<f64>().sqrt()
}

/// Norm of the difference.
pub(crate) fn distance<const D: usize>(x: &[[f64; D]], y: &[[f64; D]]) -> f64 {
    assert_eq!(x.len(), y.len());
    x.iter().flatten().zip(y.iter().flatten()).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt()
}

/// Sum of the lengths of the vectors.
pub(crate) fn size_sum<const D: usize>(x: &[[f64; D]]) -> f64 {
    x.iter().map(|x| x.iter().map(|x| x * x).sum::<f64>().sqrt()).sum()
}

/// x × f as a vector of three; in 2D only the last entry differs from zero.
pub(crate) fn cross<const D: usize>(x: &[f64; D], f: &[f64; D]) -> [f64; 3] {
    let at = |v: &[f64; D], i: usize| if i < D { v[i] } else { 0.0 };
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        at(x, j) * at(f, k) - at(x, k) * at(f, j)
    })
}
