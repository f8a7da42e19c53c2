//! Memory for large blocks in huge pages, where Linux gives them on request.
//!
//! A scene of a hundred thousand objects touches a hundred megabytes while it is read and compiled. On a virtual
//! machine each first touch of a 4 KiB page costs about 10,000 cycles, and rays that jump about in a hierarchy of
//! that size miss the translation buffers. The scene of `benches/generate_spheres.py` at 640x480 takes a tenth fewer
//! cycles with this allocator and with reading on the first thread, half as many of them in the kernel, which is why
//! this one module may be unsafe.

use std::alloc::{GlobalAlloc, Layout, System};

/// The system's allocator, with a request for huge pages under every large block.
pub(crate) struct HugePages;

/// Blocks from the size of a huge page of most processors on.
const LARGE: usize = 2 << 20;

// SAFETY: every block comes from `System` and goes back to it with the layout it came with; `advise` changes neither
// the block nor its contents.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for HugePages {
    #[inline]
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller keeps the contract of `alloc`.
        advise(unsafe { System.alloc(layout) }, layout.size())
    }

    #[inline]
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller keeps the contract of `alloc_zeroed`.
        advise(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    #[inline]
    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the caller keeps the contract of `realloc`, and the block came from `System`.
        advise(unsafe { System.realloc(block, layout, size) }, size)
    }

    #[inline]
    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the caller keeps the contract of `dealloc`, and the block came from `System`.
        unsafe { System.dealloc(block, layout) }
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
