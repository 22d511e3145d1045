//! Which exception is it?
//!
//! The exceptions are classes of `bouncelab._errors`. Each is given the sentence of the error and, where the
//! science refuses, the same as data.

use bouncelab::Error;
use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, import_exception};

import_exception!(bouncelab._errors, InferenceError);
import_exception!(bouncelab._errors, InputError);
import_exception!(bouncelab._errors, OutOfRangeError);
import_exception!(bouncelab._errors, OutputError);
import_exception!(bouncelab._errors, PhysicsError);
import_exception!(bouncelab._errors, RecordingError);
import_exception!(bouncelab._errors, RecordingNotFoundError);
import_exception!(bouncelab._errors, SessionError);
import_exception!(bouncelab._errors, UnknownNameError);

/// A result whose error becomes an exception of Python.
pub(crate) type Result<T> = std::result::Result<T, Failure>;

/// Why something could not be done.
#[derive(Debug)]
pub(crate) enum Failure {
    Science(Error),
    Audio(bouncelab_audio::Error),
    Report(bouncelab_report::Error),
    Session(bouncelab_session::Error),
    /// A file cannot be written.
    Output(String),
    /// What Python was given makes no sense here.
    Input(String),
    /// An exception of Python itself: an interruption, or one of a function that reports progress.
    Python(PyErr),
}

macro_rules! failures {
    ($($variant:ident: $error:ty),*) => {$(
        impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::$variant(error)
            }
        }
    )*};
}

failures!(
    Science: Error,
    Audio: bouncelab_audio::Error,
    Report: bouncelab_report::Error,
    Session: bouncelab_session::Error,
    Python: PyErr
);

/// The package writes what is read here, so that a fault is one of values.
impl From<serde_json::Error> for Failure {
    fn from(fault: serde_json::Error) -> Self {
        Self::Input(fault.to_string())
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Science(error) | Failure::Report(bouncelab_report::Error::Physics(error)) => {
                of_science(&error)
            }
            Failure::Audio(error @ bouncelab_audio::Error::NotFound { .. }) => {
                RecordingNotFoundError::new_err(error.to_string())
            }
            Failure::Audio(error) => RecordingError::new_err(error.to_string()),
            Failure::Report(error) => OutputError::new_err(error.to_string()),
            Failure::Session(error) => SessionError::new_err(error.to_string()),
            Failure::Output(reason) => OutputError::new_err(reason),
            Failure::Input(reason) => InputError::new_err(reason),
            Failure::Python(error) => error,
        }
    }
}

fn of_science(error: &Error) -> PyErr {
    let diagnostic = match serde_json::to_string(&error.diagnostic()) {
        Ok(diagnostic) => diagnostic,
        Err(fault) => return PyValueError::new_err(fault.to_string()),
    };
    let arguments = (error.to_string(), diagnostic);
    match error {
        Error::OutOfRange { .. } => OutOfRangeError::new_err(arguments),
        Error::UnknownName { .. } => UnknownNameError::new_err(arguments),
        Error::CannotInfer(_) => InferenceError::new_err(arguments),
        _ => PhysicsError::new_err(arguments),
    }
}
