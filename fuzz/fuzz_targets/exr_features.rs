//! OpenEXR pictures to be denoised: whatever the bytes, whole layers of one size or an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use vitrine_formats::image_file::parse_exr_features;

fuzz_target!(|data: &[u8]| {
    if let Ok(layers) = parse_exr_features(data, Path::new("picture.exr")) {
        let size = layers.light.size;
        for image in
            [Some(&layers.light), layers.albedo.as_ref(), layers.normal.as_ref()].into_iter().flatten()
        {
            assert_eq!(image.size, size);
            assert_eq!(image.pixels.len(), size[0] as usize * size[1] as usize);
        }
    }
});
