//! Where an obstacle stands.

use crate::Pose;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{Output, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BAD_POSE;

/// Position, rotation and scale of an obstacle: a point X of the shape is at position + scale rotation X.
///
/// In 2D the first two entries of the position and the upper left two by two of the rotation are read.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct fmc_pose {
    /// Position of the shape's origin.
    pub position: [f64; 3],
    /// Rotation matrix, 3 by 3, row after row; orthonormal with determinant +1 to 1e-8.
    pub rotation: [f64; 9],
    /// Uniform scale, positive.
    pub scale: f64,
}

impl Default for fmc_pose {
    fn default() -> Self {
        Self { position: [0.0; 3], rotation: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0], scale: 1.0 }
    }
}

impl<const D: usize> From<&Pose<D>> for fmc_pose {
    fn from(pose: &Pose<D>) -> Self {
        let mut found = Self { scale: pose.scale, ..Self::default() };
        found.position[..D].copy_from_slice(&pose.position);
        for (i, row) in pose.rotation.iter().enumerate() {
            found.rotation[3 * i..3 * i + D].copy_from_slice(row);
        }
        found
    }
}

impl fmc_pose {
    /// The pose of the crate, which checks it.
    pub(crate) fn to_pose<const D: usize>(self) -> Pose<D> {
        Pose {
            position: std::array::from_fn(|i| self.position[i]),
            rotation: std::array::from_fn(|i| std::array::from_fn(|j| self.rotation[3 * i + j])),
            scale: self.scale,
        }
    }
}

/// The shortest rotation that takes the last of `dim` axes to `axis`, as a 3 by 3 matrix.
///
/// With e the last axis, a = axis/|axis| and c = e·a it is R = I + K + K²/(1 + c), K x = (e × a) × x. That form loses
/// all digits as c nears −1, so for c < 0 it is applied to −a, after a rotation by 180°: diag(1, −1, −1) in 3D, −I in
/// 2D.
fn rotation_to(dim: usize, axis: &[f64]) -> Option<[[f64; 3]; 3]> {
    let largest = axis.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if !(largest.is_finite() && largest > 0.0) || axis.iter().any(|x| x.is_nan()) {
        return None;
    }
    let mut a = [0.0; 3];
    for (i, x) in axis.iter().enumerate() {
        a[i] = x / largest;
    }
    let length = a.iter().map(|x| x * x).sum::<f64>().sqrt();
    a = a.map(|x| x / length);
    if dim == 2 {
        // e = y goes to (a0, a1): turned by the angle whose sine is −a0 and whose cosine is a1.
        return Some([[a[1], a[0], 0.0], [-a[0], a[1], 0.0], [0.0, 0.0, 1.0]]);
    }
    let flip = if a[2] < 0.0 { -1.0 } else { 1.0 };
    let [x, y, z] = a.map(|component| flip * component);
    let s = 1.0 / (1.0 + z);
    let r = [[1.0 - x * x * s, -x * y * s, x], [-x * y * s, 1.0 - y * y * s, y], [-x, -y, z]];
    Some(r.map(|[i, j, k]| [i, flip * j, flip * k]))
}

/// Sets a pose to the origin, without rotation and with scale 1.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_pose_init(pose: *mut fmc_pose) -> fmc_status {
    entry(|| {
        let output = Output::required("pose", pose)?;
        // SAFETY: the host passes a pose that may be written.
        unsafe { output.write(fmc_pose::default()) };
        Ok(())
    })
}

/// Sets a pose to `position`, with scale 1 and the shape's last axis (y in 2D, z in 3D) along `axis`.
///
/// That is the outward normal of a half-space and the axis of cylinder, cone and capsule. `position` and `axis` have
/// `dim` entries; `axis` need not have unit length.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_DIMENSION`, `FMC_ERROR_BAD_POSE` for an axis of length 0. Threads:
/// any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_pose_along(
    dim: i32,
    position: *const f64,
    axis: *const f64,
    pose: *mut fmc_pose,
) -> fmc_status {
    entry(|| {
        let output = Output::required("pose", pose)?;
        let dim = crate::capi::boundary::dimension::checked_dimension(dim)?;
        // SAFETY: the host passes `dim` numbers each.
        let (position, axis) = unsafe { (slice("position", position, dim, 1)?, slice("axis", axis, dim, 1)?) };
        let rotation = rotation_to(dim, axis)
            .ok_or_else(|| Failure::new(FMC_ERROR_BAD_POSE, format!("the axis {axis:?} has no direction")))?;
        let mut placed = fmc_pose { rotation: std::array::from_fn(|i| rotation[i / 3][i % 3]), ..fmc_pose::default() };
        placed.position[..dim].copy_from_slice(position);
        // SAFETY: the pose may be written.
        unsafe { output.write(placed) };
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_axis_is_turned_along() {
        let axes: [&[f64]; 9] = [
            &[0.0, 2.0],
            &[0.0, -1.0],
            &[3.0, -4.0],
            &[0.0, 0.0, 1.0],
            &[0.0, 0.0, -1.0],
            &[1e-9, 0.0, -1.0],
            &[1.0, 2.0, -3.0],
            &[-1e200, 1e200, 0.0],
            &[1e-300, 0.0, 0.0],
        ];
        for axis in axes {
            let dim = axis.len();
            let r = rotation_to(dim, axis).unwrap();
            let largest = axis.iter().fold(0.0, |l: f64, x| l.max(x.abs()));
            let length = axis.iter().map(|x| (x / largest).powi(2)).sum::<f64>().sqrt();
            for i in 0..dim {
                assert!((r[i][dim - 1] - axis[i] / largest / length).abs() < 1e-15, "{axis:?}");
            }
            for i in 0..3 {
                for j in 0..3 {
                    let product: f64 = (0..3).map(|k| r[i][k] * r[j][k]).sum();
                    assert!((product - f64::from(u8::from(i == j))).abs() < 1e-15, "{axis:?}");
                }
            }
            let det = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1])
                - r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0])
                + r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
            assert!((det - 1.0).abs() < 1e-15, "{axis:?}");
        }
        for axis in [[0.0, 0.0], [f64::NAN, 1.0], [f64::INFINITY, 0.0]] {
            assert!(rotation_to(2, &axis).is_none());
        }
    }
}
