//! Every instruction set gives the same bits.

use super::*;

/// Every operation over awkward numbers, as the bits of its results.
struct Everything<'a>(&'a [f32; 16], &'a [f32; 16]);

impl Kernel for Everything<'_> {
    type Output = Vec<u32>;
    #[inline(always)]
    fn run<S: Simd>(self, s: S) -> Vec<u32> {
        let mut out = Vec::new();
        let keep = |v: S::F| {
            let mut lanes = [0.0; 16];
            s.store(v, &mut lanes);
            lanes[..S::LANES].iter().map(|v| if v.is_nan() { 1 } else { v.to_bits() }).collect::<Vec<_>>()
        };
        let mut rows: Vec<Vec<u32>> = vec![Vec::new(); 16];
        for start in (0..16).step_by(S::LANES) {
            let (a, b) = (s.load(&self.0[start..]), s.load(&self.1[start..]));
            let (lt, le, eq) = (s.lt(a, b), s.le(a, b), s.eq(a, b));
            let values = [
                s.add(a, b),
                s.sub(a, b),
                s.mul(a, b),
                s.div(a, b),
                s.sqrt(a),
                s.abs(a),
                s.floor(a),
                s.min(a, b),
                s.max(a, b),
                s.step(a, s.min(s.max(b, s.splat(-20.0)), s.splat(20.0))),
                s.select(lt, a, b),
                s.select(le, a, b),
                s.select(eq, a, b),
                s.select(s.and(le, s.lt(b, s.splat(2.0))), a, b),
                s.select(s.or(lt, eq), a, b),
                s.select(s.and_not(le, eq), a, b),
            ];
            for (row, v) in rows.iter_mut().zip(values) {
                row.extend(keep(v));
            }
            out.push(s.bits(le) << start | u32::from(s.any(lt)) >> 31);
        }
        rows.push(vec![out.iter().fold(0, |a, b| a | b)]);
        rows.concat()
    }
}

#[test]
fn all_instruction_sets_give_the_same_bits() {
    let n = f32::NAN;
    let i = f32::INFINITY;
    let a = [0.0, -0.0, 1.0, -2.5, n, i, -i, 1e-38, 3.3, 1e30, 7.0, 0.1, 2.0, n, 5.0, -1e-45];
    let b = [-0.0, 0.0, 3.0, -2.5, 1.0, i, 1.0, 1e-38, n, 1e30, 0.3, 0.2, -2.0, n, 0.0, 1.0];
    let results: Vec<_> =
        Instructions::available().into_iter().map(|set| set.run(Everything(&a, &b))).collect();
    let pair = crate::accel::wide::Pair(Portable);
    assert_eq!(Everything(&a, &b).run(pair), results[0], "two packets as one");
    for result in &results {
        assert_eq!(result, &results[0]);
    }
    assert_eq!(results[0][2], 4.0_f32.to_bits(), "1 + 3");
}

/// The lanes of a mask, packed, by what the documentation says.
struct Packing<'a>(&'a [f32; 16], u32, usize);

impl Kernel for Packing<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self, s: S) {
        let Self(values, bits, shift) = self;
        let shift = shift % S::LANES;
        let wanted: [f32; 16] = std::array::from_fn(|i| (bits >> i & 1) as f32);
        let mask = s.lt(s.splat(0.0), s.load(&wanted));
        let mut lanes = [0.0; 16];
        s.store(s.permute(s.load(values), s.packed(mask, shift)), &mut lanes);
        let chosen: Vec<f32> = (0..S::LANES).filter(|i| bits >> i & 1 != 0).map(|i| values[i]).collect();
        for rank in 0..S::LANES {
            let expected = chosen.get(rank).unwrap_or(&values[0]);
            assert_eq!(lanes[(rank + shift) % S::LANES], *expected, "mask {bits:b}, shift {shift}");
        }
    }
}

#[test]
fn packing_keeps_the_order_of_lanes() {
    let values: [f32; 16] = std::array::from_fn(|i| 1.0 + i as f32);
    for set in Instructions::available() {
        for bits in [0, 1, 0x8000, 0xffff, 0x8181, 0x5a3c, 0x00ff, 0xff00, 0x7ffe] {
            (0..16).for_each(|shift| set.run(Packing(&values, bits, shift)));
        }
    }
}
