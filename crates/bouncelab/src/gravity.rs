//! How hard it is pulled.
