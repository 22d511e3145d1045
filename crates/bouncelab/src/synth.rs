//! A history as sound, with noise of known strength.
