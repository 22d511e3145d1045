//! Formats signs and exponents of numbers.

/// A number with a true minus sign, and none before zero.
pub(crate) fn with_minus(number: &str) -> String {
    let is_zero = number.chars().all(|c| matches!(c, '-' | '0' | '.'));
    number.replace('-', if is_zero { "" } else { "−" })
}

/// The exponent in raised digits.
pub(crate) fn superscript(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    exponent
        .to_string()
        .chars()
        .map(|c| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign_and_others_a_true_one() {
        assert_eq!(with_minus("-0.00"), "0.00");
        assert_eq!(with_minus("-0.01"), "−0.01");
        assert_eq!(superscript(-12), "⁻¹²");
    }
}
