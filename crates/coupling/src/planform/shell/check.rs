//! What a shell-and-solid wing must satisfy before cards are made of it.

use super::settings::{PlySettings, Profile, ShellSolid, Surface};
use crate::planform::check::{count, positive, within};
use crate::planform::point_mass::check_masses;
use crate::planform::{Fault, Planform};

/// So many grids fit the numbers given to them, and no more stations than grids of the axis.
const MOST_SOLIDS: usize = 99_999;
const MOST_STATIONS: usize = 1900;

impl ShellSolid {
    pub(in crate::planform) fn check(&self, planform: &Planform) -> Result<(), Fault> {
        if planform.airfoil.is_none() {
            let help = "give `airfoil: \"...\"`, the section the skin lies on";
            return Err(Fault::named("ShellSolid", "a shell-and-solid wing needs an airfoil", help));
        }
        self.check_mesh(planform)?;
        within("elastic_axis_over_c", self.elastic_axis_over_c, 0.0, 1.0)?;
        self.check_materials()?;
        for (place, ply) in self.plies.iter().enumerate() {
            ply.check(self, planform, place + 1)?;
        }
        self.check_coverage(planform)?;
        self.check_webs(planform)?;
        within("finish_kg_m2", self.finish_kg_m2, 0.0, 100.0)?;
        for item in &self.line_masses {
            let possible = (0.0..=1e3).contains(&item.mass_kg_m) && (-1.0..=2.0).contains(&item.x_over_c);
            if !possible {
                let message = format!(
                    "{} has x_over_c {} and mass_kg_m {}, one of which cannot be",
                    item.name, item.x_over_c, item.mass_kg_m
                );
                let help = "expected x_over_c from -1 to 2 and mass_kg_m not below zero";
                return Err(Fault::named(&item.name, message, help));
            }
        }
        let (kx, ky, kz, kmx, kmy, kmz) = self.balance_stiffness;
        if let Some(k) = [kx, ky, kz, kmx, kmy, kmz].iter().find(|k| !(**k > 0.0 && k.is_finite())) {
            let message = format!("balance_stiffness has {k:?}, expected six numbers above zero");
            let help = "N/m along x, y, z, then N m/rad about them; leave it out for a stiff balance";
            return Err(Fault::field("balance_stiffness", message, help));
        }
        check_masses(self.point_masses.iter().chain(&self.sensors), planform.semispan_m)
    }

    fn check_mesh(&self, planform: &Planform) -> Result<(), Fault> {
        let (mesh, boxes) = (&self.mesh, &planform.boxes);
        count("spanwise_per_strip", mesh.spanwise_per_strip, 1, 100)?;
        count("chordwise_per_box", mesh.chordwise_per_box, 1, 100)?;
        count("thickness", mesh.thickness, 1, 100)?;
        let stations = boxes.spanwise * mesh.spanwise_per_strip;
        let solids = stations * boxes.chordwise * mesh.chordwise_per_box * mesh.thickness;
        if solids > MOST_SOLIDS || stations >= MOST_STATIONS {
            let message = format!(
                "the mesh has {solids} solids and {stations} stations, expected {MOST_SOLIDS} and {MOST_STATIONS} at \
                 most"
            );
            return Err(Fault::field("mesh", message, "use fewer elements in each box, strip or layer"));
        }
        let (first, last) = mesh.edges_over_c;
        let box_over_c = 1.0 / boxes.chordwise as f64;
        if !(first >= 0.0 && first < box_over_c && last <= 1.0 && last > 1.0 - box_over_c && first < last) {
            let message = format!(
                "edges_over_c is ({first}, {last}), expected one place in the first box and one in the last, \
                 each {box_over_c:.4} of the chord long"
            );
            return Err(Fault::field("edges_over_c", message, "the default is (0.01, 0.97)"));
        }
        Ok(())
    }

    fn check_materials(&self) -> Result<(), Fault> {
        for (place, material) in self.materials.iter().enumerate() {
            let name = &material.name;
            if name.is_empty() || self.materials[..place].iter().any(|other| other.name == *name) {
                let message = format!("two materials are called \"{name}\"");
                return Err(Fault::named(name, message, "give each its own name"));
            }
            let moduli = [material.e1_pa, material.e2_pa, material.g12_pa];
            let possible = moduli.iter().all(|&modulus| modulus > 0.0 && modulus <= 1e13)
                && material.nu12.powi(2) < material.e1_pa / material.e2_pa
                && (0.0..=1e5).contains(&material.rho_kg_m3);
            if !possible {
                let message = format!("the material \"{name}\" cannot be");
                let help = "expected moduli above zero (Pa), nu12^2 below e1/e2, a density not below zero";
                return Err(Fault::named(name, message, help));
            }
        }
        let foam = &self.foam;
        let possible = foam.e_pa > 0.0 && foam.e_pa <= 1e13 && foam.nu > -1.0 && foam.nu < 0.5;
        if possible && (0.0..=1e5).contains(&foam.rho_kg_m3) {
            return Ok(());
        }
        let help = "expected e_pa above zero, nu between -1 and 0.5, rho_kg_m3 not below zero";
        Err(Fault::field("foam", "the foam cannot be", help))
    }

    /// The skins must be closed, and so must every surface that has plies at all.
    fn check_coverage(&self, planform: &Planform) -> Result<(), Fault> {
        let edges_m = planform.strip_edges_m();
        let closed =
            [Surface::Upper, Surface::Lower, Surface::LeadingEdge, Surface::TrailingEdge, Surface::Webs];
        for surface in closed {
            let skin = matches!(surface, Surface::Upper | Surface::Lower);
            if !skin && !self.lies_on(surface) {
                continue;
            }
            let whole = |ply: &&PlySettings| ply.band.is_none() && ply.on.contains(&surface);
            let bare = edges_m
                .iter()
                .find(|&&y| !self.plies.iter().filter(whole).any(|ply| ply.thickness_m.at(y) > 0.0));
            if let Some(y_m) = bare {
                let message = format!("no ply covers {surface:?} at y = {y_m:.3} m");
                let help = "a ply without band and with a thickness above zero is needed at every station";
                return Err(Fault::field("plies", message, help));
            }
        }
        Ok(())
    }

    fn check_webs(&self, planform: &Planform) -> Result<(), Fault> {
        let lines = self.web_lines(&self.chord_lines(planform.boxes.chordwise));
        let last = planform.boxes.chordwise * self.mesh.chordwise_per_box;
        let outside = lines.iter().any(|&line| line == 0 || line == last);
        let twice = lines.iter().enumerate().any(|(place, line)| lines[..place].contains(line));
        if outside || twice || self.webs_over_c.iter().any(|x| !(0.0..=1.0).contains(x)) {
            let message =
                format!("webs_over_c is {:?}, which are no separate chord lines inside", self.webs_over_c);
            let help = "a web stands on the chord line next to it: give places near different edges of boxes, not the first or last";
            return Err(Fault::field("webs_over_c", message, help));
        }
        if lines.is_empty() == self.lies_on(Surface::Webs) {
            let help = "give both `webs_over_c` and a ply `on: [Webs]`, or neither";
            return Err(Fault::field("plies", "webs and their plies do not go together", help));
        }
        Ok(())
    }
}

impl PlySettings {
    fn check(&self, wing: &ShellSolid, planform: &Planform, number: usize) -> Result<(), Fault> {
        let fault = |message: String, help: &str| Err(Fault::field("plies", message, help));
        if !wing.materials.iter().any(|material| material.name == self.material) {
            let names: Vec<&str> = wing.materials.iter().map(|material| material.name.as_str()).collect();
            let help = format!("the materials are {}", names.join(", "));
            return Err(Fault::named(
                &self.material,
                format!("no material is called \"{}\"", self.material),
                &help,
            ));
        }
        if self.on.is_empty() || !self.angle_deg.is_finite() {
            return fault(
                format!("ply {number} lies nowhere or at no angle"),
                "for a skin `on: [Upper, Lower]`",
            );
        }
        if !self.thickness_m.is_possible(0.1) {
            let help = "(y_m, thickness) pairs in ascending y, thickness in metres, 0.1 at most: [(0.0, 0.3e-3), (1.8, 0.2e-3)]";
            return fault(format!("the thickness of ply {number} cannot be"), help);
        }
        let Some(band) = &self.band else { return Ok(()) };
        if self.on.iter().any(|surface| !matches!(surface, Surface::Upper | Surface::Lower)) {
            return fault(format!("ply {number} has a band off the skin"), "bands lie on Upper and Lower");
        }
        positive("centre_over_c", band.centre_over_c)?;
        if !band.width_m.is_possible(1e4) {
            return fault(
                format!("the width of ply {number}'s band cannot be"),
                "(y_m, width) pairs in ascending y",
            );
        }
        let (first, last) = wing.mesh.edges_over_c;
        let outside = planform.strip_edges_m().into_iter().find(|&y_m| {
            let half = 0.5 * band.width_m.at(y_m) / planform.chord_m(y_m);
            band.centre_over_c - half < first || band.centre_over_c + half > last
        });
        match outside {
            None => Ok(()),
            Some(y_m) => fault(
                format!("the band of ply {number} leaves the skin at y = {y_m:.3} m"),
                "keep the band between the mesh's first and last chord line, or leave `band` out",
            ),
        }
    }
}

impl Profile {
    fn is_possible(&self, highest: f64) -> bool {
        let values = self.0.iter().all(|pair| pair.0.is_finite() && (0.0..=highest).contains(&pair.1));
        let ascending = self.0.windows(2).all(|pair| pair[0].0 < pair[1].0);
        values && ascending && !self.0.is_empty()
    }
}
