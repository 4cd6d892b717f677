//! What walks through trees have still to visit.
//!
//! The invariant behind the `unsafe` here: of a stack's places, those below `top` have been written; nothing else changes
//! `top` than [`Stack::push`], which writes first, and [`Stack::pop`].
#![allow(unsafe_code)]

use super::tree::STACK;
use std::mem::MaybeUninit;

/// Room for a stack. Nothing is written into it before it is used, for a walk may be short.
pub struct Room<T>([MaybeUninit<T>; STACK]);

impl<T: Copy> Room<T> {
    /// Empty room.
    #[inline(always)]
    pub const fn new() -> Self {
        Self([const { MaybeUninit::uninit() }; STACK])
    }

    /// An empty stack in it.
    #[inline(always)]
    pub const fn stack(&mut self) -> Stack<'_, T> {
        Stack { places: &mut self.0, top: 0 }
    }
}

/// A stack. It stands apart from its room so that `top` can stay in a register.
pub struct Stack<'a, T> {
    places: &'a mut [MaybeUninit<T>; STACK],
    top: usize,
}

impl<T: Copy> Stack<'_, T> {
    /// How many values there are.
    #[inline(always)]
    pub const fn len(&self) -> usize {
        self.top
    }

    /// Puts a value on top. Panics when there is no room, which trees are built to leave.
    #[inline(always)]
    pub const fn push(&mut self, value: T) {
        self.places[self.top].write(value);
        self.top += 1;
    }

    /// Takes the value on top.
    #[inline(always)]
    pub const fn pop(&mut self) -> Option<T> {
        if self.top == 0 {
            return None;
        }
        self.top -= 1;
        // SAFETY: the place was below `top`.
        Some(unsafe { self.places[self.top].assume_init() })
    }

    /// The value on top, left where it is.
    #[inline(always)]
    pub fn peek(&self) -> Option<T> {
        let below = self.top.checked_sub(1)?;
        // SAFETY: the place is below `top`.
        Some(unsafe { self.places[below].assume_init() })
    }

    /// Lets the value on top sink to its place among those above `bottom`, which `is_above` has sorted already.
    #[inline(always)]
    pub fn sink(&mut self, bottom: usize, is_above: impl Fn(&T, &T) -> bool) {
        let Some(mut place) = self.top.checked_sub(1) else { return };
        // SAFETY: all these places are below `top`.
        unsafe {
            let value = self.places[place].assume_init();
            while place > bottom && is_above(self.places[place - 1].assume_init_ref(), &value) {
                self.places[place] = self.places[place - 1];
                place -= 1;
            }
            self.places[place].write(value);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::tests::Numbers;

    #[test]
    fn a_stack_gives_back_what_was_put_onto_it_in_turn() {
        let (mut room, mut numbers, mut truth) = (Room::new(), Numbers(3), Vec::<(usize, f32)>::new());
        let mut stack = room.stack();
        for i in 0..500 {
            if numbers.next() < 0.3 && truth.len() < STACK {
                stack.push((i, numbers.next()));
                truth.push(stack.peek().expect("just put there"));
            } else {
                assert_eq!(stack.pop(), truth.pop());
            }
            assert_eq!((stack.len(), stack.peek()), (truth.len(), truth.last().copied()));
        }
        let mut room = Room::new();
        let mut stack = room.stack();
        (0..STACK).for_each(|i| stack.push(i));
        assert!((0..STACK).rev().all(|i| stack.pop() == Some(i)) && stack.pop().is_none());
    }

    #[test]
    fn values_sink_to_their_places_above_the_bottom_and_no_farther() {
        let (mut room, mut numbers) = (Room::new(), Numbers(4));
        let mut stack = room.stack();
        stack.sink(0, |_, _| true);
        (0..3).for_each(|_| stack.push(-2.0));
        let mut truth: Vec<f32> = (0..40).map(|_| numbers.next()).collect();
        for value in &truth {
            stack.push(*value);
            stack.sink(3, |below, value| below < value);
        }
        truth.sort_by(f32::total_cmp);
        truth.extend([-2.0; 3]);
        assert!(truth.iter().all(|value| stack.pop() == Some(*value)) && stack.pop().is_none());
    }
}
