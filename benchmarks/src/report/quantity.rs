//! Numbers as they are read.

use crate::number::{significant, superscript};

/// A unit in which some numbers of one kind read well.
pub(super) struct Scale {
    factor: f64,
    unit: String,
    digits: i32,
}

/// Digits of a figure, and of one that should be zero.
const DIGITS: i32 = 5;
const ERROR_DIGITS: i32 = 2;

impl Scale {
    /// For numbers as large as `largest` in an SI unit; those without a unit in per cent if `percent`.
    pub(super) fn of(largest: f64, unit: &str, percent: bool) -> Self {
        let plain = |factor: f64, unit: &str| Self { factor, unit: unit.to_owned(), digits: DIGITS };
        if unit.is_empty() {
            return if percent { plain(100.0, "%") } else { plain(1.0, "") };
        }
        // Pa/m and the like start with the unit that takes the prefix; kg has one already.
        let prefixes = [(1e9, "G"), (1e6, "M"), (1e4, "k"), (0.1, ""), (1e-4, "m"), (1e-7, "µ"), (1e-10, "n")];
        let found = prefixes.into_iter().find(|(least, _)| largest >= *least);
        let (_, prefix) = found.filter(|_| !unit.starts_with("kg")).unwrap_or((0.1, ""));
        let factor = match prefix {
            "G" => 1e-9,
            "M" => 1e-6,
            "k" => 1e-3,
            "m" => 1e3,
            "µ" => 1e6,
            "n" => 1e9,
            _ => 1.0,
        };
        plain(factor, &format!("{prefix}{unit}"))
    }

    /// The same for errors, of which the first digits say everything.
    pub(super) fn of_errors(self) -> Self {
        Self { digits: ERROR_DIGITS, ..self }
    }

    /// A number with its unit.
    pub(super) fn with_unit(&self, value: f64) -> String {
        // The sign of per cent and the unit stay with their number at the end of a line.
        if self.unit.is_empty() { self.bare(value) } else { format!("{}\u{a0}{}", self.bare(value), self.unit) }
    }

    /// A number alone.
    pub(super) fn bare(&self, value: f64) -> String {
        digits(self.factor * value, self.digits)
    }
}

/// A number with so many significant digits, without zeros at its end.
pub(super) fn digits(x: f64, count: i32) -> String {
    let text = match x.abs() {
        0.0 => "0".to_owned(),
        size if !size.is_finite() => return "no number".into(),
        size if (1e-4..1e7).contains(&size) => significant(x, count),
        _ => {
            let text = format!("{x:.1e}");
            let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            let mantissa = mantissa.strip_suffix(".0").unwrap_or(mantissa);
            format!("{mantissa}·10{}", superscript(exponent))
        }
    };
    text.replace('-', "−")
}

/// Seconds as they are read.
pub(super) fn seconds(x: f64) -> String {
    match x {
        x if x < 0.995 => format!("{x:.2}\u{a0}s"),
        x if x < 99.5 => format!("{}\u{a0}s", digits(x, 2)),
        x => format!("{:.0}\u{a0}min {:02.0}\u{a0}s", (x / 60.0).floor(), (x % 60.0).floor()),
    }
}

/// A whole number in groups of three digits.
pub(super) fn count(x: u64) -> String {
    let digits = x.to_string();
    let groups: Vec<&str> = digits.as_bytes().rchunks(3).rev().filter_map(|g| std::str::from_utf8(g).ok()).collect();
    groups.join("\u{a0}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        let read = |x: f64, unit: &str, percent| Scale::of(x.abs(), unit, percent).with_unit(x).replace('\u{a0}', " ");
        assert_eq!(read(669.71234, "N s/m", false), "669.71 N s/m");
        assert_eq!(read(366_123.0, "N/m", false), "366.12 kN/m");
        assert_eq!(read(4.279e-5, "s", false), "42.79 µs");
        assert_eq!(read(6.28e-3, "s", false), "6.28 ms");
        assert_eq!(read(0.68083, "m", false), "0.68083 m");
        assert_eq!(read(-0.0080, "", true), "−0.8 %");
        assert_eq!(Scale::of(0.1, "", true).of_errors().bare(4.0915e-5), "0.0041");
        assert_eq!(read(4.4e-15, "", false), "4.4·10⁻¹⁵");
        assert_eq!(
            [count(1_800), count(12), count(1_000_000)].map(|t| t.replace('\u{a0}', " ")),
            ["1 800", "12", "1 000 000"]
        );
        assert_eq!(
            [seconds(0.123), seconds(2.531), seconds(130.0)].map(|t| t.replace('\u{a0}', " ")),
            ["0.12 s", "2.5 s", "2 min 10 s"]
        );
    }
}
