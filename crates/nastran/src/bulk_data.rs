//! A deck's content: every card that is read, by kind.

use crate::card::Card;
use crate::cards::kind::{CardKind, Cards, DeckCard, Family};
use crate::cards::{
    Aecomp, Aefact, Aelink, Aelist, Aeros, Aestat, Aesurf, BeamElement, BeamProperty, Caero1, Cbush, Conm1,
    Conm2, Coord, Crod, Genel, Grid, Mat1, Mat2, Mat8, Mat9, MonitorPoint, Mpc, Paero1, Pbush, Pcomp, Prod,
    Pshell, Psolid, Rbar, Rbe2, Rbe3, ScalarElement, ScalarProperty, Set1, SetUnion, ShellElement,
    SolidElement, Spc1, SplineCard, Suport, Trim,
};
use crate::deck::case_control::Subcase;
use crate::dmi::Dmi;
use crate::source::{InputError, Span};
use std::collections::BTreeMap;

/// What a deck says. Maps are in ascending identification numbers, which is Nastran's own order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BulkData {
    /// GRID.
    pub grids: BTreeMap<u32, Grid>,
    /// CORD1R, CORD1C, CORD1S, CORD2R, CORD2C, CORD2S.
    pub coords: BTreeMap<u32, Coord>,
    /// CBAR, CBEAM.
    pub beams: BTreeMap<u32, BeamElement>,
    /// PBAR, PBEAM.
    pub beam_properties: BTreeMap<u32, BeamProperty>,
    /// MAT1.
    pub materials: BTreeMap<u32, Mat1>,
    /// CONM2.
    pub masses: BTreeMap<u32, Conm2>,
    /// RBE2.
    pub rigid: BTreeMap<u32, Rbe2>,
    /// SPC1, in file order.
    pub constraints: Vec<Spc1>,
    /// SPCADD: the sets that a set unites.
    pub constraint_unions: BTreeMap<u32, SetUnion>,
    /// MPCADD: the sets that a set unites.
    pub equation_unions: BTreeMap<u32, SetUnion>,
    /// CQUAD4, CTRIA3.
    pub shells: BTreeMap<u32, ShellElement>,
    /// PSHELL.
    pub shell_properties: BTreeMap<u32, Pshell>,
    /// PCOMP, PCOMPG.
    pub laminates: BTreeMap<u32, Pcomp>,
    /// CHEXA, CPENTA, CTETRA.
    pub solids: BTreeMap<u32, SolidElement>,
    /// PSOLID.
    pub solid_properties: BTreeMap<u32, Psolid>,
    /// CROD.
    pub rods: BTreeMap<u32, Crod>,
    /// PROD.
    pub rod_properties: BTreeMap<u32, Prod>,
    /// CBUSH.
    pub bushes: BTreeMap<u32, Cbush>,
    /// PBUSH.
    pub bush_properties: BTreeMap<u32, Pbush>,
    /// CELAS1, CELAS2.
    pub springs: BTreeMap<u32, ScalarElement>,
    /// PELAS.
    pub spring_properties: BTreeMap<u32, ScalarProperty>,
    /// CMASS1, CMASS2.
    pub scalar_masses: BTreeMap<u32, ScalarElement>,
    /// PMASS.
    pub mass_properties: BTreeMap<u32, ScalarProperty>,
    /// GENEL.
    pub general: BTreeMap<u32, Genel>,
    /// CONM1.
    pub mass_matrices: BTreeMap<u32, Conm1>,
    /// RBAR.
    pub rigid_bars: BTreeMap<u32, Rbar>,
    /// RBE3.
    pub averages: BTreeMap<u32, Rbe3>,
    /// MPC, in file order.
    pub equations: Vec<Mpc>,
    /// MAT2.
    pub plane_materials: BTreeMap<u32, Mat2>,
    /// MAT8.
    pub ply_materials: BTreeMap<u32, Mat8>,
    /// MAT9.
    pub solid_materials: BTreeMap<u32, Mat9>,
    /// SPLINE1, SPLINE2, SPLINE4, SPLINE5.
    pub splines: BTreeMap<u32, SplineCard>,
    /// PARAM with a number, by name in capitals.
    pub parameters: BTreeMap<String, f64>,
    /// CAERO1.
    pub panels: BTreeMap<u32, Caero1>,
    /// PAERO1 (bodies are not read).
    pub panel_properties: BTreeMap<u32, Paero1>,
    /// AEFACT.
    pub factors: BTreeMap<u32, Aefact>,
    /// AESURF.
    pub surfaces: BTreeMap<u32, Aesurf>,
    /// AELIST.
    pub box_lists: BTreeMap<u32, Aelist>,
    /// SET1.
    pub sets: BTreeMap<u32, Set1>,
    /// MONPNT1, MONPNT3, in file order.
    pub monitors: Vec<MonitorPoint>,
    /// DMI matrices by name.
    pub matrices: BTreeMap<String, Dmi>,
    /// AEROS.
    pub aero_reference: Option<Aeros>,
    /// AESTAT.
    pub trim_variables: BTreeMap<u32, Aestat>,
    /// TRIM.
    pub trims: BTreeMap<u32, Trim>,
    /// AELINK, in file order.
    pub aero_links: Vec<Aelink>,
    /// AECOMP by name.
    pub aero_components: BTreeMap<String, Aecomp>,
    /// Subcases of the case control.
    pub subcases: Vec<Subcase>,
    /// SUPORT, in file order.
    pub supports: Vec<Suport>,
    /// Cards that are not read, by name.
    pub unknown: BTreeMap<String, Unread>,
}

/// How often a card that is not read occurs.
#[derive(Debug, Clone, PartialEq)]
pub struct Unread {
    /// Number of cards.
    pub count: usize,
    /// Where the first one stands.
    pub first: Span,
}

impl BulkData {
    /// How many cards of which names are not read; nothing if all are.
    pub fn unread_cards(&self) -> Option<String> {
        let list: Vec<String> =
            self.unknown.iter().map(|(card, unread)| format!("{} {card}", unread.count)).collect();
        (!list.is_empty()).then(|| list.join(", "))
    }
}

/// What a deck has beside cards that stand for themselves.
pub(crate) struct Rest {
    pub(crate) parameters: BTreeMap<String, f64>,
    pub(crate) matrices: BTreeMap<String, Dmi>,
    pub(crate) subcases: Vec<Subcase>,
    pub(crate) unknown: BTreeMap<String, Unread>,
}

impl Rest {
    /// Puts it into a deck as it is.
    pub(crate) fn put(self, deck: &mut BulkData) {
        (deck.parameters, deck.matrices) = (self.parameters, self.matrices);
        (deck.subcases, deck.unknown) = (self.subcases, self.unknown);
    }
}

/// Looks at all cards, kind by kind.
pub(crate) trait Visitor {
    /// The cards of one kind.
    fn cards(&mut self, kind: &CardKind, cards: &impl Cards);
}

/// Changes cards on their way into another deck.
pub(crate) trait Change {
    /// The card that comes in the place of one; nothing if none does.
    fn card<C: DeckCard>(&mut self, kind: &CardKind, card: C) -> Result<Option<C>, InputError>;
}

/// The one list of kinds, in the order in which they are written. Whatever goes over the cards goes over this list: a
/// field of [`BulkData`] that is not in it does not compile.
macro_rules! kinds {
    ($($field:ident: $family:ident $names:expr;)*) => {
        /// Every kind of cards.
        pub const CARD_KINDS: &[CardKind] =
            &[$(CardKind { field: stringify!($field), family: Family::$family, names: &$names }),*];

        impl BulkData {
            /// Shows all cards to a visitor.
            pub(crate) fn visit(&self, visitor: &mut impl Visitor) {
                let Self { $($field,)* parameters: _, matrices: _, subcases: _, unknown: _ } = self;
                $(visitor.cards(kind_of(stringify!($field)), $field);)*
            }

            /// Puts all cards, changed, into another deck and gives back the rest.
            ///
            /// # Errors
            /// If a change fails, or the other deck has a card with the same number.
            pub(crate) fn pour(self, into: &mut Self, change: &mut impl Change) -> Result<Rest, InputError> {
                let Self { $($field,)* parameters, matrices, subcases, unknown } = self;
                $(pour_kind(kind_of(stringify!($field)), $field, &mut into.$field, change)?;)*
                Ok(Rest { parameters, matrices, subcases, unknown })
            }

            /// Keeps what a card says; false if cards of its name are not read.
            ///
            /// # Errors
            /// If it is wrong, or its number or name is taken.
            pub(crate) fn keep(&mut self, card: &Card) -> Result<bool, InputError> {
                $(if $names.contains(&card.name.as_str()) {
                    return keep_in(&mut self.$field, card).map(|()| true);
                })*
                Ok(false)
            }
        }
    };
}

kinds! {
    coords: Own ["CORD2R", "CORD2C", "CORD2S", "CORD1R", "CORD1C", "CORD1S"];
    grids: Own ["GRID"];
    beams: Element ["CBAR", "CBEAM"];
    beam_properties: BeamProperty ["PBAR", "PBEAM", "PBARL", "PBEAML"];
    materials: Material ["MAT1"];
    masses: MassElement ["CONM2"];
    rigid: RigidElement ["RBE2"];
    constraints: Own ["SPC1", "SPC"];
    sets: Own ["SET1"];
    shells: Element ["CQUAD4", "CTRIA3"];
    solids: Element ["CHEXA", "CPENTA", "CTETRA"];
    rods: Element ["CROD"];
    bushes: Element ["CBUSH"];
    springs: Element ["CELAS1", "CELAS2"];
    scalar_masses: MassElement ["CMASS1", "CMASS2"];
    general: Element ["GENEL"];
    mass_matrices: MassElement ["CONM1"];
    rigid_bars: RigidElement ["RBAR"];
    averages: RigidElement ["RBE3"];
    equations: Own ["MPC"];
    shell_properties: ShellProperty ["PSHELL"];
    laminates: ShellProperty ["PCOMP", "PCOMPG"];
    solid_properties: Own ["PSOLID"];
    rod_properties: Own ["PROD"];
    bush_properties: Own ["PBUSH"];
    spring_properties: Own ["PELAS"];
    mass_properties: Own ["PMASS"];
    plane_materials: Material ["MAT2"];
    ply_materials: Material ["MAT8"];
    solid_materials: Material ["MAT9"];
    panels: Panel ["CAERO1"];
    panel_properties: Own ["PAERO1"];
    factors: Own ["AEFACT"];
    surfaces: Own ["AESURF"];
    box_lists: Own ["AELIST"];
    splines: Own ["SPLINE1", "SPLINE2", "SPLINE4", "SPLINE5"];
    monitors: Own ["MONPNT1", "MONPNT3"];
    constraint_unions: Own ["SPCADD"];
    equation_unions: Own ["MPCADD"];
    aero_reference: Own ["AEROS"];
    trim_variables: Own ["AESTAT"];
    trims: Own ["TRIM"];
    aero_links: Own ["AELINK"];
    aero_components: Own ["AECOMP"];
    supports: Own ["SUPORT"];
}

/// The kind that a field holds.
fn kind_of(field: &str) -> &'static CardKind {
    CARD_KINDS.iter().find(|kind| kind.field == field).expect("every field is in the list that made it")
}

fn pour_kind<C: Cards>(
    kind: &CardKind,
    from: C,
    into: &mut C,
    change: &mut impl Change,
) -> Result<(), InputError> {
    for card in from.taken() {
        let Some(card) = change.card(kind, card)? else { continue };
        let (name, key) = (kind.name(&card), card.key());
        into.put(card).map_err(|first| {
            InputError::general(format!(
                "two models share the number of {name} {key}, which is taken since {first}"
            ))
            .with_help("use smaller numbers in the wing's deck")
        })?;
    }
    Ok(())
}

fn keep_in<C: Cards>(cards: &mut C, card: &Card) -> Result<(), InputError> {
    for item in C::Card::read(card)? {
        let key = item.key();
        cards.put(item).map_err(|first| card.twice(format!("{} {key}", card.name).trim_end(), &first))?;
    }
    Ok(())
}
