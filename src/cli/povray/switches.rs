//! Every switch: a letter or two behind a plus or minus, and the keys that it stands for.
//!
//! Source: command line facts, sections 1 and 10.

use super::keys::{KINDS, kind_of, threshold};

/// A switch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Switch {
    /// Behind the sign, in either case.
    pub(super) letters: &'static str,
    pub(super) form: Form,
}

/// What may follow the letters, and what it means.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    /// Nothing; the sign says on or off.
    Flag(&'static str),
    /// A value for this key; the sign says nothing.
    Value(&'static str),
    /// Perhaps a value for the second key; the sign says on or off for the first.
    FlagAndValue(&'static str, &'static str),
    /// As before, but a value that begins with `0.`.
    Threshold(&'static str, &'static str),
    /// Perhaps a kind of picture, `g` for grey, and bits.
    Picture,
    /// Anything; it has no effect here.
    Anything,
    /// Nothing.
    Bare,
}

/// Key and value.
pub(super) type Assignment = (&'static str, String);

use Form::{Anything, Bare, Flag, FlagAndValue, Picture, Threshold, Value};

/// All switches.
#[rustfmt::skip]
pub(super) const SWITCHES: &[Switch] = &[
    switch("A", Threshold("Antialias", "Antialias_Threshold")),
    switch("AG", Value("Antialias_Gamma")),
    switch("AM", Value("Sampling_Method")),
    switch("B", Bare),
    switch("BM", Value("Bounding_Method")),
    switch("BS", Value("Render_Block_Size")),
    switch("C", Flag("Continue_Trace")),
    switch("D", Anything),
    switch("EC", Value("End_Column")),
    switch("EF", Value("Subset_End_Frame")),
    switch("EP", Value("Preview_End_Size")),
    switch("ER", Value("End_Row")),
    switch("F", Picture),
    switch("GA", FlagAndValue("All_Console", "All_File")),
    switch("GD", FlagAndValue("Debug_Console", "Debug_File")),
    switch("GF", FlagAndValue("Fatal_Console", "Fatal_File")),
    switch("GI", Value("Create_Ini")),
    switch("GP", Flag("Append_File")),
    switch("GR", FlagAndValue("Render_Console", "Render_File")),
    switch("GS", FlagAndValue("Statistic_Console", "Statistic_File")),
    switch("GW", FlagAndValue("Warning_Console", "Warning_File")),
    switch("H", Value("Height")),
    switch("HI", Value("Include_Header")),
    switch("HR", Flag("High_Reproducibility")),
    switch("I", Value("Input_File_Name")),
    switch("J", FlagAndValue("Jitter", "Jitter_Amount")),
    switch("K", Value("Clock")),
    switch("KC", Flag("Cyclic_Animation")),
    switch("KF", Value("Final_Clock")),
    switch("KFF", Value("Final_Frame")),
    switch("KFI", Value("Initial_Frame")),
    switch("KI", Value("Initial_Clock")),
    switch("L", Value("Library_Path")),
    switch("MB", FlagAndValue("Bounding", "Bounding_Threshold")),
    switch("MI", Value("Max_Image_Buffer_Memory")),
    switch("MV", Value("Version")),
    switch("O", Value("Output_File_Name")),
    switch("P", Flag("Pause_When_Done")),
    switch("Q", Value("Quality")),
    switch("R", Value("Antialias_Depth")),
    switch("RF", Value("Radiosity_File_Name")),
    switch("RFI", Flag("Radiosity_From_File")),
    switch("RFO", Flag("Radiosity_To_File")),
    switch("RP", Value("Render_Pattern")),
    switch("RS", Value("Render_Block_Step")),
    switch("RTR", Flag("Real_Time_Raytracing")),
    switch("RVP", Flag("Radiosity_Vain_Pretrace")),
    switch("SC", Value("Start_Column")),
    switch("SF", Value("Subset_Start_Frame")),
    switch("SP", Value("Preview_Start_Size")),
    switch("SR", Value("Start_Row")),
    switch("STP", Value("Frame_Step")),
    switch("SU", Flag("Split_Unions")),
    switch("TH", FlagAndValue("Dither", "Dither_Method")),
    switch("UA", Flag("Output_Alpha")),
    switch("UD", Flag("Draw_Vistas")),
    switch("UF", Flag("Field_Render")),
    switch("UL", Flag("Light_Buffer")),
    switch("UO", Flag("Odd_Field")),
    switch("UR", Flag("Remove_Bounds")),
    switch("UV", Flag("Vista_Buffer")),
    switch("V", Flag("Verbose")),
    switch("W", Value("Width")),
    switch("WL", Value("Warning_Level")),
    switch("WT", Value("Work_Threads")),
    switch("X", FlagAndValue("Test_Abort", "Test_Abort_Count")),
];

const fn switch(letters: &'static str, form: Form) -> Switch {
    Switch { letters, form }
}

/// What a switch with its sign means, or why it is none.
pub(super) fn assignments(word: &str) -> Result<Vec<Assignment>, String> {
    let (sign, body) = word.split_at(1);
    let on = if sign == "+" { "on" } else { "off" };
    let mut fitting: Vec<(&Switch, &str)> =
        SWITCHES.iter().filter_map(|switch| Some((switch, after(body, switch)?))).collect();
    fitting.sort_by_key(|(switch, _)| std::cmp::Reverse(switch.letters.len()));
    let mut first_reason = None;
    for (switch, rest) in fitting {
        match switch.form.assignments(on, rest) {
            Ok(assignments) => return Ok(assignments),
            Err(reason) => drop(first_reason.get_or_insert_with(|| format!("{sign}{}: {reason}", switch.letters))),
        }
    }
    Err(first_reason.unwrap_or_else(|| "there is no such switch".into()))
}

/// What follows the letters of a switch.
fn after<'b>(body: &'b str, switch: &Switch) -> Option<&'b str> {
    let head = body.get(..switch.letters.len())?;
    head.eq_ignore_ascii_case(switch.letters).then(|| &body[head.len()..])
}

impl Form {
    fn assignments(self, on: &str, rest: &str) -> Result<Vec<Assignment>, String> {
        let is_bare = rest.is_empty();
        match self {
            Flag(key) if is_bare => Ok(vec![(key, on.into())]),
            Flag(_) | Bare if !is_bare => Err(format!("nothing may follow, but '{rest}' does")),
            Value(_) if is_bare => Err("a value must follow, without a blank".into()),
            Value(key) => Ok(vec![(key, rest.into())]),
            FlagAndValue(key, value) | Threshold(key, value) => {
                if matches!(self, Threshold(..)) && !is_bare && threshold(rest).is_none() {
                    return Err(format!("a threshold is written as in +A0.3, not '{rest}'"));
                }
                let mut assignments = vec![(key, on.to_owned())];
                if !is_bare {
                    assignments.push((value, rest.to_owned()));
                }
                Ok(assignments)
            }
            Picture => picture(on, rest),
            Anything | Bare | Flag(_) => Ok(Vec::new()),
        }
    }
}

/// `+FN12`, `+FNg`, `-FJ`, `+F`. A number behind other kinds than PNG and PPM says nothing.
fn picture(on: &str, rest: &str) -> Result<Vec<Assignment>, String> {
    let mut assignments = vec![("Output_To_File", on.to_owned())];
    let Some(letter) = rest.chars().next() else { return Ok(assignments) };
    if kind_of(letter).is_none() {
        return Err(KINDS.into());
    }
    assignments.push(("Output_File_Type", letter.to_ascii_uppercase().to_string()));
    let (detail, has_grey) = (&rest[letter.len_utf8()..], "NnPp".contains(letter));
    match detail {
        "" => {}
        "g" | "G" if has_grey => assignments.push(("Grayscale_Output", "on".into())),
        _ if detail.bytes().all(|byte| byte.is_ascii_digit()) => {
            if has_grey {
                assignments.push(("Bits_Per_Color", detail.into()));
            }
        }
        _ => {
            return Err(format!(
                "behind the kind of picture only bits may follow, or g for grey PNG and PPM files, not '{detail}'"
            ));
        }
    }
    Ok(assignments)
}

#[cfg(test)]
mod tests {
    use super::super::keys::{KEYS, Key};
    use super::*;

    fn check(word: &str, expected: &[(&str, &str)]) {
        let found = assignments(word).unwrap_or_else(|why| panic!("{word}: {why}"));
        let found: Vec<_> = found.iter().map(|(key, value)| (*key, value.as_str())).collect();
        assert_eq!(found, expected, "{word}");
    }

    #[test]
    fn switches_mean_keys() {
        check("+W8", &[("Width", "8")]);
        check("-w8+H6", &[("Width", "8+H6")]);
        check("+KFF10", &[("Final_Frame", "10")]);
        check("+KF2", &[("Final_Clock", "2")]);
        check("-KC", &[("Cyclic_Animation", "off")]);
        check("+A", &[("Antialias", "on")]);
        check("-A0.1", &[("Antialias", "off"), ("Antialias_Threshold", "0.1")]);
        check("+FN12", &[("Output_To_File", "on"), ("Output_File_Type", "N"), ("Bits_Per_Color", "12")]);
        check("-FJ90", &[("Output_To_File", "off"), ("Output_File_Type", "J")]);
        check("-GFa.txt", &[("Fatal_Console", "off"), ("Fatal_File", "a.txt")]);
        check("+RFI", &[("Radiosity_From_File", "on")]);
        check("+RFile", &[("Radiosity_File_Name", "ile")]);
        check("+HIa.inc", &[("Include_Header", "a.inc")]);
        check("-display", &[]);
        check("+B", &[]);
    }

    #[test]
    fn what_is_no_switch_is_refused() {
        for word in [
            "+Y", "+UAx", "+Cx", "+A1", "+A.2", "+A0,2", "+FX", "+FTg", "+FNg16", "+W", "+GI", "+B100", "+NA", "+",
            "+S",
        ] {
            assert!(assignments(word).is_err(), "{word}");
        }
    }

    #[test]
    fn every_key_of_a_switch_exists() {
        for switch in SWITCHES {
            let keys = match switch.form {
                Flag(key) | Value(key) => vec![key],
                FlagAndValue(key, value) | Threshold(key, value) => vec![key, value],
                Picture | Anything | Bare => Vec::new(),
            };
            for key in keys {
                assert!(Key::named(key).is_some(), "{key} of +{}", switch.letters);
            }
        }
        let mut names: Vec<String> = KEYS.iter().map(|key| key.name.to_lowercase()).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), KEYS.len());
    }
}
