//! MTL materials: whatever the bytes, every value is one that a scene file could state.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use vitrine_formats::mesh_file::mtl;
use vitrine_scene::{Material, Params};

fuzz_target!(|data: &[u8]| {
    let Ok((materials, _)) = mtl::parse(data, Path::new("library.mtl")) else { return };
    for entry in &materials {
        for spec in Material::SPECS {
            let value = entry.material.get(spec.name).expect("every parameter has a value");
            assert_eq!(spec.check(&value), Ok(()), "{} = {value:?}", spec.name);
        }
    }
});
