//! A deck's content: every card that is read, by kind.

use crate::card::Card;
use crate::cards::kind::{CardKind, Cards, DeckCard, Family};
use crate::cards::{
    Acceleration, Aecomp, Aecompl, Aefact, Aelink, Aelist, Aero, Aeros, Aestat, Aesurf, AnalysisSet,
    BeamElement, BeamLoad, BeamProperty, Caero1, Cbush, Cbush1d, Conm1, Conm2, Conrod, Coord, Crod,
    CrossLoad, Cshear, Ctube, Cvisc, Darea, Diverg, Dmig, DynamicLoad, EigenMethod, Flfact, Flutter,
    FrequencyList, FunctionTable, Genel, Gravity, Grid, Gust, LineLoad, LoadSum, Mat1, Mat2, Mat8, Mat9,
    Mkaero, MonitorPoint, Mpc, Paero1, Pbush, Pbush1d, Pcomp, PointLoad, Pressure, Prod, Pshear, Pshell,
    Psolid, Ptube, Pvisc, Randps, Rbe2, Rbe3, RigidBody, Rrod, Rspline, ScalarElement, ScalarLoad,
    ScalarProperty, Set1, SetUnion, ShellElement, SolidElement, Spc1, Spcd, SpectrumTable, Spin, SplineCard,
    Spoint, Suport, Tabdmp1, Temperature, TimeSteps, Trim,
};
use crate::deck::case_control::{AddedMatrix, Subcase};
use crate::deck::damping::LossFactors;
use crate::dmi::Dmi;
use crate::source::{InputError, Span};
use std::collections::{BTreeMap, BTreeSet};

/// How often a card that is not read occurs.
#[derive(Debug, Clone, PartialEq)]
pub struct Unread {
    /// Number of cards.
    pub count: usize,
    /// Where the first one stands.
    pub first: Span,
    /// The whole numbers in their first fields: sets of loads, numbers of elements.
    pub numbers: BTreeSet<u32>,
    /// Names of parameters (PARAM whose value is a word or complex), in capitals.
    pub parameters: BTreeSet<String>,
}

impl Unread {
    /// Of a name that has not occurred yet, where it first does.
    pub(crate) fn first(span: Span) -> Self {
        Self { count: 0, first: span, numbers: BTreeSet::new(), parameters: BTreeSet::new() }
    }
}

/// What a deck has beside cards that stand for themselves.
pub(crate) struct Rest {
    pub(crate) parameters: BTreeMap<String, f64>,
    pub(crate) bars_twist: bool,
    pub(crate) loss_factors: LossFactors,
    pub(crate) matrices: BTreeMap<String, Dmi>,
    pub(crate) subcases: Vec<Subcase>,
    pub(crate) added: Vec<AddedMatrix>,
    pub(crate) air_errors: Vec<InputError>,
    pub(crate) unknown: BTreeMap<String, Unread>,
}

impl Rest {
    /// Puts it into a deck as it is.
    pub(crate) fn put(self, deck: &mut BulkData) {
        (deck.parameters, deck.bars_twist, deck.matrices) = (self.parameters, self.bars_twist, self.matrices);
        (deck.subcases, deck.added, deck.loss_factors) = (self.subcases, self.added, self.loss_factors);
        (deck.air_errors, deck.unknown) = (self.air_errors, self.unknown);
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

/// The one list of kinds, in the order in which they are written: field, what keeps its cards, whose numbers they must
/// not share, names. [`BulkData`] is made of it, and whatever goes over the cards goes over it, so none can be forgotten.
macro_rules! kinds {
    ($($field:ident: $cards:ty, $family:ident, [$($name:literal),*];)*) => {
        /// What a deck says. Maps are in ascending identification numbers, which is Nastran's own order.
        #[derive(Debug, Default, PartialEq)]
        pub struct BulkData {
            $(#[doc = concat!($($name, ", "),*, "in file order or by number or name.")]
            pub $field: $cards,)*
            /// PARAM with a number, by name in capitals.
            pub parameters: BTreeMap<String, f64>,
            /// BARMASS of the NASTRAN statement: bars (CBAR) have twisting inertia.
            pub bars_twist: bool,
            /// Structural damping of materials and elements (GE).
            pub loss_factors: LossFactors,
            /// DMI matrices by name.
            pub matrices: BTreeMap<String, Dmi>,
            /// Subcases of the case control.
            pub subcases: Vec<Subcase>,
            /// Matrices (DMIG) that the subcase in whose eyes the deck is seen adds to the structure's ([`BulkData::in_subcase`]).
            pub added: Vec<AddedMatrix>,
            /// What is wrong with cards of the air, which a structure does without ([`BulkData::refuse_unread_air`]).
            pub air_errors: Vec<InputError>,
            /// Cards that are not read, by name.
            pub unknown: BTreeMap<String, Unread>,
        }

        // Derived code would be compiled again, with the maps of all kinds, in every crate that copies a deck.
        impl Clone for BulkData {
            fn clone(&self) -> Self {
                Self {
                    $($field: self.$field.clone(),)*
                    parameters: self.parameters.clone(),
                    bars_twist: self.bars_twist,
                    loss_factors: self.loss_factors.clone(),
                    matrices: self.matrices.clone(),
                    subcases: self.subcases.clone(),
                    added: self.added.clone(),
                    air_errors: self.air_errors.clone(),
                    unknown: self.unknown.clone(),
                }
            }
        }

        /// Every kind of cards.
        pub const CARD_KINDS: &[CardKind] =
            &[$(CardKind { field: stringify!($field), family: Family::$family, names: &[$($name),*] }),*];

        impl BulkData {
            /// Shows all cards to a visitor.
            pub(crate) fn visit(&self, visitor: &mut impl Visitor) {
                let Self { $($field,)* parameters: _, bars_twist: _, loss_factors: _, matrices: _, subcases: _, added: _, air_errors: _, unknown: _ } = self;
                $(visitor.cards(kind_of(stringify!($field)), $field);)*
            }

            /// Puts all cards, changed, into another deck and gives back the rest.
            ///
            /// # Errors
            /// If a change fails, or the other deck has a card with the same number.
            pub(crate) fn pour(self, into: &mut Self, change: &mut impl Change) -> Result<Rest, InputError> {
                let Self { $($field,)* parameters, bars_twist, loss_factors, matrices, subcases, added, air_errors, unknown } = self;
                $(pour_kind(kind_of(stringify!($field)), $field, &mut into.$field, change)?;)*
                Ok(Rest { parameters, bars_twist, loss_factors, matrices, subcases, added, air_errors, unknown })
            }

            /// Keeps what a card says; false if cards of its name are not read.
            ///
            /// # Errors
            /// If it is wrong, or its number or name is taken.
            pub(crate) fn keep(&mut self, card: &Card) -> Result<bool, InputError> {
                $(if [$($name),*].contains(&card.name.as_str()) {
                    return keep_in(&mut self.$field, card).map(|()| true);
                })*
                Ok(false)
            }
        }
    };
}

kinds! {
    coords: BTreeMap<u32, Coord>, Own, ["CORD2R", "CORD2C", "CORD2S", "CORD1R", "CORD1C", "CORD1S"];
    grids: BTreeMap<u32, Grid>, Own, ["GRID"];
    scalar_points: BTreeMap<u32, Spoint>, Own, ["SPOINT"];
    beams: BTreeMap<u32, BeamElement>, Element, ["CBAR", "CBEAM"];
    beam_properties: BTreeMap<u32, BeamProperty>, BeamProperty, ["PBAR", "PBEAM", "PBARL", "PBEAML", "PBCOMP"];
    materials: BTreeMap<u32, Mat1>, Material, ["MAT1"];
    masses: BTreeMap<u32, Conm2>, MassElement, ["CONM2"];
    rigid: BTreeMap<u32, Rbe2>, RigidElement, ["RBE2"];
    constraints: Vec<Spc1>, Own, ["SPC1", "SPC"];
    sets: BTreeMap<u32, Set1>, Own, ["SET1"];
    shells: BTreeMap<u32, ShellElement>, Element, ["CQUAD4", "CTRIA3", "CQUADR", "CTRIAR", "CQUAD8", "CTRIA6"];
    solids: BTreeMap<u32, SolidElement>, Element, ["CHEXA", "CPENTA", "CTETRA"];
    rods: BTreeMap<u32, Crod>, Element, ["CROD"];
    tubes: BTreeMap<u32, Ctube>, Element, ["CTUBE"];
    shear_panels: BTreeMap<u32, Cshear>, Element, ["CSHEAR"];
    conrods: BTreeMap<u32, Conrod>, Element, ["CONROD"];
    bushes: BTreeMap<u32, Cbush>, Element, ["CBUSH"];
    line_bushes: BTreeMap<u32, Cbush1d>, Element, ["CBUSH1D"];
    dampers: BTreeMap<u32, Cvisc>, Element, ["CVISC"];
    scalar_dampers: BTreeMap<u32, ScalarElement>, Element, ["CDAMP1", "CDAMP2", "CDAMP3", "CDAMP4"];
    springs: BTreeMap<u32, ScalarElement>, Element, ["CELAS1", "CELAS2", "CELAS3", "CELAS4"];
    scalar_masses: BTreeMap<u32, ScalarElement>, MassElement, ["CMASS1", "CMASS2", "CMASS3", "CMASS4"];
    general: BTreeMap<u32, Genel>, Element, ["GENEL"];
    mass_matrices: BTreeMap<u32, Conm1>, MassElement, ["CONM1"];
    rigid_bodies: BTreeMap<u32, RigidBody>, RigidElement, ["RBAR", "RBE1", "RBAR1", "RTRPLT", "RTRPLT1"];
    rigid_rods: BTreeMap<u32, Rrod>, RigidElement, ["RROD"];
    rigid_splines: BTreeMap<u32, Rspline>, RigidElement, ["RSPLINE"];
    averages: BTreeMap<u32, Rbe3>, RigidElement, ["RBE3"];
    equations: Vec<Mpc>, Own, ["MPC"];
    shell_properties: BTreeMap<u32, Pshell>, ShellProperty, ["PSHELL"];
    laminates: BTreeMap<u32, Pcomp>, ShellProperty, ["PCOMP", "PCOMPG"];
    solid_properties: BTreeMap<u32, Psolid>, Own, ["PSOLID"];
    rod_properties: BTreeMap<u32, Prod>, Own, ["PROD"];
    tube_properties: BTreeMap<u32, Ptube>, Own, ["PTUBE"];
    panel_sections: BTreeMap<u32, Pshear>, Own, ["PSHEAR"];
    bush_properties: BTreeMap<u32, Pbush>, Own, ["PBUSH"];
    line_bush_properties: BTreeMap<u32, Pbush1d>, Own, ["PBUSH1D"];
    damper_properties: BTreeMap<u32, Pvisc>, Own, ["PVISC"];
    damping_properties: BTreeMap<u32, ScalarProperty>, Own, ["PDAMP"];
    spring_properties: BTreeMap<u32, ScalarProperty>, Own, ["PELAS"];
    mass_properties: BTreeMap<u32, ScalarProperty>, Own, ["PMASS"];
    plane_materials: BTreeMap<u32, Mat2>, Material, ["MAT2"];
    ply_materials: BTreeMap<u32, Mat8>, Material, ["MAT8"];
    solid_materials: BTreeMap<u32, Mat9>, Material, ["MAT9"];
    panels: BTreeMap<u32, Caero1>, Panel, ["CAERO1"];
    panel_properties: BTreeMap<u32, Paero1>, Own, ["PAERO1"];
    factors: BTreeMap<u32, Aefact>, Own, ["AEFACT"];
    surfaces: BTreeMap<u32, Aesurf>, Own, ["AESURF"];
    box_lists: BTreeMap<u32, Aelist>, Own, ["AELIST"];
    splines: BTreeMap<u32, SplineCard>, Own, ["SPLINE1", "SPLINE2", "SPLINE4", "SPLINE5"];
    monitors: Vec<MonitorPoint>, Own, ["MONPNT1", "MONPNT3"];
    constraint_unions: BTreeMap<u32, SetUnion>, Own, ["SPCADD"];
    equation_unions: BTreeMap<u32, SetUnion>, Own, ["MPCADD"];
    point_loads: Vec<PointLoad>, Own, ["FORCE", "MOMENT"];
    scalar_loads: Vec<ScalarLoad>, Own, ["SLOAD"];
    line_loads: Vec<LineLoad>, Own, ["FORCE1", "MOMENT1"];
    cross_loads: Vec<CrossLoad>, Own, ["FORCE2", "MOMENT2"];
    beam_loads: Vec<BeamLoad>, Own, ["PLOAD1"];
    pressures: Vec<Pressure>, Own, ["PLOAD", "PLOAD2", "PLOAD4"];
    gravities: Vec<Gravity>, Own, ["GRAV"];
    spins: Vec<Spin>, Own, ["RFORCE"];
    accelerations: Vec<Acceleration>, Own, ["ACCEL1"];
    load_sums: BTreeMap<u32, LoadSum>, Own, ["LOAD"];
    enforced: Vec<Spcd>, Own, ["SPCD"];
    temperatures: Vec<Temperature>, Own, ["TEMP", "TEMPD", "TEMPRB", "TEMPP1"];
    aero_reference: Option<Aeros>, Own, ["AEROS"];
    trim_variables: BTreeMap<u32, Aestat>, Own, ["AESTAT"];
    trims: BTreeMap<u32, Trim>, Own, ["TRIM"];
    divergences: BTreeMap<u32, Diverg>, Own, ["DIVERG"];
    aero_links: Vec<Aelink>, Own, ["AELINK"];
    aero_components: BTreeMap<String, Aecomp>, Own, ["AECOMP"];
    component_lists: BTreeMap<String, Aecompl>, Own, ["AECOMPL"];
    eigen_methods: BTreeMap<u32, EigenMethod>, Own, ["EIGRL", "EIGR"];
    supports: Vec<Suport>, Own, ["SUPORT", "SUPORT1"];
    analysis_sets: Vec<AnalysisSet>, Own,
        ["ASET1", "OMIT1", "QSET1", "ASET", "BSET", "BSET1", "CSET", "CSET1", "OMIT", "QSET"];
    unsteady_reference: Option<Aero>, Own, ["AERO"];
    flutters: BTreeMap<u32, Flutter>, Own, ["FLUTTER"];
    flutter_factors: BTreeMap<u32, Flfact>, Own, ["FLFACT"];
    reduced_frequencies: Vec<Mkaero>, Own, ["MKAERO1", "MKAERO2"];
    damping_tables: BTreeMap<u32, Tabdmp1>, Own, ["TABDMP1"];
    gusts: BTreeMap<u32, Gust>, Own, ["GUST"];
    dynamic_loads: BTreeMap<u32, DynamicLoad>, Own, ["TLOAD1", "TLOAD2", "RLOAD1", "RLOAD2"];
    dynamic_sums: BTreeMap<u32, LoadSum>, Own, ["DLOAD"];
    load_areas: Vec<Darea>, Own, ["DAREA"];
    extra_points: BTreeMap<u32, Spoint>, Own, ["EPOINT"];
    direct_matrices: Vec<Dmig>, Own, ["DMIG"];
    frequencies: Vec<FrequencyList>, Own, ["FREQ", "FREQ1", "FREQ2"];
    time_steps: BTreeMap<u32, TimeSteps>, Own, ["TSTEP"];
    function_tables: BTreeMap<u32, FunctionTable>, Own, ["TABLED1", "TABLED2", "TABLED3"];
    spectrum_tables: BTreeMap<u32, SpectrumTable>, Own, ["TABRND1", "TABRNDG"];
    spectra: Vec<Randps>, Own, ["RANDPS"];
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
