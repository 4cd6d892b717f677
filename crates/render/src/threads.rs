//! How many threads work.

use std::num::NonZero;
use std::thread::available_parallelism;

/// How many threads the machine runs at once; 1 where the system does not tell.
#[must_use]
pub fn of_machine() -> usize {
    available_parallelism().map_or(1, NonZero::get)
}

/// How many threads are meant by a number of them: 0 means all that the machine runs at once.
#[must_use]
pub fn meant_by(threads: usize) -> usize {
    if threads == 0 { of_machine() } else { threads }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn none_means_all_of_the_machine() {
        assert_eq!((meant_by(3), meant_by(0)), (3, of_machine()));
        assert!(of_machine() > 0);
    }
}
