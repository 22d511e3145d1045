//! Numbers of JSON, where `null` is a missing number.

use serde::de::Error;
use serde::{Deserialize, Deserializer};

pub(super) fn number<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(from)?.unwrap_or(f64::NAN))
}

pub(super) fn numbers<'de, D: Deserializer<'de>>(from: D) -> Result<Vec<f64>, D::Error> {
    let numbers: Vec<Option<f64>> = Vec::deserialize(from)?;
    let numbers = numbers.into_iter();
    Ok(numbers.map(|it| it.unwrap_or(f64::NAN)).collect())
}

pub(super) fn rows<'de, D: Deserializer<'de>, const N: usize>(
    from: D,
) -> Result<Vec<[f64; N]>, D::Error> {
    let rows: Vec<Vec<Option<f64>>> = Vec::deserialize(from)?;
    let rows = rows.into_iter().map(|row| {
        let row: Vec<f64> = row.into_iter().map(|it| it.unwrap_or(f64::NAN)).collect();
        let wrong =
            |row: Vec<f64>| D::Error::invalid_length(row.len(), &"one number for each axis");
        row.try_into().map_err(wrong)
    });
    rows.collect()
}
