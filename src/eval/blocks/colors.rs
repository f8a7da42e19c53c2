//! The words of colours, for whoever asks what may stand in a pigment; they are read in `eval/colors.rs`, wherever a colour
//! may stand.

use super::table::{Block, Item, Takes};
use crate::syntax::Keyword as K;

/// A word of a colour.
const fn color(word: K, takes: &'static str, help: &'static str) -> Item<()> {
    Item::new(word, Takes::Elsewhere(takes), "", help)
}

pub(super) static COLORS: Block<()> = Block::new(
    "colours",
    "how colours are written; a declared name or a vector of five is one, too",
    &[
        color(K::Rgb, "VECTOR", "red, green and blue"),
        color(K::Rgbf, "<4 FLOATS>", "red, green, blue and filter"),
        color(K::Rgbt, "<4 FLOATS>", "red, green, blue and transmit"),
        color(K::Rgbft, "<5 FLOATS>", "red, green, blue, filter and transmit"),
        color(K::Srgb, "VECTOR", "the same as on a screen"),
        color(K::Srgbf, "<4 FLOATS>", "the same as on a screen, and filter"),
        color(K::Srgbt, "<4 FLOATS>", "the same as on a screen, and transmit"),
        color(K::Srgbft, "<5 FLOATS>", "the same as on a screen, filter and transmit"),
        color(K::Color, "COLOUR", "may stand before any colour"),
        color(K::Colour, "COLOUR", "may stand before any colour"),
        color(K::Red, "FLOAT", "one component; also behind a colour"),
        color(K::Green, "FLOAT", "one component; also behind a colour"),
        color(K::Blue, "FLOAT", "one component; also behind a colour"),
        color(K::Filter, "FLOAT", "what is let through coloured; also behind a colour"),
        color(K::Transmit, "FLOAT", "what is let through as it is; also behind a colour"),
        color(K::Alpha, "FLOAT", "outdated: filter"),
    ],
);
