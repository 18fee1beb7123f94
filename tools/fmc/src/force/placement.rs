//! Where the meshes are put: `--rotate` and `--translate`.

use anyhow::{Result, ensure};
use fmc_contact::Pose;
use fmc_mesh_io::{Kind, Mesh};
use std::str::FromStr;

/// `MESH=X,Y[,Z]`
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Translation {
    /// Place on the command line, from 1.
    mesh: usize,
    by: [f64; 3],
}

/// `MESH=ANGLE` or `MESH=X,Y,Z,ANGLE`
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rotation {
    /// Place on the command line, from 1.
    mesh: usize,
    /// `None` in 2D.
    axis: Option<[f64; 3]>,
    degrees: f64,
}

impl FromStr for Translation {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match assignment(text)? {
            (mesh, numbers) if numbers.len() == 2 => Ok(Self { mesh, by: [numbers[0], numbers[1], 0.0] }),
            (mesh, numbers) if numbers.len() == 3 => Ok(Self { mesh, by: [numbers[0], numbers[1], numbers[2]] }),
            _ => Err("it needs 2 or 3 numbers, as in 2=0,-0.1".into()),
        }
    }
}

impl FromStr for Rotation {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match assignment(text)? {
            (mesh, numbers) if numbers.len() == 1 => Ok(Self { mesh, axis: None, degrees: numbers[0] }),
            (mesh, numbers) if numbers.len() == 4 => {
                let axis = [numbers[0], numbers[1], numbers[2]];
                if axis == [0.0; 3] {
                    return Err("its axis is zero".into());
                }
                Ok(Self { mesh, axis: Some(axis), degrees: numbers[3] })
            }
            _ => Err("it needs an angle, as in 1=30, or an axis and an angle, as in 1=0,0,1,30".into()),
        }
    }
}

impl Translation {
    pub(super) fn apply(&self, meshes: &mut [Mesh], kind: Kind) -> Result<()> {
        ensure!(kind != Kind::Flat || self.by[2] == 0.0, "--translate: 2D meshes move in their plane, without a z");
        let mesh = chosen(meshes, self.mesh, "--translate")?;
        for x in &mut mesh.points {
            for axis in 0..3 {
                x[axis] += self.by[axis];
            }
        }
        Ok(())
    }
}

impl Rotation {
    pub(super) fn apply(&self, meshes: &mut [Mesh], kind: Kind) -> Result<()> {
        let flat = kind == Kind::Flat;
        ensure!(flat || self.axis.is_some(), "--rotate: 3D meshes need an axis too, as in {}=0,0,1,30", self.mesh);
        ensure!(!flat || self.axis.is_none(), "--rotate: 2D meshes need the angle only, as in {}=30", self.mesh);
        let mesh = chosen(meshes, self.mesh, "--rotate")?;
        let axis = self.axis.unwrap_or([0.0, 0.0, 1.0]);
        let rows = Pose::<3>::default().turned_about(axis, self.degrees.to_radians()).rotation;
        for x in &mut mesh.points {
            *x = rows.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2]);
        }
        Ok(())
    }
}

fn chosen<'a>(meshes: &'a mut [Mesh], place: usize, option: &str) -> Result<&'a mut Mesh> {
    let count = meshes.len();
    ensure!((1..=count).contains(&place), "{option}: there is no mesh {place}, they are counted from 1 to {count}");
    Ok(&mut meshes[place - 1])
}

/// `MESH=NUMBER,NUMBER,…`
fn assignment(text: &str) -> Result<(usize, Vec<f64>), String> {
    let (mesh, numbers) = text.split_once('=').ok_or("it needs the place of the mesh in front, as in 2=0,-0.1")?;
    let mesh = mesh.trim().parse().map_err(|_| format!("'{mesh}' is not the place of a mesh, 1, 2, …"))?;
    let parse = |word: &str| match word.trim().parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("'{word}' is not a finite number")),
    };
    Ok((mesh, numbers.split(',').map(parse).collect::<Result<_, _>>()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn assignments_are_read_or_refused() {
        assert_eq!("2=0,-0.1".parse(), Ok(Translation { mesh: 2, by: [0.0, -0.1, 0.0] }));
        assert_eq!("1=0,0,2,90".parse(), Ok(Rotation { mesh: 1, axis: Some([0.0, 0.0, 2.0]), degrees: 90.0 }));
        for text in ["", "1", "=1,2", "a=1,2", "1=1", "1=1,2,3,4", "1=1,x", "1=nan,0", "-1=1,2"] {
            assert!(text.parse::<Translation>().is_err(), "{text}");
        }
        for text in ["1=1,2", "1=0,0,0,30", "1=inf"] {
            assert!(text.parse::<Rotation>().is_err(), "{text}");
        }
    }
}
