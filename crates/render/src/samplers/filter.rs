//! STUB
pub fn offset(u: [f32; 2]) -> [f32; 2] { [u[0] - 0.5, u[1] - 0.5] }
