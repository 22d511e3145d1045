//! The figures of an analysis, as files.

use std::collections::HashSet;
use std::path::Path;

use bouncelab::settings::Setup;
use bouncelab_report::figure::{self, FigureInput, Mark};
use bouncelab_report::file::Outputs;
use bouncelab_report::messages::Translator;
use bouncelab_report::report::MAX_DROPS_SHOWN;
use bouncelab_report::{Chart, save};

use super::read::Analysed;
use crate::failure::Failure;
use crate::language::{text_with, translator};
use crate::report::wrote_figure;
use crate::terminal::say;

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

/// Writes the figures of a recording into a folder and names them on stderr.
pub(crate) fn save_figures(
    analysed: &Analysed,
    physics: &Setup,
    folder: &Path,
    stems: &mut Stems,
    outputs: &Outputs,
) -> Result<(), Failure> {
    let stem = stems.take(&analysed.name);
    for (name, chart) in figures(analysed, physics, translator()) {
        let saved = save(&chart, folder, &format!("{stem}-{name}"), outputs)?;
        wrote_figure(&saved);
    }
    if analysed.result.drops.len() > MAX_DROPS_SHOWN {
        let shown = [("count", MAX_DROPS_SHOWN.into())];
        say(text_with("terminal-first-figures", &shown));
    }
    Ok(())
}

/// Name and chart of every figure.
fn figures(analysed: &Analysed, physics: &Setup, translator: &Translator) -> Vec<(String, Chart)> {
    let settings = &physics.options;
    let mut figures = Vec::new();
    if let Some(sound) = &analysed.result.envelope {
        let chart = figure::waveform(sound, &Mark::of_drops(&analysed.result.drops), translator);
        figures.push(("waveform".to_owned(), chart));
    }
    let drops = analysed.result.drops.iter().take(MAX_DROPS_SHOWN);
    for (index, drop) in drops.enumerate() {
        let input = FigureInput::new(drop, settings);
        figures.extend(figure::of_drop(&input).map(|figure| {
            let name = match analysed.result.drops.len() {
                1 => figure.name.to_owned(),
                _ => format!("drop{}-{}", index + 1, figure.name),
            };
            (name, figure.chart(&input, translator))
        }));
    }
    let of_air = figure::of_air(&analysed.result.drops, settings, translator);
    figures.extend(
        of_air
            .into_iter()
            .map(|(name, chart)| (name.to_owned(), chart)),
    );
    figures
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
    use bouncelab::settings::Settings;
    use bouncelab::{Options, analyze_times};

    use super::*;

    /// As many as have sections in a report.
    #[test]
    fn a_recording_of_many_drops_has_the_figures_of_the_first_hundred() {
        let options = Options::default().without_inference();
        let mut result = analyze_times(&[0.0, 0.46, 0.89, 1.29, 1.66, 2.0], &options);
        result.drops = vec![result.drops[0].clone(); 102];
        let analysed = Analysed {
            name: "class.wav".to_owned(),
            result,
        };
        let setup = Settings::default().resolve().unwrap();
        let figures = figures(&analysed, &setup, &Translator::english());
        let has = |start: &str| figures.iter().any(|(name, _)| name.starts_with(start));
        assert!(has("drop100-") && !has("drop101-"));
    }

    #[test]
    fn recordings_of_the_same_name_have_figures_of_their_own() {
        let mut stems = Stems::default();
        let names = ["a/x.wav", "b/x.wav", "x-2.wav", "c/x.flac"].map(|name| stems.take(name));
        assert_eq!(names, ["x", "x-2", "x-2-2", "x-3"]);
    }
}
