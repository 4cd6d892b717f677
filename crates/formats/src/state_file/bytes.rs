//! Numbers and texts as bytes, with a checksum at the end.

/// Bytes of the checksum.
const CHECKSUM: usize = 8;

/// As FNV-1a (Fowler, Noll, Vo), but over words of 8 bytes, each turned so that its high bits count for all; the last is filled up
/// with zeros, and the length follows. It finds files that are cut off or damaged by chance.
fn checksum(bytes: &[u8]) -> u64 {
    const BASIS: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    let step = |hash: u64, word: u64| (hash ^ word).wrapping_mul(PRIME).rotate_left(29);
    let (words, rest) = bytes.as_chunks::<8>();
    let hash = words.iter().fold(BASIS, |hash, word| step(hash, u64::from_le_bytes(*word)));
    let mut last = [0; 8];
    last[..rest.len()].copy_from_slice(rest);
    step(step(hash, u64::from_le_bytes(last)), bytes.len() as u64)
}

/// The bytes without their checksum, if it is right.
pub fn checked(bytes: &[u8]) -> Option<&[u8]> {
    let (content, sum) = bytes.split_last_chunk::<CHECKSUM>()?;
    (u64::from_le_bytes(*sum) == checksum(content)).then_some(content)
}

/// Writes the right checksum over the last bytes.
pub fn mend(bytes: &mut [u8]) {
    if let Some((content, sum)) = bytes.split_last_chunk_mut::<CHECKSUM>() {
        *sum = checksum(content).to_le_bytes();
    }
}

/// Bytes that are being written.
pub struct Writer(Vec<u8>);

impl Writer {
    pub fn with_capacity(bytes: usize) -> Self {
        Self(Vec::with_capacity(bytes))
    }

    pub fn bytes(&mut self, bytes: &[u8]) {
        self.0.extend_from_slice(bytes);
    }

    pub fn u64(&mut self, v: u64) {
        self.bytes(&v.to_le_bytes());
    }

    pub fn u32s(&mut self, values: impl IntoIterator<Item = u32>) {
        values.into_iter().for_each(|v| self.bytes(&v.to_le_bytes()));
    }

    pub fn f32s(&mut self, values: impl IntoIterator<Item = f32>) {
        values.into_iter().for_each(|v| self.bytes(&v.to_le_bytes()));
    }

    /// All bytes and their checksum.
    pub fn finish(mut self) -> Vec<u8> {
        let sum = checksum(&self.0);
        self.u64(sum);
        self.0
    }
}

/// Bytes that are being read. Every list has its length checked against the bytes that are left before any is taken.
pub struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn take(&mut self, bytes: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(bytes)?;
        self.0 = rest;
        Some(taken)
    }

    pub fn u64(&mut self) -> Option<u64> {
        self.take(8).and_then(|b| b.try_into().ok()).map(u64::from_le_bytes)
    }

    pub fn u32s<const N: usize>(&mut self) -> Option<[u32; N]> {
        let bytes = self.take(4 * N)?.as_chunks::<4>().0;
        Some(std::array::from_fn(|i| u32::from_le_bytes(bytes[i])))
    }

    pub fn u32_list(&mut self, length: usize) -> Option<Vec<u32>> {
        let bytes = self.take(length.checked_mul(4)?)?;
        Some(bytes.as_chunks::<4>().0.iter().map(|b| u32::from_le_bytes(*b)).collect())
    }

    /// So many groups of numbers.
    pub fn columns<const N: usize>(&mut self, length: usize) -> Option<Vec<[f32; N]>> {
        let bytes = self.take(length.checked_mul(4 * N)?)?;
        let group = |b: &[u8]| std::array::from_fn(|i| f32::from_le_bytes(b.as_chunks::<4>().0[i]));
        Some(bytes.chunks_exact(4 * N).map(group).collect())
    }

    pub fn text(&mut self, bytes: usize) -> Option<&'a str> {
        std::str::from_utf8(self.take(bytes)?).ok()
    }
}
