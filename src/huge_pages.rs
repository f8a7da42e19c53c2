//! Memory for large blocks in huge pages, where Linux gives them on request.
//!
//! A scene of a hundred thousand objects touches a hundred megabytes while it is read and compiled. On a virtual
//! machine each first touch of a 4 KiB page costs about 10,000 cycles, and rays that jump about in a hierarchy of
//! that size miss the translation buffers. The scene of `benches/generate_spheres.py` at 640x480 takes a tenth fewer
//! cycles with this allocator and with reading on the first thread, half as many of them in the kernel, and a tenth less
//! memory; that is why this one module may be unsafe.

use std::alloc::{GlobalAlloc, Layout, System};

/// The system's allocator, with a request for huge pages under every large block.
pub(crate) struct HugePages;

/// Blocks from the size of a huge page of most processors on.
const LARGE: usize = 2 << 20;

/// A large block starts where a huge page does, and ends there if little is missing: then most of it lies in huge pages.
fn aligned(layout: Layout) -> Layout {
    if layout.size() < LARGE {
        return layout;
    }
    let whole = layout.size().next_multiple_of(LARGE);
    let size = if whole - layout.size() <= LARGE / 4 { whole } else { layout.size() };
    Layout::from_size_align(size, LARGE).unwrap_or(layout)
}

/// Lets the system's allocator take every large block from the kernel and give it back there, however many came
/// before: between small blocks, pages that are touched already keep huge ones out.
pub(crate) fn prepare() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    #[allow(unsafe_code)]
    // SAFETY: this sets a number in the allocator, and no other thread runs yet.
    unsafe {
        libc::mallopt(libc::M_MMAP_THRESHOLD, LARGE as libc::c_int);
    }
}

// SAFETY: every block comes from `System` and goes back to it with the layout it came with, which follows from that
// of the caller; `advise` changes neither the block nor its contents.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for HugePages {
    #[inline]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let layout = aligned(layout);
        // SAFETY: the caller keeps the contract of `alloc`.
        advise(unsafe { System.alloc(layout) }, layout.size())
    }

    #[inline]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        let layout = aligned(layout);
        // SAFETY: the caller keeps the contract of `alloc_zeroed`.
        advise(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    #[inline]
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        if layout.size().max(size) < LARGE {
            // SAFETY: the caller keeps the contract of `realloc`, and the block came from `System` as it is.
            return unsafe { System.realloc(block, layout, size) };
        }
        // SAFETY: the caller keeps the contract of `realloc`, which makes this layout valid.
        let moved = unsafe { self.alloc(Layout::from_size_align_unchecked(size, layout.align())) };
        if !moved.is_null() {
            // SAFETY: both blocks hold so much, and the new one lies elsewhere; the old one is not used again.
            unsafe {
                std::ptr::copy_nonoverlapping(block, moved, layout.size().min(size));
                self.dealloc(block, layout);
            }
        }
        moved
    }

    #[inline]
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps the contract of `dealloc`, and the block came from `System` with this layout.
        unsafe { System.dealloc(block, aligned(layout)) }
    }
}

/// Asks for huge pages under a block, if it is large.
#[inline]
fn advise(block: *mut u8, size: usize) -> *mut u8 {
    if size >= LARGE && !block.is_null() {
        request(block, size);
    }
    block
}

#[cfg(target_os = "linux")]
#[cold]
#[allow(unsafe_code)]
fn request(block: *mut u8, size: usize) {
    /// Where pages are larger the kernel refuses the range, which does no harm.
    const PAGE: usize = 4 << 10;
    // Whole pages: a mapping of which a part is advised is two mappings, which cannot grow in place.
    let before = block.addr() % PAGE;
    // SAFETY: the pages hold the block, so they are mapped, and this advice says nothing about what they hold.
    unsafe {
        libc::madvise(block.wrapping_sub(before).cast(), (before + size).next_multiple_of(PAGE), libc::MADV_HUGEPAGE)
    };
}

#[cfg(not(target_os = "linux"))]
fn request(_: *mut u8, _: usize) {}
