//! The figures of an analysis, as files.

use std::collections::HashSet;
use std::path::Path;

use bouncelab_report::illustration::{self, Illustration};
use bouncelab_report::{Figure, save};

use super::hear::Hearing;
use crate::failure::Failure;
use crate::physics::Physics;

/// Names for figures, another for each recording: those of different folders may have the same name.
#[derive(Default)]
pub(crate) struct Stems(HashSet<String>);

impl Stems {
    /// The name of a file without folder and ending, or if that is taken the first of `name-2`,
    /// `name-3`, ... that is not.
    fn take(&mut self, name: &str) -> String {
        let plain = stem(name);
        let numbered = (2..).map(|number: u64| format!("{plain}-{number}"));
        let mut candidates = std::iter::once(plain.clone()).chain(numbered);
        let free = candidates.find(|candidate| self.0.insert(candidate.clone()));
        free.unwrap_or(plain)
    }
}

/// Writes the figures of a hearing into a folder and names them on stderr.
pub(crate) fn save_figures(
    hearing: &Hearing,
    physics: &Physics,
    folder: &Path,
    stems: &mut Stems,
) -> Result<(), Failure> {
    let stem = stems.take(&hearing.name);
    for (name, drawn) in figures(hearing, physics)? {
        let saved = save(&drawn, folder, &format!("{stem}-{name}"))?;
        eprintln!("wrote {} and .png", saved.svg.display());
    }
    Ok(())
}

/// Name and drawing of every figure.
fn figures(hearing: &Hearing, physics: &Physics) -> Result<Vec<(String, Figure)>, Failure> {
    let settings = &physics.settings;
    let mut figures = Vec::new();
    if let Some(sound) = &hearing.envelope {
        let drawn = illustration::waveform(sound, &hearing.drops)?;
        figures.push(("waveform".to_owned(), drawn));
    }
    for (index, drop) in hearing.drops.iter().enumerate() {
        let named = |Illustration { name, figure }: Illustration| match hearing.drops.len() {
            1 => (name.to_owned(), figure),
            _ => (format!("drop{}-{name}", index + 1), figure),
        };
        figures.extend(illustration::of_drop(drop, settings).into_iter().map(named));
    }
    let of_air = illustration::of_air(&hearing.drops, settings);
    figures.extend(
        of_air
            .into_iter()
            .map(|drawn| (drawn.name.to_owned(), drawn.figure)),
    );
    Ok(figures)
}

/// The name of a file without folder and ending, fit for the name of another file.
fn stem(name: &str) -> String {
    let stem = Path::new(name)
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned());
    let kept: String = stem
        .unwrap_or_default()
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || matches!(c, '-' | '_') {
                c
            } else {
                '-'
            }
        })
        .collect();
    if kept.is_empty() {
        "drop".to_owned()
    } else {
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recordings_of_the_same_name_have_figures_of_their_own() {
        let mut stems = Stems::default();
        let names = ["a/x.wav", "b/x.wav", "x-2.wav", "c/x.flac"].map(|name| stems.take(name));
        assert_eq!(names, ["x", "x-2", "x-2-2", "x-3"]);
    }
}
