//! Panoramas: whatever the bytes, a whole map of radiances or an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use vitrine_formats::image_file::parse_panorama;

fuzz_target!(|data: &[u8]| {
    if let Ok((map, _)) = parse_panorama(data, Path::new("panorama")) {
        let [width, height] = map.size.map(|s| s as usize);
        assert!(width > 0 && height > 0);
        assert_eq!(map.pixels.len(), width * height);
        assert!(map.pixels.iter().all(|p| p.is_finite() && p.to_array().iter().all(|c| *c >= 0.0)));
    }
});
