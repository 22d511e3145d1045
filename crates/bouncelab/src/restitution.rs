//! Drag-corrected restitution of each impact.
