//! What it falls through: density and viscosity of air.
