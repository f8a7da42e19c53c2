//! What can go wrong with a picture file.

use std::fmt;
use std::path::PathBuf;

/// Why a picture could not be read or written.
#[derive(Debug)]
pub enum ImageError {
    /// The file system refused.
    Io(PathBuf, std::io::Error),
    /// The bytes are not what they should be.
    Invalid(PathBuf, String),
    /// A kind of file or content that we do not handle.
    Unsupported(PathBuf, String),
    /// Two pictures that cannot be compared: (width, height) of each.
    SizeMismatch([usize; 2], [usize; 2]),
}

impl fmt::Display for ImageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(path, error) => write!(f, "{}: {error}", path.display()),
            Self::Invalid(path, why) => write!(f, "{}: not a valid picture: {why}", path.display()),
            Self::Unsupported(path, why) => write!(f, "{}: {why}", path.display()),
            Self::SizeMismatch([w, h], [v, g]) => write!(f, "sizes differ: {w}x{h} and {v}x{g}"),
        }
    }
}

impl std::error::Error for ImageError {}
