//! The vector unit that every processor has: plain Rust over eight lanes. It says what the others must give, bit by bit.

use super::{Kernel, Simd};

/// Plain Rust, 8 lanes.
#[derive(Clone, Copy, Debug)]
pub struct Portable;

macro_rules! lanewise {
    ($($name:ident($($arg:ident),*) -> F = |$($x:ident),*| $value:expr;)*) => {$(
        #[inline(always)]
        fn $name(self, $($arg: [f32; 8]),*) -> [f32; 8] {
            std::array::from_fn(|i| { $(let $x = $arg[i];)* $value })
        }
    )*};
    ($($name:ident -> M = |$x:ident, $y:ident| $value:expr;)*) => {$(
        #[inline(always)]
        fn $name(self, a: [f32; 8], b: [f32; 8]) -> u8 {
            (0..8).fold(0, |m, i| { let ($x, $y) = (a[i], b[i]); m | (u8::from($value) << i) })
        }
    )*};
}

impl Simd for Portable {
    const LANES: usize = 8;
    type F = [f32; 8];
    type M = u8;
    type Order = [u8; 8];

    lanewise! {
        add(a, b) -> F = |x, y| x + y;
        sub(a, b) -> F = |x, y| x - y;
        mul(a, b) -> F = |x, y| x * y;
        div(a, b) -> F = |x, y| x / y;
        sqrt(a) -> F = |x| x.sqrt();
        abs(a) -> F = |x| x.abs();
        floor(a) -> F = |x| x.floor();
        min(a, b) -> F = |x, y| if x < y { x } else { y };
        max(a, b) -> F = |x, y| if x > y { x } else { y };
        step(a, count) -> F = |x, n| f32::from_bits(x.to_bits().wrapping_add_signed(n as i32));
    }
    lanewise! {
        lt -> M = |x, y| x < y;
        le -> M = |x, y| x <= y;
        eq -> M = |x, y| x == y;
    }

    #[inline(always)]
    fn splat(self, v: f32) -> [f32; 8] {
        [v; 8]
    }
    #[inline(always)]
    fn load(self, from: &[f32]) -> [f32; 8] {
        std::array::from_fn(|i| from[i])
    }
    #[inline(always)]
    fn store(self, v: [f32; 8], to: &mut [f32]) {
        to[..8].copy_from_slice(&v);
    }
    #[inline(always)]
    fn and(self, a: u8, b: u8) -> u8 {
        a & b
    }
    #[inline(always)]
    fn or(self, a: u8, b: u8) -> u8 {
        a | b
    }
    #[inline(always)]
    fn and_not(self, a: u8, b: u8) -> u8 {
        a & !b
    }
    #[inline(always)]
    fn select(self, mask: u8, yes: [f32; 8], no: [f32; 8]) -> [f32; 8] {
        std::array::from_fn(|i| if mask >> i & 1 != 0 { yes[i] } else { no[i] })
    }
    #[inline(always)]
    fn bits(self, mask: u8) -> u32 {
        u32::from(mask)
    }
    #[inline(always)]
    fn packed(self, mask: u8, shift: usize) -> [u8; 8] {
        let together = TOGETHER[usize::from(mask)];
        std::array::from_fn(|i| together[i.wrapping_sub(shift) % 8])
    }
    #[inline(always)]
    fn permute(self, v: [f32; 8], order: [u8; 8]) -> [f32; 8] {
        order.map(|i| v[usize::from(i) % 8])
    }
    fn call<K: Kernel>(self, kernel: K) -> K::Output {
        kernel.run(self)
    }
}

/// The lanes of each mask of eight in turn, then zeros.
pub(super) const TOGETHER: [[u8; 8]; 256] = {
    let mut all = [[0; 8]; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut lane, mut rank) = (0, 0);
        while lane < 8 {
            if mask >> lane & 1 != 0 {
                all[mask][rank] = lane as u8;
                rank += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    all
};
