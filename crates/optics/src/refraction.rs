//! Mirror directions and Snell's law.

use vitrine_math::Vec3;

/// The mirror direction of `wo` at a surface with the unit normal `n`: 2N⟨N, wo⟩ − wo. Both point away from the surface.
#[inline(always)]
#[must_use]
pub fn reflect(wo: Vec3, n: Vec3) -> Vec3 {
    n * (2.0 * n.dot(wo)) - wo
}

/// The direction in which light seen along `wo` comes through a smooth surface, or None at total internal reflection.
///
/// `wo` and the unit normal `n` point to the viewer's side and are of unit length, so is the result, which points to
/// the other side. `eta` is the index on the other side over the index on the viewer's side.
#[must_use]
pub fn refract(wo: Vec3, n: Vec3, eta: f32) -> Option<Vec3> {
    let cos_i = n.dot(wo);
    // Snell: sin²θt = sin²θi / η²
    let sin2_t = (1.0 - cos_i * cos_i).max(0.0) / (eta * eta);
    if sin2_t >= 1.0 {
        return None;
    }
    let cos_t = (1.0 - sin2_t).sqrt();
    Some(n * (cos_i / eta - cos_t) - wo / eta)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at_angle_deg(angle: f32) -> Vec3 {
        let (s, c) = angle.to_radians().sin_cos();
        Vec3::new(s, c, 0.0)
    }

    #[test]
    fn refract_obeys_snell_and_stays_in_the_plane() {
        for angle in [0.0_f32, 10.0, 45.0, 80.0, 89.9] {
            let t = refract(at_angle_deg(angle), Vec3::Y, 1.5).unwrap();
            assert!((t.length() - 1.0).abs() < 1e-5);
            assert!(t.y < 0.0 && t.z == 0.0);
            let sin_t = angle.to_radians().sin() / 1.5;
            assert!((-t.x - sin_t).abs() < 1e-5, "{angle}°");
        }
    }

    #[test]
    fn total_internal_reflection_begins_at_the_critical_angle() {
        // Glass of index 1.5: 41.81°.
        assert!(refract(at_angle_deg(41.7), Vec3::Y, 1.0 / 1.5).is_some());
        assert!(refract(at_angle_deg(41.9), Vec3::Y, 1.0 / 1.5).is_none());
    }

    #[test]
    fn index_one_goes_straight_on() {
        let wo = at_angle_deg(37.0);
        let t = refract(wo, Vec3::Y, 1.0).unwrap();
        assert!((t + wo).length() < 1e-6);
    }

    #[test]
    fn reflect_mirrors_and_undoes_itself() {
        let wo = at_angle_deg(30.0);
        let wi = reflect(wo, Vec3::Y);
        assert!((wi - Vec3::new(-wo.x, wo.y, 0.0)).length() < 1e-6);
        assert!((reflect(wi, Vec3::Y) - wo).length() < 1e-6);
    }
}
