//! The listener: samples in, trains out.
