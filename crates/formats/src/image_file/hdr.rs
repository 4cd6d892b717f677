//! Radiance HDR: linear light with 8 bits a channel and a common exponent (Ward, "Real Pixels", Graphics Gems II);
//! metadata as lines of the header.

use super::{ImageFormat, WriteOptions, one_line};
use vitrine_film::Image;
use vitrine_math::Rgb;

/// The entry of the register.
pub const FORMAT: ImageFormat = ImageFormat { name: "Radiance HDR", extensions: &["hdr"], encode };

/// Widths whose rows are run-length encoded, by the format's definition.
const ENCODED_WIDTHS: std::ops::Range<usize> = 8..32_768;
/// The exponent that is written as 1.
const LEAST_EXPONENT: i32 = -127;
/// The shortest run that saves anything.
const MIN_RUN: usize = 4;

fn encode(image: &Image, options: &WriteOptions) -> Result<Vec<u8>, String> {
    let [width, height] = image.size;
    let mut file = b"#?RADIANCE\n".to_vec();
    for (key, text) in &options.metadata {
        // The format's own word.
        let key = if key == "Software" { "SOFTWARE" } else { key };
        file.extend(format!("{key}={}\n", one_line(text)).bytes());
    }
    file.extend(format!("FORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n").bytes());
    let width = width as usize;
    for row in image.pixels.chunks_exact(width) {
        let texels = row.iter().map(|p| rgbe(*p));
        if ENCODED_WIDTHS.contains(&width) {
            let texels: Vec<_> = texels.collect();
            file.extend([2, 2, (width >> 8) as u8, width as u8]);
            for channel in 0..4 {
                let values: Vec<u8> = texels.iter().map(|t| t[channel]).collect();
                encode_runs(&values, &mut file);
            }
        } else {
            file.extend(texels.flatten());
        }
    }
    Ok(file)
}

/// Mantissas and the common exponent, rounded to nearest. What is negative or no number becomes 0.
fn rgbe(color: Rgb) -> [u8; 4] {
    let channels = color.to_array().map(|c| if c > 0.0 { f64::from(c.min(f32::MAX)) } else { 0.0 });
    let largest = channels.into_iter().fold(0.0, f64::max);
    // largest = m · 2^e, m in [0.5, 1): e is the float's own exponent, which starts from 1023 for [1, 2).
    let mut exponent = (largest.to_bits() >> 52) as i32 - 1022;
    // A mantissa that would round up to 256 takes the next exponent.
    if (largest * power_of_two(8 - exponent)).round() > 255.0 {
        exponent += 1;
    }
    if exponent < LEAST_EXPONENT {
        return [0; 4];
    }
    let exponent = exponent.min(LEAST_EXPONENT + 254);
    let scale = power_of_two(8 - exponent);
    let [r, g, b] = channels.map(|c| (c * scale).round().min(255.0) as u8);
    [r, g, b, (exponent - LEAST_EXPONENT + 1) as u8]
}

/// 2^n for n from −1022 to 1023.
fn power_of_two(n: i32) -> f64 {
    f64::from_bits(((n + 1023) as u64) << 52)
}

/// Runs as 128 + length and the value; other values after their count.
fn encode_runs(values: &[u8], file: &mut Vec<u8>) {
    const MAX_RUN: usize = 127;
    const MAX_COUNT: usize = 128;
    let run_at = |v: &[u8]| v.iter().take(MAX_RUN).take_while(|b| **b == v[0]).count();
    let mut rest = values;
    while !rest.is_empty() {
        let run = run_at(rest);
        let count = if run >= MIN_RUN {
            file.extend([128 + run as u8, rest[0]]);
            run
        } else {
            let most = rest.len().min(MAX_COUNT);
            let count = (1..most).find(|i| run_at(&rest[*i..]) >= MIN_RUN).unwrap_or(most);
            file.push(count as u8);
            file.extend(&rest[..count]);
            count
        };
        rest = &rest[count..];
    }
}
