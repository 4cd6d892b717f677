//! Splits of short runs where blocks are full. Half-empty blocks cost as much time and memory as full ones.

use super::item::{Item, Span};

/// Items in a block.
const BLOCK: usize = 8;
/// The longest run.
pub const LONGEST: usize = 256;

/// Sorts the items along the axis where the best split lies; gives where the second part begins. One of the two parts fills its
/// blocks. There must be more items than one block holds, and no more than the longest run.
pub fn split(items: &mut [Item]) -> usize {
    let mut best: Option<(f32, usize, usize)> = None;
    let mut orders = [[0_u64; LONGEST]; 3];
    let mut above = [0.0_f32; LONGEST];
    for (axis, order) in orders.iter_mut().enumerate() {
        let order = &mut order[..items.len()];
        sort(order, items, axis);
        let item = |key: u64| items[(key & 0xffff) as usize].span();
        let mut span = Span::EMPTY;
        for (i, &key) in order.iter().enumerate().skip(1).rev() {
            span.join(&item(key));
            above[i] = span.half_area();
        }
        let mut span = Span::EMPTY;
        for i in 1..order.len() {
            span.join(&item(order[i - 1]));
            let rest = order.len() - i;
            if !i.is_multiple_of(BLOCK) && !rest.is_multiple_of(BLOCK) {
                continue;
            }
            let cost = span.half_area() * blocks(i) + above[i] * blocks(rest);
            if best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, axis, i));
            }
        }
    }
    let (_, axis, middle) = best.unwrap_or((0.0, 0, BLOCK));
    let mut sorted = [items[0]; LONGEST];
    for (to, key) in sorted.iter_mut().zip(&orders[axis][..items.len()]) {
        *to = items[(key & 0xffff) as usize];
    }
    items.copy_from_slice(&sorted[..items.len()]);
    middle
}

/// Sorts by the middles along an axis; of equal ones the first item comes first. Keys: the middle's bits, made to order as the
/// numbers do, then the item's place.
fn sort(keys: &mut [u64], items: &[Item], axis: usize) {
    for ((place, item), key) in items.iter().enumerate().zip(keys.iter_mut()) {
        let bits = item.center()[axis].to_bits();
        let ordered = if bits >> 31 == 0 { bits | 1 << 31 } else { !bits };
        *key = u64::from(ordered) << 32 | place as u64;
    }
    keys.sort_unstable();
}

fn blocks(count: usize) -> f32 {
    count.div_ceil(BLOCK) as f32
}
