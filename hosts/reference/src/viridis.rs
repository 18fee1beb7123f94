//! The colours of values.

/// Anchors from low to high: viridis, which is even in lightness and safe for colour-blind readers.
const ANCHORS: [[u8; 3]; 9] = [
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

/// Red, green and blue of a value between 0 and 1; beyond them those of the ends.
pub fn viridis(value: f64) -> [u8; 3] {
    let place = value.clamp(0.0, 1.0) * (ANCHORS.len() - 1) as f64;
    let low = (place as usize).min(ANCHORS.len() - 2);
    let part = place - low as f64;
    std::array::from_fn(|k| {
        let [from, to] = [low, low + 1].map(|index| f64::from(ANCHORS[index][k]));
        (from + part * (to - from)).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_the_scale_are_its_anchors() {
        assert_eq!([viridis(-1.0), viridis(0.125), viridis(7.0)], [[68, 1, 84], [71, 44, 122], [253, 231, 37]]);
    }
}
