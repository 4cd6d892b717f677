//! What light does at a surface: reflection, refraction, highlights. Directions and numbers only; no scene, no rays.

pub mod connect;
mod fresnel;
mod phong;
mod refraction;

pub use fresnel::normal_reflectance;
pub use phong::{PhongSurface, phong_light};
pub use refraction::{reflect, refract};
