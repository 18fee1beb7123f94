//! Rigid partners.

use fmc_contact::{HeightField, Measures, Pose, Shape, ShapeKind, SignedDistance};
use fmc_shapes::rotation_onto;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// `[[obstacles]]`: a rigid shape and its place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Obstacle {
    /// Name, unique among bodies and obstacles.
    pub name: String,
    /// Its shape, which needs some of the measures below.
    pub shape: ShapeName,
    /// Origin of its frame, `[D]`, m; the global origin if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub position: Option<Vec<f64>>,
    /// Direction of its axis (of the outward normal of a half-space), `[D]`; the last coordinate axis if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axis: Option<Vec<f64>>,
    /// Radius, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub radius: Option<f64>,
    /// Half of the height, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub half_height: Option<f64>,
    /// Half of each side, `[D]`, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub half_extents: Option<Vec<f64>>,
    /// Corners of a polygon, counter-clockwise, `[corner_count, 2]`, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<Vec<[f64; 2]>>,
}

/// Name of a shape of fmc-contact, or `polygon`: a polytope in 2D, from its corners alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct ShapeName(pub ShapeKind);

impl TryFrom<String> for ShapeName {
    type Error = String;

    fn try_from(name: String) -> Result<Self, String> {
        let kind = match name.as_str() {
            "polygon" => Some(ShapeKind::POLYTOPE),
            name => ShapeKind::named(name).filter(|kind| *kind != ShapeKind::POLYTOPE),
        };
        kind.map(Self).ok_or_else(|| format!("there is no shape '{name}'"))
    }
}

impl From<ShapeName> for String {
    fn from(name: ShapeName) -> String {
        if name.0 == ShapeKind::POLYTOPE { "polygon".into() } else { name.0.name() }
    }
}

/// The measures of an obstacle, as its shape asks for them.
pub(super) struct Measured<'a> {
    obstacle: &'a Obstacle,
    /// Those that the shape has, and whether they are there.
    pub(super) needed: Vec<(&'static str, bool)>,
}

impl Obstacle {
    /// The obstacle for the contact module; `None` if it lacks a measure or has lists of another length.
    pub fn build<const D: usize>(&self) -> Option<fmc_contact::Obstacle<D>> {
        let mut measured = self.measured();
        let shape = Shape::read(self.shape.0, &mut measured).ok()?;
        if measured.needed.iter().any(|(_, is_there)| !is_there) {
            return None;
        }
        let vector = |list: &Vec<f64>| <[f64; D]>::try_from(&list[..]).ok();
        let mut pose = Pose::at(self.position.as_ref().map_or(Some([0.0; D]), vector)?);
        if let Some(axis) = &self.axis {
            let axis = vector(axis)?;
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            pose.rotation = rotation_onto(axis.map(|x| x / length));
        }
        Some(fmc_contact::Obstacle { shape, pose })
    }

    /// For its shape to read.
    pub(super) fn measured(&self) -> Measured<'_> {
        Measured { obstacle: self, needed: Vec::new() }
    }
}

impl Measured<'_> {
    /// Notes a measure, and returns it, or something in its place.
    fn of<T>(&mut self, name: &'static str, value: Option<T>, absent: T) -> Result<T, &'static str> {
        self.needed.push((name, value.is_some()));
        Ok(value.unwrap_or(absent))
    }
}

impl<const D: usize> Measures<D> for Measured<'_> {
    /// What no case has.
    type Error = &'static str;

    fn radius(&mut self) -> Result<f64, &'static str> {
        self.of("radius", self.obstacle.radius, 1.0)
    }

    fn half_height(&mut self) -> Result<f64, &'static str> {
        self.of("half_height", self.obstacle.half_height, 1.0)
    }

    fn half_extents(&mut self) -> Result<[f64; D], &'static str> {
        let half_extents = self.obstacle.half_extents.as_ref();
        self.of("half_extents", half_extents.and_then(|list| <[f64; D]>::try_from(&list[..]).ok()), [1.0; D])
    }

    fn points(&mut self) -> Result<Vec<[f64; D]>, &'static str> {
        let vector = |x: &[f64; 2]| <[f64; D]>::try_from(&x[..]).ok();
        let points = self.obstacle.points.as_ref();
        self.of("points", points.and_then(|points| points.iter().map(vector).collect()), Vec::new())
    }

    /// The edges of a polygon, each from its corner to the next.
    fn facets(&mut self) -> Result<Vec<[u32; D]>, &'static str> {
        let count = self.obstacle.points.as_ref().map_or(0, Vec::len) as u32;
        Ok((0..count).map(|k| std::array::from_fn(|end| (k + end as u32) % count)).collect())
    }

    fn height_field(&mut self) -> Result<HeightField, &'static str> {
        Err("heights")
    }

    fn parts(&mut self) -> Result<Vec<fmc_contact::Obstacle<D>>, &'static str> {
        Err("parts")
    }

    fn signed_distance(&mut self) -> Result<Arc<dyn SignedDistance<D>>, &'static str> {
        Err("a function")
    }
}
