//! Random numbers without a generator: a pure function of (seed, stream, index).

/// SplitMix64's finaliser (Steele, Lea, Flood 2014): every output bit depends on every input bit.
fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Increment of SplitMix64: 2⁶⁴ divided by the golden ratio, odd.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Uniform number in [0, 1), with 53 random bits.
pub(crate) fn uniform(seed: u64, stream: u64, index: u64) -> f64 {
    let key = mix(mix(seed.wrapping_add(GOLDEN)).wrapping_add(stream.wrapping_mul(GOLDEN)).wrapping_add(GOLDEN));
    let bits = mix(key.wrapping_add(index.wrapping_add(1).wrapping_mul(GOLDEN)));
    (bits >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_uniform_distribution() {
        let n = 100_000;
        for (seed, stream) in [(0, 0), (0, 1), (1, 0), (u64::MAX, 7)] {
            let x: Vec<f64> = (0..n).map(|i| uniform(seed, stream, i)).collect();
            let mean = x.iter().sum::<f64>() / n as f64;
            let square = x.iter().map(|x| x * x).sum::<f64>() / n as f64;
            let lag = x.windows(2).map(|w| (w[0] - 0.5) * (w[1] - 0.5)).sum::<f64>() / n as f64;
            // Four standard errors: sqrt(1/12 n), sqrt(4/45 n), 1/(12 sqrt n).
            let root = (n as f64).sqrt();
            assert!((mean - 0.5).abs() < 4.0 * 0.289 / root);
            assert!((square - 1.0 / 3.0).abs() < 4.0 * 0.298 / root);
            assert!(lag.abs() < 4.0 / (12.0 * root));
            assert!(x.iter().all(|x| (0.0..1.0).contains(x)));
        }
    }
}
