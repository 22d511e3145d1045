//! C<sub>D</sub> at a Reynolds number: one enum of named laws.
