//! The paper's straight line, Eqs. 4-8.
