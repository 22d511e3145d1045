//! Numbers in words.

/// These numbers one after the other; of many, the first.
pub(crate) fn list(numbers: &[usize]) -> String {
    /// So many are read at a glance.
    const MOST: usize = 12;
    let shown: Vec<String> = numbers.iter().take(MOST).map(ToString::to_string).collect();
    let shown = shown.join(", ");
    match numbers.len().saturating_sub(MOST) {
        0 => shown,
        more => format!("{shown} and {more} more"),
    }
}

#[cfg(test)]
mod tests {
    use super::list;

    #[test]
    fn a_long_list_is_cut() {
        assert_eq!(list(&[3, 5, 8]), "3, 5, 8");
        let many: Vec<usize> = (1..=1000).collect();
        let words = list(&many);
        assert!(words.ends_with("11, 12 and 988 more"), "{words}");
    }
}
