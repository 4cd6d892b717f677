//! Pictures as the least format for floats that viewers know: PFM (Debevec). "PF", width and height, "-1.0" for little-endian
//! numbers, each line ended by a line feed; then three floats a pixel, the lowest row first.

use vitrine_math::Rgb;

/// The file's bytes, from pixels row by row from the top.
pub fn write(size: [u32; 2], pixels: &[Rgb]) -> Vec<u8> {
    let [width, height] = size;
    let mut bytes = format!("PF\n{width} {height}\n-1.0\n").into_bytes();
    for row in pixels.chunks(width as usize).rev() {
        bytes.extend(row.iter().flat_map(|c| c.to_array()).flat_map(f32::to_le_bytes));
    }
    bytes
}

/// The size, and the pixels row by row from the top; None: it is no such file.
pub fn read(bytes: &[u8]) -> Option<([u32; 2], Vec<Rgb>)> {
    let mut parts = bytes.splitn(4, |b| *b == b'\n');
    let (kind, size, order, data) = (parts.next()?, parts.next()?, parts.next()?, parts.next()?);
    let (width, height) = std::str::from_utf8(size).ok()?.split_once(' ')?;
    let size = [width.parse().ok()?, height.parse().ok()?];
    if kind != b"PF" || order != b"-1.0" || data.len() != (size[0] * size[1]) as usize * 12 {
        return None;
    }
    let (floats, _) = data.as_chunks::<4>();
    let floats: Vec<f32> = floats.iter().map(|b| f32::from_le_bytes(*b)).collect();
    let pixels: Vec<_> = floats.chunks(3).map(|c| Rgb::new(c[0], c[1], c[2])).collect();
    Some((size, pixels.chunks(size[0] as usize).rev().flatten().copied().collect()))
}

#[test]
fn what_is_written_is_read() {
    let pixels: Vec<_> = (0..6).map(|k| Rgb::new(k as f32, -0.1, 1e9)).collect();
    let bytes = write([2, 3], &pixels);
    assert_eq!(read(&bytes), Some(([2, 3], pixels)));
    assert_eq!(read(&bytes[..bytes.len() - 1]), None);
}
