//! Laminates of the shells: plies by surface and place, and the mass that the straight facets leave out.
//!
//! Plies are taken at the middle of a span cell. A band (a spar cap) is spread over each chord cell it lies on, so
//! that its cross-section is exact on any mesh. The mesh is a little smaller than the wing: facets are shorter than
//! the contour, and nose and trailing edge are cut off. What is missing is there as non-structural mass: of the
//! facets on the skin, of nose and trailing edge on the faces that close the section.

use super::contour::{Contour, SIDES, Side};
use super::layup::{FIRST_PLY_MATERIAL, Layup};
use super::mesh::Mesh;
use super::settings::Surface;
use crate::planform::panels::card_number;
use nastran::{BulkData, Expansion, LaminateOption, Mat8, Pcomp, Ply, Span};

const FIRST_LAMINATE: u32 = 1001;

/// Plies and non-structural mass of a shell.
#[derive(Debug, Clone, PartialEq)]
struct Laminate {
    plies: Vec<Ply>,
    nsm_kg_m2: f64,
}

/// All laminates, each once.
pub(super) struct Laminates<'wing> {
    layup: Layup<'wing>,
    lines: Vec<f64>,
    /// Contour length over facet length, lower and upper.
    contour_over_facets: [f64; 2],
    /// Contour ahead of the first chord line and behind the last one over the height of the face there, lower and
    /// upper.
    cut_off: [[f64; 2]; 2],
    known: Vec<Laminate>,
}

impl<'wing> Laminates<'wing> {
    pub(super) fn new(layup: Layup<'wing>, contour: &Contour, mesh: &Mesh<'_>) -> Self {
        let lines = mesh.lines.clone();
        let (first, last) = layup.settings.mesh.edges_over_c;
        let ratio = |side: Side| contour.arc(side, first, last) / contour.facets(side, &lines);
        let front = |side: Side| contour.arc(side, 0.0, first) / contour.thickness(first);
        let back = |side: Side| contour.arc(side, last, 1.0) / contour.thickness(last);
        let (contour_over_facets, cut_off) = (SIDES.map(ratio), [SIDES.map(front), SIDES.map(back)]);
        Self { layup, lines, contour_over_facets, cut_off, known: Vec::new() }
    }

    /// The laminate of a skin's cell between chord lines `line` and `line + 1`.
    pub(super) fn skin(&mut self, surface: Surface, y_m: f64, line: usize) -> Option<u32> {
        let plies = self.layup.plies(surface, y_m, Some([self.lines[line], self.lines[line + 1]]));
        let ratio = self.contour_over_facets[usize::from(surface == Surface::Upper)];
        let nsm_kg_m2 =
            self.layup.settings.finish_kg_m2 * ratio + self.layup.mass_kg_m2(&plies) * (ratio - 1.0);
        self.number(Laminate { plies, nsm_kg_m2 })
    }

    /// The laminate of a web or of a face that closes the section.
    pub(super) fn closing(&mut self, surface: Surface, y_m: f64) -> Option<u32> {
        let plies = self.layup.plies(surface, y_m, None);
        let skins = |side: Side| self.layup.plies([Surface::Lower, Surface::Upper][side as usize], y_m, None);
        let missing = |cut_off: [f64; 2]| -> f64 {
            let mass = |side: Side| self.layup.mass_kg_m2(&skins(side)) + self.layup.settings.finish_kg_m2;
            let cut: f64 = SIDES.map(|side| mass(side) * cut_off[side as usize]).iter().sum();
            (cut - self.layup.mass_kg_m2(&plies)).max(0.0)
        };
        let nsm_kg_m2 = match surface {
            Surface::LeadingEdge => missing(self.cut_off[0]),
            Surface::TrailingEdge => missing(self.cut_off[1]),
            _ => 0.0,
        };
        self.number(Laminate { plies, nsm_kg_m2 })
    }

    /// The laminate of a rib.
    pub(super) fn rib(&mut self, surface: Surface, y_m: f64) -> Option<u32> {
        let plies = self.layup.plies(surface, y_m, None);
        self.number(Laminate { plies, nsm_kg_m2: 0.0 })
    }

    fn number(&mut self, laminate: Laminate) -> Option<u32> {
        if laminate.plies.is_empty() {
            return None;
        }
        let place = self.known.iter().position(|known| *known == laminate).unwrap_or(self.known.len());
        if place == self.known.len() {
            self.known.push(laminate);
        }
        Some(FIRST_LAMINATE + card_number(place))
    }

    /// PCOMP and MAT8.
    pub(super) fn add_materials(self, bulk: &mut BulkData, span: &Span) {
        for (id, laminate) in (FIRST_LAMINATE..).zip(self.known) {
            let card = Pcomp {
                id,
                z0: None,
                nsm: laminate.nsm_kg_m2,
                reference: 0.0,
                plies: laminate.plies,
                option: LaminateOption::All,
                is_global: false,
                span: span.clone(),
            };
            bulk.laminates.insert(id, card);
        }
        for (id, material) in (FIRST_PLY_MATERIAL..).zip(&self.layup.settings.materials) {
            let card = Mat8 {
                id,
                e1: material.e1_pa,
                e2: material.e2_pa,
                nu12: material.nu12,
                g12: material.g12_pa,
                g1z: material.g12_pa,
                g2z: material.g12_pa,
                rho: material.rho_kg_m3,
                expansion: Expansion::default(),
                span: span.clone(),
            };
            bulk.ply_materials.insert(id, card);
        }
    }
}
