//! The deck as its case control selects it: one owner of what SPC, MPC and SUPORT1 apply, for every command.
//!
//! With a case control, what it does not select does not apply, as in Nastran; a deck of bulk data alone has one set of each,
//! or sets that SPCADD and MPCADD unite. Where subcases differ in boundary conditions nothing is chosen in silence.

use crate::bulk_data::BulkData;
use crate::cards::{Aecomp, Divisions, SetUnion};
use crate::deck::case_control::{Asked, Subcase, foreign_purpose};
use crate::source::InputError;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

impl Subcase {
    /// Whether both have the same structure, modes and damping: all but what they ask of these (trims, flutter, gusts, loads, answers). What
    /// is refused of one is refused of the other.
    pub fn has_modes_of(&self, other: &Self) -> bool {
        let structure = |case: &Self| Self {
            id: 0,
            label: String::new(),
            trim: None,
            divergence: None,
            load: None,
            flutter: None,
            gust: None,
            dynamic_load: None,
            frequencies: None,
            time_steps: None,
            random: None,
            responses: Asked::Nothing,
            combinations: Vec::new(),
            ..case.clone()
        };
        structure(self) == structure(other)
    }
}

/// Materials whose constants change with the temperature.
const WARM_MATERIALS: &[&str] = &["MATT1", "MATT2", "MATT3", "MATT8", "MATT9", "MATT11"];

impl BulkData {
    /// The deck under its boundary conditions: those of a subcase, of the only ones there are, or of a deck without case
    /// control. The case control is gone from it.
    ///
    /// # Errors
    /// If the subcase is not there, subcases differ in boundary conditions and none is named, a selected set is not there, or
    /// several sets stand in a deck without case control.
    pub fn bounded(&self, subcase: Option<u32>) -> Result<Cow<'_, Self>, InputError> {
        if let Some(id) = subcase {
            let case = self.subcases.iter().find(|case| case.id == id).ok_or_else(|| {
                let known: Vec<String> = self.subcases.iter().map(|case| case.id.to_string()).collect();
                InputError::general(format!("the deck has no subcase {id}")).with_help(format!(
                    "there are: {}",
                    if known.is_empty() { "none".to_owned() } else { known.join(", ") }
                ))
            })?;
            return self.in_subcase(case).map(Cow::Owned);
        }
        let Some(first) = self.subcases.first() else {
            one_set("SPC", &clamps(self), &self.constraint_unions)?;
            one_set("MPC", &equations(self), &self.equation_unions)?;
            return Ok(Cow::Borrowed(self));
        };
        // Modes are asked for where a METHOD is.
        let is_asked =
            |case: &&Subcase| case.method.is_some() || self.subcases.iter().all(|case| case.method.is_none());
        let asked: Vec<&Subcase> = self.subcases.iter().filter(is_asked).collect();
        let conditions = |case: &Subcase| (case.spc, case.mpc, case.support);
        let chosen = asked.first().copied().unwrap_or(first);
        if asked.iter().any(|case| conditions(case) != conditions(chosen)) {
            let list: Vec<String> = asked.iter().map(|case| described(case)).collect();
            let message = format!("the subcases differ in boundary conditions: {}", list.join("; "));
            return Err(InputError::general(message).with_help("name one of them (--subcase NUMBER)"));
        }
        self.in_subcase(chosen).map(Cow::Owned)
    }

    /// The deck as a subcase sees it: its SPC and MPC sets (SPCADD and MPCADD unite several), its SUPORT1 and its symmetry.
    ///
    /// Of a deck without case control the default subcase is the whole deck, as in [`BulkData::bounded`].
    ///
    /// # Errors
    /// If a selected set is not there, or none of those that an SPCADD or MPCADD unites, or it selects something that changes the structure and is not read.
    pub fn in_subcase(&self, subcase: &Subcase) -> Result<Self, InputError> {
        if self.subcases.is_empty() && *subcase == Subcase::default() {
            return self.bounded(None).map(Cow::into_owned);
        }
        if let Some((text, span)) = &subcase.foreign {
            let message = format!("`{text}` asks for {}, which wingroot is not for", foreign_purpose(text));
            return Err(InputError::at(span, message)
                .with_help("take the command out if the model shall be run without"));
        }
        if let Some((text, span)) = subcase.unread.first() {
            let message = format!("`{text}` changes the structure, its loads or its modes and is not read");
            return Err(InputError::at(span, message)
                .with_help("take it out, or write what it adds as elements, masses and loads"));
        }
        if subcase.material_temperature.or(subcase.initial_temperature).or(subcase.temperature).is_some() {
            self.refuse_warm_materials()?;
        }
        if !subcase.matrices.is_empty() {
            self.refuse_unread_air()?;
        }
        let mut bulk = self.clone();
        bulk.subcases.clear();
        bulk.added.clone_from(&subcase.matrices);
        if let Some(is_on) = subcase.auto_spc {
            bulk.parameters.insert("AUTOSPC".to_owned(), f64::from(u8::from(is_on)));
        }
        let kept = selected("SPC", subcase.spc, &clamps(self), &self.constraint_unions)?;
        bulk.constraints.retain(|card| kept.contains(&card.set));
        bulk.constraint_unions.retain(|id, _| Some(*id) == subcase.spc);
        let kept = selected("MPC", subcase.mpc, &equations(self), &self.equation_unions)?;
        bulk.equations.retain(|card| kept.contains(&card.set));
        bulk.equation_unions.retain(|id, _| Some(*id) == subcase.mpc);
        if let Some(set) =
            subcase.support.filter(|set| self.supports.iter().all(|card| card.set != Some(*set)))
        {
            return Err(InputError::general(format!(
                "the case control selects SUPORT1 {set}, which is not there"
            )));
        }
        bulk.supports.retain(|card| card.set.is_none() || card.set == subcase.support);
        if let (Some(symmetry), Some(aeros)) = (subcase.symmetry, &mut bulk.aero_reference) {
            aeros.symmetry = symmetry;
        }
        Ok(bulk)
    }

    /// Refuses materials whose constants depend on a temperature that is selected.
    ///
    /// # Errors
    /// If there is one.
    pub fn refuse_warm_materials(&self) -> Result<(), InputError> {
        let warm = self.unknown.iter().find(|(name, _)| WARM_MATERIALS.contains(&name.as_str()));
        warm.map_or(Ok(()), |(name, unread)| {
            let message = format!("{name} makes a material change with the temperature, which is not read");
            Err(InputError::at(&unread.first, message)
                .with_help("give the constants at the temperature, or take it out"))
        })
    }

    /// Refuses what would leave a matrix of K2GG or M2GG behind.
    pub(crate) fn refuse_added(&self, what: &str) -> Result<(), InputError> {
        self.added.first().map_or(Ok(()), |matrix| {
            let message = format!("a deck with the matrix {} (DMIG) cannot be {what}", matrix.name);
            Err(InputError::at(&matrix.span, message).with_help("give what it adds as elements and masses"))
        })
    }

    /// Names of the monitoring stations in the deck's order, each once: Nastran prints several of one name one after the other, here
    /// those after the first have their place among them, `ROOT (2)`.
    pub fn station_names(&self) -> Vec<String> {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        let mut names = Vec::with_capacity(self.monitors.len());
        for monitor in &self.monitors {
            let count = counts.entry(&monitor.name).or_default();
            *count += 1;
            names.push(if *count == 1 {
                monitor.name.clone()
            } else {
                format!("{} ({count})", monitor.name)
            });
        }
        names
    }

    /// The components that a name stands for: an AECOMP, or those of an AECOMPL, of lists of lists too; nothing if one is not there.
    pub fn components_of(&self, name: &str) -> Option<Vec<&Aecomp>> {
        let (mut found, mut open, mut seen) = (Vec::new(), vec![name.to_owned()], BTreeSet::new());
        while let Some(name) = open.pop() {
            if !seen.insert(name.clone()) {
                continue;
            }
            match (self.aero_components.get(&name), self.component_lists.get(&name)) {
                (Some(component), _) => found.push(component),
                (None, Some(list)) => open.extend(list.parts.iter().cloned()),
                (None, None) => return None,
            }
        }
        Some(found)
    }

    /// Which panels have boxes on a part of them alone, because their lists of divisions (AEFACT) begin or end inside: said to the user.
    pub fn division_remark(&self) -> Option<String> {
        let is_part = |divisions: &Divisions| {
            let Divisions::Aefact(id) = divisions else { return false };
            let values = self.factors.get(id).map_or(&[][..], |list| &list.values);
            values.first().is_some_and(|first| *first > 1e-6)
                || values.last().is_some_and(|last| *last < 1.0 - 1e-6)
        };
        let of_part = self
            .panels
            .values()
            .filter(|panel| is_part(&panel.span_divisions) || is_part(&panel.chord_divisions));
        let list: Vec<String> = of_part.map(|panel| format!("CAERO1 {} ", panel.id)).collect();
        (!list.is_empty())
            .then(|| format!("{}has boxes on a part alone: AEFACT does not go from 0 to 1", list.concat()))
    }

    /// What of the deck's splines is not computed as it is asked for: said to the user.
    pub fn spline_remark(&self) -> Option<String> {
        let finite = self.splines.values().filter(|spline| spline.is_finite_plate);
        let list: Vec<String> = finite.map(|spline| spline.id.to_string()).collect();
        (!list.is_empty()).then(|| {
            format!("finite plates (FPS) are computed as infinite ones (IPS), splines {}", list.join(", "))
        })
    }

    /// Which combinations of subcases (SUBCOM, SYMCOM) are not computed: said to the user.
    pub fn combination_remarks(&self) -> Vec<String> {
        let all = self.subcases.iter().flat_map(|case| &case.combinations);
        all.map(|text| format!("`{text}` is not computed: it combines the answers of other subcases"))
            .collect()
    }

    /// What of the deck's constraints its case control leaves out or selects in vain, and elements that share a number: said to the user.
    pub fn remarks(&self) -> Vec<String> {
        let selects =
            |of: &dyn Fn(&Subcase) -> Option<u32>| self.subcases.iter().any(|case| of(case).is_some());
        let mut remarks = Vec::new();
        let mut left_out = |name: &str| {
            remarks.push(format!("the case control selects no {name}: those in the deck do not apply"));
        };
        if !self.subcases.is_empty() && !self.constraints.is_empty() && !selects(&|case| case.spc) {
            left_out("SPC");
        }
        if !self.subcases.is_empty() && !self.equations.is_empty() && !selects(&|case| case.mpc) {
            left_out("MPC");
        }
        let missing = |set: &u32| !equations(self).contains(set) && !self.equation_unions.contains_key(set);
        let sets: BTreeSet<u32> = self.subcases.iter().filter_map(|case| case.mpc).filter(missing).collect();
        remarks
            .extend(sets.iter().map(|set| format!("the case control selects MPC {set}, which is not there")));
        let all = |of: fn(&Subcase) -> Option<u32>| self.subcases.iter().filter_map(of).collect();
        remarks.extend(lacking("SPC", &clamps(self), &self.constraint_unions, &all(|case| case.spc)));
        remarks.extend(lacking("MPC", &equations(self), &self.equation_unions, &all(|case| case.mpc)));
        remarks.extend(self.combination_remarks());
        remarks.extend(self.shared_numbers());
        remarks
    }
}

/// Sets that a union of the `selected` ones names and that are not there.
fn lacking(
    kind: &str,
    sets: &BTreeSet<u32>,
    unions: &BTreeMap<u32, SetUnion>,
    selected: &BTreeSet<u32>,
) -> Vec<String> {
    let lacks = |(id, union): (&u32, &SetUnion)| {
        let missing = union.sets.iter().filter(|set| !sets.contains(set)).map(u32::to_string);
        let missing = missing.collect::<Vec<_>>().join(", ");
        (!missing.is_empty()).then(|| format!("{kind}ADD {id} unites set(s) {missing}, which are not there"))
    };
    unions.iter().filter(|(id, _)| selected.contains(id)).filter_map(lacks).collect()
}

fn clamps(bulk: &BulkData) -> BTreeSet<u32> {
    bulk.constraints.iter().map(|card| card.set).collect()
}

fn equations(bulk: &BulkData) -> BTreeSet<u32> {
    bulk.equations.iter().map(|card| card.set).collect()
}

fn described(case: &Subcase) -> String {
    let one = |name: &str, set: Option<u32>| set.map(|set| format!("{name} {set}"));
    let sets: Vec<String> = [one("SPC", case.spc), one("MPC", case.mpc), one("SUPORT1", case.support)]
        .into_iter()
        .flatten()
        .collect();
    format!("{} has {}", case.id, if sets.is_empty() { "none".to_owned() } else { sets.join(", ") })
}

/// Demands one set, or a union of all.
fn one_set(kind: &str, sets: &BTreeSet<u32>, unions: &BTreeMap<u32, SetUnion>) -> Result<(), InputError> {
    let is_union = |union: &SetUnion| sets.iter().all(|set| union.sets.contains(set));
    if sets.len() < 2 || unions.values().any(is_union) {
        return Ok(());
    }
    let list: Vec<String> = sets.iter().map(u32::to_string).collect();
    let message =
        format!("the deck has {kind} sets {} and no case control that selects one", list.join(", "));
    Err(InputError::general(message).with_help(format!(
        "write {kind} = NUMBER between CEND and BEGIN BULK, or unite what shall apply by {kind}ADD"
    )))
}

/// The sets that a selection means.
fn selected(
    kind: &str,
    set: Option<u32>,
    sets: &BTreeSet<u32>,
    unions: &BTreeMap<u32, SetUnion>,
) -> Result<Vec<u32>, InputError> {
    let Some(set) = set else { return Ok(Vec::new()) };
    let Some(SetUnion { sets: united, .. }) = unions.get(&set) else {
        return if sets.contains(&set) {
            Ok(vec![set])
        } else if kind == "MPC" {
            // As in Nastran, whose rigid elements may be all there is of it; [`BulkData::remarks`] says it.
            Ok(Vec::new())
        } else {
            Err(InputError::general(format!("the case control selects {kind} {set}, which is not there")))
        };
    };
    if sets.contains(&set) {
        let message = format!("{kind} {set} is a set of its own and a union by {kind}ADD");
        return Err(InputError::general(message).with_help("give the union another number"));
    }
    // As in Nastran, sets that are not there are left out where others are; [`BulkData::remarks`] says it.
    let there: Vec<u32> = united.iter().copied().filter(|one| sets.contains(one)).collect();
    if there.is_empty() {
        let message = format!("{kind}ADD {set} unites sets of which none is there");
        return Err(InputError::general(message).with_help("name sets that the bulk data have"));
    }
    Ok(there)
}
