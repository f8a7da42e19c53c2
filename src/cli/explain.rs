//! `--explain`: what a scene has, what it does without, and which rays it took.

use super::messages;
use crate::job::Explanation;
use crate::omission::{Keep, Ledger, Omission};
use crate::render::Statistics;

/// Names of what is to be kept, as typed: `all`, or a list.
pub(super) fn keep(text: &str) -> Result<Keep, String> {
    if text == "all" {
        return Ok(Keep::ALL);
    }
    text.split(',').map(str::trim).try_fold(Keep::NONE, |keep, name| match Omission::named(name) {
        Some(omission) => Ok(keep.with(omission)),
        None => {
            let names = Omission::ALL.map(Omission::name).join(", ");
            Err(format!("'{name}' is none of all, {names}"))
        }
    })
}

/// Prints the three tables.
pub(super) fn show(explanation: &Explanation) {
    messages::line(format_args!("{}", text(explanation)));
}

/// What is none is not told.
fn text(explanation: &Explanation) -> String {
    let Explanation { found, ledger, rays } = explanation;
    let mut text = String::from("found");
    for (what, count) in found.iter().filter(|(_, count)| *count > 0) {
        text += &format!("\n  {what:<52}{count:>12}");
    }
    text += &omissions(ledger);
    text + "\nrays" + &of_rays(rays)
}

/// What was left out and what was kept although it need not be, under titles.
pub(super) fn omissions(ledger: &Ledger) -> String {
    let mut text = String::new();
    let mut left_out = String::new();
    let mut kept = String::new();
    for omission in Omission::ALL {
        let found = ledger.of(omission);
        if found.count == 0 {
            continue;
        }
        let list = if ledger.keep().holds(omission) { &mut kept } else { &mut left_out };
        *list += &format!("\n  {:<20}{:<48}{:>12}", omission.name(), omission.about(), found.count);
        if found.bytes > 0 {
            *list += &format!("{:>14} bytes", found.bytes);
        }
    }
    for (title, list) in [("left out", left_out), ("kept although not needed", kept)] {
        if !list.is_empty() {
            text += &format!("\n{title}{list}");
        }
    }
    text
}

fn of_rays(rays: &Statistics) -> String {
    let kinds = [
        ("camera rays", rays.camera_rays),
        ("transmitted rays", rays.transmitted_rays),
        ("mirrored rays", rays.reflected_rays),
        ("rays that gather light for radiosity and from below surfaces", rays.sample_rays),
        ("shadow rays", rays.shadow_rays),
        ("not sent: the surface is turned away or out of a light's reach", rays.spared_shadow_rays),
    ];
    kinds.into_iter().filter(|(_, n)| *n > 0).map(|(kind, n)| format!("\n  {kind:<68}{n:>12}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::omission::Ledger;

    #[test]
    fn lists_are_checked() {
        assert_eq!(keep("all"), Ok(Keep::ALL));
        assert_eq!(keep("flat-maps, interiors"), Ok(Keep::NONE.with(Omission::FlatMaps).with(Omission::Interiors)));
        assert!(keep("flat-maps,nothing").unwrap_err().contains("'nothing' is none of all, declarations, "));
    }

    #[test]
    fn only_what_there_is_is_told() {
        let mut ledger = Ledger::new(Keep::NONE.with(Omission::Interiors));
        ledger.omits(Omission::FlatMaps, 100);
        ledger.omits(Omission::Interiors, 0);
        let rays = Statistics { camera_rays: 7, ..Statistics::default() };
        let text = text(&Explanation { found: vec![("lights", 2), ("fogs", 0)], ledger, rays });
        let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
        assert_eq!(lines[1], ["lights", "2"]);
        assert_eq!(lines[2], ["left", "out"]);
        assert_eq!((lines[3][0], *lines[3].last().unwrap()), ("flat-maps", "bytes"));
        assert!(lines[4][0] == "kept" && lines[5][0] == "interiors");
        assert_eq!(lines[6..], [vec!["rays"], vec!["camera", "rays", "7"]]);
    }
}
