//! What light does at a surface: reflection, refraction, highlights. Directions and numbers only; no scene, no rays.
//!
//! The classic renderer uses [`phong_light`], [`reflect`] and [`refract`]; the photoreal one scatters light by
//! [`bsdf::Bsdf`], which stands on the other modules.

pub mod absorption;
pub mod bsdf;
pub mod connect;
pub mod dispersion;
mod energy;
pub mod fresnel;
pub mod metals;
pub mod microfacet;
pub mod phase;
mod phong;
mod refraction;
mod sampling;
mod spectrum;
pub mod thin_film;

pub use fresnel::normal_reflectance;
pub use phong::{PhongSurface, phong_light};
pub use refraction::{reflect, refract};
