//! The smooth surfaces that a path has met since it was last scattered, as a code that two ways of finding a path can
//! compare.

/// The longest chain that is told apart from others.
pub const MOST: usize = 12;

/// The face of a solid: for a box twice the axis, plus 1 on its positive side; 0 for others.
pub type Face = u8;

/// Surfaces in the order in which they were met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chain {
    steps: [u32; MOST],
    len: u8,
    /// Whether it holds something that no connection is solved through.
    is_other: bool,
}

impl Default for Chain {
    fn default() -> Self {
        Self { steps: [0; MOST], len: 0, is_other: false }
    }
}

impl Chain {
    /// Adds a surface: the solid, its face, and whether the light was reflected there.
    #[inline]
    pub fn push(&mut self, solid: u16, face: Face, reflects: bool) {
        if usize::from(self.len) == MOST {
            self.is_other = true;
            return;
        }
        self.steps[usize::from(self.len)] = code(solid, face, reflects);
        self.len += 1;
    }

    /// Whether that surface is in it.
    #[inline]
    pub fn holds(&self, solid: u16, face: Face, reflects: bool) -> bool {
        self.steps[..usize::from(self.len)].contains(&code(solid, face, reflects))
    }

    /// Adds a surface through which no connection is solved.
    #[inline]
    pub fn push_other(&mut self) {
        self.is_other = true;
    }

    /// The solids whose surfaces were met, in order.
    pub fn solids(&self) -> impl Iterator<Item = u16> {
        self.steps[..usize::from(self.len)].iter().map(|code| (code >> 8) as u16)
    }

    /// Whether nothing was met.
    #[inline]
    pub const fn is_empty(&self) -> bool {
        self.len == 0 && !self.is_other
    }

    /// Whether a connection may be solved through all of it.
    #[inline]
    pub const fn is_solvable(&self) -> bool {
        !self.is_other
    }
}

#[inline]
const fn code(solid: u16, face: Face, reflects: bool) -> u32 {
    (solid as u32) << 8 | (face as u32) << 1 | reflects as u32
}
