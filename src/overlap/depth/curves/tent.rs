//! The pressure that the surfaces have of the whole.

/// By what factor of its top a tent ends.
pub(super) const END: f64 = 4.0;

/// A pressure that grows with the depth up to a top, and falls to zero from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tent {
    pub(super) top: f64,
}

impl Tent {
    /// Energy, pressure and its derivative at a depth, by the stiffness.
    pub(super) fn at(&self, depth: f64) -> (f64, f64, f64) {
        let (top, end) = (self.top, self.end());
        if depth <= 0.0 {
            (0.0, 0.0, 0.0)
        } else if depth <= top {
            (0.5 * depth * depth, depth, 1.0)
        } else if depth < end {
            let fall = 1.0 / (END - 1.0);
            let left = end - depth;
            (0.5 * (end * top - fall * left * left), fall * left, -fall)
        } else {
            (0.5 * end * top, 0.0, 0.0)
        }
    }

    /// Depths at which the pressure has another slope beyond.
    pub(super) fn levels(&self) -> [f64; 3] {
        [0.0, self.top, self.end()]
    }

    /// Where it ends.
    pub(super) fn end(&self) -> f64 {
        END * self.top
    }

    /// Parts of the integrals beyond the top and beyond the end that, with it, make a pressure that grows with the depth.
    pub(super) const BEYOND: [f64; 2] = [END / (END - 1.0), -1.0 / (END - 1.0)];
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With what lies beyond the top and the end it is a spring, energy and pressure.
    #[test]
    fn makes_a_spring_with_what_is_beyond() {
        let tent = Tent { top: 0.3 };
        for depth in [0.0, 0.1, 0.3, 0.5, 1.2, 2.0] {
            let (energy, pressure, slope) = tent.at(depth);
            let beyond = [tent.top, tent.end()].map(|from| (depth - from).max(0.0));
            let sum =
                |of: fn(f64) -> f64| -> f64 { Tent::BEYOND.iter().zip(beyond).map(|(part, g)| part * of(g)).sum() };
            assert!((energy + sum(|g| 0.5 * g * g) - 0.5 * depth * depth).abs() < 1e-15, "{depth}");
            assert!((pressure + sum(|g| g) - depth).abs() < 1e-15, "{depth}");
            if depth > 0.0 && depth != tent.top && depth != tent.end() {
                assert!((slope + sum(|g| f64::from(u8::from(g > 0.0))) - 1.0).abs() < 1e-15, "{depth}");
            }
        }
    }
}
