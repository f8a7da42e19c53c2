//! Directives, for whoever asks what there is; [`crate::syntax::Directive`] is what readers go by.

use super::table::{Block, Item, Takes};
use crate::syntax::Keyword as K;

/// A directive; `takes` with the `#` of those that belong to it.
const fn directive(word: K, takes: &'static str, help: &'static str) -> Item<()> {
    Item::new(word, Takes::Elsewhere(takes), "", help)
}

pub(super) static DIRECTIVES: Block<()> = Block::new(
    "directives",
    "what stands behind a #, between any two words",
    &[
        directive(K::Declare, "NAME = VALUE;", "gives a name a value, all over the scene"),
        directive(K::Local, "NAME = VALUE;", "gives a name a value, in this macro or include file"),
        directive(K::Undef, "NAME", "forgets a name"),
        directive(K::Default, "{ TEXTURE | PIGMENT | NORMAL | FINISH }", "what objects and textures start from"),
        directive(K::Version, "FLOAT;", "the version of the language by whose rules the scene goes on"),
        directive(K::Include, "STRING", "reads another file here"),
        directive(K::Macro, "NAME (NAMES) … #end", "text with parameters, to be called as NAME(VALUES)"),
        directive(K::If, "(CONDITION) … #elseif (CONDITION) … #else … #end", "reads what stands under what holds"),
        directive(K::Ifdef, "(NAME) … #else … #end", "whether a name has a value"),
        directive(K::Ifndef, "(NAME) … #else … #end", "whether a name has no value"),
        directive(K::Elseif, "(CONDITION)", "another condition of an #if"),
        directive(K::Else, "", "what is read if no condition holds"),
        directive(K::Switch, "(FLOAT) #case (FLOAT) … #range (FLOAT, FLOAT) … #else … #end", "chooses by a number"),
        directive(K::Case, "(FLOAT)", "reads from here on if the number is this"),
        directive(K::Range, "(FLOAT, FLOAT)", "reads from here on if the number is between these"),
        directive(K::Break, "", "leaves the loop or the #switch"),
        directive(K::While, "(CONDITION) … #end", "reads over and over as long as something holds"),
        directive(K::For, "(NAME, FROM, TO [, STEP]) … #end", "reads once for each value of a name"),
        directive(K::End, "", "ends what the directives with … begin"),
        directive(K::Fopen, "NAME STRING read | write | append", "opens a file"),
        directive(K::Read, "(FILE, NAME, …)", "takes values from a file"),
        directive(K::Write, "(FILE, VALUE, …)", "adds values to a file"),
        directive(K::Fclose, "NAME", "closes a file"),
        directive(K::Debug, "STRING", "says something"),
        directive(K::Warning, "STRING", "says what may be wrong"),
        directive(K::Error, "STRING", "says what is wrong, and stops"),
        directive(K::Render, "STRING", "says something"),
        directive(K::Statistics, "STRING", "says something"),
    ],
);

#[cfg(test)]
mod tests {
    use super::DIRECTIVES;
    use crate::syntax::{Directive, Keyword};

    #[test]
    fn all_directives_are_described() {
        for word in Keyword::ALL {
            assert_eq!(DIRECTIVES.knows(*word), Directive::from_keyword(*word).is_some(), "{}", word.word());
        }
    }
}
