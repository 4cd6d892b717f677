//! The vector unit behind one small trait, so that each kernel is written once.
//!
//! Every operation is an IEEE 754 operation that rounds correctly, and none is fused with another. So each lane gives the same
//! bits on every instruction set, and a picture does not depend on the processor that made it.
//!
//! This file, `stack` and `huge` are the only ones of the crate with `unsafe`. The invariant here: a value of [`Avx2`] or
//! [`Avx512`] exists only where [`Instructions::detect`] has found the processor to have those instructions, for nothing
//! else can make one. So whoever holds one may call them.
#![allow(unsafe_code)]

mod portable;

use super::rays::Rays;
#[cfg(target_arch = "x86_64")]
use portable::TOGETHER;
use vitrine_math::pow_unit;

pub use portable::Portable;

/// Lanes of 32-bit floats and masks over them.
///
/// Comparisons with NaN are false. All functions must be inlined into one that has the instruction set switched on
/// ([`Instructions::run`]); without that they are right and slow.
pub trait Simd: Copy {
    /// How many lanes there are: 16 at most in a vector unit, 32 at most in all.
    const LANES: usize;
    /// A float in each lane.
    type F: Copy;
    /// A yes or no in each lane.
    type M: Copy;
    /// Which lane each lane is to come from.
    type Order: Copy;

    /// The same value in each lane.
    fn splat(self, v: f32) -> Self::F;
    /// The first `LANES` values of a slice. Panics when there are fewer.
    fn load(self, from: &[f32]) -> Self::F;
    /// Into the first `LANES` places of a slice. Panics when there are fewer.
    fn store(self, v: Self::F, to: &mut [f32]);
    /// a + b
    fn add(self, a: Self::F, b: Self::F) -> Self::F;
    /// a − b
    fn sub(self, a: Self::F, b: Self::F) -> Self::F;
    /// a · b
    fn mul(self, a: Self::F, b: Self::F) -> Self::F;
    /// a / b
    fn div(self, a: Self::F, b: Self::F) -> Self::F;
    /// √a
    fn sqrt(self, a: Self::F) -> Self::F;
    /// |a|
    fn abs(self, a: Self::F) -> Self::F;
    /// The largest whole number that is not above a.
    fn floor(self, a: Self::F) -> Self::F;
    /// a if a < b, else b (so b where either is NaN).
    fn min(self, a: Self::F, b: Self::F) -> Self::F;
    /// a if a > b, else b (so b where either is NaN).
    fn max(self, a: Self::F, b: Self::F) -> Self::F;
    /// The float that is so many floats farther from 0, or nearer to it when the number is negative. Fractions of the number do
    /// not count; it is below 2²⁴, and 0 is not crossed.
    fn step(self, a: Self::F, count: Self::F) -> Self::F;
    /// a < b
    fn lt(self, a: Self::F, b: Self::F) -> Self::M;
    /// a ≤ b
    fn le(self, a: Self::F, b: Self::F) -> Self::M;
    /// a = b
    fn eq(self, a: Self::F, b: Self::F) -> Self::M;
    /// Both.
    fn and(self, a: Self::M, b: Self::M) -> Self::M;
    /// Either.
    fn or(self, a: Self::M, b: Self::M) -> Self::M;
    /// The first and not the second.
    fn and_not(self, a: Self::M, b: Self::M) -> Self::M;
    /// `yes` in lanes of the mask, else `no`.
    fn select(self, mask: Self::M, yes: Self::F, no: Self::F) -> Self::F;
    /// A bit for each lane, the first lane the lowest.
    fn bits(self, mask: Self::M) -> u32;
    /// The order that moves the lanes of the mask together, in turn, from the lane `shift` on and around the end. Where
    /// none is left stands the first lane.
    fn packed(self, mask: Self::M, shift: usize) -> Self::Order;
    /// The lanes in that order.
    fn permute(self, v: Self::F, order: Self::Order) -> Self::F;
    /// Does a kernel's work in a function of its own that has the instructions switched on.
    fn call<K: Kernel>(self, kernel: K) -> K::Output;

    /// The least value of all lanes, none of which is NaN.
    #[inline(always)]
    fn least(self, v: Self::F) -> f32 {
        let mut lanes = [0.0; 16];
        self.store(v, &mut lanes);
        lanes[1..Self::LANES].iter().fold(lanes[0], |a, &b| if b < a { b } else { a })
    }

    /// The greatest value of all lanes, none of which is NaN.
    #[inline(always)]
    fn greatest(self, v: Self::F) -> f32 {
        let mut lanes = [0.0; 16];
        self.store(v, &mut lanes);
        lanes[1..Self::LANES].iter().fold(lanes[0], |a, &b| if b > a { b } else { a })
    }

    /// The value of one lane.
    #[inline(always)]
    fn lane(self, v: Self::F, lane: usize) -> f32 {
        let mut lanes = [0.0; 16];
        self.store(v, &mut lanes);
        lanes[lane % 16]
    }

    /// The same with another value in one lane.
    #[inline(always)]
    fn with_lane(self, v: Self::F, lane: usize, value: f32) -> Self::F {
        self.select(self.only(lane), self.splat(value), v)
    }

    /// One lane alone.
    #[inline(always)]
    fn only(self, lane: usize) -> Self::M {
        let mut lanes = [0.0; 16];
        lanes[lane % 16] = 1.0;
        self.lt(self.splat(0.0), self.load(&lanes))
    }

    /// `x^y` by [`pow_unit`], with its range and precision.
    #[inline(always)]
    fn pow_unit(self, x: Self::F, y: Self::F) -> Self::F {
        let (mut a, mut b) = ([0.0; 16], [0.0; 16]);
        self.store(x, &mut a);
        self.store(y, &mut b);
        for i in 0..Self::LANES {
            a[i] = pow_unit(a[i], b[i]);
        }
        self.load(&a)
    }

    /// Whether any lane says yes.
    #[inline(always)]
    fn any(self, mask: Self::M) -> bool {
        self.bits(mask) != 0
    }
}

/// Work that is written for any vector unit.
pub trait Kernel {
    /// What it gives back.
    type Output;
    /// Does it. Must be `#[inline(always)]`, and so must what it calls in its loops.
    fn run<S: Rays>(self, simd: S) -> Self::Output;
}

/// The instruction sets that a kernel can run on.
#[derive(Clone, Copy, Debug)]
pub enum Instructions {
    /// Plain Rust, right everywhere.
    Portable,
    /// 8 lanes.
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    /// 16 lanes.
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
}

impl Instructions {
    /// The widest that this processor has.
    #[must_use]
    pub fn detect() -> Self {
        Self::available().pop().unwrap_or(Self::Portable)
    }

    /// All that this processor has, from the narrowest to the widest.
    #[must_use]
    pub fn available() -> Vec<Self> {
        #[allow(unused_mut, reason = "only x86 has more than one")]
        let mut all = vec![Self::Portable];
        #[cfg(target_arch = "x86_64")]
        {
            let has_bits = is_x86_feature_detected!("bmi1")
                && is_x86_feature_detected!("lzcnt")
                && is_x86_feature_detected!("popcnt");
            if has_bits && is_x86_feature_detected!("avx2") {
                all.push(Self::Avx2(Avx2(())));
            }
            if has_bits && is_x86_feature_detected!("avx512f") {
                all.push(Self::Avx512(Avx512(())));
            }
        }
        all
    }

    /// The same, with eight lanes at most.
    #[must_use]
    pub fn eight(self) -> Self {
        match self {
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(token) => Self::Avx2(token.narrow()),
            other => other,
        }
    }

    /// Runs a kernel with these instructions switched on.
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        match self {
            Self::Portable => kernel.run(Portable),
            // SAFETY: the token proves that the processor has the instructions.
            #[cfg(target_arch = "x86_64")]
            Self::Avx2(token) => unsafe { run_avx2(token, kernel) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Self::Avx512(token) => unsafe { run_avx512(token, kernel) },
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi1,lzcnt,popcnt")]
fn run_avx2<K: Kernel>(token: Avx2, kernel: K) -> K::Output {
    kernel.run(token)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,bmi1,lzcnt,popcnt")]
fn run_avx512<K: Kernel>(token: Avx512, kernel: K) -> K::Output {
    kernel.run(token)
}

/// Asks for the memory of a value, which will be needed soon.
#[inline(always)]
pub fn prefetch<T>(value: &T) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        const LINE: usize = 64;
        let start = std::ptr::from_ref(value).cast::<i8>();
        for line in (0..size_of::<T>()).step_by(LINE) {
            // SAFETY: a prefetch reads nothing, and the address lies within the value.
            unsafe { _mm_prefetch::<_MM_HINT_T0>(start.add(line)) };
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = value;
}

#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512};

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Kernel, Simd, TOGETHER, run_avx2, run_avx512};
    use std::arch::x86_64::*;

    /// Proof that the processor has AVX2; 8 lanes.
    #[derive(Clone, Copy, Debug)]
    pub struct Avx2(pub(super) ());

    /// Proof that the processor has AVX-512F; 16 lanes.
    #[derive(Clone, Copy, Debug)]
    pub struct Avx512(pub(super) ());

    macro_rules! intrinsics {
        ($($name:ident($($arg:ident: $type:ty),*) -> $out:ty = $value:expr;)*) => {$(
            #[inline(always)]
            fn $name(self, $($arg: $type),*) -> $out {
                // SAFETY: `self` proves that the processor has the instruction.
                #[allow(unused_unsafe, reason = "some intrinsics are safe where the instructions are on")]
                unsafe { $value }
            }
        )*};
    }

    impl Simd for Avx2 {
        const LANES: usize = 8;
        type F = __m256;
        type M = __m256;
        type Order = __m256i;

        intrinsics! {
            splat(v: f32) -> __m256 = _mm256_set1_ps(v);
            add(a: __m256, b: __m256) -> __m256 = _mm256_add_ps(a, b);
            sub(a: __m256, b: __m256) -> __m256 = _mm256_sub_ps(a, b);
            mul(a: __m256, b: __m256) -> __m256 = _mm256_mul_ps(a, b);
            div(a: __m256, b: __m256) -> __m256 = _mm256_div_ps(a, b);
            sqrt(a: __m256) -> __m256 = _mm256_sqrt_ps(a);
            abs(a: __m256) -> __m256 = _mm256_andnot_ps(_mm256_set1_ps(-0.0), a);
            floor(a: __m256) -> __m256 = _mm256_floor_ps(a);
            min(a: __m256, b: __m256) -> __m256 = _mm256_min_ps(a, b);
            max(a: __m256, b: __m256) -> __m256 = _mm256_max_ps(a, b);
            step(a: __m256, count: __m256) -> __m256 = _mm256_castsi256_ps(_mm256_add_epi32(_mm256_castps_si256(a), _mm256_cvttps_epi32(count)));
            lt(a: __m256, b: __m256) -> __m256 = _mm256_cmp_ps::<_CMP_LT_OQ>(a, b);
            le(a: __m256, b: __m256) -> __m256 = _mm256_cmp_ps::<_CMP_LE_OQ>(a, b);
            eq(a: __m256, b: __m256) -> __m256 = _mm256_cmp_ps::<_CMP_EQ_OQ>(a, b);
            and(a: __m256, b: __m256) -> __m256 = _mm256_and_ps(a, b);
            or(a: __m256, b: __m256) -> __m256 = _mm256_or_ps(a, b);
            and_not(a: __m256, b: __m256) -> __m256 = _mm256_andnot_ps(b, a);
            select(mask: __m256, yes: __m256, no: __m256) -> __m256 = _mm256_blendv_ps(no, yes, mask);
            bits(mask: __m256) -> u32 = _mm256_movemask_ps(mask) as u32;
            permute(v: __m256, order: __m256i) -> __m256 = _mm256_permutevar8x32_ps(v, order);
        }

        #[inline(always)]
        fn packed(self, mask: __m256, shift: usize) -> __m256i {
            let together = i64::from_le_bytes(TOGETHER[self.bits(mask) as usize & 255]);
            // SAFETY: `self` proves that the processor has the instructions. Of each index they take the low 3 bits.
            unsafe {
                let together = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(together));
                let lanes = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
                let ranks = _mm256_sub_epi32(lanes, _mm256_set1_epi32(shift as i32));
                _mm256_permutevar8x32_epi32(together, ranks)
            }
        }

        #[inline(always)]
        fn load(self, from: &[f32]) -> __m256 {
            let from = &from[..8];
            // SAFETY: eight floats stand there; the load needs no alignment.
            unsafe { _mm256_loadu_ps(from.as_ptr()) }
        }
        #[inline(always)]
        fn store(self, v: __m256, to: &mut [f32]) {
            let to = &mut to[..8];
            // SAFETY: there is room for eight floats; the store needs no alignment.
            unsafe { _mm256_storeu_ps(to.as_mut_ptr(), v) }
        }
        fn call<K: Kernel>(self, kernel: K) -> K::Output {
            // SAFETY: `self` proves that the processor has the instructions.
            unsafe { run_avx2(self, kernel) }
        }
    }

    impl Simd for Avx512 {
        const LANES: usize = 16;
        type F = __m512;
        type M = __mmask16;
        type Order = __m512i;

        intrinsics! {
            splat(v: f32) -> __m512 = _mm512_set1_ps(v);
            add(a: __m512, b: __m512) -> __m512 = _mm512_add_ps(a, b);
            sub(a: __m512, b: __m512) -> __m512 = _mm512_sub_ps(a, b);
            mul(a: __m512, b: __m512) -> __m512 = _mm512_mul_ps(a, b);
            div(a: __m512, b: __m512) -> __m512 = _mm512_div_ps(a, b);
            sqrt(a: __m512) -> __m512 = _mm512_sqrt_ps(a);
            abs(a: __m512) -> __m512 = _mm512_abs_ps(a);
            floor(a: __m512) -> __m512 = _mm512_roundscale_ps::<{ _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC }>(a);
            min(a: __m512, b: __m512) -> __m512 = _mm512_min_ps(a, b);
            max(a: __m512, b: __m512) -> __m512 = _mm512_max_ps(a, b);
            step(a: __m512, count: __m512) -> __m512 = _mm512_castsi512_ps(_mm512_add_epi32(_mm512_castps_si512(a), _mm512_cvttps_epi32(count)));
            lt(a: __m512, b: __m512) -> __mmask16 = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b);
            le(a: __m512, b: __m512) -> __mmask16 = _mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b);
            eq(a: __m512, b: __m512) -> __mmask16 = _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a, b);
            select(mask: __mmask16, yes: __m512, no: __m512) -> __m512 = _mm512_mask_blend_ps(mask, no, yes);
            permute(v: __m512, order: __m512i) -> __m512 = _mm512_permutexvar_ps(order, v);
            least(v: __m512) -> f32 = _mm512_reduce_min_ps(v);
            greatest(v: __m512) -> f32 = _mm512_reduce_max_ps(v);
            only(lane: usize) -> __mmask16 = 1 << (lane % 16);
        }

        #[inline(always)]
        fn packed(self, mask: __mmask16, shift: usize) -> __m512i {
            // SAFETY: `self` proves that the processor has the instructions. Of each index they take the low 4 bits.
            unsafe {
                let lanes = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
                let together = _mm512_maskz_compress_epi32(mask, lanes);
                let ranks = _mm512_sub_epi32(lanes, _mm512_set1_epi32(shift as i32));
                _mm512_permutexvar_epi32(ranks, together)
            }
        }

        #[inline(always)]
        fn load(self, from: &[f32]) -> __m512 {
            let from = &from[..16];
            // SAFETY: sixteen floats stand there; the load needs no alignment.
            unsafe { _mm512_loadu_ps(from.as_ptr()) }
        }
        #[inline(always)]
        fn store(self, v: __m512, to: &mut [f32]) {
            let to = &mut to[..16];
            // SAFETY: there is room for sixteen floats; the store needs no alignment.
            unsafe { _mm512_storeu_ps(to.as_mut_ptr(), v) }
        }
        #[inline(always)]
        fn and(self, a: __mmask16, b: __mmask16) -> __mmask16 {
            a & b
        }
        #[inline(always)]
        fn or(self, a: __mmask16, b: __mmask16) -> __mmask16 {
            a | b
        }
        #[inline(always)]
        fn and_not(self, a: __mmask16, b: __mmask16) -> __mmask16 {
            a & !b
        }
        #[inline(always)]
        fn bits(self, mask: __mmask16) -> u32 {
            u32::from(mask)
        }
        fn call<K: Kernel>(self, kernel: K) -> K::Output {
            // SAFETY: `self` proves that the processor has the instructions.
            unsafe { run_avx512(self, kernel) }
        }
    }

    impl Avx512 {
        /// The same processor's eight lanes: AVX-512 brings AVX2 with it.
        #[inline(always)]
        #[must_use]
        pub const fn narrow(self) -> Avx2 {
            Avx2(())
        }
    }
}

#[cfg(test)]
mod tests;
