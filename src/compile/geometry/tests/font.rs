//! A font of two letters, so that tests of text need no font of the system.

/// Units to the em.
const EM: i16 = 1000;

/// A closed outline: points with whether they lie on the curve.
type Contour = Vec<(i16, i16, bool)>;

/// A ring of curves, from its lowest point; the sign of `x` is the sense of turning.
fn ring(radius: i16, x: i16) -> Contour {
    let r = radius;
    let around = [(0, -r, true), (-r, -r, false), (-r, 0, true), (-r, r, false), (0, r, true), (r, r, false)];
    let all = around.into_iter().chain([(r, 0, true), (r, -r, false)]);
    all.map(|(px, py, on)| (px * x + 350, py + 300, on)).collect()
}

/// `o`: a ring with a hole; `A`: a wedge with straight sides.
fn letters() -> [Vec<Contour>; 2] {
    let wedge = [(20, 0), (300, 700), (580, 0), (420, 0), (300, 400), (180, 0)];
    [vec![ring(300, 1), ring(150, -1)], vec![wedge.map(|(x, y)| (x, y, true)).to_vec()]]
}

/// Big-endian words.
fn words(values: impl IntoIterator<Item = i32>) -> Vec<u8> {
    values.into_iter().flat_map(|v| (v as u16).to_be_bytes()).collect()
}

fn glyph(contours: &[Contour]) -> Vec<u8> {
    let points: Vec<_> = contours.iter().flatten().collect();
    let range = |of: fn(&(i16, i16, bool)) -> i16| {
        let all = points.iter().map(|p| i32::from(of(p)));
        (all.clone().min().unwrap_or(0), all.max().unwrap_or(0))
    };
    let ((x0, x1), (y0, y1)) = (range(|p| p.0), range(|p| p.1));
    let mut out = words([contours.len() as i32, x0, y0, x1, y1]);
    let ends = contours.iter().scan(-1, |end, c| {
        *end += c.len() as i32;
        Some(*end)
    });
    out.extend(words(ends.chain([0])));
    out.extend(points.iter().map(|p| u8::from(p.2)));
    for of in [|p: &(i16, i16, bool)| i32::from(p.0), |p: &(i16, i16, bool)| i32::from(p.1)] {
        let mut last = 0;
        out.extend(words(points.iter().map(|p| {
            let step = of(p) - last;
            last = of(p);
            step
        })));
    }
    out.resize(out.len().next_multiple_of(4), 0);
    out
}

/// The whole file.
pub(super) fn font() -> Vec<u8> {
    let glyphs = letters().map(|contours| glyph(&contours));
    let offsets = glyphs.iter().scan(0, |at, g| {
        *at += g.len() as i32 / 2;
        Some(*at)
    });
    // Nothing stands for glyph 0.
    let loca = words([0, 0].into_iter().chain(offsets));
    let em = i32::from(EM);
    let head = words([1, 0, 1, 0, 0, 0, 0x5F0F, 0x3CF5, 0, em, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, em, em, 0, 8, 2, 0, 0]);
    let hhea = words([1, 0, 800, -200, 0, 700, 0, 0, 700, 0, 0, 0, 0, 0, 0, 0, 0, 3]);
    let maxp = words([1, 0, 3].into_iter().chain([0; 13]));
    // Advance and left bearing of nothing, `o` and `A`.
    let hmtx = words([500, 0, 700, 50, 600, 20]);
    let mut codes = [0u8; 256];
    (codes[usize::from(b'o')], codes[usize::from(b'A')]) = (1, 2);
    let mut cmap = words([0, 1, 1, 0, 0, 12, 0, 262, 0]);
    cmap.extend(codes);
    cmap.extend([0, 0]);
    // The pair of `A` and `o` is closer by a tenth of an em.
    let kern = words([0, 1, 0, 20, 1, 1, 6, 0, 0, 2, 1, -100]);
    let tables: [(&[u8; 4], Vec<u8>); 8] = [
        (b"cmap", cmap),
        (b"glyf", glyphs.concat()),
        (b"head", head),
        (b"hhea", hhea),
        (b"hmtx", hmtx),
        (b"kern", kern),
        (b"loca", loca),
        (b"maxp", maxp),
    ];
    let mut file = words([1, 0, tables.len() as i32, 128, 3, 0]);
    let mut body = Vec::new();
    for (tag, table) in &tables {
        file.extend(*tag);
        let at = 12 + 16 * tables.len() + body.len();
        file.extend([0, at as u32, table.len() as u32].map(u32::to_be_bytes).concat());
        body.extend(table);
        body.resize(body.len().next_multiple_of(4), 0);
    }
    file.extend(body);
    file
}
