//! What the system is asked and told about memory: how much there is, and to keep large arrays in large pages. A walk through a
//! tree of many megabytes touches memory all over, and with small pages the processor spends much of the time looking up
//! where they are.
//!
//! One of the three files of the crate with `unsafe`, beside `simd` and `stack`: calls of the system, each harmless by itself.
#![allow(unsafe_code)]

/// Bytes of memory that the machine has; None where the system does not tell.
pub fn machine_memory() -> Option<u64> {
    #[cfg(all(target_os = "linux", not(miri)))]
    {
        // SAFETY: it reads two numbers of the system and no memory of ours.
        let [pages, size] =
            [libc::_SC_PHYS_PAGES, libc::_SC_PAGESIZE].map(|name| unsafe { libc::sysconf(name) });
        u64::try_from(pages).ok()?.checked_mul(u64::try_from(size).ok()?).filter(|bytes| *bytes > 0)
    }
    #[cfg(not(all(target_os = "linux", not(miri))))]
    None
}

/// Room for so many values. Where the system can, in pages of two megabytes.
pub fn with_capacity<T>(count: usize) -> Vec<T> {
    let room = Vec::with_capacity(count);
    // Miri knows no such call.
    #[cfg(all(target_os = "linux", not(miri)))]
    {
        const PAGE: usize = 4096;
        let start = room.as_ptr() as usize;
        let (first, end) = (start.next_multiple_of(PAGE), start + room.capacity() * size_of::<T>());
        if let Some(length) = end.checked_sub(first).filter(|length| *length >= 1 << 21) {
            // SAFETY: the range lies within the room, starts at a page, and advice on the size of pages changes no contents.
            // Whether the system follows it does not matter.
            unsafe { libc::madvise(first as *mut libc::c_void, length, libc::MADV_HUGEPAGE) };
        }
    }
    room
}

/// The values in a room that fits.
pub fn settled<T: Copy>(values: &[T]) -> Vec<T> {
    let mut room = with_capacity(values.len());
    room.extend_from_slice(values);
    room
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rooms_of_any_size_hold_what_is_put_into_them() {
        for count in [0, 1, 1000, (1 << 18) + 1, 1 << 20] {
            let mut room = with_capacity::<u64>(count);
            assert!(room.is_empty() && room.capacity() >= count);
            room.extend([7, 8, 9]);
            assert_eq!(settled(&room), [7, 8, 9]);
        }
    }
}
