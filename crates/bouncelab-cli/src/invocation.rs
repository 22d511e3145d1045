//! How this process was started: reports quote it, and the workers of a session are started in the same way.

use std::ffi::OsString;
use std::sync::OnceLock;

/// The words that started the program.
#[derive(Clone, Debug, Default)]
pub struct Invocation {
    /// The command that starts the program, in words: a path, or an interpreter with a module.
    pub program: Vec<OsString>,
    /// The arguments that it got.
    pub arguments: Vec<OsString>,
}

static OF_THIS_PROCESS: OnceLock<Invocation> = OnceLock::new();

impl Invocation {
    /// Keeps it as that of this process; a second one is ignored.
    pub(crate) fn keep(self) -> &'static Self {
        OF_THIS_PROCESS.get_or_init(|| self)
    }

    /// That of this process.
    pub(crate) fn of_this_process() -> &'static Self {
        OF_THIS_PROCESS.get_or_init(Self::default)
    }
}
