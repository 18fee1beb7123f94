//! The 256 colours of an animation.

use colorous::VIRIDIS;
use std::collections::HashMap;

/// Entries of the colour map (and of its darker copy for the lines between cells) and of greys for text. Few enough
/// that most cells keep their colour from frame to frame, which makes the file small.
const MAPPED: usize = 40;
const GREYS: usize = 31;

/// Index of the entry that means "as before".
pub(super) const UNCHANGED: u8 = 255;

/// How much darker the lines between cells are.
const LINE_SHADE: f64 = 0.82;

/// Colours and the way back from a colour to its entry.
pub(super) struct Palette {
    colors: Vec<[u8; 3]>,
    entries: HashMap<[u8; 3], u8>,
}

impl Palette {
    pub(super) fn new() -> Self {
        let part = |index: usize, count: usize| index as f64 / (count - 1) as f64;
        let mut colors: Vec<[u8; 3]> = (0..MAPPED).map(|index| color(part(index, MAPPED))).collect();
        colors.extend((0..MAPPED).map(|index| line_color(part(index, MAPPED))));
        colors.extend((0..GREYS).map(|index| [(255.0 * part(index, GREYS)).round() as u8; 3]));
        colors.resize(256, [0; 3]); // the last is UNCHANGED
        Self { colors, entries: HashMap::new() }
    }

    /// Red, green and blue of all entries.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.colors.concat()
    }

    /// The nearest entry.
    pub(super) fn entry(&mut self, color: [u8; 3]) -> u8 {
        let colors = &self.colors[..UNCHANGED as usize];
        *self.entries.entry(color).or_insert_with(|| {
            let distance = |other: &[u8; 3]| (0..3).map(|k| (i32::from(color[k]) - i32::from(other[k])).pow(2)).sum();
            let nearest = (0u8..).zip(colors).min_by_key(|(_, other)| -> i32 { distance(other) });
            nearest.map_or(0, |(index, _)| index)
        })
    }
}

/// Colour of a value between 0 and 1, one of the palette.
pub(super) fn color(value: f64) -> [u8; 3] {
    let steps = (MAPPED - 1) as f64;
    VIRIDIS.eval_continuous((value.clamp(0.0, 1.0) * steps).round() / steps).into_array()
}

/// Colour of the lines around a cell of that value.
pub(super) fn line_color(value: f64) -> [u8; 3] {
    color(value).map(|k| (f64::from(k) * LINE_SHADE).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_values_are_in_the_palette() {
        let mut palette = Palette::new();
        assert_eq!(palette.colors.len(), 256);
        for value in [0.0, 0.1, 0.333, 0.9, 1.0, 7.0] {
            for color in [color(value), line_color(value), [255; 3], [0; 3]] {
                let entry = palette.entry(color);
                assert_eq!(palette.colors[entry as usize], color);
                assert_ne!(entry, UNCHANGED);
            }
        }
    }
}
