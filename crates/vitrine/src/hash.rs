//! The mark of a scene: a hash of its text that stays the same over versions, machines and years.

use std::fmt;

/// A hash of a scene's text, for the metadata of pictures: two pictures with one hash, seed and number of samples are the
/// same picture. 128-bit FNV-1a (Fowler, Noll, Vo): short, and defined for good. It tells scenes apart; it does
/// not protect against forgery.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SceneHash(u128);

const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;

impl SceneHash {
    /// The hash of a text. Line ends count as written.
    #[must_use]
    pub fn of(text: &str) -> Self {
        Self(BASIS).and_text(text)
    }

    /// The same with more text.
    #[must_use]
    pub(crate) fn and_text(self, text: &str) -> Self {
        self.and_words(text.bytes().map(u32::from))
    }

    /// The same with numbers, a word of 32 bits each.
    #[must_use]
    pub(crate) fn and_words(self, words: impl IntoIterator<Item = u32>) -> Self {
        Self(words.into_iter().fold(self.0, |hash, word| (hash ^ u128::from(word)).wrapping_mul(PRIME)))
    }

    /// The same with floats, by their bits.
    #[must_use]
    pub(crate) fn and_numbers(self, numbers: impl IntoIterator<Item = f32>) -> Self {
        self.and_words(numbers.into_iter().map(f32::to_bits))
    }
}

impl fmt::Display for SceneHash {
    /// 32 hexadecimal digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_values_of_fnv_1a() {
        assert_eq!(SceneHash::of("").to_string(), "6c62272e07bb014262b821756295c58d");
        assert_eq!(SceneHash::of("a").to_string(), "d228cb696f1a8caf78912b704e4a8964");
        assert_eq!(SceneHash::of("foobar").to_string(), "343e1662793c64bf6f0d3597ba446f18");
    }
}
