//! Rigid partners from the command line: `--obstacle "ball radius=0.5 position=0,0,1"`.

use anyhow::{Result, bail, ensure};
use fmc_contact::{HeightField, Measures, Obstacle, Pose, Shape, ShapeKind, SignedDistance};
use fmc_shapes::rotation_onto;
use std::str::FromStr;
use std::sync::Arc;

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
        let Some(kind) = ShapeKind::named(&self.shape) else {
            let shapes = Words::shapes::<D>().join(", ");
            bail!("--obstacle '{}': '{}' is not one of {shapes}", self.text, self.shape);
        };
        let mut words = Words { spec: Some(self), read: vec!["position", "axis"] };
        let shape = Shape::read(kind, &mut words)?;
        for (key, _) in &self.measures {
            ensure!(words.read.contains(&key.as_str()), "--obstacle '{}': {} has no {key}", self.text, self.shape);
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

    fn vector<const D: usize>(&self, key: &str) -> Result<Option<[f64; D]>> {
        match self.numbers(key).map(<[f64; D]>::try_from) {
            None => Ok(None),
            Some(Ok(vector)) => Ok(Some(vector)),
            Some(Err(_)) => bail!("--obstacle '{}': {key} needs {D} numbers in {D}D", self.text),
        }
    }
}

/// The measures in the words of a user; without any, every length is 1, to see which shapes have no others.
struct Words<'a> {
    spec: Option<&'a ObstacleSpec>,
    /// Keys that were asked for.
    read: Vec<&'static str>,
}

impl Words<'_> {
    /// Names of the shapes that lengths describe.
    fn shapes<const D: usize>() -> Vec<String> {
        let is_read = |kind: &ShapeKind| Shape::<D>::read(*kind, &mut Words { spec: None, read: Vec::new() }).is_ok();
        ShapeKind::ALL.into_iter().filter(is_read).map(ShapeKind::name).collect()
    }

    fn length(&mut self, key: &'static str) -> Result<f64> {
        self.read.push(key);
        let Some(spec) = self.spec else { return Ok(1.0) };
        match spec.numbers(key) {
            Some(&[value]) if value > 0.0 => Ok(value),
            _ => bail!("--obstacle '{}': {} needs {key}, a positive length", spec.text, spec.shape),
        }
    }

    fn list<T>(&self) -> Result<T> {
        let text = self.spec.map_or("", |spec| &spec.text);
        bail!("--obstacle '{text}': such a shape has too many numbers for a command line")
    }
}

impl<const D: usize> Measures<D> for Words<'_> {
    type Error = anyhow::Error;

    fn radius(&mut self) -> Result<f64> {
        self.length("radius")
    }

    fn half_height(&mut self) -> Result<f64> {
        self.length("half-height")
    }

    fn half_extents(&mut self) -> Result<[f64; D]> {
        self.read.push("half-extents");
        let Some(spec) = self.spec else { return Ok([1.0; D]) };
        match spec.vector("half-extents")?.filter(|half: &[f64; D]| half.iter().all(|&x| x > 0.0)) {
            Some(half_extents) => Ok(half_extents),
            None => bail!("--obstacle '{}': {} needs half-extents, {D} positive lengths", spec.text, spec.shape),
        }
    }

    fn points(&mut self) -> Result<Vec<[f64; D]>> {
        self.list()
    }

    fn facets(&mut self) -> Result<Vec<[u32; D]>> {
        self.list()
    }

    fn height_field(&mut self) -> Result<HeightField> {
        self.list()
    }

    fn parts(&mut self) -> Result<Vec<Obstacle<D>>> {
        self.list()
    }

    fn signed_distance(&mut self) -> Result<Arc<dyn SignedDistance<D>>> {
        self.list()
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
        for text in [
            "ball",
            "ball radius=-1",
            "ball radius=1 position=0,0",
            "wedge",
            "polytope",
            "half-space radius=1",
            "cuboid",
        ] {
            assert!(build(text).is_err(), "{text}");
        }
        let known = "half-space, ball, cuboid, cylinder, cone, capsule";
        assert!(build("wedge").unwrap_err().to_string().ends_with(known));
        for text in ["", "ball radius", "ball radius=x", "ball radius=inf"] {
            assert!(text.parse::<ObstacleSpec>().is_err(), "{text}");
        }
    }
}
