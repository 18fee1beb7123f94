//! Rigid partners.

use fmc_contact::{Pose, Shape};
use fmc_shapes::rotation_onto;
use serde::{Deserialize, Serialize};

/// `[[obstacles]]`: a rigid shape of fmc-contact and where it stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Obstacle {
    /// Name, unique among bodies and obstacles.
    pub name: String,
    /// Its shape; which measures it needs follows from it.
    pub shape: ShapeName,
    /// Where the origin of its frame lies, `[D]`, m; the origin of space if absent.
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

/// Names of shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShapeName {
    /// Everything below the plane through the position.
    HalfSpace,
    /// `radius`.
    Ball,
    /// `half_extents`.
    Cuboid,
    /// `radius`, `half_height`.
    Cylinder,
    /// `radius`, `half_height`; its apex is ahead.
    Cone,
    /// `radius`, `half_height`.
    Capsule,
    /// `points`; in 2D.
    Polygon,
}

impl ShapeName {
    /// Whether it is measured by a radius, a half height, half extents and points.
    pub fn measures(self) -> [bool; 4] {
        match self {
            ShapeName::HalfSpace => [false; 4],
            ShapeName::Ball => [true, false, false, false],
            ShapeName::Cuboid => [false, false, true, false],
            ShapeName::Cylinder | ShapeName::Cone | ShapeName::Capsule => [true, true, false, false],
            ShapeName::Polygon => [false, false, false, true],
        }
    }
}

impl Obstacle {
    /// The obstacle for the contact module; `None` if it lacks a measure or has lists of another length.
    pub fn build<const D: usize>(&self) -> Option<fmc_contact::Obstacle<D>> {
        let vector = |list: &Vec<f64>| <[f64; D]>::try_from(&list[..]).ok();
        let (radius, half_height) = (self.radius, self.half_height);
        let shape = match self.shape {
            ShapeName::HalfSpace => Shape::HalfSpace,
            ShapeName::Ball => Shape::Ball { radius: radius? },
            ShapeName::Cuboid => Shape::Cuboid { half_extents: vector(self.half_extents.as_ref()?)? },
            ShapeName::Cylinder => Shape::Cylinder { radius: radius?, half_height: half_height? },
            ShapeName::Cone => Shape::Cone { radius: radius?, half_height: half_height? },
            ShapeName::Polygon => {
                let points = self.points.as_ref()?;
                let count = points.len() as u32;
                Shape::Polytope {
                    points: points.iter().map(|x| vector(&x.to_vec())).collect::<Option<_>>()?,
                    facets: (0..count).map(|k| std::array::from_fn(|end| (k + end as u32) % count)).collect(),
                }
            }
            ShapeName::Capsule => Shape::Capsule { radius: radius?, half_height: half_height? },
        };
        let mut pose = Pose::at(self.position.as_ref().map_or(Some([0.0; D]), vector)?);
        if let Some(axis) = &self.axis {
            let axis = vector(axis)?;
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            pose.rotation = rotation_onto(axis.map(|x| x / length));
        }
        Some(fmc_contact::Obstacle { shape, pose })
    }
}
