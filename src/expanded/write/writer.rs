//! The text under way: lines, blocks, and a declaration for each thing that is shared.

use super::origins::Origins;
use crate::diag::SourceMap;
use crate::scene::{Gamma, Settings};
use rustc_hash::FxHashMap;
use std::fmt::Display;
use std::path::Path;
use std::sync::Arc;

/// What a caller may choose.
pub struct Style<'a> {
    /// How a file is called that the scene refers to.
    pub file_name: &'a dyn Fn(&Path) -> String,
    /// Say in a comment where each object was written, with these sources, and by which calls if its span
    /// [tells](SourceMap::visits).
    pub origins: Option<&'a SourceMap>,
}

impl Default for Style<'_> {
    /// Files keep the names under which they were found, and nothing is said of origins.
    fn default() -> Self {
        Self { file_name: &|path| path.display().to_string(), origins: None }
    }
}

/// Longest line that a block is drawn together on.
const WIDTH: usize = 110;

/// Writes a scene, twice: the first time counts what is shared and how pictures were named, the second makes the text.
pub(super) struct Writer<'a> {
    pub(super) style: &'a Style<'a>,
    /// This run only counts.
    pub(super) counting: bool,
    /// How often each shared thing is met, by its place in memory.
    uses: FxHashMap<usize, u32>,
    /// What each is called, once it is declared.
    names: FxHashMap<usize, String>,
    /// How many names of each sort are taken.
    taken: FxHashMap<&'static str, usize>,
    /// Declarations that are complete.
    pub(super) declarations: String,
    /// What is being written.
    pub(super) out: String,
    /// Where its blocks began.
    open: Vec<usize>,
    /// The scene's settings.
    pub(super) settings: &'a Settings,
    /// Every texture is declared, ahead of any `#default`.
    pub(super) textures_ahead: bool,
    /// How colours related to light where the first picture was named.
    pub(super) pictures_mode: Option<Gamma>,
    /// Some text looks its characters up by Unicode.
    pub(super) unicode: bool,
    /// How many parts of expressions became functions.
    pub(super) parts: usize,
    /// The noise generator in force behind the declarations so far, where one of them needed another.
    pub(super) noise_ahead: Option<u8>,
    /// Tells where objects were written, on request.
    pub(super) origins: Option<Origins<'a>>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(style: &'a Style<'a>, settings: &'a Settings) -> Self {
        Self {
            style,
            counting: true,
            uses: FxHashMap::default(),
            names: FxHashMap::default(),
            taken: FxHashMap::default(),
            declarations: String::new(),
            out: String::new(),
            open: Vec::new(),
            settings,
            textures_ahead: false,
            pictures_mode: None,
            unicode: false,
            parts: 0,
            noise_ahead: None,
            origins: style.origins.map(Origins::new),
        }
    }

    /// Ends the run that counts.
    pub(super) fn start_writing(&mut self) {
        self.counting = false;
        self.names.clear();
        self.taken.clear();
        self.out.clear();
        self.declarations.clear();
        (self.parts, self.noise_ahead) = (0, None);
    }

    /// Adds a line at the present depth.
    pub(super) fn line(&mut self, text: impl Display) {
        if !self.counting {
            use std::fmt::Write as _;
            let depth = self.open.len();
            let _ = writeln!(self.out, "{:width$}{text}", "", width = 2 * depth);
        }
    }

    /// Opens a block behind a word.
    pub(super) fn open(&mut self, head: impl Display) {
        self.open_with(format_args!("{head} {{"));
    }

    /// The same with another sign, as entries of maps begin.
    pub(super) fn open_with(&mut self, line: impl Display) {
        let start = self.out.len();
        self.line(line);
        self.open.push(start);
    }

    /// Closes the last block, and draws it together on one line if it is short.
    pub(super) fn close(&mut self) {
        self.close_with("}");
    }

    /// The same for what ends with another sign, as entries of maps do.
    pub(super) fn close_with(&mut self, end: &str) {
        let start = self.open.pop().unwrap_or_default();
        self.line(end);
        let indent = 2 * self.open.len();
        let block = &self.out[start..];
        if self.counting || block.len() > 2 * WIDTH || block.contains("//") {
            return;
        }
        let joined: Vec<&str> = block.lines().map(str::trim).collect();
        let joined = joined.join(" ");
        if joined.len() + indent <= WIDTH {
            self.out.truncate(start);
            self.line(joined);
        }
    }

    /// A block with one line of content.
    pub(super) fn block(&mut self, head: &str, content: impl Display) {
        self.open(head);
        self.line(content);
        self.close();
    }

    /// Writes something apart and gives the text back, without the end of its last line.
    pub(super) fn apart(&mut self, write: impl FnOnce(&mut Self)) -> String {
        let (out, open) = (std::mem::take(&mut self.out), std::mem::take(&mut self.open));
        write(self);
        let mut text = std::mem::replace(&mut self.out, out);
        self.open = open;
        text.truncate(text.trim_end().len());
        text
    }

    /// The name of something that is met more than once or, with `always`, whenever it is met: the first time it is
    /// declared as `define` writes it. `None` for what stands where it is used.
    pub(super) fn shared<T: ?Sized>(
        &mut self,
        thing: &Arc<T>,
        sort: &'static str,
        always: bool,
        define: impl FnOnce(&mut Self),
    ) -> Option<String> {
        self.shared_at(Arc::as_ptr(thing).cast::<()>() as usize, sort, always, |w, _| define(w))
    }

    /// The same for what is known by some number; `define` gets the name.
    pub(super) fn shared_at(
        &mut self,
        key: usize,
        sort: &'static str,
        always: bool,
        define: impl FnOnce(&mut Self, &str),
    ) -> Option<String> {
        if self.counting {
            let uses = self.uses.entry(key).or_default();
            *uses += 1;
            let first = *uses == 1;
            if first && always {
                define(self, "");
            }
            return (!first || always).then(String::new);
        }
        if let Some(name) = self.names.get(&key) {
            return Some(name.clone());
        }
        if !always && self.uses.get(&key).is_none_or(|uses| *uses < 2) {
            return None;
        }
        let number = self.taken.entry(sort).or_default();
        *number += 1;
        let name = format!("{sort}_{number}");
        let text = self.apart(|w| define(w, &name));
        self.declare(&name, &text);
        self.names.insert(key, name.clone());
        Some(name)
    }

    /// Adds a declaration.
    fn declare(&mut self, name: &str, text: &str) {
        // Values need the semicolon, blocks must not have one.
        self.declarations.push_str("#declare ");
        self.declarations.push_str(name);
        self.declarations.push_str(" = ");
        self.declarations.push_str(text);
        self.declarations.push('\n');
    }

    /// Adds a statement between declarations.
    pub(super) fn statement_ahead(&mut self, text: &str) {
        if !self.counting {
            self.declarations.push_str(text);
            self.declarations.push('\n');
        }
    }

    /// A note that only our own reader takes in: POV-Ray sees a comment.
    pub(super) fn note(&mut self, text: impl Display) {
        self.line(format_args!("/*= {text} */"));
    }
}
