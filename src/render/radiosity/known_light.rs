//! Light between surfaces as a text, to be kept from one picture of a scene to the next.
//!
//! The text is POV-Ray's, so that either program reads what the other wrote: a line for each record, tabs between `C` with
//! the depth + 1, the point, the normal, the light, the mean and the least distance, and the direction of the nearest.
//! Directions are two hexadecimal digits a component.
//!
//! Source: radiosity facts, section 9 (measured).

use super::record::Record;
use crate::math::{DVec3, Rgb};
use std::fmt::Write as _;

/// Deepest bounce that a scene can ask for.
const DEEPEST: u32 = 20;

/// Steps of a component of a direction between 0 and 1.
const STEPS: f64 = 127.0;

/// What POV-Ray rounds components with.
const ROUNDING: f64 = 0.499_999;

/// Length below which a direction that was read is none: rounding moves each component by half a step at most.
const NOWHERE: f64 = 0.5;

/// Light that falls on places of a scene, whatever the camera.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KnownLight {
    /// A line for each record: numbers that were read go out again as they came.
    text: String,
    records: Vec<(u32, Record)>,
}

impl KnownLight {
    /// What a text says, and the numbers, from 1, of lines that say nothing.
    pub fn read(text: &str) -> (Self, Vec<usize>) {
        let (mut known, mut others) = (Self::default(), Vec::new());
        for (i, line) in text.lines().enumerate() {
            match record(line) {
                Some(record) => {
                    known.text.push_str(line);
                    known.text.push('\n');
                    known.records.push(record);
                }
                None => others.push(i + 1),
            }
        }
        (known, others)
    }

    /// A line for each record.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Each with its depth.
    pub(in crate::render) fn records(&self) -> &[(u32, Record)] {
        &self.records
    }

    /// Takes in a record that was found.
    pub(in crate::render) fn add(&mut self, depth: u32, record: Record) {
        let Record { point, normal, mean_distance, nearest, toward_nearest, light, .. } = record;
        let _infallible = writeln!(
            self.text,
            "C{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{mean_distance}\t{nearest}\t{}",
            depth + 1,
            point.x,
            point.y,
            point.z,
            digits(normal),
            light.x,
            light.y,
            light.z,
            digits(toward_nearest),
        );
        self.records.push((depth, record));
    }
}

/// A depth and a record, if a line is one.
fn record(line: &str) -> Option<(u32, Record)> {
    let mut words = line.split_ascii_whitespace();
    let depth =
        words.next()?.strip_prefix('C')?.parse::<u32>().ok()?.checked_sub(1).filter(|depth| *depth < DEEPEST)?;
    let point = vector(&mut words)?;
    let normal = direction(words.next()?)?.try_normalize()?;
    let light = vector(&mut words)?;
    let [mean_distance, nearest] = [number(words.next())? as f32, number(words.next())? as f32];
    let toward_nearest = direction(words.next()?)?;
    let toward_nearest = match toward_nearest.length() < NOWHERE {
        true => DVec3::ZERO,
        false => toward_nearest.normalize(),
    };
    let light = Rgb::new(light.x as f32, light.y as f32, light.z as f32);
    let whole = words.next().is_none() && mean_distance > 0.0;
    whole.then_some((depth, Record { point, normal, mean_distance, nearest, toward_nearest, light, quality: 1.0 }))
}

fn vector<'t>(words: &mut impl Iterator<Item = &'t str>) -> Option<DVec3> {
    let [x, y, z] = [number(words.next())?, number(words.next())?, number(words.next())?];
    Some(DVec3::new(x, y, z))
}

/// A number that single precision holds.
fn number(word: Option<&str>) -> Option<f64> {
    word?.parse().ok().filter(|number: &f64| number.abs() <= f64::from(f32::MAX))
}

/// Six digits as a direction, not of unit length.
fn direction(word: &str) -> Option<DVec3> {
    let all = u32::from_str_radix(word, 16).ok().filter(|_| word.len() == 6)?;
    let [_, x, y, z] = all.to_be_bytes();
    Some(DVec3::from([x, y, z].map(|step| f64::from(step) / STEPS - 1.0)))
}

/// A unit direction, or none at all, as six digits.
fn digits(direction: DVec3) -> String {
    let [x, y, z] = direction.to_array().map(|c| ((c + 1.0) * STEPS + ROUNDING).floor() as u8);
    format!("{x:02x}{y:02x}{z:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: &str = "C2\t-0.521468\t-4\t0.5\t7ffe7f\t0.0359\t0.0239\t0.0120\t1.56518\t3.17131\tff7f7f";

    #[test]
    fn lines_of_povray_are_records() {
        let (known, others) = KnownLight::read(&format!("{LINE}\nhello\n{LINE}\tmore\n\n{LINE}\n"));
        assert_eq!((known.records().len(), others), (2, vec![2, 3, 4]));
        assert_eq!(known.text(), format!("{LINE}\n{LINE}\n"));
        let (depth, record) = known.records()[0];
        assert_eq!((depth, record.point, record.normal), (1, DVec3::new(-0.521468, -4.0, 0.5), DVec3::Y));
        assert_eq!((record.light, record.mean_distance), (Rgb::new(0.0359, 0.0239, 0.0120), 1.56518));
        assert_eq!((record.nearest, record.toward_nearest, record.quality), (3.17131, DVec3::X, 1.0));
    }

    #[test]
    fn what_is_no_record_is_left_out() {
        let damaged = |from: &str, to: &str| assert_eq!(KnownLight::read(&LINE.replace(from, to)).1, [1], "{to}");
        damaged("C2", "C0");
        damaged("C2", "C21");
        damaged("C2", "2");
        damaged("-4", "NaN");
        damaged("-4", "1e300");
        damaged("7ffe7f", "7ffe7");
        damaged("7ffe7f", "7f7f7f");
        damaged("1.56518", "0");
        damaged("\tff7f7f", "");
    }

    #[test]
    fn what_is_written_is_read() {
        let mut known = KnownLight::default();
        let record = Record {
            point: DVec3::new(1e-9, -2.5, 1.0 / 3.0),
            normal: -DVec3::Z,
            mean_distance: 0.1,
            nearest: 2e10,
            toward_nearest: DVec3::ZERO,
            light: Rgb::new(0.1, 2e-7, 4000.0),
            quality: 1.0,
        };
        known.add(0, record);
        assert_eq!(KnownLight::read(known.text()), (known, Vec::new()));
    }
}
