//! The bytes of a file, and its tokens where more than one reader wants them.

use super::{Symbol, Token, TokenKind, Words};
use crate::diag::FileId;
use rustc_hash::FxHashMap;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

/// The bytes of a file, which any number of readers may share, one after the other or at the same time.
///
/// What tokens are does not depend on who reads them, but for the number of the file and the numbers of its words. So
/// what is kept has neither, and each reader puts in its own.
#[derive(Debug)]
pub struct Text {
    bytes: Arc<Vec<u8>>,
    /// Its pieces as far as they were read; nothing before it is worth it.
    kept: OnceLock<Mutex<Vec<Arc<Kept>>>>,
}

/// The tokens of one piece, for whoever reads it.
#[derive(Debug)]
pub(super) struct Kept {
    /// Of no file; the symbol of a name is its place in `words`.
    tokens: Vec<Token>,
    /// In the order in which they were met.
    words: Vec<Box<str>>,
    /// Where the next piece begins.
    end: usize,
}

impl Text {
    /// Of these bytes.
    pub fn new(bytes: Vec<u8>) -> Self {
        Self { bytes: Arc::new(bytes), kept: OnceLock::new() }
    }

    /// The bytes.
    pub fn bytes(&self) -> &Arc<Vec<u8>> {
        &self.bytes
    }

    /// From now on whoever makes tokens keeps them for all others. They take up about six times as much memory as the
    /// text.
    pub fn keep_tokens(&self) {
        self.kept.get_or_init(Mutex::default);
    }

    /// A panic of another thread does not matter to plain data.
    fn pieces(&self) -> Option<MutexGuard<'_, Vec<Arc<Kept>>>> {
        Some(self.kept.get()?.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// The tokens of piece number `index`, if they are kept.
    pub(super) fn kept(&self, index: usize) -> Option<Arc<Kept>> {
        self.pieces()?.get(index).cloned()
    }

    /// Keeps the tokens of piece number `index`, behind which the next one begins at `end`, if they are wanted.
    pub(super) fn keep(&self, index: usize, tokens: &[Token], names: &Words, end: usize) {
        // Pieces are read in order, at first; a reader that came before tokens were kept may be further on.
        if let Some(mut pieces) = self.pieces().filter(|pieces| pieces.len() == index) {
            pieces.push(Arc::new(Kept::new(tokens, names, end)));
        }
    }
}

impl Kept {
    fn new(tokens: &[Token], names: &Words, end: usize) -> Self {
        let mut kept = Self { tokens: tokens.to_vec(), words: Vec::new(), end };
        let mut places = FxHashMap::default();
        for token in &mut kept.tokens {
            token.span.file = FileId::default();
            if let TokenKind::Name(symbol) = &mut token.kind {
                let place = *places.entry(*symbol).or_insert_with(|| {
                    kept.words.push(names.word(*symbol).as_ref().into());
                    Symbol((kept.words.len() - 1) as u32)
                });
                *symbol = place;
            }
        }
        kept
    }

    /// Writes the tokens in place of what `tokens` holds, as if they had been read there for the first time; gives back
    /// where the next piece begins.
    pub(super) fn write(&self, file: FileId, names: &mut Words, tokens: &mut Vec<Token>) -> usize {
        let symbols: Vec<Symbol> = self.words.iter().map(|word| names.intern(word)).collect();
        tokens.clear();
        tokens.extend(self.tokens.iter().map(|token| {
            let mut token = *token;
            token.span.file = file;
            if let TokenKind::Name(place) = &mut token.kind {
                *place = symbols[place.0 as usize];
            }
            token
        }));
        self.end
    }
}

#[cfg(test)]
mod tests {
    use super::super::Source;
    use super::*;

    /// All tokens of a text as another file and to other words, with the words of its names.
    fn read(text: &Arc<Text>, file: u32, known: &str) -> (Vec<Token>, Vec<String>) {
        let (mut names, source) = (Words::default(), Source::new(FileId(file), Arc::clone(text)));
        names.intern(known);
        let mut tokens = Vec::new();
        for index in 0.. {
            let Some(piece) = source.tokens(index, &mut names) else { break };
            tokens.extend_from_slice(&piece.tokens);
        }
        (tokens, names.iter().map(|(_, word)| word.to_owned()).collect())
    }

    #[test]
    fn kept_tokens_are_those_that_were_read() {
        let turn = "\u{feff}#declare A_1 = <1, 2>, <3, 4>; // x\n sphere { B #if (A_1 >= 2) \"s\" #end 1.2.3 }\n";
        let bytes = turn.repeat(1000).into_bytes();
        let kept = Arc::new(Text::new(bytes.clone()));
        read(&kept, 0, "none");
        assert!(kept.kept(0).is_none(), "once is not enough");
        kept.keep_tokens();
        for (file, known) in [(1, "B"), (2, "A_1"), (3, "none")] {
            assert_eq!(read(&kept, file, known), read(&Arc::new(Text::new(bytes.clone())), file, known));
        }
        assert!(kept.kept(9).is_some());
    }
}
