//! OBJ models: whatever the bytes, a whole model or an error. What follows a zero byte is the library of materials.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use vitrine_formats::mesh_file::obj;
use vitrine_scene::TriangleMesh;

fuzz_target!(|data: &[u8]| {
    let mut pieces = data.splitn(2, |b| *b == 0);
    let model = pieces.next().unwrap_or_default();
    let materials = pieces.next().unwrap_or_default();
    if let Ok((mesh, _)) = obj::parse(model, Path::new("model.obj"), &mut |_| Ok(materials.to_vec())) {
        check(&mesh);
    }
});

fn check(mesh: &TriangleMesh) {
    let count = mesh.positions.len();
    assert!(!mesh.triangles.is_empty());
    assert!(mesh.triangles.iter().flatten().all(|i| (*i as usize) < count));
    assert!(mesh.positions.iter().all(|p| p.is_finite()));
    assert!([0, count].contains(&mesh.normals.len()) && [0, count].contains(&mesh.uvs.len()));
    assert!(mesh.normals.iter().all(|n| n.length() == 0.0 || (n.length() - 1.0).abs() < 1e-5));
    assert!(mesh.uvs.iter().all(|uv| uv.is_finite()));
    let mut next = 0;
    for part in &mesh.parts {
        assert_eq!(part.triangles.start, next);
        assert!(part.triangles.end > next);
        assert!(part.material.is_none_or(|m| m < mesh.materials.len()));
        next = part.triangles.end;
    }
    assert_eq!(next, mesh.triangles.len());
}
