//! The pictures: one over the other, with a slider between them.

use crate::measure::number::figure;
use crate::report::bench::{Bench, Images, ShownReference};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};

/// A rung that can be looked at.
struct Shown<'b> {
    key: String,
    label: String,
    images: &'b Images,
}

/// The rungs with pictures, by ladder.
fn shown(bench: &Bench) -> Vec<(String, Vec<Shown<'_>>)> {
    let mut groups = Vec::new();
    for (l, climb) in bench.climbs_against_reference(true) {
        let mut rungs = Vec::new();
        for (r, (rung, result)) in climb.ladder.rungs.iter().zip(&climb.results).enumerate() {
            let Ok(figures) = result else { continue };
            let Some(images) = &figures.images else { continue };
            let label = format!("{}, RMSE {}", rung.label, figure(figures.difference.rmse));
            rungs.push(Shown { key: format!("{l}-{r}"), label, images });
        }
        groups.push((format!("{}, {}", climb.ladder.program.name(), climb.ladder.name), rungs));
    }
    groups.retain(|(_, rungs)| !rungs.is_empty());
    groups
}

/// Before and after, or before and the error map.
pub(super) fn viewer(scene: usize, bench: &Bench, reference: &ShownReference) -> Markup {
    let groups = shown(bench);
    let all = || groups.iter().flat_map(|(_, rungs)| rungs);
    let Some(first) = all().next() else { return html! { p.failed { "No rung has a picture." } } };
    html! {
        h3 { "Pictures" }
        figure.viewer {
            div.controls {
                label { "Picture " select.rung {
                    @for (name, rungs) in &groups { optgroup label=(name) {
                        @for rung in rungs { option value=(rung.key) { (name) ": " (rung.label) } }
                    } }
                } }
                fieldset {
                    legend { "Beside it" }
                    @for (value, name) in [("reference", "reference"), ("heatmap", "error map")] {
                        label {
                            input type="radio" name=(format!("beside-{scene}")) value=(value) checked[value == "reference"];
                            " " (name)
                        }
                    }
                }
                label { "Size " select.zoom { @for zoom in [1, 2, 4] { option value=(zoom) { (zoom) " ×" } } } }
            }
            div.stage tabindex="0" role="group" aria-label="Picture, can be scrolled when enlarged" { div.pane {
                img.reference src=(data_url(&reference.picture)) alt="Reference";
                @for rung in all() {
                    img.heatmap data-rung=(rung.key) src=(data_url(&rung.images.heatmap)) alt=(format!("Error map: {}", rung.label)) hidden;
                    img.picture data-rung=(rung.key) src=(data_url(&rung.images.picture)) alt=(rung.label) hidden[rung.key != first.key];
                }
                input.slider type="range" min="0" max="100" step="0.5" value="50" aria-label="Where the left picture ends and the right one begins, in percent";
                div.divider aria-hidden="true" {}
            } }
            div.sides aria-live="polite" { span.left { "◀ " span.left-name {} } span.right { span.right-name { "reference" } " ▶" } }
            div.scale hidden {
                span.ramp role="img" aria-label="Colours of the error map from black for none over blue, red and yellow to white for 64 of 255 and more" {}
                ol { @for value in [0, 4, 16, 36, 64] { li { (value) } } }
                span { "largest difference of a pixel's sRGB values, of 255" }
            }
            noscript { "Choosing pictures and moving the slider needs JavaScript; all figures stand in the tables." }
        }
    }
}

fn data_url(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}
