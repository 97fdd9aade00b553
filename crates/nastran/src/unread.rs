//! Cards that are not read: those that a structure cannot be without, and what to say of the others.
//!
//! A finite element, a mass or a rigid element that is left out changes stiffness and mass without anyone noticing; so a
//! structure with one is refused by its name. What plots, selects, optimises or tabulates is listed and left alone, and so
//! is what counts only if the case control selects it (loads, `NSM`, `DMIG`).

use crate::bulk_data::{BulkData, Unread};
use crate::source::InputError;

/// Elements, masses and rigid elements of the Quick Reference Guides of MSC, NX and NASTRAN-95 that are not read, and
/// what is read in their place.
const ELEMENTS: &[(&str, &str)] = &[
    ("CTRIA1 CTRIA2 CTRPLT CTRBSC CTRMEM CTRIM6 CTRPLT1 CTRSHL", "CTRIA3"),
    ("CQUAD CQUAD1 CQUAD2 CQDPLT CQDMEM CQDMEM1 CQDMEM2", "CQUAD4"),
    ("CTWIST", "CQUAD4 and CROD"),
    ("CIHEX1 CIHEX2 CIHEX3 CHEXA1 CHEXA2 CHEX8 CHEX20 CHEXPR CIFHEX", "CHEXA"),
    ("CWEDGE CPENPR CIFPENT", "CPENTA"),
    ("CTETPR CPYRAM CPYRA", "CTETRA and CPENTA"),
    ("CBEND CBEAM3", "CBEAM"),
    ("CBUSH2D CGAP CBEAR CROTORG", "CBUSH with the stiffness at the working point"),
    ("CWELD CFAST CSEAM", "CBUSH between RBE3"),
    (DAMPERS, "a damping ratio of the modes"),
    (
        "CTRIAX CTRIAX6 CTRAX3 CTRAX6 CQUADX CQUADX4 CQUADX8 CCONEAX CTRIARG CTRAPRG CTRIAAX CTRAPAX CTORDRG",
        "a model in space",
    ),
    ("CPLSTN3 CPLSTN4 CPLSTN6 CPLSTN8 CPLSTS3 CPLSTS4 CPLSTS6 CPLSTS8", "CTRIA3 or CQUAD4"),
    ("CDUM1 CDUM2 CDUM3 CDUM4 CDUM5 CDUM6 CDUM7 CDUM8 CDUM9 CRAC2D CRAC3D", "GENEL"),
    ("EGRID CGEN GRIDG GRIDU", "GRID and elements, which the mesh generator would have made, for"),
    ("RINGFL AXIF RINGAX AXIC", "a model in space"),
    ("PLPLANE PLSOLID MATHP MATHE", "PSHELL or PSOLID of an elastic material for hyperelastic"),
    ("CRROD RJOINT CRIGDR", "RROD or MPC"),
    ("CRBAR", "RBAR"),
    ("CRBE1 CRBE2 CRIGD1 CRIGD2 CRTRPLT RSSCON", "RBE1, RBE2 or MPC"),
    ("CRSPLINE CRBE3 CRIGD3 RBE2GS", "RSPLINE, RBE3 or MPC"),
];

/// Dampers, which have no part in statics, natural modes and trims.
const DAMPERS: &str = "CDAMP5";

impl BulkData {
    /// How many cards of which names are not read, parameters with theirs (`1 EIGC, 2 PARAM (OGEOM, PRGPST)`); nothing if all are.
    pub fn unread_cards(&self) -> Option<String> {
        let counted = |(card, unread): (&String, &Unread)| {
            let names: Vec<&str> = unread.parameters.iter().map(String::as_str).collect();
            let names = if names.is_empty() { String::new() } else { format!(" ({})", names.join(", ")) };
            format!("{} {card}{names}", unread.count)
        };
        let list: Vec<String> = self.unknown.iter().map(counted).collect();
        (!list.is_empty()).then(|| list.join(", "))
    }

    /// Which structural damping of materials and elements flutter is computed without.
    pub fn damping_remark(&self) -> Option<String> {
        let counts = self.loss_factors.counts.iter();
        let list: Vec<String> = counts.map(|(name, count)| format!("GE of {name} ({count})")).collect();
        (!list.is_empty()).then(|| {
            format!(
                "structural damping on cards is not computed with in flutter: {}; give it by frequency (SDAMPING and TABDMP1)",
                list.join(", ")
            )
        })
    }

    /// Refuses a deck whose cards of the air are wrong or not read as they stand.
    ///
    /// # Errors
    /// If there is one: the first.
    pub fn refuse_unread_air(&self) -> Result<(), InputError> {
        self.air_errors.first().map_or(Ok(()), |error| Err(error.clone()))
    }

    /// Refuses a deck with elements, masses or rigid elements that are not read.
    ///
    /// # Errors
    /// If there is one: with the names, how many of each, where the first of each stands, and what to write instead.
    pub fn refuse_unread_elements(&self) -> Result<(), InputError> {
        self.refuse_elements_but("")
    }

    /// As [`BulkData::refuse_unread_elements`], where damping counts for nothing (statics, natural modes, trims).
    ///
    /// # Errors
    /// As [`BulkData::refuse_unread_elements`].
    pub fn refuse_unread_undamped(&self) -> Result<(), InputError> {
        self.refuse_elements_but(DAMPERS)
    }

    fn refuse_elements_but(&self, allowed: &str) -> Result<(), InputError> {
        let is_in = |names: &str, name: &str| names.split(' ').any(|one| one == name);
        let instead = |name: &str| ELEMENTS.iter().find(|(names, _)| is_in(names, name)).map(|row| row.1);
        let unread = self.unknown.iter().filter(|(name, _)| !is_in(allowed, name));
        let mut left: Vec<(&String, &Unread, &str)> =
            unread.filter_map(|(name, unread)| Some((name, unread, instead(name)?))).collect();
        left.sort_by_key(|(name, unread, _)| (std::cmp::Reverse(unread.count), *name));
        let Some((_, first, _)) = left.first() else { return Ok(()) };
        let list: Vec<String> = left
            .iter()
            .map(|(name, Unread { count, first, .. }, _)| format!("{count} {name} (from {first} on)"))
            .collect();
        let message = format!(
            "the deck has {}: elements that are not read, and leaving them out would change stiffness, damping, mass or constraints",
            list.join(", ")
        );
        let help: Vec<String> =
            left.iter().map(|(name, _, instead)| format!("{instead} for {name}")).collect();
        let help = format!("write {}, or take out what the model shall do without", help.join(", "));
        Err(InputError::at(&first.first, message).with_help(help))
    }
}
