//! Properties of the beam sections that PBARL and PBEAML know by name.
//!
//! Areas and moments of inertia are those of the rectangles or circles a section is made of, without approximation.
//! Torsion constants are those of thin walls, as in the NX Nastran Element Library: `J = sum(b t^3)/3` over the
//! mid-lines of open sections, Bredt's `4 A^2 / integral(ds/t)` for the box, `b h^3 (1/3 - 0.21 h/b (1 - h^4/(12 b^4)))`
//! for the rectangle. Shear factors are its shares of the clear web or flange in the area for channel and angle, and
//! otherwise Nastran's typical values: 5/6 for a rectangle, 0.9 for a circle, 0.5 for a tube, A_web/A along the web and
//! A_flange/(1.2 A) along the flanges.
//!
//! Dimensions of T1, T2, I1, H, CHAN1, CROSS and BOX1 are those of the same guide; their shear factors follow the same rules.
//!
//! y points up in the figures of Nastran's Quick Reference Guide and z to the right, away from the web of CHAN and
//! from the upright leg of L.

use std::f64::consts::PI;

/// What a section amounts to, about its neutral axes.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Section {
    /// Area.
    pub(super) area: f64,
    /// Bending in plane 1: the integral of y^2.
    pub(super) i1: f64,
    /// Bending in plane 2: the integral of z^2.
    pub(super) i2: f64,
    /// The integral of y z.
    pub(super) i12: f64,
    /// Torsion constant.
    pub(super) j: f64,
    /// K1, K2.
    pub(super) shear_factors: [f64; 2],
    /// Neutral axis (y, z) seen from the shear centre.
    pub(super) neutral_axis: [f64; 2],
}

/// The names that are read, with how many dimensions each has.
pub(super) const SECTIONS: [(&str, usize); 16] = [
    ("ROD", 1),
    ("TUBE", 2),
    ("TUBE2", 2),
    ("BAR", 2),
    ("BOX", 4),
    ("I", 6),
    ("T", 4),
    ("CHAN", 4),
    ("L", 4),
    ("T2", 4),
    ("I1", 4),
    ("H", 4),
    ("CHAN1", 4),
    ("CROSS", 4),
    ("T1", 4),
    ("BOX1", 6),
];

/// Sections whose place of the shear centre is not known here: a bar does not ask for it, a beam does.
pub(super) const OF_BARS_ONLY: [&str; 2] = ["T1", "BOX1"];

/// The section of a name with its dimensions; nothing if the dimensions do not fit together.
pub(super) fn section(name: &str, dimensions: &[f64]) -> Option<Section> {
    match (name, dimensions) {
        ("ROD", [radius]) => Some(ring(*radius, 0.0, 0.9)),
        ("TUBE", [outer, inner]) if inner < outer => Some(ring(*outer, *inner, 0.5)),
        ("TUBE2", [outer, wall]) if wall <= outer => Some(ring(*outer, outer - wall, 0.5)),
        ("BAR", [width, height]) => Some(rectangle(*width, *height)),
        ("BOX", [width, height, lids, sides]) => hollow([*width, *height, *lids, *sides]),
        ("I", [height, below, above, web, t_below, t_above]) => {
            flanged(*height, [*below, *above], *web, [*t_below, *t_above])
        }
        ("T", [width, height, flange, web]) => tee(*width, *height, *flange, *web),
        ("CHAN", [width, height, web, flange]) => channel(*width, *height, *web, *flange),
        ("L", [width, height, lying, upright]) => angle(*width, *height, *lying, *upright),
        // The flange below.
        ("T2", [width, height, flange, web]) => {
            let over = tee(*width, *height, *flange, *web)?;
            Some(Section { neutral_axis: over.neutral_axis.map(|at| 0.0 - at), ..over })
        }
        // Overhang of both flanges together, web, clear height, whole height.
        ("I1", [overhang, web, clear, height]) => {
            flanged(*height, [overhang + web; 2], *web, [(height - clear) / 2.0; 2])
        }
        ("CHAN1", [overhang, web, clear, height]) => {
            channel(overhang + web, *height, *web, (height - clear) / 2.0)
        }
        // Clear width, both legs together, their height, thickness of the bar between them.
        ("H", [clear, legs, height, bar]) => {
            flanged(clear + legs, [*height; 2], *bar, [legs / 2.0; 2]).map(turned)
        }
        ("CROSS", [arms, upright, height, thickness]) => cross(*arms, *upright, *height, *thickness),
        ("T1", [height, web_length, flange, web]) => {
            tee(*height, web_length + flange, *flange, *web).map(turned)
        }
        ("BOX1", [width, height, top, bottom, left, right]) => {
            uneven_box([*width, *height], [*top, *bottom], [*left, *right])
        }
        _ => None,
    }
}

fn ring(outer: f64, inner: f64, shear_factor: f64) -> Section {
    let i = PI / 4.0 * (outer.powi(4) - inner.powi(4));
    let area = PI * (outer.powi(2) - inner.powi(2));
    let shear_factors = [shear_factor; 2];
    Section { area, i1: i, i2: i, j: 2.0 * i, shear_factors, ..Section::default() }
}

fn rectangle(width: f64, height: f64) -> Section {
    let (long, short) = (width.max(height), width.min(height));
    let ratio = short / long;
    let j = long * short.powi(3) * (1.0 / 3.0 - 0.21 * ratio * (1.0 - ratio.powi(4) / 12.0));
    let whole = of_rectangles(&[Rectangle { y: 0.0, z: 0.0, height, width }]);
    Section { j, shear_factors: [5.0 / 6.0; 2], ..whole }
}

fn hollow([width, height, lids, sides]: [f64; 4]) -> Option<Section> {
    let (inner_width, inner_height) = (width - 2.0 * sides, height - 2.0 * lids);
    if inner_width <= 0.0 || inner_height <= 0.0 {
        return None;
    }
    let y = (height - lids) / 2.0;
    let z = (width - sides) / 2.0;
    let lid = Rectangle { y, z: 0.0, height: lids, width };
    let side = Rectangle { y: 0.0, z, height: inner_height, width: sides };
    let whole = of_rectangles(&[lid, Rectangle { y: -y, ..lid }, side, Rectangle { z: -z, ..side }]);
    let enclosed = (width - sides) * (height - lids);
    let j = 4.0 * enclosed.powi(2) / (2.0 * (width - sides) / lids + 2.0 * (height - lids) / sides);
    let shear_factors = [2.0 * sides * inner_height / whole.area, 2.0 * lids * inner_width / whole.area];
    Some(Section { j, shear_factors, ..whole })
}

/// A quarter turn: y for z.
fn turned(section: Section) -> Section {
    let [along, across] = section.shear_factors;
    Section { i1: section.i2, i2: section.i1, shear_factors: [across, along], ..section }
}

/// An upright rectangle with an arm on each side.
fn cross(arms: f64, upright: f64, height: f64, thickness: f64) -> Option<Section> {
    if thickness > height {
        return None;
    }
    let middle = Rectangle { y: 0.0, z: 0.0, height, width: upright };
    let z = f64::midpoint(upright, arms / 2.0);
    let arm = Rectangle { y: 0.0, z, height: thickness, width: arms / 2.0 };
    let whole = of_rectangles(&[middle, arm, Rectangle { z: -z, ..arm }]);
    let j = (height * upright.powi(3) + arms * thickness.powi(3)) / 3.0;
    let shear_factors =
        [height * upright / whole.area, arms * thickness / whole.area].map(|share| share / 1.2);
    Some(Section { j, shear_factors, ..whole })
}

/// A hollow rectangle with four walls of their own.
fn uneven_box([width, height]: [f64; 2], lids: [f64; 2], sides: [f64; 2]) -> Option<Section> {
    let (clear, inside) = (height - lids[0] - lids[1], width - sides[0] - sides[1]);
    if clear <= 0.0 || inside <= 0.0 {
        return None;
    }
    let lid = |y: f64, thickness: f64| Rectangle { y, z: width / 2.0, height: thickness, width };
    let side =
        |z: f64, thickness: f64| Rectangle { y: lids[1] + clear / 2.0, z, height: clear, width: thickness };
    let whole = of_rectangles(&[
        lid(height - lids[0] / 2.0, lids[0]),
        lid(lids[1] / 2.0, lids[1]),
        side(sides[0] / 2.0, sides[0]),
        side(width - sides[1] / 2.0, sides[1]),
    ]);
    let (across, up) = (width - f64::midpoint(sides[0], sides[1]), height - f64::midpoint(lids[0], lids[1]));
    let way = across / lids[0] + across / lids[1] + up / sides[0] + up / sides[1];
    let j = 4.0 * (across * up).powi(2) / way;
    let shear_factors =
        [(sides[0] + sides[1]) * clear / whole.area, (lids[0] + lids[1]) * inside / whole.area];
    Some(Section { j, shear_factors, ..whole })
}

/// Flanges below and above a web in their middle.
fn flanged(height: f64, widths: [f64; 2], web: f64, flanges: [f64; 2]) -> Option<Section> {
    let clear = height - flanges[0] - flanges[1];
    if clear <= 0.0 || widths[0] < web || widths[1] < web {
        return None;
    }
    let below = Rectangle { y: flanges[0] / 2.0, z: 0.0, height: flanges[0], width: widths[0] };
    let above = Rectangle { y: height - flanges[1] / 2.0, z: 0.0, height: flanges[1], width: widths[1] };
    let middle = Rectangle { y: flanges[0] + clear / 2.0, z: 0.0, height: clear, width: web };
    let whole = of_rectangles(&[below, above, middle]);
    let between = above.y - below.y;
    let stiff = [0, 1].map(|end| flanges[end] * widths[end].powi(3));
    let shear_centre = below.y + between * stiff[1] / (stiff[0] + stiff[1]);
    // Of equal flanges only round-off would be left.
    let offset = whole.neutral_axis[0] - shear_centre;
    let walls = widths[0] * flanges[0].powi(3) + widths[1] * flanges[1].powi(3) + between * web.powi(3);
    let flange_area = widths[0] * flanges[0] + widths[1] * flanges[1];
    Some(Section {
        j: walls / 3.0,
        shear_factors: [web * clear / whole.area, flange_area / (1.2 * whole.area)],
        neutral_axis: [if widths[0] == widths[1] && flanges[0] == flanges[1] { 0.0 } else { offset }, 0.0],
        ..whole
    })
}

fn tee(width: f64, height: f64, flange: f64, web: f64) -> Option<Section> {
    let clear = height - flange;
    if clear <= 0.0 || web > width {
        return None;
    }
    // The shear centre is where the mid-lines meet, and y counts from there.
    let top = Rectangle { y: 0.0, z: 0.0, height: flange, width };
    let stem = Rectangle { y: -height / 2.0, z: 0.0, height: clear, width: web };
    let whole = of_rectangles(&[top, stem]);
    let j = (width * flange.powi(3) + (height - flange / 2.0) * web.powi(3)) / 3.0;
    let shear_factors = [web * clear / whole.area, width * flange / (1.2 * whole.area)];
    Some(Section { j, shear_factors, ..whole })
}

fn channel(width: f64, height: f64, web: f64, flange: f64) -> Option<Section> {
    let (clear, out) = (height - 2.0 * flange, width - web);
    if clear <= 0.0 || out <= 0.0 {
        return None;
    }
    // z counts from the middle of the web.
    let upright = Rectangle { y: 0.0, z: 0.0, height, width: web };
    let arm = Rectangle { y: (height - flange) / 2.0, z: width / 2.0, height: flange, width: out };
    let whole = of_rectangles(&[upright, arm, Rectangle { y: -arm.y, ..arm }]);
    let (reach, between) = (width - web / 2.0, height - flange);
    let behind = reach.powi(2) * flange / (2.0 * reach * flange + between * web / 3.0);
    Some(Section {
        j: (2.0 * reach * flange.powi(3) + between * web.powi(3)) / 3.0,
        shear_factors: [web * clear / whole.area, 2.0 * flange * out / whole.area],
        neutral_axis: [0.0, whole.neutral_axis[1] + behind],
        ..whole
    })
}

fn angle(width: f64, height: f64, lying: f64, upright: f64) -> Option<Section> {
    let (clear, out) = (height - lying, width - upright);
    if clear <= 0.0 || out <= 0.0 {
        return None;
    }
    // The shear centre is where the mid-lines of the legs meet, and y and z count from there.
    let foot = Rectangle { y: 0.0, z: out / 2.0, height: lying, width };
    let leg = Rectangle { y: height / 2.0, z: 0.0, height: clear, width: upright };
    let whole = of_rectangles(&[foot, leg]);
    let j = ((width - upright / 2.0) * lying.powi(3) + (height - lying / 2.0) * upright.powi(3)) / 3.0;
    Some(Section { j, shear_factors: [clear * upright / whole.area, out * lying / whole.area], ..whole })
}

/// A rectangle at (y, z).
#[derive(Debug, Clone, Copy)]
struct Rectangle {
    y: f64,
    z: f64,
    height: f64,
    width: f64,
}

/// Area, inertia about the common centre, and that centre.
fn of_rectangles(parts: &[Rectangle]) -> Section {
    let sum = |of: &dyn Fn(&Rectangle) -> f64| {
        parts.iter().map(|part| part.height * part.width * of(part)).sum::<f64>()
    };
    let area = sum(&|_| 1.0);
    let (y, z) = (sum(&|part| part.y) / area, sum(&|part| part.z) / area);
    Section {
        area,
        i1: sum(&|part| (part.y - y).powi(2) + part.height.powi(2) / 12.0),
        i2: sum(&|part| (part.z - z).powi(2) + part.width.powi(2) / 12.0),
        i12: sum(&|part| (part.y - y) * (part.z - z)),
        neutral_axis: [y, z],
        ..Section::default()
    }
}
