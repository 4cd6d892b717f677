use super::*;
use proptest::prelude::*;
use vitrine_film::{Keep, TileSums};

fn state(keep: Keep) -> RenderState {
    let mut film = Film::keeping(Region { x: 3, y: 5, width: 40, height: 33 }, keep);
    for (row, mut band) in film.bands().enumerate() {
        for column in 0..2 {
            let pixels = [32, 8][column] * [32, 1][row];
            let light: Vec<_> = (0..pixels).map(|i| Rgb::new(i as f32, -0.0, 1e-42)).collect();
            let seen = Features { albedo: Rgb::splat(0.3), normal: Vec3::Y, depth: 2.5 };
            let features = vec![seen; if keep == Keep::Layers { pixels } else { 0 }];
            for count in [1, 1, 2] {
                band.add_samples(column, TileSums { light: &light, features: &features }, count);
            }
        }
    }
    RenderState {
        program: "Vitrine 0.1.0".into(),
        scene: "0123abc".into(),
        settings: "depth = 3\nseed = 0\n".into(),
        film,
        rays: 1 << 40,
        bad_samples: 3,
        spent_ms: 65_000,
    }
}

fn parse(bytes: &[u8]) -> Result<RenderState, FormatError> {
    parse_state(bytes, Path::new("a.vitrine-state"))
}

#[test]
fn what_is_written_is_read() {
    for keep in [Keep::Light, Keep::Halves, Keep::Layers] {
        let state = state(keep);
        let bytes = encode_state(&state);
        let read = parse(&bytes).unwrap();
        assert!(read == state, "{keep:?}");
        assert_eq!(encode_state(&read), bytes, "to the bit");
    }
}

#[test]
fn a_file_that_is_cut_off_is_damaged() {
    let bytes = encode_state(&state(Keep::Layers));
    for length in (12..60).chain((60..bytes.len()).step_by(997)).chain([bytes.len() - 1]) {
        assert!(matches!(parse(&bytes[..length]), Err(FormatError::StateDamaged { .. })), "{length}");
    }
    for length in 0..8 {
        assert!(matches!(parse(&bytes[..length]), Err(FormatError::NotAState { .. })), "{length}");
    }
}

#[test]
fn every_changed_bit_is_found() {
    let bytes = encode_state(&state(Keep::Light));
    for place in (12..bytes.len()).step_by(101) {
        let mut changed = bytes.clone();
        changed[place] ^= 1 << (place % 8);
        assert!(matches!(parse(&changed), Err(FormatError::StateDamaged { .. })), "{place}");
    }
}

#[test]
fn other_files_and_versions_are_told_apart() {
    let mut bytes = encode_state(&state(Keep::Light));
    bytes[8] = 99;
    let error = parse(&bytes).unwrap_err();
    assert!(matches!(error, FormatError::StateOfOtherVersion { .. }), "{error}");
    assert!(error.to_string().ends_with(": a.vitrine-state"));
    assert!(!error.help().is_empty());
    assert!(matches!(parse(b"\x89PNG"), Err(FormatError::NotAState { .. })));
}

#[test]
fn a_header_that_claims_more_than_there_is_allocates_nothing() {
    let bytes = encode_state(&state(Keep::Light));
    // Lengths of texts, flags and the region's four numbers.
    for place in (12..44).step_by(4) {
        for value in [u32::MAX, 1 << 16, 11_585, 2, 0] {
            let mut changed = bytes.clone();
            changed[place..place + 4].copy_from_slice(&value.to_le_bytes());
            mend_checksum(&mut changed);
            if changed == bytes {
                continue;
            }
            if let Ok(read) = parse(&changed) {
                // The corner of the region may be anywhere.
                assert!((28..36).contains(&place), "{place} {value}: {:?}", read.film.region());
            }
        }
    }
}

proptest! {
    #[test]
    fn whatever_the_bytes_a_state_or_an_error(junk in prop::collection::vec(any::<u8>(), 0..300), at in 12..400_usize) {
        let mut bytes = encode_state(&state(Keep::Halves));
        let end = (at + junk.len()).min(bytes.len());
        bytes[at..end].copy_from_slice(&junk[..end - at]);
        mend_checksum(&mut bytes);
        if let Ok(read) = parse(&bytes) {
            prop_assert_eq!(read.film.image().pixels.len(), read.film.region().pixels());
        }
    }
}

#[test]
fn files_are_written_and_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.vitrine-state");
    let state = state(Keep::Layers);
    write_state(&path, &state).unwrap();
    assert!(read_state(&path).unwrap() == state);
    assert!(matches!(read_state(&folder.path().join("no")), Err(FormatError::Missing { .. })));
}
