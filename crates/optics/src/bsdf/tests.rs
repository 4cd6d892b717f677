//! Scattering held against what must be true of any surface.
