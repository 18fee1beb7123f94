//! A state in a file, exact to the bit.
//!
//! ```text
//! "fmcstate"   8 bytes
//! version      u32     dimension  u32     fingerprint of the setup  u64
//! node count   u64     facet count u64    step       u64     step size  f64            dissipated energy  f64
//! displacement [node count × dimension] f64
//! velocity     [node count × dimension] f64
//! with friction, else the facet count is 0:
//! displacement at which its step began [node count × dimension] f64
//! elastic slip carried into it         [facet count × dimension] f64
//! FNV-1a of all before  u64
//! ```
//!
//! All little endian. The acceleration is not kept: it is a function of the displacement.

use super::error::CheckpointError;
use super::friction_step::FrictionStep;
use super::state::State;
use fnv::FnvHasher;
use std::fs::File;
use std::hash::Hasher;
use std::io::Write;
use std::path::{Path, PathBuf};

const MAGIC: &[u8; 8] = b"fmcstate";
const VERSION: u32 = 2;

/// A state and what it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Checkpoint<const D: usize> {
    pub(super) fingerprint: u64,
    pub(super) step_size: f64,
    pub(super) state: State<D>,
    pub(super) friction: Option<FrictionStep<D>>,
}

impl<const D: usize> Checkpoint<D> {
    /// Writes the file whole or not at all: beside its place first, then moved there.
    pub(super) fn write(&self, path: &Path) -> Result<(), CheckpointError> {
        let mut beside = path.as_os_str().to_owned();
        beside.push(".part");
        let beside = PathBuf::from(beside);
        let written = File::create(&beside).and_then(|mut file| {
            file.write_all(&self.to_bytes())?;
            file.sync_all()
        });
        written.and_then(|()| std::fs::rename(&beside, path)).map_err(|error| file_error(path, &error))
    }

    /// Reads a file.
    pub(super) fn read(path: &Path) -> Result<Self, CheckpointError> {
        Self::from_bytes(&std::fs::read(path).map_err(|error| file_error(path, &error))?)
    }

    fn to_bytes(&self) -> Vec<u8> {
        let State { step, displacement, velocity, dissipated, .. } = &self.state;
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend((D as u32).to_le_bytes());
        bytes.extend(self.fingerprint.to_le_bytes());
        bytes.extend((displacement.len() as u64).to_le_bytes());
        let none = FrictionStep::default();
        let friction = self.friction.as_ref().unwrap_or(&none);
        bytes.extend((friction.slip.len() as u64).to_le_bytes());
        bytes.extend(step.to_le_bytes());
        let of_friction = friction.displacement.iter().chain(&friction.slip);
        let values = displacement.iter().chain(velocity).chain(of_friction).flatten();
        for value in [&self.step_size, dissipated].into_iter().chain(values) {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend(checksum(&bytes).to_le_bytes());
        bytes
    }

    fn from_bytes(bytes: &[u8]) -> Result<Self, CheckpointError> {
        let (body, sum) = bytes.split_last_chunk::<8>().ok_or(CheckpointError::Damaged)?;
        let body = body.strip_prefix(MAGIC).ok_or(CheckpointError::Damaged)?;
        let (version, rest) = body.split_first_chunk::<4>().ok_or(CheckpointError::Damaged)?;
        // Before the sum, which another version may form in another way.
        match u32::from_le_bytes(*version) {
            VERSION => {}
            found => return Err(CheckpointError::Version { found }),
        }
        if checksum(&bytes[..bytes.len() - 8]) != u64::from_le_bytes(*sum) {
            return Err(CheckpointError::Damaged);
        }
        let (dimension, rest) = rest.split_first_chunk::<4>().ok_or(CheckpointError::Damaged)?;
        if u32::from_le_bytes(*dimension) as usize != D {
            return Err(CheckpointError::OtherModel);
        }
        let words: Vec<u64> =
            rest.chunks(8).map(|c| c.try_into().map(u64::from_le_bytes)).collect::<Result<_, _>>().map_err(damaged)?;
        let [fingerprint, node_count, facet_count, step, step_size, dissipated, ref values @ ..] = words[..] else {
            return Err(CheckpointError::Damaged);
        };
        let values: Vec<f64> = values.iter().map(|&word| f64::from_bits(word)).collect();
        let nodes: Vec<[f64; D]> =
            values.chunks(D).map(<[f64; D]>::try_from).collect::<Result<_, _>>().map_err(damaged)?;
        let arrays = if facet_count > 0 { 3u64 } else { 2 };
        let expected = node_count.checked_mul(arrays).and_then(|nodes| nodes.checked_add(facet_count));
        if expected != Some(nodes.len() as u64) {
            return Err(CheckpointError::Damaged);
        }
        let (displacement, rest) = nodes.split_at(node_count as usize);
        let (velocity, rest) = rest.split_at(node_count as usize);
        let friction = (facet_count > 0).then(|| {
            let (displacement, slip) = rest.split_at(node_count as usize);
            FrictionStep { displacement: displacement.to_vec(), slip: slip.to_vec() }
        });
        let state = State {
            step,
            displacement: displacement.to_vec(),
            velocity: velocity.to_vec(),
            acceleration: vec![[0.0; D]; displacement.len()],
            dissipated: f64::from_bits(dissipated),
        };
        Ok(Self { fingerprint, step_size: f64::from_bits(step_size), state, friction })
    }
}

fn checksum(bytes: &[u8]) -> u64 {
    let mut hash = FnvHasher::default();
    hash.write(bytes);
    hash.finish()
}

fn damaged<E>(_: E) -> CheckpointError {
    CheckpointError::Damaged
}

fn file_error(path: &Path, error: &std::io::Error) -> CheckpointError {
    CheckpointError::File { path: path.display().to_string(), reason: error.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checkpoint() -> Checkpoint<2> {
        let state = State {
            step: 7,
            displacement: vec![[0.1, -0.0], [f64::MIN_POSITIVE / 8.0, 1e300]],
            velocity: vec![[1.0 / 3.0, 2.0], [3.0, 4.0]],
            acceleration: vec![[0.0; 2]; 2],
            dissipated: 0.25,
        };
        let friction = FrictionStep { displacement: vec![[0.5, 0.25], [1.0, 0.0]], slip: vec![[1e-9, -0.0]; 3] };
        Checkpoint { fingerprint: 42, step_size: 1e-6, state, friction: Some(friction) }
    }

    #[test]
    fn bytes_give_the_state_back() {
        let checkpoint = checkpoint();
        assert_eq!(Checkpoint::from_bytes(&checkpoint.to_bytes()), Ok(checkpoint.clone()));
        let frictionless = Checkpoint { friction: None, ..checkpoint };
        assert_eq!(Checkpoint::from_bytes(&frictionless.to_bytes()), Ok(frictionless));
    }

    #[test]
    fn damage_anywhere_is_seen() {
        let bytes = checkpoint().to_bytes();
        for position in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[position] ^= 4;
            assert!(Checkpoint::<2>::from_bytes(&damaged).is_err(), "byte {position}");
            assert!(Checkpoint::<2>::from_bytes(&bytes[..position]).is_err(), "cut at {position}");
        }
        assert_eq!(Checkpoint::<3>::from_bytes(&bytes), Err(CheckpointError::OtherModel));
    }
}
