//! The classic renderer and the render job seen from outside: a scene goes in, a picture comes out.
//!
//! Tests carry the row of the course work that they show (`c8_…`, see PRODUCT.md). Proofs by formula come first, golden
//! pictures last.

mod acne;
mod agreement;
mod bad_scenes;
mod coincident;
mod common;
mod dice;
mod glass;
mod job;
mod mirrors;
mod models;
mod oracle;
mod phong;
mod pick;
mod recompile;
mod resume;
mod shadows;
mod shapes;
mod soft;
mod stopping;
mod textures;
mod views;
