//! The inference gives the numbers of the stored copy.

use std::path::Path;

use bouncelab_bench::net::{numbers_of_drops, relative_difference, stored_table};

/// Another processor or another level of optimisation may round differently.
const MAX_DIFFERENCE: f64 = 1e-9;

/// A change of the science that changes numbers on purpose stores them anew:
/// `cargo xtask net store=crates/bouncelab-bench/tests/net.csv`.
#[test]
fn numbers_of_simulated_drops_are_those_stored() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/net.csv");
    let stored = std::fs::read_to_string(path).unwrap();
    let drops = numbers_of_drops(stored.lines().count() - 1);
    let table = stored_table(&drops);
    let mut different = Vec::new();
    let mut lines = stored.lines().zip(table.lines());
    let (header, header_now) = lines.next().unwrap();
    assert_eq!(header, header_now);
    let names: Vec<&str> = header.split(',').collect();
    for (row, row_now) in lines {
        for ((name, cell), now) in names.iter().zip(row.split(',')).zip(row_now.split(',')) {
            let agree = match (cell.parse(), now.parse()) {
                (Ok(stored), Ok(now)) => relative_difference(stored, now) <= MAX_DIFFERENCE,
                _ => cell == now,
            };
            if !agree {
                different.push(format!("{row:.4} {name}: {cell} -> {now}"));
            }
        }
    }
    assert!(different.is_empty(), "{}", different.join("\n"));
}
