//! Moved, turned and scaled meshes.

use crate::Mesh;

impl<const D: usize> Mesh<D> {
    /// Every node moved to `f(x)`. `f` must keep orientation.
    pub fn mapped(mut self, f: impl Fn([f64; D]) -> [f64; D]) -> Self {
        self.coords.iter_mut().for_each(|x| *x = f(*x));
        self
    }

    /// Moved by `offset`.
    pub fn translated(self, offset: [f64; D]) -> Self {
        self.mapped(|x| std::array::from_fn(|i| x[i] + offset[i]))
    }

    /// Scaled about the origin by a positive factor.
    pub fn scaled(self, factor: f64) -> Self {
        assert!(factor > 0.0, "a factor of {factor} turns the mesh inside out");
        self.mapped(|x| x.map(|x| x * factor))
    }

    /// Turned about the origin by a rotation matrix given by rows.
    pub fn rotated_by(self, rotation: [[f64; D]; D]) -> Self {
        self.mapped(|x| std::array::from_fn(|i| (0..D).map(|j| rotation[i][j] * x[j]).sum()))
    }
}

impl Mesh<2> {
    /// Turned counter-clockwise about the origin by `angle` in radians.
    pub fn rotated(self, angle: f64) -> Self {
        let (s, c) = angle.sin_cos();
        self.rotated_by([[c, -s], [s, c]])
    }
}

impl Mesh<3> {
    /// Turned about `axis` through the origin by `angle` in radians, by the right-hand rule.
    ///
    /// Rodrigues: R = cos φ I + sin φ a × + (1 − cos φ) a aᵀ with a the unit axis.
    pub fn rotated(self, axis: [f64; 3], angle: f64) -> Self {
        let length = axis.iter().map(|a| a * a).sum::<f64>().sqrt();
        let a = axis.map(|a| a / length);
        let (s, c) = angle.sin_cos();
        let cross = [[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]];
        self.rotated_by(std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let diagonal = if i == j { c } else { 0.0 };
                diagonal + s * cross[i][j] + (1.0 - c) * a[i] * a[j]
            })
        }))
    }
}

#[cfg(test)]
mod tests {
    use crate::{cuboid_hex8, rectangle_tri3};

    #[test]
    fn quarter_turns() {
        let mesh = rectangle_tri3([1.0, 0.0], [2.0, 1.0], [1, 1], crate::Diagonals::Same);
        let turned = mesh.clone().rotated(std::f64::consts::FRAC_PI_2);
        for (x, y) in mesh.coords.iter().zip(&turned.coords) {
            assert!((y[0] + x[1]).abs() < 1e-15 && (y[1] - x[0]).abs() < 1e-15);
        }
        let mesh = cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]);
        let turned = mesh.clone().rotated([0.0, 0.0, 2.0], std::f64::consts::FRAC_PI_2);
        for (x, y) in mesh.coords.iter().zip(&turned.coords) {
            assert!((y[0] + x[1]).abs() < 1e-15 && (y[1] - x[0]).abs() < 1e-15 && y[2] == x[2]);
        }
    }

    #[test]
    fn volume_follows_motion() {
        let mesh = cuboid_hex8([0.0; 3], [1.0, 2.0, 3.0], [2; 3]);
        let moved = mesh.rotated([1.0, -2.0, 0.5], 0.7).scaled(0.5).translated([3.0, 1.0, -2.0]);
        assert!((moved.measure() - 0.75).abs() < 1e-13);
        assert!(moved.smallest_jacobian() > 0.0);
    }
}
