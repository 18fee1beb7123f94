//! J^(−1/3).

/// Inverse cube root of a positive normal number, to two units in the last place.
///
/// y = x^(−1/3) has 1 − x y³ = 0. With e = 1 − x y³ the exact root is y (1 − e)^(−1/3), and the series of that to third
/// order leaves an error of 35/243 e⁴. The start, a third of the exponent, has |e| ≤ 0.102: the first step leaves 2e-5,
/// the second only rounding. There is no division and no branch, so neighbouring calls overlap; the
/// library's cube root, correctly rounded, took half of the time of an element.
#[inline(always)]
pub(super) fn inverse_cube_root(x: f64) -> f64 {
    let mut y = f64::from_bits(START - x.to_bits() / 3);
    for _ in 0..2 {
        let e = 1.0 - x * (y * y * y);
        y += y * e * (1.0 / 3.0 + e * (2.0 / 9.0 + e * (14.0 / 81.0)));
    }
    y
}

/// 4/3 of the bits of 1, less 0.068 of an octave, which makes the largest |e| least.
const START: u64 = 0x553e_e978_d4fd_f3b7;

#[cfg(test)]
mod tests {
    use super::*;
    use fmc_shapes::Splitmix;

    #[test]
    fn cube_times_number_is_one() {
        let mut random = Splitmix::new(1);
        for k in 0..100_000 {
            let x = if k % 2 == 0 { random.between(0.1, 10.0) } else { random.between(-300.0, 300.0).exp2() };
            let (computed, exact) = (inverse_cube_root(x), 1.0 / x.cbrt());
            assert!((computed / exact - 1.0).abs() < 4.0 * f64::EPSILON, "{x}: {computed} {exact}");
        }
        assert!((inverse_cube_root(1.0) - 1.0).abs() < 2.0 * f64::EPSILON);
    }
}
