//! Random numbers as a pure function of (seed, stream, index).
//!
//! The generator is ChaCha with 8 rounds: its streams and its blocks are addressed by number, so that fiber n is found
//! without the n − 1 before it. Its raw words are a published standard; what makes doubles of them is ours, since the
//! distributions of a library may change from one version to the next, and with them every sampled answer.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// 32-bit words in a block of ChaCha: room for eight numbers of 53 bits.
const WORDS: u128 = 16;

/// `N` ≤ 8 uniform numbers in [0, 1): the first of block `index` in a stream of this seed.
pub(crate) fn uniforms<const N: usize>(seed: u64, stream: u64, index: u64) -> [f64; N] {
    const { assert!(N as u128 * 2 <= WORDS) };
    let mut generator = block(seed, stream, index);
    std::array::from_fn(|_| (generator.next_u64() >> 11) as f64 * (1.0 / (1u64 << 53) as f64))
}

/// The generator at the start of a block. The seed is the low end of the key, the rest of which is zero.
fn block(seed: u64, stream: u64, index: u64) -> ChaCha8Rng {
    let mut key = [0; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    let mut generator = ChaCha8Rng::from_seed(key);
    generator.set_stream(stream);
    generator.set_word_pos(u128::from(index) * WORDS);
    generator
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J. Strömbergson, Test Vectors for the Stream Cipher ChaCha, draft-strombergson-chacha-test-vectors-01: 256-bit
    /// key, 8 rounds, first block of TC1 (key and IV zero), TC2 (first byte of the key 1) and TC3 (first of the IV 1).
    #[test]
    fn words_are_those_of_the_published_vectors() {
        for ((seed, stream), expected) in [
            (
                (0, 0),
                "3e00ef2f895f40d67f5bb8e81f09a5a12c840ec3ce9a7f3b181be188ef711a1e\
                 984ce172b9216f419f445367456d5619314a42a3da86b001387bfdb80e0cfe42",
            ),
            (
                (1, 0),
                "cf5ee9a0494aa9613e05d5ed725b804b12f4a465ee635acc3a311de8740489ea\
                 289d04f43c7518db56eb4433e498a1238cd8464d3763ddbb9222ee3bd8fae3c8",
            ),
            (
                (0, 1),
                "2b8f4bb3798306ca5130d47c4f8d4ed13aa0edccc1be6942090faeeca0d7599b\
                 7ff0fe616bb25aa0153ad6fdc88b954903c22426d478b97b22b8f9b1db00cf06",
            ),
        ] {
            let mut found = [0; 64];
            block(seed, stream, 0).fill_bytes(&mut found);
            assert_eq!(found.map(|byte| format!("{byte:02x}")).concat(), expected, "seed {seed}, stream {stream}");
        }
    }

    #[test]
    fn first_shifts() {
        // Of the first words of the vectors above: 0xd6405f89_2fef003e and 0xa1a5091f_e8b85b7f.
        let shift = |word: u64| (word >> 11) as f64 / 2f64.powi(53);
        assert_eq!(uniforms(0, 0, 0), [shift(0xd640_5f89_2fef_003e), shift(0xa1a5_091f_e8b8_5b7f)]);
        assert_eq!(uniforms(0, 0, 0), [0.836_919_756_882_647_2, 0.631_424_494_066_523_1]);
    }

    #[test]
    fn blocks_follow_one_another() {
        let mut words = block(3, 5, 0);
        for index in 0..20 {
            for found in uniforms::<8>(3, 5, index) {
                assert_eq!(found, (words.next_u64() >> 11) as f64 / 2f64.powi(53));
            }
        }
        assert_eq!(uniforms::<8>(3, 5, u64::MAX), uniforms::<8>(3, 5, u64::MAX));
    }

    #[test]
    fn moments_are_those_of_the_uniform_distribution() {
        let n = 100_000;
        for (seed, stream) in [(0, 0), (0, 1), (1, 0), (u64::MAX, 7)] {
            let x: Vec<f64> = (0..n / 8).flat_map(|i| uniforms::<8>(seed, stream, i)).collect();
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
