//! Colours of values.

use colorous::VIRIDIS;

/// Part of all values that are dimmer than the brightest colour: corners, where stress has no bound, do not dim the rest.
const BRIGHTEST: f64 = 0.99;

/// Opaque colour of a value between 0 and 1.
pub(crate) fn opaque(value: f64) -> [u8; 4] {
    let [r, g, b] = VIRIDIS.eval_continuous(value.clamp(0.0, 1.0)).into_array();
    [r, g, b, 255]
}

/// The colour of lines on a colour.
pub(crate) fn darker([r, g, b, a]: [u8; 4]) -> [u8; 4] {
    let [r, g, b] = [r, g, b].map(|c| (0.8 * f64::from(c)).round() as u8);
    [r, g, b, a]
}

/// A round number above almost all values.
pub(crate) fn brightest(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_unstable_by(f64::total_cmp);
    let value = values.get((values.len() as f64 * BRIGHTEST) as usize).copied().unwrap_or(0.0);
    if value <= 0.0 {
        return 1.0;
    }
    let decade = 10f64.powf(value.log10().floor());
    // Stress that is uniform up to rounding must not fall beyond the scale.
    let round = [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0].into_iter().find(|step| step * decade >= value * (1.0 - 1e-6));
    round.unwrap_or(10.0) * decade
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_end_at_round_numbers() {
        assert_eq!(brightest((0..1000).map(f64::from)), 1000.0);
        assert_eq!(brightest([2.99, 2.99].into_iter()), 3.0);
        assert_eq!(brightest(std::iter::empty()), 1.0);
    }
}
