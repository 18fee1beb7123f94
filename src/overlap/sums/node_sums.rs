//! Sums of vectors at nodes of two sides.

use crate::geometry::Vector;
use crate::ranks::Packed;
use rustc_hash::FxHashMap;

/// Vectors at nodes, each summed in the order in which they come; a node that both sides have is two.
#[derive(Default)]
pub(crate) struct NodeSums<const D: usize> {
    /// Twice a node, and one more for the second side.
    slots: Vec<u32>,
    values: Vec<Vector<D>>,
    /// Where among these a slot is. Never iterated over: its order is not ours.
    place: FxHashMap<u32, u32>,
}

impl<const D: usize> Packed for NodeSums<D> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.slots.pack(bytes);
        self.values.pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        let (slots, values) = (Vec::unpack(bytes)?, Vec::unpack(bytes)?);
        let place = slots.iter().copied().zip(0..).collect();
        Some(Self { slots, values, place })
    }

    fn blank() -> Self {
        Self::default()
    }
}

impl<const D: usize> NodeSums<D> {
    /// Adds to a node of one side.
    pub(crate) fn add(&mut self, node: u32, of_b: bool, value: &Vector<D>) {
        let slot = 2 * node + u32::from(of_b);
        let place = *self.place.entry(slot).or_insert_with(|| {
            self.slots.push(slot);
            self.values.push(Vector::zeros());
            self.slots.len() as u32 - 1
        });
        self.values[place as usize] += value;
    }

    /// Adds all of another sum.
    pub(crate) fn add_sums(&mut self, other: &Self) {
        for (&slot, value) in other.slots.iter().zip(&other.values) {
            self.add(slot / 2, slot % 2 == 1, value);
        }
    }

    /// Nodes, ascending, the side of each, and their vectors.
    pub(crate) fn into_nodes(self) -> (Vec<u32>, Vec<bool>, Vec<Vector<D>>) {
        let mut order: Vec<(u32, u32)> = self.slots.iter().copied().zip(0..).collect();
        order.sort_unstable();
        let nodes = order.iter().map(|&(slot, _)| slot / 2).collect();
        let of_b = order.iter().map(|&(slot, _)| slot % 2 == 1).collect();
        (nodes, of_b, order.iter().map(|&(_, place)| self.values[place as usize]).collect())
    }
}
