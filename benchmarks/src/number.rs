//! Numbers as text.

/// So many decimals, but no zeros at the end.
pub(crate) fn trimmed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// So many significant digits, eight decimals at most, and no zeros at the end.
pub(crate) fn significant(x: f64, digits: i32) -> String {
    if x == 0.0 {
        return "0".into();
    }
    trimmed(x, (digits - 1 - x.abs().log10().floor() as i32).clamp(0, 8) as usize)
}

/// A whole number, raised.
pub(crate) fn superscript(number: &str) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        _ => char::from_u32('⁰' as u32 + c as u32 - '0' as u32).unwrap_or(c),
    };
    number.chars().map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_end_with_a_digit_that_says_something() {
        assert_eq!(
            [0.0, 668.91234, 1e-3, 360_123.4, -0.02].map(|x| significant(x, 6)),
            ["0", "668.912", "0.001", "360123", "-0.02"]
        );
        assert_eq!([trimmed(0.25, 4), trimmed(100.0, 4), trimmed(100.0, 0)], ["0.25", "100", "100"]);
        assert_eq!(superscript("-12"), "⁻¹²");
    }
}
