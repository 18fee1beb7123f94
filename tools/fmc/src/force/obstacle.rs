//! Rigid partners from the command line: `--obstacle "ball radius=0.5 position=0,0,1"`.

use anyhow::{Result, bail, ensure};
use fmc_contact::{Obstacle, Pose, Shape};
use fmc_shapes::rotation_onto;
use std::str::FromStr;

/// A shape by name, and its measures, each a list of numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ObstacleSpec {
    /// As the user wrote it.
    pub(super) text: String,
    shape: String,
    measures: Vec<(String, Vec<f64>)>,
}

impl FromStr for ObstacleSpec {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut words = text.split_whitespace();
        let shape = words.next().ok_or("it needs a shape, as in 'ball radius=0.5 position=0,0,1'")?.to_owned();
        let measure = |word: &str| {
            let (key, numbers) = word.split_once('=').ok_or(format!("'{word}' is not KEY=NUMBER,…"))?;
            let number = |n: &str| match n.parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(value),
                _ => Err(format!("'{n}' in '{word}' is not a finite number")),
            };
            Ok::<_, String>((key.to_owned(), numbers.split(',').map(number).collect::<Result<_, _>>()?))
        };
        Ok(Self { text: text.to_owned(), shape, measures: words.map(measure).collect::<Result<_, _>>()? })
    }
}

impl ObstacleSpec {
    /// The obstacle in `D` dimensions.
    pub(super) fn build<const D: usize>(&self) -> Result<Obstacle<D>> {
        let (radius, half_height) = (|| self.positive("radius"), || self.positive("half-height"));
        let (shape, keys): (_, &[&str]) = match self.shape.as_str() {
            "half-space" => (Shape::HalfSpace, &[]),
            "ball" => (Shape::Ball { radius: radius()? }, &["radius"]),
            "cuboid" => {
                let half_extents = self.vector("half-extents")?;
                let Some(half_extents) = half_extents.filter(|h| h.iter().all(|&x| x > 0.0)) else {
                    bail!("--obstacle '{}': cuboid needs half-extents, {D} positive lengths", self.text);
                };
                (Shape::Cuboid { half_extents }, &["half-extents"])
            }
            "cylinder" => {
                (Shape::Cylinder { radius: radius()?, half_height: half_height()? }, &["radius", "half-height"])
            }
            "cone" => (Shape::Cone { radius: radius()?, half_height: half_height()? }, &["radius", "half-height"]),
            "capsule" => {
                (Shape::Capsule { radius: radius()?, half_height: half_height()? }, &["radius", "half-height"])
            }
            other => bail!(
                "--obstacle '{}': '{other}' is not half-space, ball, cuboid, cylinder, cone or capsule",
                self.text
            ),
        };
        for (key, _) in &self.measures {
            let known = ["position", "axis"].contains(&key.as_str()) || keys.contains(&key.as_str());
            ensure!(known, "--obstacle '{}': {} has no {key}", self.text, self.shape);
        }
        let mut pose = Pose::at(self.vector("position")?.unwrap_or([0.0; D]));
        if let Some(axis) = self.vector("axis")? {
            let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
            ensure!(length > 0.0 && length.is_finite(), "--obstacle '{}': its axis has no direction", self.text);
            pose.rotation = rotation_onto(axis.map(|x| x / length));
        }
        Ok(Obstacle { shape, pose })
    }

    fn numbers(&self, key: &str) -> Option<&[f64]> {
        self.measures.iter().find(|(k, _)| k == key).map(|(_, numbers)| numbers.as_slice())
    }

    fn positive(&self, key: &str) -> Result<f64> {
        match self.numbers(key) {
            Some(&[value]) if value > 0.0 => Ok(value),
            _ => bail!("--obstacle '{}': {} needs {key}, a positive length", self.text, self.shape),
        }
    }

    fn vector<const D: usize>(&self, key: &str) -> Result<Option<[f64; D]>> {
        match self.numbers(key).map(<[f64; D]>::try_from) {
            None => Ok(None),
            Some(Ok(vector)) => Ok(Some(vector)),
            Some(Err(_)) => bail!("--obstacle '{}': {key} needs {D} numbers in {D}D", self.text),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn specifications_are_built_or_refused() {
        let build = |text: &str| text.parse::<ObstacleSpec>().unwrap().build::<3>();
        let ball = build("ball radius=0.5 position=0,0,1").unwrap();
        assert!(matches!(ball.shape, Shape::Ball { radius: 0.5 }));
        assert_eq!(ball.pose, Pose::at([0.0, 0.0, 1.0]));
        for text in ["ball", "ball radius=-1", "ball radius=1 position=0,0", "wedge", "half-space radius=1", "cuboid"] {
            assert!(build(text).is_err(), "{text}");
        }
        for text in ["", "ball radius", "ball radius=x", "ball radius=inf"] {
            assert!(text.parse::<ObstacleSpec>().is_err(), "{text}");
        }
    }
}
