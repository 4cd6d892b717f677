//! "Did you mean …?"

/// Nobody mistypes anything longer, and to compare it would be slow.
const MAX_BYTES: usize = 200;

/// The candidate that the text most likely means, or None when none is near.
#[must_use]
pub fn closest<'a>(text: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if text.len() > MAX_BYTES {
        return None;
    }
    let text = text.to_lowercase();
    candidates
        .into_iter()
        .filter(|c| c.len() <= MAX_BYTES)
        .map(|c| (strsim::jaro_winkler(&text, &c.to_lowercase()), c))
        .filter(|(score, _)| *score > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, c)| c)
}

#[cfg(test)]
mod tests {
    use super::closest;

    #[test]
    fn finds_the_slip_and_not_the_stranger() {
        let keys = ["radius", "position", "turn_deg", "material"];
        assert_eq!(closest("raduis", keys), Some("radius"));
        assert_eq!(closest("turn", keys), Some("turn_deg"));
        assert_eq!(closest("Material", keys), Some("material"));
        assert_eq!(closest("xyz", keys), None);
    }
}
