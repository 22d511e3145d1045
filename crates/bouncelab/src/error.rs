//! What can go wrong in the science.
