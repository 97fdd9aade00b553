//! Properties of shells, solids, rods and springs, and anisotropic materials, as cards.

use crate::cards::BulkData;
use crate::fe_cards::Pcomp;
use crate::write::fields::Fields;

/// PSHELL, PCOMP, PCOMPG, PSOLID, PROD, PBUSH, PELAS and PMASS.
pub(super) fn properties(deck: &BulkData, text: &mut String) {
    for shell in deck.shell_properties.values() {
        let card = Fields::new("PSHELL").int(shell.id).optional(shell.membrane).real(shell.thickness);
        let card = card.optional(shell.bending).real(shell.bending_ratio).optional(shell.shear);
        let card = card.real(shell.shear_ratio).real(shell.nsm).blanks(2).optional(shell.coupling);
        text.push_str(&card.write());
    }
    deck.laminates.values().for_each(|property| text.push_str(&laminate(property)));
    for solid in deck.solid_properties.values() {
        let card = Fields::new("PSOLID").ints([solid.id, solid.material]).text(solid.cordm.to_string());
        text.push_str(&card.write());
    }
    for rod in deck.rod_properties.values() {
        let card = Fields::new("PROD").ints([rod.id, rod.material]).reals(&[rod.area, rod.j]);
        text.push_str(&card.blanks(1).real(rod.nsm).write());
    }
    for bush in deck.bush_properties.values() {
        text.push_str(&Fields::new("PBUSH").int(bush.id).text("K").reals(&bush.stiffness).write());
    }
    for spring in deck.spring_properties.values() {
        text.push_str(&Fields::new("PELAS").int(spring.id).real(spring.value).write());
    }
    for mass in deck.mass_properties.values() {
        text.push_str(&Fields::new("PMASS").int(mass.id).real(mass.value).write());
    }
}

/// MAT2, MAT8 and MAT9.
pub(super) fn materials(deck: &BulkData, text: &mut String) {
    for material in deck.plane_materials.values() {
        let card = Fields::new("MAT2").int(material.id).reals(&material.g).real(material.rho);
        text.push_str(&card.write());
    }
    for ply in deck.ply_materials.values() {
        let card = Fields::new("MAT8").int(ply.id).reals(&[ply.e1, ply.e2, ply.nu12, ply.g12]);
        text.push_str(&card.reals(&[ply.g1z, ply.g2z, ply.rho]).write());
    }
    for material in deck.solid_materials.values() {
        let card = Fields::new("MAT9").int(material.id).reals(&material.g).real(material.rho);
        text.push_str(&card.write());
    }
}

fn laminate(property: &Pcomp) -> String {
    let card = Fields::new(if property.is_global { "PCOMPG" } else { "PCOMP" }).int(property.id);
    let card = match property.z0 {
        Some(z0) => card.real(z0),
        None => card.blanks(1),
    };
    let card = card.real(property.nsm).blanks(4);
    let mut card = if property.is_symmetric { card.text("SYM") } else { card.blanks(1) };
    for ply in &property.plies {
        if property.is_global {
            card = card.next_line().int(ply.global_id.unwrap_or(1));
        }
        card = card.int(ply.material).reals(&[ply.thickness, ply.angle_deg]).blanks(1);
    }
    card.write()
}
