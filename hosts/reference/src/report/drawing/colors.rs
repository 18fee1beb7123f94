//! Colours of values.

/// Anchors of viridis, from low to high: even in lightness, and safe for colour-blind readers.
pub(super) const VIRIDIS: [[u8; 3]; 9] = [
    [68, 1, 84],
    [71, 44, 122],
    [59, 81, 139],
    [44, 113, 142],
    [33, 144, 141],
    [39, 173, 129],
    [92, 200, 99],
    [170, 220, 50],
    [253, 231, 37],
];

/// Part of all values that are dimmer than the brightest colour: corners, where stress has no bound, do not dim the rest.
const BRIGHTEST: f64 = 0.99;

/// Colour of a value between 0 and 1.
pub(crate) fn viridis(value: f64) -> [u8; 4] {
    let place = value.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let low = (place as usize).min(VIRIDIS.len() - 2);
    let part = place - low as f64;
    let [r, g, b] = std::array::from_fn(|k| {
        let [from, to] = [low, low + 1].map(|index| f64::from(VIRIDIS[index][k]));
        (from + part * (to - from)).round() as u8
    });
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
    fn ends_of_the_scale_are_its_anchors() {
        assert_eq!([viridis(0.0), viridis(7.0)], [[68, 1, 84, 255], [253, 231, 37, 255]]);
        assert_eq!(brightest((0..1000).map(f64::from)), 1000.0);
        assert_eq!(brightest([2.99, 2.99].into_iter()), 3.0);
        assert_eq!(brightest(std::iter::empty()), 1.0);
    }
}
