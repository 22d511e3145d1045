//! The report of a recording.

use std::path::{Path, PathBuf};

use bouncelab::settings::Setup;
use bouncelab_report::file::Outputs;
use bouncelab_report::report::{self, Page, Provenance, ReportInput};
use bouncelab_session::hash::hash_of_file;
use clap::Args;

use super::read::Analysed;
use crate::failure::Failure;
use crate::language::{text, translator};
use crate::report::{ReportFile, provenance};

/// Whether there is a report, and of which form.
#[derive(Args)]
pub(super) struct ReportArguments {
    /// Write a report of one recording: .html (one file), .md (with its figures in a folder) or .pdf (printed by an installed
    /// Chromium, Chrome or Edge)
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Unfold the details of the report (every table and figure, the formulas), so that it prints them too
    #[arg(long, requires = "report")]
    report_details: bool,
}

impl ReportArguments {
    /// Where the report of these recordings goes, if one is requested.
    pub(super) fn file<'a>(
        &self,
        recordings: &[PathBuf],
        outputs: &'a Outputs,
    ) -> Result<Option<ReportFile<'a>>, Failure> {
        match (&self.report, recordings) {
            (None, _) => Ok(None),
            (Some(path), [_]) => ReportFile::new(path, outputs).map(Some),
            (Some(_), _) => Err(Failure::Usage(text("analyze-one-report"))),
        }
    }

    /// The page of the result of a file.
    pub(super) fn page(
        &self,
        path: &Path,
        analysed: &Analysed,
        physics: &Setup,
    ) -> Result<Page, Failure> {
        let recording = ReportInput {
            name: &analysed.name,
            setup: physics,
            result: &analysed.result,
        };
        let provenance = Provenance {
            files: vec![(analysed.name.clone(), hash_of_file(path)?.to_string())],
            ..provenance()
        };
        let page = report::of_recording(&recording, &provenance, translator());
        Ok(Page {
            unfolded: self.report_details,
            ..page
        })
    }
}
