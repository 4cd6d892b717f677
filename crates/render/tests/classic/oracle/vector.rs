//! Vectors in double precision.

use std::ops::{Add, Mul, Neg, Sub};
use vitrine_math::{Rgb, Vec3};

/// A point, a direction or a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct D3(pub [f64; 3]);

impl D3 {
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self([x, y, z])
    }

    pub fn of(v: Vec3) -> Self {
        Self(v.to_array().map(f64::from))
    }

    pub fn of_color(c: Rgb) -> Self {
        Self(c.to_array().map(f64::from))
    }

    pub fn color(self) -> Rgb {
        Rgb::from(self.0.map(|v| v as f32))
    }

    pub fn dot(self, o: Self) -> f64 {
        (0..3).map(|k| self.0[k] * o.0[k]).sum()
    }

    pub fn cross(self, o: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, o.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    pub fn unit(self) -> Self {
        self * (1.0 / self.length())
    }

    /// Component by component.
    pub fn times(self, o: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] * o.0[k]))
    }
}

impl Add for D3 {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] + o.0[k]))
    }
}

impl Sub for D3 {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - o.0[k]))
    }
}

impl Neg for D3 {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Mul<f64> for D3 {
    type Output = Self;
    fn mul(self, s: f64) -> Self {
        Self(self.0.map(|v| v * s))
    }
}

/// The turn about X, then Y, then Z, by the matrices of the course work (section 1.5).
pub fn turned(p: D3, turn_deg: Vec3) -> D3 {
    let [a, b, c] = turn_deg.to_array().map(|v| f64::from(v).to_radians());
    let [x, y, z] = p.0;
    let (y, z) = (y * a.cos() - z * a.sin(), y * a.sin() + z * a.cos());
    let (x, z) = (x * b.cos() + z * b.sin(), -x * b.sin() + z * b.cos());
    let (x, y) = (x * c.cos() - y * c.sin(), x * c.sin() + y * c.cos());
    D3::new(x, y, z)
}
