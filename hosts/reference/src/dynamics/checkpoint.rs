//! A state in a file, exact to the bit.
//!
//! ```text
//! "fmcstate"   8 bytes
//! version      u32     dimension  u32     fingerprint of the setup  u64
//! node count   u64     slip rows  u64     step       u64     step size  f64            dissipated energy  f64
//! displacement [node count × dimension] f64
//! velocity     [node count × dimension] f64
//! with friction, else the number of slip rows is all ones:
//! displacement at which its step began [node count × dimension] f64
//! elastic slip carried into it, in rows of facet u64, partner's kind u64 and index u64, side u64, slip [dimension] f64, slid f64
//! FNV-1a of all before  u64
//! ```
//!
//! All little endian. The acceleration is not kept: it is a function of the displacement.

use super::error::CheckpointError;
use super::friction_step::FrictionStep;
use super::state::State;
use fmc_contact::contact::FacetSlip;
use fmc_contact::overlap::Partner;
use fnv::FnvHasher;
use std::fs::File;
use std::hash::Hasher;
use std::io::Write;
use std::path::{Path, PathBuf};

const MAGIC: &[u8; 8] = b"fmcstate";
const VERSION: u32 = 3;

/// In place of a number of slip rows.
const NO_FRICTION: u64 = u64::MAX;

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
        let rows = self.friction.as_ref().map_or(NO_FRICTION, |friction| friction.slip.len() as u64);
        bytes.extend(rows.to_le_bytes());
        bytes.extend(step.to_le_bytes());
        let begun = self.friction.iter().flat_map(|friction| &friction.displacement);
        let values = displacement.iter().chain(velocity).chain(begun).flatten();
        for value in [&self.step_size, dissipated].into_iter().chain(values) {
            bytes.extend(value.to_le_bytes());
        }
        for row in self.friction.iter().flat_map(|friction| &friction.slip) {
            let (kind, partner) = match row.partner {
                Partner::Body(index) => (0, index),
                Partner::Obstacle(index) => (1, index),
            };
            for number in [row.facet as u64, kind, partner as u64, u64::from(row.is_second)] {
                bytes.extend(number.to_le_bytes());
            }
            row.slip.iter().chain([&row.slid]).for_each(|value| bytes.extend(value.to_le_bytes()));
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
        let [fingerprint, node_count, row_count, step, step_size, dissipated, ref words @ ..] = words[..] else {
            return Err(CheckpointError::Damaged);
        };
        let (arrays, rows) = if row_count == NO_FRICTION { (2u64, 0) } else { (3, row_count) };
        let of_nodes = node_count.checked_mul(arrays * D as u64);
        let expected = rows.checked_mul(5 + D as u64).and_then(|rows| rows.checked_add(of_nodes?));
        let (Some(of_nodes), true) = (of_nodes, expected == Some(words.len() as u64)) else {
            return Err(CheckpointError::Damaged);
        };
        let (nodes, rows) = words.split_at(of_nodes as usize);
        let values: Vec<f64> = nodes.iter().map(|&word| f64::from_bits(word)).collect();
        let nodes: Vec<[f64; D]> =
            values.chunks(D).map(<[f64; D]>::try_from).collect::<Result<_, _>>().map_err(damaged)?;
        let (displacement, rest) = nodes.split_at(node_count as usize);
        let (velocity, begun) = rest.split_at(node_count as usize);
        let slip: Vec<FacetSlip<D>> =
            rows.chunks(5 + D).map(slip_row).collect::<Option<_>>().ok_or_else(|| damaged(()))?;
        let friction = (row_count != NO_FRICTION).then(|| FrictionStep { displacement: begun.to_vec(), slip });
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

fn slip_row<const D: usize>(row: &[u64]) -> Option<FacetSlip<D>> {
    let [facet, kind, partner, is_second, ref slip @ .., slid] = *row else { return None };
    let partner = match kind {
        0 => Partner::Body(partner as usize),
        _ => Partner::Obstacle(partner as usize),
    };
    let slip = std::array::from_fn(|axis| f64::from_bits(slip[axis]));
    let slid = f64::from_bits(slid);
    Some(FacetSlip { facet: facet as usize, partner, is_second: is_second != 0, slip, slid })
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
        let row = |facet, partner| FacetSlip { facet, partner, is_second: facet == 9, slip: [1e-9, -0.0], slid: 0.5 };
        let slip = vec![row(2, Partner::Body(0)), row(9, Partner::Body(1)), row(4, Partner::Obstacle(0))];
        let friction = FrictionStep { displacement: vec![[0.5, 0.25], [1.0, 0.0]], slip };
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
