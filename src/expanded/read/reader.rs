//! The scene under way, what was declared, and what is said of wrong places.

use super::tree::{Items, Node, Read, Rule, wrong};
use crate::eval::{Host, Options, Status};
use crate::function::Spline;
use crate::imaging::Encoded;
use crate::math::Color;
use crate::scene::{
    Blend, Density, Finish, Function, Gamma, GeometryQueries, ImageFormat, Interior, Normal, Object, Pigment, Scene,
    Settings, Texture,
};
use rustc_hash::FxHashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a name stands for.
#[derive(Clone)]
pub(super) enum Value {
    Texture(Arc<Texture>),
    Pigment(Arc<Pigment>),
    Normal(Arc<Normal>),
    Finish(Arc<Finish>),
    Interior(Arc<Interior>),
    Density(Arc<Density>),
    ColorMap(Arc<Blend<Color>>),
    PigmentMap(Arc<Blend<Arc<Pigment>>>),
    Object(Arc<Object>),
    Function(Arc<Function>),
    Spline(Arc<Spline>),
}

/// Makes a scene of a tree.
pub(super) struct Reader<'a> {
    pub(super) scene: Scene,
    pub(super) host: &'a dyn Host,
    pub(super) queries: &'a dyn GeometryQueries,
    pub(super) options: &'a Options,
    /// Where the scene's own file is.
    folder: PathBuf,
    names: FxHashMap<&'a str, Value>,
    /// In hundredths.
    pub(super) version: u32,
    /// `assumed_gamma` was given.
    gamma_given: bool,
    pub(super) utf8: bool,
    default: Arc<Texture>,
    pictures: FxHashMap<(PathBuf, ImageFormat), Arc<Encoded>>,
    fonts: FxHashMap<PathBuf, Arc<Vec<u8>>>,
    /// The settings as functions see them, until they change.
    settings: Option<Arc<Settings>>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(path: &Path, options: &'a Options, host: &'a dyn Host, queries: &'a dyn GeometryQueries) -> Self {
        Self {
            scene: Scene::default(),
            host,
            queries,
            options,
            folder: path.parent().map(Path::to_owned).unwrap_or_default(),
            names: FxHashMap::default(),
            version: 0,
            gamma_given: false,
            utf8: false,
            default: Arc::new(Texture::default()),
            pictures: FxHashMap::default(),
            fonts: FxHashMap::default(),
            settings: None,
        }
    }

    /// The whole scene.
    pub(super) fn scene(&mut self, tree: Node<'a>) -> Read<()> {
        for node in tree.into_inner() {
            self.statement(node)?;
        }
        self.finish();
        Ok(())
    }

    fn statement(&mut self, node: Node<'a>) -> Read<()> {
        match node.as_rule() {
            Rule::version => self.read_version(node)?,
            Rule::declaration => self.declaration(node)?,
            Rule::default => self.default(node)?,
            Rule::global_settings => {
                self.settings = None;
                self.gamma_given |= self.global_settings(node)?;
            }
            Rule::camera => self.scene.camera = self.camera(node)?,
            Rule::background => self.scene.background = Some(self.background(node)?),
            Rule::sky_sphere => self.scene.sky_sphere = Some(self.sky_sphere(node)?),
            Rule::fog => {
                let fog = self.fog(node)?;
                self.scene.fogs.push(fog);
            }
            Rule::rainbow => {
                let rainbow = self.rainbow(node)?;
                self.scene.rainbows.push(rainbow);
            }
            Rule::media => {
                let media = self.media(node)?;
                self.scene.media.push(media);
            }
            Rule::EOI => {}
            _ => {
                let object = self.object(node)?;
                self.scene.objects.push(Arc::unwrap_or_clone(object));
                self.scene.default_textures.push(Arc::clone(&self.default));
            }
        }
        Ok(())
    }

    fn read_version(&mut self, node: Node<'a>) -> Read<()> {
        let mut items = Items::of(node);
        let number = items.node()?;
        let hundredths = (super::tree::number(&number)? * 100.0).round();
        if !(0.0..=370.0).contains(&hundredths) {
            return wrong(&number, "the version must be 0 to 3.7");
        }
        self.version = hundredths as u32;
        Ok(())
    }

    fn declaration(&mut self, node: Node<'a>) -> Read<()> {
        let mut items = Items::of(node);
        let name = items.word()?;
        let value = items.node()?;
        let value = match value.as_rule() {
            Rule::textures => Value::Texture(self.textures(value)?),
            Rule::pigment => Value::Pigment(self.pigment(value)?),
            Rule::normal => Value::Normal(self.normal(value)?),
            Rule::finish => Value::Finish(self.finish_block(value)?),
            Rule::interior => Value::Interior(self.interior(value)?),
            Rule::density => Value::Density(self.density(value)?),
            Rule::color_map => Value::ColorMap(self.color_map(value)?),
            Rule::pigment_map => Value::PigmentMap(self.pigment_map(value, false)?),
            Rule::spline => Value::Spline(self.spline(value)?),
            Rule::function => Value::Function(self.declared_function(value)?),
            _ => Value::Object(self.object(value)?),
        };
        self.names.insert(name, value);
        Ok(())
    }

    fn default(&mut self, node: Node<'a>) -> Read<()> {
        let mut items = Items::of(node);
        let value = items.node()?;
        if value.as_rule() == Rule::importance {
            self.scene.settings.radiosity_importance = self.importance(value)?;
            return Ok(());
        }
        let texture = self.texture(value.clone())?;
        match &*texture {
            Texture::Layers(layers) if layers.len() == 1 => self.default = texture,
            _ => return wrong(&value, "the default texture must be a plain one, without layers or pattern"),
        }
        Ok(())
    }

    /// What holds for the scene as a whole, as where a scene of any kind ends.
    fn finish(&mut self) {
        let (settings, overrides) = (&mut self.scene.settings, &self.options.overrides);
        settings.max_parts = self.options.limits.parts;
        settings.max_trace_level = overrides.max_trace_level.unwrap_or(settings.max_trace_level);
        settings.adc_bailout = overrides.adc_bailout.unwrap_or(settings.adc_bailout);
        settings.version = self.version;
        if !self.gamma_given && self.version >= 370 {
            settings.gamma = Gamma::implied(370);
        }
    }

    /// What an identifier stands for, as `pick` wants it.
    pub(super) fn known<T>(&self, node: &Node<'_>, what: &str, pick: impl Fn(&Value) -> Option<T>) -> Read<T> {
        let name = node.as_str();
        match self.names.get(name) {
            Some(value) => match pick(value) {
                Some(value) => Ok(value),
                None => wrong(node, format!("'{name}' is no {what}")),
            },
            None => wrong(node, format!("'{name}' is not declared before this")),
        }
    }

    /// The levels inside something, if they are not too many: names build them without nesting any text.
    pub(super) fn nested(&self, depth: u32, node: &Node<'_>) -> Read<u32> {
        let limit = self.options.limits.nesting;
        if depth as usize > limit {
            return wrong(node, format!("more than {limit} levels inside one another"));
        }
        Ok(depth)
    }

    /// The settings of here, for a function.
    pub(super) fn settings_here(&mut self) -> Arc<Settings> {
        Arc::clone(self.settings.get_or_insert_with(|| Arc::new(self.scene.settings.clone())))
    }

    /// A file that the scene refers to.
    pub(super) fn find(&self, name: &str, node: &Node<'_>) -> Read<PathBuf> {
        let named = PathBuf::from(name);
        let mut candidates = vec![named.clone()];
        if !named.is_absolute() {
            candidates.extend(self.options.include_dirs.iter().map(|folder| folder.join(name)));
            candidates.push(self.folder.join(name));
        }
        let with = |status| candidates.iter().find(|path| self.host.status(path) == status).cloned();
        match with(Status::Readable).or_else(|| with(Status::Refused)) {
            Some(path) => Ok(path),
            None => wrong(node, format!("cannot find the file \"{name}\"")),
        }
    }

    pub(super) fn bytes(&self, path: &Path, node: &Node<'_>) -> Read<Vec<u8>> {
        self.host.read(path).or_else(|error| wrong(node, format!("cannot read {}: {error}", path.display())))
    }

    /// The bytes of a picture, once for all that name it.
    pub(super) fn picture(&mut self, path: PathBuf, format: ImageFormat, node: &Node<'_>) -> Read<Arc<Encoded>> {
        let key = (path, format);
        if let Some(known) = self.pictures.get(&key) {
            return Ok(Arc::clone(known));
        }
        let bytes = self.bytes(&key.0, node)?;
        let file = self.host.picture(Encoded::new(key.0.clone(), format.decoder(), bytes));
        self.pictures.insert(key, Arc::clone(&file));
        Ok(file)
    }

    /// A font, once for all that name it.
    pub(super) fn font(&mut self, path: &Path, node: &Node<'_>) -> Read<Arc<Vec<u8>>> {
        if let Some(known) = self.fonts.get(path) {
            return Ok(Arc::clone(known));
        }
        let font = self.host.font(path, self.bytes(path, node)?);
        self.fonts.insert(path.to_owned(), Arc::clone(&font));
        Ok(font)
    }
}

/// An error of something that belongs nowhere where it stands, though the grammar lets it.
pub(super) fn misplaced<T>(node: &Node<'_>) -> Read<T> {
    let word = node.as_str().split([' ', '{', '\n']).next().unwrap_or_default();
    wrong(node, format!("'{word}' has no place here"))
}
