//! Scenes and helpers that the benches share.
