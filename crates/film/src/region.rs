//! A part of a picture.

/// A part of a picture, in pixels from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Pixels from the left.
    pub x: u32,
    /// Pixels from the top.
    pub y: u32,
    /// Pixels.
    pub width: u32,
    /// Pixels.
    pub height: u32,
}

/// A region that is no part of its picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the region {},{},{},{} is empty or not inside the picture of {}×{} pixels",
    region.x, region.y, region.width, region.height, size[0], size[1]
)]
pub struct RegionError {
    /// The region.
    pub region: Region,
    /// The picture's width and height.
    pub size: [u32; 2],
}

impl Region {
    /// All of a picture.
    #[must_use]
    pub const fn whole(size: [u32; 2]) -> Self {
        Self { x: 0, y: 0, width: size[0], height: size[1] }
    }

    /// How many pixels it holds.
    #[must_use]
    pub const fn pixels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// Checks that it is a part of a picture of that size.
    ///
    /// # Errors
    /// When it is empty or reaches beyond the picture.
    pub fn check_inside(&self, size: [u32; 2]) -> Result<(), RegionError> {
        let fits = |from: u32, length: u32, all: u32| {
            length > 0 && from.checked_add(length).is_some_and(|end| end <= all)
        };
        if fits(self.x, self.width, size[0]) && fits(self.y, self.height, size[1]) {
            Ok(())
        } else {
            Err(RegionError { region: *self, size })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_must_lie_inside() {
        let size = [100, 50];
        assert!(Region::whole(size).check_inside(size).is_ok());
        for bad in [[0, 0, 0, 5], [99, 0, 2, 1], [0, 50, 1, 1], [u32::MAX, 0, 2, 2]] {
            let [x, y, width, height] = bad;
            assert!(Region { x, y, width, height }.check_inside(size).is_err(), "{bad:?}");
        }
    }
}
