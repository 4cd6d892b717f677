//! PNG and JPEG pictures: whatever the bytes, a whole picture or an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use vitrine_formats::image_file::parse_picture;

fuzz_target!(|data: &[u8]| {
    if let Ok(picture) = parse_picture(data, Path::new("picture")) {
        let [width, height] = picture.size.map(|s| s as usize);
        assert!(width > 0 && height > 0);
        assert_eq!(picture.texels.len(), width * height);
    }
});
