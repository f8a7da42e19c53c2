//! Every key of POV-Ray's INI files, what it takes, and what is done about it.
//!
//! Source: command line facts, section 10.

use super::settings::{Settings, Sort};
use super::values::{Takes, Value, real};
use crate::imaging::{Curve, Dither, FileKind};
use crate::job::six_digits;

/// A key.
#[derive(Clone, Copy, Debug)]
pub(super) struct Key {
    /// As POV-Ray's manual writes it; letters count in either case.
    pub(super) name: &'static str,
    pub(super) takes: Takes,
    pub(super) action: Action,
}

/// What is done about a key.
#[derive(Clone, Copy, Debug)]
pub(super) enum Action {
    /// It does what it says; an error says what was expected.
    Work(fn(&mut Settings, &Value) -> Result<(), String>),
    /// It is taken, and changes nothing here.
    Ignore,
    /// It is taken, and said once that it does nothing, and why.
    Note(&'static str),
}

const SHELL: &str = "shell commands are prohibited, and never run";
const FIELDS: &str = "fields are not rendered; POV-Ray 3.7 takes the option and renders whole frames, too";

use Action::{Ignore, Note, Work};
use Takes::{Bool, Gamma, Name, Real, Whole, Word};

/// All keys, by name.
#[rustfmt::skip]
pub(super) static KEYS: &[Key] = &[
    work("All_Console", Bool, |s, v| set(&mut s.streams[Sort::All as usize].console, v.on())),
    work("All_File", Name, |s, v| stream_file(s, Sort::All, v)),
    work("Antialias", Bool, |s, v| set(&mut s.antialias, v.on())),
    work("Antialias_Depth", Whole, |s, v| set(&mut s.depth, v.whole())),
    work("Antialias_Gamma", Real, |s, v| set(&mut s.antialias_gamma, v.real())),
    work("Antialias_Threshold", Real, |s, v| set(&mut s.threshold, v.real())),
    work("Append_File", Bool, |s, v| set(&mut s.appends, v.on())),
    work("Bits_Per_Color", Whole, |s, v| set(&mut s.bits, v.whole())),
    work("Bits_Per_Colour", Whole, |s, v| set(&mut s.bits, v.whole())),
    ignore("Bounding", Bool),
    ignore("Bounding_Method", Whole),
    ignore("Bounding_Threshold", Whole),
    ignore("BSP_BaseAccessCost", Real),
    ignore("BSP_ChildAccessCost", Real),
    ignore("BSP_ISectCost", Real),
    ignore("BSP_MaxDepth", Whole),
    ignore("BSP_MissChance", Real),
    work("Clock", Real, |s, v| set(&mut s.clock, Some(v.real()))),
    work("Compression", Whole, |s, v| set(&mut s.compression, v.whole())),
    work("Continue_Trace", Bool, |s, v| set(&mut s.continues, v.on())),
    work("Create_Ini", Name, |s, v| set(&mut s.create_ini, Some(v.text().into()))),
    work("Cyclic_Animation", Bool, |s, v| set(&mut s.cyclic, v.on())),
    work("Debug_Console", Bool, |s, v| set(&mut s.streams[Sort::Debug as usize].console, v.on())),
    work("Debug_File", Name, |s, v| stream_file(s, Sort::Debug, v)),
    work("Declare", Word, declare),
    ignore("Display", Bool),
    ignore("Display_Gamma", Gamma),
    work("Dither", Bool, |s, v| set(&mut s.dithers, v.on())),
    work("Dither_Method", Word, dither_method),
    ignore("Draw_Vistas", Bool),
    work("Fatal_Console", Bool, |s, v| set(&mut s.streams[Sort::Fatal as usize].console, v.on())),
    note("Fatal_Error_Command", Word, SHELL),
    note("Fatal_Error_Return", Word, SHELL),
    work("Fatal_File", Name, |s, v| stream_file(s, Sort::Fatal, v)),
    note("Field_Render", Bool, FIELDS),
    work("File_Gamma", Gamma, file_gamma),
    work("Final_Clock", Real, |s, v| set(&mut s.final_clock, v.real())),
    work("Final_Frame", Whole, |s, v| set(&mut s.final_frame, Some(v.whole()))),
    work("Frame_Step", Whole, |s, v| set(&mut s.step, v.whole())),
    work("Grayscale_Output", Bool, |s, v| set(&mut s.grey, v.on())),
    work("Height", Whole, |s, v| set(&mut s.size[1], v.whole())),
    ignore("High_Reproducibility", Bool),
    work("Include_Header", Name, |s, v| set(&mut s.header, Some(v.text().into()))),
    // Read where it stands, by the reader.
    ignore("Include_Ini", Name),
    work("Initial_Clock", Real, |s, v| set(&mut s.initial_clock, v.real())),
    work("Initial_Frame", Whole, |s, v| set(&mut s.initial_frame, Some(v.whole()))),
    work("Input_File_Name", Name, |s, v| set(&mut s.scene, Some(v.text().into()))),
    work("Jitter", Bool, |s, v| set(&mut s.jitter, v.on())),
    work("Jitter_Amount", Real, |s, v| { s.jitter = v.real() > 0.0; set(&mut s.jitter_amount, v.real()) }),
    work("Library_Path", Name, library_path),
    ignore("Light_Buffer", Bool),
    ignore("Max_Image_Buffer_Memory", Whole),
    note("Odd_Field", Bool, FIELDS),
    work("Output_Alpha", Bool, |s, v| set(&mut s.alpha, v.on())),
    work("Output_File_Name", Name, |s, v| set(&mut s.output, Some(v.text().into()))),
    work("Output_File_Type", Word, file_kind),
    work("Output_To_File", Bool, |s, v| set(&mut s.to_file, v.on())),
    ignore("Palette", Word),
    ignore("Pause_When_Done", Bool),
    note("Post_Frame_Command", Word, SHELL),
    note("Post_Frame_Return", Word, SHELL),
    note("Post_Scene_Command", Word, SHELL),
    note("Post_Scene_Return", Word, SHELL),
    note("Pre_Frame_Command", Word, SHELL),
    note("Pre_Frame_Return", Word, SHELL),
    note("Pre_Scene_Command", Word, SHELL),
    note("Pre_Scene_Return", Word, SHELL),
    ignore("Preview_End_Size", Whole),
    ignore("Preview_Start_Size", Whole),
    work("Quality", Whole, |s, v| set(&mut s.quality, v.whole())),
    work("Radiosity_File_Name", Name, |s, v| set(&mut s.radiosity_file, v.text().into())),
    work("Radiosity_From_File", Bool, |s, v| set(&mut s.radiosity_from_file, v.on())),
    work("Radiosity_To_File", Bool, |s, v| set(&mut s.radiosity_to_file, v.on())),
    ignore("Radiosity_Vain_Pretrace", Bool),
    note("Real_Time_Raytracing", Bool, "frames are not shown while they are made"),
    ignore("Remove_Bounds", Bool),
    work("Render_Block_Size", Whole, block_size),
    ignore("Render_Block_Step", Whole),
    work("Render_Console", Bool, |s, v| set(&mut s.streams[Sort::Render as usize].console, v.on())),
    work("Render_File", Name, |s, v| stream_file(s, Sort::Render, v)),
    ignore("Render_Pattern", Whole),
    work("Sampling_Method", Whole, |s, v| set(&mut s.method, v.whole())),
    ignore("Split_Unions", Bool),
    work("Start_Column", Real, |s, v| set(&mut s.start[0], Some(v.real()))),
    work("End_Column", Real, |s, v| set(&mut s.end[0], Some(v.real()))),
    work("Start_Row", Real, |s, v| set(&mut s.start[1], Some(v.real()))),
    work("End_Row", Real, |s, v| set(&mut s.end[1], Some(v.real()))),
    work("Statistic_Console", Bool, |s, v| set(&mut s.streams[Sort::Statistics as usize].console, v.on())),
    work("Statistic_File", Name, |s, v| stream_file(s, Sort::Statistics, v)),
    work("Subset_End_Frame", Real, |s, v| set(&mut s.subset[1], Some(v.real()))),
    work("Subset_Start_Frame", Real, |s, v| set(&mut s.subset[0], Some(v.real()))),
    ignore("Test_Abort", Bool),
    ignore("Test_Abort_Count", Whole),
    note("User_Abort_Command", Word, SHELL),
    note("User_Abort_Return", Word, SHELL),
    work("Verbose", Bool, |s, v| set(&mut s.verbose, v.on())),
    work("Version", Real, version),
    ignore("Video_Mode", Word),
    ignore("Vista_Buffer", Bool),
    work("Warning_Console", Bool, |s, v| set(&mut s.streams[Sort::Warning as usize].console, v.on())),
    work("Warning_File", Name, |s, v| stream_file(s, Sort::Warning, v)),
    ignore("Warning_Level", Whole),
    work("Width", Whole, |s, v| set(&mut s.size[0], v.whole())),
    work("Work_Threads", Whole, threads),
];

const fn work(name: &'static str, takes: Takes, set: fn(&mut Settings, &Value) -> Result<(), String>) -> Key {
    Key { name, takes, action: Work(set) }
}

const fn ignore(name: &'static str, takes: Takes) -> Key {
    Key { name, takes, action: Ignore }
}

const fn note(name: &'static str, takes: Takes, why: &'static str) -> Key {
    Key { name, takes, action: Note(why) }
}

impl Key {
    /// The key of a name, in any case.
    pub(super) fn named(name: &str) -> Option<&'static Self> {
        KEYS.iter().find(|key| key.name.eq_ignore_ascii_case(name))
    }

    /// Whether every assignment counts, not the last alone.
    pub(super) fn adds_up(&self) -> bool {
        matches!(self.name, "Library_Path" | "Declare")
    }
}

fn set<T>(place: &mut T, value: T) -> Result<(), String> {
    *place = value;
    Ok(())
}

fn stream_file(settings: &mut Settings, sort: Sort, value: &Value) -> Result<(), String> {
    let name = value.text();
    let usual = ["true", "on", "yes", "1"].iter().any(|word| name.eq_ignore_ascii_case(word));
    settings.streams[sort as usize].file = Some(if usual { sort.default_file() } else { name }.into());
    Ok(())
}

fn library_path(settings: &mut Settings, value: &Value) -> Result<(), String> {
    let folder = match value.text().trim_end_matches('/') {
        "" => "/",
        folder => folder,
    };
    if !settings.library.iter().any(|known| known.as_os_str() == folder) {
        settings.library.push(folder.into());
    }
    Ok(())
}

/// A number that the scene knows by a name; of several the first counts.
fn declare(settings: &mut Settings, value: &Value) -> Result<(), String> {
    let (name, number) = value.text().split_once('=').ok_or("expected Declare=NAME=NUMBER")?;
    let name = name.trim();
    let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if !is_name {
        return Err(format!("'{name}' is no name that a scene could use"));
    }
    let number: f64 =
        number.trim().parse().map_err(|_| format!("'{number}' is not a number; only numbers can be declared"))?;
    if !settings.declarations.iter().any(|(known, _)| known == name) {
        settings.declarations.push((name.into(), six_digits(number)));
    }
    Ok(())
}

/// Bits and what else follows the letter have no effect, as in POV-Ray.
fn file_kind(settings: &mut Settings, value: &Value) -> Result<(), String> {
    settings.kind = value.text().chars().next().and_then(kind_of).ok_or(KINDS)?;
    Ok(())
}

pub(super) const KINDS: &str = "the kinds of pictures are N (PNG), P (PPM), T and C (TGA, plain and packed), B (BMP), J (JPEG), E (OpenEXR) and H (HDR)";

/// The kind of picture behind a letter.
pub(super) fn kind_of(letter: char) -> Option<FileKind> {
    match letter.to_ascii_uppercase() {
        'N' => Some(FileKind::Png),
        'P' => Some(FileKind::Ppm),
        'T' => Some(FileKind::Tga { packed: false }),
        'C' => Some(FileKind::Tga { packed: true }),
        'B' => Some(FileKind::Bmp),
        'J' => Some(FileKind::Jpeg),
        'E' => Some(FileKind::Exr),
        'H' => Some(FileKind::Hdr),
        _ => None,
    }
}

fn dither_method(settings: &mut Settings, value: &Value) -> Result<(), String> {
    settings.dither = match value.text().to_ascii_uppercase().as_str() {
        "FS" => Dither::FloydSteinberg,
        "D1" => Dither::Next,
        "D2" => Dither::Simple,
        "B2" => Dither::Ordered(2),
        "B3" => Dither::Ordered(3),
        "B4" => Dither::Ordered(4),
        _ => return Err("the ways of dithering are FS, D1, D2, B2, B3 and B4".into()),
    };
    Ok(())
}

fn file_gamma(settings: &mut Settings, value: &Value) -> Result<(), String> {
    /// Less is refused. Source: camera and image facts, section 4.1.
    const LEAST: f64 = 0.001;
    settings.file_gamma = match value {
        Value::Text(_) => Curve::Srgb,
        _ if value.real() < LEAST => return Err(format!("a gamma must be at least {LEAST}")),
        _ => Curve::power(value.real()),
    };
    Ok(())
}

fn block_size(_: &mut Settings, value: &Value) -> Result<(), String> {
    if value.whole() < 4 { Err("a block has at least 4 pixels along a side".into()) } else { Ok(()) }
}

fn version(settings: &mut Settings, value: &Value) -> Result<(), String> {
    let hundredths = (value.real() * 100.0).round();
    if !(0.0..=370.0).contains(&hundredths) {
        return Err("must be 0 to 3.7".into());
    }
    // There is nothing below 1.0. Source: command line facts, section 10.
    settings.version = Some((hundredths as u32).max(100));
    Ok(())
}

fn threads(settings: &mut Settings, value: &Value) -> Result<(), String> {
    /// More help nobody.
    const MOST: i64 = 512;
    settings.threads = value.whole().clamp(0, MOST);
    Ok(())
}

/// A threshold as it may stand behind `+A`: POV-Ray takes what begins with `0.`.
pub(super) fn threshold(text: &str) -> Option<f64> {
    real(text).filter(|_| text.starts_with("0."))
}
