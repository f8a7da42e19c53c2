//! What height fields and textures share about pictures.

use crate::scene::ImageFormat;

/// The name under which [`imaging::decode`](crate::imaging::decode) knows a file type.
pub(super) fn decoder_name(format: ImageFormat) -> &'static str {
    match format {
        ImageFormat::Png => "png",
        ImageFormat::Gif => "gif",
        ImageFormat::Tga => "tga",
        ImageFormat::Bmp => "bmp",
        ImageFormat::Pnm => "pnm",
        ImageFormat::Jpeg => "jpeg",
        ImageFormat::Tiff => "tiff",
        ImageFormat::Exr => "exr",
        ImageFormat::Hdr => "hdr",
        ImageFormat::Pot => "pot",
    }
}

/// The 16-bit level, 0 to 65535, in which a picture made by a function holds a value; outside 0 to 1 it wraps
/// around. Source: function facts, section 8.2.
pub(super) fn stored_level(value: f64) -> f64 {
    (f64::from(value as f32) * 65535.0).trunc().rem_euclid(65536.0)
}
