//! Pictures: the pixel buffer, files in and out, and how two pictures differ.
//!
//! Pixels are height x width x (red, green, blue, alpha), row-major, top row first, linear light,
//! `f32`, premultiplied by alpha. Knows nothing of scenes.
//!
//! ```
//! use whitted::imaging::{Picture, compare};
//! let (black, white) = (Picture::filled(4, 3, [0.0, 0.0, 0.0, 1.0]), Picture::filled(4, 3, [1.0; 4]));
//! assert_eq!(compare(&black, &black).unwrap().rmse, 0.0);
//! assert!(compare(&black, &white).unwrap().mean_display > 254.9);
//! ```

mod atomic;
mod cryptomatte;
mod decode;
mod display_file;
mod dither;
mod encoding;
mod error;
mod exr_blocks;
mod exr_read;
mod exr_write;
mod flip;
mod heatmap;
mod mark;
mod metrics;
mod picture;
mod quantise;
mod save;
mod tga;
mod transfer;

pub use atomic::{check_writable, pause_writing, sweep, write_whole};
pub use cryptomatte::cryptomatte;
pub use decode::{Encoded, Pixels, Samples, decode};
pub use encoding::{Curve, Dither, Encoding, FileKind};
pub use error::ImageError;
pub use exr_read::{read_exr, read_exr_figures};
pub use flip::flip;
pub use heatmap::heatmap;
pub use mark::{MARK, mark_of};
pub use metrics::{Difference, Verdict, Worst, compare};
pub use picture::{Layer, Metadata, Picture, Projection};
pub use save::{encode_png, save, save_as};
pub use transfer::{linear_from_srgb, srgb_from_linear};
