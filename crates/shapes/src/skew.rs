//! Blocks whose inner lines lean.

use crate::Mesh;

impl<const D: usize> Mesh<D> {
    /// Block skewed inside its own outline: lines along the last axis lean to one side, most in the middle, by `amount`
    /// of the width of the bounding box between its ends, and every side of the box stays in itself.
    ///
    /// With ξ the place in the box along the axis and ζ that along the last one, both from 0 to 1, every other coordinate
    /// moves by amount · width · 4 ξ(1 − ξ)(ζ − ½). The last coordinate stays.
    ///
    /// # Panics
    /// If `amount` is not between −½ and ½, beyond which cells may turn inside out.
    pub fn skewed(self, amount: f64) -> Self {
        assert!(amount.abs() < 0.5, "a skew of {amount} turns cells inside out");
        let (mut low, mut high) = ([f64::INFINITY; D], [f64::NEG_INFINITY; D]);
        for x in &self.coords {
            low = std::array::from_fn(|i| low[i].min(x[i]));
            high = std::array::from_fn(|i| high[i].max(x[i]));
        }
        self.mapped(|x| {
            let place = |i: usize| (x[i] - low[i]) / (high[i] - low[i]);
            let lean = amount * 4.0 * (place(D - 1) - 0.5);
            std::array::from_fn(|i| {
                let shift = if i + 1 < D { lean * place(i) * (1.0 - place(i)) } else { 0.0 };
                x[i] + shift * (high[i] - low[i])
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use crate::{cuboid_hex8, rectangle_quad4};

    #[test]
    fn skewed_blocks_keep_their_outline() {
        let flat = rectangle_quad4([1.0, 2.0], [3.0, 5.0], [10, 4]).skewed(0.45);
        assert!((flat.measure() - 6.0).abs() < 1e-13 && flat.smallest_jacobian() > 0.0);
        // The middle of the top has moved by 0.45 · 2 · 4 · ¼ · ½ to the right.
        assert!(flat.coords.iter().any(|x| (x[0] - 2.45).abs() < 1e-14 && x[1] == 5.0));
        let solid = cuboid_hex8([0.0; 3], [1.0, 2.0, 3.0], [5, 4, 3]).skewed(-0.4);
        assert!((solid.measure() - 6.0).abs() < 1e-13 && solid.smallest_jacobian() > 0.0);
        assert!(solid.coords.iter().all(|x| (0..3).all(|i| x[i] >= 0.0 && x[i] <= (i + 1) as f64)));
    }
}
