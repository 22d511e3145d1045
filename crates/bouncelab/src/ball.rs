//! What falls: mass, diameter, presets with their source.
