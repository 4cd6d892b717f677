//! Rays that are traced together, with what each carries, in blocks; and how chosen lanes join such blocks without a gap.

use crate::accel::simd::Simd;
use crate::accel::{BLOCK, Column, RayBlock, RayStream};

/// Whole numbers from 0 on.
pub const NUMBERS: Column = {
    let mut numbers = [0.0; BLOCK];
    let mut i = 0;
    while i < BLOCK {
        numbers[i] = i as f32;
        i += 1;
    }
    numbers
};

/// Lanes below a number.
#[inline(always)]
pub fn lanes_below<S: Simd>(s: S, end: usize) -> S::M {
    s.lt(s.load(&NUMBERS), s.splat(end as f32))
}

/// A block that lanes join: its columns in a fixed order.
pub trait Columns<const N: usize> {
    /// All of them.
    fn columns(&mut self) -> [&mut Column; N];
}

/// How chosen lanes join others that are there already: packed, and turned so that they come to stand right behind them.
#[derive(Clone, Copy)]
pub struct Joining<S: Simd> {
    /// Whether all lanes go where they are, as whole vectors.
    is_whole: bool,
    order: S::Order,
    /// Lanes of the first place that are taken.
    taken: S::M,
    /// How many there are before.
    start: usize,
    /// How many there are then.
    end: usize,
}

impl<S: Simd> Joining<S> {
    /// The chosen lanes join so many.
    #[inline(always)]
    pub fn new(s: S, chosen: S::M, len: usize) -> Self {
        let shift = len % S::LANES;
        let count = s.bits(chosen).count_ones() as usize;
        Self {
            is_whole: shift == 0 && count == S::LANES,
            order: s.packed(chosen, shift),
            taken: lanes_below(s, shift),
            start: len,
            end: len + count,
        }
    }

    /// How many there are then.
    #[inline(always)]
    pub const fn end(&self) -> usize {
        self.end
    }

    /// Writes columns. Places from the end of the last lane to the end of the vector hold something then that means nothing.
    #[inline(always)]
    pub fn write<const N: usize, B: Columns<N>>(&self, s: S, values: &[S::F; N], blocks: &mut [B]) {
        let first = self.start - self.start % S::LANES;
        let at = first % BLOCK;
        if self.is_whole {
            for (column, value) in blocks[first / BLOCK].columns().into_iter().zip(*values) {
                s.store(value, &mut column[at..]);
            }
            return;
        }
        let mut packed = *values;
        for value in &mut packed {
            *value = s.permute(*value, self.order);
        }
        for (column, value) in blocks[first / BLOCK].columns().into_iter().zip(packed) {
            let column = &mut column[at..];
            s.store(s.select(self.taken, s.load(column), value), column);
        }
        let second = first + S::LANES;
        if self.end > second {
            let at = second % BLOCK;
            for (column, value) in blocks[second / BLOCK].columns().into_iter().zip(packed) {
                s.store(value, &mut column[at..]);
            }
        }
    }
}

/// What sixteen rays carry. All are numbers that floats hold exactly.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct ErrandBlock {
    /// The pixel, by its place in the tile's order.
    pub pixel: Column,
    /// How much of what the ray sees reaches the pixel.
    pub weight: Column,
    /// How many times it may be mirrored yet.
    pub reflections: Column,
    /// How many surfaces it has passed.
    pub crossings: Column,
}

impl ErrandBlock {
    const EMPTY: Self = {
        let zero = [0.0; BLOCK];
        Self { pixel: zero, weight: zero, reflections: zero, crossings: zero }
    };
}

impl Columns<4> for ErrandBlock {
    #[inline(always)]
    fn columns(&mut self) -> [&mut Column; 4] {
        [&mut self.pixel, &mut self.weight, &mut self.reflections, &mut self.crossings]
    }
}

impl Columns<10> for RayBlock {
    #[inline(always)]
    fn columns(&mut self) -> [&mut Column; 10] {
        let [ox, oy, oz] = &mut self.origin;
        let [dx, dy, dz] = &mut self.direction;
        let (end, start) = (&mut self.t_max, &mut self.start_t);
        [ox, oy, oz, dx, dy, dz, end, start, &mut self.start_primitive, &mut self.start_triangle]
    }
}

/// Rays in lanes, with what they carry.
#[derive(Clone, Copy)]
pub struct RayLanes<S: Simd> {
    pub origin: [S::F; 3],
    pub direction: [S::F; 3],
    pub t_max: S::F,
    /// Where hits begin to count: the distance, the primitive and its triangle, as in [`RayBlock`].
    pub start: [S::F; 3],
    pub pixel: S::F,
    pub weight: S::F,
    pub reflections: S::F,
    pub crossings: S::F,
}

/// Rays that are traced together.
#[derive(Debug, Default)]
pub struct Wave {
    rays: RayStream,
    /// As many blocks as there ever were rays for.
    errands: Vec<ErrandBlock>,
}

impl Wave {
    /// The rays.
    #[inline(always)]
    pub const fn rays(&self) -> &RayStream {
        &self.rays
    }

    /// What they carry.
    #[inline(always)]
    pub fn errands(&self) -> &[ErrandBlock] {
        &self.errands[..self.rays.blocks().len()]
    }

    /// Takes all rays out.
    pub fn clear(&mut self) {
        self.rays.clear();
    }

    /// Adds the chosen lanes.
    #[inline(always)]
    pub fn push<S: Simd>(&mut self, s: S, chosen: S::M, lanes: &RayLanes<S>) {
        let joining = Joining::new(s, chosen, self.rays.len());
        if joining.end() == self.rays.len() {
            return;
        }
        let ([ox, oy, oz], [dx, dy, dz]) = (lanes.origin, lanes.direction);
        let [t, primitive, triangle] = lanes.start;
        let rays = [ox, oy, oz, dx, dy, dz, lanes.t_max, t, primitive, triangle];
        joining.write(s, &rays, self.rays.resize(joining.end()));
        let blocks = self.rays.blocks().len();
        if self.errands.len() < blocks {
            self.errands.resize(blocks, ErrandBlock::EMPTY);
        }
        let errands = [lanes.pixel, lanes.weight, lanes.reflections, lanes.crossings];
        joining.write(s, &errands, &mut self.errands);
    }

    /// Marks the places behind the last ray as without one. To be called before the rays are traced.
    pub fn seal(&mut self) {
        let len = self.rays.len();
        let blocks = self.rays.resize(len);
        if let Some(last) = blocks.last_mut() {
            let used = (len - 1) % BLOCK + 1;
            last.t_max[used..].fill(-1.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::simd::{Instructions, Kernel};

    /// Pushes the lanes of masks, each lane with its own number as pixel.
    struct Pushing<'a>(&'a [u32], &'a mut Wave);

    impl Kernel for Pushing<'_> {
        type Output = ();
        #[inline(always)]
        fn run<S: Simd>(self, s: S) {
            let zero = s.splat(0.0);
            for (i, bits) in self.0.iter().enumerate() {
                for start in (0..BLOCK).step_by(S::LANES) {
                    let number = s.add(s.load(&NUMBERS[start..]), s.splat((i * BLOCK) as f32));
                    let wanted: Column = std::array::from_fn(|lane| (bits >> lane & 1) as f32);
                    let chosen = s.lt(zero, s.load(&wanted[start..]));
                    let lanes = RayLanes {
                        origin: [number, zero, zero],
                        direction: [zero, zero, number],
                        t_max: s.splat(1.0),
                        start: [zero, zero, number],
                        pixel: number,
                        weight: zero,
                        reflections: zero,
                        crossings: number,
                    };
                    self.1.push(s, chosen, &lanes);
                }
            }
        }
    }

    #[test]
    fn chosen_lanes_join_in_order_and_without_a_gap() {
        let masks = [0xffff, 0x0001, 0x8000, 0, 0x5555, 0xfffe, 0x00ff, 0xff00, 0x0180, 0xffff, 0x7fff, 1];
        let expected: Vec<f32> = (0..masks.len() * BLOCK)
            .filter(|i| masks[i / BLOCK] >> (i % BLOCK) & 1 != 0)
            .map(|i| i as f32)
            .collect();
        for set in Instructions::available() {
            let mut wave = Wave::default();
            set.run(Pushing(&masks, &mut wave));
            wave.seal();
            assert_eq!(wave.rays().len(), expected.len());
            for (i, &number) in expected.iter().enumerate() {
                let (block, lane) = (i / BLOCK, i % BLOCK);
                let (rays, errands) = (&wave.rays().blocks()[block], &wave.errands()[block]);
                let ends = [rays.origin[0], rays.direction[2], rays.start_triangle, errands.pixel];
                assert_eq!(ends.map(|column| column[lane]), [number; 4], "{set:?}, ray {i}");
                assert_eq!((rays.t_max[lane], errands.crossings[lane]), (1.0, number));
            }
            let last = &wave.rays().blocks()[expected.len() / BLOCK];
            assert!(last.t_max[expected.len() % BLOCK..].iter().all(|&t| t < 0.0));
        }
    }
}
