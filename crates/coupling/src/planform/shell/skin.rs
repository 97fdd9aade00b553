//! The shells on the block: skins, closing faces, webs and ribs. Normals point outward; webs' point aft.

use super::laminates::Laminates;
use super::mesh::{AXIS_SYSTEM, Mesh};
use super::settings::Surface;
use nastran::{BulkData, CornerThickness, MaterialDirection, ShellElement, Span};

/// Where the shells of one surface begin, and what they are.
const UPPER: u32 = 2_100_001;
const LOWER: u32 = 2_200_001;
const LEADING_EDGE: u32 = 2_300_001;
const TRAILING_EDGE: u32 = 2_400_001;
const WEBS: u32 = 2_500_001;
const ROOT_RIB: u32 = 2_600_001;
const TIP_RIB: u32 = 2_700_001;

/// Shells of one surface while they are numbered.
struct Numbered<'a> {
    bulk: &'a mut BulkData,
    next: u32,
    direction: MaterialDirection,
    span: &'a Span,
}

impl Numbered<'_> {
    /// One shell, or none where no ply lies.
    fn add(&mut self, property: Option<u32>, grids: [u32; 4]) {
        let Some(property) = property else { return };
        let (id, grids) = (self.next, grids.to_vec());
        let (direction, span) = (self.direction, self.span.clone());
        self.bulk.shells.insert(
            id,
            ShellElement {
                id,
                property,
                grids,
                midsides: Vec::new(),
                direction,
                is_r: false,
                thickness: CornerThickness::default(),
                offset: 0.0,
                span,
            },
        );
        self.next += 1;
    }
}

impl Mesh<'_> {
    /// CQUAD4 without offset: the laminate's middle lies on the contour.
    pub(super) fn add_shells(&self, bulk: &mut BulkData, laminates: &mut Laminates<'_>, span: &Span) {
        let along_axis = MaterialDirection::System(AXIS_SYSTEM);
        let mut surface = |first: u32, direction, fill: &mut dyn FnMut(&mut Numbered<'_>)| {
            fill(&mut Numbered { bulk, next: first, direction, span });
        };
        surface(UPPER, along_axis, &mut |shells| self.skin(Surface::Upper, shells, laminates));
        surface(LOWER, along_axis, &mut |shells| self.skin(Surface::Lower, shells, laminates));
        surface(LEADING_EDGE, along_axis, &mut |shells| self.front(shells, laminates));
        let last = self.chordwise();
        surface(TRAILING_EDGE, along_axis, &mut |shells| {
            self.upright(Surface::TrailingEdge, last, shells, laminates);
        });
        surface(WEBS, along_axis, &mut |shells| {
            for line in self.settings.web_lines(&self.lines) {
                self.upright(Surface::Webs, line, shells, laminates);
            }
        });
        // The axis may stand upright on a rib, so ribs count angles from their own first side.
        let along_chord = MaterialDirection::AngleDeg(0.0);
        surface(ROOT_RIB, along_chord, &mut |shells| self.rib(Surface::RootRib, shells, laminates));
        surface(TIP_RIB, along_chord, &mut |shells| self.rib(Surface::TipRib, shells, laminates));
    }

    fn skin(&self, surface: Surface, shells: &mut Numbered<'_>, laminates: &mut Laminates<'_>) {
        let layer = if surface == Surface::Upper { self.layers } else { 0 };
        for station in 0..self.spanwise() {
            for line in 0..self.chordwise() {
                let property = laminates.skin(surface, self.middle_m(station), line);
                let [a, b, c, d] = [
                    self.grid(line, station, layer),
                    self.grid(line + 1, station, layer),
                    self.grid(line + 1, station + 1, layer),
                    self.grid(line, station + 1, layer),
                ];
                shells.add(property, if surface == Surface::Upper { [a, b, c, d] } else { [a, d, c, b] });
            }
        }
    }

    fn front(&self, shells: &mut Numbered<'_>, laminates: &mut Laminates<'_>) {
        for station in 0..self.spanwise() {
            let property = laminates.closing(Surface::LeadingEdge, self.middle_m(station));
            for layer in 0..self.layers {
                let [a, b, c, d] = self.upright_grids(0, station, layer);
                shells.add(property, [a, d, c, b]);
            }
        }
    }

    /// Shells from surface to surface on one chord line, normals aft.
    fn upright(
        &self,
        surface: Surface,
        line: usize,
        shells: &mut Numbered<'_>,
        laminates: &mut Laminates<'_>,
    ) {
        for station in 0..self.spanwise() {
            let property = laminates.closing(surface, self.middle_m(station));
            for layer in 0..self.layers {
                shells.add(property, self.upright_grids(line, station, layer));
            }
        }
    }

    fn upright_grids(&self, line: usize, station: usize, layer: usize) -> [u32; 4] {
        [
            self.grid(line, station, layer),
            self.grid(line, station + 1, layer),
            self.grid(line, station + 1, layer + 1),
            self.grid(line, station, layer + 1),
        ]
    }

    fn rib(&self, surface: Surface, shells: &mut Numbered<'_>, laminates: &mut Laminates<'_>) {
        let station = if surface == Surface::RootRib { 0 } else { self.spanwise() };
        let property = laminates.rib(surface, self.y_m[station]);
        for line in 0..self.chordwise() {
            for layer in 0..self.layers {
                let [a, b, c, d] = [
                    self.grid(line, station, layer),
                    self.grid(line + 1, station, layer),
                    self.grid(line + 1, station, layer + 1),
                    self.grid(line, station, layer + 1),
                ];
                shells.add(property, if surface == Surface::RootRib { [a, b, c, d] } else { [a, d, c, b] });
            }
        }
    }

    /// Middle of a span cell, where its laminates are taken.
    fn middle_m(&self, station: usize) -> f64 {
        0.5 * (self.y_m[station] + self.y_m[station + 1])
    }
}
