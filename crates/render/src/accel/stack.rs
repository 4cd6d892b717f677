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
        let mut place = self.top.saturating_sub(1);
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
