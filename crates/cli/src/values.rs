//! Values on the command line: sizes, regions, numbers with the ranges that the scene allows.

use std::time::Duration;
use vitrine::Region;
use vitrine::formats::BitDepth;
use vitrine::scene::params::Value;
use vitrine::scene::{Cause, ParamKind, ParamSpec, Settings};

/// More threads than this help nobody.
const MOST_THREADS: usize = 1024;

/// The value of a setting that is a whole number, checked as in a scene file.
fn whole_number(key: &str, text: &str) -> Result<u32, String> {
    let spec = setting(key);
    let number: i64 = text.parse().map_err(|_| format!("it takes {}", spec.allowed()))?;
    spec.check(&Value::Integer(number)).map_err(|_| format!("it takes {}", spec.allowed()))?;
    u32::try_from(number).map_err(|_| format!("it takes {}", spec.allowed()))
}

fn setting(key: &str) -> &'static ParamSpec {
    Settings::SPECS.iter().find(|s| s.name == key).expect("the settings have this key")
}

/// Rays through each pixel.
pub fn samples(text: &str) -> Result<u32, String> {
    whole_number("samples", text)
}

/// Reflection depth.
pub fn depth(text: &str) -> Result<u32, String> {
    whole_number("depth", text)
}

/// Seed.
pub fn seed(text: &str) -> Result<u32, String> {
    whole_number("seed", text)
}

/// The value of a setting that is a number, checked as in a scene file.
fn number(key: &str, text: &str) -> Result<f32, String> {
    let spec = setting(key);
    let wrong = || format!("it takes {}", spec.allowed());
    let number: f32 = text.trim().parse().map_err(|_| wrong())?;
    spec.check(&Value::Number(number)).map_err(|_| wrong())?;
    Ok(number)
}

/// The noise at which a picture is clean enough.
pub fn noise(text: &str) -> Result<f32, String> {
    number("noise", text)
}

/// The longest time for a picture, seconds.
pub fn time(text: &str) -> Result<f32, String> {
    number("time_limit", text)
}

/// Stops.
pub fn exposure(text: &str) -> Result<f32, String> {
    number("exposure", text)
}

/// Kelvin.
pub fn white_balance(text: &str) -> Result<f32, String> {
    number("white_balance", text)
}

/// Seconds between two times; 0 stands for never.
pub fn pause(text: &str) -> Result<Duration, String> {
    let seconds = text.trim().parse().ok().and_then(|s| Duration::try_from_secs_f64(s).ok());
    seconds.ok_or_else(|| "it takes seconds such as 30, or 0 for never".into())
}

/// "809x817", with x, X or ×.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let spec = setting("size");
    let ParamKind::Size { min, max } = spec.kind else { unreachable!("the size is a size") };
    let wrong = || format!("it takes WIDTHxHEIGHT such as 1920x1080, each from {min} to {max}");
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
    let parse = |text: &str| text.trim().parse::<i64>().map_err(|_| wrong());
    let (width, height) = (parse(width)?, parse(height)?);
    spec.check(&Value::Size([width, height])).map_err(|_| wrong())?;
    let size = [width, height].map(|v| u32::try_from(v).unwrap_or(u32::MAX));
    if u64::from(size[0]) * u64::from(size[1]) > Settings::MAX_PIXELS {
        let cause = Cause::PictureTooLarge { width: size[0], height: size[1] };
        return Err(format!("{cause}; {}", cause.help()));
    }
    Ok(size)
}

/// "X,Y,W,H" in pixels from the upper left corner.
pub fn region(text: &str) -> Result<Region, String> {
    let numbers: Result<Vec<u32>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[x, y, width, height]) if width > 0 && height > 0 => Ok(Region { x, y, width, height }),
        _ => Err("it takes X,Y,W,H: the left upper corner, the width and the height, in pixels such as \
                  100,50,400,300"
            .into()),
    }
}

/// Bits for each colour.
pub fn bits(text: &str) -> Result<BitDepth, String> {
    match text {
        "8" => Ok(BitDepth::Eight),
        "16" => Ok(BitDepth::Sixteen),
        _ => Err("it takes 8 or 16".into()),
    }
}

/// A number of threads; 0 stands for all.
pub fn threads(text: &str) -> Result<usize, String> {
    let number = text.trim().parse().ok().filter(|n| *n <= MOST_THREADS);
    number.ok_or_else(|| format!("it takes a whole number from 1 to {MOST_THREADS}, or 0 for all cores"))
}

/// A number of threads, and not "all".
pub fn thread_count(text: &str) -> Result<usize, String> {
    let number = text.trim().parse().ok().filter(|n| (1..=MOST_THREADS).contains(n));
    number.ok_or_else(|| format!("it takes whole numbers from 1 to {MOST_THREADS} such as 1,2,4"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!(size("809x817"), Ok([809, 817]));
        assert_eq!(size("10×20"), Ok([10, 20]));
        for bad in ["", "10", "0x10", "-5x10", "10x", "1e3x5", "99999x1", "32768x32768", "nanx1"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn numbers_have_the_ranges_of_the_scene() {
        assert_eq!(samples("16"), Ok(16));
        for bad in ["0", "-3", "1.5", "99999999999999999999", ""] {
            assert!(samples(bad).is_err(), "{bad}");
        }
        assert_eq!(depth("0"), Ok(0));
        assert!(depth("33").is_err());
        assert_eq!(seed("4294967295"), Ok(u32::MAX));
    }

    #[test]
    fn noise_time_and_light() {
        assert_eq!((noise("0.02"), time("90"), exposure("-1.5")), (Ok(0.02), Ok(90.0), Ok(-1.5)));
        assert_eq!(white_balance("3000"), Ok(3000.0));
        for bad in ["", "nan", "inf", "x", "-0.1", "2"] {
            assert!(noise(bad).is_err(), "{bad}");
        }
        assert!(time("-1").is_err() && exposure("100").is_err() && white_balance("10").is_err());
        assert_eq!((pause("0"), pause("0.5")), (Ok(Duration::ZERO), Ok(Duration::from_millis(500))));
        assert!(pause("-1").is_err() && pause("nan").is_err() && pause("1e300").is_err());
    }

    #[test]
    fn regions_and_threads() {
        assert_eq!(region("1,2,3,4"), Ok(Region { x: 1, y: 2, width: 3, height: 4 }));
        for bad in ["1,2,3", "1,2,0,4", "-1,2,3,4", "1,2,3,4,5", ""] {
            assert!(region(bad).is_err(), "{bad}");
        }
        assert_eq!((threads("0"), thread_count("3")), (Ok(0), Ok(3)));
        assert!(threads("-1").is_err() && threads("100000").is_err() && thread_count("0").is_err());
    }
}
