//! Where an instance of a part stands in the assembly.

use super::lines::{Lines, fields, number};
use anyhow::{Result, ensure};

/// Moved first, then turned (Abaqus Analysis User's Guide, "Assembly definition").
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    translation: [f64; 3],
    rotation: Option<Rotation>,
}

#[derive(Clone, Debug, PartialEq)]
struct Rotation {
    /// A point of the axis.
    centre: [f64; 3],
    /// Its direction, of length 1.
    axis: [f64; 3],
    cos: f64,
    sin: f64,
}

impl Motion {
    /// Reads the data lines of `*INSTANCE`, none to two.
    pub(super) fn read(lines: &mut Lines) -> Result<Self> {
        let mut motion = Self::default();
        if let Some((line, text)) = lines.data() {
            motion.translation = numbers::<3>(line, text, "the three components of a translation")?;
        }
        if let Some((line, text)) = lines.data() {
            let [a, b, c, p, q, r, angle] =
                numbers::<7>(line, text, "two points of an axis and an angle in degrees, 7 numbers")?;
            let along = [p - a, q - b, r - c];
            let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
            ensure!(length > 0.0 && length.is_finite(), "line {line}: the two points of the axis are one");
            let (sin, cos) = sine_and_cosine(angle);
            motion.rotation = Some(Rotation { centre: [a, b, c], axis: along.map(|x| x / length), cos, sin });
        }
        Ok(motion)
    }

    /// Where a point of the part is in the assembly.
    pub fn place(&self, point: [f64; 3]) -> [f64; 3] {
        let moved: [f64; 3] = std::array::from_fn(|axis| point[axis] + self.translation[axis]);
        let Some(Rotation { centre, axis, cos, sin }) = &self.rotation else { return moved };
        // Rodrigues' formula.
        let x: [f64; 3] = std::array::from_fn(|k| moved[k] - centre[k]);
        let along: f64 = (0..3).map(|k| axis[k] * x[k]).sum();
        std::array::from_fn(|k| {
            let (next, last) = ((k + 1) % 3, (k + 2) % 3);
            let across = axis[next] * x[last] - axis[last] * x[next];
            centre[k] + cos * x[k] + sin * across + (1.0 - cos) * along * axis[k]
        })
    }
}

/// Of an angle in degrees: exact at right angles, where rounding would tilt faces that lie along the axes.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => degrees.to_radians().sin_cos(),
    }
}

/// A data line of at most `N` numbers; missing ones are 0, as Abaqus has it.
fn numbers<const N: usize>(line: usize, text: &str, expected: &str) -> Result<[f64; N]> {
    let found: Vec<f64> = fields(text).map(|field| number(line, field)).collect::<Result<_>>()?;
    ensure!(found.len() <= N, "line {line}: expected {expected}, found {} numbers", found.len());
    Ok(std::array::from_fn(|k| found.get(k).copied().unwrap_or(0.0)))
}
