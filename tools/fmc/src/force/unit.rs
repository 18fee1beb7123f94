//! The unit of length of a mesh, and those that follow from it.

use clap::ValueEnum;

/// Unit of length of the coordinates.
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Unit {
    /// Metres
    #[default]
    M,
    /// Centimetres
    Cm,
    /// Millimetres
    Mm,
    /// Micrometres
    Um,
    /// Inches
    In,
}

/// Names of the units of a result.
pub(super) struct Units {
    pub(super) length: String,
    pub(super) area: String,
    pub(super) volume: String,
    pub(super) force: String,
    pub(super) moment: String,
    pub(super) energy: String,
    /// Meaning of the numbers, as a sentence.
    pub(super) in_words: String,
}

impl Unit {
    /// Units of a result in two or three dimensions.
    pub(super) fn units(self, dim: usize) -> Units {
        let (length, plural, one, force, forces) = match self {
            Unit::M => ("m", "metres", "metre", "N", "newtons"),
            Unit::Cm => ("cm", "centimetres", "centimetre", "N", "newtons"),
            Unit::Mm => ("mm", "millimetres", "millimetre", "N", "newtons"),
            Unit::Um => ("µm", "micrometres", "micrometre", "N", "newtons"),
            Unit::In => ("in", "inches", "inch", "lbf", "pounds-force"),
        };
        let joule = if self == Unit::M { "J".to_owned() } else { format!("{force}·{length}") };
        let pressure = match self {
            Unit::M => "Pa".to_owned(),
            Unit::Mm => "MPa".to_owned(),
            Unit::In => "psi".to_owned(),
            _ => format!("{force}/{length}²"),
        };
        let in_words = format!(
            "lengths in {plural}, forces in {forces}{}; K in {forces} per cubic {one}, which is {pressure}/{length} (law volume, exponent 1: \
             in {forces} per square {one}, which is {pressure})",
            if dim == 2 { format!(" per {one} of thickness") } else { String::new() },
        );
        let (area, volume) = (format!("{length}²"), format!("{length}³"));
        let length = length.to_owned();
        if dim == 2 {
            let (force, energy) = (format!("{force}/{length}"), format!("{joule}/{length}"));
            let moment = force.split('/').next().unwrap_or_default().to_owned();
            return Units { area: length.clone(), volume: area, length, force, moment, energy, in_words };
        }
        let moment = format!("{force}·{length}");
        Units { length, area, volume, force: force.to_owned(), moment, energy: joule, in_words }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_follow_from_the_length() {
        let Units { length, area, volume, force, moment, energy, in_words } = Unit::Mm.units(3);
        assert_eq!([length, area, volume, force, moment, energy].join(" "), "mm mm² mm³ N N·mm N·mm");
        assert!(
            in_words.contains("millimetres") && in_words.contains("cubic millimetre") && in_words.contains("MPa/mm")
        );
        let Units { area, volume, force, moment, energy, in_words, .. } = Unit::M.units(2);
        assert_eq!([area, volume, force, moment, energy].join(" "), "m m² N/m N J/m");
        assert!(in_words.contains("per metre of thickness") && in_words.contains("Pa/m"), "{in_words}");
    }
}
