//! Static aeroelasticity: AEROS, AESTAT, TRIM, SUPORT, AELINK and AECOMP. They are read, not written, and have no mirror
//! image: they say what is asked of the whole aircraft.

use super::prelude::*;

/// References of the aerodynamics (AEROS).
#[derive(Debug, Clone, PartialEq)]
pub struct Aeros {
    /// Aerodynamic system, x along the stream; 0 is basic.
    pub acsid: u32,
    /// System of accelerations, rates and derivatives; 0 is basic.
    pub rcsid: u32,
    /// Reference chord.
    pub chord: f64,
    /// Reference span.
    pub span_length: f64,
    /// Reference area.
    pub area: f64,
    /// Symmetry about the xz plane: 1 symmetric, 0 none, -1 antisymmetric.
    pub symmetry: i32,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aeros {
    type Key = &'static str;
    fn key(&self) -> Self::Key {
        ""
    }
    fn span(&self) -> &Span {
        &self.span
    }
    /// AEROS: ACSID RCSID REFC REFB REFS SYMXZ SYMXY.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.unset(6, "SYMXY")?;
        let symmetry = card.integer_or(5, "SYMXZ", 0)?;
        if !(-1..=1).contains(&symmetry) {
            return Err(card.wrong(5, "SYMXZ", "1, 0 or -1"));
        }
        Ok(vec![Aeros {
            acsid: card.count_or(0, "ACSID", 0)?,
            rcsid: card.count_or(1, "RCSID", 0)?,
            chord: card.positive(2, "REFC")?,
            span_length: card.positive(3, "REFB")?,
            area: card.positive(4, "REFS")?,
            symmetry,
            span: card.span.clone(),
        }])
    }

    not_written!();

    raises!(systems: acsid, rcsid);

    no_image!();
}

/// A rigid-body trim variable (AESTAT).
#[derive(Debug, Clone, PartialEq)]
pub struct Aestat {
    /// Identification number.
    pub id: u32,
    /// ANGLEA, SIDES, ROLL, PITCH, YAW or URDD1 to URDD6.
    pub label: String,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aestat {
    numbered!();
    /// AESTAT: ID LABEL.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        Ok(vec![Aestat { id: card.id(0, "ID")?, label: card.name_at(1, "LABEL")?, span: card.span.clone() }])
    }

    not_written!();

    raises!(cards: id);

    no_image!();
}

/// A trim condition (TRIM).
#[derive(Debug, Clone, PartialEq)]
pub struct Trim {
    /// Identification number.
    pub id: u32,
    /// Mach number.
    pub mach: f64,
    /// Dynamic pressure.
    pub q: f64,
    /// AEQR: what the deformation counts for in the air's loads, from zero (a rigid trim) to one.
    pub elastic_share: f64,
    /// Variables with given values.
    pub fixed: Vec<(String, f64)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Trim {
    numbered!();
    /// TRIM: ID MACH Q LABEL1 UX1 LABEL2 UX2 AEQR / LABEL3 UX3 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let elastic_share = if card.text(7).is_empty() { 1.0 } else { card.real(7, "AEQR")? };
        if !(0.0..=1.0).contains(&elastic_share) {
            return Err(card.wrong(7, "AEQR", "from 0., the rigid aircraft, to 1., the elastic one"));
        }
        let mut fixed = Vec::new();
        for at in [3, 5].into_iter().chain((8..card.len()).step_by(2)) {
            if !card.text(at).is_empty() {
                fixed.push((card.name_at(at, "LABEL")?, card.real(at + 1, "UX")?));
            }
        }
        let mach = card.not_negative(1, "MACH", 0.0)?;
        Ok(vec![Trim {
            id: card.id(0, "ID")?,
            mach,
            q: card.positive(2, "Q")?,
            elastic_share,
            fixed,
            span: card.span.clone(),
        }])
    }

    not_written!();

    // A set keeps its number.
    keeps_numbers!();

    no_image!();
}

/// What divergence is looked for (DIVERG).
#[derive(Debug, Clone, PartialEq)]
pub struct Diverg {
    /// Identification number.
    pub id: u32,
    /// How many dynamic pressures of divergence, the lowest.
    pub roots: u32,
    /// Mach numbers.
    pub machs: Vec<f64>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Diverg {
    numbered!();
    /// DIVERG: SID NROOT M1 M2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let given = (2..card.len()).filter(|at| !card.text(*at).is_empty());
        let machs: Vec<f64> = given.map(|at| card.not_negative(at, "M", 0.0)).collect::<Result<_, _>>()?;
        if machs.is_empty() {
            return Err(card.empty(2, "M1", "a Mach number"));
        }
        let roots = if card.text(1).is_empty() { 1 } else { card.id(1, "NROOT")? };
        Ok(vec![Diverg { id: card.id(0, "SID")?, roots, machs, span: card.span.clone() }])
    }

    not_written!();

    // A set keeps its number.
    keeps_numbers!();

    no_image!();
}

/// Fictitious supports of one grid (SUPORT, and SUPORT1, which a subcase selects).
#[derive(Debug, Clone, PartialEq)]
pub struct Suport {
    /// Its set (SUPORT1); none for one that always applies (SUPORT).
    pub set: Option<u32>,
    /// Grid.
    pub grid: u32,
    /// Components, digits 1 to 6.
    pub components: Vec<u8>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Suport {
    keyed!(u32, grid);
    /// SUPORT: ID1 C1 ID2 C2 ... SUPORT1: SID ID1 C1 ID2 C2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let first = usize::from(card.name == "SUPORT1");
        let set = (first > 0).then(|| card.id(0, "SID")).transpose()?;
        let end = card.len().max(first + 1);
        let places = (first..end).step_by(2).filter(|at| *at == first || !card.text(*at).is_empty());
        places
            .map(|at| {
                let (grid, components) = (card.id(at, "ID")?, card.some_components(at + 1, "C")?);
                Ok(Suport { set, grid, components, span: card.span.clone() })
            })
            .collect()
    }

    not_written!();

    raises!(cards: grid);

    no_image!();
}

/// One control in proportion to others (AELINK): dependent + sum of coefficient times independent = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Aelink {
    /// The TRIM it holds for; none for all (ALWAYS or 0).
    pub trim: Option<u32>,
    /// The dependent control.
    pub dependent: String,
    /// Independent controls and their coefficients.
    pub terms: Vec<(String, f64)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aelink {
    keyed!(String, dependent);
    /// AELINK: ID LABLD LABL1 C1 LABL2 C2 LABL3 C3 / LABL4 C4 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let always = card.text(0).eq_ignore_ascii_case("ALWAYS");
        let trim = if always { 0 } else { card.count_or(0, "ID", 0)? };
        let mut terms = Vec::new();
        for at in (2..card.len()).step_by(2) {
            if !card.text(at).is_empty() {
                terms.push((card.name_at(at, "LABL")?, card.real(at + 1, "C")?));
            }
        }
        if terms.is_empty() {
            return Err(card.empty(2, "LABL1", "an independent control and its coefficient"));
        }
        let dependent = card.name_at(1, "LABLD")?;
        Ok(vec![Aelink { trim: (trim > 0).then_some(trim), dependent, terms, span: card.span.clone() }])
    }

    not_written!();

    // It has no number of its own, and sets keep theirs.
    keeps_numbers!();

    no_image!();
}

/// What lists a component is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ComponentOf {
    /// Boxes (AELIST).
    Boxes,
    /// Whole panels (CAERO).
    Panels,
    /// Grids (SET1).
    Grids,
}

/// Boxes whose loads a monitoring station adds up (AECOMP).
#[derive(Debug, Clone, PartialEq)]
pub struct Aecomp {
    /// Name.
    pub name: String,
    /// What the lists are.
    pub of: ComponentOf,
    /// Their numbers.
    pub lists: Vec<u32>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aecomp {
    keyed!(String, name);
    /// AECOMP: NAME LISTTYPE LISTID1 LISTID2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let of = match card.name_at(1, "LISTTYPE")?.as_str() {
            "AELIST" => ComponentOf::Boxes,
            "CAERO" => ComponentOf::Panels,
            "SET1" => ComponentOf::Grids,
            _ => return Err(card.wrong(1, "LISTTYPE", "AELIST, CAERO or SET1")),
        };
        let lists = card.id_list(2, "LISTID")?;
        Ok(vec![Aecomp { name: card.name_at(0, "NAME")?, of, lists, span: card.span.clone() }])
    }

    not_written!();

    fn raise(&mut self, by: Step) {
        match self.of {
            ComponentOf::Panels => by.boxes(&mut self.lists),
            ComponentOf::Boxes | ComponentOf::Grids => by.cards(&mut self.lists),
        }
    }

    no_image!();
}

/// Components as one (AECOMPL).
#[derive(Debug, Clone, PartialEq)]
pub struct Aecompl {
    /// Name, which no AECOMP has.
    pub name: String,
    /// Names of AECOMP, or of other AECOMPL.
    pub parts: Vec<String>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aecompl {
    keyed!(String, name);
    /// AECOMPL: NAME LABEL1 LABEL2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let there = (1..card.len()).filter(|at| !card.text(*at).is_empty());
        let parts: Vec<String> = there.map(|at| card.name_at(at, "LABEL")).collect::<Result<_, _>>()?;
        if parts.is_empty() {
            return Err(card.empty(1, "LABEL1", "the name of an AECOMP"));
        }
        Ok(vec![Self { name: card.name_at(0, "NAME")?, parts, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}
