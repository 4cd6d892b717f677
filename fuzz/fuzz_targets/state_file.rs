//! State files: whatever the bytes, a whole state or an error. What is read is written as the same bytes.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use vitrine_formats::state_file::{encode_state, mend_checksum, parse_state};

fuzz_target!(|data: &[u8]| {
    check(data);
    // With the checksum right, the reader has to look at the rest itself.
    let mut mended = data.to_vec();
    mend_checksum(&mut mended);
    check(&mended);
});

fn check(data: &[u8]) {
    if let Ok(state) = parse_state(data, Path::new("state")) {
        assert_eq!(state.film.image().pixels.len(), state.film.region().pixels());
        let _ = (state.film.noise(), state.film.layers());
        assert_eq!(encode_state(&state), data);
    }
}
