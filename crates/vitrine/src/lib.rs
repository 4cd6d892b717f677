//! Vitrine: load a scene, render it, save the picture.
