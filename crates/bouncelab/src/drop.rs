//! A whole history: release to rest.
